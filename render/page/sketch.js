// A sketch under the hand: new names, places on guides, parts that go with others, other names.
import { along, distance, heading } from "./geometry.js";

const POINTS = [..."ABCDEFGHKLMNPQRSTUVW"], RAILS = ["x-x", "y-y", "z-z", "n-n", "m-m", "q-q"];
const AT_MOST = 400, SAME_M = 1e-9;

/** @type {(taken: Record<string, any>, names: string[], more: string) => string} */
const free = (taken, names, more) => [...names, ...Array.from({ length: AT_MOST }, (_, k) => `${more}${k + 1}`)]
  .find(n => !(n in taken));
/** @type {(sketch: Sketch, at: Spot) => string} */
export function pointAt({ points }, at) {
  const name = free(points, POINTS, "P");
  points[name] = [...at];
  return name;
}
/** @type {(sketch: Sketch, points: string[], slides?: string | null) => string} */
export function linkOf({ links }, points, slides = null) {
  const name = free(links, [], "");
  links[name] = { points, slides, centre: null };
  return name;
}
/** @type {(sketch: Sketch, at: Spot, angle: number, link: string) => string} */
export function guideAt({ guides }, at, angle, link) {
  const name = free(guides, RAILS, "g");
  guides[name] = { at: [...at], angle: +angle.toFixed(6), link };
  return name;
}
/** The links of a point, in the order of the sketch. @type {(sketch: Sketch, point: string) => string[]} */
export const holders = ({ links }, point) => Object.keys(links).filter(n => links[n].points.includes(point));
/** @type {(guide: { at: Spot, angle: number }, p: Spot) => Spot} */
export function onGuide({ at, angle }, [x, y]) {
  const a = angle * Math.PI / 180;
  return along(at, (x - at[0]) * Math.cos(a) + (y - at[1]) * Math.sin(a), angle);
}
/** Points of one link only keep their places on it: they turn and grow with the link about its other joint.
 * @type {(sketch: Sketch, points: string[], point: string, was: Spot, now: Spot) => void} */
function followed(sketch, points, point, [x, y], now) {
  const joint = (/** @type {string} */ p) => sketch.fixed.includes(p) || holders(sketch, p).length > 1;
  const pivot = points.find(p => p !== point && joint(p));
  if (!pivot) return;
  const [u, v] = sketch.points[pivot], long = (x - u) ** 2 + (y - v) ** 2;
  if (!long) return;
  const c = ((now[0] - u) * (x - u) + (now[1] - v) * (y - v)) / long;
  const s = ((now[1] - v) * (x - u) - (now[0] - u) * (y - v)) / long;
  for (const p of points) if (p !== point && !joint(p)) {
    const [a, b] = sketch.points[p];
    sketch.points[p] = [u + c * (a - u) - s * (b - v), v + s * (a - u) + c * (b - v)];
  }
}
/** A point, with all that must follow it; a slider stays on its guide, or the lever with its guide turns after it.
 * @type {(sketch: Sketch, point: string, at: Spot) => void} */
export function shifted(sketch, point, at) {
  const { guides, links, points } = sketch, was = points[point];
  const sliding = Object.values(links).filter(l => l.slides && l.points[0] === point).map(l => guides[l.slides ?? ""]);
  const rail = sliding.find(g => g.link === "0"), own = rail ? onGuide(rail, at) : at;
  for (const l of Object.values(links)) if (l.points.includes(point)) followed(sketch, l.points, point, was, own);
  for (const g of Object.values(guides)) if (distance(g.at, was) < SAME_M) g.at = own;
  points[point] = own;
  for (const { points: [first], slides } of Object.values(links)) {
    const g = slides ? guides[slides] : null, lever = g ? links[g.link] : null;
    if (g && lever?.points.length === 1 && !lever.slides) g.angle = +heading(g.at, points[first]).toFixed(6);
  }
}
/** @type {(sketch: Sketch, link: string) => void} */
export function gone(sketch, link) {
  delete sketch.links[link];
  for (const [n, g] of Object.entries(sketch.guides)) if (g.link === link) unguided(sketch, n);
  if ([sketch.drive?.link, sketch.drive?.on].includes(link)) sketch.drive = null;
}
/** @type {(sketch: Sketch, guide: string) => void} */
export function unguided(sketch, guide) {
  delete sketch.guides[guide];
  for (const [n, l] of Object.entries(sketch.links)) if (l.slides === guide) gone(sketch, n);
}
/** @type {(sketch: Sketch, point: string) => void} */
export function unpointed(sketch, point) {
  for (const [n, l] of Object.entries(sketch.links)) {
    l.points = l.points.filter(p => p !== point);
    if (l.centre === point) l.centre = null;
    if (l.points.length + +Object.values(sketch.guides).some(g => g.link === n) < (l.slides ? 1 : 2)) gone(sketch, n);
  }
  sketch.fixed = sketch.fixed.filter(p => p !== point);
}
/** @type {(sketch: Sketch) => void} */
export function alone(sketch) { // points that belong to no link are deleted
  for (const p of Object.keys(sketch.points)) {
    if (!sketch.fixed.includes(p) && !holders(sketch, p).length) delete sketch.points[p];
  }
}
/** A point with the name of another one: the two become a hinge, unless a link has both.
 * @type {(sketch: Sketch, point: string, other: string) => boolean} */
export function merged(sketch, point, other) {
  if (holders(sketch, point).some(n => sketch.links[n].points.includes(other))) return false;
  const was = sketch.points[other];
  renamed(sketch, "point", point, other);
  sketch.points[other] = was;
  sketch.fixed = [...new Set(sketch.fixed)];
  return true;
}
/** @type {(sketch: Sketch, kind: string, was: string, now: string) => void} */
export function renamed(sketch, kind, was, now) {
  const other = (/** @type {string} */ n) => n === was ? now : n;
  /** @type {<T>(table: Record<string, T>) => Record<string, T>} */
  const keyed = table => Object.fromEntries(Object.entries(table).map(([n, one]) => [other(n), one]));
  if (kind === "point") {
    sketch.points = keyed(sketch.points);
    sketch.fixed = sketch.fixed.map(other);
    for (const l of Object.values(sketch.links)) Object.assign(l, { points: l.points.map(other),
      centre: l.centre && other(l.centre) });
    for (const load of sketch.loads) load.point = other(load.point);
    return;
  }
  sketch.links = keyed(sketch.links);
  for (const g of Object.values(sketch.guides)) g.link = other(g.link);
  for (const load of sketch.loads) load.link = other(load.link);
  const { drive } = sketch;
  if (drive) sketch.drive = { ...drive, link: other(drive.link), ...(drive.on ? { on: other(drive.on) } : {}) };
}
/** A copy of a point or a link beside it, with points of its own; its name.
 * @type {(sketch: Sketch, kind: string, name: string, by: number) => string} */
export function copied(sketch, kind, name, by) {
  const beside = (/** @type {string} */ p) => pointAt(sketch, sketch.points[p].map((v, k) => v + (k ? -by : by)));
  if (kind === "point") {
    const copy = beside(name), [holder] = holders(sketch, name);
    if (sketch.fixed.includes(name)) sketch.fixed.push(copy); else sketch.links[holder]?.points.push(copy);
    return copy;
  }
  const { points, slides, centre } = sketch.links[name], copies = points.map(beside);
  const copy = linkOf(sketch, copies, slides);
  sketch.links[copy].centre = centre && copies[points.indexOf(centre)];
  for (const g of Object.values(sketch.guides).filter(one => one.link === name)) {
    guideAt(sketch, [g.at[0] + by, g.at[1] - by], g.angle, copy);
  }
  if (slides) sketch.points[copies[0]] = onGuide(sketch.guides[slides], sketch.points[copies[0]]);
  return copy;
}
