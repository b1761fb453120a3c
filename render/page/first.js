// At first sight: three marks that show what can be dragged; gone for good after the first drag on this machine.
import { remember, remembered } from "./memory.js";
import { holders } from "./sketch.js";
import { svg } from "./svg.js";

const ONCE = "planes.dragged", MARKS = 3, ARROWS = "M-19 0l6 -5v10zM19 0l-6 -5v10zM0 -19l-5 6h10zM0 19l-5 -6h10z";
let known = false;

export function taught() {
  if (known) return;
  known = true;
  remember(ONCE, 1);
}
/** Hinges of two links first, then those of the frame.
 * @type {(parent: Element, sketch: Sketch, view: View) => void} */
export function marked(parent, sketch, view) {
  if (known ||= !!remembered(ONCE, 0)) return;
  const rank = (/** @type {string} */ p) => sketch.fixed.includes(p) ? 1 : 2 * +(holders(sketch, p).length < 2);
  const some = Object.keys(sketch.links).length ? Object.keys(sketch.points).sort((a, b) => rank(a) - rank(b)) : [];
  for (const p of some.slice(0, MARKS)) {
    const [x, y] = view.px(sketch.points[p]);
    svg("path", { d: ARROWS, class: "draggable", "aria-hidden": "true", transform: `translate(${x} ${y})` }, parent);
  }
}
