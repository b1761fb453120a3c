// Words of the page: sentences with their numbers, names with their indices.
import { html, lettered } from "./letters.js";
import { data, live, state, words } from "./page.js";
export const SCHEME = data.scheme?.drawn ? "space_diagram" : "scheme"; // the title of the figure of links
/** @type {(key: string) => string} */
export function say(key) { return words[state.lang][key]; }
/** @type {(text: string) => string} */
export function local(text) { return state.lang !== "en" ? text.replace(".", ",") : text; }
/** @type {(x: number, digits: number) => string} */
export function fixed(x, digits) { // as the engine rounds: a tie goes to the even digit
  const all = x.toFixed(Math.min(digits + 30, 100)), cut = all.indexOf(".") + 1 + digits;
  if (!/^50*$/.test(all.slice(cut))) return x.toFixed(digits);
  const low = all.slice(0, cut).replace(/\.$/, "");
  return /[02468]$/.test(low) ? low : x.toFixed(digits);
}
/** @type {(v: number) => string} */
export function number(v) { // four digits, as the engine prints them
  if (v === null || v === undefined) return "—";
  if (v === 0) return "0";
  const [mantissa, exponent] = v.toExponential(3).split("e"), power = +exponent;
  const short = (/** @type {string} */ t) => t.includes(".") ? t.replace(/0+$/, "").replace(/\.$/, "") : t;
  const raised = () => short(mantissa) + "·10" + String(power).replace(/./g,
    c => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(c)]);
  return local((power > -5 && power < 7 ? short(fixed(v, Math.max(3 - power, 0))) : raised()).replace("-", "−"));
}
// a scale as the engine writes it: exact, its inverse with three digits if need be
/** @type {(mu: number, inverse?: boolean) => string} */
export function scaled(mu, inverse) {
  if (!inverse) return local(String(+mu.toPrecision(12)));
  const four = +(1 / mu).toPrecision(4);
  return local(String(Math.abs(four * mu - 1) < 1e-12 ? four : +(1 / mu).toPrecision(3)));
}
// for a slot: a value, or values joined by *, after a possible minus; the sign alone; null where one fails
/** @type {(name: string, sign: boolean) => any} */
function product(name, sign) {
  const values = name.replace(/^−/, "").split("*").map(n => live.value(n));
  const signs = sign ? values.map(v => v !== null && Math.abs(v) < 1e-12 ? 1 : v && Math.sign(v)) : values;
  return values.includes(null) ? null : signs.reduce((z, v) => z * v, name[0] === "−" ? -1 : 1);
}
/** @type {(text: string) => string} */
export function filled(text) { // a sentence with its numbers, for display
  return text.replace(/⟦(\w+)¦([^¦⟧]+)(?:¦([^⟧]+))?⟧/g, (_, how, name, mu) => {
    if (how === "n") return local(name); // a number written out
    if (how === "d") return number(Math.asin(live.zone ? live.zone.least : live.sharpness(name)) * 180 / Math.PI);
    const found = product(name, how === "join" || how === "lead");
    const v = Math.abs(found) < 1e-12 ? 0 : found; // noise is zero
    if (found === null) return "—";
    if (how === "mm") return local(fixed(Math.abs(v * live.given[mu]), 1).replace(/\.0$/, ""));
    if (how === "s") return say(v > 0 ? "ccw" : v < 0 ? "cw" : "still");
    if (how === "k" || how === "i") return scaled(v, how === "i").replace("-", "−");
    if (how === "join" || how === "lead") return how === "join" ? (v < 0 ? " − " : " + ") : v < 0 ? "−" : "";
    const shown = number(how === "a" ? Math.abs(v) : v);
    return how === "b" && shown.startsWith("−") ? `(${shown})` : shown;
  });
}
/** @type {(text: string, key?: string) => string} */
export function sentence(text, key) {
  return filled(text).replace(/⟨([^⟩]*)⟩/g, (_, n) => `<i class="name" data-name="${n}">${html(n, key)}</i>`);
}
/** @type {(name: string, key?: string) => string} */
export function spoken(name, key) { return lettered(name, key).map(([t]) => t).join(""); }
/** @type {(text: string, key?: string) => string} */
export function plain(text, key) { return filled(text).replace(/⟨([^⟩]*)⟩/g, (_, n) => spoken(n, key)); }
/** @type {(key: string, seen: Set<string>) => string} */
export function described(key, seen) { // the contents of a figure, for screen readers
  const scheme = key === "position";
  const there = (/** @type {Segment} */ s) => [s.start, s.end].every(n => seen.has(`${key}:${n}`));
  const list = scheme
    ? data.scheme.links.flatMap(l => l.points).filter(n => seen.has(n) && live.at(n)).map(n => n.slice(9))
    : data.segments.filter(s => s.plan === key && there(s)).flatMap(s => s.names);
  const title = scheme ? say(SCHEME) : data.plans.find(p => p.key === key)?.title[state.lang] ?? "";
  const names = [...new Set(list)].map(n => spoken(n, key)).join(", ");
  return `${title}. ${names ? say(scheme ? "hear_points" : "hear_vectors").replace("{names}", names) :
    say("hear_nothing")}`;
}
