// Boxes, strokes and quantiles: computations with places, without drawing.

/** @type {(a: Spot, b: Spot) => number} */
export function distance(a, b) { return Math.hypot(b[0] - a[0], b[1] - a[1]); }
/** A place moved along a direction, degrees. @type {(at: Spot, by: number, angle: number) => Spot} */
export function along([x, y], by, angle) {
  return [x + by * Math.cos(angle * Math.PI / 180), y + by * Math.sin(angle * Math.PI / 180)];
}
/** The direction from a place to another, degrees. @type {(a: Spot, b: Spot) => number} */
export const heading = (a, b) => Math.atan2(b[1] - a[1], b[0] - a[0]) * 180 / Math.PI;
/** @type {(p: Spot, stroke: Ends) => number} */
export function gap(p, [a, b]) { // from a point to a stroke, px
  const dx = b[0] - a[0], dy = b[1] - a[1], n = dx * dx + dy * dy;
  const t = n ? Math.max(0, Math.min(1, ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / n)) : 0;
  return Math.hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy);
}
/** @type {(a: Box, b: Box) => Box} */
export function union(a, b) {
  return [Math.min(a[0], b[0]), Math.min(a[1], b[1]), Math.max(a[2], b[2]), Math.max(a[3], b[3])];
}
/** @type {(numbers: number[], share: number) => number} */
export function quantile(numbers, share) {
  const sorted = [...numbers].sort((a, b) => a - b);
  return sorted[Math.floor(share * (sorted.length - 1))];
}
/** @type {(v: number, a: number, b: number) => number} */
export function clamp(v, a, b) { return Math.min(b, Math.max(a, Number.isFinite(v) ? v : a)); }
/** @type {(a: ArrayLike<number>, b: ArrayLike<number>) => number} */
export function dot(a, b) {
  let sum = 0;
  for (let k = 0; k < a.length; k++) sum += a[k] * b[k];
  return sum;
}
/** @type {(points: Spot[]) => Spot[]} */
export function hull(points) { // the outline of a link of three points or more; of points in line, the two ends
  const turn = (/** @type {Spot} */ o, /** @type {Spot} */ a, /** @type {Spot} */ b) => (a[0] - o[0]) * (b[1] - o[1]) -
    (a[1] - o[1]) * (b[0] - o[0]);
  const half = (/** @type {Spot[]} */ list) => {
    const h = /** @type {Spot[]} */ ([]);
    for (const q of list) { while (h.length > 1 && turn(h[h.length - 2], h[h.length - 1], q) <= 1) h.pop(); h.push(q); }
    return h.slice(0, -1);
  };
  const p = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]), back = [...p].reverse();
  const all = p.length > 2 ? [...half(p), ...half(back)] : p;
  return all.length > 2 ? all : [...new Set([p[0], p[p.length - 1]])];
}
