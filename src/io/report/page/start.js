// Choice of the plan, theme and print; shows the best plan when all else is there.

function choose(i) {
  chosen = i;
  for (const tell of choosers) tell(plan());
}

matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => {
  drawAll();
  drawTracks();
});

// Paper has one width, and no page scrolls on it: the map is fitted to it before it is printed.
const paperWidth = 690;
addEventListener('beforeprint', () => {
  root.dataset.theme = 'light';
  play(false);
  mapNode.style.width = paperWidth + 'px';
  mapNode.style.height = Math.min(plans.length > 1 ? 430 : 520, Math.max(260, Math.round(paperWidth * (whole.y1 - whole.y0) / (whole.x1 - whole.x0)))) + 'px';
  showsAll = true;
  refit();
  drawAll();
  drawTracks();
  fitTracks(300);
});
addEventListener('afterprint', () => {
  delete root.dataset.theme;
  mapNode.style.width = mapNode.style.height = '';
  refit();
  drawAll();
  drawTracks();
});

new ResizeObserver(refit).observe(mapNode);
choose(chosen);
refit();
// Other programs may ask when the page was ready, in milliseconds from its start.
root.dataset.ready = Math.round(performance.now());
