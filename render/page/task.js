// The panel of practice: the question with its fields, the same for mouse and keyboard; the code to hand in.
import { NEAR_PX, desk } from "./desk.js";
import { buttons, chosen, question, reply } from "./choices.js";
import { $, on, safe } from "./dom.js";
import { plan, scheme } from "./figures.js";
import { distance } from "./geometry.js";
import { html, labelOf } from "./letters.js";
import { data, draw, later, live, state } from "./page.js";
import { practice } from "./practice.js";
import { filled, plain, say, sentence, spoken } from "./words.js";
const fields = /** @type {Record<string, any>} */ (desk); // by the ids of their inputs
export const TOOLS = ["vector", "line", "arc", "point", "ruler"];

export const task = {
  last: "",
  paint() {
    const box = $("task"), p = practice, text = (/** @type {string} */ t) => sentence(t, p.frame?.plan);
    for (const id of ["scheme", "plan"]) $(id).classList.remove("place");
    $("number").textContent = `${p.done.size} / ${p.items.length}`;
    $("back").disabled = $("next").disabled = p.over || p.open().length < 2;
    const said = p.said ? `<p class="said ${p.said[0]}">${p.said[0] === "yes" ? "✓" : "✗"} ${text(p.said[1])}</p>` : "";
    const held = /** @type {HTMLElement} */ (document.activeElement), data_ = held?.dataset?.term;
    const id = box.contains(held) ? held.id || "h" : "";
    const score = `<span class="score">${say("score")}: ${p.good} / ${p.asked}${p.seed ? ` · № ${p.seed}` : ""}</span>`;
    const now = p.over ? this.end(said) :
      `${score}<h2 id="h" tabindex="-1">${text(this.question())}</h2>${said}${this.fields()}`;
    if (!p.over) desk.paint();
    const same = now.replace(/(<input[^>]*) value="[^"]*"/g, "$1");
    if (same === this.last) { // the same question: the focus and the typed text stay
      for (const n of ["mm", "angle"]) if ($(n) && $(n).value !== String(fields[n])) $(n).value = fields[n];
      return;
    }
    this.last = same;
    box.innerHTML = now;
    if (p.over) this.sign(p.name);
    if (!id) return;
    const again = data_ ? [...box.querySelectorAll("[data-term]")].find(b => b.dataset.term === data_) : $(id);
    (again && !again.disabled ? again : box.querySelector("#mm, #figure, button[data-do], #h")).focus();
  },
  question() {
    const t = practice.item, f = practice.frame, own = (/** @type {string} */ n) => `⟨${n}⟩`;
    const unit = (data.units[t.what] || {})[state.lang] || "";
    if (t.kind === "known") return say("ask_known");
    if (chosen(t)) return question(t);
    if (t.kind === "sense" && !f.turns) return say("ask_turning").replace("{force}",
      own(t.what.slice(1))).replace("{about}", own(labelOf(data.moments[f.moments].about)));
    if (t.kind === "sense") return say("ask_sense").replace("{vector}", own(f.turns.vector)).replace("{rate}",
      own(t.what)).replace("{point}", own(labelOf(f.turns.point))).replace("{about}", own(labelOf(f.turns.about)));
    if (t.kind === "number") return `${own(t.what.replace(/[‖|]/g, ""))} = ? ${unit}${t.signed ?
      ` (${say("plus_ccw")})` : ""}`;
    return say(practice.laid && f.terms[0] ? "ask_vector" : "ask_mark").replace("{name}",
      f.terms.slice(0, 1).map(own).join("")).replace("{mark}", own(labelOf(t.what)));
  },
  fields() {
    const t = practice.item, open = practice.open();
    const row = (/** @type {string} */ inner) => `<div class="answers">${inner}</div>`;
    const choose = open.length > 1 ?
      `<label>${say("now")} ${this.select("now", open.map(k => [k, this.short(k)]), practice.index)}</label>` : "";
    const last = row(`${choose}${this.button("show", say("show"))}`);
    if (t.kind === "known") return row(
      practice.goal(practice.equation).map(
      g => `<button type="button" class="term known${practice.given(
      g.name)}" data-do="known" data-term="${g.name}" aria-label="${spoken(g.name)}: ${say("known" +
      practice.given(g.name))}"><b>${html(g.name)}</b></button>`).join("") + this.button("check", say("check"))) + last;
    if (t.kind === "sense") return row(this.button("ccw", "↺ " + say("ccw")) + this.button("cw", "↻ " + say("cw"))) +
      this.ruler() + last;
    if (t.kind === "mark") return row(this.tools()) + row(this.hand()) + last;
    if (chosen(t)) return row(buttons(t)) + last;
    return row(`<span>${this.told()}</span><label><span>${html(t.what.replace(/[‖|]/g,
      ""))} =</span> <input id="figure" type="text" inputmode="decimal" autocomplete="off"></label> ${
      (data.units[t.what] || {})[state.lang] || ""} ${this.button("number", say("check"))}`) + this.ruler() + last;
  },
  tools() {
    const one = (/** @type {string} */ n) => `<button type="button" id="tool-${n}" data-do="tool" data-tool="${n}"` +
      ` aria-pressed="${desk.tool === n}">${say("tool_" + n)}</button>`;
    return TOOLS.map(one).join("");
  },
  told() { // numbers that the question needs but does not ask for
    const asked = new Set(practice.items.filter((t, k) => t.kind === "number" &&
      !practice.done.has(k)).map(t => t.what.replace(/[‖|]/g, "")));
    const [scales, values] = [true, false].map(is => practice.frame.values.filter(n => n.startsWith("mu_") === is));
    const given = values.filter(n => !asked.has(n.replace(/[‖|]/g, ""))).map(n => `⟨${n.replace(/[‖|]/g,
      "")}⟩ = ⟦${/^h_/i.test(n) ? "a" : "v"}¦${n}⟧ ${(data.units[n] || {})[state.lang] || ""}`.trim());
    const mu = data.plans.filter(p => scales.includes("mu_" + p.key) || (practice.item.kind === "number" &&
      p.key === practice.frame.plan && !practice.waits("mu", p.key))).map(p => `μ = ${filled(p.mu[state.lang])}`);
    return sentence([...new Set([...given, ...mu])].join("; "), practice.frame.plan);
  },
  hand() { // the fields of the current tool
    const marks = desk.marks().map(m => [m, spoken(labelOf(m), practice.frame.plan)]);
    const from = `<label>${say("from")} ${this.select("from", marks, desk.from)}</label>`;
    const draw_ = this.button("draw", say("draw"));
    const mm = (/** @type {string} */ name) => `<label>${say(
      name)} <input id="mm" type="text" inputmode="decimal" autocomplete="off" value="${safe(desk.mm)}"> ${say(
      "millimetres")}</label>`;
    if (desk.tool === "ruler") return this.measures(marks);
    if (desk.tool === "arc") return from + mm("radius") + draw_ + this.erase();
    if (desk.tool === "point") {
      const spots = desk.crossings().map((_, k) => [k, k + 1]);
      return (spots.length ? `<label>${say("crossing")} ${this.select("spot", spots,
        desk.spot)}</label>${this.button("draw", say("mark_it"))}` : `<span>${say("no_crossing")}</span>`) +
        this.erase();
    }
    const along = `<label>${say("along")} ${this.select("along", desk.lines(), desk.along)}</label>`;
    const angle = desk.along === "angle" ?
      `<label>${say("degrees")} <input id="angle" type="text" inputmode="decimal" autocomplete="off" value="${safe(
      desk.angle)}"></label>` : "";
    const both = desk.tool === "vector" && desk.along.includes("|") ?
      `<label>${say("way")} ${this.select("way", desk.ways().map((w, k) => [k, w]), +desk.back)}</label>` : "";
    return from + along + angle + both + (desk.tool === "vector" ? mm("long") : "") + draw_ + this.erase();
  },
  ruler() { return `<div class="answers">${this.measures(desk.marks().map(m => [m,
    spoken(labelOf(m), practice.frame.plan)]))}</div>`; },
  /** @type {(marks: string[][]) => string} */
  measures(marks) {
    const m = practice.frame.moments;
    const feet = m === null ? [] :
      data.moments[m].forces.filter(f => f.foot && live.at(f.foot)).map(f => [f.foot, "⊥ " + spoken(f.name)]);
    const all = [...marks, ...feet];
    return marks.length > 1 ?
      `<label>${say("tool_ruler")} ${this.select("from", all,
      desk.from)}</label> <label>${say("to")} ${this.select("to", all,
      desk.to)}</label> <output>${desk.ruler()} ${say("millimetres")}</output>` : "";
  },
  erase() { return desk.strokes.length ? this.button("erase", say("erase")) : ""; },
  /** @type {(k: number) => string} */
  short(k) { const t = practice.items[k], key = data.frames[t.frame].plan;
    if (chosen(t)) return t.kind === "mu" ? "μ = ?" : plain(question(t), key);
    return `${t.kind === "known" ? say("equation") :
    spoken(t.kind === "mark" ? labelOf(t.what) : t.what.replace(/[‖|↺]/g, ""), key)}${t.kind === "mark" ? "" :
    t.kind === "sense" ? " ↺" : t.kind === "known" ?
    " " + practice.goal(data.equations[t.what]).map(g => spoken(g.name)).slice(0, 3).join(" ") : " ="}`; },
  /** @type {(id: string, options: any[][], chosen: any) => string} */
  select(id, options, chosen) {
    return `<select id="${id}">${options.map(([v, text]) => `<option value="${safe(v)}"${String(v) === String(chosen) ?
    " selected" : ""}>${safe(text)}</option>`).join("")}</select>`; },
  /** @type {(what: string, label: string) => string} */
  button(what, label) { return `<button type="button" id="do-${what}" data-do="${what}">${label}</button>`; },
  /** @type {(said: string) => string} */
  end(said) { // the result, and the code a teacher's planes reads
    return `${said}<h2 id="h" tabindex="-1">${say("over")} ${practice.good} / ${practice.items.length}.</h2><p>${say(
      "hand_in")}</p><div class="answers"><label>${say(
      "student")} <input id="student" type="text" autocomplete="name" value="${safe(practice.name)}"></label>` +
      `<a id="save">${say("save_code")}</a></div><textarea id="code" readonly rows="4" aria-label="${say(
        "code")}"></textarea>` +
      `<div class="answers">${this.button("again", say("again"))}${this.button("fresh", say("fresh"))}</div>`;
  },
  /** @type {(name: string) => void} */
  sign(name) { // in place: a click on its way to the link must find the same one
    practice.name = name.slice(0, 80);
    const code = handed(), save = /** @type {any} */ ($("save"));
    const kept = URL.createObjectURL(new Blob([code + "\n"], { type: "text/plain" }));
    URL.revokeObjectURL(save.href);
    Object.assign(save, { href: kept, download: `${practice.name.replace(/[\s.]+$/, "") || "practice"}.practice` });
    $("code").value = code;
  },
  /** @type {(what: string, e: any) => void} */
  pick(what, e) {
    const p = practice;
    if (what === "again") p.begin();
    else if (what === "fresh") p.begin(1 + Math.floor(Math.random() * 999999));
    else if (what === "tool") { desk.tool = e.dataset.tool; draw(); }
    else if (what === "erase") { desk.strokes.pop(); draw(); }
    else if (what === "show") p.answer(null, "", true);
    else if (what === "known") { p.marks[e.dataset.term] = (p.given(e.dataset.term) + 1) % 3; draw(); }
    else if (what === "check") p.answer(p.goal(p.equation).map(t => p.given(t.name)).join(""), say("why_known"));
    else if (what === "choose") {
      const { value } = p.item.offered[e.dataset.at];
      p.answer(value, reply(p.item, value));
    }
    else if (what === "ccw" || what === "cw") p.answer(what === "ccw" ? 1 : -1,
      p.named([["sense_wrong", [p.item.what.replace("↺", "")]]]));
    else if (what === "number") p.number($("figure").value);
    else if (what === "draw") this.draw();
  },
  draw() { // the stroke for the present state of the tools
    if (desk.tool === "point") { const spot = desk.crossings()[desk.spot]; if (spot) practice.place(spot); return; }
    const s = desk.draft();
    if (!s) { practice.said = ["no", say("unfinished")]; draw(); return; }
    desk.mm = "";
    if (s.end) practice.place(s.end, s); else practice.stroke(s);
  },
  /** @type {(id: string, value: string) => void} */
  change(id, value) {
    if (id === "now") { practice.said = null; practice.take(+value); return; }
    if (id === "student") { this.sign(value); return; }
    if (id === "spot") desk.spot = +value;
    else if (id === "way") desk.back = value === "1";
    else fields[id] = value;
    if (id === "from" && desk.along === value) desk.along = desk.lines()[0][0];
    draw();
  },
};
export function handed() { // all first answers as letters, with a checksum against copying errors
  const told = { planes: 1, id: data.id, seed: practice.seed, name: practice.name, right: practice.good,
    scales: practice.scales,
    answers: practice.items.map((_, k) => practice.answers[k] ?? null) };
  const bytes = new TextEncoder().encode(JSON.stringify(told));
  const text = btoa(String.fromCharCode(...bytes)).replace(/\+/g, "-").replace(/\//g, "_").replace(/=+$/, "");
  let sum = 2166136261;
  for (const b of bytes) sum = Math.imul(sum ^ b, 16777619) >>> 0;
  return `planes-practice.${text}.${sum.toString(16).padStart(8, "0")}`;
}
$("practise").onclick = () => practice.toggle();
on($("task"), "click",
  e => { const b = e.target.closest("[data-do]"); if (b) task.pick(b.dataset.do, b); });
on($("task"), "change", e => task.change(e.target.id, e.target.value));
on($("task"), "input",
  e => { if (e.target.id === "student") task.sign(e.target.value);
    if (e.target.id === "mm" || e.target.id === "angle") { fields[e.target.id] = e.target.value; later(); } });
on($("task"), "keydown", e => {
  if (e.key !== "Enter" || e.target.tagName !== "INPUT" || e.target.id === "student") return;
  if (e.target.id !== "figure") fields[e.target.id] = e.target.value;
  task.pick(e.target.id === "figure" ? "number" : "draw", e.target);
});
for (const figure of [scheme, plan]) {
  const { node } = figure;
  let drawing = false;
  const place = (/** @type {any} */ e) => { const r = node.getBoundingClientRect();
    return [e.clientX - r.left, e.clientY - r.top]; };
  on(node, "pointerdown", e => {
    if (!practice.on || practice.over || e.button) return;
    const line = e.target.closest("[data-name^='link:']"), on = figure === desk.panel;
    if (on && desk.tool === "point") { // the nearest crossing
      const q = place(e), near = (/** @type {Spot} */ p) => distance(figure.px(p), q);
      const spots = desk.crossings(), k = spots.findIndex(p => near(p) < NEAR_PX);
      if (k >= 0) { desk.spot = k; task.draw(); }
      return;
    }
    const mark = on && desk.grip(place(e));
    if (mark) {
      desk.from = mark;
      if (desk.along === mark) desk.along = "angle";
      node.setPointerCapture(e.pointerId);
      drawing = true;
      figure.fixed_view = { k: figure.k, dx: figure.dx, dy: figure.dy };
      e.preventDefault();
      later(); // later: the element under the finger must survive its touch
    } else if (line && practice.drawing) desk.lay(line.dataset.name.slice(5));
  });
  on(node, "touchstart", e => { if (drawing) e.preventDefault(); }, { passive: false });
  on(node, "pointermove", e => { if (drawing) { desk.drag(figure.mm(place(e))); later(); } });
  on(node, "pointerup", e => {
    if (!drawing) return;
    drawing = false; figure.fixed_view = null;
    if (desk.tool === "line" && practice.drawing &&
      figure.k * distance(figure.mm(place(e)), live.at(desk.from)) > NEAR_PX) task.draw();
    else draw();
  });
  on(node, "pointercancel", () => { drawing = false; figure.fixed_view = null; later(); });
}
for (const by of [-1, 1]) on($(by < 0 ? "back" : "next"), "click", e => {
  if (!practice.on) return;
  e.stopImmediatePropagation();
  const open = practice.open(), at = open.indexOf(practice.index);
  practice.said = null;
  practice.take(open[(at + by + open.length) % open.length]);
}, true);
