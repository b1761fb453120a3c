// The report on a checked drawing: layers, the table of steps, marks to move by hand or keys; every move is judged
// again.
import { $, on, safe } from "./dom.js";
import { Figure } from "./figure.js";
import { distance } from "./geometry.js";
import { Handles } from "./handles.js";
import { Judge } from "./judge.js";
import { letters } from "./labels.js";
import { html } from "./letters.js";
import { circle, end, svg } from "./svg.js";

const data = JSON.parse(document.getElementById("data").textContent);

class Sheet extends Figure { // the drawing under its marks, on one scale
  /** @param {Element} node @param {any} data */
  constructor(node, data) {
    super(node, { ...data, marks: {} });
    this.own = /** @type {any} */ (null);
    this.layers = /** @type {Record<string, boolean>} */ ({ picture: true, own: true, next: true, truth: true });
  }
  /** @type {(at: There) => { vectors: any[][], at: There }} */
  laid(at) { // vectors with their names, and the places of the marks: a force polygon in the student's order
    const { order, rows, vectors, chained } = this.data, places = /** @type {Record<string, any>} */ ({});
    if (!order.length) return { vectors: chained ? rows.map((/** @type {any} */ [n, a, b]) => [at(a), at(b), n, b]) :
      vectors.map((/** @type {any} */ [a, b]) => [at(a), at(b)]), at };
    let z = [0, 0];
    const out = [];
    for (const [name, start, end] of order) {
      const a = at(start), b = at(end);
      if (!a || !b) continue;
      const next = [z[0] + b[0] - a[0], z[1] + b[1] - a[1]];
      out.push([z, next, name, end]);
      places[end] ||= next;
      z = next;
    }
    return { vectors: out, at: name => name !== "p" && places[name] || at(name) };
  }
  /** @type {(marks: Mark[], found: Found) => void} */
  draw(marks, found) {
    this.measure();
    this.data.marks = { p: [0, 0] };
    for (const m of marks) if (m.read) this.data.marks[m.name] = [m.x, m.y];
    this.start(this.data.box);
    const on = this.layers, ghost = /** @type {Record<string, any>} */ ({});
    if (on.picture) this.under();
    const own = this.own = this.laid(n => this.at(n)), truth = this.laid(n => this.data.truth[n]);
    if (on.truth) for (const [a, b] of truth.vectors) this.vector(a, b, "truth");
    for (const m of marks) {
      const { own, verdict } = found.marks[m.name];
      if (!own || own.size <= 0.5 || (verdict === "right" && own.size > own.reach(found.limit))) continue;
      const [x, y] = this.own.at(m.name);
      ghost[m.name] = this.px([x - own.x, y - own.y]);
    }
    if (on.next) for (const n in ghost) this.line(this.px(own.at(n)), ghost[n], "next", "", false);
    if (on.next) for (const n in ghost) circle(ghost[n], 4, "next", this.node);
    if (on.own) for (const [a, b] of own.vectors) this.vector(a, b, "own");
    const named = this.data.chained && on.own ? this.forces() : new Set(), pole = this.px([0, 0]);
    // a scheme has none otherwise
    if (this.data.kind !== "position" || original.every((/** @type {Mark} */ m) => !m.read)) this.pole(pole);
    marks.forEach((m, k) => this.handle(m, found.marks[m.name], k, named.has(m.name)));
    end();
  }
  forces() { // names of forces are beside their vectors; of a zero vector, at the mark
    const named = new Set();
    for (const [a, b, name, end] of this.own.vectors) {
      const p = a && this.px(a), q = b && this.px(b);
      if (!p || !q || distance(p, q) < 12) continue;
      this.along(p, q, [name], this.data.kind);
      named.add(end);
    }
    return named;
  }
  /** @type {(a: Spot, b: Spot, cls: string) => void} */
  vector(a, b, cls) { // a link of a scheme has no arrowhead
    if (!a || !b) return;
    if (this.data.kind === "position") this.line(this.px(a), this.px(b), cls);
      else this.arrow(this.px(a), this.px(b), cls);
  }
  under() { // the picture, or the lines of a drawing of lines
    const { picture, strokes } = this.data;
    if (picture) {
      const [x, y] = this.px([picture.box[0], picture.box[3]]), [far, low] = this.px([picture.box[2], picture.box[1]]);
      svg("image", { href: picture.href, x, y, width: far - x, height: low - y, preserveAspectRatio: "none",
        class: "picture" }, this.node);
    }
    for (const [a, b, c, d] of strokes) this.line(this.px([a, b]), this.px([c, d]), "stroke", "", false);
  }
  /** @type {(q: Spot) => void} */
  pole(q) { // on a picture it is corrected like any mark; a polygon in another order does not depend on it alone
    const free = this.data.picture && !this.data.order.length;
    circle(q, 3.5, "pole", free ? this.grip(q, "p", "p") : this.node);
    this.beside(q, ["p"], this.data.kind);
  }
  /** @type {(k: number) => Spot} */
  parked(k) { return [this.w - 26, 30 + 34 * k]; } // marks not recognised wait at the edge
  /** @type {(m: Mark, found: Judged, k: number, named: boolean) => void} */
  handle(m, found, k, named) {
    const q = m.read ? this.px(this.own.at(m.name)) : this.parked(k);
    const place = m.read ? `x ${m.x.toFixed(1)}, y ${m.y.toFixed(1)}` : "";
    const g = this.grip(q, m.name, `${m.name}: ${data.words[found.verdict]}. ${place}`, found.verdict);
    circle(q, 6, "dot", g);
    if (found.verdict === "wrong") svg("path", { d: `M${q[0] - 3} ${q[1] - 3}l6 6m0 -6l-6 6`, class: "cross" }, g);
    if (m.read && named) return;
    if (m.read) this.beside(q, [m.name], this.data.kind, 9);
      else letters(this.node, [m.name], q[0] - 24, q[1] + 5, 15, this.data.kind);
  }
}

const original = data.marks.map((/** @type {Mark} */ m) => ({ ...m }));
const sheet = new Sheet($("sheet"), data), judge = new Judge(data);
let marks = original.map((/** @type {Mark} */ m) => ({ ...m })), found = /** @type {any} */ (null);
let moved = false, shifted = [0, 0];
const handles = new Handles(sheet.node, (name, e) => {
  const [x, y] = mm(e);
  drag(name, x, y);
}, (name, [dx, dy], e) => {
  const m = marks.find((/** @type {Mark} */ m) => m.name === name), k = e.shiftKey ? 5 : e.altKey ? 0.1 : 0.5;
  const from = !m ? [0, 0] : m.read ? sheet.own.at(name) : sheet.mm(sheet.parked(marks.indexOf(m)));
  drag(name, from[0] + k * dx, from[1] - k * dy);
});

function draw() {
  found = judge.judge(marks);
  handles.redraw(() => sheet.draw(marks, found));
  if (!moved) return; // the printed outcome stays until a mark is moved
  /** @type {(text: string) => void} */
  say(found.sentence);
  document.body.className = found.verdict;
  $("chance").style.visibility = "hidden"; // the drawing stays in place
  for (const old of document.querySelectorAll(".places, #as-read, .printed")) old.hidden = true;
  $("moved").hidden = false;
  table();
}
function say(/** @type {string} */ text) { // names lettered as on the plan, commands kept on one line
  let told = "", end = 0;
  for (const m of text.matchAll(new RegExp(data.sought, "g"))) {
    told += safe(text.slice(end, m.index)) + (m[1] ? `<span class="command">${safe(m[1])}</span>` :
      `<i>${html(m[2], data.kind)}</i>`);
    end = m.index + m[0].length;
  }
  $("sentence").innerHTML = told + safe(text.slice(end));
}
function table() {
  const sign = document.documentElement.lang !== "en" ? "," : ".";
  /** @type {(v: number) => string} */
  const mm = v => v === undefined || !Number.isFinite(v) ? "—" : v.toFixed(1).replace(".", sign);
  document.querySelectorAll("#marks tbody tr").forEach(row => {
    const one = found.marks[row.dataset.mark], [own, limit, off, word] = row.querySelectorAll("td");
    row.className = one.verdict;
    const aside = one.verdict === "right" && one.own?.size > one.own?.reach(found.limit); // see rows_of
    const more = aside ? "true_place" : one.close && "close";
    own.textContent = mm(one.own?.size);
    limit.textContent = mm(one.own?.reach(found.limit));
    off.textContent = mm(one.free?.size);
    word.textContent = data.words[one.verdict] + (more ? ` (${data.words[more]})` : "");
  });
}
/** @type {(name: string, x: number, y: number) => void} */
function move(name, x, y) {
  const m = marks.find((/** @type {Mark} */ m) => m.name === name);
  Object.assign(m, { x, y, read: true });
  handles.held = name;
  moved = true;
  draw();
}
/** @type {(x: number, y: number) => void} */
function origin(x, y) { // the pole moves on the picture: everything visible there stays
  for (const m of marks) if (m.read) { m.x -= x; m.y -= y; }
  for (const box of [data.box, data.picture.box]) for (let k = 0; k < 4; k++) box[k] -= k % 2 ? y : x;
  shifted = [shifted[0] + x, shifted[1] + y];
  handles.held = "p";
  moved = true;
  draw();
}
// to the place shown: in a polygon of another order only the two sides that meet there change
/** @type {(name: string, x: number, y: number) => void} */
function drag(name, x, y) {
  if (name === "p") return origin(x, y);
  const k = data.order.findIndex((/** @type {any} */ [, , end]) => end === name);
  if (k < 0 || !marks.find((/** @type {Mark} */ m) => m.name === name).read) return move(name, x, y);
  const [x0, y0] = sheet.own.at(name), next = data.order[k + 1];
  const shift = (/** @type {string} */ mark, /** @type {number} */ sign) => { // with all that depends on it
    const after = new Set([mark]), placed = new Set(["p"]);
    for (const [, a, b] of data.rows) if (!placed.has(b)) { placed.add(b); if (after.has(a)) after.add(b); }
    for (const m of marks) if (m.read && after.has(m.name)) { m.x += sign * (x - x0); m.y += sign * (y - y0); }
  };
  shift(name, 1);
  if (next && marks.some((/** @type {Mark} */ m) => m.name === next[2]) &&
    data.order.findIndex((/** @type {any} */ [, , end]) => end === next[2]) === k + 1) shift(next[2], -1);
  const m = marks.find((/** @type {Mark} */ m) => m.name === name);
  move(name, m.x, m.y);
}
function reset() {
  if (shifted.some(Math.abs)) origin(-shifted[0], -shifted[1]);
  marks = original.map((/** @type {Mark} */ m) => ({ ...m })); moved = true; draw(); $("moved").hidden = true;
}
function csv() { // the marks as a table for the program, and its command; in a row "p" the pen returns to the pole
  const rows = [`# ${document.querySelector("code").textContent}`, "mark,x_mm,y_mm,error_mm"];
  const at = (/** @type {string} */ n) => n === "p" ? { x: 0, y: 0, error: 0 } :
    marks.find((/** @type {Mark} */ m) => m.name === n);
  /** @type {(name: string, m: Mark) => void} */
  const row = (name, m) => rows.push(`${name},${m.x.toFixed(3)},${m.y.toFixed(3)},${m.error}`);
  const { look, name } = $("save").dataset;
  if (look) rows.splice(1, 0, `# sheet ${look} ${name}`); // the drawing the marks belong to
  // the place of the picture
  if (data.picture) rows.splice(1, 0,
    `# box ${data.picture.box.map((/** @type {number} */ v) => v.toFixed(3)).join(" ")}`);
  let pen = "p";
  row("p", at("p"));
  for (const [name, start, end] of data.rows) {
    if (![start, end].every(n => n === "p" || at(n)?.read)) continue;
    if (start !== pen) row("p", at(start));
    row(name, at(end));
    pen = data.chained ? end : "p";
  }
  return rows.join("\n") + "\n";
}
function save() {
  const a = document.createElement("a");
  a.href = URL.createObjectURL(new Blob([csv()], { type: "text/csv" }));
  a.download = $("save").dataset.name || ""; // with the picture's name: put beside it, the next run uses it
  a.click();
  setTimeout(() => URL.revokeObjectURL(a.href), 1000);
}
/** @type {(e: MouseEvent) => Spot} */
function mm(e) {
  const box = sheet.node.getBoundingClientRect();
  return sheet.mm([(e.clientX - box.left) * sheet.w / box.width, (e.clientY - box.top) * sheet.h / box.height]);
}
document.querySelectorAll("input[data-layer]").forEach(i => {
  i.onchange = () => { sheet.layers[i.dataset.layer] = i.checked; draw(); }; });
$("save").onclick = save;
$("as-read")?.addEventListener("click", () => { moved = true; draw(); });
$("reset").onclick = reset;
on(window, "resize", draw);
on(window, "beforeprint", () => { // relative to the sheet's width, so that letters keep their size
  sheet.node.style.cssText = "width: 700px; height: 400px";
  draw();
  sheet.node.style.cssText = "";
});
on(window, "afterprint", draw);
draw();
globalThis.planes = { // the interface of the page for scripts
  csv, data, drag, draw, move, sheet,
  get found() { return found; },
  get marks() { return marks; },
};
