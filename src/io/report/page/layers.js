// What the map can show: a ground below, and layers above it.

const at = ([x, y]) => [y, x];  // Leaflet's order
const line = (points) => points.map(at);
const boundsOf = (box) => [[box.y0, box.x0], [box.y1, box.x1]];

/** What a click on something tells: a heading and rows of name and value, as text. */
function telling(heading, rows) {
  return element('div', {class: 'telling'}, element('h3', {}, heading), element('dl', {},
    ...rows.filter(([, value]) => value).flatMap(([name, value]) => [element('dt', {}, name), element('dd', {}, value)])));
}

const span = ([low, high], text) => (low === high ? text(low) : `${text(low)} to ${text(high)}`);
const depthText = (leg) => (leg.depth_m[0] === null ? '' : span(leg.depth_m, (v) => number(v, 1)) + ' m');
const keelText = (leg) => (leg.under_keel_m === null ? '' : number(leg.under_keel_m, 1) + ' m');
const fanText = (leg) => (leg.sonar ? `${span(leg.port_deg, (v) => +v.toFixed(1) + '°')} / ${span(leg.stbd_deg, (v) => +v.toFixed(1) + '°')}` : '');
const speedText = (leg) => span(leg.speed_mps, (v) => number(v, 1)) + ' m/s';
const headingText = (leg) => (leg.heading_deg === null ? '' : bearing(leg.heading_deg));
const lasting = (leg) => leg.times[leg.times.length - 1] - leg.times[0];
const capital = (text) => text[0].toUpperCase() + text.slice(1);

function tellLeg(leg) {
  return telling(capital(legName(leg)), [
    ['heading', leg.line === null && leg.kind !== 'line' ? '' : headingText(leg)], ['length', long(leg.length_m)], ['depth', depthText(leg)], ['least under the keel', keelText(leg)],
    ['fan, port / starboard', fanText(leg)], ['speed', speedText(leg)],
    ['begins after', clock(leg.times[0])], ['takes', time(lasting(leg))],
    ['from', leg.from.map((v) => plainNumber(v, 1)).join(', ')], ['to', leg.to.map((v) => plainNumber(v, 1)).join(', ')],
    ['logged', leg.log ? 'yes' : 'no'], ['', leg.infeasible ? 'cannot be steered as drawn' : ''],
  ]);
}

function tellGap(gap, rank) {
  return telling('Gap ' + rank, [['area', square(gap.area_m2)], ['cells', count(gap.cells)], ['why', gap.cause],
    ['position', fileText(gap.at)], ['', lonLatText(gap.at)]]);
}

const violationNames = {
  'infeasible': (v) => 'infeasible ' + v.kind.replace('_', '-'), 'outside water': () => 'outside safe water',
  'tight turn': () => 'tight turn',
};
function tellViolation(v, rank) {
  return telling(`${rank}: ${violationNames[v.what](v)}`, [['length', number(v.length_m, 1) + ' m'], ['why', v.reason], ['position', fileText(v.at)]]);
}

const pane = (name, options) => ({pane: name, ...options});
const poly = (rings, options) => L.polygon(rings.map(line), {interactive: false, ...options});
/** Leaflet takes a node as it is: no text of the data becomes markup. */
const telled = (layer, content) => layer.bindPopup(content, {maxWidth: 320});
const mark = (place, node, options = {}) => L.marker(at(place), {interactive: false, keyboard: false,
  icon: L.divIcon({className: 'mark', html: node, iconSize: null}), ...options});

// --- grounds -----------------------------------------------------------------------------------
const pictures = {depth: new Picture(data.depth), slope: new Picture(data.slope)};
for (const p of plans) {
  p.coveragePicture = new Picture(p.coverage, data.legend.palette);
  if (p.criterion) p.tvuPicture = new Picture(p.criterion.tvu);
}
const grounds = [
  ['depth', 'Depth', () => pictures.depth],
  ['slope', 'Slope', () => pictures.slope],
  ['soundings', 'Soundings a cell', () => plan().coveragePicture],
  ...(plans.some((p) => p.criterion) ? [['tvu', 'TVU', () => plan().tvuPicture]] : []),
];
let ground = 'depth';

// --- layers above ------------------------------------------------------------------------------
function pathStyle(leg) {
  if (leg.kind === 'transit' || !leg.sonar) return {color: colour('transit'), weight: 1.8, dashArray: '6 4'};
  return leg.log && !joining.has(leg.kind) ? {color: colour('path'), weight: 1.7} : {color: colour('turn'), weight: 1.3};
}

const legLayer = (leg) => L.polyline(line(leg.points), pane('lines', {interactive: false, ...pathStyle(leg)}));

function middleOf(leg) {
  let left = leg.points.slice(1).reduce((sum, p, i) => sum + distance(leg.points[i], p), 0) / 2;
  for (let i = 1; i < leg.points.length; ++i) {
    const step = distance(leg.points[i - 1], leg.points[i]);
    if (step >= left && step > 0) {
      const t = left / step, [a, b] = [leg.points[i - 1], leg.points[i]];
      return {place: [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])], turn: Math.atan2(b[0] - a[0], b[1] - a[1]) * 180 / Math.PI};
    }
    left -= step;
  }
  return {place: leg.points[0], turn: 0};
}

/** Numbers of lines, those of long lines first; map.js leaves out what would cover others. */
function numberLayers(p) {
  const lines = p.legs.filter((leg) => !joining.has(leg.kind) && leg.log).sort((a, b) => b.length_m - a.length_m);
  return lines.map((leg) => ({...middleOf(leg), text: leg.line === null ? '' : String(leg.line)}));
}
function numberMark({place, turn, text}) {
  return mark(place, element('span', {class: 'lineno'}, element('i', {style: `transform:rotate(${turn.toFixed(0)}deg)`}, '▲'), text), {pane: 'numbers'});
}

function gapLayers(p) {
  return p.holidays.flatMap((gap, i) => {
    const b = metres(gap.box);
    const rings = gap.rings.length ? gap.rings : [[[b.x0, b.y0], [b.x1, b.y0], [b.x1, b.y1], [b.x0, b.y1]]];
    gap.target = telled(poly(rings, pane('gaps', {interactive: true, color: colour('gap'), weight: 1.6, fillColor: colour('gap'), fillOpacity: 0.22})),
      () => tellGap(gap, i + 1));
    const badge = telled(mark(gap.at, element('span', {class: 'badge gap'}, String(i + 1)), {pane: 'numbers', interactive: true}),
      () => tellGap(gap, i + 1));
    return i < 10 ? [gap.target, badge] : [gap.target];
  });
}

function violationLayers(p) {
  return p.violations.list.flatMap((v, i) => {
    const points = line(v.line), tell = () => tellViolation(v, i + 1);
    v.target = telled(L.polyline(points, pane('gaps', {color: '#000', weight: 7})), tell);
    return [v.target, telled(L.polyline(points, pane('gaps', {color: '#ffd500', weight: 4.5, dashArray: '7 8'})), tell),
      ...(i < 20 ? [telled(mark(v.at, element('span', {class: 'badge violation'}, String(i + 1)), {pane: 'numbers', interactive: true}), tell)] : [])];
  });
}

function endLayers(p) {
  const first = p.legs[0], last = p.legs[p.legs.length - 1];
  return [mark(last.points[last.points.length - 1], element('span', {class: 'badge end', title: 'end'}, 'E'), {pane: 'numbers'}),
    mark(first.points[0], element('span', {class: 'badge start', title: 'start'}, 'S'), {pane: 'numbers'})];
}

const edge = (edges, name, width) => edges.flatMap((e) => [
  L.polyline(line(e), pane('gaps', {color: colour('casing'), weight: width + 2.5, interactive: false})),
  L.polyline(line(e), pane('gaps', {color: colour(name), weight: width, interactive: false}))]);

/** No-go areas, and above them each hazard with its room. */
function hazardLayers() {
  const look = (ink) => pane('area', {interactive: true, color: ink, weight: 1.2, dashArray: '4 3', fillColor: ink, fillOpacity: 0.28});
  const tellHazard = (h) => telling(h.name || h.layer, [['layer', h.layer], ['room around it', number(h.buffer_m, 1) + ' m'],
    ['accuracy of its place', `${number(h.accuracy_m, 1)} m (${h.accuracy_from})`],
    ['', h.to_be_seen ? 'not sailed over, but to be seen' : 'the boat keeps out of it']]);
  return [telled(poly(site.noGo, look('#b3261e')), () => telling('No-go area', [['', 'the boat keeps out of it']])),
    ...site.hazards.map((h) => telled(poly(h.rings, look(h.to_be_seen ? '#8a2be2' : '#b3261e')), () => tellHazard(h)))];
}

// [key, name, shown at first, whether there is any, its layers for a plan]
const overlays = [
  ['area', 'Survey area', true, true, () => [poly(site.area, pane('area', {color: '#10202c', weight: 1.8, fill: false}))]],
  ['water', 'Safe water', false, site.water.length, () =>
    [poly(site.water, pane('area', {color: '#00796b', weight: 1.2, dashArray: '3 3', fillColor: '#00bfa5', fillOpacity: 0.15}))]],
  ['hazards', 'Hazards and no-go', true, site.noGo.length + site.hazards.length, hazardLayers],
  ['cut', 'Area outside safe water', true, site.cutOff.count, () => [telled(poly(site.cutOff.rings, pane('area', {interactive: true,
    color: colour('cut'), weight: 1.2, dashArray: '2 4', fillColor: colour('cut'), fillOpacity: 0.18})), () => telling('Area outside safe water',
    [['area', square(site.cutOff.area_m2)], ['share', number(site.cutOff.share_pct, 2) + ' %'], ['', 'its cells still count in the coverage']]))]],
  ['swaths', 'Swath outlines', false, true, (p) => p.legs.filter((leg) => leg.swath.length).map((leg) =>
    poly(leg.swath, pane('swaths', {color: '#1769aa', weight: 1, fillColor: '#1769aa', fillOpacity: 0.08, fillRule: 'nonzero'})))],
  ['lines', 'Lines', true, true, (p) => p.legs.filter((leg) => !joining.has(leg.kind)).map(legLayer)],
  ['joins', 'Turns and transits', true, true, (p) => [...p.legs.filter((leg) => joining.has(leg.kind)).map(legLayer), ...endLayers(p)]],
  ['numbers', 'Line numbers', true, true, null],
  ['gaps', 'Gaps', true, plans.some((p) => p.holidays.length), gapLayers],
  ['violations', 'Violations', true, plans.some((p) => p.violations.count), violationLayers],
  ['regions', 'Depth regions', false, site.regions.length, () => site.regions.flatMap((r) => [
    poly(r.rings, pane('area', {color: '#fff', weight: 3, fill: false})), poly(r.rings, pane('area', {color: '#33414f', weight: 1.2, fill: false})),
    mark(r.label, element('span', {class: 'region'}, number(r.mean_depth_m, 1) + ' m · fan ' + number(r.opening_deg) + '°'), {pane: 'numbers'})])],
  ['gates', 'Gates and blocked edges', false, site.gates.length + site.blocked.length, () =>
    [...edge(site.blocked, 'blocked', 2.2), ...edge(site.gates, 'gate', 4)]],
  ['grid', hasCrs ? 'Grid of ' + data.crs.split(' ')[0] : 'Grid', false, true, null],
  ['graticule', 'Latitude and longitude', false, data.lonlat !== null, null],
].filter(([, , , has]) => has);
const shown = Object.fromEntries(overlays.map(([key, , on]) => [key, on]));
