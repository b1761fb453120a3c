// The canvas: a mechanism is drawn point by point, link by link; each change is reported as a whole sketch.
import { $, on } from "./dom.js";
import { marked, taught } from "./first.js";
import { along, distance, heading } from "./geometry.js";
import { boxOf, depicted, viewOf } from "./moving.js";
import { MM, arrow } from "./signs.js";
import { alone, gone, guideAt, holders, linkOf, merged, onGuide, pointAt, shifted, unguided,
  unpointed } from "./sketch.js";
import { GROUPS, STAMPS, stamped } from "./stamps.js";
import { svg } from "./svg.js";

const GRIP_PX = 14, TOUCH_PX = 26, STILL_PX = 5, STEP_DEG = 5, SQUARE_DEG = 4;
const STEPS_M = [0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1];
/** @type {Sketch} */
export const NOTHING = { title: "", points: {}, fixed: [], guides: {}, links: {}, drive: null, loads: [] };
export const TOOLS = ["move", "fix", "link", "plate", "guide", "slide", "drive", "load", "mass", "measure", "remove"];
const DRAGGED = ["link", "guide", "measure", ...STAMPS]; // from one end to the other: dragged, or clicked at both

export const canvas = {
  sketch: /** @type {Sketch} */ (structuredClone(NOTHING)), view: viewOf([-0.3, -0.2, 0.3, 0.2], 600, 400, 40),
  size: [0, 0],
  tool: "move", chosen: "", from: /** @type {any} */ (null), to: /** @type {any} */ (null), hands: 0,
  held: false, // the first end has been clicked, the other one not yet
  changed: /** @type {(what: string, more?: any) => void} */ (() => {}), seen: () => {},
  under: /** @type {any} */ (null),
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
    if (b) svg("path", { d: `M${a[0]} ${a[1]}L${b[0]} ${b[1]}${cross(a)}${cross(b)}`, class: "ruled" }, at);
  }
  grid(at);
  depicted(at, sketch, view, sketch.points, true);
  for (const load of sketch.loads) {
    const p = sketch.points[load.point] && view.px(sketch.points[load.point]);
    if (p) arrow(at, [p[0] + 34, p[1] - 4], [p[0] + 6, p[1] - 4], MM, "thick", { class: "load" });
  }
  if (from && to && DRAGGED.includes(canvas.tool)) {
    const [a, b] = [view.px(from.at), view.px(to.at)];
    svg("line", { x1: a[0], y1: a[1], x2: b[0], y2: b[1], class: "link draft" }, at);
    const l = +distance(from.at, to.at).toFixed(4), turn = +heading(from.at, to.at).toFixed(1);
    svg("text", { x: b[0] + 10, y: b[1] - 12, class: "measure" }, at, `${l} m, ${turn}°`);
  }
  at.querySelectorAll(`[data-point="${canvas.chosen}"], [data-link="${canvas.chosen}"]`).forEach(
    (/** @type {any} */ e) => e.classList.add("lit"));
  if (canvas.tool === "move" && !from) marked(at, sketch, view);
  canvas.seen();
}
/** @type {(p: Spot) => string} */
const cross = ([x, y]) => `M${x - 6} ${y - 6}l12 12m0 -12l-12 12`;
/** @type {() => number} */
export const step = () => STEPS_M.find(s => s * canvas.view.k >= 6) ?? 1; // as fine as the eye sees

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
/** The object under the pointer: a point (not the one in hand), a link or a guide.
 * @type {(e: PointerEvent, but?: string) => any} */
function under(e, but = "") {
  const box = node().getBoundingClientRect(), px = [e.clientX - box.left, e.clientY - box.top];
  const reach = e.pointerType === "touch" ? TOUCH_PX : GRIP_PX, { sketch, view } = canvas;
  const far = (/** @type {string} */ p) => distance(px, view.px(sketch.points[p]));
  const near = Object.keys(sketch.points).filter(p => p !== but && far(p) < reach).sort((a, b) => far(a) - far(b))[0];
  const own = /** @type {any} */ (e.target);
  const hit = document.elementsFromPoint(e.clientX, e.clientY).map((/** @type {any} */ one) => one.dataset);
  const link = own.dataset?.link ?? hit.find(d => d?.link)?.link, guide = hit.find(d => d?.guide)?.guide;
  return { point: near ?? "", link: link ?? "", guide: guide ?? "", at: view.m(px), raw: view.m(px) };
}
/** The intended place: on a point, on a guide or a link where the tool joins to them, a whole length and angle from the
 * start, or the grid. @type {(found: any, from?: any) => any} */
function meant(found, from) {
  const { sketch, tool } = canvas, by = step();
  if (found.point) return { ...found, at: [...sketch.points[found.point]] };
  const joins = STAMPS.includes(tool) || tool === "plate" || tool === "link";
  const own = joins && found.link && sketch.links[found.link].points.map(p => sketch.points[p]);
  if (own?.length === 2) { // on its line, a whole length from its first end
    const [a, b] = own, way = heading(a, b), [x, y] = onGuide({ at: a, angle: way }, found.at);
    const turn = way * Math.PI / 180, long = (x - a[0]) * Math.cos(turn) + (y - a[1]) * Math.sin(turn);
    return { ...found, at: along(a, Math.round(long / by) * by, way) };
  }
  const rail = GROUPS.includes(tool) && !found.link ? found.guide || nearGuide(found.at) : "";
  if (rail) return { ...found, guide: rail, at: onGuide(sketch.guides[rail], found.at) };
  if (from && tool !== "move" && !GROUPS.includes(tool)) {
    const way = heading(from.at, found.at), far = distance(from.at, found.at);
    const turn = squared(way, from) ?? Math.round(way / STEP_DEG) * STEP_DEG;
    return { ...found, at: along(from.at, Math.round(far / by) * by, turn) };
  }
  return { ...found, at: found.at.map((/** @type {number} */ v) => Math.round(v / by) * by) };
}
/** A guide from a link's point is set along that link or across it, where it nearly is; degrees.
 * @type {(way: number, from: any) => number | null} */
function squared(way, { point }) {
  const { sketch, tool } = canvas;
  if (tool !== "guide" || !point || sketch.fixed.includes(point)) return null;
  const ways = holders(sketch, point).slice(0, 1).flatMap(n => sketch.links[n].points).filter(p => p !== point).map(p =>
    heading(sketch.points[point], sketch.points[p]));
  const off = (/** @type {number} */ a) => a - way - 90 * Math.round((a - way) / 90);
  const near = ways.find(a => Math.abs(off(a)) < SQUARE_DEG);
  return near === undefined ? null : way + off(near);
}
/** @type {(p: Spot) => string} */
function nearGuide(p) {
  const { guides } = canvas.sketch;
  const off = (/** @type {string} */ n) => distance(onGuide(guides[n], p), p) * canvas.view.k;
  return Object.keys(guides).filter(n => off(n) < 1.6 * GRIP_PX).sort((a, b) => off(a) - off(b))[0] ?? "";
}
const ACTS = /** @type {Record<string, (found: any, from: any) => any>} */ ({
  fix({ point, at }) {
    const { sketch } = canvas, name = point || pointAt(sketch, at);
    sketch.fixed = sketch.fixed.includes(name) ? sketch.fixed.filter(p => p !== name) : [...sketch.fixed, name];
  },
  link(to, from) {
    if (distance(from.at, to.at) < step() / 2) return false;
    const { sketch } = canvas, ends = [from, to].map(e => e.point || joined(e)), name = linkOf(sketch, ends);
    sketch.drive ??= sketch.fixed.some(p => ends.includes(p)) ? { link: name, kind: "phi", rate: 10 } : null;
    return true;
  },
  guide(to, from) {
    if (to.at[0] === from.at[0] && to.at[1] === from.at[1]) return false;
    const { sketch } = canvas, owner = from.point && !sketch.fixed.includes(from.point) ?
      holders(sketch, from.point)[0] : from.link;
    guideAt(sketch, from.at, heading(from.at, to.at), owner || "0");
    return true;
  },
  slide(found) {
    const { sketch } = canvas, guide = found.guide || nearGuide(found.at);
    if (!guide) return false;
    const name = found.point || pointAt(sketch, found.at);
    sketch.points[name] = onGuide(sketch.guides[guide], sketch.points[name]);
    linkOf(sketch, [name], guide);
    return true;
  },
  plate(found) {
    if (!found.link) return false;
    const { sketch } = canvas, own = sketch.links[found.link].points;
    own.push(found.point && !own.includes(found.point) ? found.point : pointAt(sketch, found.at));
    return true;
  },
  drive(found) {
    const { sketch } = canvas, link = found.link || holders(sketch, found.point)[0];
    if (!link) return false;
    sketch.drive = { link, kind: sketch.links[link].slides ? "s" : "phi", rate: 10 };
    return true;
  },
  load(found) { return found.point ? { load: found.point } : false; },
  mass(found) {
    const { sketch } = canvas, held = holders(sketch, found.point), link = found.link || held[0];
    const own = held.length === 1 && held[0] === link && !sketch.fixed.includes(found.point);
    return link ? { mass: link, centre: own ? found.point : "" } : false;
  },
  remove(found) {
    const { sketch } = canvas;
    if (found.point) unpointed(sketch, found.point);
    else if (found.link) gone(sketch, found.link);
    else if (found.guide) unguided(sketch, found.guide);
    else return false;
    alone(sketch);
    return true;
  },
  move(found, from) {
    if (from.moved && found.point) merged(canvas.sketch, from.point, found.point);
    return from.moved;
  },
  measure(to, from) {
    if (!canvas.under || distance(from.raw, to.raw) < step() / 2) return false;
    canvas.ruled = [from.raw, to.raw];
    return true;
  },
});
for (const name of STAMPS) ACTS[name] = (to, from) => {
  const made = stamped(canvas.sketch, name, from, to, step());
  if (!made) return false;
  canvas.sketch = made;
  return true;
};
/** A new point at an end, of the link there. @type {(end: any) => string} */
function joined({ link, at }) {
  const { sketch } = canvas, name = pointAt(sketch, at);
  if (link) sketch.links[link].points.push(name);
  return name;
}
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
/** Act with the tool in hand, from one end to the other. @type {(to: any, from: any) => void} */
function act(to, from) {
  const made = ACTS[canvas.tool](to, from);
  canvas.from = canvas.to = null;
  canvas.held = false;
  if (made !== false && made !== undefined || canvas.tool === "fix") canvas.changed(canvas.tool, made);
}
export function dropped() { // what is in hand
  canvas.from = canvas.to = null;
  canvas.held = false;
  paint();
}
/** The chosen point or link as an end. @type {() => any} */
function chosenEnd() {
  const { sketch, chosen } = canvas, p = sketch.points[chosen] ?? sketch.points[sketch.links[chosen]?.points[0]];
  return { point: chosen in sketch.points ? chosen : "", link: chosen in sketch.links ? chosen : "", guide: "",
    at: [...p], raw: [...p] };
}
export function listen() {
  const at = node();
  let down = /** @type {Spot} */ ([]);
  on(at, "pointerdown", e => {
    if (e.button) return;
    const found = under(e);
    at.setPointerCapture(e.pointerId);
    down = [e.clientX, e.clientY];
    if (canvas.held) return;
    canvas.from = meant(found);
    canvas.to = canvas.from;
    canvas.chosen = found.point || found.link;
    paint();
  });
  on(at, "pointermove", e => {
    if (!canvas.from) return;
    const { from } = canvas;
    if (canvas.tool === "move" && from.point) {
      const to = meant({ ...under(e), point: "" });
      from.moved ||= to.at.some((/** @type {number} */ v, /** @type {number} */ k) => v !== from.at[k]);
      if (from.moved) { shifted(canvas.sketch, from.point, to.at); taught(); }
    } else canvas.to = meant(under(e, from.point), from);
    paint();
  });
  on(at, "pointerup", e => {
    const { from } = canvas, still = Math.hypot(e.clientX - down[0], e.clientY - down[1]) < STILL_PX;
    canvas.hands++;
    if (!from) return;
    const dragged = DRAGGED.includes(canvas.tool);
    if (dragged && still && !canvas.held && canvas.tool !== "motor") { canvas.held = true; return; }
    const other = under(e, from.point);
    act(dragged ? meant(other, from) : canvas.tool === "move" ? other : meant(under(e)), from);
    paint();
  });
  on(at, "pointercancel", dropped);
  on(at, "keydown", e => {
    const { sketch, chosen } = canvas, names = [...Object.keys(sketch.points), ...Object.keys(sketch.links)];
    const k = names.indexOf(chosen);
    const way = /** @type {Record<string, Spot>} */ ({ ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1],
      ArrowDown: [0, -1] })[e.key];
    if (e.key === "Tab" && !e.ctrlKey && names.length && k + (e.shiftKey ? -1 : 1) in names) {
      canvas.chosen = names[k + (e.shiftKey ? -1 : 1)];
      e.preventDefault();
    } else if (way && chosen in sketch.points) {
      shifted(sketch, chosen, sketch.points[chosen].map((v, i) => v + way[i] * step()));
      taught();
      canvas.changed("move", true);
      e.preventDefault();
    } else if (e.key === "Delete" && chosen) {
      ACTS.remove(chosenEnd(), null);
      canvas.changed("remove", true);
    } else if (e.key === "Enter" && k >= 0 && canvas.tool !== "move") {
      const end = chosenEnd();
      if (DRAGGED.includes(canvas.tool) && !canvas.held) Object.assign(canvas, { from: end, to: end, held: true });
      else act(end, canvas.from);
      e.preventDefault();
    } else if (e.key === "Escape") dropped();
    paint();
  });
  new ResizeObserver(() => { if (!canvas.from) resized(); }).observe(at);
}
