// A figure of the lesson's marks: arrows about centres, forces and arms of a moment equation.
import { Figure } from "./figure.js";
import { distance } from "./geometry.js";
import { keyOf, labelOf } from "./letters.js";
import { live } from "./page.js";
import { head, headSize } from "./signs.js";
import { arc, circle, svg } from "./svg.js";

export class Drawing extends Figure {
  /** @param {Element} node @param {LessonData} data @param {number[]} [size] */
  constructor(node, data, size) {
    super(node, data, size);
    this.data = data;
  }
  /** @type {(name: string) => Spot} */
  at(name) { return live.at(name); }
  /** @type {(key: string) => string[]} */
  own(key) {
    const { drawn } = this.data.scheme, poles = drawn ? drawn.strokes.flatMap(s => s.ends) : [];
    return Object.keys(this.data.marks).filter(n => keyOf(n) === key &&
      (!this.data.helpers.includes(n) || poles.includes(n)));
  }
  /** @type {(o: Spot, r: number, from: number, way: number, ends: number[], cls: string,
   * name: string) => (t: number) => Spot} */
  turned(o, r, from, way, [first, last], cls, name) { // an arrow about a centre, from an angle onwards, radians
    const at = (/** @type {number} */ t) => [o[0] + r * Math.cos(from + way * t), o[1] + r * Math.sin(from + way * t)];
    const size = headSize(r * (last - first), this.unit, "thick"), back = at(last - 2 * Math.asin(size[0] / 2 / r));
    const tip = at(last), n = distance(back, tip), along = [0, 1].map(k => (tip[k] - back[k]) / n);
    arc(o, r, from + way * first, from + way * (last - 0.8 * size[0] / r), { class: cls }, this.node);
    svg("polygon", { points: head(tip, along, size) },
      svg("g", { class: "arrow force", "data-name": name }, this.node));
    return at;
  }
  /** @type {(drawn: Statics, plan: string, there: There) => void} */
  strokesOf(drawn, plan, there) { // strings, rays and lines of action, with their letters
    for (const s of drawn.strokes) {
      const [a, b] = s.plan === plan ? s.ends.map(there) : [];
      if (!a || !b) continue;
      this.line(a, b, s.kind !== "string" && s.kind !== "ray" && s.kind !== "closing" ? "trace" : "string", s.name);
      if (s.name) this.along(a, b, [s.name], plan);
    }
    const poles = new Set(drawn.strokes.filter(s => s.kind === "ray" && s.plan === plan).map(s => s.ends[0]));
    for (const n of poles) if (there(n)) this.beside(there(n), [labelOf(n)], plan);
  }
  /** @type {(c: Couple, nth: number) => void} */
  couple(c, nth) { // about the middle of its link, each further one wider
    const l = this.data.scheme.links.find(l => l.name === c.link);
    const pts = l ? l.points.map(n => this.spot(n)).filter(Boolean) : [];
    const size = c.sign * live.value(c.size), r = (this.size ? 13 : 19) + 7 * nth;
    if (!pts.length || !(Math.abs(size) > 1e-9)) return;
    const o = [0, 1].map(i => pts.reduce((z, p) => z + p[i], 0) / pts.length);
    const from = pts.length > 1 ? Math.atan2(pts[1][1] - o[1], pts[1][0] - o[0]) : 0;
    const at = this.turned(o, r, from, size > 0 ? -1 : 1, [0.5, 4.2], "about couple", c.name);
    for (const t of [0.5, 1.4, 2.3, 3.2, 4.2]) this.strokes.push([at(t), at(t + 0.4)]);
    this.beside(o, [c.name], "force", r + 3);
  }
  /** @type {(m: Moments, terms: string[]) => void} */
  forces(m, terms) { // each force at its point, its arm to the moment point; not to scale
    const about = this.spot(m.about), beside = /** @type {Record<string, any>} */ ({});
    const dropped = /** @type {any[]} */ ([]);
    for (const f of m.forces) {
      const p = this.spot(f.mark), angle = live.angle(f.along);
      if (!p || angle == null || !terms.includes(f.name)) continue;
      const size = f.size ? live.value(f.size) : 1, back = size < 0 ? -1 : 1;
      const c = back * Math.cos(angle * Math.PI / 180), s = -back * Math.sin(angle * Math.PI / 180);
      const long = this.size ? 34 : 52;
      const foot = f.foot && this.spot(f.foot);
      const key = `${p.map(Math.round)}${Math.round(angle * back)}`;
      beside[key] = (beside[key] || 0) + 1;
      const shift = (beside[key] - 1) * 5, a = [p[0] - s * shift, p[1] + c * shift];
      const b = [a[0] + c * long, a[1] + s * long];
      if (foot && about) {
        this.line(a, foot, "trace", "", false);
        this.line(about, foot, "arm", f.name);
        const same = dropped.find(d => distance(foot, d.foot) < 2);
        if (same) same.names.push(f.arm); else dropped.push({ foot, names: [f.arm] });
      }
      this.arrow(a, b, "force", f.name);
      this.along(a, b, [f.name], "force");
    }
    const couples = m.couples.filter(c => terms.includes(c.name));
    couples.forEach((c, k) => this.couple(c, couples.slice(0, k).filter(o => o.link === c.link).length));
    for (const d of dropped) if (distance(about, d.foot) > 8) this.along(about, d.foot, d.names, "force");
    if (about) circle(about, 8, "about", this.node);
  }
}
