// Details under two millimetres of paper, drawn again, larger, in a circle where there is room for it.
import { Drawing } from "./drawing.js";
import { distance, gap, union } from "./geometry.js";
import { circle, svg } from "./svg.js";

const SMALL_MM = 2, SEEN_MM = 0.02, TOGETHER_MM = 3, LENSES = 2, TIMES = [2, 5, 10, 20, 50];
let lenses = 0;

export class Lensed extends Drawing {
  /** @type {(key: string, shown: Shown[]) => void} */
  lenses(key, shown) { // shown: segments by their ends, px, with their names
    const far = (/** @type {Shown} */ s) => distance(s.a, s.b) / this.k;
    const found = /** @type {{ m: Spot, own: Shown[] }[]} */ ([]);
    for (const s of shown.filter(s => far(s) < SMALL_MM && far(s) > SEEN_MM)) {
      const m = [(s.a[0] + s.b[0]) / 2, (s.a[1] + s.b[1]) / 2];
      const g = found.find(g => distance(m, g.m) < TOGETHER_MM * this.k);
      if (g) g.own.push(s); else found.push({ m, own: [s] });
    }
    for (const g of found.slice(0, LENSES)) {
      const r = this.size ? 26 : Math.min(58, 0.15 * Math.min(this.w, this.h) + 8);
      const ends = g.own.flatMap(s => [s.a, s.b]);
      const b = ends.reduce((b, p) => union(b, [...p, ...p]), [...ends[0], ...ends[0]]);
      const m = [(b[0] + b[2]) / 2, (b[1] + b[3]) / 2], most = 1.1 * r / Math.max(b[2] - b[0], b[3] - b[1], 0.1);
      const times = TIMES.filter(t => t <= most).pop(), c = times && this.room(r, m);
      if (c) this.lens(g, m, c, r, times, shown, key);
    }
    this.settle();
  }
  /** @type {(r: number, m: Spot) => any} */
  room(r, m) { // the emptiest place for a circle, as near as possible; null where there is none
    let best = /** @type {any} */ (null);
    for (let x = r + 6; x <= this.w - r - 6; x += 14) for (let y = r + 24; y <= this.h - r - 22; y += 14) {
      const near = Math.hypot(x - m[0], y - m[1]);
      if (near < r + 12 || (best && near >= best[0])) continue;
      const far = (/** @type {number[]} */ t) =>
        Math.hypot(Math.max(Math.abs(x - t[0]) - t[2], 0), Math.max(Math.abs(y - t[1]) - 9, 0)) > r + 2;
      const free = this.strokes.every(s => gap([x, y], s) > r + 3) && this.taken.every(far);
      if (free) best = [near, x, y];
    }
    return best && best.slice(1);
  }
  /** @type {(group: { own: Shown[] }, m: Spot, c: Spot, r: number, times: number, shown: Shown[],
   * key: string) => void} */
  lens(group, m, c, r, times, shown, key) {
    const id = `lens-${lenses++}`, whole = this.node, { strokes } = this;
    const at = (/** @type {Spot} */ p) => [c[0] + times * (p[0] - m[0]), c[1] + times * (p[1] - m[1])];
    const own = r / times, d = distance(m, c), u = [(c[0] - m[0]) / d, (c[1] - m[1]) / d];
    const f = (/** @type {number} */ v) => v.toFixed(1);
    svg("path", { class: "lens-line",
      d: `M${f(m[0] + own * u[0])} ${f(m[1] + own * u[1])}L${f(c[0] - r * u[0])} ${f(c[1] - r * u[1])}` }, whole);
    circle(m, own, "lens-line", whole);
    circle(c, r, "", svg("clipPath", { id }, whole));
    circle(c, r, "lens", whole);
    this.node = svg("g", { "clip-path": `url(#${id})` }, whole);
    this.strokes = [];
    for (const s of shown) if (gap(m, [s.a, s.b]) < own) this.arrow(at(s.a), at(s.b), s.kind, s.names.join(" "));
    this.node = whole;
    const inner = this.strokes.map(s => inside(s, c, r));
    this.strokes = [...strokes, ...inner];
    for (const s of group.own) this.along(at(s.a), at(s.b), s.names, key);
    this.strokes = [...strokes, ...inner, [[c[0] - r, c[1]], [c[0] + r, c[1]]], [[c[0], c[1] - r], [c[0], c[1] + r]]];
    svg("text", { class: "bar-text", x: f(c[0]), y: f(c[1] + r + 11), "text-anchor": "middle" },
      whole, `${times}:1`);
    this.taken.push([c[0], c[1] + r + 8, 14]);
  }
}
/** @type {(stroke: Ends, c: Spot, r: number) => Ends} */
function inside([a, b], c, r) { // the part of a stroke within a circle
  const d = [b[0] - a[0], b[1] - a[1]], e = [a[0] - c[0], a[1] - c[1]], n = d[0] * d[0] + d[1] * d[1] || 1;
  const q = (d[0] * e[0] + d[1] * e[1]) / n;
  const root = Math.sqrt(Math.max(q * q - (e[0] * e[0] + e[1] * e[1] - r * r) / n, 0));
  return [Math.max(0, -q - root), Math.min(1, -q + root)].map(t => [a[0] + t * d[0], a[1] + t * d[1]]);
}
