// Numbers as people type them: sums, decimal commas, units.
const UNITS = /** @type {Record<string, string>} */ ({ mm: "0.001", "мм": "0.001", cm: "0.01", "см": "0.01",
  in: "0.0254", ft: "0.3048", kn: "1000", "кн": "1000", g: "0.001", "г": "0.001", rpm: "pi/30",
  "об/мин": "pi/30", "об/хв": "pi/30", "аб/хв": "pi/30", "°/s": "pi/180", "°/с": "pi/180" });
const OF_SI = /^(|m|м|rad\/s|рад\/с|n|н|kg|кг|°)$/i;
/** A sum as people type it, without spaces, and the factor of its unit. @type {(text: string) => string[]} */
function parted(text) {
  const [, sum, unit] = text.trim().replace(/,/g, ".").match(/^([-+*/().\d\s]+(?:e-?\d+)?)\s*(\S*)$/i) ?? ["", "", ""];
  const factor = OF_SI.test(unit) ? "1" : UNITS[unit.toLowerCase()] ?? "";
  return [/[\d.]\s+[\d.]/.test(sum) ? "" : sum.replace(/\s+/g, ""), factor];
}
/** A number as people type it: a sum or a quotient, a decimal comma, a unit; in SI. @type {(text: string) => number} */
export function typed(text) {
  const [sum, factor] = parted(text);
  return factor ? summed(sum) * summed(factor.replace("pi", String(Math.PI))) : NaN;
}
/** The same number as a scene says it, in the figures that were typed. @type {(text: string) => string} */
export function asTyped(text) {
  const [sum, factor] = parted(text);
  return factor === "1" ? sum : `${/.[-+/]/.test(sum) ? `(${sum})` : sum}*${factor}`;
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
