// A page of the essay: paragraphs, each beside its figure; one tape for all, so a move in one figure shows in all.
import { $, on, worded } from "./dom.js";
import { written } from "./equations.js";
import { seenAt } from "./frames.js";
import { aimedAt, grips, handlesOf, pulled, span } from "./grips.js";
import { html } from "./letters.js";
import { data, draw, later, live, paintedBy, state } from "./page.js";
import { Plan } from "./plan.js";
import { Scheme } from "./scheme.js";
import { described, filled, number, say, sentence } from "./words.js";
const asked = new URLSearchParams(location.hash.slice(1)).get("lang");
if (["ru", "en"].includes(asked)) state.lang = asked;
live.scan();
document.documentElement.lang = state.lang;
const turning = data.drive.symbol === "φ";
const paragraphs = data.paragraphs.map((p, k) => {
  const section = document.createElement("section"), names = p.knobs.map(n => n === "phi" ? data.drive.given : n);
  const slid = (/** @type {string} */ n) => data.knobs.find(k => k.given === n) ||
    /** @type {any} */ ({ given: n, at: 1, drive: true });
  section.className = "paragraph";
  section.innerHTML = `<p></p><figure><figcaption></figcaption><svg role="img"></svg><div class="slid">${names.map(
    n => `<label><span></span><input type="range" data-given="${n}"><output></output></label>`).join(
    "")}</div><div class="equations"></div><p class="follow" role="status"></p></figure>`;
  $("essay").appendChild(section);
  const [text, figcaption, node, equations, follow] = ["p", "figcaption", "svg", ".equations",
    ".follow"].map(s => section.querySelector(s));
  const figure = new (p.view === "position" ? Scheme : Plan)(node, data);
  const own = { ...p, section, text, figcaption, node, equations, follow, figure, knobs: names.map(slid),
    seen: seenAt(p.frame) };
  section.querySelectorAll("input").forEach((input, i) => {
    const knob = own.knobs[i], angle = aimedAt(knob.given);
    const [low, high] = knob.drive ? [data.drive.from, data.drive.to] : span(knob);
    Object.assign(input, { min: low, max: high, step: (high - low) / (knob.drive || angle ? 720 : 500) });
    input.oninput = () => { live.set({ [knob.given]: +input.value }); follow.textContent = ""; later(); };
    input.onchange = () => { if (!knob.drive) live.scan(); later(); };
  });
  const marks = () => (p.view === "position" ? Object.keys(data.drags) :
    figure.own(p.view).filter(m => !m.endsWith(":p"))).filter(m => own.seen.has(m));
  grips(figure, marks, (mark, shift) => handlesOf(mark, "", shift), (mark, names, target) => {
    follow.innerHTML = pulled(mark, names, target).text;
    later();
  }, () => { live.scan(); later(); });
  return own;
});
/** @type {(knob: Knob) => string} */
function shown(knob) { // a number under its slider
  const v = live.given[knob.given];
  if (knob.drive) return `${turning ? number(+(((v % 360) + 360) % 360).toFixed(1)) + "°" : number(v)}`;
  return knob.plan ? filled(data.plans.find(p => p.key === knob.plan).mu[state.lang]) :
    `${number(+v.toPrecision(4))} ${knob.unit[state.lang]}`.replace(" °", "°");
}
/** @type {(knob: Knob) => string} */
function named(knob) { return knob.drive ? data.drive.symbol : knob.plan ? "μ" : html(knob.name); }
function paint() {
  for (const p of paragraphs) {
    const f = data.frames[p.frame], scheme = p.view === "position", plan = data.plans.find(q => q.key === p.view);
    state.frame = p.frame;
    p.figure.measure();
    p.figure.show(p.view, p.seen, f);
    p.text.innerHTML = sentence(p.said[state.lang], p.view);
    p.figcaption.textContent = live.failed ? `⚠ ${filled(live.failed[state.lang])}` :
      `${plan.title[state.lang]}, μ = ${filled(plan.mu[state.lang])}`;
    p.node.setAttribute("aria-label", described(p.view, p.seen));
    p.equations.innerHTML = scheme ? "" : written(f, p.view, p.frame, null);
    p.section.querySelectorAll("label").forEach((label, i) => {
      const [name, input, output] = label.children, knob = p.knobs[i];
      name.innerHTML = named(knob);
      input.value = live.given[knob.given];
      output.textContent = shown(knob);
      input.setAttribute("aria-valuetext", output.textContent);
    });
  }
  $("home").disabled = live.at_home;
}
function language() {
  document.documentElement.lang = state.lang;
  document.title = $("title").textContent = `${data.number}. ${data.title[state.lang]}`;
  $("lang").textContent = state.lang === "ru" ? "English" : "Русский";
  worded(say);
  $("pages").setAttribute("aria-label", say("essay_pages"));
  $("pages").innerHTML = `<ol>${data.titles.map((t,
    k) => `<li><a href="${k + 1}.html#lang=${state.lang}"${k + 1 === data.number ? ' aria-current="page"' :
    ""}>${k + 1}. ${t[state.lang]}</a></li>`).join("")}</ol>`;
  draw();
}
$("lang").onclick = () => { state.lang = state.lang === "ru" ? "en" : "ru";
  history.replaceState(null, "", `#lang=${state.lang}`); language(); };
$("home").onclick = () => { live.reset(); paragraphs.forEach(p => { p.follow.textContent = ""; }); draw(); };
on(window, "resize", later);
paintedBy(paint);
language();
globalThis.planes = { data, draw, live, paragraphs, state };
