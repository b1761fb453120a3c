"use strict";
// The stepper and the languages: reads the exported lesson, draws the frame in hand, keeps its place in the address.
const $ = id => document.getElementById(id);
const live = new Live(data, LOOKS); // the whole turn is looked at once the first picture is there
const scheme = new Scheme($("scheme"), data), plan = new Plan($("plan"), data);
const state = { frame: 0, lang: document.documentElement.lang, timer: 0, spin: 0, waiting: false };

function readAddress() { // the frame, the drive, the language, and every number that is not the scene's
  const q = new URLSearchParams(location.hash.length > 1 ? location.hash.slice(1) : location.search), numbers = {};
  practice.seed = /^\d{1,6}$/.test(q.get("seed")) ? +q.get("seed") : 0;
  if (q.has("step")) state.frame = clamp(+q.get("step") - 1, 0, data.frames.length - 1);
  if (q.has("at") && Number.isFinite(+q.get("at"))) numbers[data.drive.given] = placed(+q.get("at"));
  for (const k of data.knobs) numbers[k.given] = q.has(k.given) && allowed(k, +q.get(k.given)) ? +q.get(k.given) : k.at;
  live.back(data.home);
  live.set(numbers);
  if (live.altered.length) live.scan();
  if (["ru", "en"].includes(q.get("lang"))) state.lang = q.get("lang");
}
function writeAddress() {
  clearTimeout(writeAddress.timer);
  const own = live.altered.map(n => `&${encodeURIComponent(n)}=${+live.given[n].toPrecision(9)}`).join("");
  const seeded = practice.on && practice.seed, text = `#${seeded ? `seed=${practice.seed}` : `step=${state.frame + 1}&at=${+live.drive.toFixed(6)}`}&lang=${state.lang}${seeded ? "" : own}`;
  writeAddress.timer = setTimeout(() => { try { history.replaceState(null, "", text); } catch { /* a page inside a page has no address */ } }, 120);
}
const READ_MS = 120;
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
  scheme.draw(seen, practising && f.moments === null ? null : f);
  $("scheme-title").textContent = `${say("scheme")}, μ = ${filled(data.plans[0].mu[state.lang])}`;
  if (key !== "position") {
    plan.show(key, seen, f, practising);
    const p = data.plans.find(p => p.key === key);
    $("plan-title").textContent = `${p.title[state.lang]}, μ = ${filled(p.mu[state.lang])}`;
  }
  if (state.spin && performance.now() - draw.read < READ_MS) return relight(); // numbers are read eight times a second, figures move at every frame
  draw.read = performance.now();
  $("scheme").setAttribute("aria-label", described(scheme, seen, key));
  $("plan").setAttribute("aria-label", described(plan, seen, key));
  if (!practising) told(f, key);
  facing(f);
  put("equations", written(f, f.plan === "position" ? key : f.plan, state.frame, practising));
  crank();
  large(key);
  if (practising) practice.paint();
  kit.show(practising || state.spin ? null : f, false);
  heard();
  relight();
}
function facing(f) { // on a narrow screen one figure is seen: the one the step is drawn on; the other is a swipe away
  const panels = document.querySelector(".panels"), on = f.plan !== "position" && !f.turns ? 1 : 0;
  if (facing.frame === f || panels.scrollWidth <= panels.clientWidth + 2) return;
  facing.frame = f;
  panels.scrollLeft = on * panels.clientWidth;
}
const chapters = data.frames.map((f, k) => k).filter(k => !k || data.frames[k].chapter !== data.frames[k - 1].chapter);
function contents() { // the plans in their order, each by its title
  const title = key => key === "position" ? say("scheme") : data.plans.find(p => p.key === key).title[state.lang];
  $("chapter").innerHTML = chapters.map((k, n) => `<option value="${n}">${n + 1}. ${safe(title(data.frames[k].chapter))}</option>`).join("");
}
function put(id, text) { // only what has changed
  if (put[id] !== text) $(id).innerHTML = put[id] = text;
}
function told(f, key) {
  $("number").textContent = `${state.frame + 1} / ${data.frames.length}`;
  put("sentence", typeset(f));
  put("why", sentence(f.why[state.lang], f.plan));
  $("back").disabled = state.frame === 0;
  $("next").disabled = state.frame === data.frames.length - 1;
  $("progress").value = state.frame + 1;
  $("chapter").value = chapters.findLastIndex(k => k <= state.frame);
  $("progress").setAttribute("aria-valuetext", $("number").textContent);
}
if (!data.moves) document.body.classList.add("still"); // vectors alone: no scheme, no crank
function language() {
  zones();
  knobs();
  contents();
  document.documentElement.lang = state.lang;
  document.querySelectorAll("[data-word]").forEach(e => { e.textContent = say(e.dataset.word); });
  document.querySelectorAll("[data-title]").forEach(e => { e.title = say(e.dataset.title); e.setAttribute("aria-label", e.title); });
  document.title = $("title").textContent = data.title[state.lang] || data.title.ru || "planes";
  $("lang").textContent = state.lang === "ru" ? "English" : "Русский";
}
function later() { if (!state.waiting) { state.waiting = true; requestAnimationFrame(draw); } }
function go(frame) { // one forward with the tools at work
  const next = clamp(frame, 0, data.frames.length - 1), forward = next === state.frame + 1;
  state.frame = next;
  writeAddress();
  draw();
  if (forward) kit.show(data.frames[next], true);
}
function play() {
  if (state.timer) { clearInterval(state.timer); state.timer = 0; }
  else state.timer = setInterval(() => state.frame + 1 < data.frames.length ? go(state.frame + 1) : play(), 3500);
  $("play").textContent = state.timer ? "❚❚" : "▶▶";
}
let lit = []; // the names under the pointer
function relight() { if (lit.length) light(lit, true); }
function light(names, on) { // a name, its term, its segment, its link, wherever they are
  lit = on ? names : [];
  const all = new Set(names);
  for (const n of names) {
    for (const r of data.related[n] || []) all.add(r);
    if (n.startsWith("link:") || n.startsWith("position:")) for (const k in data.related) if (data.related[k].includes(n)) all.add(k);
  }
  document.querySelectorAll("main [data-name]").forEach(e => {
    if (e.dataset.name.split(" ").some(n => all.has(n))) e.classList.toggle("hover", on);
  });
}
$("back").onclick = () => practice.on || go(state.frame - 1);
$("next").onclick = () => practice.on || go(state.frame + 1);
$("play").onclick = play;
$("progress").oninput = e => go(+e.target.value - 1);
$("chapter").onchange = e => go(chapters[+e.target.value]);
$("lang").onclick = () => { state.lang = state.lang === "ru" ? "en" : "ru"; language(); writeAddress(); draw(); };
addEventListener("keydown", e => {
  if (/^(INPUT|SELECT)$/.test(e.target.tagName) || e.altKey || e.ctrlKey || e.metaKey || practice.on) return;
  if (e.key === "ArrowRight") go(state.frame + 1);
  else if (e.key === "ArrowLeft") go(state.frame - 1);
  else if (e.key === "Home") go(0);
  else if (e.key === "End") go(data.frames.length - 1);
  else if (e.key === " " && !/^(BUTTON|SUMMARY)$/.test(e.target.tagName)) play();
  else return;
  e.preventDefault();
});
addEventListener("mouseover", e => { const t = e.target.closest("[data-name]"); if (t) light(t.dataset.name.split(" "), true); });
addEventListener("mouseout", e => { const t = e.target.closest("[data-name]"); if (t) light(t.dataset.name.split(" "), false); });
addEventListener("hashchange", () => { if (practice.on) practice.toggle(); readAddress(); language(); draw(); });
addEventListener("resize", () => { draw.resized = true; later(); });
addEventListener("beforeprint", handout);
