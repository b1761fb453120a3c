// A draughtsman's tools at work: set square, compass, dividers, protractor; each carried to its place, then drawn with.
import { plan, scheme } from "./figures.js";
import { distance } from "./geometry.js";
import { labelOf } from "./letters.js";
import { data, live } from "./page.js";
import { arc, circle, svg } from "./svg.js";

export const ACT_MS = 600;
const CARRIED_MS = 360, AIR = 14;

export const kit = {
  panels: document.querySelector(".panels"),
    over: svg("svg", { id: "kit", "aria-hidden": "true" }, document.querySelector(".panels")), from: 0, next: 0,
    frame: /** @type {Frame} */ (/** @type {any} */ (null)), moved: /** @type {any} */ (null),
  /** @type {(mark: string) => any} */
  figure(mark) { return mark.startsWith("position:") ? scheme : plan; },
  /** @type {(mark: string) => Spot} */
  spot(mark) { // the place of a mark among the panels, px
    const p = live.at(mark), f = this.figure(mark);
    return p && this.among(f, f.px(p));
  },
  /** @type {(f: any, place: number[]) => number[]} */
  among(f, [x, y]) {
    const r = f.node.getBoundingClientRect(), o = this.over.getBoundingClientRect();
    return [x + r.left - o.left, y + r.top - o.top];
  },
  /** @type {(f: any) => Box} */
  box(f) { const [x, y] = this.among(f, [0, 0]); return [x, y, x + f.w, y + f.h]; },
  /** @type {() => any[]} */
  acts() { // those with distinct marks
    return this.frame.tools.map(t => KITS[t.tool](t)).filter(Boolean);
  },
  /** @type {(frame: any, moving: boolean) => void} */
  show(frame, moving) { // the tools of a frame: in motion, or as they were left
    this.frame = frame;
    if (moving && frame.tools.length && !matchMedia("(prefers-reduced-motion: reduce)").matches) {
      this.from = performance.now();
      this.await(new Set([...frame.makes.map(labelOf), ...frame.terms]));
      if (!this.next) this.next = requestAnimationFrame(() => this.move());
    } else if (!moving && this.next && frame === this.moved) return;
    else this.rest();
    this.moved = frame;
  },
  /** @type {(names: Set<string>) => void} */
  await(names) { // letters of the new marks, shown when these are drawn
    for (const f of [scheme, plan]) for (const [, , , label] of f.taken || [])
      label?.node?.classList.toggle("awaited", label.names.some((/** @type {string} */ n) => names.has(n)));
  },
  move() {
    const acts = this.acts(), past = performance.now() - this.from, k = Math.floor(past / ACT_MS);
    const ease = (/** @type {number} */ s) => s * s * (3 - 2 * s);
    if (k >= acts.length) { this.rest(); return; }
    this.panels.classList.toggle("moving", this.frame.makes.length > 0); // marks from before a measurement stay
    this.over.textContent = "";
    acts.slice(0, k).forEach(a => this.pose(a, 1, 1, false));
    const t = past - k * ACT_MS;
    this.pose(acts[k], ease(Math.min(1, t / CARRIED_MS)), Math.max(0, (t - CARRIED_MS) / (ACT_MS - CARRIED_MS)));
    this.next = requestAnimationFrame(() => this.move());
  },
  rest() { // the last tool at its last place
    if (this.next) cancelAnimationFrame(this.next);
    this.next = 0;
    this.panels.classList.remove("moving");
    if (this.over.firstChild) this.over.textContent = "";
    const acts = this.frame ? this.acts() : [];
    if (acts.length) this.pose(acts[acts.length - 1], 1, 1);
  },
  /** @type {(act: Act, carried: number, drawn: number, held?: boolean) => void} */
  pose(act, carried, drawn, held = true) {
    if (held) act.show(carried, this.over);
    if (drawn && act.line && this.next) act.line(drawn, this.over);
  },
};
/** @type {(points: any[][], cls: string, shut: boolean, parent: Element) => any} */
const path = (points, cls, shut, parent) => svg("path",
  { class: cls, d: "M" + points.map(p => p.map(v => v.toFixed(1)).join(" ")).join("L") + (shut ? "Z" : "") }, parent);
/** @type {(a: Spot, b: Spot, t: number) => Spot} */
const mixed = (a, b, t) => a.map((v, k) => v + (b[k] - v) * t);
/** @type {(a: Spot, b: Spot) => (share: number, over: Element) => void} */
const ruled = (a, b) => (share, over) => path([a, mixed(a, b, share)], "pencil-line", false, over);
/** @type {(t: Tool) => any} */
function apart(t) { // the ends of the new segment, its direction and length; null where there is none
  const [a, b] = t.to.map(m => kit.spot(m));
  if (!a || !b) return null;
  const n = distance(a, b);
  return n < 1.5 ? null : { a, b, n, u: [(b[0] - a[0]) / n, (b[1] - a[1]) / n] };
}
/** @type {(t: Tool) => any} */
function laidTo(t) { // where a set square slides from: a place of a link or of a guide, and its direction
  if (t.guide) {
    const l = data.scheme.links.find(l => l.slides === t.guide), g = data.scheme.guides.find(g => g.name === t.guide);
    const p = kit.spot(l ? l.points[0] : g.mark), w = live.angle("∥" + t.guide) * Math.PI / 180;
    return p && { m: p, u: [Math.cos(w), -Math.sin(w)] };
  }
  const [a, b] = (t.from || []).map(m => kit.spot(m)), n = a && b ? distance(a, b) : 0;
  return n > 1.5 ? { m: mixed(a, b, 0.5), u: [(b[0] - a[0]) / n, (b[1] - a[1]) / n] } : null;
}
/** @type {Record<string, (t: Tool) => Act | null>} */
export const KITS = {
  /** @type {(t: Tool) => Act | null} */
  square(t) { // one edge to the link, slid without turning until an edge goes through the start of the line
    const w = apart(t);
    if (!w) return null;
    const f = kit.figure(t.to[1]), box = kit.box(f), long = Math.max(96, Math.min(w.n + 44, 0.62 * f.w));
    const wide = 0.58 * long, base = laidTo(t);
    const middle = [(box[0] + box[2]) / 2, (box[1] + box[3]) / 2], back = Math.min(16, (long - 30) / 3);
    const corner = [w.a[0] - back * w.u[0], w.a[1] - back * w.u[1]];
    const side = [1, -1].map(s => [s,
      Math.hypot(corner[0] + long / 3 * w.u[0] - s * wide / 3 * w.u[1] - middle[0],
      corner[1] + long / 3 * w.u[1] + s * wide / 3 * w.u[0] - middle[1])]).sort((a, b) => b[1] - a[1])[0][0];
    const v = [-side * w.u[1], side * w.u[0]];
    const across = base && Math.abs(base.u[0] * w.u[0] + base.u[1] * w.u[1]) < 0.02;
    const along = base && Math.abs(base.u[0] * w.u[1] - base.u[1] * w.u[0]) < 0.02;
    const first = along ? mixed(base.m, [base.m[0] + w.u[0], base.m[1] + w.u[1]], -long / 2) : across ?
      mixed(base.m, [base.m[0] + v[0], base.m[1] + v[1]], -wide / 2) : [corner[0] + 70 * v[0], corner[1] + 70 * v[1]];
    const over = Math.min(AIR, w.n), end = [w.b[0] + over * w.u[0], w.b[1] + over * w.u[1]];
    return {
      tool: "square", first, corner, u: w.u, v, long, wide,
      show(s, parent) {
        const c = mixed(first, corner, s);
        const p = (/** @type {number} */ x, /** @type {number} */ y) => [c[0] + x * w.u[0] + y * v[0],
          c[1] + x * w.u[1] + y * v[1]];
        const in_ = 0.2 * wide;
        const window_ = [p(in_, in_), p(long - 2.9 * in_, in_), p(in_, wide - 1.7 * in_)];
        svg("path", { class: "tool", "fill-rule": "evenodd",
          d: [[p(0, 0), p(long, 0), p(0, wide)],
          window_].map(q => "M" + q.map(r => r.map(x => x.toFixed(1)).join(" ")).join("L") + "Z").join("") }, parent);
      },
      line: ruled(w.a, end),
    };
  },
  /** @type {(t: Tool) => Act | null} */
  compass(t) { // opened to the radius, then an arc about its needle
    const w = apart(t);
    return w && { tool: "compass", at: w.a, end: w.b, ...legs(w, s => [w.a, mixed(w.a, w.b, 0.12 + 0.88 * s)]),
      line(share, over) {
        const a = Math.atan2(w.u[1], w.u[0]), half = Math.min(0.5, 70 / w.n);
        arc(w.a, w.n, a - half, a - half + 2 * half * share, { class: "pencil-line" }, over);
      } };
  },
  /** @type {(t: Tool) => any} */
  dividers(t) { // a segment taken with two needles, and set down in its place; from a scale, or to it
    const [from, to] = [t.from, t.to].map(ms => ms.map(m => kit.spot(m)));
    if ([...from, ...to].some(p => !p)) return null;
    const f = kit.figure((t.to[1] || t.from[1] || t.to[0]));
    const k = t.from[0] && t.to[0] ? f.k / kit.figure(t.from[0]).k : 1;
    const seg = from.length ? from : to, d = [seg[1][0] - seg[0][0], seg[1][1] - seg[0][1]], n = Math.hypot(...d);
    if (n < 1.5) return null;
    const zero = kit.among(f, [12, f.h - 9]), scale_ = [zero, [zero[0] + n, zero[1]]];
    const shown = to.length === 1 ? Math.min(64, Math.max(26, n * k)) / n : 1;
    const goal = to.length === 2 ? to : to.length ? [to[0], [to[0][0] + d[0] * shown, to[0][1] + d[1] * shown]] :
      scale_, first = from.length ? from : scale_;
    return { tool: "dividers", first, goal,
      ...legs({ n: distance(goal[0], goal[1]) }, s => [mixed(first[0], goal[0], s), mixed(first[1], goal[1], s)]) };
  },
  /** @type {(t: Tool) => Act | null} */
  protractor(t) { // its zero along the existing line, an angle set off
    const w = apart(t);
    if (!w) return null;
    const base = laidTo(t), u = base ? base.u : [1, 0], r = Math.min(72, 0.2 * kit.figure(t.to[0]).w);
    const up = u[0] * w.u[1] - u[1] * w.u[0] > 0 ? 1 : -1, v = [-up * u[1], up * u[0]];
    const away = [w.a[0] - 60 * v[0], w.a[1] - 60 * v[1]];
    const at = (/** @type {Spot} */ c, /** @type {number} */ x,
      /** @type {number} */ q) => [c[0] + q * (Math.cos(x) * u[0] + Math.sin(x) * v[0]),
      c[1] + q * (Math.cos(x) * u[1] + Math.sin(x) * v[1])];
    return {
      tool: "protractor", at: w.a, u,
      show(s, parent) {
        const c = mixed(away, w.a, s), rim = Array.from({ length: 37 }, (_, k) => at(c, k * Math.PI / 36, r));
        path(rim, "tool", true, parent);
        for (let k = 1; k < 18; k++) path([at(c, k * Math.PI / 18, r), at(c, k * Math.PI / 18, r - (k % 3 ? 5 : 9))],
          "tool-mark", false, parent);
      },
      line: ruled(w.a, [w.b[0] + AIR * w.u[0], w.b[1] + AIR * w.u[1]]),
    };
  },
};
/** @type {(w: { n: number }, needles: (share: number) => Ends) => { show(s: number, parent: Element): void }} */
function legs(w, needles) { // two legs from a joint above the middle, as a hand holds them
  const leg = Math.max(46, 0.66 * w.n);
  return {
    show(s, parent) {
      const [a, b] = needles(s), x = b[0] - a[0], y = b[1] - a[1], n = Math.hypot(x, y) || 1;
      const high = Math.sqrt(Math.max(leg * leg - n * n / 4, 1)), up = x < 0 ? -1 : 1;
      const top = [(a[0] + b[0]) / 2 + up * y / n * high, (a[1] + b[1]) / 2 - up * x / n * high];
      const dx = top[0] - (a[0] + b[0]) / 2, dy = top[1] - (a[1] + b[1]) / 2;
      path([a, top, b], "tool-leg", false, parent);
      path([top, [top[0] + dx / high * 12, top[1] + dy / high * 12]], "tool-leg", false, parent);
      circle(top, 4, "tool-joint", parent);
      for (const needle of [a, b]) circle(needle, 2, "needle-point", parent);
    },
  };
}
