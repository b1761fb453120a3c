// The reader's changes: the crank, the given numbers, dragged marks, the scale where a plan grows.
import { writeAddress } from "./address.js";
import { $, on } from "./dom.js";
import { plan, scheme } from "./figures.js";
import { found, planOf, seenAt } from "./frames.js";
import { allowed, grips, handlesOf, naming, pulled, span } from "./grips.js";
import { html } from "./letters.js";
import { TURN } from "./live.js";
import { data, draw, later, live, state } from "./page.js";
import { put } from "./put.js";
import { asTyped, typed } from "./typed.js";
import { figures, nothing, redo, rested, undo } from "./undo.js";
import { filled, local, number, plain, say, scaled, sentence } from "./words.js";
const LOOK_MS = 180, REST_MS = 400;
let resting = 0, looking = 0;

export function heard() { // screen readers announce the state once it has settled
  clearTimeout(resting);
  resting = setTimeout(() => {
    const parts = state.practising ? ["#task .said", "#h"] : ["#sentence", "#why", "#zone", "#large", "#follow"];
    const text = parts.map(p => document.querySelector(p)?.textContent.trim()).filter(Boolean).join(" ");
    if ($("heard").textContent !== text) $("heard").textContent = text;
  }, REST_MS);
}
/** @type {(value: number) => void} */
export function turn(value) { live.set({ [data.drive.given]: live.placed(value) }); writeAddress(); later(); }
/** @type {(numbers: Numbers) => void} */
function change(numbers) { // given numbers; the whole turn is computed once they settle
  live.set(numbers);
  writeAddress();
  clearTimeout(looking);
  looking = setTimeout(() => { live.scan(); zones(); later(); }, LOOK_MS);
  later();
}
export function crank() {
  const v = live.drive, { symbol, held } = data.drive, turning = symbol === "φ";
  const shown = turning ? local((((v % 360) + 360) % 360).toFixed(1).replace(/\.0$/, "")) + "°" :
    local(v.toFixed(4)) + (state.lang !== "en" ? " м" : " m");
  $("value").textContent = `${symbol} = ${shown}`;
  $("crank").value = String(v);
  if (document.activeElement !== $("exact"))
    $("exact").value = String(+(turning ? ((v % 360) + 360) % 360 : v).toFixed(6));
  $("crank").setAttribute("aria-valuetext", $("value").textContent);
  $("home").disabled = live.at_home;
  [$("undo").disabled, $("redo").disabled] = nothing().map(none => none || state.practising);
  for (const id of ["crank", "exact", "spin"]) $(id).disabled = Boolean(held) || state.practising;
  const zone = live.zone;
  $("zone").className = live.failed ? "bad" : "";
  const near = live.failed ? live.nearest() : null;
  const there = near !== null ? say("nearest").replace("{name}", symbol).replace("{value}",
    `${number(near)}${turning ? "°" : ""}`) : "";
  const wrong = live.failed ? filled(live.failed[state.lang]) + there :
    zone?.mark ? sentence(data.blunt[zone.mark][state.lang], "") : "";
  put("zone", held ? held[state.lang] : wrong && `⚠ ${wrong}`);
  const told = data.results.filter(r => found(r.value) <= state.frame).map(r =>
    `<span><i class="name" data-name="${r.name}">${html(r.name)}</i>` +
    ` = ${number(live.value(r.value))} ${r.unit[state.lang]}</span>`);
  put("rates", told.join(""));
  document.querySelectorAll("#knobs input").forEach(e => {
    const text = String(+live.given[e.dataset.given].toPrecision(6));
    if (e.value !== text && (e !== document.activeElement || e.type === "range")) e.value = text;
    e.disabled = state.practising;
  });
}
// a standard scale at which a grown plan is as large as in its given position; null where it fits
/** @type {(key: string) => any} */
function fitting(key) {
  const marks = plan.own(key), own = plan.box(marks, n => live.home(n)), now = plan.box(marks);
  const long = (/** @type {Box} */ b) => Math.hypot(b[2] - b[0], b[3] - b[1]);
  const knob = data.knobs.find(k => k.plan === key || (key === "lever" && /velocity|motion/.test(k.plan || "")));
  if (!own || !now || !knob || long(now) < 4 * long(own) || long(own) < 1) return null;
  const most = live.given[knob.given] * long(own) / long(now), power = 10 ** Math.floor(Math.log10(most));
  return [knob.given, +([5, 4, 2.5, 2, 1].find(m => m * power <= most * (1 + 1e-9)) * power).toPrecision(3)];
}
/** @type {(key: string) => void} */
export function large(key) { // a draughtsman's remedy near a dead point: another scale, with the reason
  const fit = key === "position" || live.failed ? null : fitting(key);
  if (!fit) { put("large", ""); return; }
  const button = `<button type="button" data-mu="${fit[1]}" data-given="${fit[0]}">${say("large_fit")}</button>`;
  put("large", `${say("large").replace("{mu}", scaled(fit[1]))} ${button}`);
}
export function zones() { // positions that fail, and blunt ones, marked over the slider by pattern as well as colour
  const { from, to } = data.drive, long = to - from || 1;
  const said = (/** @type {Zone} */ z) => z.kind === "bad" ? say("zone_bad") : plain(data.blunt[z.mark][state.lang]);
  $("zones").innerHTML = live.zones.map(z => {
    const left = 100 * (z.from - from) / long, width = 100 * (z.to - z.from) / long + 100 / TURN;
    return `<i class="${z.kind}" title="${said(z)}" style="left:${left}%;width:${width}%"></i>`;
  }).join("");
}
export function knobs() { // every given number, with a field and a slider
  const name = (/** @type {Knob} */ k) => k.plan ?
    `μ, ${data.plans.find(p => p.key === k.plan)?.title[state.lang].toLowerCase() ?? ""}` :
    html(k.name) + (k.when ? `, <small>${k.when[state.lang]}</small>` : "");
  const shown = data.knobs.filter(k => !k.plan || data.plans.some(p => p.key === k.plan));
  const unit = (/** @type {Knob} */ k) => k.plan ?
    filled(data.plans.find(p => p.key === k.plan).mu[state.lang]).replace(/^\S+ /, "") :
    k.unit[state.lang];
  const label = (/** @type {Knob} */ k) => (k.plan ? name(k) : k.name + (k.when ? `, ${k.when[state.lang]}` : "")) +
    " " + unit(k);
  const slid = (/** @type {Knob} */ k) => {
    const [low, high] = span(k);
    return `min="${low}" max="${high}" step="${(high - low) / 500}"`;
  };
  $("knobs").innerHTML = shown.map(k => `<div class="knob${k.plan ? " scale" : ""}"><span>${name(k)}</span>` +
    `<input type="range" ${slid(k)} data-given="${k.given}" aria-label="${label(k)}">` +
    `<input type="text" inputmode="decimal" data-given="${k.given}" aria-label="${label(k)}"><small>${unit(
      k)}</small></div>`).join("");
  const chosen = $("free").value;
  $("free").innerHTML = `<option value="">${say("free_any")}</option>` +
    shown.filter(k => !k.plan).map(k => `<option value="${k.given}">${k.name.replace("_", "")}${k.when ?
    `, ${k.when[state.lang]}` : ""}</option>`).join("");
  $("free").value = chosen;
}
// the crank turns automatically, a turn in six seconds, to and fro where it cannot go round
/** @type {(on?: boolean) => void} */
export function spin(on = !state.spin) {
  cancelAnimationFrame(state.spin);
  state.spin = 0;
  $("spin").textContent = on ? "❚❚" : "⟳";
  rested();
  if (!on) { later(); return; }
  const { from, to, symbol } = data.drive, round = symbol === "φ" && !live.zones.some(z => z.kind === "bad");
  let way = 1, last = 0;
  const next = (/** @type {number} */ now) => {
    const was = live.drive, step = way * (to - from) * Math.min(now - (last || now), 100) / 6000;
    last = now;
    live.set({ [data.drive.given]: round ? live.placed(was + step) : was + step });
    if (!round && (live.failed || live.drive < from || live.drive > to)) { way = -way;
      live.set({ [data.drive.given]: was }); }
    draw();
    state.spin = requestAnimationFrame(next);
  };
  state.spin = requestAnimationFrame(next);
}
/** @type {(mark: string, shift: boolean) => string[]} */
function take(mark, shift) {
  const names = handlesOf(mark, $("free").value, shift);
  put("follow", naming(mark, names));
  return names;
}
/** @type {(figure: any, mark: string, target: Spot, names?: string[]) => number} */
export function drag(figure, mark, target, names = take(mark, false)) {
  const { short, text } = pulled(mark, names, target);
  change({});
  put("follow", text);
  return short;
}
/** @type {(figure: any) => string[]} */
function marks(figure) {
  const seen = seenAt(state.frame);
  return (figure === scheme ? Object.keys(data.drags) :
    plan.own(planOf(state.frame)).filter(m => !m.endsWith(":p"))).filter(m => seen.has(m));
}
for (const figure of [scheme, plan]) grips(figure, () => state.practising ? [] : marks(figure),
  (mark, shift) => { if (state.spin) spin(false); rested(); return take(mark, shift); },
  (mark, names, target) => drag(figure, mark, target, names), () => { rested(); later(); });
/** @type {(way: () => boolean) => void} */
function stepped(way) { // undone, or redone
  if (state.practising) return;
  if (state.spin) spin(false);
  if (!way()) return;
  live.scan();
  put("follow", "");
  zones();
  writeAddress();
  later();
}
$("undo").onclick = () => stepped(undo);
$("redo").onclick = () => stepped(redo);
on(window, "keydown", e => { // in a field of text the letters are taken back
  const key = (e.ctrlKey || e.metaKey) && !e.altKey ? e.code : "";
  const way = key === "KeyY" || (key === "KeyZ" && e.shiftKey) ? redo : key === "KeyZ" && undo;
  if (!way || e.target.matches?.("input[type=text], textarea")) return;
  e.preventDefault();
  stepped(way);
});
on(document, "change", rested); // a slider at rest, a number typed
$("spin").onclick = () => spin();
$("crank").oninput = () => turn(+$("crank").value);
$("exact").onchange = () => { const v = parseFloat($("exact").value.replace(",", ".")); if (Number.isFinite(v)) turn(v);
  else crank(); };
$("home").onclick = () => { rested(); live.reset(); rested(); put("follow", ""); zones(); writeAddress(); later(); };
on($("large"), "click",
  e => { if (e.target.dataset.mu) change({ [e.target.dataset.given]: +e.target.dataset.mu }); rested(); });
on($("knobs"), "input", e => {
  const k = data.knobs.find(k => k.given === e.target.dataset.given), text = e.target.value;
  const v = e.target.type === "range" ? +(+text).toPrecision(4) : typed(text);
  e.target.setAttribute("aria-invalid", !allowed(k, v));
  if (!allowed(k, v)) return;
  if (e.target.type === "text") figures[k.given] = { value: v, text: asTyped(text) };
  change({ [k.given]: v });
});
