// A velocity, acceleration or force plan, or Zhukovsky's lever, as far as it is drawn.
import { born } from "./frames.js";
import { distance, union } from "./geometry.js";
import { Lensed } from "./lens.js";
import { live, state } from "./page.js";
import { circle, end } from "./svg.js";

const SAME_PX = 2;

export class Plan extends Lensed {
  drawn = /** @type {Shown[]} */ ([]);
  sides = /** @type {Shown[]} */ ([]); // of a polygon of forces, as laid
  /** @type {(key: string) => Box} */
  frame(key) { // the plan in its given position fills the panel; the view follows a growing one, up to three times
    const marks = this.own(key), now = this.box(marks), own = this.box(marks, n => live.home(n)) || now || [0, 0, 1, 1];
    if (!now || live.at_home) return own;
    const far = 3 * Math.max(own[2] - own[0], own[3] - own[1], 10), mx = (own[0] + own[2]) / 2;
    const my = (own[1] + own[3]) / 2;
    const held = [Math.max(now[0], mx - far), Math.max(now[1], my - far), Math.min(now[2], mx + far),
      Math.min(now[3], my + far)];
    return Math.hypot(now[2] - now[0], now[3] - now[1]) < 0.2 * far ? own : union(own, held);
  }
  /** @type {(key: string, seen: Set<string>, frame: any, hidden?: boolean) => void} */
  show(key, seen, frame, hidden) {
    const lit = new Set(frame ? frame.terms : []), force = !["velocity", "acceleration", "lever"].includes(key);
    const lever = key === "lever";
    this.more = lever || hidden ? (this.size ? 14 : 44) : 0;
    this.start(this.frame(key));
    /** @type {(n: string) => any} */
    const there = n => seen.has(n) && this.spot(n);
    const made = frame && !hidden ? frame.makes.filter((/** @type {string} */ m) => m.startsWith(key + ":")) : [];
    for (const m of made) this.trace(this.data.traces[m], m);
    this.sides = [];
    this.drawn = [];
    const upto = frame ? this.data.frames.indexOf(frame) - (hidden ? 1 : 0) : this.data.frames.length;
    const begun = (/** @type {Segment} */ s) => s.plan === key &&
      (!force || s.names.some((/** @type {string} */ n) => born(n, key) <= upto));
    const begunOnes = this.data.segments.filter(begun);
    for (const s of begunOnes) if (!s.sum) this.segment(s, there, lit, force);
    const numbers = this.numbered();
    for (const s of begunOnes) if (s.sum) this.segment(s, there, lit, force);
    const drawn = this.data.scheme.drawn, lettered = drawn && drawn.members.length && key === "cremona";
    if (drawn) this.strokesOf(drawn, key, there);
    if (lever) this.lever(there);
    const pole = there(`${key}:p`);
    if (pole) circle(pole, 3, "pole", this.node);
    for (const m of frame && !hidden ? frame.makes : []) {
      if (m.startsWith(key + ":") && there(m)) circle(there(m), 5.5, "fresh", this.node);
    }
    if (lever && frame && frame.moments !== null) this.forces(this.data.moments[frame.moments], frame.terms);
    if (pole && !lettered && !this.data.moves && !key.startsWith("force") && force) this.beside(pole, ["p"], key);
    if (!lettered) numbers.forEach((q, k) => this.beside(q, [String(k + 1)], key, 5, ""));
    const number = (/** @type {Spot} */ q) => 1 + numbers.findIndex(o => distance(o, q) < SAME_PX);
    for (const { a, b, names } of this.sides) if (!lettered || !drawn.members.includes(names[0]))
      this.along(a, b, names, key, number(a) && number(b) && !lettered ? `(${number(a)}–${number(b)})` : "");
    if (!force || lettered) for (const g of this.groups(this.own(key).filter(n => seen.has(n)), 5)) this.beside(g.q,
      this.fixed(g.names, key), key);
    this.settle();
    if (!hidden && !state.spin) this.lenses(key, this.drawn);
    end();
  }
  /** @type {(names: string[], key: string) => string[]} */
  fixed(names, key) { // fixed points of the scheme end at the pole
    return names.includes("p") ? [...names, ...this.data.plans.find(p => p.key === key).fixed] : names;
  }
  /** @type {(s: Segment, there: There, lit: Set<string>, force: boolean) => void} */
  segment({ plan, start, end, names, pen, sum }, there, lit, force) {
    let a = there(`${plan}:${start}`), b = there(`${plan}:${end}`);
    if (!a || !b) return;
    const kind = pen + (names.some(n => lit.has(n)) ? " lit" : "");
    this.drawn.push({ a, b, kind, names });
    if (sum) [a, b] = this.aside(a, b); // the others are in the polygon, head to tail
    this.arrow(a, b, kind, names.join(" "));
    if (force && distance(a, b) > 1) this.sides.push({ a, b, kind, names });
  }
  /** @type {() => Spot[]} */
  numbered() { // the ends of overlapping forces, along the polygon
    const lying = this.sides.filter(p => this.sides.some(o => o !== p && upon(p.a, p.b, o)));
    const ends = lying.flatMap(({ a, b }) => [a, b]);
    return ends.filter((q, k) => ends.findIndex(o => distance(o, q) < SAME_PX) === k);
  }
  /** @type {(a: Spot, b: Spot) => Ends} */
  aside(a, b) { // a sum of forces is drawn beside the forces it overlaps, with ticks to its ends
    const n = distance(a, b), x = (b[1] - a[1]) / n, y = (a[0] - b[0]) / n;
    if (n < 1) return [a, b];
    for (const k of [0, 1, -1, 2, -2, 3, -3]) {
      const d = k * (this.size ? 4 : 8), p = [a[0] + x * d, a[1] + y * d], q = [b[0] + x * d, b[1] + y * d];
      if (this.sides.some(o => upon(p, q, o))) continue;
      for (const [from, to] of k ? [[a, p], [b, q]] : []) this.line(from, to, "trace", "", false);
      return [p, q];
    }
    return [a, b];
  }
  /** @type {(there: There) => void} */
  lever(there) {
    const pole = there("lever:p");
    for (const n of this.own("lever")) { const q = there(n);
      if (pole && q && n !== "lever:p") this.line(pole, q, "link"); }
  }
}
/** @type {(p: Spot, q: Spot, side: Shown) => boolean} */
function upon(p, q, { a, b }) { // whether two strokes of one line share more than a few pixels
  const n = distance(a, b), ux = (b[0] - a[0]) / n, uy = (b[1] - a[1]) / n;
  const along = (/** @type {Spot} */ r) => (r[0] - a[0]) * ux + (r[1] - a[1]) * uy;
  const off = (/** @type {Spot} */ r) => Math.abs((r[0] - a[0]) * uy - (r[1] - a[1]) * ux);
  if (Math.max(off(p), off(q)) > 3) return false;
  return Math.min(Math.max(along(p), along(q)), n) - Math.max(Math.min(along(p), along(q)), 0) > 4;
}
