// Marks that the pointer or the arrow keys move, each an element with its name; the one in hand keeps the focus.
import { on } from "./dom.js";

const WAYS = /** @type {Record<string, Spot>} */ ({ ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1],
  ArrowDown: [0, 1] }); // y down
/** @type {(e: Event) => string | null} */
const markOf = e => /** @type {any} */ (e.target).closest("[data-mark]")?.dataset.mark || null;

export class Handles {
  held = /** @type {string | null} */ (null);
  dragged = false;
  /** A figure, and what moves its marks: to the place of the pointer, or by a step of a key.
   * @param {any} node @param {(name: string, e: MouseEvent) => void} drag
   * @param {(name: string, way: Spot, e: KeyboardEvent) => void} step */
  constructor(node, drag, step) {
    this.node = node;
    on(node, "pointerdown", e => {
      const name = markOf(e);
      if (!name) return;
      this.held = name;
      this.dragged = true;
      node.setPointerCapture(e.pointerId);
      e.preventDefault();
      this.focus();
    });
    on(node, "pointermove", e => { if (this.dragged && this.held) drag(this.held, e); });
    for (const end of ["pointerup", "pointercancel"]) on(node, end, () => { this.dragged = false; });
    on(node, "keydown", e => {
      const name = markOf(e);
      if (!WAYS[e.key] || !name) return;
      e.preventDefault();
      this.held = name;
      step(name, WAYS[e.key], e);
    });
    on(node, "focusin", e => { this.held = markOf(e) || this.held; });
    on(node, "focusout", () => { if (!this.dragged) this.held = null; });
  }
  focus() { this.node.querySelector(`[data-mark="${CSS.escape(this.held || "")}"]`)?.focus({ preventScroll: true }); }
  /** Draws the figure anew, which loses the focus. @type {(draw: () => void) => void} */
  redraw(draw) {
    const now = this.held;
    draw();
    this.held = now;
    if (now) this.focus();
  }
}
