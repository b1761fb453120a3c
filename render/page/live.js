// The program at work: given numbers in, marks, values and failures out; a whole turn; the numbers for a drag.
import { clamp, dot, quantile, union } from "./geometry.js";
import { labelOf } from "./letters.js";
import { Tape } from "./tape.js";
export const TURN = 360, LOOKS = 5, REACHED = 0.01;
const BLUNT = Math.sin(Math.PI / 12);

export class Live {
  zones = /** @type {Zone[]} */ ([]);
  own = /** @type {Record<string, Spot>} */ (/** @type {any} */ (null));
  usual = [0, 0, 1, 1];
  reach = /** @type {Record<string, number[]>} */ ({});
  /** @param {LessonData} data @param {number} [by] */
  constructor(data, by = 1) {
    this.data = data;
    this.leans = false;
    this.tape = new Tape(data.tape);
    this.given = { ...data.home };
    this.run();
    this.scan(by);
  }
  get drive() { return this.given[this.data.drive.given]; }
  get at_home() { return Object.entries(this.data.home).every(([n, v]) => this.given[n] === v); }
  get altered() { return Object.keys(this.data.home).filter(n => n !== this.data.drive.given &&
    this.given[n] !== this.data.home[n] && this.data.knobs.some(k => k.given === n)); }
  /** @type {(numbers: Numbers) => void} */
  set(numbers) { // numbers tied to a number change with it
    for (const k of this.data.knobs) if (numbers[k.given]) {
      for (const n of k.tied) this.given[n] *= numbers[k.given] / this.given[k.given];
      this.given[k.given] = numbers[k.given];
    }
    Object.assign(this.given, numbers);
    this.run();
  }
  /** @type {(v: number) => number} */
  placed(v) { // a position of the drive within its range; an angle wraps round
    const { from, to, symbol, held, at } = this.data.drive;
    if (held || (v >= from && v < to)) return held ? at : v; // exactly, where it is one
    return symbol === "φ" ? ((v - from) % 360 + 360) % 360 + from : clamp(v, from, to);
  }
  /** @type {(given: Numbers) => void} */
  back(given) { this.given = { ...given }; this.run(); }
  reset() { this.back(this.data.home); this.scan(); }
  lean() { // with a guide turned there is more to say: terms that are zero in its original direction
    const leans = this.data.knobs.some(k => k.stays && this.given[k.given] !== k.at);
    if (leans === this.leans) return;
    this.leans = leans;
    for (const [k, more] of Object.entries(this.data.leaning || {})) for (const n in more) {
      const frame = /** @type {any} */ (this.data.frames[+k]);
      [frame[n], more[n]] = [more[n], frame[n]];
    }
  }
  run() {
    this.lean();
    this.tape.run(this.given);
    const failed = this.data.holds.find(h => !this.tape.values[h.at]);
    this.failed = failed ? failed.said : null;
  }
  /** @type {(places: number[]) => any} */
  pair(places) {
    const [x, y] = places ? places.map(p => this.tape.values[p]) : [NaN];
    return Number.isFinite(x) && Number.isFinite(y) ? [x, y] : null;
  }
  /** @type {(mark: string) => Spot} */
  at(mark) { return this.pair(this.data.marks[mark]); }
  /** @type {(mark: string) => any} */
  home(mark) { return this.own[mark] || null; }
  /** @type {(direction: string) => any} */
  angle(direction) {
    const u = this.pair(this.data.turned[direction]);
    return u && Math.atan2(u[1], u[0]) * 180 / Math.PI;
  }
  /** @type {(name: string) => any} */
  value(name) {
    const v = this.tape.values[this.data.values[name]];
    return Number.isFinite(v) ? v : null;
  }
  /** @type {(mark: string) => number} */
  sharpness(mark) { return this.tape.values[this.data.sharp[mark]]; }
  scan(by = 1) { // a turn of the drive: where it fails or is blunt, the bounds of the view, the range of sliders
    const { from, to, at } = this.data.drive, now = this.drive, seen = /** @type {any[]} */ ([]), rows = [];
    for (let k = 0; k < (to > from ? TURN : 1); k += by) {
      this.set({ [this.data.drive.given]: from + k * (to - from) / TURN });
      rows.push({ drive: this.drive, failed: this.failed, ...this.bluntest() });
      if (!this.failed && k % LOOKS === 0) seen.push(this.look());
    }
    this.zones = this.zoned(rows);
    this.set({ [this.data.drive.given]: at });
    if (!this.failed || !this.own) this.own = Object.fromEntries(Object.keys(this.data.marks).map(n => [n,
      this.at(n)]));
    this.usual = this.view(seen.map(s => s.box));
    this.reach = Object.fromEntries(this.data.scheme.guides.map(g => [g.name,
      this.spread(seen.flatMap(s => s.runs[g.name] || []))]));
    this.set({ [this.data.drive.given]: now });
  }
  bluntest() {
    let least = 1, mark = "";
    if (!this.failed) for (const m in this.data.sharp) { const s = this.sharpness(m);
      if (s < least) { least = s; mark = m; } }
    return { least, mark: least < BLUNT ? mark : "" };
  }
  /** @type {(rows: any[]) => Zone[]} */
  zoned(rows) { // stretches that fail, and stretches where one mark is blunt
    const found = /** @type {Zone[]} */ ([]);
    for (const r of rows) {
      const kind = r.failed ? "bad" : r.mark ? "blunt" : "", last = found[found.length - 1];
      if (last && last.kind === kind && last.mark === r.mark) { last.to = r.drive;
        last.least = Math.min(last.least, r.least); }
      else found.push({ kind, mark: r.mark, from: r.drive, to: r.drive, least: r.least });
    }
    return found.filter(z => z.kind);
  }
  get zone() { return this.zones.find(z => z.from <= this.drive && this.drive <= z.to); }
  nearest() { // the nearest working position of a turn, once the turn is computed
    const { from, to } = this.data.drive, step = (to - from) / TURN;
    const bad = (/** @type {number} */ v) => this.zones.some(z => z.kind === "bad" && z.from <= v && v <= z.to);
    const q = Math.round((this.drive - from) / step);
    if (!bad(from + q * step)) return null;
    for (let k = 0; k < TURN; k++) for (const side of [k, -k]) {
      const v = from + (q + side) * step;
      if (v >= from && v < to && !bad(v)) return v;
    }
    return null;
  }
  /** @type {() => Looked} */
  look() { // the scheme's box, and the distance of each slider from its guide's mark
    const { scheme, helpers } = this.data, box = [Infinity, Infinity, -Infinity, -Infinity];
    const runs = /** @type {Record<string, any>} */ ({});
    for (const n in this.data.marks) {
      const p = n.startsWith("position:") && n !== "position:p" && !helpers.includes(n) && this.at(n);
      if (p) { box[0] = Math.min(box[0], p[0]); box[1] = Math.min(box[1], p[1]); box[2] = Math.max(box[2], p[0]);
        box[3] = Math.max(box[3], p[1]); }
    }
    for (const g of scheme.guides) for (const l of scheme.links) if (l.slides === g.name) {
      const u = this.pair(this.data.turned["∥" + g.name]), p = this.at(l.points[0]), o = this.at(g.mark);
      if (u && p && o) (runs[g.name] ||= []).push((p[0] - o[0]) * u[0] + (p[1] - o[1]) * u[1]);
    }
    return { box, runs };
  }
  /** @type {(boxes: Box[]) => Box} */
  view(boxes) { // the bounds in most positions; the view follows the rest
    const names = Object.keys(this.data.marks).filter(n => n.startsWith("position:") && n !== "position:p" &&
      !this.data.helpers.includes(n));
    const own = names.map(n => this.own[n]).filter(Boolean).reduce((b, p) => union(b, [...p, ...p]),
      [Infinity, Infinity, -Infinity, -Infinity]);
    if (!names.length) return [0, 0, 1, 1];
    if (!boxes.length) return own;
    const part = (/** @type {number} */ k, /** @type {number} */ share) => quantile(boxes.map(b => b[k]), share);
    const usual = union(own, [part(0, 0.12), part(1, 0.12), part(2, 0.88), part(3, 0.88)]);
    const side = 0.95 * Math.max(own[2] - own[0], own[3] - own[1]), mx = (own[0] + own[2]) / 2;
    const my = (own[1] + own[3]) / 2;
    return union(own, [Math.max(usual[0], mx - side), Math.max(usual[1], my - side), Math.min(usual[2], mx + side),
      Math.min(usual[3], my + side)]);
  }
  /** @type {(runs: number[]) => number[]} */
  spread(runs) { // the interval along a guide, in most positions
    const size = Math.hypot(this.usual[2] - this.usual[0], this.usual[3] - this.usual[1]);
    if (!runs.length) return [0, 0];
    return [Math.max(Math.min(quantile(runs, 0.08), 0), -size), Math.min(Math.max(quantile(runs, 0.92), 0), size)];
  }
  /** @type {(mark: string, names: string[]) => number[][]} */
  turns(mark, names) { // how a mark moves with each number, by a typical change: two rows
    return this.data.marks[mark].map(place => {
      const g = this.tape.slopes(place);
      const own = (/** @type {string} */ n) => g[this.tape.givens[n]] || 0;
      return names.map(n => {
        const tied = (this.data.knobs.find(k => k.given === n) || {}).tied || [];
        return this.size(n) * tied.reduce((all, t) => all + own(t) * this.given[t] / this.given[n], own(n));
      });
    });
  }
  /** @type {(name: string) => number} */
  size(name) { // a typical change of a number by hand
    const { given, symbol, from, to } = this.data.drive, knob = this.data.knobs.find(k => k.given === name);
    if (name.startsWith("angle_") || (name === given && symbol === "φ")) return 20;
    return name === given ? to - from : (knob && knob.reach) || Math.abs(this.data.home[name]);
  }
  // a force's numbers (for a weight the mass); else the drive, or the number with the largest effect on a mark,
  // and another one
  /** @type {(mark: string, chosen: string) => string[]} */
  handles(mark, chosen) {
    const name = labelOf(mark).replace(/^G_/, "m_"), force = mark.startsWith("force:") && !chosen;
    const own = force ? this.data.knobs.filter(k => k.name === name || k.name === "∠" + name).map(k => k.given) : [];
    if (own.length > 1) return own;
    const first = this.data.moves ? this.data.drive.given : this.handle(mark, this.data.drive.given);
    const other = chosen || own[0] || this.handle(mark, first);
    return [...(this.data.drive.held || !first ? [] : [first]), ...(other && other !== first ? [other] : [])];
  }
  /** @type {(mark: string, drive: string) => string} */
  handle(mark, drive) { // the number that, beside the drive, moves a mark most freely
    const knobs = this.data.knobs.filter(k => k.at && !k.plan).map(k => k.given); // zeros stay zero
    const [x, y] = this.turns(mark, [drive, ...knobs]), far = Math.hypot(x[0], y[0]) || 1;
    let best = "", most = 1e-9;
    knobs.forEach((n, k) => {
      const own = Math.abs(x[0] * y[k + 1] - y[0] * x[k + 1]) / far + 1e-3 * Math.hypot(x[k + 1], y[k + 1]);
      if (own > most * 1.2) { best = n; most = own; }
    });
    return best;
  }
  /** @type {(mark: string, names: string[], place: Spot) => number} */
  follow(mark, names, [x, y]) { // damped least squares; the distance in mm by which the mark misses the place
    const miss = () => { const p = this.failed ? null : this.at(mark); return p ? [x - p[0], y - p[1]] : null; };
    let off = miss(), damp = 1e-3;
    for (let k = 0; off && k < 60 && Math.hypot(...off) > REACHED / 100 && damp < 1e12; k++) {
      const [u, w] = this.turns(mark, names);
      const scale = dot(u, u) + dot(w, w), a = dot(u, u) + damp * scale, b = dot(u, w), c = dot(w, w) + damp * scale;
      const det = a * c - b * b;
      if (!(det > 0)) break;
      const p = (c * off[0] - b * off[1]) / det, q = (a * off[1] - b * off[0]) / det, before = { ...this.given };
      const moved = (/** @type {string} */ n, /** @type {number} */ i) => before[n] + Math.max(-0.5,
        Math.min(0.5, u[i] * p + w[i] * q)) * this.size(n);
      this.set(Object.fromEntries(names.map((n, i) => [n,
        n === this.data.drive.given ? this.placed(moved(n, i)) : moved(n, i)])));
      const kept = names.every((n, i) => n === this.data.drive.given || n.startsWith("angle_") || !before[n] ||
        before[n] * this.given[n] > 0), now = kept && miss();
      if (now && Math.hypot(...now) < Math.hypot(...off)) { off = now; damp = Math.max(damp / 10, 1e-12); }
      else { this.back(before); damp *= 10; }
    }
    return off ? Math.hypot(...off) : Infinity;
  }
}
