// The desk of practice: set square, compass, ruler; the reader's strokes on a plan, and their crossings.
import { plan, scheme } from "./figures.js";
import { distance } from "./geometry.js";
import { labelOf } from "./letters.js";
import { data, draw, live } from "./page.js";
import { circle, svg } from "./svg.js";
import { fixed, local, say, spoken } from "./words.js";
export const NEAR_PX = 18;
const QUARTER = Math.PI / 2, ARROWS = "→↗↑↖←↙↓↘", SAME_MM = 0.3;

export const desk = {
  practice: /** @type {any} */ (null), tool: "vector", from: "", along: "", angle: "", back: false, mm: "", to: "",
    spot: 0, strokes: /** @type {Pencil[]} */ ([]),
  clear() { Object.assign(this, { strokes: [], mm: "", spot: 0, back: false }); },
  get panel() { return this.practice.frame.plan === "position" ? scheme : plan; },
  marks() { // one for coinciding marks
    const key = this.practice.frame.plan, found = /** @type {any[]} */ ([]);
    for (const n of [...this.practice.seen()].sort((a, b) => +(a === "position:p") - +(b === "position:p"))) {
      const p = n.startsWith(key + ":") && !data.helpers.includes(n) && live.at(n);
      if (p && !found.some(m => distance(live.at(m), p) < 0.01)) found.push(n);
    }
    return found;
  },
  /** @type {() => string[][]} */
  lines() { // objects to lay a set square against: lines of the drawing, marks of the plan
    const own = Object.keys(data.lines).filter(n => live.angle(n) !== null);
    const marks = this.marks().filter(m => m !== this.from);
    return [...own.flatMap(n => [[n + "|0", "∥ " + this.line(n)], [n + "|1", "⊥ " + this.line(n)]]),
      ...marks.map(m => [m, "→ " + spoken(labelOf(m), this.practice.frame.plan)]), ["angle", say("angle")]];
  },
  /** @type {(name: string) => string} */
  line(name) { return spoken(data.lines[name]); },
  heading() { // radians
    if (this.along === "angle") { const a = parseFloat(String(this.angle).replace(",", "."));
      return Number.isFinite(a) ? a * Math.PI / 180 : null; }
    if (data.marks[this.along]) {
      const a = live.at(this.from), b = live.at(this.along);
      return a && b ? Math.atan2(b[1] - a[1], b[0] - a[0]) : null;
    }
    const [name, quarter] = this.along.split("|"), angle = live.angle(name);
    return angle === null ? null : angle * Math.PI / 180 + +quarter * QUARTER + (this.back ? Math.PI : 0);
  },
  ways() { // both directions along a line, as an arrow and an angle
    const kept = this.back;
    return [false, true].map(back => {
      this.back = back;
      const a = this.heading(), turn = a === null ? 0 : ((a * 180 / Math.PI) % 360 + 360) % 360;
      this.back = kept;
      return `${ARROWS[Math.round(turn / 45) % 8]} ${local(turn.toFixed(0))}°`;
    });
  },
  length() { const v = parseFloat(String(this.mm).replace(",", ".")); return Number.isFinite(v) && v >= 0 ? v : null; },
  /** @type {() => any} */
  draft() { // the stroke for the present state of the tools
    const at = live.at(this.from), a = this.heading(), mm = this.length();
    if (!at) return null;
    if (this.tool === "arc") return mm ? { at, r: mm } : null;
    if (a === null) return null;
    if (this.tool === "line") return { at, a };
    return this.tool === "vector" && mm !== null ?
      { at, a, mm, end: [at[0] + mm * Math.cos(a), at[1] + mm * Math.sin(a)] } : null;
  },
  /** @type {(link: string) => void} */
  lay(link) { // lay the set square against a link of the scheme: along it, then across
    const l = data.scheme.links.find(l => l.name === link), pts = l.points.map(p => labelOf(p));
    const n = Object.keys(data.lines).find(n => { const at = data.lines[n];
      return pts.some(a => pts.some(b => a !== b && a + b === at)) || l.slides === at; });
    if (!n) return;
    this.along = this.along === n + "|0" ? n + "|1" : n + "|0";
    draw();
  },
  /** @type {(stroke: Pencil, place: Spot) => number} */
  off(stroke, place) { // distance of a place from a stroke, mm
    const [x, y] = place;
    const dx = x - stroke.at[0], dy = y - stroke.at[1];
    return stroke.r ? Math.abs(Math.hypot(dx, dy) - stroke.r) :
      Math.abs(dx * Math.sin(stroke.a) - dy * Math.cos(stroke.a));
  },
  /** @type {() => Spot[]} */
  crossings() { // crossings of strokes, each place once, from left to right
    const found = /** @type {any[]} */ ([]), add = (/** @type {Spot} */ p) => {
      if (p.every(Number.isFinite) && this.inside(p) && found.every(q => distance(p, q) > SAME_MM)) found.push(p); };
    this.strokes.forEach((s, k) => this.strokes.slice(0, k).forEach(t => meet(s, t).forEach(add)));
    return found.sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  },
  /** @type {(p: Spot) => boolean} */
  inside(p) { const f = this.panel, [x, y] = f.px(p); return x > 0 && y > 0 && x < f.w && y < f.h; },
  paint() { // the strokes drawn, the current one, crossings to choose from
    const f = this.panel;
    for (const s of this.strokes) this.stroke(f, s, "pencil" + (s.wrong ? " slip" : ""));
    const s = this.draft();
    if (s) {
      this.stroke(f, s, "pencil draft");
      if (s.end && s.mm * f.k > 1) f.arrow(f.px(s.at), f.px(s.end), "ask");
    }
    const q = this.tool !== "point" && live.at(this.from) && f.px(live.at(this.from));
    if (q) circle(q, 7, "needle", f.node);
    if (this.tool === "point") this.crossings().forEach((p, k) => {
      const [x, y] = f.px(p);
      circle([x, y], 6, "choice" + (k === this.spot ? " held" : ""), f.node);
      svg("text", { x: x + 10, y: y - 8, class: "choice-text" }, f.node, String(k + 1));
    });
    f.node.classList.toggle("place", this.practice.drawing);
  },
  /** @type {(f: any, s: Pencil, cls: string) => void} */
  stroke(f, s, cls) {
    const q = f.px(s.at);
    if (s.r) { circle(q, s.r * f.k, cls, f.node); return; }
    const far = 2 * (f.w + f.h), c = Math.cos(s.a), d = -Math.sin(s.a);
    const e = s.end ? [f.px(s.at), f.px(s.end)] : [[q[0] - far * c, q[1] - far * d], [q[0] + far * c, q[1] + far * d]];
    f.line(e[0], e[1], cls, "", false);
  },
  ruler() { // between two marks, to a tenth of a millimetre
    const a = live.at(this.from), b = live.at(this.to);
    return a && b ? local(fixed(distance(a, b), 1)) : "—";
  },
  /** @type {(place: number[]) => string} */
  grip(at) { // the mark under the pointer
    const f = this.panel, near = (/** @type {string} */ m) => distance(f.px(live.at(m)), at);
    return this.marks().filter(m => near(m) < NEAR_PX).sort((a, b) => near(a) - near(b))[0];
  },
  // the free end of a stroke: its direction by the set square, else by the pointer; its length to half a millimetre
  /** @type {(p: Spot) => void} */
  drag(p) {
    const at = live.at(this.from), dx = p[0] - at[0], dy = p[1] - at[1];
    if (this.tool === "ruler") { this.to = this.grip(this.panel.px(p)) || this.to; return; }
    if (this.along === "angle") this.angle = String(Math.round(Math.atan2(dy, dx) * 180 / Math.PI));
    let a = this.heading();
    if (a !== null && !data.marks[this.along] && this.along !== "angle" &&
      dx * Math.cos(a) + dy * Math.sin(a) < 0) this.back = !this.back;
    a = this.heading() ?? Math.atan2(dy, dx);
    const mm = this.tool === "arc" ? Math.hypot(dx, dy) : Math.max(0, dx * Math.cos(a) + dy * Math.sin(a));
    if (this.tool !== "line") this.mm = String(Math.round(2 * mm) / 2);
  },
};
/** @type {(s: Pencil, t: Pencil) => Spot[]} */
function meet(s, t) { // of two strokes, lines or arcs
  if (s.r && !t.r) return meet(t, s);
  const dx = t.at[0] - s.at[0], dy = t.at[1] - s.at[1];
  if (!t.r) {
    const det = Math.sin(t.a - s.a), u = (dx * Math.sin(t.a) - dy * Math.cos(t.a)) / det;
    return Math.abs(det) < 1e-6 ? [] : [[s.at[0] + u * Math.cos(s.a), s.at[1] + u * Math.sin(s.a)]];
  }
  let foot, half, a;
  if (s.r) {
    const d = Math.hypot(dx, dy), u = (d * d + s.r * s.r - t.r * t.r) / (2 * d);
    a = Math.atan2(dy, dx) + QUARTER;
    foot = [s.at[0] + u * dx / d, s.at[1] + u * dy / d];
    half = s.r * s.r - u * u;
  } else {
    const u = dx * Math.cos(s.a) + dy * Math.sin(s.a), off = dx * Math.sin(s.a) - dy * Math.cos(s.a);
    a = s.a;
    foot = [s.at[0] + u * Math.cos(a), s.at[1] + u * Math.sin(a)];
    half = t.r * t.r - off * off;
  }
  const root = Math.sqrt(half);
  return half < 0 ? [] : [1, -1].map(k => [foot[0] + k * root * Math.cos(a), foot[1] + k * root * Math.sin(a)]);
}
