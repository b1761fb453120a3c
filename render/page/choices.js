// The choices in practice: a scale, the links that come next for forces and why, the equation written first.
import { distance, union } from "./geometry.js";
import { data, live, state } from "./page.js";
import { filled, number, say, scaled, sentence } from "./words.js";
const CHOICES = ["mu", "order", "reason", "first"];

/** @type {(t: Question) => boolean} */
export function chosen(t) { return CHOICES.includes(t.kind); }
/** @type {(key: string) => string} */
function scaleUnit(key) { return filled(data.plans.find(p => p.key === key).mu[state.lang]).replace(/^\S+ /, ""); }
/** @type {(key: string) => string} */
function scaleOf(key) { return `mu_${key}`; }
/** @type {(t: Question, scale: number) => number} */
function across(t, scale) { // the larger side of a plan at a scale, mm: with its pole where it has one
  const places = [...t.marks.map(m => live.at(m)), ...t.what === "position" ? [] : [[0, 0]]].filter(Boolean);
  const box = places.reduce((b, p) => union(b, [...p, ...p]), [Infinity, Infinity, -Infinity, -Infinity]);
  return Math.max(box[2] - box[0], box[3] - box[1]) * scale / live.given[scaleOf(t.what)];
}
/** @type {(t: Question) => number[]} */
function bounds(t) { // a ruler reading is as accurate at it as the judgement requires; it fits, or as well as before
  const own = across(t, data.home[scaleOf(t.what)]);
  return [Math.min(data.judging.ruler_mm / data.judging.number_share, own / 2), Math.max(t.most, own)];
}
/** @type {(t: Question) => any} */
export function best(t) { return t.kind === "mu" ? data.home[scaleOf(t.what)] : t.offered.find(o => !o.why).value; }
/** @type {(t: Question, a: any) => boolean} */
export function holds(t, a) {
  if (t.kind !== "mu") return t.offered.some(o => o.value === a && !o.why);
  const [least, most] = bounds(t), mm = across(t, a);
  return typeof a === "number" && least <= mm && mm <= most;
}
/** @type {(key: string, scale: number) => string} */
function scaleSaid(key, scale) {
  return `${scaled(scale, /⟦i/.test(data.plans.find(p => p.key === key).mu.en))} ${scaleUnit(key)}`;
}
/** @type {(t: Question, a: any) => string} */
export function reply(t, a) { // for a scale the size of the plan, right or wrong
  const own = (/** @type {any} */ value) => t.offered.find(o => o.value === value);
  if (t.kind !== "mu" && !holds(t, a)) return /** @type {Said} */ (own(a).why)[state.lang];
  if (t.kind === "order" && a !== t.what) return say("on").replace("{links}", own(t.what).said[state.lang]);
  if (t.kind !== "mu") return say("right");
  const mm = across(t, a), key = holds(t, a) ? "fits" : mm < bounds(t)[0] ? "small" : "wide";
  return say(key).replace("{mu}", scaleSaid(t.what, a)).replace("{mm}", number(+mm.toPrecision(2)));
}
/** @type {(t: Question, a: any) => Numbers} */
export function taken(t, a) { // draw at the scale if it is right
  if (t.kind !== "mu") return {};
  live.set({ [scaleOf(t.what)]: a });
  if (t.what === "position") live.scan();
  return { [t.what]: a };
}
/** @type {(t: Question) => string} */
export function question(t) {
  if (t.kind !== "mu") return say(`ask_${t.kind}`);
  const mark = data.practice.find(o => o.kind === "mark" && o.frame === t.frame), f = data.frames[t.frame];
  const start = live.at(f.uses[0]) || [0, 0], long = distance(start, live.at(mark.what));
  const value = t.what === "position" && live.given[t.name] || long / live.given[scaleOf(t.what)];
  return say("ask_mu").replace("{name}", `⟨${t.name}⟩`).replace("{value}",
    `${number(value)} ${t.unit[state.lang]}`).replace("{most}", number(t.most));
}
/** @type {(t: Question) => string} */
export function buttons(t) {
  const label = (/** @type {Offer} */ o) => t.kind === "mu" ? scaleSaid(t.what, o.value) : sentence(o.said[state.lang]);
  return t.offered.map((o, k) => `<button type="button" id="do-choose-${k}" data-do="choose" data-at="${k}">${label(
    o)}</button>`).join("");
}
