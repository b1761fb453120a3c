// The scheme of the mechanism: links, hinges, guides, sliders, and the forces on them.
import { Drawing } from "./drawing.js";
import { born } from "./frames.js";
import { along, distance, heading, hull, union } from "./geometry.js";
import { labelOf } from "./letters.js";
import { live, state } from "./page.js";
import { paper } from "./signs.js";
import { arc, end, coordinates, svg } from "./svg.js";

// additions by other modules: the figure, the frame, the visible marks
export const overlays = /** @type {((figure: Scheme, frame: any, seen: Set<string>) => void)[]} */ ([]);

const PENS = /** @type {Said} */ ({ large: "block", small: "block", roller: "ground", clamp: "ground" }); // as classes

export class Scheme extends Drawing {
  /** @param {Element} node @param {LessonData} data @param {number[]} [size] */
  constructor(node, data, size) {
    super(node, data, size);
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
    this.more = this.size ? 15 : 11; // for the sign of a support over the bar of lengths
    this.start(now ? union(common, now) : common);
    /** @type {(n: string) => any} */
    const there = n => seen.has(n) && this.spot(n);
    const borne = (/** @type {Guide} */ g) => scheme.links.some(l => l.slides === g.name && there(l.points[0]));
    for (const g of scheme.guides) // a moving guide is drawn once its slider is: the construction tells where it lies
      if (g.link === "0" || borne(g)) this.guide(g, there(g.mark), live.angle("∥" + g.name), there);
    const own = frame ? this.data.plans.find(p => p.key === frame.plan).links : [];
    const apart = (/** @type {Link} */ l) => own.length && !own.includes(l.name);
    for (const l of scheme.links) this.link(l, there, apart(l) ? " away" : "");
    if (scheme.drawn) this.standing(scheme.drawn, there, !own.length && !told);
    for (const l of scheme.links) if (l.round) this.rounded(l, there(l.points[0]), there(l.round.centre));
    for (const { sign, mark, shows, along, turn, towards } of scheme.signs) {
      const p = there(mark), q = towards && there(towards);
      const angle = along ? live.angle(along) : q ? -heading(p, q) : turn ?? 0;
      if (p && angle !== null) this.sign(sign, p, angle, (PENS[sign] ?? sign) + (lit.has(shows) ? " lit" : ""), shows);
    }
    if (told) this.forces(told, frame.terms);
    const made = frame && frame.chapter !== "centres" ? frame.makes : [];
    for (const m of made) if (m.startsWith("position:")) this.trace(this.data.traces[m], m);
    if (frame && frame.turns) this.carried(frame);
    if (own.length) this.loaded(frame);
    const joints = [...new Set([...scheme.links.flatMap(l => l.points), ...scheme.pivots, ...this.centres])];
    for (const n of this.special) if (there(n)) this.beside(there(n), [labelOf(n)], "position", 9, n);
    for (const g of this.groups(joints.filter(n => seen.has(n)), 6)) {
      const under = g.names.map(n => this.data.under["position:" + n]).filter(u => u && state.frame >= u.from);
      const names = [...g.names, ...under.map(u => u.name)], marks = g.names.map(n => "position:" + n);
      this.beside(g.q, names, "position", 9, marks.join(" "));
    }
    for (const show of overlays) show(this, frame, seen);
    this.settle();
    end();
  }
  /** @type {(drawn: Statics, there: There, loaded: boolean) => void} */
  standing(drawn, there, loaded) { // strings, lines of action, loads at their points: not to scale
    this.strokesOf(drawn, "position", there);
    for (const f of loaded ? drawn.loads : []) {
      const p = there(f.mark), angle = live.angle(f.along), size = live.value(f.size);
      if (!p || angle == null || !size) continue;
      const from = along(p, (this.size ? -30 : -44) * Math.sign(size), -angle);
      this.arrow(from, p, "force", f.name);
      this.along(from, p, [f.name], "force");
    }
  }
  // the free body of a group, with the forces laid off so far at their points, as long as on the plan
  /** @type {(frame: Frame) => void} */
  loaded(frame) {
    const upto = this.data.frames.indexOf(frame);
    const known = (/** @type {string} */ n) => born(n, frame.plan) >= 0 && born(n, frame.plan) <= upto;
    for (const s of this.data.segments) for (const name of s.plan === frame.plan ? s.names : []) {
      const [p, a, b] = [this.data.acts[name] || "", `${s.plan}:${s.start}`, `${s.plan}:${s.end}`].map(n => this.at(n));
      const sum = name.split("^")[0];
      if (!p || !a || !b || !known(name) || (sum !== name && known(sum))) continue;
      const q = this.px(p);
      const e = [q[0] + (b[0] - a[0]) * this.k, q[1] - (b[1] - a[1]) * this.k];
      if (!this.arrow(q, e, frame.terms.includes(name) ? "force" : "part loaded", name)) continue;
      const n = distance(q, e), far = Math.min(n, 90) / n;
      this.along(q, [q[0] + (e[0] - q[0]) * far, q[1] + (e[1] - q[1]) * far], [name], frame.plan);
    }
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
    const [c, s] = along([0, 0], 1, -angle), fixed = g.link === "0";
    let [lo, hi] = live.reach[g.name];
    for (const l of this.data.scheme.links) if (l.slides === g.name) { // at least to its slider
      const q = there(l.points[0]);
      if (q) { const t = ((q[0] - p[0]) * c + (q[1] - p[1]) * s) / this.k; lo = Math.min(lo, t); hi = Math.max(hi, t); }
    }
    const over = 34 / this.k;
    const [a, b] = [lo - (fixed || lo < 0 ? over : 0), hi + over].map(t => along(p, t * this.k, -angle));
    this.line(a, b, fixed ? "axis" : "rail", fixed ? "" : "link:" + g.link, true);
  }
  /** @type {(l: Link, there: There, away: string) => void} */
  link(l, there, away) {
    const pts = l.points.map(there).filter(Boolean), [a, b] = pts, n = b ? distance(a, b) : 0;
    const cls = "link" + (l.name === this.data.scheme.driver ? " driver" : "") + away;
    const shape = hull(pts), { drawn } = this.data.scheme;
    if (drawn) pts.slice(1).forEach((p, k) => this.line(pts[k], p, cls, "link:" + l.name)); // including its bends
    else if (shape.length > 2) {
      svg("polygon", { points: coordinates(shape), class: cls, "data-name": "link:" + l.name }, this.node);
      shape.forEach((p, k, a) => this.strokes.push([p, a[(k + 1) % a.length]]));
    } else if (shape.length === 2) this.line(shape[0], shape[1], cls, "link:" + l.name);
    if (n <= 34 || drawn && !drawn.numbered.includes(l.name)) return; // its number, beside its middle
    const x = (a[0] + b[0]) / 2 - (b[1] - a[1]) / n * 13, y = (a[1] + b[1]) / 2 + (b[0] - a[0]) / n * 13;
    svg("text", { class: "number", x, y: y + 4, "text-anchor": "middle", "data-name": "link:" + l.name },
      this.node, l.name);
    this.taken.push([x, y, 6]);
  }
  /** @type {(l: Link, p: Spot, o: Spot) => void} */
  rounded(l, p, o) { // a block on an arc, and the arc on its outer side, hatched if it is the frame's
    if (!p || !o) return;
    const r = distance(o, p) + this.unit * paper.wide / 2, here = Math.atan2(p[1] - o[1], p[0] - o[0]);
    const half = Math.min(this.unit * paper.reach / r, 3), step = this.unit * paper.gap / r;
    const at = (/** @type {number} */ t) => along(o, r, t * 180 / Math.PI), fixed = l.round.link === "0";
    arc(o, r, here - half, here + half,
      { class: "thick rail", ...(!fixed && { "data-name": `link:${l.round.link}` }) }, this.node);
    for (let t = here - half + step / 2; t < here + half; t += step) {
      this.strokes.push([at(t - step / 2), at(t + step / 2)]);
      if (fixed) this.sign("stroke", at(t), -t * 180 / Math.PI, "ground");
    }
    this.sign("block", p, 90 - here * 180 / Math.PI, "block", `link:${l.name}`);
  }
}
