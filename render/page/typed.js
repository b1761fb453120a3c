// Numbers as people type them: sums, decimal commas, units.
const UNITS = /** @type {Numbers} */ ({ mm: 1e-3, "мм": 1e-3, cm: 1e-2, "см": 1e-2, in: 0.0254, ft: 0.3048, kn: 1e3,
  "кн": 1e3, g: 1e-3, "г": 1e-3, rpm: Math.PI / 30,
  "об/мин": Math.PI / 30, "об/хв": Math.PI / 30, "аб/хв": Math.PI / 30,
  "°/s": Math.PI / 180, "°/с": Math.PI / 180 });
/** A number as people type it: a sum or a quotient, a decimal comma, a unit; in SI. @type {(text: string) => number} */
export function typed(text) {
  const [, sum, unit] = text.trim().replace(/,/g, ".").match(/^([-+*/().\d\s]+(?:e-?\d+)?)\s*(\S*)$/i) ?? ["", "", ""];
  const factor = unit ? UNITS[unit.toLowerCase()] ?? (/^(m|м|rad\/s|рад\/с|n|н|kg|кг|°)$/i.test(unit) ? 1 : NaN) : 1;
  return /[\d.]\s+[\d.]/.test(sum) ? NaN : summed(sum.replace(/\s+/g, "")) * factor;
}
/** Of numbers, signs and brackets alone. @type {(text: string) => number} */
function summed(text) {
  let at = 0;
  const next = (/** @type {string} */ signs) => signs.includes(text[at] || "!") ? text[at++] : "";
  /** @type {() => number} */
  const value = () => {
    if (next("-")) return -value();
    if (next("(")) { const inner = sum(); return next(")") ? inner : NaN; }
    const found = /^(\d+\.?\d*|\.\d+)(e-?\d+)?/i.exec(text.slice(at));
    at += found ? found[0].length : text.length + 1;
    return found ? +found[0] : NaN;
  };
  /** @type {() => number} */
  const product = () => {
    let found = value();
    for (let sign; (sign = next("*/"));) found = sign === "*" ? found * value() : found / value();
    return found;
  };
  /** @type {() => number} */
  const sum = () => {
    let found = product();
    for (let sign; (sign = next("+-"));) found += sign === "+" ? product() : -product();
    return found;
  };
  const found = sum();
  return at === text.length ? found : NaN;
}
