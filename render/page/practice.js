"use strict";
// Practice: the reader does the step. Right and wrong answers come with the lesson; here they are only compared.
const CLOSE_MM = 2.5, CLOSE_PX = 12, TRIES = 3;

const practice = {
  on: false, index: 0, stage: 0, tries: 0, good: 0, asked: 0, marks: {}, said: null, list: false, done: [],
  toggle() {
    this.on = !this.on;
    $("practise").setAttribute("aria-pressed", this.on);
    document.body.classList.toggle("practising", this.on);
    $("told").hidden = this.on;
    $("task").hidden = !this.on;
    if (state.timer) play();
    if (state.spin) spin(false);
    for (const id of ["play", "progress"]) $(id).disabled = this.on;
    if (this.on) {
      const from = this.over ? 0 : state.frame; // a practice that is done begins anew
      Object.assign(this, { stage: 0, tries: 0, good: 0, asked: 0, said: null, done: [], over: false });
      this.index = Math.max(0, data.practice.findIndex(t => t.frame >= from));
      this.open();
    } else draw();
  },
  get task() { return data.practice[this.index]; },
  get frame() { return data.frames[this.task.frame]; },
  get stages() {
    const t = this.task, e = this.frame.equation, list = [];
    const first = e !== null && data.equations[e].total && !["position"].includes(this.frame.plan) && !this.done.includes(e);
    if (first) list.push("known");
    if (t.kind === "lay_off") list.push("direction", "length");
    else list.push(...(t.lines || []).map((_, k) => "line" + k), "place");
    return list;
  },
  get now() { return this.order[this.stage]; },
  open() { // a new task: the drawing as far as it was, in the lesson's own position
    live.reset();
    state.frame = this.task.frame;
    this.order = this.stages;
    this.stage = this.tries = 0;
    this.marks = {};
    this.list = false;
    draw();
  },
  seen() {
    const seen = seenAt(this.over ? data.frames.length - 1 : this.task.frame - 1), pole = this.frame.plan + ":p";
    return seen.add(pole);
  },
  asking(name) { return this.on && this.now === "known" && name in this.goal(); },
  given(name) { return this.marks[name] || 0; },
  goal() {
    const e = this.frame.equation === null ? null : data.equations[this.frame.equation];
    return e ? Object.fromEntries([...terms(e), ...(e.total.known ? [e.total] : [])].filter(t => t.action !== "=0").map(t => [t.name, t.known])) : {};
  },
  answer(right, said) {
    if (this.tries === 0) this.asked += 1;
    if (right) {
      if (this.tries === 0) this.good += 1;
      this.said = ["yes", say("right")];
      this.move();
      return;
    }
    this.tries += 1;
    const reason = (said || this.frame.why[state.lang]).replace(/\.?$/, ".");
    this.said = ["no", reason];
    if (this.tries >= TRIES) { this.said = ["no", `${reason} ${say("shown")}`]; this.move(); return; }
    draw();
  },
  move() {
    if (this.now === "known") this.done.push(this.frame.equation);
    this.tries = 0;
    this.list = false;
    if (this.stage + 1 < this.order.length) { this.stage += 1; draw(); return; }
    if (this.index + 1 < data.practice.length) { this.index += 1; const said = this.said; this.open(); this.said = said; draw(); return; }
    this.over = true;
    draw();
  },
  named(slips, near = () => 0) { // every mistake that leads to this answer, the nearest first
    const fit = slips.filter(w => near(w) <= 1).sort((a, b) => near(a) - near(b));
    return [...new Set(fit.map(w => w.said[state.lang]))].join(`; ${say("or_else")} `);
  },
  mark(label) { const full = label.slice(label.lastIndexOf(":") + 1); return `⟨${full.replace("°", "")}⟩`; },
  paint() { // the question, and what may be clicked
    const box = $("task"), f = this.frame, text = t => sentence(t, f.plan);
    for (const id of ["scheme", "plan"]) {
      $(id).classList.remove("place");
    }
    $("back").disabled = this.index === 0; $("next").disabled = this.index + 1 >= data.practice.length;
    $("number").textContent = `${this.index + 1} / ${data.practice.length}`;
    const said = this.said ? `<p class="said ${this.said[0]}">${this.said[0] === "yes" ? "✓" : "✗"} ${text(this.said[1])}</p>` : "";
    const score = `<span class="score">${say("score")}: ${this.good} / ${this.asked}</span>`;
    if (this.over) { box.innerHTML = `${said}<h2>${say("over")} ${this.good} / ${this.asked}.</h2><div class="answers"><button type="button" data-do="again">${say("again")}</button></div>`; return; }
    const held = box.contains(document.activeElement);
    box.innerHTML = `${score}<h2 tabindex="-1">${text(this.question())}</h2>${this.choices()}${said}`;
    this.aid();
    if (held) (box.querySelector("input") || box.querySelector("h2")).focus(); // where the hand was
  },
  question() {
    const t = this.task, mark = this.mark(t.mark), name = this.frame.terms[0] || t.mark.split(":").pop();
    const line = this.now.startsWith("line") ? t.lines[+this.now.slice(4)] : null;
    const asks = { known: "ask_known", direction: "ask_direction", length: "ask_length", place: t.kind === "similar" ? "ask_similar" : "ask_place" };
    return say(line ? "ask_line" : asks[this.now]).replace("{mark}", mark).replace("{name}", `⟨${name}⟩`).replace("{through}", line ? this.mark(line.through) : "").replace("{start}", t.start ? this.mark(t.start) : "");
  },
  choices() {
    const t = this.task, button = (what, label) => `<button type="button" data-do="${what}">${label}</button>`;
    let body = "";
    if (this.now === "known") {
      body = Object.keys(this.goal()).map(n => `<button type="button" class="term known${this.given(n)}" data-do="known" data-term="${n}" aria-label="${n}: ${this.given(n)}"><b>${html(n)}</b></button>`).join("") + button("check", say("check"));
    } else if (this.now === "direction") body = this.rays().map((_, k) => button("ray" + k, k + 1)).join("");
    else if (this.now === "length") {
      const given = this.frame.values.map(n => `⟨${n}⟩ = ⟦v¦${n}⟧ ${(data.units[n] || {})[state.lang] || ""}`.trim()).join("; "), mu = filled(data.plans.find(p => p.key === this.frame.plan).mu[state.lang]);
      body = `<span>${sentence(given, this.frame.plan)}; μ = ${mu}</span><input id="length" type="text" inputmode="decimal" aria-label="${say("millimetres")}"> ${say("millimetres")} ${button("length", say("check"))}`;
    } else if (this.now.startsWith("line")) {
      body = t.lines[+this.now.slice(4)].options.map((o, k) => button("line" + k, o.text)).join("");
    } else body = this.list ? this.spots().map((_, k) => button("spot" + k, k + 1)).join("") : button("list", say("list"));
    return `<div class="answers">${body}</div>`;
  },
  rays() { // four ways from the start of the vector, in the order of the clock
    const a = this.task.angle;
    return [0, 1, 2, 3].map(k => ({ quarter: k, angle: (((a + 90 * k) % 360) + 360) % 360 })).sort((x, y) => x.angle - y.angle);
  },
  spots() { // the right place among those of the mistakes, each once, from left to right
    const at = plan.at(this.task.mark), same = (v, w) => v.at[0] === w.at[0] && v.at[1] === w.at[1];
    const near = this.task.places.filter((w, k, all) => this.inside(w.at) && all.findIndex(v => same(v, w)) === k).slice(0, 5);
    return [{ at, right: true }, ...near].sort((a, b) => a.at[0] - b.at[0]);
  },
  inside(p) { const [x, y] = this.panel().px(p); return x > 5 && y > 5 && x < this.panel().w - 5 && y < this.panel().h - 5; },
  panel() { return this.frame.plan === "position" ? scheme : plan; },
  aid() { // what helps to answer, drawn on the plan
    const p = this.panel(), t = this.task, circle = (q, label, act) => {
      svg("circle", { cx: q[0], cy: q[1], r: 13, class: "choice", "data-do": act }, p.node);
      svg("text", { x: q[0], y: q[1] + 4.5, "text-anchor": "middle", class: "choice-text" }, p.node).textContent = label;
    };
    if (this.now === "direction") {
      const a = p.px(p.at(t.start));
      this.rays().forEach((r, k) => {
        const c = Math.cos(r.angle * Math.PI / 180), s = -Math.sin(r.angle * Math.PI / 180);
        p.arrow(a, [a[0] + 64 * c, a[1] + 64 * s], "ask");
        circle([a[0] + 78 * c, a[1] + 78 * s], k + 1, "ray" + k);
      });
    }
    if (this.now === "place") {
      const q = p.px(p.at(t.mark)), far = 1.5 * (p.w + p.h);
      for (const n of (data.traces[t.mark] || {}).lines || []) {
        const a = p.at(n) && p.px(p.at(n)), d = a ? Math.hypot(q[0] - a[0], q[1] - a[1]) : 0;
        if (d > 0.5) p.line([a[0] - (q[0] - a[0]) * far / d, a[1] - (q[1] - a[1]) * far / d], [a[0] + (q[0] - a[0]) * far / d, a[1] + (q[1] - a[1]) * far / d], "trace", "", false);
      }
      for (const n of (data.traces[t.mark] || {}).arcs || []) {
        const a = p.px(p.at(n));
        svg("circle", { cx: a[0], cy: a[1], r: Math.hypot(q[0] - a[0], q[1] - a[1]), class: "trace" }, p.node);
      }
      if (this.list) this.spots().forEach((s, k) => circle(p.px(s.at), k + 1, "spot" + k));
      else p.node.classList.add("place");
    }
  },
  pick(what, e) { // an answer by a button, or by what stands for it on the plan
    const t = this.task, k = +what.replace(/\D/g, "");
    if (what === "again") { this.on = false; this.toggle(); }
    else if (what === "known") { const n = e.dataset.term; this.marks[n] = (this.given(n) + 1) % 3; draw(); const again = [...document.querySelectorAll("[data-term]")].find(b => b.dataset.term === n); if (again) again.focus(); }
    else if (what === "check") this.answer(Object.entries(this.goal()).every(([n, v]) => this.given(n) === v), say("why_known"));
    else if (what.startsWith("ray")) {
      const q = this.rays()[k].quarter;
      this.answer(q === 0, this.named(t.turned[q] || []));
    } else if (what === "length") this.measure($("length").value);
    else if (what.startsWith("line")) {
      const o = t.lines[+this.now.slice(4)].options[k];
      this.answer(!!o.right, this.named(o.slips));
    } else if (what === "list") { this.list = true; draw(); }
    else if (what.startsWith("spot")) {
      const s = this.spots()[k];
      this.answer(!!s.right, this.named(t.places.filter(w => w.at[0] === s.at[0] && w.at[1] === s.at[1])));
    }
  },
  measure(text) {
    const given = parseFloat(text.replace(",", ".")), t = this.task;
    if (!Number.isFinite(given)) return;
    const off = (mm, least) => Math.abs(given - mm) / Math.max(least, 0.03 * mm);
    this.answer(off(t.mm, 1) <= 1, this.named(t.lengths, w => off(w.mm, Math.max(0.005, Math.min(0.4, 0.2 * w.mm)))));
  },
  click(event) {
    if (!this.on || this.over || this.now !== "place" || this.list) return;
    const p = this.panel(), r = p.node.getBoundingClientRect(), at = p.mm([event.clientX - r.left, event.clientY - r.top]);
    const right = p.at(this.task.mark), reach = Math.max(CLOSE_MM, CLOSE_PX / p.k);
    const off = q => Math.hypot(q[0] - at[0], q[1] - at[1]) / reach;
    this.answer(off(right) <= 1, this.named(this.task.places, w => off(w.at) / 1.4));
  },
};
$("practise").onclick = () => practice.toggle();
$("task").addEventListener("click", e => { const b = e.target.closest("[data-do]"); if (b) practice.pick(b.dataset.do, b); });
$("task").addEventListener("keydown", e => { if (e.key === "Enter" && e.target.id === "length") practice.pick("length", e.target); });
for (const id of ["scheme", "plan"]) $(id).addEventListener("click", e => {
  const b = e.target.closest("[data-do]");
  if (practice.on && b) practice.pick(b.dataset.do, b);
  else if (practice.on && practice.panel().node.id === id) practice.click(e);
});
for (const [id, by] of [["back", -1], ["next", 1]]) $(id).addEventListener("click", e => {
  if (!practice.on) return;
  e.stopImmediatePropagation();
  practice.index = clamp(practice.index + by, 0, data.practice.length - 1);
  Object.assign(practice, { said: null, over: false });
  practice.open();
}, true);
readAddress();
language();
draw();
