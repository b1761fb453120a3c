// The stepper and the languages: reads the exported lesson, draws the current frame, keeps its place in the address.
import { readAddress, writeAddress } from "./address.js";
import { coloured } from "./colour.js";
import { curve, curveNames, curveOf } from "./curves.js";
import { desk } from "./desk.js";
import { $, on, worded } from "./dom.js";
import { written } from "./equations.js";
import { plan, scheme } from "./figures.js";
import { planOf, seenAt } from "./frames.js";
import { crank, drag, heard, knobs, large, spin, turn, zones } from "./hands.js";
import { handout } from "./handout.js";
import { ACT_MS, KITS, kit } from "./kit.js";
import { relight } from "./light.js";
import { data, draw, later, live, own, paintedBy, state } from "./page.js";
import { practice } from "./practice.js";
import { put } from "./put.js";
import { inWords } from "./rows.js";
import { contents, facing, go, told } from "./stepper.js";
import { Tape } from "./tape.js";
import { TOOLS, handed, task } from "./task.js";
import { forget, rested } from "./undo.js";
import { SCHEME, described, filled, number, plain, say } from "./words.js";

const READ_MS = 120;
let read = 0;
let alone = /** @type {any} */ (null), resized = false;
function paint() {
  const f = data.frames[state.frame], practising = practice.on;
  const seen = practising ? practice.seen() : seenAt(state.frame), key = planOf(state.frame);
  if (alone !== (key === "position") || resized) {
    alone = key === "position";
    document.querySelector(".panels").classList.toggle("alone", alone);
    scheme.measure(); plan.measure();
  }
  scheme.show("position", seen, practising && f.moments === null ? null : f);
  const mu = (/** @type {PlanOf} */ p) => practice.waits("mu", p.key) ? "?" : filled(p.mu[state.lang]);
  $("scheme-title").textContent = `${say(SCHEME)}, μ = ${mu(data.plans[0])}`;
  if (key !== "position") {
    plan.show(key, seen, f, practising);
    const p = data.plans.find(p => p.key === key);
    $("plan-title").textContent = `${p.title[state.lang]}, μ = ${mu(p)}`;
  }
  if (state.spin && performance.now() - read < READ_MS) { // numbers change eight times a second, figures each frame
    kit.show(null, false);
    coloured();
    relight();
    return;
  }
  read = performance.now();
  $("scheme").setAttribute("aria-label", described("position", seen));
  $("plan").setAttribute("aria-label", described(key, seen));
  $("practise").disabled = !!data.pending;
  if (!practising) told(f);
  facing(f, resized);
  resized = false;
  const stated = f.moments !== null ? f.chapter : f.plan === "position" ? key : f.plan;
  put("equations", written(f, stated, state.frame, practising ? practice : null));
  crank();
  curve();
  large(practising ? "position" : key);
  if (practising) task.paint();
  kit.show(practising || state.spin ? null : f, false);
  heard();
  coloured();
  relight();
}
$("formula").textContent = data.formula;
$("progress").max = String(data.frames.length);
const { from, to, at } = data.drive;
Object.assign($("crank"), { min: from, max: to, step: (to - from) / 360, value: at });
if (!own) document.body.classList.add("within"); // the studio has title and language
if (!data.moves) document.body.classList.add("unmoved", ...(data.scheme.drawn ? [] : ["still"])); // no formula
if (!data.moves && from === to) document.body.classList.add("held"); // no crank
function language() {
  zones();
  knobs();
  curveNames();
  contents();
  document.documentElement.lang = state.lang;
  worded(say);
  document.title = $("title").textContent = data.title[state.lang] || data.title.ru || "planes";
  $("lang").textContent = state.lang === "ru" ? "English" : "Русский";
}
$("lang").onclick = () => { state.lang = state.lang === "ru" ? "en" : "ru"; language(); writeAddress(); draw(); };
on(window, "hashchange", () => { if (practice.on) practice.toggle(); readAddress(); rested(); language(); draw(); });
on(window, "resize", () => { resized = true; later(); });
on(window, "beforeprint", handout);
function renewed() { // the studio has changed numbers of the scene: the crank stays where it is
  live.back({ ...data.home, [data.drive.given]: live.drive });
  live.scan();
  forget();
  language();
  draw();
}
function completed(/** @type {Partial<LessonData>} */ more) { // the practice, which the studio asks for apart
  Object.assign(data, more);
  live.tape = new Tape(data.tape);
  live.run();
  draw();
}
paintedBy(paint);
readAddress();
forget();
language();
draw();
if (practice.seed) practice.toggle();
else setTimeout(() => { live.scan(); zones(); later(); }, 60);
globalThis.planes = { // the interface of the page for scripts
  $, ACT_MS, KITS, TOOLS, completed, curveOf, data, desk, drag, draw, filled, go, handed, handout, inWords, kit, live,
  number, plain, plan, planOf, practice, renewed, rested, scheme, spin, state, task, turn,
};
