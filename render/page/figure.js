// A panel of ink: maps millimetres of paper to pixels, draws lines and arrows between the marks of the tape, places
// labels.
import { distance, gap, union } from "./geometry.js";
import { labelOf, lettered } from "./letters.js";
import { alter, begin, svg } from "./svg.js";

// cost of overlapping labels: more than any number of strokes
const UPON = 40, ROUNDS = 4;
// and what one nearer to another vector than to its own, which it would name: as much as several strokes through it
const STRANGE = 8;

const ruler = /** @type {any} */ (document.createElement("canvas").getContext("2d")), widths = new Map();
/** @type {(names: string[], plan: string, size: number) => number} */
function wide(names, plan, size) { // the width of a label, px
  const key = `${document.documentElement.lang} ${plan} ${size} ${names.join(" ")}`;
  if (!widths.has(key)) {
    /** @type {(text: string, small?: string) => number} */
    const one = (text, small) => {
      ruler.font = `italic ${small ? 0.7 * size : size}px "DejaVu Serif", Georgia, serif`;
      return ruler.measureText(text).width;
    };
    const all = names.map(n => lettered(n, plan).reduce((s, [text, kind]) => s + one(text, kind), 0));
    widths.set(key, all.reduce((w, own, i) => w + (i ? one(" = ") : 0) + own, 0));
  }
  return widths.get(key);
}
/** @type {(parent: Element, names: string[], x: any, y: any, size: number, plan: string, joint?: string,
 * as?: string) => any} */
export function letters(parent, names, x, y, size, plan, joint = ", ", as = names.join(" ")) {
  const t = svg("text", { x, y, "font-size": size, class: "label", "text-anchor": "middle", "data-name": as }, parent);
  let back = 0;
  /** @type {(text: string, shift: number, small?: string) => void} */
  const put = (text, shift, small) => {
    svg("tspan", { dy: (shift - back).toFixed(2), ...(small ? { "font-size": (size * 0.7).toFixed(1) } : {}) },
      t, text);
    back = shift;
  };
  names.forEach((name, i) => {
    if (i) put(name[0] === "(" ? " " : joint, 0);
    for (const [text, kind] of lettered(name, plan)) put(text,
      kind === "sub" ? 0.3 * size : kind === "sup" ? -0.42 * size : 0, kind);
  });
  return t;
}
/** @type {(a: any, b: any, size: number) => boolean} */
function crowds(a, b, size) { // whether labels overlap, [x, y, half the width]
  return a[2] + b[2] + 3 > Math.abs(a[0] - b[0]) && size * 1.32 > Math.abs(a[1] - b[1]);
}

export class Figure { // millimetres y up -> pixels y down
  /** @param {any} node @param {any} data @param {number[]} [size] */
  constructor(node, data, size) {
    this.node = node;
    this.data = data;
    this.size = size;
    this.real = [600, 380];
    this.kept = /** @type {Map<string, number>} */ (new Map());
    this.more = 0; // of its edge, px
    this.fixed_view = /** @type {any} */ (null); // while it is dragged
    this.strokes = /** @type {Ends[]} */ ([]);
    this.taken = /** @type {any[]} */ ([]);
    this.view = /** @type {any} */ (null);
    this.k = this.dx = this.dy = this.w = this.h = 0;
  }
  measure() { this.real = [this.node.clientWidth || 600, this.node.clientHeight || 380]; }
  get letter() { return this.size ? 13 : 17; }
  /** @type {(name: string) => Spot} */
  at(name) { return this.data.marks[name] || null; }
  /** @type {(names: Iterable<string>, at?: There) => any} */
  box(names, at = (/** @type {string} */ n) => this.at(n)) {
    let b = null;
    for (const n of names) {
      const p = at(n);
      if (p) b = b ? union(b, [...p, ...p]) : [...p, ...p];
    }
    return b;
  }
  /** @type {(box: Box) => void} */
  start(box) {
    begin(this.node);
    this.view = box;
    const [w, h] = this.size || this.real;
    const pad = (this.size ? 26 : w < 520 ? 30 : 44) + (this.more || 0), bw = Math.max(box[2] - box[0], 1);
    const bh = Math.max(box[3] - box[1], 1);
    this.k = Math.min((w - 2 * pad) / bw, (h - 2 * pad) / bh, 14);
    this.dx = w / 2 - this.k * (box[0] + box[2]) / 2;
    this.dy = h / 2 + this.k * (box[1] + box[3]) / 2;

    if (this.fixed_view) Object.assign(this, { k: this.fixed_view.k, dx: this.fixed_view.dx, dy: this.fixed_view.dy });
    this.w = w; this.h = h; this.strokes = []; this.taken = [];
    alter(this.node, { viewBox: `0 0 ${w} ${h}` });
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
  arrow(a, b, cls, name) { // heads of one size; of a tiny vector a smaller one; of a dot none
    const dx = b[0] - a[0], dy = b[1] - a[1], n = Math.hypot(dx, dy);
    if (n < 0.7) return null;
    const g = svg("g", { class: "arrow " + cls, ...(name && { "data-name": name }) }, this.node);
    const h = n < 3 ? 0 : Math.min(this.size ? 9 : 12, n * 0.6), w = h * 0.26, ux = dx / n, uy = dy / n;
    const f = (/** @type {number} */ v) => v.toFixed(1), c = [b[0] - ux * h, b[1] - uy * h];
    svg("line", { x1: f(a[0]), y1: f(a[1]), x2: f(c[0] + ux), y2: f(c[1] + uy) }, g);
    if (h) svg("polygon", { points: `${f(b[0])},${f(b[1])} ${f(c[0] - uy * w)},${f(c[1] + ux * w)} ${f(c[0] + uy *
      w)},${f(c[1] - ux * w)}` }, g);
    this.strokes.push([a, b]);
    return g;
  }
  /** @type {(names: string[], spots: Places, plan: string, joint?: string, as?: string, of?: Ends) => any} */
  put(names, spots, plan, joint, as, of) { // a label at the best of some places: clear of strokes and of other labels
    const size = this.letter, half = wide(names, plan, size) / 2;
    const label = /** @type {Label} */ ({ names, half, size, all: spots(half, size * 0.5), key: names.join(" "), of });
    const [x, y] = this.best(label);
    label.node = letters(this.node, names, x.toFixed(1), (y + size * 0.34).toFixed(1), size, plan, joint, as);
    this.taken.push([x, y, half, label]);
    return label.node;
  }
  /** @type {(label: Label) => number[]} */
  best(label) { // its last place, unless another is clearly better: a label should not jump
    const { all, key } = label, kept = this.kept.get(key);
    let best = /** @type {number[]} */ (/** @type {any} */ (null));
    for (let k = -1; k < all.length; k++) {
      const n = k < 0 ? kept : k;
      if (n === undefined || n >= all.length || (k >= 0 && n === kept)) continue;
      const own = all[n][2] - (k < 0 ? 0.6 : 0);
      if (best && own >= best[0]) continue;
      const cost = this.price(label, all[n], own, best ? best[0] : Infinity);
      if (!best || cost < best[0]) best = [cost, n];
      if (k < 0 && cost <= 0) break;
    }
    this.kept.set(key, best[1]);
    return all[best[1]];
  }
  // the cost of a place: strokes, other labels, the edge of the figure; up to a limit
  /** @type {(label: Label, place: number[], own: number, most: number) => number} */
  price({ half, size, of }, [x, y], own, most) {
    const tall = size * 0.5, parts = Math.max(2, Math.ceil(1.6 * half / size)); // nothing crosses it between two places
    let cost = own;
    const far = of ? gap([x, y], of) - 1 : 0;
    if (of && this.strokes.some(s => gap([x, y], s) < far)) cost += STRANGE;
    for (const t of this.taken) if (crowds([x, y, half], t, size)) cost += UPON;
    for (const s of this.strokes) {
      if (cost >= most) return cost;
      for (let k = 0; k <= parts; k++) {
        const d = gap([x + (1.6 * k / parts - 0.8) * half, y], s);
        if (d < tall + 3) cost += (tall + 3 - d) / tall;
      }
    }
    const over = Math.max(half - x, x + half - this.w, tall - y, y + tall - this.h); // a clipped label is unreadable
    return over > 0 ? cost + 2 * UPON : over > -2 ? cost + 6 : cost;
  }
  settle() { // overlapping labels are placed again, now that all are known
    for (let round = 0; round < ROUNDS; round++) {
      const crowded = this.taken.filter(t => t[3] && this.taken.some(o => o !== t && crowds(t, o, t[3].size)));
      for (const t of crowded) {
        this.taken.splice(this.taken.indexOf(t), 1);
        const { node, size, half } = t[3], [x, y] = this.best(t[3]);
        alter(node, { x: x.toFixed(1), y: (y + size * 0.34).toFixed(1) });
        this.taken.push([x, y, half, t[3]]);
      }
      if (!crowded.length) return;
    }
  }
  /** @type {(p: Spot, half: number, tall: number) => number[][]} */
  around([x, y], half, tall) { // places of a label about a point
    return [0, 7, 15, 26, 40, 58].flatMap(far => [...Array(16).keys()].map(k => {
      const c = Math.cos(k * Math.PI / 8), s = Math.sin(k * Math.PI / 8);
      return [x + c * (half + far), y + s * (tall + far), far * 0.06 + (k % 4 ? 0.05 : 0)];
    }));
  }
  /** @type {(p: Spot, names: string[], plan: string, clear?: number, as?: string) => any} */
  beside(p, names, plan, clear = 5, as = names.join(" ")) { // around a mark
    return this.put(names, (half, tall) => this.around(p, half + clear, tall + clear), plan, undefined, as);
  }
  /** @type {(a: Spot, b: Spot, names: string[], plan: string, ends?: string) => any} */
  along(a, b, names, plan, ends) { // beside a vector; after its names, its ends
    const n = distance(a, b) || 1, ux = (b[0] - a[0]) / n, uy = (b[1] - a[1]) / n;
    return this.put(ends ? [...names, ends] : names, (half, tall) => {
      const found = [], off = Math.abs(uy) * half + Math.abs(ux) * tall + 5;
      for (const t of [0.5, 0.35, 0.65, 0.2, 0.8, 0.95, 0.08]) for (const side of [1, -1]) for (const far of [0, 10, 22,
        36, 54, 74, 96]) {
        found.push([a[0] + t * n * ux - side * uy * (off + far), a[1] + t * n * uy + side * ux * (off + far),
          far * 0.05 + Math.abs(t - 0.5)]);
      }
      const short = n < 2 * half + 10; // it has more room about it than beside it
      return short ? [...found, ...this.around([(a[0] + b[0]) / 2, (a[1] + b[1]) / 2], half + 5, tall + 5)] : found;
    }, plan, " = ", names.join(" "), [a, b]);
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
    const [u, v] = this.px([c[0] - 2 * off * y, c[1] + 2 * off * x]);
    svg("circle", { cx: u.toFixed(1), cy: v.toFixed(1), r: 5, class: "trace" }, this.node);
  }
  /** @type {(t: Trace, made: string) => void} */
  trace(t, made) { // the lines or arcs that cross at a mark, slightly beyond it
    const c = this.at(made);
    if (!t || !c) return;
    this.ghost(t, c);
    const q = this.px(c);
    for (const n of t.lines || []) {
      const p = this.spot(n);
      if (!p) continue;
      const dx = q[0] - p[0], dy = q[1] - p[1], d = Math.hypot(dx, dy);
      if (d < 0.5) continue;
      const far = 26 / d;
      this.line([p[0] - dx * far, p[1] - dy * far], [q[0] + dx * far, q[1] + dy * far], "trace", "", false);
    }
    for (const n of t.arcs || []) {
      const p = this.spot(n);
      if (!p) continue;
      const r = distance(p, q), a = Math.atan2(q[1] - p[1], q[0] - p[0]), w = Math.min(0.6, 60 / Math.max(r, 1));
      const end = (/** @type {number} */ s) =>
        `${(p[0] + r * Math.cos(a + s)).toFixed(1)} ${(p[1] + r * Math.sin(a + s)).toFixed(1)}`;
      svg("path", { class: "trace", d: `M${end(-w)}A${r.toFixed(1)} ${r.toFixed(1)} 0 0 1 ${end(w)}` }, this.node);
      this.line(p, q, "trace faint", "", false);
    }
  }
}
