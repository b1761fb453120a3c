// Dragging in a figure: the mark under the pointer, the numbers that follow, the sentence where they cannot.
import { on } from "./dom.js";
import { keyOf, labelOf } from "./letters.js";
import { REACHED } from "./live.js";
import { data, live } from "./page.js";
import { fixed, local, say, sentence } from "./words.js";
const GRIP_PX = 16, GRIP_TOUCH_PX = 30, IDLE_MM = 1e-6; // a smaller effect on a mark counts as none

/** @type {(knob: Knob, v: number) => boolean} */
export function allowed(knob, v) {
  return Number.isFinite(v) && (v > 0 || (v < 0 && knob.at < 0) || !/^(l_|mu_)/.test(knob.given));
}
/** @type {(given: string) => boolean} */
export function aimedAt(given) { return given.startsWith("angle_∠"); }
// from a third of a number to three times; about zero as far as others of its kind
/** @type {(knob: Knob) => number[]} */
export function span({ given, at, reach }) {
  if (aimedAt(given)) return [at - 60, at + 60];
  return at ? [at / 3, 3 * at].sort((a, b) => a - b) : [-reach, reach];
}
/** @type {(names: string[]) => string} */
const listed = names => names.map(n => `⟨${n === data.drive.given ? data.drive.symbol :
  data.knobs.find(k => k.given === n)?.name ?? n}⟩`).join(", ");
// the numbers a drag changes, chosen at its start: the crank's end turns the crank, with Shift its length changes
/** @type {(mark: string, chosen: string, shift: boolean) => string[]} */
export function handlesOf(mark, chosen, shift) {
  const own = data.drags[mark], { given, held } = data.drive, some = own?.filter(n => n !== given);
  const turned = own?.length > some?.length && !held && !(shift && some.length);
  const names = turned ? [given] : some || live.handles(mark, chosen);
  const free = names.filter(n => live.turns(mark, [n]).flat().some(v => Math.abs(v) > IDLE_MM));
  return free.length ? free : names;
}
/** @type {(mark: string, names: string[], short?: number) => string} */
export function naming(mark, names, short = 0) { // the change, or the distance by which a mark misses its place
  const others = names[0] === data.drive.given && names.length === 1 ?
    data.drags[mark]?.filter(n => n !== names[0]) : [];
  const key = short === Infinity ? "follows_none" : others?.length ? "follows_shift" :
    short <= REACHED ? "follows" : "follows_not";
  const text = say(key).replace("{mark}", `⟨${labelOf(mark)}⟩`).replace("{names}", listed(names));
  return sentence(text.replace("{others}", listed(others || [])).replace("{mm}", local(fixed(short, 2))), keyOf(mark));
}
/** @type {(mark: string, names: string[], target: Spot) => { short: number, text: string }} */
export function pulled(mark, names, target) { // the mechanism follows, or the sentence says by how much it cannot
  const moved = names.length && data.marks[mark] && live.turns(mark, names).flat().some(Boolean);
  const short = moved ? live.follow(mark, names, target) : Infinity;
  return { short, text: naming(mark, names, short) };
}
/** @type {(figure: any, event: PointerEvent, marks: string[]) => any} */
function grip(figure, event, marks) { // the mark under the pointer
  const r = figure.node.getBoundingClientRect(), q = [event.clientX - r.left, event.clientY - r.top];
  const near = event.pointerType === "touch" ? GRIP_TOUCH_PX : GRIP_PX;
  let best = null;
  for (const m of marks) {
    const p = figure.at(m), d = p ? Math.hypot(figure.px(p)[0] - q[0], figure.px(p)[1] - q[1]) : near;
    if (d < near && (!best || d < best.d - 0.5)) best = { mark: m, d };
  }
  return best && best.mark;
}
// a figure with marks to drag: the mark decides which numbers change; its view stays fixed meanwhile
/** @type {(figure: any, marks: () => string[], take: (mark: string, shift: boolean) => string[],
 * drag: (mark: string, names: string[], place: Spot) => void, done: () => void) => void} */
export function grips(figure, marks, take, drag, done) {
  const node = figure.node;
  on(node, "pointerdown", e => {
    const mark = e.button === 0 && grip(figure, e, marks());
    if (!mark) return;
    node.setPointerCapture(e.pointerId);
    node.held = { mark, names: take(mark, e.shiftKey), k: figure.k, dx: figure.dx, dy: figure.dy };
    figure.fixed_view = node.held;
    e.preventDefault();
  });
  on(node, "touchstart", e => { if (node.held) e.preventDefault(); }, { passive: false });
  on(node, "pointermove", e => {
    if (!node.held) { node.style.cursor = e.pointerType !== "touch" && grip(figure, e, marks()) ? "grab" : ""; return; }
    const r = node.getBoundingClientRect();
    drag(node.held.mark, node.held.names, figure.mm([e.clientX - r.left, e.clientY - r.top]));
  });
  for (const end of ["pointerup", "pointercancel"]) on(node, end,
    () => { const was = node.held; node.held = figure.fixed_view = null; if (was) done(); });
}
