// Practice: questions to the reader, in any sensible order; answers are judged by the mistakes on the
// lesson's tape.
import { writeAddress } from "./address.js";
import { best, chosen, holds, taken } from "./choices.js";
import { desk } from "./desk.js";
import { $ } from "./dom.js";
import { terms } from "./equations.js";
import { fresh } from "./fresh.js";
import { distance } from "./geometry.js";
import { spin, zones } from "./hands.js";
import { keyOf, labelOf } from "./letters.js";
import { data, draw, live, state } from "./page.js";
import { play } from "./stepper.js";
import { forget } from "./undo.js";
import { say } from "./words.js";
const TRIES = 3, JUDGING = data.judging;

export const practice = {
  index: 0, after: () => {}, tries: 0, answers: /** @type {any[]} */ ([]), done: /** @type {Set<number>} */ (new Set()),
    marks: /** @type {Numbers} */ ({}), said: /** @type {any} */ (null), over: false, name: "",
  scales: /** @type {Numbers} */ ({}), // that were chosen
  kept: /** @type {any} */ (null),
  get on() { return state.practising; },
  set on(on) { state.practising = on; },
  get seed() { return state.seed; },
  set seed(seed) { state.seed = seed; },
  get items() { return data.practice; },
  get item() { return this.items[this.index]; },
  get frame() { return data.frames[this.item.frame]; },
  get equation() { return data.equations[this.item.what]; },
  get drawing() { return this.on && !this.over && this.item.kind === "mark"; },
  get good() { return this.answers.filter((a, k) => a !== undefined && this.right(this.items[k], a)).length; },
  get asked() { return this.answers.filter(a => a !== undefined).length; },
  toggle() {
    this.on = !this.on;
    $("practise").setAttribute("aria-pressed", String(this.on));
    document.body.classList.toggle("practising", this.on);
    $("told").hidden = this.on;
    $("task").hidden = !this.on;
    if (state.timer) play();
    if (state.spin) spin(false);
    for (const id of ["play", "progress"]) $(id).disabled = this.on;
    if (this.on) this.begin(); else { live.reset(); zones(); draw(); }
    forget();
  },
  /** @type {(seed?: number) => void} */
  begin(seed = state.seed) { // from the first question, with the scene's numbers or with fresh ones
    live.reset();
    this.seed = seed && fresh(seed, key => this.size(key)) ? seed : 0;
    live.scan();
    zones();
    Object.assign(this, { answers: [], done: new Set(), over: !this.items.length, said: null, index: 0, scales: {} });
    if (!this.over) this.take(0);
    writeAddress();
  },
  /** @type {(index: number) => void} */
  take(index) { // open a question: the drawing so far
    Object.assign(this, { index, tries: 0, marks: {} });
    state.frame = this.item.frame;
    desk.clear();
    if (this.item.kind === "mark") {
      const uses = this.frame.uses.filter(m => m.startsWith(this.frame.plan + ":") && this.seen().has(m));
      desk.tool = (data.traces[this.item.what] || this.frame.plan === "position") && !this.laid ?
        (data.traces[this.item.what]?.arcs ? "arc" : "line") : "vector";
      Object.assign(desk, { from: uses[0] || this.frame.plan + ":p", along: desk.lines()[0]?.[0] || "angle" });
    } else Object.assign(desk, { tool: "ruler", from: desk.marks()[0] || "", to: desk.marks()[1] || "" });
    draw();
  },
  get laid() { return !data.traces[this.item.what]; },
  seen() { // the drawing: answered questions, and steps that need no answer
    const pole = this.frame.plan + ":p";
    if (this.kept?.done === this.done && this.kept.size === this.done.size) return this.kept.seen.add(pole);
    const asked = new Set(this.items.filter(t => t.kind === "mark").map(t => t.what)), seen = new Set(["position:p"]);
    this.items.forEach((t, k) => { if (t.kind === "mark" && this.done.has(k)) seen.add(t.what); });
    for (let more = true; more;) {
      more = false;
      for (const f of data.frames) for (const m of f.makes) if (!seen.has(m) && !asked.has(m) &&
        f.uses.every(n => seen.has(n) || n.endsWith(":p"))) { seen.add(m); more = true; }
    }
    this.kept = { done: this.done, size: this.done.size, seen };
    return seen.add(pole);
  },
  /** @type {(k: number) => boolean} */
  free(k) { // whether a question may be answered now
    if (this.done.has(k)) return false;
    const t = this.items[k], f = data.frames[t.frame], seen = this.seen(), trace = data.traces[t.what] || {};
    const own = (/** @type {Question} */ o) => data.frames[o.frame].chapter === f.chapter;
    const first = (/** @type {Question} */ o) => own(o) ? chosen(o) || t.kind === "mu" : false;
    // choices come first
    if (this.items.some((o, i) => i < k && !this.done.has(i) && first(o))) return false;
    if (t.kind !== "mark") return this.items.every((o, i) => i >= k || o.kind !== "mark" || this.done.has(i));
    return [...f.uses, ...(trace.lines || []),
      ...(trace.arcs || [])].every(n => seen.has(n) || n.endsWith(":p") ||
      !this.items.some(o => o.kind === "mark" && o.what === n));
  },
  open() { // the questions of the current plan that may be answered, and the first of each other
    const all = this.items.map((_, k) => k).filter(k => this.free(k));
    const plan = (/** @type {number} */ k) => data.frames[this.items[k].frame].plan;
    return all.filter((k, i) => plan(k) === this.frame.plan || all.findIndex(o => plan(o) === plan(k)) === i);
  },
  /** @type {(key: string) => number} */
  size(key) { // the size of a plan: the distance of its farthest mark
    return Math.max(0, ...this.items.filter(t => t.kind === "mark" &&
      t.what.startsWith(key + ":")).map(t => live.at(t.what) ? Math.hypot(...live.at(t.what)) : 0));
  },
  /** @type {(mark: string) => number} */
  allowed(mark) { return Math.max(JUDGING.fits_mm, JUDGING.fits_share * this.size(keyOf(mark))); },
  /** @type {(mark: string) => number} */
  fits(mark) { // nearer to its place than to any mistake, within the limits of a hand
    const p = live.at(mark), wrong = this.slips(mark).map(s => distance(p, s.place));
    return Math.max(JUDGING.least_mm, Math.min(this.allowed(mark), ...wrong.map(d => d / 2)));
  },
  /** @type {(t: Question) => any} */
  truth(t) {
    if (t.kind === "known") return this.goal(data.equations[t.what]).map(g => g.known).join("");
    if (t.kind === "mark") return live.at(t.what);
    if (chosen(t)) return best(t);
    return t.kind === "sense" ? Math.sign(live.value(t.what)) : live.value(t.what);
  },
  /** @type {(t: Question, a: any) => boolean} */
  right(t, a) {
    const true_ = this.truth(t);
    if (a === null || true_ === null) return false;
    if (chosen(t)) return holds(t, a);
    if (t.kind === "known" || t.kind === "sense") return a === true_;
    if (t.kind === "mark") return distance(true_, a) <= this.fits(t.what);
    const [seen, due] = t.signed ? [a, true_] : [Math.abs(a), Math.abs(true_)];
    return Math.abs(seen - due) <= Math.max(JUDGING.number_share * Math.abs(true_),
      t.mu ? JUDGING.ruler_mm / live.given[t.mu] : 0);
  },
  /** @type {(e: Equation) => Term[]} */
  goal(e) { return [...terms(e), ...(e.total.known ? [e.total] : [])].filter(t => t.action !== "=0"); },
  /** @type {(given: any, said?: string, shown?: boolean) => void} */
  answer(given, said = "", shown = false) {
    this.judged(given, said, shown);
    this.after();
  },
  /** @type {(given: any, said: string, shown: boolean) => void} */
  judged(given, said, shown) { // the first answer counts
    if (this.answers[this.index] === undefined) this.answers[this.index] = given;
    if (this.right(this.item, given)) {
      this.said = ["yes", said || say("right")];
      if (chosen(this.item)) Object.assign(this.scales, taken(this.item, given));
      this.move();
      return;
    }
    this.tries += 1;
    const reason = (said || this.frame.why[state.lang]).replace(/\.?$/, ".");
    this.said = ["no", reason];
    if (shown || this.tries >= TRIES) { this.said = ["no", `${shown ? "" : reason + " "}${say("shown")}`]; this.move();
      return; }
    draw();
  },
  move() {
    this.done.add(this.index);
    const open = this.open(), next = open.find(k => k > this.index) ?? open[0];
    if (next === undefined) { this.over = true; desk.clear(); draw(); } else this.take(next);
  },
  /** @type {(fit: any[]) => string} */
  named(fit) { // every mistake that leads to this answer: distinguished only where the tolerance allows
    return [...new Set(fit.map(([m, names]) => this.sentence(m, names)))].join(`; ${say("or_else")} `);
  },
  /** @type {(mistake: string, names: any[]) => string} */
  sentence(mistake, names) {
    const { said, parts } = data.mistakes[mistake], own = Object.fromEntries(parts.map((p, k) => [p, names[k]]));
    return said[state.lang].replace(/\{(\w+)\}/g,
      (_, p) => typeof own[p] === "object" ? own[p][state.lang] : own[p] ? `⟨${own[p]}⟩` : "");
  },
  /** @type {(mark: string) => (Omit<Slip, "place"> & { place: Spot })[]} */
  slips(mark) { return data.slips.filter(s => s.at === mark).map(s => ({ ...s, place: live.pair(s.place) })).filter(
    s => s.place); },
  /** @type {(p: Spot, stroke?: any) => void} */
  place(p, stroke) { // a mark put here
    const t = this.item, fits = this.allowed(t.what), at = p.map(v => +v.toFixed(2));
    const near = (/** @type {Spot} */ q) => distance(at, q) <= fits;
    if (this.right(t, at)) { this.answer(at); return; }
    const fit = this.slips(t.what).filter(s => near(s.place)).map(s => [s.m, s.names]), mark = [labelOf(t.what)];
    const true_ = live.at(t.what);
    const way = stroke && stroke.end ? Math.atan2(true_[1] - stroke.at[1], true_[0] - stroke.at[0]) : null;
    const mu = live.given["mu_" + this.frame.plan];
    if (way !== null && Math.abs(Math.sin(stroke.a - way)) < 0.05 && Math.cos(stroke.a - way) > 0) {
      const long = distance(stroke.at, true_);
      const as = (/** @type {number} */ mm) => Math.abs(stroke.mm - mm) <= Math.max(0.005, Math.min(fits, 0.05 * mm));
      if (as(long / mu)) fit.push(["value_for_mm", mark]);
      if (as(long / mu / mu)) fit.push(["value_over_mu", mark]);
    }
    const other = fit.length ? null :
      this.open().map(k => this.items[k]).find(o => o.kind === "mark" && o !== t && near(live.at(o.what)));
    if (stroke) desk.strokes.push({ ...stroke, wrong: true });
    this.answer(at, other ? say("other_mark").replace("{mark}", `⟨${labelOf(other.what)}⟩`) : this.named(fit));
  },
  /** @type {(s: Pencil) => void} */
  stroke(s) { // a line or an arc on the way to a mark of this plan; the possible mistakes behind it
    const open = this.open().map(k => this.items[k]).filter(t => t.kind === "mark" &&
      t.what.startsWith(this.frame.plan + ":"));
    const wrong = !open.some(t => desk.off(s, live.at(t.what)) <= this.fits(t.what));
    desk.strokes.push({ ...s, wrong });
    if (!wrong) { this.said = ["yes", say("stroke_right")]; if (desk.crossings().length) desk.tool = "point"; draw();
      return; }
    const fit = open.flatMap(t => this.slips(t.what)).filter(w => w.m !== "angle_sense" &&
      this.starts(w.at).includes(this.stood(s)) && desk.off(s, w.place) <= this.fits(w.at) / 2).map(w => [w.m,
      w.names]);
    this.answer(null, this.named(fit));
  },
  /** @type {(mark: string) => string[]} */
  starts(mark) { const t = data.traces[mark] || {};
    return [...(t.lines || []), ...(t.arcs || []),
    this.frame.plan + ":p"].map(n => live.at(n)).filter(Boolean).map(p => p.map(v => v.toFixed(1)).join()); },
  /** @type {(s: Pencil) => string} */
  stood(s) { return s.at.map(v => v.toFixed(1)).join(); },
  /** @type {(kind: string, what: any) => boolean} */
  waits(kind, what) { return this.on && this.items.some((t, k) => t.kind === kind && t.what === what &&
    !this.done.has(k)); }, // whether a choice is still open
  /** @type {(text: string) => void} */
  number(text) { // a value
    const given = parseFloat(String(text).replace(",", ".").replace("−", "-")), t = this.item;
    if (!Number.isFinite(given)) return;
    const true_ = Math.abs(this.truth(t));
    const as = (/** @type {number} */ v) => Math.abs(Math.abs(given) - Math.abs(v)) <= JUDGING.number_share *
      Math.abs(v), fit = [];
    /** @type {(m: string, v: number) => void} */
    const add = (m, v) => { if (v && as(v)) fit.push([m, [t.what.replace(/[‖|]/g, "")]]); };
    if (t.signed && given * this.truth(t) < 0) add("sense_wrong", true_);
    const rate = /^(omega|epsilon)_/.test(t.what), mu = live.given[t.mu || "mu_" + this.frame.plan];
    const scheme_ = live.given.mu_position;
    if (rate) for (const by of [1 / scheme_, mu / scheme_, 1e-3]) add("omega_without_mu_l", true_ * by);
    if (mu && mu !== 1) { add("mm_for_value", true_ * mu); add("mu_inverted", true_ * mu * mu);
      add("mu_inverted", true_ / mu / mu); }
    const mark = this.items.find(o => o.kind === "mark" && o.frame === t.frame);
    const from = mark && live.at(data.frames[t.frame].uses[0]);
    if (from) for (const s of this.slips(mark.what)) if (as(distance(from, s.place) / mu)) fit.push([s.m, s.names]);
    this.answer(+given.toPrecision(6), this.named(fit));
  },
  /** @type {(name: string) => boolean} */
  asking(name) { return this.on && !this.over && this.item.kind === "known" &&
    this.goal(this.equation).some(t => t.name === name); },
  /** @type {(name: string) => number} */
  given(name) { return this.marks[name] || 0; },
};
desk.practice = practice;
