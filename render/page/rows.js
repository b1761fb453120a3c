// Lines of calculation as mathematics: fractions, names that highlight their objects, numbers of the position.
import { safe } from "./dom.js";
import { html } from "./letters.js";
import { data, live, state } from "./page.js";
import { filled, say, sentence } from "./words.js";
const STILL_MM = 1e-4;
export const notes = /** @type {((f: Frame) => string)[]} */ ([]); // additions to a frame by other modules

/** @type {(f: Frame) => string} */
export function noted(f) { return stands(f) + notes.map(more => more(f)).join(""); } // for this position only
/** @type {(f: Frame) => string} */
function stands(f) { // the sentence that the point whose vector ends here is at rest, if it is
  const p = f.still && live.at(f.makes[0]), names = f.still;
  if (!p || Math.hypot(...p) >= STILL_MM) return "";
  return " " + say(`still_${names.said}`).replace(/{(\w+)}/g, (_, k) => names[k]);
}
/** @type {(f: Frame) => string} */
export function inWords(f) { // a frame's sentence with its lines in words
  return f.said[state.lang].replace(/⟪(\d+)⟫/g, (_, k) => rowText(f.rows[k]));
}
/** @type {(r: Row) => string} */
function unitOf(r) { return r.unit ? data.reckoned.units[r.unit][state.lang] : ""; }
/** @type {(r: Row) => string} */
function rowText(r) { // in the engine's wording
  if (!r.numbers) return `⟨${r.name}⟩ = 0`;
  const head = r.head || `⟨${r.name}⟩`, found = head.includes("·") ? `; ⟨${r.name}⟩` : "", unit = unitOf(r);
  const arm = r.arm ? ` (⟨${r.arm}⟩ = ⟦a¦${r.arm}⟧ ${data.reckoned.units.m[state.lang]})` : "";
  const places = /** @type {Record<string, any>} */ ({ ...r, head, found, unit, arm });
  const text = data.reckoned.words[r.kind || "formula"][state.lang].replace(/{(\w+)}/g, (_, k) => places[k]);
  return text + (r.turns ? ` (⟦s¦${r.name}⟧)` : "");
}
/** @type {(f: Frame) => string} */
export function typeset(f) { // the action, the lines beneath each other, the remarks
  if (!f.rows.length) return sentence(f.said[state.lang], f.plan);
  const [lead, ...tail] = f.said[state.lang].split(/⟪\d+⟫(?:; ⟪\d+⟫)*/);
  const rest = tail.join("").replace(/^[.;:,]\s*/, "");
  const rows = f.rows.map(r => `<div>${setLine(r, f.plan)}</div>`).join("");
  const many = f.rows.length > 3 ? " many" : "";
  return `${sentence(lead, f.plan)}<div class="rows${many}">${rows}</div>${sentence(rest, f.plan)}`;
}
/** @type {(r: Row, key: string) => string} */
function setLine(r, key) { // name = letters = numbers = value unit, with possible line breaks between the pieces
  const unit = `<mspace width=".2em"/><mtext>${safe(unitOf(r))}</mtext>`;
  const sign = r.turns ? `<span class="sense">${sentence(`(⟦s¦${r.name}⟧)`, key)}</span>` : "";
  const value = `<mo>=</mo>${added(filled(r.value), key)}${unit}`, name = `⟨${r.name}⟩`;
  if (!r.numbers) return math(`${added(name, key)}<mo>=</mo><mn>0</mn>`);
  if (r.kind === "measured" && filled(r.letters) === "0")
    return math(added(name, key)) + `<span>${say("too_small")}</span>`;
  if (r.kind === "measured") {
    const mm = `${added(filled(r.letters), key)}<mspace width=".2em"/><mtext>${safe(say("millimetres"))}</mtext>`;
    const by = r.numbers.slice(2);
    const read = r.numbers[0] === "/" ? `<mfrac><mrow>${mm}</mrow><mrow>${added(filled(by), key)}</mrow></mfrac>`
      : `${mm}<mo>·</mo>${added(filled(by), key)}`;
    return math(added(name, key)) + math(`<mo>=</mo>${read}`) + math(value) + sign;
  }
  const head = r.head || name, sides = [r.letters, r.numbers].map(t => wrapped(filled(t), key)).join("");
  const arm = r.arm ? math(`<mo>(</mo>${added(filled(`⟨${r.arm}⟩ = ⟦a¦${r.arm}⟧`), key)}<mo>)</mo>`) : "";
  const again = head !== name ? `<b></b>${math(added(name, key))}` : "";
  return math(added(head, key)) + sides + arm + again + math(value) + sign;
}
/** @type {(text: string, key: string) => string} */
function wrapped(text, key) { // a side, each of its terms a piece
  const found = pieces(text, [" + ", " − "]);
  const one = (/** @type {string} */ t, /** @type {number} */ k) =>
    math(`<mo form="infix">${k ? found[2 * k - 1].trim() : "="}</mo>${added(t, key)}`);
  return found.filter((_, k) => k % 2 === 0).map(one).join("");
}
/** @type {(inner: string) => string} */
function math(inner) { return `<math displaystyle="true"><mrow>${inner}</mrow></math>`; }
/** @type {(text: string, by: string[]) => string[]} */
function pieces(text, by) { // at a sign outside brackets
  const found = [""];
  let deep = 0;
  for (const piece of text.split(/( [·+−/=] |[()])/)) {
    if (piece === "(") deep++; else if (piece === ")") deep--;
    if (!deep && by.includes(piece)) found.push(piece, ""); else found[found.length - 1] += piece;
  }
  return found;
}
/** @type {(text: string, key: string) => string} */
function added(text, key) {
  const minus = '<mo form="prefix">−</mo>';
  const signed = (/** @type {string} */ t) => t[0] === "−" && t.length > 1 ? minus + quotient(t.slice(1), key) :
    quotient(t, key);
  return pieces(text, [" + ", " − ", " = "]).map((t, k) => k % 2 ? `<mo>${t.trim()}</mo>` : signed(t)).join("");
}
/** @type {(text: string, key: string) => string} */
function quotient(text, key) {
  const bare = (/** @type {string} */ t) => /^\([^()]*\)$/.test(t) && t.includes(" ") ? t.slice(1, -1) : t;
  const [above, , below] = pieces(text, [" / "]);
  const all = (/** @type {string} */ t) => `<mrow>${multiplied(t, key)}</mrow>`;
  return below ? `<mfrac>${all(above)}${all(bare(below))}</mfrac>` : multiplied(above, key);
}
/** @type {(text: string, key: string) => string} */
function multiplied(text, key) {
  return pieces(text, [" · "]).map((t, k) => k % 2 ? "<mo>·</mo>" : factorOf(t, key)).join("");
}
/** @type {(text: string, key: string) => string} */
function factorOf(text, key) {
  const m = /^(∣?)⟨([^⟩]*)⟩(∣?)([²³]?)$/.exec(text);
  if (!m) return /[0-9—]/.test(text) ? `<mn>${safe(text)}</mn>` : `<mtext>${sentence(text, key)}</mtext>`;
  const name = `<mtext><i class="name" data-name="${m[2]}">${html(m[2], key)}</i></mtext>`;
  const bar = m[1] ? "<mo>|</mo>" : "";
  const one = `<mrow>${bar}${name}${bar}</mrow>`;
  return m[4] ? `<msup>${one}<mn>${"²³".indexOf(m[4]) + 2}</mn></msup>` : one;
}
