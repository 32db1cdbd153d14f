// Buttons of the map, and the ruler.

for (const button of document.querySelectorAll('[data-zoom]')) {
  button.addEventListener('click', () => ({in: () => map.zoomIn(), out: () => map.zoomOut(), all: showAll})[button.dataset.zoom]());
}
mapNode.addEventListener('keydown', (event) => {
  if (event.key === '0') showAll();
  if (!ruler.on) return;
  if (event.key === 'Enter') ruler.add(map.getCenter());
  if (event.key === 'Escape') ruler.stop();
});

/** Measures from click to click: length and azimuth of each leg, and the sum. */
const ruler = {
  on: false, points: [], layer: L.layerGroup().addTo(map),
  start() {
    this.on = true;
    this.points = [];
    this.draw();
    $('ruler').setAttribute('aria-pressed', 'true');
    mapNode.classList.add('measuring');
    $('readout').textContent = 'Ruler: click where to begin';
  },
  stop() {
    this.on = false;
    this.layer.clearLayers();
    $('ruler').setAttribute('aria-pressed', 'false');
    mapNode.classList.remove('measuring');
  },
  add(latlng) {
    this.points.push([latlng.lng, latlng.lat]);
    this.draw();
  },
  says(to) {
    const all = to ? [...this.points, to] : this.points;
    if (all.length < 2) return '';
    const legs = all.slice(1).map((p, i) => distance(all[i], p));
    const last = `${long(legs[legs.length - 1])}, ${bearing(azimuth(all[all.length - 2], all[all.length - 1]))}`;
    return legs.length > 1 ? `${last}; ${long(legs.reduce((a, b) => a + b, 0))} in all` : last;
  },
  draw(to = null) {
    this.layer.clearLayers();
    const all = to ? [...this.points, to] : this.points;
    for (const [ink, weight] of [['#fff', 5], ['#10202c', 2]]) {
      this.layer.addLayer(L.polyline(line(all), {pane: 'trail', interactive: false, color: ink, weight}));
    }
    for (const p of this.points) this.layer.addLayer(L.circleMarker(at(p), {pane: 'trail', interactive: false, radius: 4, color: '#10202c', fillColor: '#fff', fillOpacity: 1, weight: 2}));
    const text = this.says(to);
    if (text) this.layer.addLayer(mark(all[all.length - 1], element('span', {class: 'measure'}, text), {pane: 'boat'}));
    if (text && !to) $('readout').textContent = 'Ruler: ' + text;
  },
};
$('ruler').addEventListener('click', () => (ruler.on ? ruler.stop() : ruler.start()));
map.on('click', (event) => {
  if (ruler.on) return ruler.add(event.latlng);
  // Gaps, violations and areas tell of themselves.
  if (event.originalEvent.target.closest('.leaflet-interactive')) return;
  const place = [event.latlng.lng, event.latlng.lat], leg = legNear(place);
  if (leg) openLeg(leg, place);
});
map.on('mousemove', (event) => ruler.on && ruler.points.length && ruler.draw([event.latlng.lng, event.latlng.lat]));
// While measuring, a click on a line measures and does not tell.
map.on('popupopen', () => ruler.on && map.closePopup());
