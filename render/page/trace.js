// Tracing paper: the correct plan over a picture of a drawing, moved by its pole, turned and scaled by a mark.
import { $, on } from "./dom.js";
import { Figure } from "./figure.js";
import { Handles } from "./handles.js";
import { circle, svg } from "./svg.js";

const data = JSON.parse(document.getElementById("data").textContent);
// a place of the plan (mm, y up) lies at pole + turn · its mirror image, in pixels of the picture (y down)
const state = { plan: data.plans[0], pole: [0, 0], turn: [1, 0], size: [1200, 800], file: "" };

class Tracing extends Figure {
  zoom = 1;
  /** @type {(p: Spot) => Spot} */
  px([x, y]) {
    const [a, b] = state.turn, k = this.zoom;
    return [k * (state.pole[0] + a * x + b * y), k * (state.pole[1] + b * x - a * y)];
  }
  /** @type {(name: string) => Spot} */
  at(name) { return state.plan.marks[name]; }
  draw() {
    const view = this.node.getBoundingClientRect(), { plan } = state;
    this.w = view.width; this.h = view.height; this.zoom = view.width / state.size[0];
    this.node.textContent = "";
    this.node.setAttribute("viewBox", `0 0 ${this.w} ${this.h}`);
    this.strokes = []; this.taken = [];
    this.ink = svg("g", { opacity: +$("paper").value / 100 }, this.node);
    const whole = this.node;
    this.node = this.ink;
    if ($("ink").checked) for (const [a, b] of plan.vectors) {
      if (plan.kind === "position") this.line(this.px(this.at(a)), this.px(this.at(b)), "ink");
      else this.arrow(this.px(this.at(a)), this.px(this.at(b)), "ink");
    }
    if ($("names").checked) this.names(plan);
    this.node = whole;
    for (const n of ["p", $("by").value]) this.handle(n);
  }
  /** @type {(plan: any) => void} */
  names(plan) {
    for (const [name, a, b] of plan.names) this.along(this.px(this.at(a)), this.px(this.at(b)), [name], plan.kind);
    const marks = Object.keys(plan.marks).filter(n => !plan.names.length || n === "p");
    for (const n of marks) if (plan.kind !== "position" || n !== "p") {
      this.beside(this.px(this.at(n)), [n], plan.kind, 8);
    }
  }
  /** @type {(name: string) => void} */
  handle(name) {
    const q = this.px(this.at(name));
    circle(q, 6, "dot", this.grip(q, name, `${name === "p" ? data.words.pole : name}: ${place(name).join(", ")}`));
  }
}
const sheet = new Tracing($("sheet"), data);
const handles = new Handles(sheet.node, (name, e) => {
  const box = sheet.node.getBoundingClientRect();
  move(name, (e.clientX - box.left) / sheet.zoom, (e.clientY - box.top) / sheet.zoom);
}, (name, way, e) => {
  const [x, y] = sheet.px(sheet.at(name)).map(v => v / sheet.zoom), k = e.shiftKey ? 10 : 1;
  move(name, x + k * way[0], y + k * way[1]);
});

/** @type {(name: string) => Spot} */
function place(name) { return sheet.px(sheet.at(name)).map(v => Math.round(v / sheet.zoom)); }
/** @type {(v: number, digits: number) => string} */
function shown(v, digits) { const t = v.toFixed(digits);
  return document.documentElement.lang !== "en" ? t.replace(".", ",") : t; }
function draw() {
  handles.redraw(() => sheet.draw());
  const turned = Math.atan2(-state.turn[1], state.turn[0]) * 180 / Math.PI, by = $("by").value;
  $("said").innerHTML = `${data.words.turned} <b>${shown(turned, 1).replace("-",
    "−")}°</b>, <b>${shown(Math.hypot(...state.turn), 2)}</b> ${data.words.scale}`;
  $("check").hidden = !state.file;
  const file = /^[\w.,+-]+$/.test(state.file) ? state.file : `'${state.file.replaceAll("'", "'\\''")}'`;
  const mark = /'/.test(by) ? `"${by}=` : `${by}=`;
  const end = /'/.test(by) ? '"' : "";
  $("command").textContent = state.plan.command.replace("⟦file⟧", file).replace("⟦pole⟧",
    place("p").join(",")).replace("⟦mark⟧", mark + place(by).join(",") + end);
}
/** @type {(name: string, x: number, y: number) => void} */
function move(name, x, y) { // pixels of the picture
  if (name === "p") state.pole = [x, y];
  else {
    const [u, v] = sheet.at(name), dx = x - state.pole[0], dy = y - state.pole[1], n = u * u + v * v;
    if (Math.hypot(dx, dy) > 3) state.turn = [(dx * u - dy * v) / n, (dx * v + dy * u) / n];
  }
  draw();
}
function home() { // the plan in the middle, filling half the sheet
  const [w, h] = state.size, [x0, y0, x1, y1] = sheet.box(Object.keys(state.plan.marks));
  const k = 0.55 * Math.min(w / Math.max(x1 - x0, 1), h / Math.max(y1 - y0, 1));
  state.turn = [k, 0];
  state.pole = [w / 2 - k * (x0 + x1) / 2, h / 2 + k * (y0 + y1) / 2];
}
function choose() { // another plan keeps the scale and the pole: it is on the same sheet
  state.plan = data.plans.find((/** @type {any} */ p) => p.key === $("plan").value);
  const marks = Object.keys(state.plan.marks).filter(n => Math.hypot(...state.plan.marks[n]) > 1);
  $("by").replaceChildren(...marks.map(n => new Option(n, n, false, n === state.plan.far)));
  home();
  draw();
}
function lay() { // the paper as wide as the window, or wider
  const paper = document.querySelector(".paper"), width = +$("zoom").value / 100 * paper.parentNode.clientWidth;
  paper.style.width = `${width}px`;
  paper.style.height = `${width * state.size[1] / state.size[0]}px`;
  draw();
}
/** @type {(file: File) => void} */
function open(file) {
  if (!file) return;
  const image = /** @type {any} */ ($("image")), url = URL.createObjectURL(file);
  image.onload = () => {
    state.size = [image.naturalWidth || 1200, image.naturalHeight || 800];
    state.file = file.name;
    image.hidden = false;
    home();
    lay();
  };
  image.onerror = () => { image.hidden = true; state.file = ""; draw(); $("said").textContent = data.words.not_picture;
    };
  image.src = url;
}
on(document, "dragover", e => e.preventDefault());
on(document, "drop", e => { e.preventDefault(); open(e.dataTransfer.files[0]); });
$("file").onchange = () => open(/** @type {FileList} */ ($("file").files)[0]);
$("plan").replaceChildren(...data.plans.map((/** @type {any} */ p) => new Option(p.title, p.key)));
$("plan").onchange = choose;
$("by").onchange = $("ink").onchange = $("names").onchange = $("paper").oninput = draw;
$("picture").oninput = () => { $("image").style.opacity = String(+$("picture").value / 100); };
$("zoom").oninput = lay;
on(window, "resize", lay);
choose();
lay();
globalThis.planes = { data, lay, sheet, state };
