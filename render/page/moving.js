// Small animated pictures of mechanisms: a sketch drawn in one position or in a sequence.
import { hull } from "./geometry.js";
import { MM, sign } from "./signs.js";
import { coordinates, svg } from "./svg.js";

const ROUND_MS = 4000, DRAWN = 0.75, SMALL = 0.7, PENS = 0.85; // of true mm

/** @type {(sketch: Sketch) => Box} */
export function boxOf({ points, guides, motion }) {
  const at = [...Object.values(points), ...Object.values(motion ?? {}).flat(), ...Object.values(guides).map(g => g.at)];
  const xs = at.map(p => p[0]), ys = at.map(p => p[1]);
  return at.length ? [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)] : [-0.3, -0.2, 0.3, 0.2];
}
/** The mapping of a sketch to a picture of w by h.
 * @type {(box: Box, w: number, h: number, edge: number) => View} */
export function viewOf([x0, y0, x1, y1], w, h, edge) {
  const k = Math.min((w - 2 * edge) / Math.max(x1 - x0, 1e-6), (h - 2 * edge) / Math.max(y1 - y0, 1e-6), 4000);
  const mx = (x0 + x1) / 2, my = (y0 + y1) / 2;
  return { k, px: ([x, y]) => [w / 2 + k * (x - mx), h / 2 - k * (y - my)],
    m: ([x, y]) => [mx + (x - w / 2) / k, my - (y - h / 2) / k] };
}
/** @type {(g: any, points: Record<string, Spot>, view: View, long: number) => Ends} */
export function guideEnds(g, points, view, long) {
  const a = g.angle * Math.PI / 180, [x, y] = view.px(g.at), dx = Math.cos(a), dy = -Math.sin(a);
  const near = Object.values(points).map(view.px).map(([u, v]) => (u - x) * dx + (v - y) * dy)
    .filter((_, k) => { const [u, v] = view.px(Object.values(points)[k]);
      return Math.abs((u - x) * dy - (v - y) * dx) < 1; });
  const from = Math.min(0, ...near) - long, to = Math.max(0, ...near) + long;
  return [[x + from * dx, y + from * dy], [x + to * dx, y + to * dy]];
}
/** By how much a link has turned since its sketch, degrees, by two of its points, or one and what slides on it.
 * @type {(sketch: Sketch, link: string, points: Record<string, Spot>, slider: string) => number} */
function turned(sketch, link, points, slider) {
  const own = sketch.links[link]?.points ?? [], [a, b] = own.length > 1 ? own : [own[0], slider];
  if (!a || a === b || !sketch.points[a] || !sketch.points[b] || points === sketch.points) return 0;
  const way = (/** @type {Record<string, Spot>} */ at) => Math.atan2(at[b][1] - at[a][1], at[b][0] - at[a][0]);
  return (way(points) - way(sketch.points)) * 180 / Math.PI;
}
/** @type {(parent: Element, sketch: Sketch, view: View, points?: Record<string, Spot>, names?: boolean) => void} */
export function depicted(parent, sketch, view, points = sketch.points, names = false) {
  const at = (/** @type {string} */ p) => points[p] && view.px(points[p]), mm = MM * (names ? DRAWN : SMALL);
  parent.setAttribute("style", `--share: ${PENS}`);
  const held = Object.values(sketch.links).flatMap(l => l.points);
  /** @type {(p: string) => boolean} */
  const centre = p => held.filter(q => q === p).length === 1 && Object.values(sketch.links).some(l => l.centre === p &&
    l.points.length > 1) && !sketch.fixed.includes(p);
  for (const [name, g] of Object.entries(sketch.guides)) {
    if (sketch.motion && g.link !== "0") continue; // it moves without a known path
    const sliders = sketch.motion ? [] : Object.values(sketch.links).filter(l => l.slides === name);
    const own = Object.fromEntries(sliders.map(l => [l.points[0], points[l.points[0]]]).filter(([, p]) => p));
    const [a, b] = guideEnds(g, own, view, sketch.motion ? 40 : 55);
    svg("line", { x1: a[0], y1: a[1], x2: b[0], y2: b[1], class: "rail", "data-guide": name }, parent);
    if (names) svg("text", { x: b[0] + 4, y: b[1], class: "label" }, parent, name);
  }
  for (const [name, l] of Object.entries(sketch.links)) {
    const ends = l.points.filter(p => p !== l.centre).map(at).filter(Boolean);
    const cls = "link" + (sketch.drive?.link === name ? " driver" : "");
    if (ends.length > 2) svg("polygon", { points: coordinates(hull(ends)), class: cls, "data-link": name }, parent);
    else if (ends.length === 2) svg("line", { x1: ends[0][0], y1: ends[0][1], x2: ends[1][0], y2: ends[1][1],
      class: cls, "data-link": name }, parent);
    const g = l.slides && sketch.guides[l.slides], p = at(l.points[0]);
    if (g && p) sign(parent, "block", p, g.angle + turned(sketch, g.link, points, l.points[0]), mm,
      { class: "block", "data-link": name });
    if (names && ends.length) {
      const [mx, my] = [0, 1].map(k => ends.reduce((s, e) => s + e[k], 0) / ends.length);
      svg("text", { x: mx + 6, y: my + 14, class: "number" }, parent, name);
    }
  }
  for (const name of Object.keys(points)) {
    const p = at(name), fixed = sketch.fixed.includes(name);
    if (centre(name) && !names) continue;
    const kind = centre(name) ? "point" : "hinge";
    if (fixed) sign(parent, "ground", p, 0, mm, { class: "ground" });
    sign(parent, kind, p, 0, mm, { class: kind, "data-point": name });
    if (names) svg("text", { x: p[0] + 8, y: p[1] - 8, class: "label" }, parent, name);
  }
}
/** A sketch animated while it is visible. @type {(node: SVGSVGElement, sketch: Sketch) => void} */
export function moving(node, sketch) {
  const w = 220, h = 150, view = viewOf(boxOf(sketch), w, h, 24), many = Object.values(sketch.motion ?? {})[0]?.length;
  node.setAttribute("viewBox", `0 0 ${w} ${h}`);
  const place = (/** @type {number} */ k) => Object.fromEntries(Object.entries(sketch.motion ?? {}).map(([n, all]) =>
    [n, all[k]]));
  /** @type {(k: number) => void} */
  const show = k => { node.textContent = ""; depicted(node, sketch, view, many ? place(k) : sketch.points); };
  show(0);
  if (!many || matchMedia("(prefers-reduced-motion: reduce)").matches) return;
  let frame = 0;
  const still = new IntersectionObserver(([seen]) => {
    cancelAnimationFrame(frame);
    const turn = (/** @type {number} */ now) => {
      const share = now % ROUND_MS / ROUND_MS;
      show(sketch.round ? Math.floor(share * many) : Math.round(Math.abs(1 - 2 * share) * (many - 1)));
      frame = requestAnimationFrame(turn);
    };
    if (seen.isIntersecting) frame = requestAnimationFrame(turn);
  });
  still.observe(node);
}
