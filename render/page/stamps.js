// Stamps: the groups of two links, a motor in a hinge, a cylinder; each joined to what is at its two ends.
import { along, distance, heading } from "./geometry.js";
import { guideAt, holders, linkOf, onGuide, pointAt } from "./sketch.js";

const WAY_DEG = 15, LONG = 1.5, BEYOND = 0.5, TURNED_DEG = 60, TURNS = 10, STRETCHES = 0.1; // rad/s, m/s
export const GROUPS = ["RRR", "RRP", "RPR", "PRP", "RPP"], STAMPS = [...GROUPS, "motor", "cylinder"];

/** A hinge at an end: the point there, a new point of the link there, or one of the frame.
 * @type {(sketch: Sketch, end: End) => string} */
function hinge(sketch, end) {
  if (end.point) return end.point;
  const name = pointAt(sketch, end.at);
  if (end.link) sketch.links[end.link].points.push(name); else sketch.fixed.push(name);
  return name;
}
/** A guide at an end: the one there, or a new one of what is there.
 * @type {(sketch: Sketch, end: End, angle: number) => any} */
function rail(sketch, end, angle) {
  const moving = end.link || (!sketch.fixed.includes(end.point) && holders(sketch, end.point)[0]) || "0";
  const name = end.guide || guideAt(sketch, end.at, Math.round(angle / WAY_DEG) * WAY_DEG, moving);
  return { name, guide: sketch.guides[name], own: moving !== "0" && !end.guide };
}
/** @type {Record<string, (sketch: Sketch, from: End, to: End, by: number) => boolean>} */
const MADE = {
  RRR(sketch, from, to, by) { // two links of one length
    const [a, b] = [hinge(sketch, from), hinge(sketch, to)], [p, q] = [from.at, to.at], half = distance(p, q) / 2;
    const long = Math.ceil(LONG * half / by) * by, middle = [(p[0] + q[0]) / 2, (p[1] + q[1]) / 2];
    const inner = pointAt(sketch, along(middle, Math.sqrt(long ** 2 - half ** 2), heading(p, q) + 90));
    linkOf(sketch, [a, inner]);
    linkOf(sketch, [b, inner]);
    return true;
  },
  RRP(sketch, from, to, by) { // a rod of whole length
    const way = heading(from.at, to.at), { name, guide, own } = rail(sketch, to, way), a = hinge(sketch, from);
    const beyond = own ? BEYOND * distance(from.at, to.at) : 0;
    const meant = along(onGuide(guide, to.at), beyond, guide.angle);
    const foot = onGuide(guide, from.at), high = distance(foot, from.at);
    const long = Math.round(distance(from.at, meant) / by) * by, far = Math.sqrt(long ** 2 - high ** 2);
    const inner = pointAt(sketch, far > by ? along(foot, far, heading(foot, meant)) : meant);
    linkOf(sketch, [a, inner]);
    linkOf(sketch, [inner], name);
    return true;
  },
  RPR(sketch, from, to) {
    const a = hinge(sketch, from), lever = linkOf(sketch, [hinge(sketch, to)]);
    linkOf(sketch, [a], guideAt(sketch, to.at, heading(to.at, from.at), lever));
    return true;
  },
  PRP(sketch, from, to) {
    const way = heading(from.at, to.at), [one, other] = [rail(sketch, from, way), rail(sketch, to, way + 90)];
    const [a, b] = [one, other].map(r => r.guide.angle * Math.PI / 180), det = Math.sin(b - a);
    if (Math.abs(det) < 0.05 || one.name === other.name) return false; // parallel: they do not meet
    const [dx, dy] = [0, 1].map(k => other.guide.at[k] - one.guide.at[k]);
    const inner = pointAt(sketch, along(one.guide.at, (dx * Math.sin(b) - dy * Math.cos(b)) / det, one.guide.angle));
    linkOf(sketch, [inner], one.name);
    linkOf(sketch, [inner], other.name);
    return true;
  },
  RPP(sketch, from, to) {
    const way = heading(from.at, to.at), { name, guide } = rail(sketch, to, way + 90), a = hinge(sketch, from);
    const foot = onGuide(guide, from.at), yoke = linkOf(sketch, [pointAt(sketch, foot)], name);
    linkOf(sketch, [a], guideAt(sketch, foot, guide.angle - 90, yoke));
    return true;
  },
  motor(sketch, from, to) { // of two links that move, the one nearer the frame carries it
    const at = hinge(sketch, from), fixed = sketch.fixed.includes(at), some = holders(sketch, at);
    const held = (/** @type {string} */ n) => sketch.links[n].points.some(p => sketch.fixed.includes(p));
    if (!fixed && some.length < 2) return false;
    const [on, link] = fixed ? ["0", some[0]] : [some.find(held) ?? some[0], ""];
    const turned = link || some.find(n => n !== on && !fixed) ||
      linkOf(sketch, [at, to.point || pointAt(sketch, to.at)]);
    sketch.drive = { link: turned, kind: "phi", rate: TURNS, ...(fixed ? {} : { on }) };
    return true;
  },
  cylinder(sketch, from, to) {
    const barrel = linkOf(sketch, [hinge(sketch, from)]);
    const guide = guideAt(sketch, from.at, heading(from.at, to.at), barrel);
    sketch.drive = { link: linkOf(sketch, [hinge(sketch, to)], guide), kind: "s", rate: STRETCHES };
    return true;
  },
};
/** A stamp between two ends; a motor that was not dragged has a crank of ten steps. ``by``: the step of lengths; null
 * where it cannot be. @type {(sketch: Sketch, stamp: string, from: End, to: End, by: number) => Sketch | null} */
export function stamped(sketch, stamp, from, to, by) {
  const made = structuredClone(sketch), short = distance(from.at, to.at) < by / 2;
  if (short && stamp !== "motor") return null;
  const end = short ? { point: "", link: "", guide: "", at: along(from.at, 10 * by, TURNED_DEG) } : to;
  return MADE[stamp](made, from, end, by) ? made : null;
}
