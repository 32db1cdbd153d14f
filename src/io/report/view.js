'use strict';
// The one view that all maps share, in metres from the lower-left corner of the data's box.

const data = JSON.parse(document.getElementById('data').textContent);

function element(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith('on')) node.addEventListener(name.slice(2), value);
    else if (value !== null && value !== undefined) node.setAttribute(name, value);
  }
  node.append(...children);
  return node;
}

/** [x, y, dx, dy, ...] in centimetres -> [x, y, x, y, ...] in metres. */
function decoded(line) {
  const out = new Float64Array(line.length);
  let x = 0, y = 0;
  for (let i = 0; i < line.length; i += 2) {
    out[i] = (x += line[i]) / 100;
    out[i + 1] = (y += line[i + 1]) / 100;
  }
  return out;
}

const metres = (box) => ({x0: box[0] / 100, y0: box[1] / 100, x1: box[2] / 100, y1: box[3] / 100});
const whole = metres(data.box);
const home = {
  x: (whole.x0 + whole.x1) / 2, y: (whole.y0 + whole.y1) / 2,
  w: whole.x1 - whole.x0, h: whole.y1 - whole.y0,
};

const view = {...home};
const maps = [];
let waiting = false;

function redraw() {
  if (waiting) return;
  waiting = true;
  requestAnimationFrame(() => {
    waiting = false;
    for (const map of maps) map.draw();
  });
}

function setView(next) {
  const smallest = Math.max(40 * data.resolution_m, 0.5) / home.w;
  const share = Math.min(1.15, Math.max(smallest, next.w / home.w));
  view.w = home.w * share;
  view.h = home.h * share;
  view.x = Math.min(whole.x1, Math.max(whole.x0, next.x));
  view.y = Math.min(whole.y1, Math.max(whole.y0, next.y));
  for (const map of maps) map.canvas.style.touchAction = share < 0.99 ? 'none' : 'pan-y';
  redraw();
}

/** Zooms by `factor` (above 1: closer) and keeps the point (x, y) where it is. */
function zoom(factor, x = view.x, y = view.y) {
  const before = view.w;
  setView({...view, w: view.w / factor, h: view.h / factor});
  const done = before / view.w;
  setView({...view, x: x + (view.x - x) / done, y: y + (view.y - y) / done});
}

function showAll() { setView(home); }

function showBox(box) {
  const b = metres(box);
  const share = 3 * Math.max((b.x1 - b.x0) / home.w, (b.y1 - b.y0) / home.h, 25 * data.resolution_m / home.w);
  setView({x: (b.x0 + b.x1) / 2, y: (b.y0 + b.y1) / 2, w: home.w * share, h: home.h * share});
}

/** Where the pointer is, told to all that show something of it. */
const pointerListeners = [];
function pointAt(place) {
  for (const listener of pointerListeners) listener(place);
}

/** Pointer, wheel and keys of a map's canvas. */
function steer(map) {
  const canvas = map.canvas;
  const down = new Map();
  const place = (event) => {
    const box = canvas.getBoundingClientRect();
    return map.toGround(event.clientX - box.left, event.clientY - box.top);
  };
  canvas.addEventListener('pointerdown', (event) => {
    down.set(event.pointerId, event);
    canvas.setPointerCapture(event.pointerId);
    canvas.focus({preventScroll: true});
  });
  canvas.addEventListener('pointermove', (event) => {
    const before = down.get(event.pointerId);
    if (!before) return pointAt(place(event));
    const others = [...down.values()].filter((e) => e.pointerId !== event.pointerId);
    if (others.length > 0) {
      const span = (a, b) => Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
      const old = span(before, others[0]);
      if (old > 0) zoom(span(event, others[0]) / old, ...place(others[0]));
    } else if (event.pointerType !== 'touch' || view.w < 0.99 * home.w) {
      setView({...view, x: view.x - (event.clientX - before.clientX) / map.scale(),
               y: view.y + (event.clientY - before.clientY) / map.scale()});
    }
    down.set(event.pointerId, event);
  });
  const up = (event) => down.delete(event.pointerId);
  canvas.addEventListener('pointerup', up);
  canvas.addEventListener('pointercancel', up);
  canvas.addEventListener('pointerleave', () => pointAt(null));
  canvas.addEventListener('wheel', (event) => {
    // A map must not stop a page that scrolls past it.
    if (document.activeElement !== canvas && !event.ctrlKey) return;
    event.preventDefault();
    zoom(Math.exp(-event.deltaY * (event.deltaMode === 1 ? 0.06 : 0.002)), ...place(event));
  }, {passive: false});
  canvas.addEventListener('keydown', (event) => {
    const step = view.w / 10;
    const move = {
      ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, step], ArrowDown: [0, -step],
    }[event.key];
    if (move) setView({...view, x: view.x + move[0], y: view.y + move[1]});
    else if (event.key === '+' || event.key === '=') zoom(1.4);
    else if (event.key === '-') zoom(1 / 1.4);
    else if (event.key === '0') showAll();
    else return;
    event.preventDefault();
  });
}
