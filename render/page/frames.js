// The frames of the lesson: the drawing so far, and the frame in which a value or a vector first appears.
import { data } from "./page.js";

const values = /** @type {Record<string, any>} */ ({}), births = /** @type {Record<string, any>} */ ({});
const starts = /** @type {Record<string, number>} */ ({});

/** @type {(frame: number) => Set<string>} */
export function seenAt(frame) {
  const seen = new Set(["position:p"]);
  for (const f of data.frames.slice(0, frame + 1)) for (const m of f.makes) seen.add(m);
  return seen;
}
/** @type {(frame: number) => string} */
export function planOf(frame) { // the plan on the right: that of this frame, or the last one begun
  const shown = (/** @type {string} */ p) => p !== "position" && begunAt(p) <= frame;
  for (let k = frame; k >= 0; k--) if (shown(data.frames[k].plan)) return data.frames[k].plan;
  return "position";
}
/** @type {(plan: string) => number} */
function begunAt(plan) { // the frame that makes its first mark
  return starts[plan] ??= data.frames.findIndex(f => f.plan === plan && f.makes.length);
}
/** @type {(name: string) => number} */
export function found(name) { // the frame in which a value first appears
  return values[name] ??= data.frames.findIndex(f => f.tells.includes(name));
}
/** @type {(name: string, key: string) => number} */
export function born(name, key) { // the frame of its plan in which a vector first appears
  return births[`${key} ${name}`] ?? -1;
}
data.frames.forEach((f, k) => {
  if (f.moments === null && k >= begunAt(f.plan)) for (const t of f.terms) births[`${f.plan} ${t}`] ??= k;
});
for (const s of data.segments) { // a vector in no frame appears with its end mark
  const k = data.frames.findIndex(f => f.makes.includes(`${s.plan}:${s.end}`));
  for (const n of s.names) births[`${s.plan} ${n}`] ??= k;
}
