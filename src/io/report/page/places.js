// Places: metres on the map, the user's coordinates, longitude and latitude.

const whole = metres(data.box);
const hasCrs = data.crs !== 'none';

/** [x, y] in metres -> the coordinates of the user's file. */
function fileOf([x, y]) {
  return [x, y].map((v, k) => data.file_corner[k] + v * 100 * data.file_units_per_cm);
}
function fileText(place) {
  return fileOf(place).map((v) => plainNumber(v, 1)).join(', ');
}

const side = data.lonlat ? Math.round(Math.sqrt(data.lonlat.length / 2)) : 0;

/** Lagrange's weights of even places at `t` in [0, 1]. */
function weights(t) {
  return Array.from({length: side}, (_, i) => {
    let w = 1;
    for (let k = 0; k < side; ++k) if (k !== i) w *= (t * (side - 1) - k) / (i - k);
    return w;
  });
}

/** [x, y] in metres -> [longitude, latitude]; null where nobody knows. */
function lonLatOf([x, y]) {
  if (!side) return null;
  const u = weights((x - whole.x0) / (whole.x1 - whole.x0));
  const v = weights((y - whole.y0) / (whole.y1 - whole.y0));
  let lon = 0, lat = 0;
  v.forEach((b, row) => u.forEach((a, column) => {
    const at = 2 * (row * side + column);
    lon += a * b * data.lonlat[at];
    lat += a * b * data.lonlat[at + 1];
  }));
  return [lon, lat];
}

/** The way back, by Newton's steps. */
function placeOf(lonLat) {
  let at = [(whole.x0 + whole.x1) / 2, (whole.y0 + whole.y1) / 2];
  const h = (whole.x1 - whole.x0) / 100;
  for (let i = 0; i < 4; ++i) {
    const here = lonLatOf(at), east = lonLatOf([at[0] + h, at[1]]), north = lonLatOf([at[0], at[1] + h]);
    const [a, c] = east.map((v, k) => (v - here[k]) / h), [b, d] = north.map((v, k) => (v - here[k]) / h);
    const [p, q] = lonLat.map((v, k) => v - here[k]), det = a * d - b * c;
    at = [at[0] + (d * p - b * q) / det, at[1] + (a * q - c * p) / det];
  }
  return at;
}

const hemisphere = (v, [plus, minus], digits) => Math.abs(v).toFixed(digits) + '° ' + (v < 0 ? minus : plus);
function lonLatText(place, digits = 6) {
  const at = lonLatOf(place);
  return at ? hemisphere(at[1], 'NS', digits) + ', ' + hemisphere(at[0], 'EW', digits) : '';
}

/** Azimuth from true north, degrees. */
function azimuth(from, to) {
  const grid = Math.atan2(to[0] - from[0], to[1] - from[1]) * 180 / Math.PI;
  return (grid + data.grid_north_deg + 720) % 360;
}
const bearing = (degrees) => String(Math.round(degrees) % 360).padStart(3, '0') + '°';
const distance = (a, b) => Math.hypot(b[0] - a[0], b[1] - a[1]);
