// The maps: each a canvas that draws its layers in the shared view.

const root = document.documentElement;
const colour = (name) => getComputedStyle(root).getPropertyValue('--' + name).trim();

/** A palette picture that knows which index lies where. */
class Picture {
  constructor(source, palette, crisp) {
    this.crisp = crisp;  // enlarged pixels stay squares, as cells are; else they are smoothed
    Object.assign(this, {columns: source.columns, rows: source.rows, box: metres(source.box)});
    this.indices = new Map();
    palette.forEach((hex, i) => {
      if (hex && !this.indices.has(hex)) this.indices.set(hex, i);
    });
    this.image = new Image();
    this.image.addEventListener('load', redraw);
    this.image.src = 'data:image/png;base64,' + source.png;
  }

  draw(map) {
    if (!this.image.complete || !this.image.naturalWidth) return;
    const [left, top] = map.toScreen(this.box.x0, this.box.y1);
    const [right, bottom] = map.toScreen(this.box.x1, this.box.y0);
    const pixel = (right - left) / this.columns * (window.devicePixelRatio || 1);
    map.ink.imageSmoothingEnabled = !this.crisp || pixel < 1.5;
    map.ink.imageSmoothingQuality = 'high';
    map.ink.drawImage(this.image, left, top, right - left, bottom - top);
  }

  /** The palette index at a place on the ground; 0 where there is nothing. */
  indexAt(x, y) {
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

/** Pixels under the ground that belong to the scale bar while all is shown. */
const FOOT = 26;

class MapView {
  constructor(parent, label, tallest, paint) {
    this.paint = paint;
    this.tallest = tallest;
    this.canvas = element('canvas', {
      tabindex: 0, role: 'img',
      'aria-label': label + '. Arrow keys pan, plus and minus zoom, 0 shows all.',
    });
    this.cross = element('div', {class: 'cross'});
    this.ink = this.canvas.getContext('2d');
    parent.append(this.canvas, this.cross);
    maps.push(this);
    steer(this);
    pointerListeners.push((place) => this.mark(place));
    new ResizeObserver(redraw).observe(parent);
  }

  scale() { return Math.min(this.width / view.w, (this.height - FOOT) / view.h); }
  toScreen(x, y) {
    const s = this.scale();
    return [this.width / 2 + (x - view.x) * s, (this.height - FOOT) / 2 - (y - view.y) * s];
  }
  toGround(px, py) {
    const s = this.scale();
    return [view.x + (px - this.width / 2) / s, view.y - (py - (this.height - FOOT) / 2) / s];
  }

  fit() {
    this.width = this.canvas.parentElement.clientWidth;
    const shape = Math.min(1.35, Math.max(0.42, home.h / home.w));
    this.height = Math.round(Math.min(this.tallest, this.width * shape)) + FOOT;
    const density = Math.max(2, window.devicePixelRatio || 1);
    if (this.canvas.width !== Math.round(this.width * density) ||
        this.canvas.height !== Math.round(this.height * density)) {
      this.canvas.width = Math.round(this.width * density);
      this.canvas.height = Math.round(this.height * density);
      this.canvas.style.height = this.height + 'px';
    }
    this.ink.setTransform(density, 0, 0, density, 0, 0);
  }

  draw() {
    this.fit();
    if (!this.width) return;
    this.ink.fillStyle = colour('land');
    this.ink.fillRect(0, 0, this.width, this.height);
    this.paint(this);
    this.scaleBar();
  }

  mark(place) {
    const [x, y] = place ? this.toScreen(...place) : [0, 0];
    this.cross.style.display = place ? 'block' : 'none';
    this.cross.style.transform = `translate(${x}px, ${y}px)`;
    this.cross.style.left = this.cross.style.top = '0';
  }

  /** Strokes [x, y, ...] lines in metres with a width in pixels. */
  stroke(lines, style, width, dash = []) {
    const ink = this.ink;
    ink.beginPath();
    for (const line of lines) {
      for (let i = 0; i < line.length; i += 2) {
        const [x, y] = this.toScreen(line[i], line[i + 1]);
        if (i === 0) ink.moveTo(x, y); else ink.lineTo(x, y);
      }
    }
    ink.strokeStyle = style;
    ink.lineWidth = width;
    ink.lineJoin = ink.lineCap = 'round';
    ink.setLineDash(dash);
    ink.stroke();
    ink.setLineDash([]);
  }

  fill(rings, style) {
    const ink = this.ink;
    ink.beginPath();
    for (const ring of rings) {
      for (let i = 0; i < ring.length; i += 2) {
        const [x, y] = this.toScreen(ring[i], ring[i + 1]);
        if (i === 0) ink.moveTo(x, y); else ink.lineTo(x, y);
      }
      ink.closePath();
    }
    ink.fillStyle = style;
    ink.fill('evenodd');
  }

  /** Fills with slanted lines that keep their place on the screen. */
  hatch(rings, style) {
    if (!rings.length) return;
    const ink = this.ink;
    ink.save();
    ink.beginPath();
    for (const ring of rings) {
      ink.moveTo(...this.toScreen(ring[0], ring[1]));
      for (let i = 2; i < ring.length; i += 2) ink.lineTo(...this.toScreen(ring[i], ring[i + 1]));
      ink.closePath();
    }
    ink.clip('evenodd');
    ink.beginPath();
    for (let x = -this.height; x < this.width; x += 6) {
      ink.moveTo(x, this.height);
      ink.lineTo(x + this.height, 0);
    }
    ink.strokeStyle = style;
    ink.lineWidth = 2;
    ink.stroke();
    ink.restore();
    this.stroke(rings, style, 1.6);
  }

  /** A warning triangle with a number. */
  triangle(text, place) {
    const [x, y] = this.toScreen(...place);
    const ink = this.ink;
    ink.beginPath();
    ink.moveTo(x, y - 12);
    ink.lineTo(x + 11, y + 8);
    ink.lineTo(x - 11, y + 8);
    ink.closePath();
    ink.fillStyle = '#ffd500';
    ink.fill();
    ink.lineJoin = 'round';
    ink.lineWidth = 2;
    ink.strokeStyle = '#000000';
    ink.stroke();
    ink.font = '700 10px system-ui, sans-serif';
    ink.textAlign = 'center';
    ink.textBaseline = 'middle';
    ink.fillStyle = '#000000';
    ink.fillText(text, x, y + 2);
  }

  /** A label with a halo, so that it reads on any ground. */
  label(text, x, y, style = '#10202c', halo = 'rgba(255,255,255,0.85)', size = 12) {
    const ink = this.ink;
    ink.font = `600 ${size}px system-ui, sans-serif`;
    ink.textAlign = 'center';
    ink.textBaseline = 'middle';
    ink.lineJoin = 'round';
    ink.lineWidth = 3.5;
    ink.strokeStyle = halo;
    ink.strokeText(text, x, y);
    ink.fillStyle = style;
    ink.fillText(text, x, y);
  }

  badge(text, place, fill, radius = 9) {
    const [x, y] = this.toScreen(...place);
    const ink = this.ink;
    ink.beginPath();
    ink.arc(x, y, radius, 0, 7);
    ink.fillStyle = fill;
    ink.fill();
    ink.lineWidth = 1.8;
    ink.strokeStyle = '#ffffff';
    ink.stroke();
    ink.font = `700 ${radius + 2}px system-ui, sans-serif`;
    ink.textAlign = 'center';
    ink.textBaseline = 'middle';
    ink.fillStyle = '#ffffff';
    ink.fillText(text, x, y + 0.5);
  }

  /** Arrow heads along a line, one each `step` pixels; `start` pixels are already walked. */
  arrows(line, style, step, start) {
    let walked = start;
    let [px, py] = this.toScreen(line[0], line[1]);
    for (let i = 2; i < line.length; i += 2) {
      const [x, y] = this.toScreen(line[i], line[i + 1]);
      const length = Math.hypot(x - px, y - py);
      for (let at = step - walked % step; length > 3 && at <= length && at <= 60 * step; at += step) {
        const t = at / length;
        this.arrow(px + t * (x - px), py + t * (y - py), (x - px) / length, (y - py) / length, style);
      }
      walked = (walked + length) % step;
      [px, py] = [x, y];
    }
    return walked;
  }

  arrow(x, y, dx, dy, style) {
    if (x < -9 || y < -9 || x > this.width + 9 || y > this.height + 9) return;
    const ink = this.ink;
    ink.beginPath();
    ink.moveTo(x + 5 * dx, y + 5 * dy);
    ink.lineTo(x - 4 * dx + 4 * dy, y - 4 * dy - 4 * dx);
    ink.lineTo(x - 4 * dx - 4 * dy, y - 4 * dy + 4 * dx);
    ink.closePath();
    ink.fillStyle = style;
    ink.strokeStyle = '#ffffff';
    ink.lineWidth = 1;
    ink.stroke();
    ink.fill();
  }

  scaleBar() {
    const most = 0.28 * this.width / this.scale();
    const power = 10 ** Math.floor(Math.log10(most));
    const length = (most / power >= 5 ? 5 : most / power >= 2 ? 2 : 1) * power;
    const pixels = length * this.scale();
    const x = 12, y = this.height - 8;
    // Close up, the map lies under the scale bar. A plate behind it keeps it easy to read.
    this.ink.fillStyle = 'rgba(255,255,255,0.75)';
    this.ink.fillRect(x - 6, y - FOOT + 6, pixels + 12, FOOT);
    const bar = () => {
      this.ink.beginPath();
      this.ink.moveTo(x, y - 5); this.ink.lineTo(x, y);
      this.ink.lineTo(x + pixels, y); this.ink.lineTo(x + pixels, y - 5);
      this.ink.stroke();
    };
    this.ink.lineJoin = this.ink.lineCap = 'round';
    this.ink.strokeStyle = 'rgba(255,255,255,0.9)'; this.ink.lineWidth = 5; bar();
    this.ink.strokeStyle = '#10202c'; this.ink.lineWidth = 2; bar();
    const text = length >= 1000 ? length / 1000 + ' km' : +length.toPrecision(3) + ' m';
    this.label(text, x + pixels / 2, y - 11);
  }
}
