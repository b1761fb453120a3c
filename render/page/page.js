// The contents and state of the page: words, data, the program at work, the current frame and language.
// A page within the studio has words alone: the data are those of the current scene.
import { $ } from "./dom.js";
import { LOOKS, Live } from "./live.js";

/** @type {[Record<string, Said>, LessonData]} */
export const [brought, own] = JSON.parse($("brought").textContent);
export const words = brought, data = own ?? parent.planes.lesson.data;
export const live = new Live(data, LOOKS); // the whole turn is computed after the first picture
export const state = {
  frame: 0, lang: document.documentElement.lang, timer: 0, spin: 0, waiting: false, practising: false, seed: 0,
  coloured: false,
};
let painted = () => {};

/** @type {(paint: () => void) => void} */
export function paintedBy(paint) { painted = paint; }
export function draw() {
  state.waiting = false;
  painted();
}
export function later() { // with the next picture of the screen
  if (!state.waiting) { state.waiting = true; requestAnimationFrame(draw); }
}
