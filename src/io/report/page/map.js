// The map itself: Leaflet in metres, with panes one above the other.

$('map').style.setProperty('--shape', (whole.y1 - whole.y0) / (whole.x1 - whole.x0));
const map = L.map('map', {
  crs: L.CRS.Simple, zoomControl: false, attributionControl: false, zoomSnap: 0, zoomDelta: 0.7, wheelPxPerZoomLevel: 90,
  scrollWheelZoom: false, minZoom: -14, maxZoom: 9, zoomAnimation: false, fadeAnimation: false, markerZoomAnimation: false,
  keyboardPanDelta: 60, maxBoundsViscosity: 0.6,
});
['ground', 'grid', 'area', 'swaths', 'lines', 'gaps', 'numbers', 'trail', 'boat'].forEach((name, i) => {
  map.createPane(name).style.zIndex = 300 + 10 * i;
});
const home = boundsOf(whole);
map.fitBounds(home);
map.setMaxBounds(L.latLngBounds(home).pad(0.6));
L.control.scale({imperial: false, maxWidth: 160}).addTo(map);
const mapNode = map.getContainer();
mapNode.setAttribute('role', 'application');
mapNode.setAttribute('aria-roledescription', 'map');
mapNode.setAttribute('aria-label', 'Map of the plan. Arrow keys pan, plus and minus zoom, 0 shows all. Lines, gaps and violations are in the tables below.');

// North.
{
  const corner = L.control({position: 'topright'});
  const off = data.grid_north_deg;
  corner.onAdd = () => element('div', {class: 'north', role: 'img', 'aria-label': Math.abs(off) < 0.05 ? 'North is up'
    : `True north lies ${number(Math.abs(off), 1)} degrees ${off > 0 ? 'left' : 'right'} of up`},
    svg('svg', {viewBox: '-14 -18 28 40', width: 28, height: 40, style: `transform:rotate(${-off}deg)`},
      svg('path', {d: 'M0 -16 L7 8 L0 4 L-7 8 Z'}), svg('text', {x: 0, y: 20, 'text-anchor': 'middle'}, 'N')));
  corner.addTo(map);
}

// Until somebody moves the map, all of it stays in view whatever the size of the window.
let showsAll = true, fitting = false;
function showAll() {
  fitting = true;
  map.fitBounds(home, {animate: false});
  fitting = false;
  showsAll = true;
}
map.on('movestart zoomstart', () => { if (!fitting) showsAll = false; });
function refit() {
  const all = showsAll;
  fitting = true;
  map.invalidateSize({animate: false, pan: false});
  fitting = false;
  if (all) showAll();
}
function showBox(box) {
  const b = metres(box), wide = 25 * data.resolution_m;
  const grow = Math.max(wide, b.x1 - b.x0, b.y1 - b.y0);
  map.fitBounds([[b.y0 - grow, b.x0 - grow], [b.y1 + grow, b.x1 + grow]]);
}
/** From a table: the map moves there; `tell` opens what it says of it. */
function visit(box, tell) {
  $('map-section').scrollIntoView({block: 'start'});
  mapNode.focus({preventScroll: true});
  showBox(box);
  if (tell) tell();
}
const tellOf = (layer, place) => () => map.hasLayer(layer) && layer.openPopup(at(place));

// A map must not stop a page that scrolls past it: the wheel zooms once the map was clicked, and on a
// small screen one finger moves the page until the map is zoomed in.
mapNode.addEventListener('pointerdown', () => map.scrollWheelZoom.enable());
mapNode.addEventListener('mouseleave', () => map.scrollWheelZoom.disable());
const coarse = matchMedia('(pointer: coarse)').matches;
if (coarse) {
  const homeZoom = () => map.getBoundsZoom(home);
  const settle = () => map.dragging[map.getZoom() > homeZoom() + 0.2 ? 'enable' : 'disable']();
  map.on('zoomend resize', settle);
  settle();
}

// --- layers ------------------------------------------------------------------------------------
const overGround = L.layerGroup().addTo(map);
const groups = Object.fromEntries(overlays.map(([key]) => [key, L.layerGroup()]));

function drawGround() {
  overGround.clearLayers();
  const entry = grounds.find(([key]) => key === ground) || grounds[0];
  const picture = entry[2]();
  if (picture) {
    overGround.addLayer(L.imageOverlay(picture.address, boundsOf(picture.box), {pane: 'ground', className: 'picture', alt: entry[1] + ' over the map'}));
  }
  drawLegend();
}

function drawOverlay(key) {
  if (key === 'grid' || key === 'graticule') return drawGrids();
  if (key === 'numbers') return drawNumbers();
  const entry = overlays.find(([k]) => k === key);
  groups[key].clearLayers();
  if (shown[key]) for (const layer of entry[4](plan())) groups[key].addLayer(layer);
  groups[key].addTo(map);
}

function drawAll() {
  map.closePopup();
  drawGround();
  for (const [key] of overlays) drawOverlay(key);
}
choosers.push(drawAll);

/** Numbers that would cover others are left out. */
function drawNumbers() {
  groups.numbers.clearLayers().addTo(map);
  const taken = [];
  for (const label of shown.numbers ? numberLayers(plan()) : []) {
    const p = map.latLngToContainerPoint(at(label.place));
    if (taken.some((q) => Math.abs(p.x - q.x) < 48 && Math.abs(p.y - q.y) < 24)) continue;
    taken.push(p);
    groups.numbers.addLayer(numberMark(label));
  }
}
map.on('zoomend', drawNumbers);

// --- a click on a line -------------------------------------------------------------------------
let marked = null;
function openLeg(leg, place) {
  map.openPopup(L.popup({maxWidth: 320}).setLatLng(at(place)).setContent(tellLeg(leg)));
  marked = L.polyline(line(leg.points), {pane: 'trail', interactive: false, color: '#ffb300', weight: 5, opacity: 0.8}).addTo(map);
}
map.on('popupclose', () => {
  if (marked) marked.remove();
  marked = null;
});

/** The drawn leg nearest to a place, if it lies within some pixels. */
function legNear([x, y]) {
  const reach = 9 / 2 ** map.getZoom();
  let best = null, nearest = reach;
  for (const leg of plan().legs) {
    if (!shown[joining.has(leg.kind) ? 'joins' : 'lines']) continue;
    for (let i = 1; i < leg.points.length; ++i) {
      const [[ax, ay], [bx, by]] = [leg.points[i - 1], leg.points[i]];
      const dx = bx - ax, dy = by - ay, square = dx * dx + dy * dy;
      const t = square > 0 ? Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / square)) : 0;
      const far = Math.hypot(x - ax - t * dx, y - ay - t * dy);
      if (far < nearest) [best, nearest] = [leg, far];
    }
  }
  return best;
}

for (const [key, name, picture] of grounds) {
  const input = element('input', {type: 'radio', name: 'ground', value: key, onchange: () => {
    ground = key;
    drawGround();
  }});
  input.checked = key === ground;
  $('grounds').append(element('label', {}, input, name));
}
for (const [key, name, on] of overlays) {
  const input = element('input', {type: 'checkbox', onchange: () => {
    shown[key] = input.checked;
    drawOverlay(key);
    drawLegend();
  }});
  input.checked = on;
  $('overlays').append(element('label', {}, input, name));
}

// --- legend ------------------------------------------------------------------------------------
const item = (...parts) => element('span', {class: 'item'}, ...parts);
const sample = (kind, name) => element('span', {class: kind, style: `--c:var(--${name})`, 'aria-hidden': 'true'});
const ramp = (stops) => element('span', {class: 'ramp', style: `background:linear-gradient(90deg,${stops})`, 'aria-hidden': 'true'});

const groundLegends = {
  depth() {
    const {min_m: min, max_m: max, palette, levels, shades} = data.depth;
    const stops = [0, 0.25, 0.5, 0.75, 1].map((t) => palette[1 + Math.round(t * (levels - 1)) * shades + 2]);
    return [item(number(min, 1) + ' m', ramp(stops), number(max, 1) + ' m deep, isobaths each ' + data.depth.isobath_m + ' m')];
  },
  slope() {
    const colours = data.slope.palette.slice(1);
    return [item('0°', ramp(colours), number((colours.length - 1) * data.slope.step_deg) + '° and more, over ' + number(data.slope.pixel_m, 1) + ' m')];
  },
  soundings() {
    const {palette, covered, covered_names: names, empty, empty_steps: steps} = data.legend;
    const strip = element('span', {class: 'strip'}, ...names.map((name, i) => element('i', {style: '--c:' + palette[covered + i]}, name)));
    return [item('Soundings a cell', strip), item('Gap: few', ramp([palette[empty + 1], palette[empty + steps / 2], palette[empty + steps]]),
      'to all cells without a ' + (plan().counted === 'logged' ? 'logged ' : '') + 'sounding')];
  },
  tvu() {
    if (!plan().criterion) return [];
    const palette = plan().criterion.tvu.palette;
    return [item('Best TVU of a cell: 0', ramp(palette.slice(1, -1)), 'its limit'),
      item(element('span', {class: 'box', style: '--c:' + palette[palette.length - 1]}), 'beyond it')];
  },
};

function drawLegend() {
  const on = (key, ...parts) => (shown[key] ? [item(...parts)] : []);
  $('legend').replaceChildren(...groundLegends[ground](),
    ...on('lines', sample('stroke', 'path'), 'line'), ...on('joins', sample('stroke', 'turn'), 'turn or not logged'),
    ...on('joins', sample('stroke dash', 'transit'), 'transit or sonar off'), ...on('gaps', sample('box', 'gap'), 'gap'),
    ...on('violations', element('span', {class: 'hazard'}), 'cannot be sailed as drawn'),
    ...on('cut', sample('box', 'cut'), 'survey area outside safe water'),
    ...on('gates', sample('stroke', 'gate'), 'gate'), ...on('gates', sample('stroke', 'blocked'), 'blocked edge'),
    ...on('joins', 'S start, E end'));
}

// --- what lies under the pointer ---------------------------------------------------------------
function soundingsAt(place) {
  const index = plan().coveragePicture.indexAt(place), legend = data.legend;
  if (index === 0) return '';
  if (index > legend.empty) {
    return plan().coverage.factor === 1 ? 'no sounding' : 'up to ' + Math.round(100 * (index - legend.empty) / legend.empty_steps) + ' % of cells here empty';
  }
  const name = legend.covered_names[index - legend.covered];
  return name.replace('-', ' to ') + (name === '1' ? ' sounding a cell' : ' soundings a cell');
}

function depthAt(place) {
  const index = pictures.depth.indexAt(place);
  const {min_m: min, max_m: max, levels, shades} = data.depth;
  return index ? min + (Math.floor((index - 1) / shades) + 0.5) / levels * (max - min) : null;
}

function tellPlace(place) {
  const depth = depthAt(place), steep = pictures.slope.indexAt(place);
  $('readout').textContent = [fileText(place), lonLatText(place),
    depth === null ? 'no seafloor' : `about ${number(depth, 1)} m deep, slope ${number((steep - 1) * data.slope.step_deg)}°`,
    soundingsAt(place)].filter(Boolean).join(' · ');
}
map.on('mousemove', (event) => tellPlace([event.latlng.lng, event.latlng.lat]));
map.on('moveend', () => {
  if (document.activeElement === mapNode) tellPlace([map.getCenter().lng, map.getCenter().lat]);
});

// --- grid and graticule ------------------------------------------------------------------------
const gridLayer = L.layerGroup().addTo(map);
const frame = mapNode.appendChild(element('div', {class: 'frame', 'aria-hidden': 'true'}));

function spread(low, high) {
  return ticks(low, high, 6).filter((v) => v >= low && v <= high);
}

/** Lines where the k-th coordinate is `value`, and a label where they leave the map. */
function gridLine(points, text, edge, kind) {
  gridLayer.addLayer(L.polyline(line(points), {pane: 'grid', interactive: false, className: kind, weight: 1}));
  const p = map.latLngToContainerPoint(at(points[0])), size = map.getSize();
  const within = edge === 'left' || edge === 'right' ? p.y > 8 && p.y < size.y - 30 : p.x > 30 && p.x < size.x - 40;
  if (!within) return;
  frame.append(element('span', {class: `${edge} ${kind}`, style: edge === 'left' || edge === 'right' ? `top:${p.y}px` : `left:${p.x}px`}, text));
}

function drawGrids() {
  gridLayer.clearLayers();
  frame.replaceChildren();
  const view = map.getBounds(), x0 = view.getWest(), x1 = view.getEast(), y0 = view.getSouth(), y1 = view.getNorth();
  const unit = 100 * data.file_units_per_cm;
  if (shown.grid) {
    const [[ex0, ny0], [ex1, ny1]] = [fileOf([x0, y0]), fileOf([x1, y1])];
    for (const e of spread(ex0, ex1)) {
      const x = (e - data.file_corner[0]) / unit;
      gridLine([[x, y0], [x, y1]], String(e), 'bottom', 'grid');
    }
    for (const n of spread(ny0, ny1)) {
      const y = (n - data.file_corner[1]) / unit;
      gridLine([[x0, y], [x1, y]], String(n), 'left', 'grid');
    }
  }
  if (shown.graticule && data.lonlat) {
    const corners = [[x0, y0], [x1, y0], [x0, y1], [x1, y1]].map(lonLatOf);
    const range = (k) => [Math.min(...corners.map((c) => c[k])), Math.max(...corners.map((c) => c[k]))];
    const [lon, lat] = [range(0), range(1)], along = ([low, high]) => Array.from({length: 9}, (_, i) => low + i / 8 * (high - low));
    const degrees = (v, letters) => hemisphere(v, letters, 5).replace(/\.?0+°/, '°');
    for (const v of spread(...lon)) gridLine(along(lat).reverse().map((w) => placeOf([v, w])), degrees(v, 'EW'), 'top', 'graticule');
    for (const v of spread(...lat)) gridLine(along(lon).reverse().map((w) => placeOf([w, v])), degrees(v, 'NS'), 'right', 'graticule');
  }
}
map.on('moveend resize', drawGrids);
