// What a hand takes hold of in a figure: the mark under it, the numbers that follow, what is said where they cannot.
import { on } from "./dom.js";
import { keyOf, labelOf } from "./letters.js";
import { REACHED } from "./live.js";
import { data, live } from "./page.js";
import { fixed, local, say, sentence } from "./words.js";
const GRIP_PX = 16, GRIP_TOUCH_PX = 30;

export function allowed(knob,
  v) { return Number.isFinite(v) && (v > 0 || (v < 0 && knob.at < 0) || !/^(l_|mu_)/.test(knob.given)); }
export function aimedAt(given) { return given.startsWith("angle_∠"); }
// from a third of a number to three times; about nothing as far as others of its kind
export function span({ given, at, reach }) { return aimedAt(given) ? [at - 60, at + 60] : at ?
  [at / 3, 3 * at].sort((a, b) => a - b) : [-reach, reach]; }
export function listed(names) {
  const said = n => n === data.drive.given ? data.drive.symbol :
    (data.knobs.find(k => k.given === n) || { name: n }).name;
  return names.map(n => `⟨${said(n)}⟩`).join(", ");
}
// the mechanism follows, or it is said how far it cannot; a crank alone only points to the hand
export function pulled(mark, names, target) {
  const moved = names.length && data.marks[mark] && live.turns(mark, names).flat().some(Boolean);
  const short = moved ? live.follow(mark, names, target) : Infinity;
  live.set({ [data.drive.given]: live.placed(live.drive) });
  const list = listed(names), aims = moved && names.length === 1 && names[0] === data.drive.given;
  const end = `⟨${labelOf(mark)}⟩`;
  const text = say(short <= REACHED || aims ? "follows" : Number.isFinite(short) ? "follows_not" :
    "follows_none").replace("{mark}", end).replace("{names}", list).replace("{mm}", local(fixed(short, 2)));
  return { short, text: sentence(text, keyOf(mark)) };
}
function grip(figure, event, marks) { // the mark under the hand
  const r = figure.node.getBoundingClientRect(), q = [event.clientX - r.left, event.clientY - r.top];
  const near = event.pointerType === "touch" ? GRIP_TOUCH_PX : GRIP_PX;
  let best = null;
  for (const m of marks) {
    const p = figure.at(m), d = p ? Math.hypot(figure.px(p)[0] - q[0], figure.px(p)[1] - q[1]) : near;
    if (d < near && (!best || d < best.d - 0.5)) best = { mark: m, d };
  }
  return best && best.mark;
}
// a figure whose marks are dragged; its view, and what a drag changes, stand still meanwhile
export function grips(figure, marks, drag, done, hold = (_mark, _event) => []) {
  const node = figure.node;
  on(node, "pointerdown", e => {
    const mark = e.button === 0 && grip(figure, e, marks());
    if (!mark) return;
    node.setPointerCapture(e.pointerId);
    node.held = { mark, names: hold(mark, e), k: figure.k, dx: figure.dx, dy: figure.dy };
    figure.fixed_view = node.held;
    e.preventDefault();
  });
  on(node, "touchstart", e => { if (node.held) e.preventDefault(); }, { passive: false });
  on(node, "pointermove", e => {
    if (!node.held) { node.style.cursor = e.pointerType !== "touch" && grip(figure, e, marks()) ? "grab" : ""; return; }
    const r = node.getBoundingClientRect();
    drag(node.held.mark, figure.mm([e.clientX - r.left, e.clientY - r.top]), node.held.names);
  });
  for (const end of ["pointerup", "pointercancel"]) on(node, end,
    () => { if (node.held) done(); node.held = figure.fixed_view = null; });
}
