// Coverage against length: the plans, and the choices that a planner had.

function svg(tag, attributes, ...children) {
  const node = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...children);
  return node;
}

/** Round numbers from `low` to `high`, about `wanted` of them. */
function ticks(low, high, wanted) {
  const rough = (high - low) / wanted;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((f) => f * power).find((s) => s >= rough * 0.999);
  const first = Math.floor(low / step + 1e-9), last = Math.ceil(high / step - 1e-9);
  return Array.from({length: last - first + 1}, (_, i) => +((first + i) * step).toPrecision(12));
}

/** Coverage of a plan as its planner counted it: cells hit, or cells in a beam's footprint. */
function covered(plan) {
  const by = plan.choices.cover === 'footprint' ? plan.figures.coverage_footprint_pct : null;
  return by ?? plan.figures.coverage_hit_pct;
}

function drawChart(place) {
  const W = 460, H = 320, left = 58, right = 22, top = 16, bottom = 50;
  const all = plans.flatMap((p) => [[p.figures.length_ratio, covered(p)],
    ...p.choices.list.map((c) => [c.length_ratio, c.coverage_pct])]);
  const xs = all.map((a) => a[0]), ys = all.map((a) => a[1]);
  const alone = plans.length === 1 && all.length > 1;
  const pad = 0.06 * (Math.max(...xs) - Math.min(...xs));
  const xt = ticks(alone ? Math.min(...xs) - pad : 0, Math.max(...xs) + Math.max(pad, 0.05), 6);
  const yt = ticks(Math.min(...ys) - (alone ? 0.2 : 3), Math.max(Math.max(...ys), alone ? 0 : 100), 5)
    .filter((y) => y <= 100);
  const [x0, x1, y0, y1] = [xt[0], xt[xt.length - 1], yt[0], Math.max(yt[yt.length - 1], ...ys)];
  const px = (x) => left + (x - x0) / (x1 - x0) * (W - left - right);
  const py = (y) => top + (y1 - y) / (y1 - y0) * (H - top - bottom);
  const chart = svg('svg', {viewBox: `0 0 ${W} ${H}`, role: 'img', 'aria-label':
    'Coverage against length: ' + plans.map((p) =>
      `${p.name} ${percent(covered(p))} at ${ratio(p.figures.length_ratio)}`).join('; ')});
  for (const y of yt) {
    chart.append(svg('line', {class: 'grid', x1: left, x2: W - right, y1: py(y), y2: py(y)}),
      svg('text', {x: left - 7, y: py(y) + 4, 'text-anchor': 'end'}, y));
  }
  for (const x of xt) {
    chart.append(svg('line', {class: 'grid', x1: px(x), x2: px(x), y1: top, y2: H - bottom}),
      svg('text', {x: px(x), y: H - bottom + 17, 'text-anchor': 'middle'}, x));
  }
  const middle = top + (H - top - bottom) / 2;
  chart.append(svg('text', {x: (left + W - right) / 2, y: H - 10, 'text-anchor': 'middle'},
    'path length / ideal length (area / swath width)'),
  svg('text', {x: 15, y: middle, 'text-anchor': 'middle', transform: `rotate(-90 15 ${middle})`},
    'coverage, % of cells'));
  for (const plan of plans) drawChoices(chart, plan, px, py);
  drawPlans(chart, px, py, W, H - bottom);
  place.append(chart);
  for (const plan of plans) if (plan.choices.list.length) place.append(choicesText(plan));
}

/** Diamonds on a line: no other plan that was tried is both shorter and covers more. */
function drawChoices(chart, plan, px, py) {
  const list = plan.choices.list;
  if (!list.length) return;
  const at = list.map((c) => [px(c.length_ratio), py(c.coverage_pct)]);
  chart.append(svg('polyline', {points: at.join(' '), fill: 'none', stroke: plan.tint, 'stroke-width': 1.4}));
  list.forEach((c, i) => {
    const [x, y] = at[i];
    const says = `${number(c.coverage_pct, 2)} % at ${ratio(c.length_ratio)} ideal lengths, ` +
      `${long(c.length_m)}, ${c.turns} turns: ${c.what}${withinMargin(c)}`;
    chart.append(svg('path', {d: `M${x - 5} ${y}L${x} ${y - 5}L${x + 5} ${y}L${x} ${y + 5}Z`, class: 'choice',
      stroke: plan.tint}, svg('title', {}, says)));
    if (i === plan.choices.chosen) {
      chart.append(svg('circle', {cx: x, cy: y, r: 11, fill: 'none', class: 'picked'}));
    }
  });
}

/** What is left of a choice without the share of its swaths that is kept in reserve. */
function withinMargin(choice) {
  return choice.within_margin_pct === undefined ? '' :
    `; ${number(choice.within_margin_pct, 2)} % if the margin of each swath is lost`;
}

/** Points that a name should not cover: plans, choices and the line between these. */
function chartMarks(px, py) {
  const marks = [];
  for (const plan of plans) {
    marks.push([px(plan.figures.length_ratio), py(covered(plan))]);
    const at = plan.choices.list.map((c) => [px(c.length_ratio), py(c.coverage_pct)]);
    at.forEach(([x, y], i) => {
      const [bx, by] = at[Math.max(0, i - 1)];
      const parts = Math.max(1, Math.ceil(Math.hypot(x - bx, y - by) / 8));
      for (let k = 1; k <= parts; ++k) marks.push([bx + (x - bx) * k / parts, by + (y - by) * k / parts]);
    });
  }
  return marks;
}

/** Names stand where they cover least: beside their plan, else above, below or farther off. */
function drawPlans(chart, px, py, width, height) {
  const marks = chartMarks(px, py), taken = [];
  for (const plan of [...plans].sort((a, b) => covered(b) - covered(a))) {
    const x = px(plan.figures.length_ratio), y = py(covered(plan));
    chart.append(svg('circle', {cx: x, cy: y, r: 6.5, fill: plan.tint, stroke: '#fff', 'stroke-width': 1.5}));
    const wide = 8.6 * plan.name.length, gap = plan.choices.list.length ? 16 : 11;
    const boxes = [0, 17, -15, 31, -29, 45, -43].flatMap((dy) =>
      [x + gap, x - gap - wide, ...(dy ? [x - wide / 2] : [])].map((left) => [left, y + dy - 7, left + wide, y + dy + 7]));
    const covers = ([l, t, r, b]) =>
      marks.filter(([mx, my]) => mx > l - 6 && mx < r + 6 && my > t - 5 && my < b + 5).length +
      100 * taken.filter((o) => l < o[2] && r > o[0] && t < o[3] && b > o[1]).length +
      (l < 0 || r > width || t < 0 || b > height ? 1000 : 0);
    const best = boxes.reduce((a, b) => covers(b) < covers(a) ? b : a);
    taken.push(best);
    chart.append(svg('text', {class: 'name', x: (best[0] + best[2]) / 2, y: best[1] + 11,
      'text-anchor': 'middle'}, plan.name));
  }
}

function choicesText(plan) {
  const {list, chosen: picked, why, cover} = plan.choices;
  const by = cover === 'footprint' ? ' (of beam footprints)' : '';
  const c = list[picked];
  return element('p', {class: 'says'}, element('strong', {}, `${plan.name}: `),
    `each diamond is a plan (${list.length} in all) that no other tried plan beats in length, coverage${by} and infeasible legs. ` +
    `Picked (ring): ${c.what}${withinMargin(c)}, ${why}` +
    (c.within_margin_pct === undefined ? '.' : ', counting only what the margin leaves of each swath.'));
}

drawChart($('scatter'));
