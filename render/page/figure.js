// A panel of ink: maps millimetres of paper to pixels, draws signs, lines and arrows between the marks of the tape.
import { distance, union } from "./geometry.js";
import { Labels } from "./labels.js";
import { labelOf } from "./letters.js";
import { MM, arrow, sign } from "./signs.js";
import { alter, arc, begin, circle, svg } from "./svg.js";

const NARROW = 520, SMALLER = 0.75; // a panel under so many px, and one on paper, has smaller signs

export class Figure extends Labels { // millimetres y up -> pixels y down
  /** @param {any} node @param {any} data @param {number[]} [size] */
  constructor(node, data, size) {
    super(node, size);
    this.data = data;
    this.real = [600, 380];
    this.more = 0; // of its edge, px
    this.fixed_view = /** @type {any} */ (null); // while it is dragged
    this.view = /** @type {any} */ (null);
    this.k = this.dx = this.dy = 0;
  }
  measure() { this.real = [this.node.clientWidth || 600, this.node.clientHeight || 380]; }
  get unit() { return MM * (this.size || this.real[0] < NARROW ? SMALLER : 1); } // px to a mm of signs
  /** @type {(name: string) => Spot} */
  at(name) { return this.data.marks[name] || null; }
  /** @type {(names: Iterable<string>, at?: There) => any} */
  box(names, at = (/** @type {string} */ n) => this.at(n)) {
    const boxes = [...names].map(at).filter(Boolean).map(p => [...p, ...p]);
    return boxes.length ? boxes.reduce((a, b) => union(a, b)) : null;
  }
  /** @type {(box: Box) => void} */
  start(box) {
    begin(this.node);
    this.view = box;
    const [w, h] = this.size || this.real;
    const pad = (this.size ? 26 : w < NARROW ? 30 : 44) + (this.more || 0), bw = Math.max(box[2] - box[0], 1);
    const bh = Math.max(box[3] - box[1], 1);
    this.k = Math.min((w - 2 * pad) / bw, (h - 2 * pad) / bh, 14);
    this.dx = w / 2 - this.k * (box[0] + box[2]) / 2;
    this.dy = h / 2 + this.k * (box[1] + box[3]) / 2;

    if (this.fixed_view) Object.assign(this, { k: this.fixed_view.k, dx: this.fixed_view.dx, dy: this.fixed_view.dy });
    this.w = w; this.h = h; this.strokes = []; this.taken = [];
    alter(this.node, { viewBox: `0 0 ${w} ${h}`, style: `--share: ${this.unit / MM}` });
    this.bar();
  }
  /** @type {(p: Spot) => Spot} */
  px(p) { return [this.dx + this.k * p[0], this.dy - this.k * p[1]]; }
  /** @type {(name: string) => Spot} */
  spot(name) { // the place of a mark, px; null where it is missing
    const p = this.at(name);
    return p && this.px(p);
  }
  /** @type {(q: Spot) => Spot} */
  mm(q) { return [(q[0] - this.dx) / this.k, (this.dy - q[1]) / this.k]; }
  bar() { // the length of ten (or more) millimetres of paper here
    const mm = [5, 10, 20, 50, 100, 200].find(m => m * this.k > 46) || 500, y = this.h - 9, x = 12;
    const far = x + mm * this.k;
    svg("path", { class: "bar", d: `M${x} ${y - 4}v4H${far}v-4` }, this.node);
    svg("text", { class: "bar-text", x: far + 6, y: y + 1 },
      this.node,
      `${mm} ${document.documentElement.lang !== "en" ? "мм" : "mm"}`);
  }
  /** @type {(a: Spot, b: Spot, cls: string, name?: string, solid?: boolean) => any} */
  line(a, b, cls, name, solid = true) { // pixels
    const l = svg("line", { x1: a[0].toFixed(1), y1: a[1].toFixed(1), x2: b[0].toFixed(1), y2: b[1].toFixed(1),
      class: cls, ...(name && { "data-name": name }) }, this.node);
    if (solid) this.strokes.push([a, b]);
    return l;
  }
  /** @type {(a: Spot, b: Spot, cls: string, name?: string) => any} */
  arrow(a, b, cls, name) { // of a dot none
    if (distance(a, b) < 0.7) return null;
    this.strokes.push([a, b]);
    return arrow(this.node, a, b, this.unit, /^part(?! lit)/.test(cls) ? "vector" : "thick",
      { class: `arrow ${cls}`, ...(name && { "data-name": name }) });
  }
  /** @type {(name: string, p: Spot, turn?: number, cls?: string, as?: string) => void} */
  sign(name, p, turn = 0, cls = name, as = "") {
    this.strokes.push(...sign(this.node, name, p, turn, this.unit, { class: cls, ...(as && { "data-name": as }) }));
  }
  /** @type {(q: Spot, name: string, said: string, cls?: string) => any} */
  grip(q, name, said, cls = "") { // of a mark that is moved by hand or by keys
    const how = { class: `handle ${cls}`, tabindex: 0, role: "button", "data-mark": name, "aria-label": said };
    const g = svg("g", how, this.node);
    circle(q, 15, "grip", g);
    return g;
  }
  /** @type {(marks: string[], reach: number) => { q: Spot, names: string[] }[]} */
  groups(marks, reach) { // coinciding marks share a label
    const found = /** @type {any[]} */ ([]);
    for (const full of marks) {
      const p = this.at(full), name = labelOf(full);
      if (!p || this.data.helpers.includes(full)) continue;
      const q = this.px(p), g = found.find(g => distance(q, g.q) < reach);
      if (g) g.names.push(name); else found.push({ q, names: [name] });
    }
    return found;
  }
  // the other crossing of two arcs, or of an arc and a line: the mark mirrored in the common axis of symmetry
  /** @type {(t: Trace, c: Spot) => void} */
  ghost(t, c) {
    const [o, b] = [...(t.arcs || []), ...(t.lines || [])].map(n => this.at(n)), arcs = (t.arcs || []).length;
    if (!arcs || !o || !b) return;
    const [x, y] = arcs > 1 ? [b[0] - o[0], b[1] - o[1]] : [b[1] - c[1], c[0] - b[0]], n = x * x + y * y;
    const off = ((c[0] - o[0]) * y - (c[1] - o[1]) * x) / n;
    if (n < 1e-6 || Math.abs(off) * Math.sqrt(n) * this.k < 6) return;
    circle(this.px([c[0] - 2 * off * y, c[1] + 2 * off * x]), 5, "trace", this.node);
  }
  /** @type {(t: Trace, made: string) => void} */
  trace(t, made) { // the lines or arcs that cross at a mark, slightly beyond it
    const c = this.at(made);
    if (!t || !c) return;
    this.ghost(t, c);
    const q = this.px(c);
    const spots = (/** @type {string[] | undefined} */ names) => (names ?? []).map(n => this.spot(n)).filter(Boolean);
    for (const p of spots(t.lines)) {
      const far = 26 / distance(p, q), dx = (q[0] - p[0]) * far, dy = (q[1] - p[1]) * far;
      if (far < 52) this.line([p[0] - dx, p[1] - dy], [q[0] + dx, q[1] + dy], "trace", "", false);
    }
    for (const p of spots(t.arcs)) {
      const r = distance(p, q), a = Math.atan2(q[1] - p[1], q[0] - p[0]), w = Math.min(0.6, 60 / Math.max(r, 1));
      arc(p, r, a - w, a + w, { class: "trace" }, this.node);
      this.line(p, q, "trace faint", "", false);
    }
  }
}
