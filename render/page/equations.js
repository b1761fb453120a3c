// The equations of a plan: vectors with small segments, their known parts, lines of action.
import { born } from "./frames.js";
import { distance } from "./geometry.js";
import { html } from "./letters.js";
import { data, live } from "./page.js";
import { MM, head, headSize } from "./signs.js";
import { say } from "./words.js";

const SHARE = 0.6; // of true mm

/** @type {(f: Frame, key: string, frame: number, asked: any) => string} */
export function written(f, key, frame, asked) { // the equations of a plan: those begun, the current one framed
  const stated = (/** @type {number} */ k) => data.frames.findIndex(g => g.key === "equation" && g.equation === k);
  const begun = (/** @type {Equation} */ e, /** @type {number} */ k) => key.startsWith("force") ? stated(k) <= frame :
    terms(e).some(t => t.action !== "=0" && born(t.name, key) <= frame);
  const own = (/** @type {Equation} */ e) => f.terms.length && terms(e).some(t => f.terms.includes(t.name));
  const index = f.equation !== null ? f.equation : data.equations.findIndex(e => e.plan === key && own(e));
  return data.equations.map((e, k) => e.plan === key && key !== "position" && (begun(e, k) || k === f.equation) &&
    !asked?.waits("first", k) ?
    lines(e, !asked && k === index, f, frame, asked) : "").join("");
}
/** @type {(e: Equation) => Term[]} */
export function terms(e) { return e.sides.flat(); }
/** @type {(e: Equation, current: boolean, f: Frame, frame: number, asked?: any) => string} */
export function lines(e, current, f, frame, asked) {
  const one = (/** @type {Term} */ t) => term(t, e.plan, f, frame, asked);
  const sign = (/** @type {string} */ s) => `<span class="sign">${s}</span>`;
  /** @type {(list: Term[]) => string} */
  const side = list => list.map((t, k) => (t.minus ? sign("−") : k ? sign("+") : "") + one(t)).join("");
  const first = e.total ? one(e.total) + sign("=") : "";
  const rows = e.sides.filter(s => s.length).map((s,
    k) => `<div class="side">${k ? sign("=") : first}${side(s)}</div>`);
  const body = e.closed ? `<div class="side">${side(e.sides.flat())}${sign("= 0")}</div>` :
    rows.join("");
  return `<div class="equation${current ? " current" : ""}">${body}</div>`;
}
/** @type {(t: Term, key: string, f: Frame, frame: number, asked: Asking) => string} */
function term(t, key, f, frame, asked) { // a vector: a small segment, its letters, underlines, line of action
  const lit = !asked && f.terms.includes(t.name), later = born(t.name, key) > frame - (asked ? 1 : 0);
  const secret = asked && later; // for the reader to find
  const action = secret ? "" : t.action === "=0" ? "= 0" : t.action === "↓" ? "↓" : acted(t.action);
  const known = secret || asked?.asking(t.name) ? asked.given(t.name) : t.known;
  return `<span class="term known${known}${lit ? " lit" : ""}${later ? " later" : ""}" data-name="${t.name}">` +
    `${secret ? '<svg class="mini"></svg>' : mini(t, later)}<b>${html(t.name,
      key)}</b><span class="sr"> (${say("known" + known)})</span><small>${action}</small></span>`;
}
/** @type {(text: string) => string} */
function acted(text) { return text.replace(/^([-+])([va]q?_\w+)$/,
  (_, s, v) => `${s === "-" ? "↑↓" : "↑↑"} ${html(v)}`); }
// the segment itself, as small as a word: an arrow, or only its line while its length is unknown
/** @type {(t: Term, later: boolean) => string} */
function mini(t, later) {
  const s = /** @type {any} */ (t.start ? t : data.segments.find(s => s.names.includes(t.name)) || {});
  const full = (/** @type {string} */ n) => n && (n.includes(":") ? n : `${s.plan}:${n}`), a = live.at(full(s.start));
  const b = live.at(full(s.end));
  const n = a && b ? distance(a, b) : 0;
  if (n < 1e-6) return '<svg class="mini"></svg>';
  const ux = (b[0] - a[0]) / n, uy = (a[1] - b[1]) / n;
  const h = Math.min(19 / Math.max(Math.abs(ux), 1e-6), 8 / Math.max(Math.abs(uy), 1e-6), 19);
  const ray = later && t.known < 2, size = ray ? [0, 0] : headSize(2 * h, SHARE * MM, "thick"), end = h - 0.8 * size[0];
  const f = (/** @type {number} */ v) => v.toFixed(1), tip = [22 + ux * h, 10 + uy * h];
  const line = `<line x1="${f(22 - ux * h)}" y1="${f(10 - uy * h)}" x2="${f(22 + ux * end)}" y2="${f(10 + uy * end)}"`;
  const drawn = !ray ? `${line}/><polygon points="${head(tip, [ux, uy], size)}"/>` :
    t.known ? `${line} class="ray"/>` : "";
  return `<svg class="mini" viewBox="0 0 44 20" style="--share: ${SHARE}">${drawn}</svg>`;
}
