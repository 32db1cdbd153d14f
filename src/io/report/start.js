// Buttons, theme and print; shows the first plan when all else is there.

for (const button of document.querySelectorAll('[data-zoom]')) {
  button.addEventListener('click', () => {
    if (button.dataset.zoom === 'all') marked = null;
    ({in: () => zoom(1.6), out: () => zoom(1 / 1.6), all: showAll})[button.dataset.zoom]();
  });
}
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', redraw);
addEventListener('beforeprint', () => {
  root.dataset.theme = 'light';
  for (const map of maps) map.draw();
});
addEventListener('afterprint', () => {
  delete root.dataset.theme;
  redraw();
});
setView(home);
choose(chosen);
