// What a criterion says of each plan: its rules, where they fail, and the soundings' TVU.

/** Soundings by the share of their TVU in its limit: a bar a bin, a line at the limit. */
function tvuChart(name, {bin, soundings}) {
  const W = 460, H = 200, left = 50, right = 12, top = 10, bottom = 44;
  const all = soundings.reduce((sum, n) => sum + n, 0) || 1;
  const shares = soundings.map((n) => 100 * n / all);
  const yt = ticks(0, Math.max(...shares, 1), 4);
  const px = (x) => left + x / (bin * soundings.length) * (W - left - right);
  const py = (y) => top + (1 - y / yt[yt.length - 1]) * (H - top - bottom);
  const beyond = shares.slice(Math.round(1 / bin)).reduce((sum, s) => sum + s, 0);
  const chart = svg('svg', {viewBox: `0 0 ${W} ${H}`, role: 'img', 'aria-label':
    `TVU of the logged soundings of ${name}: ${number(beyond, 1)} % beyond the limit`});
  for (const y of yt) {
    chart.append(svg('line', {class: 'grid', x1: left, x2: W - right, y1: py(y), y2: py(y)}),
      svg('text', {x: left - 7, y: py(y) + 4, 'text-anchor': 'end'}, y));
  }
  shares.forEach((share, k) => chart.append(svg('rect', {class: k * bin < 0.999 ? 'within' : 'beyond',
    x: px(k * bin) + 0.5, y: py(share), width: px(bin) - px(0) - 1, height: py(0) - py(share)})));
  for (const x of [0, 0.5, 1, 1.5, 2]) {
    chart.append(svg('text', {x: px(x), y: H - bottom + 16, 'text-anchor': 'middle'}, x === 2 ? '2+' : x));
  }
  chart.append(svg('line', {class: 'limit', x1: px(1), x2: px(1), y1: top, y2: H - bottom}),
    svg('text', {x: (left + W - right) / 2, y: H - 8, 'text-anchor': 'middle'}, 'TVU / its limit'),
    svg('text', {x: 13, y: (top + H - bottom) / 2, 'text-anchor': 'middle',
      transform: `rotate(-90 13 ${(top + H - bottom) / 2})`}, '% of soundings'));
  return chart;
}

/** A map of TVU / its limit beside its colours. */
function tvuMap(plan) {
  const {tvu} = plan.criterion;
  const picture = new Picture(tvu, tvu.palette, true);
  const frame = element('div', {class: 'map'});
  const strip = tvu.palette.slice(1, -1);
  const legend = element('div', {class: 'legend'},
    element('span', {class: 'item'}, 'Best TVU of a cell: 0', element('span', {class: 'ramp',
      style: `background:linear-gradient(90deg,${strip})`}), 'its limit'),
    legendItem(element('span', {class: 'box', style: '--c:' + tvu.palette[tvu.palette.length - 1]}), 'beyond it'));
  new MapView(frame, 'Vertical uncertainty of plan ' + plan.name, 420, (map) => {
    picture.draw(map);
    map.stroke(area, '#10202c', 1.8);
  });
  return element('div', {}, frame, legend);
}

function ruleRow(rule) {
  const where = rule.where.slice(0, 3).map((p) => `${number(p.x, 1).replaceAll(',', '')}, ` +
    `${number(p.y, 1).replaceAll(',', '')} (${square(p.area_m2)})`);
  const more = rule.failing_places > where.length && where.length ? `; ${count(rule.failing_places)} places in all` : '';
  return element('tr', {}, element('td', {class: 'l ' + (rule.pass ? 'best' : 'alarm')}, rule.pass ? '✓ passes' : '✗ fails'),
    element('td', {class: 'l'}, rule.name), element('td', {class: 'l wrap'}, rule.figure),
    element('td', {class: 'l wrap'}, rule.asks), element('td', {class: 'l wrap'}, where.join('; ') + more || '–'));
}

function criterionCard(plan) {
  const c = plan.criterion;
  const head = element('thead', {}, element('tr', {}, ...['', 'Rule', 'Predicted', 'Asked', 'Where it falls short: x, y'].map((name) =>
    element('th', {class: 'l', scope: 'col'}, name))));
  const left = c.out_of_reach_m2 > 0
    ? ` ${square(c.out_of_reach_m2)} that no place in safe water shows to the sonar are not judged.` : '';
  return element('div', {class: 'judged'},
    element('p', {class: 'says'}, element('strong', {}, plan.name + ': predicted to ' + (c.predicted_to_pass ? 'pass ' : 'fail ') + c.title + '.'),
      ` Judged over ${square(c.judged_m2)}; ${number(c.accepted_soundings_pct, 1)} % of ${count(c.logged_soundings)} logged soundings within the limits.` + left),
    element('div', {class: 'scroll'}, element('table', {}, head, element('tbody', {}, ...c.rules.map(ruleRow)))),
    element('div', {class: 'pair'}, tvuMap(plan), tvuChart(plan.name, c.tvu_share_of_limit)));
}

{
  const judged = plans.filter((plan) => plan.criterion);
  if (judged.length) $('criterion').append(...judged.map(criterionCard));
  else $('criterion-section').remove();
}
