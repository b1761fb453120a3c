// Fresh numbers for a practice: the same for a seed in every page, and where its code is read again.
import { data, live } from "./page.js";

/** @type {(seed: number) => () => number} */
function random(seed) { // a stream of numbers from 0 to 1: mulberry32
  let a = seed >>> 0;
  return () => {
    a = a + 0x6D2B79F5 >>> 0;
    let t = Math.imul(a ^ a >>> 15, a | 1);
    t ^= t + Math.imul(t ^ t >>> 7, t | 61);
    return ((t ^ t >>> 14) >>> 0) / 4294967296;
  };
}
// other numbers near the scene's, with which everything can be drawn; false where there are none
/** @type {(seed: number, size: (key: string) => number) => boolean} */
export function fresh(seed, size) {
  const { given, symbol, held, at, from, to } = data.drive, sizes = () => data.plans.map(p => size(p.key));
  const blunt = () => Math.min(...Object.keys(data.sharp).map(m => live.sharpness(m)));
  const home = sizes(), sharp = blunt();
  for (let k = 0; k < data.judging.draws; k++) {
    const draw = random(seed * data.judging.draws + k), numbers = /** @type {Record<string, any>} */ ({});
    for (const n of data.knobs) if (!n.plan &&
      !n.stays) numbers[n.given] = +(n.at * (1 + data.judging.fresh * (2 * draw() - 1))).toPrecision(3);
    if (!held) numbers[given] = symbol === "φ" ? Math.round(at + data.judging.swing * (2 * draw() - 1)) :
      +(at + (to - from) / 20 * (2 * draw() - 1)).toPrecision(3);
    live.back(data.home);
    live.set(numbers);
    const now = live.failed ? [] : sizes();
    if (now.length && now.every((s, i) => s >= 0.5 * home[i] && s <= 1.8 * home[i]) &&
      !(blunt() < 0.5 * sharp)) return true;
  }
  live.back(data.home);
  return false;
}
