// The reader's changes, one step for each action: undo all of them, and redo.
import { live } from "./page.js";

const past = /** @type {any[]} */ ([]), future = /** @type {any[]} */ ([]);
let last = { ...live.given };
/** What was typed for a number, by its name. */
export const figures = /** @type {Record<string, { value: number, text: string }>} */ ({});

const same = () => Object.keys(last).every(n => last[n] === live.given[n]);
function announced() { // the studio writes it into the scene
  const numbers = Object.fromEntries(Object.entries(live.given).filter(([n, v]) => last[n] !== v));
  dispatchEvent(new CustomEvent("rested", { detail: { numbers, figures } }));
}
export function rested() { // an action has ended: its changes are one step
  if (same()) return;
  announced();
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
  live.back(from.pop());
  announced();
  last = { ...live.given };
  return true;
}
export const undo = () => went(past, future), redo = () => went(future, past);
export const nothing = () => [!past.length && same(), !future.length || !same()]; // undo, redo
