// The frames of the lesson: what is drawn so far, and the frame in which a value or a vector is first told.
import { data } from "./page.js";

const values = /** @type {Record<string, any>} */ ({}), births = /** @type {Record<string, any>} */ ({});

/** @type {(frame: number) => Set<string>} */
export function seenAt(frame) {
  const seen = new Set(["position:p"]);
  for (const f of data.frames.slice(0, frame + 1)) for (const m of f.makes) seen.add(m);
  return seen;
}
/** @type {(frame: number) => string} */
export function planOf(frame) { // the plan on the right: of this frame, or the last one that was not the scheme
  for (let k = frame; k >= 0; k--) if (data.frames[k].plan !== "position") return data.frames[k].plan;
  return "position";
}
/** @type {(name: string) => number} */
export function found(name) { // the frame in which a value is first told
  return values[name] ??= data.frames.findIndex(f => ["v", "a"].some(how => f.said.en.includes(`⟦${how}¦${name}⟧`)));
}
/** @type {(name: string, key: string) => number} */
export function born(name, key) { // the frame of its plan in which a vector is first in hand
  return births[`${key} ${name}`] ?? -1;
}
data.frames.forEach((f, k) => { if (f.moments === null) for (const t of f.terms) births[`${f.plan} ${t}`] ??= k; });
for (const s of data.segments) { // what no frame speaks of is there with its end
  const k = data.frames.findIndex(f => f.makes.includes(`${s.plan}:${s.end}`));
  for (const n of s.names) births[`${s.plan} ${n}`] ??= k;
}
