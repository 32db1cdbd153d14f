// The page around the maps: cards, legends, table, chart, list of gaps, settings.

const $ = (id) => document.getElementById(id);
const tints = ['#0072b2', '#d55e00', '#009e73', '#cc79a7', '#8a6d00', '#56b4e9', '#6b4fb3', '#555555'];
const plans = data.plans.map((plan, i) => ({
  ...plan, tint: tints[i % tints.length],
  path: plan.path.map((part) => ({...part, line: decoded(part.line)})),
  holidays: plan.holidays.map((gap) => ({...gap, at: [...decoded(gap.at)]})),
  picture: new Picture(plan.coverage, data.legend.palette, true),
}));
const depth = new Picture(data.depth, data.depth.palette, false);
const area = data.area.map(decoded), water = data.water.map(decoded), noGo = data.no_go.map(decoded);
const regions = data.regions.map((r) => ({...r, rings: r.rings.map(decoded), label: decoded(r.label)}));
const gates = data.gates.map(decoded), blocked = data.blocked.map(decoded);

let chosen = plans.reduce((best, p, i) =>
  (p.figures.coverage_hit_pct > plans[best].figures.coverage_hit_pct ? i : best), 0);
let marked = null;  // the gap that was clicked: [plan, number]
const layers = {path: true, limits: true, regions: true, gates: true, gaps: true};

const number = (v, digits = 0) => v.toLocaleString('en-GB', {minimumFractionDigits: digits, maximumFractionDigits: digits});
const percent = (v) => number(v < 100 ? Math.min(v, 99.9) : v, 1) + ' %';
const square = (v) => number(v, v >= 100 ? 0 : v >= 1 ? 1 : 2) + ' m²';
const long = (v) => (v >= 10000 ? number(v / 1000, 1) + ' km' : number(v, v < 10 ? 2 : 0) + ' m');
const short = (v) => number(v, 2) + ' m';
const count = (v) => number(v);
const ratio = (v) => number(v, 2);
const energy = (v) => (v >= 1000 ? number(v / 1000, 2) + ' kWh' : number(v) + ' Wh');
const time = (s) => {
  if (s < 60) return number(s, s < 10 ? 2 : 0) + ' s';
  const minutes = Math.round(s / 60);
  return minutes < 60 ? minutes + ' min' : Math.floor(minutes / 60) + ' h ' + minutes % 60 + ' min';
};

// --- head ------------------------------------------------------------------------------------
{
  const f = plans[0].figures;
  const extent = f.survey_area_m2 >= 1e5 ? number(f.survey_area_m2 / 1e6, 2) + ' km²' : square(f.survey_area_m2);
  $('facts').textContent = [
    plans.length === 1 ? 'Plan: ' + plans[0].name : plans.length + ' plans', extent,
    'depth ' + number(data.depth.min_m, 1) + ' to ' + number(data.depth.max_m, 1) + ' m',
    'cells of ' + data.resolution_m + ' m', data.provenance.input_file,
  ].filter(Boolean).join(' · ');
}

// --- coverage cards --------------------------------------------------------------------------
function stateOf(plan, place) {
  const index = plan.picture.indexAt(...place);
  const legend = data.legend;
  if (index === 0) return 'outside the survey area';
  if (index > legend.empty) {
    if (plan.coverage.factor === 1) return 'gap: no sounding';
    return 'up to ' + Math.round(100 * (index - legend.empty) / legend.empty_steps) + ' % of cells here empty';
  }
  const level = index - legend.covered;
  return legend.covered_names[level].replace('-', ' to ') + (level === 0 ? ' sounding a cell' : ' soundings a cell');
}

function paintCoverage(plan, map) {
  plan.picture.draw(map);
  map.stroke(area, colour('outline'), 1);
  const number = plans.indexOf(plan);
  plan.holidays.slice(0, 3).forEach((gap, i) => map.badge(String(i + 1), gap.at, '#1c1c1c', 8));
  if (marked && marked[0] === number) ring(map, plan.holidays[marked[1]]);
}

/** A ring around the gap that was clicked. */
function ring(map, gap) {
  const b = metres(gap.box);
  const [x0, y0] = map.toScreen(b.x0, b.y1), [x1, y1] = map.toScreen(b.x1, b.y0);
  const pad = 7;
  for (const [style, width] of [['#ffffff', 5], ['#111111', 2]]) {
    map.ink.strokeStyle = style;
    map.ink.lineWidth = width;
    map.ink.strokeRect(x0 - pad, y0 - pad, x1 - x0 + 2 * pad, y1 - y0 + 2 * pad);
  }
}

// Notes are folded: open ones would push the maps out of sight.
function notesOf(plan) {
  const paragraphs = plan.notes.map((note) => element('p', {class: 'says'}, note));
  if (paragraphs.length === 0) return '';
  const fold = element('details', {},
    element('summary', {}, paragraphs.length === 1 ? 'A note' : paragraphs.length + ' notes'), ...paragraphs);
  return fold;
}

function figure(value, unit, label) {
  return element('div', {}, element('b', {}, value, element('small', {}, unit)), element('span', {}, label));
}

plans.forEach((plan, i) => {
  const frame = element('div', {class: 'map'});
  plan.readout = element('p', {class: 'readout'}, '\u00a0');
  const gaps = plan.figures.holidays;
  plan.card = element('article', {class: 'card', style: '--plan:' + plan.tint},
    element('header', {},
      element('h3', {}, element('button', {type: 'button', title: 'Show this plan below', onclick: () => choose(i)}, plan.name)),
      element('div', {class: 'numbers'},
        figure(plan.coverage_text, ' %', 'covered'),
        figure(ratio(plan.figures.length_ratio), ' ×', 'ideal length'),
        figure(gaps ? plan.largest_text : '0', ' m²', 'largest gap')),
      element('p', {class: 'says'}, plan.gaps_text),
      ...plan.warnings.map((w) => element('span', {class: 'warn'}, '⚠ ' + w)),
      notesOf(plan)),
    frame, plan.readout);
  $('cards').append(plan.card);
  new MapView(frame, 'Coverage of plan ' + plan.name, 520, (map) => paintCoverage(plan, map));
});

function legendItem(sample, text) { return element('span', {class: 'item'}, sample, text); }
{
  const {palette, covered, covered_names: names, empty, empty_steps: steps} = data.legend;
  const strip = element('span', {class: 'strip'},
    ...names.map((name, i) => element('i', {style: '--c:' + palette[covered + i]}, name)));
  const from = palette[empty + 1], middle = palette[empty + steps / 2], to = palette[empty + steps];
  $('coverage-legend').append(
    element('span', {class: 'item'}, 'Soundings a cell', strip),
    element('span', {class: 'item'}, 'Gap: few', element('span', {class: 'ramp', style:
      `background:linear-gradient(90deg,${from},${middle},${to})`}), 'to all cells without a sounding'),
    legendItem(element('span', {class: 'box', style: '--c:var(--land)'}), 'land or outside'));
}

// --- depth map -------------------------------------------------------------------------------
const plain = new Set(['line', 'cross', 'infill']);

function pathStyle(part) {
  if (part.kind === 'transit' || !part.sonar) return [colour('transit'), 1.8, [6, 4]];
  return plain.has(part.kind) && part.log ? [colour('path'), 1.5, []] : [colour('turn'), 1.3, []];
}

function paintPath(map) {
  const parts = plans[chosen].path;
  const thick = Math.min(2, Math.max(0.75, Math.sqrt(map.scale() * home.w / map.width)));
  for (const part of parts) {
    const [style, width, dash] = pathStyle(part);
    map.stroke([part.line], style, width * thick, dash);
  }
  let walked = 0;
  for (const part of parts) walked = map.arrows(part.line, pathStyle(part)[0], 230, walked);
  const last = parts[parts.length - 1].line;
  map.badge('E', [last[last.length - 2], last[last.length - 1]], '#b3261e', 9);
  map.badge('S', [parts[0].line[0], parts[0].line[1]], '#0a6b4d', 9);
}

function paintDepth(map) {
  depth.draw(map);
  if (layers.limits) paintCutOff(map);
  map.fill(noGo, 'rgba(179,38,30,0.28)');
  map.stroke(noGo, '#b3261e', 1.2, [4, 3]);
  map.stroke(water, 'rgba(16,32,44,0.45)', 1, [2, 3]);
  if (layers.regions) for (const r of regions) map.stroke(r.rings, 'rgba(255,255,255,0.9)', 3);
  if (layers.regions) for (const r of regions) map.stroke(r.rings, '#33414f', 1.2);
  map.stroke(area, '#10202c', 1.8);
  if (layers.path) paintPath(map);
  if (layers.limits) paintViolations(map);
  if (layers.gates) {
    for (const [edges, name, width] of [[blocked, 'blocked', 2.2], [gates, 'gate', 4]]) {
      map.stroke(edges, colour('casing'), width + 2.5);
      map.stroke(edges, colour(name), width);
    }
  }
  if (layers.regions) {
    for (const r of regions) {
      const [x, y] = map.toScreen(r.label[0], r.label[1]);
      map.label(number(r.mean_depth_m, 1) + ' m · fan ' + number(r.opening_deg) + '°', x, y);
    }
  }
  if (layers.gaps) {
    plans[chosen].holidays.slice(0, 10).forEach((gap, i) => map.badge(String(i + 1), gap.at, '#c2410c', 8));
  }
  if (marked && marked[0] === chosen) ring(map, plans[chosen].holidays[marked[1]]);
}

new MapView($('depth-map'), 'Depth, depth regions, gates and path', 720, paintDepth);

for (const [key, text, has] of [['path', 'Path', true],
  ['limits', 'Violations', plans.some((p) => p.violations.count) || data.cut_off.count], ['regions', 'Depth regions', regions.length],
  ['gates', 'Gates and blocked edges', gates.length + blocked.length], ['gaps', 'Largest gaps', true]]) {
  if (!has) continue;
  const box = element('input', {type: 'checkbox', checked: '', onchange: (event) => {
    layers[key] = event.target.checked;
    redraw();
  }});
  $('layers').append(element('label', {}, box, text));
}

{
  const {min_m: min, max_m: max, palette, levels, shades} = data.depth;
  const stops = [0, 0.25, 0.5, 0.75, 1].map((t) => palette[1 + Math.round(t * (levels - 1)) * shades + 2]);
  const mark = (name, dash = '') => element('span', {class: 'mark ' + dash, style: `--c:var(--${name})`});
  $('depth-legend').append(
    element('span', {class: 'item'}, number(min, 1) + ' m', element('span', {class: 'ramp',
      style: `background:linear-gradient(90deg,${stops})`}), number(max, 1) + ' m deep, isobaths each ' + data.depth.isobath_m + ' m'),
    legendItem(mark('path'), 'line'), legendItem(mark('turn'), 'turn or not logged'),
    legendItem(mark('transit', 'dash'), 'transit or sonar off'),
    ...(gates.length ? [legendItem(mark('gate'), 'gate')] : []),
    ...(blocked.length ? [legendItem(mark('blocked'), 'blocked edge')] : []),
    ...(plans.some((p) => p.violations.count)
      ? [legendItem(element('span', {class: 'hazard'}), '▲ infeasible, outside safe water, or too tight')] : []),
    ...(data.cut_off.count ? [legendItem(element('span', {class: 'hatch'}), 'survey area outside safe water')] : []),
    element('span', {class: 'item'}, 'S start, E end'));
}

function fileText(place) {
  const at = data.file_corner.map((c, k) => c + place[k] * 100 * data.file_units_per_cm);
  return number(at[0], 1).replaceAll(',', '') + ', ' + number(at[1], 1).replaceAll(',', '');
}

pointerListeners.push((place) => {
  if (!place) {
    for (const plan of plans) plan.readout.textContent = '\u00a0';
    $('depth-readout').textContent = '\u00a0';
    return;
  }
  for (const plan of plans) plan.readout.textContent = stateOf(plan, place);
  const index = depth.indexAt(...place);
  const {min_m: min, max_m: max, levels, shades} = data.depth;
  const deep = min + (Math.floor((index - 1) / shades) + 0.5) / levels * (max - min);
  $('depth-readout').textContent = fileText(place) + (index ? ' · about ' + number(deep, 1) + ' m deep' : ' · no seafloor');
});

// --- choice of the plan ----------------------------------------------------------------------
function choose(i) {
  chosen = i;
  marked = null;
  plans.forEach((plan, k) => {
    plan.card.classList.toggle('chosen', k === i && plans.length > 1);
    plan.tab.setAttribute('aria-pressed', k === i);
  });
  listGaps();
  listLimits();
  redraw();
}
plans.forEach((plan, i) => {
  plan.tab = element('button', {type: 'button', onclick: () => choose(i)}, plan.name);
  $('tabs').append(plan.tab);
});

function listGaps() {
  const plan = plans[chosen];
  $('gaps-of').textContent = plan.name;
  const show = (k) => () => {
    marked = [chosen, k];
    showBox(plan.holidays[k].box);
  };
  const rows = plan.holidays.map((gap, k) => element('tr', {},
    element('td', {}, element('button', {type: 'button', onclick: show(k), 'aria-label': 'Zoom to gap ' + (k + 1)}, String(k + 1))),
    element('td', {}, square(gap.area_m2)), element('td', {class: 'l'}, gap.cause),
    element('td', {}, fileText([gap.at[0], gap.at[1]]))));
  const head = element('thead', {}, element('tr', {}, element('th', {}, 'Zoom'), element('th', {}, 'Area'),
    element('th', {class: 'l'}, 'Cause'), element('th', {}, 'x, y')));
  $('gaps').replaceChildren(rows.length ? element('table', {}, head, element('tbody', {}, ...rows))
    : element('p', {class: 'readout'}, plan.figures.holidays ? 'All gaps are too small for the list.' : 'No gaps.'));
}

// --- table -----------------------------------------------------------------------------------
// [label, figure, format, which is best, what is alarming]
const figures = [
  ['Coverage, all pings', 'coverage_hit_pct', percent, 'high'],
  ['Coverage, logged pings only', 'coverage_hit_logged_pct', percent, 'high'],
  ['Coverage by beam footprints', 'coverage_footprint_pct', percent, 'high'],
  ['Cells with 2 or more soundings', 'coverage_hit_2_pct', percent, 'high'],
  ['Cells with 5 or more soundings', 'coverage_hit_5_pct', percent, 'high'],
  ['Length', 'length_m', long, 'low'],
  ['Length ratio (1 is ideal)', 'length_ratio', ratio, 'low'],
  ['Duration', 'duration_s', time, 'low'],
  ['Duration with contingency', 'duration_with_contingency_s', time, 'low'],
  ['Energy, where the power is given', 'energy_wh', energy, 'low'],
  ['Overlap: soundings a covered cell, less 1', 'overlap_soundings_per_cell', ratio, ''],
  ['Cells sounded from two or more legs', 'several_legs_pct', percent, ''],
  ['Gaps', 'holidays', count, ''],
  ['Largest gap', 'largest_holiday_m2', square, 'low'],
  ['All gaps together', 'holidays_total_m2', square, 'low'],
  ['Turns', 'turns', count, 'low'],
  ['of them 90° or more', 'sharp_turns', count, 'low'],
  ['Smallest turn radius', 'min_turn_radius_m', short, 'high'],
  ['Infeasible legs', 'infeasible_legs', count, 'low', (v) => v > 0],
  ['Path tighter than the vehicle turns', 'tight_turn_m', short, 'low', (v) => v > 0],
  ['Self-crossings', 'self_crossings', count, 'low'],
  ['Path along earlier stretches of itself', 'shared_m', long, 'low'],
  ['Path outside the water', 'outside_water_m', long, 'low', (v) => v > 0],
  ['of it over land or unknown ground', 'unknown_depth_m', long, 'low', (v) => v > 0],
  ['Least water under the keel', 'min_under_keel_m', short, 'high', (v) => v < 0],
  ['Planning time', 'planning_s', time, ''],
];
{
  const head = element('tr', {}, element('th', {scope: 'col'}, ''), ...plans.map((plan) =>
    element('th', {scope: 'col', style: '--plan:' + plan.tint}, element('span', {class: 'dot'}), plan.name)));
  const body = figures.map(([label, key, format, best, alarm]) => {
    const values = plans.map((plan) => (key === 'planning_s' ? plan.planning_s : plan.figures[key]));
    const known = values.filter((v) => v !== null && v !== undefined);
    if (key === 'energy_wh' && known.length === 0) return null;
    const top = best === 'high' ? Math.max(...known) : Math.min(...known);
    const differ = new Set(known.map(format)).size > 1;
    return element('tr', {}, element('th', {scope: 'row'}, label), ...values.map((v) => {
      if (v === null || v === undefined) return element('td', {}, '–');
      const kind = alarm && alarm(v) ? 'alarm' : best && differ && format(v) === format(top) ? 'best' : '';
      return element('td', {class: kind}, format(v));
    }));
  });
  $('figures').append(element('table', {}, element('thead', {}, head), element('tbody', {}, ...body.filter(Boolean))));
}

// --- settings --------------------------------------------------------------------------------
{
  const p = data.provenance;
  const add = (name, value, wide = '') => $('settings').append(element('div', {class: wide}, element('dt', {}, name),
    element('dd', {}, Array.isArray(value) ? value.join(', ') : String(value))));
  for (const [name, value] of Object.entries(p.options)) add(name, value);
  add('seed', p.seed);
  add('coordinates', data.crs === 'none' ? 'those of the input file (no CRS)' : data.crs);
  add('input file', p.input_file);
  add('made by', p.program + ' ' + p.version + ', ' + p.command);
  add('input hash', p.input_hash, 'wide');
}
