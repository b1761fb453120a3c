"use strict";
// The report of a checked drawing: layers, the table of steps, marks to move by hand or keys; every move is judged anew.
const data = JSON.parse(document.getElementById("data").textContent);
const $ = id => document.getElementById(id);
frameNumber = data.frame;

class Sheet extends Figure { // the drawing under its marks, on one scale
  constructor(node, data) {
    super(node, { ...data, marks: {} });
    this.layers = { picture: true, own: true, next: true, truth: true };
  }
  at(name) { return this.data.marks[name] || null; }
  draw(marks, found) {
    this.measure();
    this.data.marks = { p: [0, 0] };
    for (const m of marks) if (m.read) this.data.marks[m.name] = [m.x, m.y];
    this.start(this.data.box);
    const on = this.layers, ghost = {};
    if (on.picture) this.under();
    if (on.truth) for (const [a, b] of this.data.vectors) this.vector(this.data.truth[a], this.data.truth[b], "truth");
    for (const m of marks) {
      const own = found.marks[m.name].own;
      if (own && own.size > 0.5) ghost[m.name] = this.px([m.x - own.x, m.y - own.y]);
    }
    if (on.next) for (const n in ghost) this.line(this.px(this.at(n)), ghost[n], "next", "", false);
    if (on.next) for (const n in ghost) svg("circle", { cx: ghost[n][0], cy: ghost[n][1], r: 4, class: "next" }, this.node);
    if (on.own) for (const [a, b] of this.data.vectors) this.vector(this.at(a), this.at(b), "own");
    const named = this.data.chained && on.own ? this.forces() : new Set(), pole = this.px([0, 0]);
    svg("circle", { cx: pole[0], cy: pole[1], r: 3.5, class: "pole" }, this.node);
    this.beside(pole, ["p"], this.data.kind);
    marks.forEach((m, k) => this.handle(m, found.marks[m.name], k, named.has(m.name)));
  }
  forces() { // the names of forces stand beside their vectors; of what ends where it begins, at the mark
    const named = new Set();
    for (const [name, a, b] of this.data.rows) {
      const p = this.at(a) && this.px(this.at(a)), q = this.at(b) && this.px(this.at(b));
      if (!p || !q || Math.hypot(q[0] - p[0], q[1] - p[1]) < 12) continue;
      this.along(p, q, [name], this.data.kind);
      named.add(b);
    }
    return named;
  }
  vector(a, b, cls) { // of a scheme a link, which has no arrowhead
    if (!a || !b) return;
    if (this.data.kind === "position") this.line(this.px(a), this.px(b), cls); else this.arrow(this.px(a), this.px(b), cls);
  }
  under() { // the picture, or the lines of a drawing of lines
    const { picture, strokes } = this.data;
    if (picture) {
      const [x, y] = this.px([picture.box[0], picture.box[3]]), [far, low] = this.px([picture.box[2], picture.box[1]]);
      svg("image", { href: picture.href, x, y, width: far - x, height: low - y, preserveAspectRatio: "none", class: "picture" }, this.node);
    }
    for (const [a, b, c, d] of strokes) this.line(this.px([a, b]), this.px([c, d]), "stroke", "", false);
  }
  parked(k) { return [this.w - 26, 30 + 34 * k]; } // marks nobody has read wait at the edge
  handle(m, found, k, named) {
    const q = m.read ? this.px([m.x, m.y]) : this.parked(k);
    const g = svg("g", { class: `handle ${found.verdict}`, tabindex: 0, role: "button", "data-mark": m.name }, this.node);
    svg("circle", { cx: q[0], cy: q[1], r: 14, class: "grip" }, g);
    svg("circle", { cx: q[0], cy: q[1], r: 6, class: "dot" }, g);
    if (found.verdict === "wrong") svg("path", { d: `M${q[0] - 3} ${q[1] - 3}l6 6m0 -6l-6 6`, class: "cross" }, g);
    const place = m.read ? `x ${m.x.toFixed(1)}, y ${m.y.toFixed(1)}` : "";
    g.setAttribute("aria-label", `${m.name}: ${data.words[found.verdict]}. ${place}`);
    if (m.read && named) return;
    if (m.read) this.beside(q, [m.name], this.data.kind, 9); else letters(this.node, [m.name], q[0] - 24, q[1] + 5, 15, this.data.kind);
  }
}

const original = data.marks.map(m => ({ ...m }));
const sheet = new Sheet($("sheet"), data), judge = new Judge(data);
let marks = original.map(m => ({ ...m })), found = null, held = null, moved = false;

function draw() {
  const now = held; // drawing anew takes the focus away
  found = judge.judge(marks);
  sheet.draw(marks, found);
  held = now;
  if (held) sheet.node.querySelector(`[data-mark="${CSS.escape(held)}"]`)?.focus({ preventScroll: true });
  if (!moved) return; // what was printed stands until something is moved
  $("sentence").textContent = found.sentence;
  document.body.className = found.verdict;
  $("moved").hidden = false;
  table();
}
function table() {
  const mm = v => v === undefined || !Number.isFinite(v) ? "—" : v.toFixed(1);
  document.querySelectorAll("#marks tbody tr").forEach(row => {
    const one = found.marks[row.dataset.mark], [own, limit, off, word] = row.querySelectorAll("td");
    row.className = one.verdict;
    own.textContent = mm(one.own?.size);
    limit.textContent = mm(one.own?.reach(found.limit));
    off.textContent = mm(one.free?.size);
    word.textContent = data.words[one.verdict] + (one.close ? ` (${data.words.close})` : "");
  });
}
function move(name, x, y) {
  const m = marks.find(m => m.name === name);
  Object.assign(m, { x, y, read: true });
  held = name;
  moved = true;
  draw();
}
function reset() { marks = original.map(m => ({ ...m })); moved = true; draw(); $("moved").hidden = true; }
function csv() { // the marks as the table the program reads; a row "p" is where the pen is lifted to
  const rows = ["mark,x_mm,y_mm,error_mm"], at = n => n === "p" ? { x: 0, y: 0, error: 0 } : marks.find(m => m.name === n);
  const row = (name, m) => rows.push(`${name},${m.x.toFixed(3)},${m.y.toFixed(3)},${m.error}`);
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
  a.download = "marks.csv";
  a.click();
  setTimeout(() => URL.revokeObjectURL(a.href), 1000);
}
function mm(e) {
  const box = sheet.node.getBoundingClientRect();
  return sheet.mm([(e.clientX - box.left) * sheet.w / box.width, (e.clientY - box.top) * sheet.h / box.height]);
}
sheet.node.addEventListener("pointerdown", e => {
  const name = e.target.closest("[data-mark]")?.dataset.mark;
  if (!name) return;
  held = name;
  sheet.node.dragged = name;
  sheet.node.setPointerCapture(e.pointerId);
  e.preventDefault();
  e.target.closest("[data-mark]").focus({ preventScroll: true });
});
sheet.node.addEventListener("pointermove", e => { if (sheet.node.dragged) move(sheet.node.dragged, ...mm(e)); });
for (const end of ["pointerup", "pointercancel"]) sheet.node.addEventListener(end, () => { sheet.node.dragged = null; });
sheet.node.addEventListener("keydown", e => {
  const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[e.key];
  const name = e.target.closest("[data-mark]")?.dataset.mark;
  if (!way || !name) return;
  e.preventDefault();
  const m = marks.find(m => m.name === name), k = e.shiftKey ? 5 : e.altKey ? 0.1 : 0.5;
  const from = m.read ? [m.x, m.y] : sheet.mm(sheet.parked(marks.indexOf(m)));
  move(name, from[0] + k * way[0], from[1] + k * way[1]);
});
sheet.node.addEventListener("focusin", e => { held = e.target.closest("[data-mark]")?.dataset.mark || held; });
sheet.node.addEventListener("focusout", () => { if (!sheet.node.dragged) held = null; });
document.querySelectorAll("input[data-layer]").forEach(i => { i.onchange = () => { sheet.layers[i.dataset.layer] = i.checked; draw(); }; });
$("save").onclick = save;
$("reset").onclick = reset;
addEventListener("resize", draw);
addEventListener("beforeprint", draw);
document.querySelectorAll("tbody th").forEach(e => { e.innerHTML = html(e.textContent, data.kind); });
draw();
