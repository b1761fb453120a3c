// The signs and arrows of the drawing, as Python draws them on paper: mm of paper, y up.
import { distance } from "./geometry.js";
import { circle, coordinates, svg } from "./svg.js";

/** @type {PaperSigns} */
export const paper = JSON.parse(document.getElementById("signs").textContent);
export const MM = 96 / 25.4; // px of the screen

/** A sign at a place, turned by degrees, with so many px to a mm; its strokes, px.
 * @type {(parent: Element, name: string, p: Spot, turn: number, mm: number, own: Attributes) => Ends[]} */
export function sign(parent, name, p, turn, mm, own) {
  const c = mm * Math.cos(turn * Math.PI / 180), s = mm * Math.sin(turn * Math.PI / 180);
  const all = paper.signs[name].map(stroke => ({ ...stroke,
    points: stroke.points.map(([x, y]) => [p[0] + c * x - s * y, p[1] - s * x - c * y]) }));
  for (const pen of ["thin", "thick"]) {
    const lines = all.filter(one => one.pen === pen && !one.r);
    if (lines.length) svg("path", { ...own, class: `${pen} ${own.class}`, d: lines.map(({ points, closed }) =>
      `M${coordinates(points)}${closed ? "Z" : ""}`).join("") }, parent);
  }
  for (const { pen, points: [at], r } of all) if (r) circle(at, mm * r, `${pen} ${own.class}`, parent, own);
  return all.flatMap(({ points }) => points.slice(1).map((q, k) => [points[k], q]));
}
/** The length and the width of the head of an arrow, px; zeros: none. As ``head_size`` in Python.
 * @type {(length: number, mm: number, pen: string) => number[]} */
export function headSize(length, mm, pen) {
  const [long, wide, width] = paper.heads[pen], shrink = Math.min(1, 0.5 * length / mm / long);
  if (length < paper.headless * mm) return [0, 0];
  return [mm * long * shrink, mm * Math.max(wide * shrink, Math.min(wide, paper.least * width))];
}
/** The corners of an arrowhead at its tip, which points along a unit vector.
 * @type {(tip: Spot, along: Spot, size: number[]) => string} */
export function head([x, y], [u, v], [long, wide]) {
  const [bx, by] = [x - long * u, y - long * v], [w, h] = [v * wide / 2, u * wide / 2];
  return coordinates([[x, y], [bx - w, by + h], [bx + w, by - h]]);
}
/** An arrow from place to place, px; its shaft ends within its head.
 * @type {(parent: Element, a: Spot, b: Spot, mm: number, pen: string, own: Attributes) => any} */
export function arrow(parent, a, b, mm, pen, own) {
  const n = distance(a, b), u = [(b[0] - a[0]) / n, (b[1] - a[1]) / n], size = headSize(n, mm, pen);
  const g = svg("g", own, parent), [x, y] = b.map((v, k) => (v - 0.8 * size[0] * u[k]).toFixed(1));
  svg("line", { x1: a[0].toFixed(1), y1: a[1].toFixed(1), x2: x, y2: y }, g);
  if (size[0]) svg("polygon", { points: head(b, u, size) }, g);
  return g;
}
