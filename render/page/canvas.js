// The canvas: a mechanism is drawn point by point, link by link; each change is reported as a whole sketch.
import { $, on } from "./dom.js";
import { boxOf, depicted, viewOf } from "./moving.js";
import { svg } from "./svg.js";

const GRIP_PX = 14, TOUCH_PX = 26, STEP_DEG = 5, STEPS_M = [0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1];
/** @type {Sketch} */
export const NOTHING = { title: "", points: {}, fixed: [], guides: {}, links: {}, drive: null, loads: [] };
export const TOOLS = ["move", "fix", "link", "plate", "guide", "slide", "drive", "load", "mass", "measure", "remove"];
const DRAGGED = ["link", "guide", "measure"]; // drawn from where the pointer goes down to where it goes up

export const canvas = {
  sketch: /** @type {Sketch} */ (structuredClone(NOTHING)), view: viewOf([-0.3, -0.2, 0.3, 0.2], 600, 400, 40),
  size: [0, 0],
  tool: "move", chosen: "", from: /** @type {any} */ (null), to: /** @type {any} */ (null), hands: 0,
  changed: /** @type {(what: string, more?: any) => void} */ (() => {}), under: /** @type {any} */ (null),
  ruled: /** @type {Ends | null} */ (null), // a length of the picture beneath, from point to point
};
const node = () => /** @type {any} */ ($("canvas"));

export function fit() { // all of it in view, with room to draw
  const { width, height } = node().getBoundingClientRect();
  const [x0, y0, x1, y1] = boxOf(canvas.sketch), more = 0.15 * Math.max(x1 - x0, y1 - y0, 0.1);
  canvas.view = viewOf([x0 - more, y0 - more, x1 + more, y1 + more], width || 600, height || 400, 20);
  canvas.size = [width, height];
  paint();
}
/** A sentence beside the canvas reduces its room: the drawing keeps its size and its middle, if it fits. */
function resized() {
  const { width, height } = node().getBoundingClientRect(), { view, size: [w, h] } = canvas;
  const [mx, my] = view.m([w / 2, h / 2]), [dx, dy] = [width / 2 / view.k, height / 2 / view.k];
  const [x0, y0, x1, y1] = boxOf(canvas.sketch);
  if (!w || !width || x0 < mx - dx || x1 > mx + dx || y0 < my - dy || y1 > my + dy) { fit(); return; }
  canvas.view = viewOf([mx - dx, my - dy, mx + dx, my + dy], width, height, 0);
  canvas.size = [width, height];
  paint();
}
/** @type {(sketch: Sketch | null) => void} */
export function show(sketch) {
  canvas.sketch = structuredClone(sketch ?? NOTHING);
  if (!canvas.from) fit();
}
export function paint() {
  const { sketch, view, from, to } = canvas, at = node();
  at.textContent = "";
  if (canvas.under) {
    const [x, y] = view.px(canvas.under.at), w = canvas.under.width * view.k;
    svg("image", { href: canvas.under.href, x, y, width: w, height: w * canvas.under.ratio, opacity: 0.4 }, at);
    const [a, b] = canvas.ruled?.map(view.px) ?? [];
    if (b) svg("path", { d: `M${a[0]} ${a[1]}L${b[0]} ${b[1]}`, class: "ruled" }, at);
  }
  grid(at);
  depicted(at, sketch, view, sketch.points, true);
  for (const load of sketch.loads) {
    const p = sketch.points[load.point] && view.px(sketch.points[load.point]);
    if (p) svg("path", { d: `M${p[0] + 34} ${p[1] - 4}h-26m8 -5l-9 5 9 5`, class: "load" }, at);
  }
  if (from && to && DRAGGED.includes(canvas.tool)) {
    const [a, b] = [view.px(from.at), view.px(to.at)];
    svg("line", { x1: a[0], y1: a[1], x2: b[0], y2: b[1], class: "link draft" }, at);
    const l = Math.hypot(to.at[0] - from.at[0], to.at[1] - from.at[1]);
    const turn = Math.atan2(to.at[1] - from.at[1], to.at[0] - from.at[0]) * 180 / Math.PI;
    svg("text", { x: b[0] + 10, y: b[1] - 12, class: "measure" }, at, `${+l.toFixed(4)} m, ${+turn.toFixed(1)}°`);
  }
  at.querySelectorAll(`[data-point="${canvas.chosen}"], [data-link="${canvas.chosen}"]`).forEach(
    (/** @type {any} */ e) => e.classList.add("lit"));
}
/** @type {() => number} */
const step = () => STEPS_M.find(s => s * canvas.view.k >= 6) ?? 1; // as fine as the eye sees

/** @type {(parent: Element) => void} */
function grid(parent) {
  const { width, height } = parent.getBoundingClientRect(), { view } = canvas, by = step() * 10;
  const [x0, y1] = view.m([0, 0]), [x1, y0] = view.m([width, height]);
  if ((x1 - x0) / by > 80 || !width) return;
  let d = "";
  for (let x = Math.ceil(x0 / by) * by; x < x1; x += by) d += `M${view.px([x, 0])[0].toFixed(1)} 0V${height}`;
  for (let y = Math.ceil(y0 / by) * by; y < y1; y += by) d += `M0 ${view.px([0, y])[1].toFixed(1)}H${width}`;
  svg("path", { d, class: "grid" }, parent);
}
/** @type {(taken: Record<string, any>, names: string[]) => string} */
const free = (taken, names) => names.find(n => !(n in taken)) ?? `P${Object.keys(taken).length}`;
const letter = () => free(canvas.sketch.points, [..."ABCDEFGHKLMNPQRSTUVW"]);
const linkName = () => free(canvas.sketch.links, Array.from({ length: 60 }, (_, k) => String(k + 1)));

/** The object under the pointer: a point, a link or a guide. @type {(e: PointerEvent) => any} */
function under(e) {
  const box = node().getBoundingClientRect(), px = [e.clientX - box.left, e.clientY - box.top];
  const reach = e.pointerType === "touch" ? TOUCH_PX : GRIP_PX, { sketch, view } = canvas;
  const near = Object.keys(sketch.points).map(p => ({ p, d: Math.hypot(...view.px(sketch.points[p]).map((v, k) =>
    v - px[k])) })).filter(one => one.d < reach).sort((a, b) => a.d - b.d)[0];
  const own = /** @type {any} */ (e.target);
  const hit = document.elementsFromPoint(e.clientX, e.clientY).map((/** @type {any} */ one) => one.dataset);
  const link = own.dataset?.link ?? hit.find(d => d?.link)?.link, guide = hit.find(d => d?.guide)?.guide;
  return { point: near?.p ?? "", link: link ?? "", guide: guide ?? "", at: view.m(px), raw: view.m(px) };
}
/** The intended place: on a point, a guide, a whole length and angle from the start, or the grid.
 * @type {(found: any, from?: any) => any} */
function meant(found, from) {
  const { sketch } = canvas, by = step();
  if (found.point) return { ...found, at: [...sketch.points[found.point]] };
  if (from && canvas.tool !== "move") {
    const dx = found.at[0] - from.at[0], dy = found.at[1] - from.at[1];
    const turn = Math.round(Math.atan2(dy, dx) * 180 / Math.PI / STEP_DEG) * STEP_DEG * Math.PI / 180;
    const long = Math.round(Math.hypot(dx, dy) / by) * by;
    return { ...found, at: [from.at[0] + long * Math.cos(turn), from.at[1] + long * Math.sin(turn)] };
  }
  return { ...found, at: found.at.map((/** @type {number} */ v) => Math.round(v / by) * by) };
}
/** @type {(name: string, p: Spot) => Spot} */
function onGuide(name, [x, y]) {
  const g = canvas.sketch.guides[name], a = g.angle * Math.PI / 180, c = Math.cos(a), s = Math.sin(a);
  const t = (x - g.at[0]) * c + (y - g.at[1]) * s;
  return [g.at[0] + t * c, g.at[1] + t * s];
}
/** @type {(p: Spot) => string} */
function nearGuide(p) {
  const off = (/** @type {string} */ n) => Math.hypot(...onGuide(n, p).map((v, k) => v - p[k])) * canvas.view.k;
  return Object.keys(canvas.sketch.guides).filter(n => off(n) < 1.6 * GRIP_PX).sort((a, b) => off(a) - off(b))[0] ?? "";
}
/** @type {(at: Spot) => string} */
function pointAt(at) {
  const name = letter();
  canvas.sketch.points[name] = at;
  return name;
}
const ACTS = /** @type {Record<string, (found: any, from: any) => any>} */ ({
  fix({ point, at }) {
    const { sketch } = canvas, name = point || pointAt(at);
    sketch.fixed = sketch.fixed.includes(name) ? sketch.fixed.filter(p => p !== name) : [...sketch.fixed, name];
  },
  link(to, from) {
    if (Math.hypot(to.at[0] - from.at[0], to.at[1] - from.at[1]) < step() / 2) return false;
    const ends = [from, to].map(e => e.point || pointAt(e.at));
    const name = linkName();
    canvas.sketch.links[name] = { points: ends, slides: null, centre: null };
    canvas.sketch.drive ??= canvas.sketch.fixed.some(p => ends.includes(p)) ?
      { link: name, kind: "phi", rate: 10 } : null;
    return true;
  },
  guide(to, from) {
    if (to.at[0] === from.at[0] && to.at[1] === from.at[1]) return false;
    const { sketch } = canvas, owner = from.point && !sketch.fixed.includes(from.point) ?
      Object.keys(sketch.links).find(n => sketch.links[n].points.includes(from.point)) : from.link;
    const angle = Math.atan2(to.at[1] - from.at[1], to.at[0] - from.at[0]) * 180 / Math.PI;
    const name = free(sketch.guides, ["x-x", "y-y", "z-z", "g4", "g5", "g6"]);
    sketch.guides[name] = { at: from.at, angle: +angle.toFixed(6), link: owner || "0" };
    return true;
  },
  slide(found) {
    const { sketch } = canvas, guide = found.guide || nearGuide(found.at);
    if (!guide) return false;
    const name = found.point || pointAt(found.at);
    sketch.points[name] = onGuide(guide, sketch.points[name]);
    sketch.links[linkName()] = { points: [name], slides: guide, centre: null };
    return true;
  },
  plate(found) {
    if (!found.link) return false;
    const own = canvas.sketch.links[found.link].points;
    const name = found.point && !own.includes(found.point) ? found.point : pointAt(found.at);
    own.push(name);
    return true;
  },
  drive(found) {
    const { sketch } = canvas, link = found.link || Object.keys(sketch.links).find(n =>
      sketch.links[n].points.includes(found.point));
    if (!link) return false;
    sketch.drive = { link, kind: sketch.links[link].slides ? "s" : "phi", rate: 10 };
    return true;
  },
  load(found) { return found.point ? { load: found.point } : false; },
  mass(found) { return found.link ? { mass: found.link } : false; },
  remove(found) {
    const { sketch } = canvas;
    if (found.point) {
      for (const [n, l] of Object.entries(sketch.links)) {
        l.points = l.points.filter(p => p !== found.point);
        if (l.points.length + +Object.values(sketch.guides).some(g => g.link === n) < (l.slides ? 1 : 2)) gone(n);
      }
      sketch.fixed = sketch.fixed.filter(p => p !== found.point);
    } else if (found.link) gone(found.link);
    else if (found.guide) unguided(found.guide);
    else return false;
    alone();
    return true;
  },
  move(found, from) { return from.moved; },
  measure(to, from) {
    if (!canvas.under || Math.hypot(to.raw[0] - from.raw[0], to.raw[1] - from.raw[1]) < step() / 2) return false;
    canvas.ruled = [from.raw, to.raw];
    return true;
  },
});
/** Scale the picture beneath so that the length marked on it has this many metres; its first point stays.
 * @type {(metres: number) => void} */
export function sized(metres) {
  const { under, ruled } = canvas;
  if (!under || !ruled || !(metres > 0)) return;
  const [[x, y], [u, v]] = ruled, k = metres / Math.hypot(u - x, v - y);
  under.width *= k;
  under.at = [x + k * (under.at[0] - x), y + k * (under.at[1] - y)];
  canvas.ruled = [[x, y], [x + k * (u - x), y + k * (v - y)]];
  paint();
}
/** @type {(link: string) => void} */
function gone(link) {
  const { sketch } = canvas;
  delete sketch.links[link];
  for (const [n, g] of Object.entries(sketch.guides)) if (g.link === link) unguided(n);
  if (sketch.drive?.link === link) sketch.drive = null;
}
/** @type {(guide: string) => void} */
function unguided(guide) {
  delete canvas.sketch.guides[guide];
  for (const [n, l] of Object.entries(canvas.sketch.links)) if (l.slides === guide) gone(n);
}
function alone() { // points that belong to no link are deleted
  const { sketch } = canvas, used = new Set([...sketch.fixed, ...Object.values(sketch.links).flatMap(l => l.points)]);
  for (const p of Object.keys(sketch.points)) if (!used.has(p)) delete sketch.points[p];
}
/** Points of one link only keep their places on it: they turn and grow with the link about its other joint.
 * @type {(points: string[], point: string, was: Spot, now: Spot) => void} */
function followed(points, point, [x, y], now) {
  const { sketch } = canvas, held = Object.values(sketch.links).flatMap(l => l.points);
  const joint = (/** @type {string} */ p) => sketch.fixed.includes(p) || held.filter(q => q === p).length > 1;
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
/** @type {(point: string, at: Spot) => void} */
function shifted(point, at) { // a point, with all points that must follow it; a slider stays on its guide
  const { sketch } = canvas, guide = Object.values(sketch.links).find(l => l.slides && l.points[0] === point)?.slides;
  const own = guide && sketch.guides[guide].link === "0" ? onGuide(guide, at) : at;
  const was = sketch.points[point];
  for (const l of Object.values(sketch.links)) if (l.points.includes(point)) followed(l.points, point, was, own);
  for (const g of Object.values(sketch.guides)) if (Math.hypot(g.at[0] - was[0], g.at[1] - was[1]) < 1e-9) g.at = own;
  sketch.points[point] = own;
}
export function listen() {
  const at = node();
  on(at, "pointerdown", e => {
    if (e.button) return;
    const found = under(e);
    at.setPointerCapture(e.pointerId);
    canvas.from = meant(found);
    canvas.to = canvas.from;
    canvas.chosen = found.point || found.link;
    paint();
  });
  on(at, "pointermove", e => {
    if (!canvas.from) return;
    const found = under(e), { from } = canvas;
    if (canvas.tool === "move" && from.point) {
      const to = meant({ ...found, point: "" });
      from.moved ||= to.at.some((/** @type {number} */ v, /** @type {number} */ k) => v !== from.at[k]);
      if (from.moved) shifted(from.point, to.at);
    } else canvas.to = meant({ ...found, point: found.point === from.point ? "" : found.point }, from);
    paint();
  });
  on(at, "pointerup", e => {
    const { from, to } = canvas;
    canvas.from = canvas.to = null;
    canvas.hands++;
    if (!from) return;
    const found = DRAGGED.includes(canvas.tool) ? to : meant(under(e));
    const made = ACTS[canvas.tool](found, from);
    if (made !== false && made !== undefined || canvas.tool === "fix") canvas.changed(canvas.tool, made);
    paint();
  });
  on(at, "pointercancel", () => { canvas.from = canvas.to = null; paint(); });
  on(at, "keydown", e => {
    const names = Object.keys(canvas.sketch.points), k = names.indexOf(canvas.chosen);
    const way = /** @type {Record<string, Spot>} */ ({ ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1],
      ArrowDown: [0, -1] })[e.key];
    if (e.key === "Tab" && !e.ctrlKey && names.length && k + (e.shiftKey ? -1 : 1) in names) {
      canvas.chosen = names[k + (e.shiftKey ? -1 : 1)];
      e.preventDefault();
    } else if (way && k >= 0) {
      shifted(canvas.chosen, canvas.sketch.points[canvas.chosen].map((v, i) => v + way[i] * step()));
      canvas.changed("move", true);
      e.preventDefault();
    } else if (e.key === "Delete" && canvas.chosen) {
      ACTS.remove({ point: k >= 0 ? canvas.chosen : "", link: k < 0 ? canvas.chosen : "" }, null);
      canvas.changed("remove", true);
    }
    paint();
  });
  new ResizeObserver(() => { if (!canvas.from) resized(); }).observe(at);
}
