// The plans, unpacked.

const tints = ['#0072b2', '#d55e00', '#009e73', '#cc79a7', '#8a6d00', '#56b4e9', '#6b4fb3', '#555555'];
/** What these kinds of legs are called; others go by their own name. */
const kindNames = {run_in: 'run-in', run_out: 'run-out', cross: 'cross-line', infill: 'infill',
  patch: 'patch-test line'};
/** Kinds that join lines. All others are listed as lines. */
const joining = new Set(['turn', 'transit', 'run_in', 'run_out', 'end']);

/** A palette picture that knows which index lies where. */
class Picture {
  constructor(source, palette = source.palette) {
    Object.assign(this, {columns: source.columns, rows: source.rows, box: metres(source.box)});
    this.indices = new Map();
    palette.forEach((hex, i) => {
      if (hex && !this.indices.has(hex)) this.indices.set(hex, i);
    });
    this.address = 'data:image/png;base64,' + source.png;
    this.image = new Image();
    this.image.src = this.address;
  }

  /** The palette index at a place on the ground; 0 where there is nothing. */
  indexAt([x, y]) {
    if (!this.image.complete || !this.image.naturalWidth) return 0;
    if (!this.pixels) {
      const canvas = element('canvas', {width: this.columns, height: this.rows});
      const ink = canvas.getContext('2d', {willReadFrequently: true});
      ink.drawImage(this.image, 0, 0);
      this.pixels = ink.getImageData(0, 0, this.columns, this.rows).data;
    }
    const column = Math.floor((x - this.box.x0) / (this.box.x1 - this.box.x0) * this.columns);
    const row = Math.floor((this.box.y1 - y) / (this.box.y1 - this.box.y0) * this.rows);
    if (column < 0 || row < 0 || column >= this.columns || row >= this.rows) return 0;
    const i = 4 * (row * this.columns + column);
    if (this.pixels[i + 3] === 0) return 0;
    const hex = '#' + [0, 1, 2].map((k) => this.pixels[i + k].toString(16).padStart(2, '0')).join('');
    return this.indices.get(hex) || 0;
  }
}

function unpackedLeg(leg, i) {
  let now = 0;
  return {...leg, index: i, points: decoded(leg.points), times: leg.times.map((t) => (now += t) / 10),
    swath: (leg.swath || []).map(decoded)};
}

/** Legs without a number are counted by kind, in the order of sailing. */
function numbered(legs) {
  const counts = {};
  return legs.map((leg) => {
    const ordinal = counts[leg.kind] = (counts[leg.kind] || 0) + 1;
    return {...leg, number: leg.line === null ? '#' + ordinal : String(leg.line)};
  });
}
const kindName = (leg) => kindNames[leg.kind] || leg.kind;
const legName = (leg) => `${kindName(leg)} ${leg.number}`;

const plans = data.plans.map((plan, i) => ({
  ...plan, tint: tints[i % tints.length],
  legs: numbered(plan.legs.map(unpackedLeg)),
  holidays: plan.holidays.map((gap) => ({...gap, at: decoded(gap.at)[0], rings: gap.rings.map(decoded)})),
  violations: {...plan.violations, list: plan.violations.list.map((v) =>
    ({...v, line: decoded(v.line), at: decoded(v.at)[0]}))},
}));
const site = {
  area: data.area.map(decoded), water: data.water.map(decoded), noGo: data.no_go.map(decoded),
  hazards: data.hazards.map((h) => ({...h, rings: h.rings.map(decoded)})),
  regions: data.regions.map((r) => ({...r, rings: r.rings.map(decoded), label: decoded(r.label)[0]})),
  gates: data.gates.map(decoded), blocked: data.blocked.map(decoded),
  cutOff: {...data.cut_off, rings: data.cut_off.rings.map(decoded),
    list: data.cut_off.list.map((piece) => ({...piece, at: decoded(piece.at)[0]}))},
};

let chosen = data.best;
/** Called with the plan whenever another one is chosen. */
const choosers = [];
const plan = () => plans[chosen];
