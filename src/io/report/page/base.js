'use strict';
// What all parts of the page use: its data, elements, numbers in words.

const data = JSON.parse(document.getElementById('data').textContent);
const $ = (id) => document.getElementById(id);
const root = document.documentElement;
const colour = (name) => getComputedStyle(root).getPropertyValue('--' + name).trim();

/** An element with attributes and children. Texts become text nodes, so that no name of a file can run as markup. */
function element(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith('on')) node.addEventListener(name.slice(2), value);
    else if (value !== null && value !== undefined) node.setAttribute(name, value);
  }
  node.append(...children);
  return node;
}

function svg(tag, attributes, ...children) {
  const node = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...children);
  return node;
}

const number = (v, digits = 0) => v.toLocaleString('en-GB', {minimumFractionDigits: digits, maximumFractionDigits: digits});
const plainNumber = (v, digits) => number(v, digits).replaceAll(',', '');
// Never rounded up to 100.
const percentText = (v) => number(v < 100 ? Math.min(v, 99.9) : v, 1);
const percent = (v) => percentText(v) + ' %';
const square = (v) => number(v, v >= 100 ? 0 : v >= 1 ? 1 : 2) + ' m²';
const long = (v) => (v >= 1000 ? number(v / 1000, 1) + ' km' : number(v, v < 10 ? 2 : 0) + ' m');
const short = (v) => number(v, 2) + ' m';
const count = (v) => number(v);
const ratio = (v) => number(v, 2);
const energy = (v) => (v >= 1000 ? number(v / 1000, 2) + ' kWh' : number(v) + ' Wh');
const time = (s) => {
  if (s < 60) return number(s, s < 10 ? 2 : 0) + ' s';
  const minutes = Math.round(s / 60);
  return minutes < 60 ? minutes + ' min' : Math.floor(minutes / 60) + ' h ' + String(minutes % 60).padStart(2, '0') + ' min';
};
/** 1:02:03 */
const clock = (s) => {
  const whole = Math.round(s), part = (v) => String(v).padStart(2, '0');
  return Math.floor(whole / 3600) + ':' + part(Math.floor(whole / 60) % 60) + ':' + part(whole % 60);
};
const plural = (n, one, many = one + 's') => `${count(n)} ${n === 1 ? one : many}`;

/** Round numbers from `low` to `high`, about `wanted` of them. */
function ticks(low, high, wanted) {
  const rough = (high - low) / wanted || 1;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((f) => f * power).find((s) => s >= rough * 0.999);
  const first = Math.floor(low / step + 1e-9), last = Math.ceil(high / step - 1e-9);
  return Array.from({length: last - first + 1}, (_, i) => +((first + i) * step).toPrecision(12));
}

/** [x, y, dx, dy, ...] in centimetres -> [[x, y], ...] in metres. */
function decoded(line) {
  const out = [];
  let x = 0, y = 0;
  for (let i = 0; i < line.length; i += 2) out.push([(x += line[i]) / 100, (y += line[i + 1]) / 100]);
  return out;
}
const metres = (box) => ({x0: box[0] / 100, y0: box[1] / 100, x1: box[2] / 100, y1: box[3] / 100});

/** A table with a caption that screen readers tell. */
function table(caption, head, rows) {
  return element('table', {}, element('caption', {}, caption),
    element('thead', {}, element('tr', {}, ...head)), element('tbody', {}, ...rows));
}
const headCell = (text, kind = '') => element('th', {scope: 'col', class: kind}, text);
const cell = (text, kind = '') => element('td', {class: kind}, text);
