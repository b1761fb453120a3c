"use strict";
// The stepper, the crank, the languages and the handout: reads the exported lesson, keeps its place in the address.
const data = JSON.parse(document.getElementById("data").textContent);
const words = JSON.parse(document.getElementById("words").textContent);
const $ = id => document.getElementById(id);
const scheme = new Scheme($("scheme"), data), plan = new Plan($("plan"), data);
const state = { frame: 0, index: data.drive.at, lang: document.documentElement.lang, timer: 0, spin: 0, waiting: false };

function readAddress() {
  const q = new URLSearchParams(location.hash.slice(1));
  if (q.has("step")) state.frame = clamp(+q.get("step") - 1, 0, data.frames.length - 1);
  if (q.has("at")) state.index = clamp(Math.round(+q.get("at")), 0, data.drive.values.length - 1);
  if (["ru", "en"].includes(q.get("lang"))) state.lang = q.get("lang");
}
function writeAddress() {
  clearTimeout(writeAddress.timer);
  const text = `#step=${state.frame + 1}&at=${state.index}&lang=${state.lang}`;
  writeAddress.timer = setTimeout(() => { try { history.replaceState(null, "", text); } catch { /* a page inside a page has no address */ } }, 120);
}
function clamp(v, a, b) { return Math.min(b, Math.max(a, Number.isFinite(v) ? v : a)); }
function say(key) { return words[key][state.lang]; }
function local(text) { return state.lang === "ru" ? text.replace(".", ",") : text; }
function fixed(x, digits) { // as the engine rounds: a tie goes to the even digit
  const all = x.toFixed(Math.min(digits + 30, 100)), cut = all.indexOf(".") + 1 + digits;
  if (!/^50*$/.test(all.slice(cut))) return x.toFixed(digits);
  const low = all.slice(0, cut).replace(/\.$/, "");
  return /[02468]$/.test(low) ? low : x.toFixed(digits);
}
function number(v) { // four digits, as the engine prints them
  if (v === null || v === undefined) return "—";
  if (v === 0) return "0";
  const [mantissa, exponent] = v.toExponential(3).split("e"), power = +exponent;
  const short = t => t.includes(".") ? t.replace(/0+$/, "").replace(/\.$/, "") : t;
  const raised = () => short(mantissa) + "·10" + String(power).replace(/./g, c => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(c)]);
  return local((power > -5 && power < 7 ? short(fixed(v, Math.max(3 - power, 0))) : raised()).replace("-", "−"));
}
function filled(text, i) { // the numbers of a sentence, for the position shown
  return text.replace(/⟦(\w+)¦([^¦⟧]+)(?:¦([^⟧]+))?⟧/g, (_, how, name, mu) => {
    const v = value(data, name, i);
    if (v === null) return "—";
    if (how === "mm") return local(fixed(Math.abs(v * data.mus[mu]), 1).replace(/\.0$/, ""));
    if (how === "s") return say(v > 0 ? "ccw" : v < 0 ? "cw" : "still");
    const shown = number(v);
    return how === "b" && shown.startsWith("−") ? `(${shown})` : shown;
  });
}
function sentence(text, i, key) {
  return filled(text, i).replace(/⟨([^⟩]*)⟩/g, (_, n) => `<i class="name" data-name="${n}">${html(n, key)}</i>`);
}
function seenAt(frame) {
  const seen = new Set(["position:p"]);
  for (const f of data.frames.slice(0, frame + 1)) for (const m of f.makes) seen.add(m);
  return seen;
}
function planOf(frame) { // the plan on the right: of this frame, or the last one that was not the scheme
  for (let k = frame; k >= 0; k--) if (data.frames[k].plan !== "position") return data.frames[k].plan;
  return "position";
}
function draw() {
  state.waiting = false;
  const f = data.frames[state.frame], practising = typeof practice !== "undefined" && practice.on;
  const seen = practising ? practice.seen() : seenAt(state.frame), key = planOf(state.frame);
  if (draw.alone !== (key === "position") || draw.resized) {
    draw.alone = key === "position";
    draw.resized = false;
    document.querySelector(".panels").classList.toggle("alone", draw.alone);
    scheme.measure(); plan.measure();
  }
  scheme.draw(state.index, seen, practising ? null : f);
  $("scheme-title").textContent = `${say("scheme")}, μ = ${data.plans[0].mu[state.lang]}`;
  if (key !== "position") {
    plan.show(key, state.index, seen, f, practising);
    const p = data.plans.find(p => p.key === key);
    $("plan-title").textContent = `${p.title[state.lang]}, μ = ${p.mu[state.lang]}`;
  }
  if (practising) practice.paint(); else told(f, key);
  put("equations", written(f, key, state.frame, state.index, practising));
  crank();
}
function put(id, text) { // only what has changed
  if (put[id] !== text) $(id).innerHTML = put[id] = text;
}
function told(f, key) {
  $("number").textContent = `${state.frame + 1} / ${data.frames.length}`;
  put("sentence", sentence(f.said[state.lang], state.index, f.plan));
  put("why", sentence(f.why[state.lang], state.index, f.plan));
  const plain = filled(f.said[state.lang], state.index).replace(/[⟨⟩]/g, "");
  $("scheme").setAttribute("aria-label", `${say("scheme")}. ${plain}`);
  $("plan").setAttribute("aria-label", plain);
  $("back").disabled = state.frame === 0;
  $("next").disabled = state.frame === data.frames.length - 1;
  $("progress").value = state.frame + 1;
  $("progress").setAttribute("aria-valuetext", $("number").textContent);
}
function born(name, key) { // the frame of its plan in which a vector is first in hand
  if (!born.of) {
    born.of = {};
    data.frames.forEach((f, k) => { if (f.moments === null) for (const t of f.terms) born.of[f.plan + " " + t] ??= k; });
    for (const s of data.segments) { // what no frame speaks of is there with its end
      const k = data.frames.findIndex(f => f.makes.includes(`${s.plan}:${s.end}`));
      for (const n of s.names) born.of[s.plan + " " + n] ??= k;
    }
  }
  return born.of[key + " " + name] ?? -1;
}
function written(f, key, frame, i, plainly) { // the equations of a plan: those begun, the one in hand framed
  const begun = e => key.startsWith("force") || terms(e).some(t => t.action !== "=0" && born(t.name, key) <= frame);
  const own = e => f.terms.length && terms(e).some(t => f.terms.includes(t.name));
  const index = f.equation !== null ? f.equation : data.equations.findIndex(e => e.plan === key && own(e));
  return data.equations.map((e, k) => e.plan === key && key !== "position" && begun(e) ? lines(e, !plainly && k === index, f, frame, i, plainly) : "").join("");
}
function terms(e) { return e.sides.flat(); }
function lines(e, current, f, frame, i, plainly) {
  const one = t => term(t, e.plan, f, frame, i, plainly);
  const side = list => list.map(one).join('<span class="sign">+</span>');
  const first = e.total ? one(e.total) : "";
  const rows = e.sides.filter(s => s.length).map((s, k) => `<div class="side">${k && first ? '<span class="sign">=</span>' : first ? first + '<span class="sign">=</span>' : ""}${side(s)}</div>`);
  const body = e.total ? rows.join("") : `<div class="side">${side(e.sides.flat())}<span class="sign">= 0</span></div>`;
  return `<div class="equation${current ? " current" : ""}">${body}</div>`;
}
function term(t, key, f, frame, i, plainly) { // a vector: its own small segment, its letters, underlines, line of action
  const lit = !plainly && f.terms.includes(t.name), later = born(t.name, key) > frame - (plainly ? 1 : 0);
  const secret = plainly && later; // what the reader is to find
  const action = secret ? "" : t.action === "=0" ? "= 0" : t.action === "↓" ? "↓" : acted(t.action);
  const known = secret || (plainly && practice.asking(t.name)) ? practice.given(t.name) : t.known;
  return `<span class="term known${known}${lit ? " lit" : ""}${later ? " later" : ""}" data-name="${t.name}">` +
    `${secret ? '<svg class="mini"></svg>' : mini(t, later, i)}<b>${html(t.name, key)}</b><small>${action}</small></span>`;
}
function acted(text) { return text.replace(/^([-+])([va]q?_\w+)$/, (_, s, v) => `${s === "-" ? "↑↓" : "↑↑"} ${html(v)}`); }
function mini(t, later, i) { // the segment itself, as small as a word: an arrow, or only its line while its length is sought
  const s = t.start ? t : data.segments.find(s => s.names.includes(t.name)) || {};
  const full = n => n && (n.includes(":") ? n : `${s.plan}:${n}`), a = plan.at(full(s.start), i), b = plan.at(full(s.end), i);
  const n = a && b ? Math.hypot(b[0] - a[0], b[1] - a[1]) : 0;
  if (n < 1e-6) return '<svg class="mini"></svg>';
  const ux = (b[0] - a[0]) / n, uy = (a[1] - b[1]) / n, h = Math.min(19 / Math.max(Math.abs(ux), 1e-6), 8 / Math.max(Math.abs(uy), 1e-6), 19);
  const x = 22 + ux * h, y = 10 + uy * h, f = v => v.toFixed(1), line = `<line x1="${f(22 - ux * h)}" y1="${f(10 - uy * h)}" x2="${f(x)}" y2="${f(y)}"`;
  if (later && t.known < 2) return `<svg class="mini" viewBox="0 0 44 20">${t.known ? line + ' class="ray"/>' : ""}</svg>`;
  return `<svg class="mini" viewBox="0 0 44 20">${line}/><polygon points="${f(x)},${f(y)} ${f(x - 6 * ux - 2.2 * uy)},${f(y - 6 * uy + 2.2 * ux)} ${f(x - 6 * ux + 2.2 * uy)},${f(y - 6 * uy - 2.2 * ux)}"/></svg>`;
}
function crank() {
  const i = state.index, v = data.drive.values[i], turning = data.drive.symbol === "φ";
  const shown = turning ? local((((v % 360) + 360) % 360).toFixed(1).replace(/\.0$/, "")) + "°" : local(v.toFixed(4)) + (state.lang === "ru" ? " м" : " m");
  $("value").textContent = `${data.drive.symbol} = ${shown}`;
  $("crank").value = i;
  $("crank").setAttribute("aria-valuetext", $("value").textContent);
  $("home").disabled = i === data.drive.at;
  const zone = data.zones.find(z => z.from <= i && i <= z.to), failed = data.failed[i];
  $("zone").className = failed ? "bad" : "";
  put("zone", failed ? "⚠ " + failed[state.lang] : zone ? "⚠ " + sentence(zone.said[state.lang], i, "") : "");
  put("rates", data.results.map(r => `<span><i class="name" data-name="${r.name}">${html(r.name)}</i> = ${number(value(data, r.value, i))} ${r.unit[state.lang]}</span>`).join(""));
}
function zones() { // positions that fail, and blunt ones, marked over the slider by pattern as well as colour
  const n = data.drive.values.length;
  $("zones").innerHTML = data.zones.map(z => `<i class="${z.kind}" title="${filled(z.said[state.lang], 0).replace(/[⟨⟩]/g, "")}" style="left:${100 * z.from / n}%;width:${100 * (z.to - z.from + 1) / n}%"></i>`).join("");
}
function language() {
  zones();
  document.documentElement.lang = state.lang;
  document.querySelectorAll("[data-word]").forEach(e => { e.textContent = say(e.dataset.word); });
  document.querySelectorAll("[data-title]").forEach(e => { e.title = say(e.dataset.title); e.setAttribute("aria-label", e.title); });
  document.title = $("title").textContent = data.title[state.lang] || data.title.ru || "planes";
  $("lang").textContent = state.lang === "ru" ? "English" : "Русский";
}
function later() { if (!state.waiting) { state.waiting = true; requestAnimationFrame(draw); } }
function go(frame) { state.frame = clamp(frame, 0, data.frames.length - 1); writeAddress(); draw(); }
function turn(index) { state.index = clamp(index, 0, data.drive.values.length - 1); writeAddress(); later(); }
function play() {
  if (state.timer) { clearInterval(state.timer); state.timer = 0; }
  else state.timer = setInterval(() => state.frame + 1 < data.frames.length ? go(state.frame + 1) : play(), 3500);
  $("play").textContent = state.timer ? "❚❚" : "▶▶";
}
function spin() { // the crank goes round by itself, there and back where it cannot
  if (state.spin) { cancelAnimationFrame(state.spin); state.spin = 0; $("spin").textContent = "⟳"; return; }
  const n = data.drive.values.length, round = data.drive.symbol === "φ" && !Object.keys(data.failed).length;
  let step = 1, index = state.index;
  const next = () => {
    let to = round ? (index + step + n) % n : index + step;
    if (!round && (to < 0 || to >= n || data.failed[to])) { step = -step; to = clamp(index + step, 0, n - 1); }
    state.index = index = to;
    draw();
    state.spin = requestAnimationFrame(next);
  };
  $("spin").textContent = "❚❚";
  state.spin = requestAnimationFrame(next);
}
function light(names, on) { // a name, its term, its segment, its link, wherever they are
  const all = new Set(names);
  for (const n of names) {
    for (const r of data.related[n] || []) all.add(r);
    if (n.startsWith("link:") || n.startsWith("position:")) for (const k in data.related) if (data.related[k].includes(n)) all.add(k);
  }
  document.querySelectorAll("main [data-name]").forEach(e => {
    if (e.dataset.name.split(" ").some(n => all.has(n))) e.classList.toggle("hover", on);
  });
}
function handout() { // every frame as a numbered picture and its sentence, for printing
  let last = "";
  $("handout").innerHTML = "";
  data.frames.forEach((f, k) => {
    const key = planOf(k), onScheme = f.plan === "position", p = data.plans.find(p => p.key === f.plan);
    if (f.plan !== last && !(onScheme && f.moments !== null)) {
      $("handout").insertAdjacentHTML("beforeend", `<h2>${p.title[state.lang]}, μ = ${p.mu[state.lang]}</h2>`);
      last = f.plan;
    }
    const item = document.createElement("article"), figure = svg("svg", { class: "figure" });
    item.innerHTML = `<h3>${k + 1}</h3>`;
    item.appendChild(figure);
    if (onScheme) new Scheme(figure, data, [350, 205]).draw(data.drive.at, seenAt(k), f);
    else new Plan(figure, data, [350, 205]).show(key, data.drive.at, seenAt(k), f);
    const begins = f.equation !== null && data.frames.findIndex(g => g.equation === f.equation) === k && !onScheme;
    const equation = begins ? lines(data.equations[f.equation], false, f, data.frames.length, data.drive.at) : "";
    item.insertAdjacentHTML("beforeend", `${equation}<p>${sentence(f.said[state.lang], data.drive.at, f.plan)}</p><p class="why">${sentence(f.why[state.lang], data.drive.at, f.plan)}</p>`);
    $("handout").appendChild(item);
  });
}
$("back").onclick = () => practice.on || go(state.frame - 1);
$("next").onclick = () => practice.on || go(state.frame + 1);
$("play").onclick = play;
$("spin").onclick = spin;
$("progress").oninput = e => go(+e.target.value - 1);
$("crank").oninput = e => turn(+e.target.value);
$("home").onclick = () => turn(data.drive.at);
$("lang").onclick = () => { state.lang = state.lang === "ru" ? "en" : "ru"; language(); writeAddress(); draw(); };
addEventListener("keydown", e => {
  if (e.target.tagName === "INPUT" || e.altKey || e.ctrlKey || e.metaKey || practice.on) return;
  if (e.key === "ArrowRight") go(state.frame + 1);
  else if (e.key === "ArrowLeft") go(state.frame - 1);
  else if (e.key === "Home") go(0);
  else if (e.key === "End") go(data.frames.length - 1);
  else if (e.key === " " && e.target.tagName !== "BUTTON") play();
  else return;
  e.preventDefault();
});
addEventListener("mouseover", e => { const t = e.target.closest("[data-name]"); if (t) light(t.dataset.name.split(" "), true); });
addEventListener("mouseout", e => { const t = e.target.closest("[data-name]"); if (t) light(t.dataset.name.split(" "), false); });
addEventListener("hashchange", () => { if (practice.on) practice.toggle(); readAddress(); language(); draw(); });
addEventListener("resize", () => { draw.resized = true; later(); });
addEventListener("beforeprint", handout);
