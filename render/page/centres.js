// Instantaneous centres, if requested: their lines and those found so far on the scheme, and the sentence about
// one that cannot be seen.
import { clamp, distance } from "./geometry.js";
import { labelOf } from "./letters.js";
import { data, later, live, state } from "./page.js";
import { notes } from "./rows.js";
import { overlays } from "./scheme.js";
import { circle } from "./svg.js";
const PAST_PX = 26, MOST_PX = 4000, CLOSE_PX = 6;

// whether a centre lies within the scheme shown
let onSheet = /** @type {(mark: string) => boolean} */ (() => true);

/** @type {(figure: any, p: Spot, u: Spot, through: Spot[]) => void} */
function lineOf(figure, p, u, through) { // a line through its centres and slightly beyond
  const along = [0, ...through.map(q => (q[0] - p[0]) * u[0] + (q[1] - p[1]) * u[1])];
  const ends = [Math.min(...along) - PAST_PX, Math.max(...along) + PAST_PX].map(t => clamp(t, -MOST_PX, MOST_PX));
  const [low, high] = ends.map(t => [p[0] + t * u[0], p[1] + t * u[1]]);
  figure.line(low, high, "centre-line");
}
/** @type {(figure: any, frame: Frame) => void} */
function linesOf(figure, frame) {
  const made = figure.spot(frame.makes[0]);
  for (const [from, by] of data.centres[frame.makes[0]]) {
    const p = figure.spot(from), q = by.includes(":") ? figure.spot(by) : null, angle = live.angle(by);
    const a = q ? Math.atan2(q[1] - p?.[1], q[0] - p?.[0]) : angle === null ? NaN : -angle * Math.PI / 180;
    if (p && Number.isFinite(a)) lineOf(figure, p, [Math.cos(a), Math.sin(a)], [q, made].filter(Boolean));
  }
}
/** @type {(figure: any, frame: any, seen: Set<string>) => void} */
function showCentres(figure, frame, seen) {
  if (frame?.chapter !== "centres") return;
  onSheet = mark => { const q = figure.spot(mark);
    return !q || (q[0] >= 0 && q[1] >= 0 && q[0] <= figure.w && q[1] <= figure.h); };
  if (data.centres[frame.makes[0]]) linesOf(figure, frame);
  const groups = /** @type {{ q: Spot, names: string[] }[]} */ ([]);
  for (const mark of Object.keys(data.centres).filter(n => seen.has(n) && figure.spot(n) && onSheet(n))) {
    const q = figure.spot(mark), lit = [...frame.makes, ...frame.uses].includes(mark);
    circle(q, 4, `centre${lit ? " lit" : ""}`, figure.node);
    const same = groups.find(g => distance(g.q, q) < CLOSE_PX);
    if (same) same.names.push(labelOf(mark)); else groups.push({ q, names: [labelOf(mark)] });
  }
  for (const g of groups) figure.beside(g.q, g.names, "position", 9, g.names.map(n => `position:${n}`).join(" "));
}
/** @type {(f: Frame) => string} */
function centreNoted(f) { // why a centre cannot be seen
  const mark = f.makes[0], found = f.chapter === "centres" && data.centres[mark];
  if (!found || !found.length) return "";
  const there = found.every(([a, b]) => live.at(a) && (b.includes(":") ? live.at(b) : live.angle(b) !== null));
  const key = live.at(mark) ? onSheet(mark) ? "" : "off" : there ? "parallel" : "lost";
  return key && " " + data.noted[key][state.lang].replace("{name}", labelOf(mark));
}
overlays.push(showCentres);
notes.push(centreNoted);
later();
