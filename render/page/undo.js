// What the reader has changed, a step for each move of the hand: back as many as there were, and forth again.
import { live } from "./page.js";

const past = /** @type {any[]} */ ([]), future = /** @type {any[]} */ ([]);
let last = { ...live.given };

const same = () => Object.keys(last).every(n => last[n] === live.given[n]);
export function rested() { // a move has ended: what it changed is one step
  if (same()) return;
  past.push(last);
  future.length = 0;
  last = { ...live.given };
}
export function forget() { // from here on
  past.length = future.length = 0;
  last = { ...live.given };
}
/** @type {(from: Numbers[], to: Numbers[]) => boolean} */
function went(from, to) {
  rested();
  if (!from.length) return false;
  to.push(last);
  last = from.pop();
  live.back(last);
  return true;
}
export const undo = () => went(past, future), redo = () => went(future, past);
export const nothing = () => [!past.length && same(), !future.length || !same()]; // to undo, to do again
