// Charts: hours against coverage, what passes below the boat, uncertainty of soundings.

/** Coverage of a plan as its planner counted it: cells hit, or cells in a beam's footprint. */
function covered(p) {
  const footprint = p.counted === 'logged' ? p.figures.coverage_footprint_logged_pct : p.figures.coverage_footprint_pct;
  return (p.choices.cover === 'footprint' ? footprint : null) ?? p.counted_pct;
}
const hours = (p) => p.figures.duration_s / 3600;

/** Axes, grid and labels of a chart of W x H; gives what places points in it. */
function axes(chart, {W, H, left, right, top, bottom}, xt, yt, xLabel, yLabel) {
  const [x0, x1, y0, y1] = [xt[0], xt[xt.length - 1], yt[0], yt[yt.length - 1]];
  const px = (x) => left + (x - x0) / (x1 - x0) * (W - left - right);
  const py = (y) => top + (y1 - y) / (y1 - y0) * (H - top - bottom);
  for (const y of yt) {
    chart.append(svg('line', {class: 'grid', x1: left, x2: W - right, y1: py(y), y2: py(y)}),
      svg('text', {x: left - 7, y: py(y) + 4, 'text-anchor': 'end'}, y));
  }
  for (const x of xt) {
    chart.append(svg('line', {class: 'grid', x1: px(x), x2: px(x), y1: top, y2: H - bottom}),
      svg('text', {x: px(x), y: H - bottom + 17, 'text-anchor': 'middle'}, x));
  }
  const middle = top + (H - top - bottom) / 2;
  chart.append(svg('text', {x: (left + W - right) / 2, y: H - 8, 'text-anchor': 'middle'}, xLabel),
    svg('text', {x: 14, y: middle, 'text-anchor': 'middle', transform: `rotate(-90 14 ${middle})`}, yLabel));
  return {px, py};
}

// --- the front ---------------------------------------------------------------------------------
const frontSize = {W: 460, H: 310, left: 58, right: 22, top: 16, bottom: 46};

function drawFront() {
  const all = plans.flatMap((p) => [[hours(p), covered(p)], ...p.choices.list.map((c) => [c.hours, c.coverage_pct])]);
  const least = plans[0].figures.least_hours;
  const xs = [...all.map((a) => a[0]), ...(least ? [least] : [])], ys = all.map((a) => a[1]);
  const alone = plans.length === 1;
  const [low, high] = [Math.min(...xs), Math.max(...xs)], pad = 0.05 * (high - low || high);
  const xt = ticks(Math.max(0, low - pad), high + pad, 6);
  const yt = ticks(Math.min(...ys) - (alone ? 0.2 : 3), Math.max(Math.max(...ys), alone ? 0 : 100), 5).filter((y) => y <= 100);
  if (yt[yt.length - 1] < Math.max(...ys)) yt.push(100);
  const chart = svg('svg', {viewBox: `0 0 ${frontSize.W} ${frontSize.H}`, role: 'img', 'aria-label': 'Hours against coverage: ' +
    plans.map((p) => `${p.name} ${percent(covered(p))} in ${time(p.figures.duration_s)}`).join('; ')});
  const {px, py} = axes(chart, frontSize, xt, yt, 'hours under way', plans[0].counted === 'logged' ? 'logged coverage, % of cells' : 'coverage, % of cells');
  if (least) {
    chart.append(svg('line', {class: 'limit', x1: px(least), x2: px(least), y1: frontSize.top, y2: frontSize.H - frontSize.bottom}),
      svg('text', {x: px(least) + 5, y: frontSize.H - frontSize.bottom - 6}, 'least hours'));
  }
  for (const p of plans) drawChoices(chart, p, px, py);
  drawPlans(chart, px, py, frontSize.W, frontSize.H - frontSize.bottom);
  $('front').append(chart);
  for (const p of plans) if (p.choices.list.length) $('front').append(choicesText(p));
}

/** Diamonds on a line: no other plan that was tried beats them. */
function drawChoices(chart, p, px, py) {
  const list = [...p.choices.list.entries()].sort(([, a], [, b]) => a.hours - b.hours);
  if (!list.length) return;
  chart.append(svg('polyline', {points: list.map(([, c]) => [px(c.hours), py(c.coverage_pct)]).join(' '), fill: 'none', stroke: p.tint, 'stroke-width': 1.4}));
  for (const [i, c] of list) {
    const x = px(c.hours), y = py(c.coverage_pct);
    const says = `${number(c.coverage_pct, 2)} % in ${time(3600 * c.hours)}, ${long(c.length_m)}, ${c.turns} turns: ${c.what}${withinMargin(c)}`;
    chart.append(svg('path', {d: `M${x - 5} ${y}L${x} ${y - 5}L${x + 5} ${y}L${x} ${y + 5}Z`, class: 'choice', stroke: p.tint}, svg('title', {}, says)));
    if (i === p.choices.chosen) chart.append(svg('circle', {cx: x, cy: y, r: 11, fill: 'none', class: 'picked'}));
  }
}

/** What is left of a choice without the share of its swaths that is kept in reserve. */
function withinMargin(choice) {
  return choice.within_margin_pct === undefined ? '' : `; ${number(choice.within_margin_pct, 2)} % if the margin of each swath is lost`;
}

/** Points that a name should not cover: plans, choices and the line between these. */
function chartMarks(px, py) {
  const marks = [];
  for (const p of plans) {
    marks.push([px(hours(p)), py(covered(p))]);
    const places = p.choices.list.map((c) => [px(c.hours), py(c.coverage_pct)]);
    places.forEach(([x, y], i) => {
      const [bx, by] = places[Math.max(0, i - 1)];
      const parts = Math.max(1, Math.ceil(Math.hypot(x - bx, y - by) / 8));
      for (let k = 1; k <= parts; ++k) marks.push([bx + (x - bx) * k / parts, by + (y - by) * k / parts]);
    });
  }
  return marks;
}

/** Names stand where they cover least: beside their plan, else above, below or farther off. */
function drawPlans(chart, px, py, width, height) {
  const marks = chartMarks(px, py), taken = [];
  for (const p of [...plans].sort((a, b) => covered(b) - covered(a))) {
    const x = px(hours(p)), y = py(covered(p));
    chart.append(svg('circle', {cx: x, cy: y, r: 6.5, fill: p.tint, stroke: '#fff', 'stroke-width': 1.5}));
    const wide = 8.6 * p.name.length, gap = p.choices.list.length ? 16 : 11;
    const boxes = [0, 17, -15, 31, -29, 45, -43].flatMap((dy) =>
      [x + gap, x - gap - wide, ...(dy ? [x - wide / 2] : [])].map((left) => [left, y + dy - 7, left + wide, y + dy + 7]));
    const covers = ([l, t, r, b]) =>
      marks.filter(([mx, my]) => mx > l - 6 && mx < r + 6 && my > t - 5 && my < b + 5).length +
      100 * taken.filter((o) => l < o[2] && r > o[0] && t < o[3] && b > o[1]).length +
      (l < 0 || r > width || t < 0 || b > height ? 1000 : 0);
    const best = boxes.reduce((a, b) => covers(b) < covers(a) ? b : a);
    taken.push(best);
    chart.append(svg('text', {class: 'name', x: (best[0] + best[2]) / 2, y: best[1] + 11, 'text-anchor': 'middle'}, p.name));
  }
}

function choicesText(p) {
  const {list, chosen: picked, why, cover} = p.choices;
  const c = list[picked];
  return element('p', {class: 'says'}, element('strong', {}, `${p.name}: `),
    `each diamond is a plan (${list.length} in all) that no other tried plan beats${cover === 'footprint' ? ' (coverage by beam footprints)' : ''}. ` +
    `Picked (ring): ${c.what}${withinMargin(c)}, ${why}` + (c.within_margin_pct === undefined ? '.' : ', counting only what the margin leaves of each swath.'));
}

if (plans.length > 1 || plans[0].choices.list.length > 1) drawFront(); else $('front-figure').remove();

// --- along the time ----------------------------------------------------------------------------
const tracks = [];

/** Grey behind what is not logged. */
function shadeUnlogged(chart) {
  const {ctx: ink, bbox: box} = chart;
  ink.save();
  ink.fillStyle = colour('shade');
  for (const leg of plan().legs) {
    if (leg.log) continue;
    const unit = chart.inHours ? 3600 : 60;
    const x0 = chart.valToPos(leg.times[0] / unit, 'x', true), x1 = chart.valToPos(leg.times[leg.times.length - 1] / unit, 'x', true);
    const left = Math.max(x0, box.left), right = Math.min(x1, box.left + box.width);
    if (right > left) ink.fillRect(left, box.top, right - left, box.height);
  }
  ink.restore();
}

function trackChart(id, column, label, down) {
  const node = $(id), p = plan();
  const inHours = p.figures.duration_s > 7200, unit = inHours ? 60 : 1;
  const ink = () => colour('soft'), grid = {stroke: () => colour('line'), width: 1}, font = '12px system-ui, sans-serif';
  const chart = new uPlot({
    width: Math.max(240, node.clientWidth || 460), height: 190, legend: {show: false}, cursor: {points: {size: 7}, sync: {key: 'time'}},
    scales: {x: {time: false}, y: {dir: down ? -1 : 1, range: (u, low, high) => (down ? [Math.max(0, low - 0.05 * (high - low) - 0.1), high + 0.05 * (high - low) + 0.1] : [0, high * 1.08 || 1])}},
    axes: [{stroke: ink, grid, ticks: grid, font, label: inHours ? 'hours' : 'minutes', labelSize: 20, labelFont: font, size: 34, values: (u, all) => all.map(String)},
      {stroke: ink, grid, ticks: grid, font, label, labelSize: 20, labelFont: font, size: 50, values: (u, all) => all.map((v) => +v.toPrecision(4) + '')}],
    series: [{}, {stroke: () => colour('accent'), width: 1.4, points: {show: false}, spanGaps: false}],
    hooks: {drawClear: [shadeUnlogged]},
  }, [p.along[0].map((t) => t / unit), p.along[column]], node);
  chart.inHours = inHours;
  chart.over.addEventListener('click', () => chart.cursor.idx !== null && moveBoat(60 * p.along[0][chart.cursor.idx]));
  const known = p.along[column].filter((v) => v !== null);
  node.setAttribute('aria-label', known.length ? `${label}: from ${number(Math.min(...known), 2)} to ${number(Math.max(...known), 2)}` : label + ': not known');
  tracks.push(chart);
}

function drawTracks() {
  for (const chart of tracks.splice(0)) chart.destroy();
  trackChart('depth-chart', 1, 'metres deep', true);
  trackChart('ping-chart', 2, 'metres between pings', false);
}
choosers.push(drawTracks);

/** The cursor of both charts goes with the boat. */
function chartsAt(seconds) {
  for (const chart of tracks) {
    const x = chart.valToPos(seconds / (chart.inHours ? 3600 : 60), 'x');
    chart.setCursor({left: x, top: chart.over.clientHeight / 2}, false);
  }
}
function fitTracks(width) {
  for (const chart of tracks) chart.setSize({width: width || Math.max(240, chart.root.parentElement.clientWidth), height: 190});
}
addEventListener('resize', () => fitTracks());

// --- uncertainty -------------------------------------------------------------------------------
/** Soundings by the share of their TVU in its limit: a bar a bin, a line at the limit. */
function drawTvu(p) {
  $('tvu-figure').hidden = !p.criterion;
  if (!p.criterion) return;
  const size = {W: 460, H: 210, left: 58, right: 16, top: 10, bottom: 44};
  const {bin, soundings} = p.criterion.tvu_share_of_limit;
  const all = soundings.reduce((sum, n) => sum + n, 0) || 1;
  const shares = soundings.map((n) => 100 * n / all);
  const beyond = shares.slice(Math.round(1 / bin)).reduce((sum, s) => sum + s, 0);
  const chart = svg('svg', {viewBox: `0 0 ${size.W} ${size.H}`, role: 'img', 'aria-label':
    `TVU of the logged soundings of ${p.name}: ${number(beyond, 1)} % beyond the limit`});
  const {px, py} = axes(chart, size, [0, 0.5, 1, 1.5, 2], ticks(0, Math.max(...shares, 1), 4), 'TVU / its limit (2: 2 and more)', '% of soundings');
  shares.forEach((share, k) => {
    const x = Math.min(k * bin, 2 - bin);  // the last bin has no end
    chart.append(svg('rect', {class: k * bin < 0.999 ? 'within' : 'beyond', x: px(x) + 0.5, y: py(share), width: px(bin) - px(0) - 1, height: py(0) - py(share)}));
  });
  chart.append(svg('line', {class: 'limit', x1: px(1), x2: px(1), y1: size.top, y2: size.H - size.bottom}));
  $('tvu-chart').replaceChildren(chart);
}
choosers.push(drawTvu);
