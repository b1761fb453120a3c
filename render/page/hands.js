"use strict";
// What a reader's hand changes: the crank, the given numbers, what is dragged, the scale where a plan grows.
const LOOK_MS = 180, REST_MS = 400;

function heard() { // readers of the screen hear what there is once it has come to rest
  clearTimeout(heard.timer);
  heard.timer = setTimeout(() => {
    const parts = practice.on ? ["#task .said", "#h"] : ["#sentence", "#why", "#zone", "#large", "#follow"];
    put("heard", parts.map(p => document.querySelector(p)?.textContent.trim()).filter(Boolean).map(safe).join(" "));
  }, REST_MS);
}
function turn(value) { live.set({ [data.drive.given]: placed(value) }); writeAddress(); later(); }
function change(numbers) { // given numbers; the whole turn is looked at when they rest
  live.set(numbers);
  writeAddress();
  clearTimeout(change.timer);
  change.timer = setTimeout(() => { live.scan(); zones(); later(); }, LOOK_MS);
  later();
}
function crank() {
  const v = live.drive, { symbol, held } = data.drive, turning = symbol === "φ";
  const shown = turning ? local((((v % 360) + 360) % 360).toFixed(1).replace(/\.0$/, "")) + "°" : local(v.toFixed(4)) + (state.lang !== "en" ? " м" : " m");
  $("value").textContent = `${symbol} = ${shown}`;
  $("crank").value = v;
  if (document.activeElement !== $("exact")) $("exact").value = +(turning ? ((v % 360) + 360) % 360 : v).toFixed(6);
  $("crank").setAttribute("aria-valuetext", $("value").textContent);
  const practising = typeof practice !== "undefined" && practice.on;
  $("home").disabled = live.at_home;
  for (const id of ["crank", "exact", "spin"]) $(id).disabled = Boolean(held) || practising;
  const zone = live.zone;
  $("zone").className = live.failed ? "bad" : "";
  const near = live.failed && live.nearest(), there = near !== null && near !== false ? say("nearest").replace("{name}", symbol).replace("{value}", `${number(near)}${turning ? "°" : ""}`) : "";
  put("zone", held ? held[state.lang] : live.failed ? `⚠ ${filled(live.failed[state.lang])}${there}` : zone && zone.mark ? "⚠ " + sentence(data.blunt[zone.mark][state.lang], "") : "");
  put("rates", data.results.filter(r => found(r.value) <= state.frame).map(r => `<span><i class="name" data-name="${r.name}">${html(r.name)}</i> = ${number(live.value(r.value))} ${r.unit[state.lang]}</span>`).join(""));
  document.querySelectorAll("#knobs input").forEach(e => {
    const v = live.given[e.dataset.given];
    if (e !== document.activeElement || e.type === "range") e.value = +v.toPrecision(6);
    e.disabled = practising;
  });
}
function fitting(key) { // a scale of the series at which a plan that has grown is as large as in its own position; null where it fits
  const marks = plan.own(key), own = plan.box(marks, n => live.home(n)), now = plan.box(marks), long = b => Math.hypot(b[2] - b[0], b[3] - b[1]);
  const knob = data.knobs.find(k => k.plan === key || (key === "lever" && /velocity|motion/.test(k.plan || "")));
  if (!own || !now || !knob || long(now) < 4 * long(own) || long(own) < 1) return null;
  const most = live.given[knob.given] * long(own) / long(now), power = 10 ** Math.floor(Math.log10(most));
  return [knob.given, +([5, 4, 2.5, 2, 1].find(m => m * power <= most * (1 + 1e-9)) * power).toPrecision(3)];
}
function large(key) { // what a draughtsman does near a dead point: another scale, and it is said why
  const fit = key === "position" || live.failed ? null : fitting(key);
  put("large", fit ? `${say("large").replace("{mu}", scaled(fit[1]))} <button type="button" data-mu="${fit[1]}" data-given="${fit[0]}">${say("large_fit")}</button>` : "");
}
function zones() { // positions that fail, and blunt ones, marked over the slider by pattern as well as colour
  const { from, to } = data.drive, long = to - from || 1, said = z => z.kind === "bad" ? say("zone_bad") : plain(data.blunt[z.mark][state.lang]);
  $("zones").innerHTML = live.zones.map(z => `<i class="${z.kind}" title="${said(z)}" style="left:${100 * (z.from - from) / long}%;width:${100 * (z.to - z.from) / long + 100 / TURN}%"></i>`).join("");
}
function knobs() { // every given number, to be typed or slid
  const name = k => k.plan ? `μ, ${data.plans.find(p => p.key === k.plan)?.title[state.lang].toLowerCase() ?? ""}` : html(k.name) + (k.when ? `, <small>${k.when[state.lang]}</small>` : "");
  const shown = data.knobs.filter(k => !k.plan || data.plans.some(p => p.key === k.plan));
  const unit = k => k.plan ? filled(data.plans.find(p => p.key === k.plan).mu[state.lang]).replace(/^\S+ /, "") : k.unit[state.lang];
  const label = k => (k.plan ? name(k) : k.name + (k.when ? `, ${k.when[state.lang]}` : "")) + " " + unit(k);
  const slid = (k, [low, high] = span(k)) => `min="${low}" max="${high}" step="${(high - low) / 500}"`;
  $("knobs").innerHTML = shown.map(k => `<div class="knob${k.plan ? " scale" : ""}"><span>${name(k)}</span>` +
    `<input type="range" ${slid(k)} data-given="${k.given}" aria-label="${label(k)}">` +
    `<input type="text" inputmode="decimal" data-given="${k.given}" aria-label="${label(k)}"><small>${unit(k)}</small></div>`).join("");
  const chosen = $("free").value;
  $("free").innerHTML = `<option value="">${say("free_any")}</option>` + shown.filter(k => !k.plan).map(k => `<option value="${k.given}">${k.name.replace("_", "")}${k.when ? `, ${k.when[state.lang]}` : ""}</option>`).join("");
  $("free").value = chosen;
}
function spin(on = !state.spin) { // the crank goes round by itself, a turn in six seconds, there and back where it cannot
  cancelAnimationFrame(state.spin);
  state.spin = 0;
  $("spin").textContent = on ? "❚❚" : "⟳";
  if (!on) { settle(); later(); return; }
  const { from, to, symbol } = data.drive, round = symbol === "φ" && !live.zones.some(z => z.kind === "bad");
  let way = 1, last = 0;
  const next = now => {
    const was = live.drive, step = way * (to - from) * Math.min(now - (last || now), 100) / 6000;
    last = now;
    live.set({ [data.drive.given]: round ? placed(was + step) : was + step });
    if (!round && (live.failed || live.drive < from || live.drive > to)) { way = -way; live.set({ [data.drive.given]: was }); }
    draw();
    state.spin = requestAnimationFrame(next);
  };
  state.spin = requestAnimationFrame(next);
}
function follower(figure, mark, lengths) { // what a drag changes: the crank's end turns it, its length with Shift
  if (figure === plan) return live.handles(mark, $("free").value);
  const names = data.drags[mark], { given } = data.drive, chosen = lengths || names.includes($("free").value);
  return names.includes(given) && names.length > 1 ? names.filter(n => (n !== given) === Boolean(chosen)) : names;
}
function holding(figure, mark, lengths) { // it is said before anything moves
  const names = follower(figure, mark, lengths);
  if (names.length) put("follow", sentence(say("held").replace("{names}", listed(names)), ""));
  return names;
}
const past = [], ahead = []; // what was given before each change, and what was taken back
let kept = { ...live.given };
function settle() { // a change has come to its end
  if (Object.entries(kept).every(([n, v]) => live.given[n] === v)) return;
  past.push(kept);
  ahead.length = 0;
  kept = { ...live.given };
  steps();
}
function restore(from, to) {
  settle();
  if (!from.length || practice.on) return;
  to.push(kept);
  live.back(kept = from.pop());
  kept = { ...kept };
  live.scan();
  zones();
  put("follow", "");
  writeAddress();
  steps();
  later();
}
function steps() {
  $("undo").disabled = !past.length;
  $("redo").disabled = !ahead.length;
}
function drag(figure, mark, target, names = follower(figure, mark)) {
  const { short, text } = pulled(mark, names, target);
  change({ [data.drive.given]: placed(live.drive) });
  put("follow", text);
  return short;
}
function marks(figure) {
  const seen = seenAt(state.frame);
  return (figure === scheme ? Object.keys(data.drags) : plan.own(planOf(state.frame)).filter(m => !m.endsWith(":p"))).filter(m => seen.has(m));
}
for (const figure of [scheme, plan]) grips(figure, () => practice.on ? [] : marks(figure), (mark, target, names) => { if (state.spin) spin(false); drag(figure, mark, target, names); }, () => { settle(); later(); }, (mark, e) => holding(figure, mark, e.shiftKey));
$("spin").onclick = () => spin();
$("crank").oninput = e => turn(+e.target.value);
$("exact").onchange = e => { const v = parseFloat(e.target.value.replace(",", ".")); if (Number.isFinite(v)) turn(v); else crank(); };
$("home").onclick = () => { live.reset(); put("follow", ""); zones(); writeAddress(); settle(); later(); };
$("undo").onclick = () => restore(past, ahead);
$("redo").onclick = () => restore(ahead, past);
addEventListener("change", settle);
addEventListener("keydown", e => {
  const key = e.key.toLowerCase();
  if (!(e.ctrlKey || e.metaKey) || e.altKey || !["z", "y", "я", "н"].includes(key) || e.target.type === "text") return;
  e.preventDefault();
  if (e.shiftKey || "yн".includes(key)) restore(ahead, past); else restore(past, ahead);
});
steps();
$("large").onclick = e => { if (e.target.dataset.mu) { change({ [e.target.dataset.given]: +e.target.dataset.mu }); settle(); } };
$("knobs").addEventListener("input", e => {
  const k = data.knobs.find(k => k.given === e.target.dataset.given), text = e.target.value.replace(",", ".");
  const v = e.target.type === "range" ? +(+text).toPrecision(4) : +text;
  e.target.setAttribute("aria-invalid", !allowed(k, v));
  if (allowed(k, v)) change({ [k.given]: v });
});
