// The scheme of the mechanism: links, hinges, guides, sliders, and the forces on them.
import { Drawing } from "./drawing.js";
import { born } from "./frames.js";
import { distance, union } from "./geometry.js";
import { labelOf } from "./letters.js";
import { live, state } from "./page.js";
import { end, svg } from "./svg.js";

// additions by other modules: the figure, the frame, the visible marks
export const overlays = /** @type {((figure: Scheme, frame: any, seen: Set<string>) => void)[]} */ ([]);

export class Scheme extends Drawing {
  /** @param {Element} node @param {LessonData} data @param {number[]} [size] */
  constructor(node, data, size) {
    super(node, data, size);
    this.first = /** @type {Numbers} */ ({});
    this.names = Object.keys(data.marks).filter(n => n.startsWith("position:") && n !== "position:p" &&
      !data.helpers.includes(n));
    this.centres = data.scheme.links.flatMap(l => l.round ? [l.round.centre] : []);
    this.special = data.frames ? data.frames.filter(f => f.key === "special").flatMap(f => f.makes) : [];
  }
  /** @type {(key: string, seen: Set<string>, frame: any) => void} */
  show(key, seen, frame) {
    const { scheme } = this.data, common = live.usual, lit = new Set(frame ? [...frame.makes, ...frame.uses] : []);
    const body = frame && ["free_body", "split"].includes(frame.key) ? this.data.bodies[frame.plan] : null;
    const told = frame && frame.moments !== null && frame.plan === "position" ? this.data.moments[frame.moments] : body;
    const feet = told ? told.forces.filter(f => f.foot && frame.terms.includes(f.name)).map(f => f.foot) : [];
    const now = this.box([...this.names.filter(n => seen.has(n)), ...feet]);
    this.start(now ? union(common, now) : common);
    /** @type {(n: string) => any} */
    const there = n => seen.has(n) && this.spot(n);
    for (const g of scheme.guides) this.guide(g, there(g.mark), live.angle("∥" + g.name), there);
    const own = frame ? this.data.plans.find(p => p.key === frame.plan).links : [];
    const apart = (/** @type {Link} */ l) => own.length && !own.includes(l.name);
    for (const l of scheme.links) this.link(l, there, apart(l) ? " away" : "");
    if (scheme.drawn) this.standing(scheme.drawn, there, !own.length && !told);
    for (const l of scheme.links) if (l.slides) this.slider(l, there(l.points[0]), live.angle("∥" + l.slides));
    for (const l of scheme.links) if (l.round) this.rounded(l, there(l.points[0]), there(l.round.centre));
    for (const n of scheme.pivots) { const p = there(n); if (p) this.ground(p); }
    this.hinges(there, lit);
    if (told) this.forces(told, frame.terms);
    const made = frame && frame.chapter !== "centres" ? frame.makes : [];
    for (const m of made) if (m.startsWith("position:")) this.trace(this.data.traces[m], m);
    if (frame && frame.turns) this.carried(frame);
    if (own.length) this.loaded(frame);
    const joints = [...new Set([...scheme.links.flatMap(l => l.points), ...scheme.pivots, ...this.centres])];
    for (const n of this.special) if (there(n)) this.beside(there(n), [labelOf(n)], "position", 9, n);
    for (const g of this.groups(joints.filter(n => seen.has(n)), 6)) {
      const under = g.names.map(n => this.data.under["position:" + n]).filter(n => n &&
        state.frame >= this.introduced(n));
      this.beside(g.q, [...g.names, ...under], "position", 9, g.names.map(n => "position:" + n).join(" "));
    }
    for (const show of overlays) show(this, frame, seen);
    this.settle();
    end();
  }
  /** @type {(drawn: Statics, there: There, loaded: boolean) => void} */
  standing(drawn, there, loaded) { // strings, lines of action, supports, loads at their points: not to scale
    this.strokesOf(drawn, "position", there);
    for (const s of drawn.signs) if (s.kind !== "hinge" && there(s.mark)) this.sign(there(s.mark), s);
    for (const f of loaded ? drawn.loads : []) {
      const p = there(f.mark), angle = live.angle(f.along), size = live.value(f.size);
      if (!p || angle == null || !size) continue;
      const long = (this.size ? 30 : 44) * Math.sign(size), turn = angle * Math.PI / 180;
      const from = [p[0] - long * Math.cos(turn), p[1] + long * Math.sin(turn)];
      this.arrow(from, p, "force", f.name);
      this.along(from, p, [f.name], "force");
    }
  }
  /** @type {(p: Spot, s: { kind: string, turn: number }) => void} */
  sign(p, s) { // a roller on its base, or the wall of a clamp
    const u = this.size ? 0.75 : 1;
    if (s.kind === "clamp") {
      const rows = [-2, -1, 0, 1, 2].map(k => `M${p[0]} ${p[1] + k * 7 * u}l${-6 * u} ${6 * u}`);
      svg("path", { class: "hatch", d: `M${p[0]} ${p[1] - 18 * u}v${36 * u}${rows.join("")}` }, this.node);
    } else if (s.kind === "roller") {
      const node = svg("g", { transform: `translate(${p[0]} ${p[1]}) rotate(${90 - s.turn})` }, this.node);
      svg("path", { class: "ground", d: `M0 0l${-9 * u} ${13 * u}h${18 * u}z` }, node);
      for (const x of [-5, 5]) svg("circle", { class: "hinge", cx: x * u, cy: 16 * u, r: 2.6 * u }, node);
      svg("path", { class: "hatch", d: `M${-15 * u} ${19 * u}h${30 * u}` }, node);
      const turn = (s.turn - 90) * Math.PI / 180, c = Math.cos(turn), d = Math.sin(turn);
      const at = (/** @type {number} */ x, /** @type {number} */ y) =>
        [p[0] + u * (x * c + y * d), p[1] - u * (x * d - y * c)];
      this.strokes.push([at(0, 0), at(-9, 13)], [at(0, 0), at(9, 13)], [at(-15, 19), at(15, 19)]);
    }
  }
  // the free body of a group, with the forces laid off so far at their points, as long as on the plan
  /** @type {(frame: Frame) => void} */
  loaded(frame) {
    const upto = this.data.frames.indexOf(frame);
    for (const s of this.data.segments) for (const name of s.plan === frame.plan ? s.names : []) {
      const [p, a, b] = [this.data.acts[name] || "", `${s.plan}:${s.start}`, `${s.plan}:${s.end}`].map(n => this.at(n));
      const first = born(name, frame.plan);
      const whole = this.data.segments.some(o => o.plan === s.plan &&
        o.names.some(n => n === name.split("^")[0] && n !== name && born(n, s.plan) <= upto));
      if (!p || !a || !b || first > upto || first < 0 || (name.includes("^") && whole)) continue;
      const q = this.px(p);
      const e = [q[0] + (b[0] - a[0]) * this.k, q[1] - (b[1] - a[1]) * this.k];
      if (!this.arrow(q, e, frame.terms.includes(name) ? "force" : "part loaded", name)) continue;
      const n = distance(q, e), far = Math.min(n, 90) / n;
      this.along(q, [q[0] + (e[0] - q[0]) * far, q[1] + (e[1] - q[1]) * far], [name], frame.plan);
    }
  }
  /** @type {(name: string) => number} */
  introduced(name) { // the frame that explains the point under a slider
    return this.first[name] ??= this.data.frames.findIndex(f => f.key === "equation" && f.why.en.includes(`⟨${name}⟩`));
  }
  /** @type {(frame: Frame) => void} */
  carried(frame) { // a relative vector at its point, and the sense in which it turns the link
    const { vector, rate, point, about } = frame.turns;
    const s = this.data.segments.find(s => s.plan === frame.plan && s.names.includes(vector));
    const [p, o] = [point, about].map(n => this.spot(n));
    const [a, b] = s ? [s.start, s.end].map(n => this.at(`${s.plan}:${n}`)) : [];
    if (!p || !o || !a || !b) return;
    const n = distance(a, b), long = Math.min(64, Math.max(26, n * this.k));
    const q = [p[0] + (b[0] - a[0]) / n * long, p[1] - (b[1] - a[1]) / n * long];
    if (n < 1e-6) return;
    this.arrow(p, q, "force", vector);
    this.along(p, q, [vector], frame.plan);
    const from = Math.atan2(p[1] - o[1], p[0] - o[0]), r = Math.min(0.55 * distance(o, p), 70);
    const way = live.value(rate) > 0 ? -1 : 1;
    const at = this.turned(o, r, from, way, [-0.1, 0.75], "about turning", rate);
    this.put([rate], (half, tall) => [0.33, 0.05, 0.6, 0.9, -0.3, 1.3].flatMap((t, k) => {
      const m = at(t), n = distance(o, m) || 1, u = [(m[0] - o[0]) / n, (m[1] - o[1]) / n];
      return [6, 16, -2 * half - 6].map((far, j) => [m[0] + u[0] * (half + far), m[1] + u[1] * (tall + far),
        0.2 * (k + j)]);
    }), frame.plan);
  }
  /** @type {(g: Guide, p: Spot, angle: number, there: There) => void} */
  guide(g, p, angle, there) {
    if (!p || angle == null) return;
    const c = Math.cos(angle * Math.PI / 180), s = -Math.sin(angle * Math.PI / 180), fixed = g.link === "0";
    let [lo, hi] = live.reach[g.name];
    for (const l of this.data.scheme.links) if (l.slides === g.name) { // at least to its slider
      const q = there(l.points[0]);
      if (q) { const t = ((q[0] - p[0]) * c + (q[1] - p[1]) * s) / this.k; lo = Math.min(lo, t); hi = Math.max(hi, t); }
    }
    const over = 34 / this.k;
    const ends = [lo - (fixed || lo < 0 ? over : 0),
      hi + over].map(t => [p[0] + t * this.k * c, p[1] + t * this.k * s]);
    this.line(ends[0], ends[1], fixed ? "axis" : "rail", fixed ? "" : "link:" + g.link, true);
  }
  /** @type {(l: Link, there: There, away: string) => void} */
  link(l, there, away) {
    const pts = l.points.map(there).filter(Boolean);
    const cls = "link" + (l.name === this.data.scheme.driver ? " driver" : "") + away;
    const shape = hull(pts), { drawn } = this.data.scheme;
    if (drawn) pts.slice(1).forEach((p, k) => this.line(pts[k], p, cls, "link:" + l.name)); // including its bends
    else if (shape.length > 2) {
      svg("polygon", { points: shape.map(p => p.map(v => v.toFixed(1)).join(",")).join(" "), class: cls,
        "data-name": "link:" + l.name }, this.node);
      shape.forEach((p, k, a) => this.strokes.push([p, a[(k + 1) % a.length]]));
    } else if (shape.length === 2) this.line(shape[0], shape[1], cls, "link:" + l.name);
    const numbered = !drawn || drawn.numbered.includes(l.name);
    if (pts.length > 1 && numbered) { // the number of the link, at its middle
      const m = [(pts[0][0] + pts[1][0]) / 2, (pts[0][1] + pts[1][1]) / 2], n = distance(pts[0], pts[1]);
      if (n > 34) this.number(l.name, pts[0], pts[1], m, n);
    }
  }
  /** @type {(name: string, a: Spot, b: Spot, m: Spot, n: number) => void} */
  number(name, a, b, m, n) {
    const x = m[0] - (b[1] - a[1]) / n * 13, y = m[1] + (b[0] - a[0]) / n * 13;
    svg("text", { class: "number", x, y: y + 4, "text-anchor": "middle", "data-name": "link:" + name },
      this.node, name);
    this.taken.push([x, y, 6]);
  }
  /** @type {(l: Link, p: Spot, angle: number) => void} */
  slider(l, p, angle) {
    if (!p || angle == null) return;
    const u = this.size ? 0.75 : 1, turn = `translate(${p[0].toFixed(1)} ${p[1].toFixed(1)}) rotate(${-angle})`;
    svg("rect", { x: -20 * u, y: -11 * u, width: 40 * u, height: 22 * u, class: "block", transform: turn,
      "data-name": "link:" + l.name }, this.node);
    const c = Math.cos(angle * Math.PI / 180) * 20 * u, s = -Math.sin(angle * Math.PI / 180) * 20 * u;
    const w = [s * 0.55, -c * 0.55];
    for (const k of [1, -1]) this.strokes.push([[p[0] - c + k * w[0], p[1] - s + k * w[1]],
      [p[0] + c + k * w[0], p[1] + s + k * w[1]]]);
  }
  /** @type {(l: Link, p: Spot, o: Spot) => void} */
  rounded(l, p, o) { // a block on an arc, and the arc on its outer side, hatched if it is the frame's
    if (!p || !o) return;
    const u = this.size ? 0.75 : 1, r = distance(o, p) + 11 * u, here = Math.atan2(p[1] - o[1], p[0] - o[0]);
    const half = Math.min(62 * u / r, Math.PI);
    const at = (/** @type {number} */ t, far = 0) => [o[0] + (r + far) * Math.cos(here + t),
      o[1] + (r + far) * Math.sin(here + t)].map(v => v.toFixed(1));
    const ways = [-1, -0.75, -0.5, -0.25, 0, 0.25, 0.5, 0.75, 1].map(k => at(k * half).map(Number));
    svg("path", { class: "rail arc",
      d: `M${ways.map(q => q.join(" ")).join(`A${r.toFixed(1)} ${r.toFixed(1)} 0 0 1 `)}`,
      "data-name": l.round.link === "0" ? "" : "link:" + l.round.link }, this.node);
    ways.slice(1).forEach((q, k) => this.strokes.push([ways[k], q]));
    if (l.round.link === "0") svg("path",
      { class: "hatch", d: ways.map((_,
      k) => `M${at((k / 4 - 1) * half).join(" ")}L${at((k / 4 - 1) * half + 5 / r, 7 * u).join(" ")}`).join("") },
      this.node);
    this.slider(l, p, 90 - here * 180 / Math.PI);
  }
  /** @type {(there: There, lit: Set<string>) => void} */
  hinges(there, lit) {
    const hinges = new Set(this.data.scheme.links.flatMap(l => l.hinges));
    for (const n of new Set([...this.data.scheme.links.flatMap(l => l.points), ...this.centres, ...this.special])) {
      const p = there(n);
      if (!p) continue;
      const r = hinges.has(n) ? (this.size ? 3.4 : 4.6) : 2.6;
      svg("circle", { cx: p[0], cy: p[1], r, class: (hinges.has(n) ? "hinge" : "point") + (lit.has(n) ? " lit" : ""),
        "data-name": n }, this.node);
    }
  }
  /** @type {(p: Spot) => void} */
  ground(p) {
    const [x, y] = p, u = this.size ? 0.75 : 1;
    svg("path", { class: "ground", d: `M${x} ${y}l${-11 * u} ${19 * u}h${22 * u}z` }, this.node);
    let d = "";
    for (let k = -2; k < 4; k++) d += `M${x + k * 5 * u} ${y + 19 * u}l${-5 * u} ${6 * u}`;
    svg("path", { class: "hatch", d: d + `M${x - 15 * u} ${y + 19 * u}h${30 * u}` }, this.node);
    this.strokes.push([[x, y], [x - 11 * u, y + 19 * u]], [[x, y], [x + 11 * u, y + 19 * u]],
      [[x - 11 * u, y + 19 * u], [x + 11 * u, y + 19 * u]]);
  }
}
/** @type {(points: Spot[]) => Spot[]} */
function hull(points) { // the outline of a link of three points or more; of points in line, the two ends
  const p = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  if (p.length < 3) return p;
  const turn = (/** @type {Spot} */ o, /** @type {Spot} */ a, /** @type {Spot} */ b) => (a[0] - o[0]) * (b[1] - o[1]) -
    (a[1] - o[1]) * (b[0] - o[0]);
  const half = (/** @type {Spot[]} */ list) => {
    const h = [];
    for (const q of list) { while (h.length > 1 && turn(h[h.length - 2], h[h.length - 1], q) <= 1) h.pop(); h.push(q); }
    return h.slice(0, -1);
  };
  const all = [...half(p), ...half(p.reverse())];
  return all.length > 2 ? all : [p[0], p[p.length - 1]];
}
