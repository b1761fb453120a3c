"use strict";
// The stepper, the crank, the languages and the handout: reads the exported lesson, keeps its place in the address.
const data = JSON.parse(document.getElementById("data").textContent);
const words = JSON.parse(document.getElementById("words").textContent);
const $ = id => document.getElementById(id);
const scheme = new Scheme($("scheme"), data), plan = new Plan($("plan"), data);
const state = { frame: 0, index: data.drive.at, lang: document.documentElement.lang, timer: 0, plan: "position" };

function readAddress() {
  const q = new URLSearchParams(location.hash.slice(1));
  if (q.has("step")) state.frame = clamp(+q.get("step") - 1, 0, data.frames.length - 1);
  if (q.has("at")) state.index = clamp(+q.get("at"), 0, data.drive.values.length - 1);
  if (["ru", "en"].includes(q.get("lang"))) state.lang = q.get("lang");
}
function writeAddress() {
  history.replaceState(null, "", `#step=${state.frame + 1}&at=${state.index}&lang=${state.lang}`);
}
function clamp(v, a, b) { return Math.min(b, Math.max(a, Number.isFinite(v) ? v : a)); }
function say(key) { return words[key][state.lang]; }
function sentence(text) {
  return text.replace(/⟨([^⟩]*)⟩/g, (_, n) => `<i class="name" data-name="${n}">${html(n)}</i>`);
}
function seenAt(frame) {
  const seen = new Set();
  data.frames.slice(0, frame + 1).forEach(f => f.makes.forEach(m => seen.add(m)));
  data.plans.forEach(p => { if ([...seen].some(n => n.startsWith(p.key + ":"))) seen.add(p.key + ":p"); });
  if (frame >= 0) seen.add("position:p");
  return seen;
}
function planOf(frame) { // the plan on the right: of this frame, or the last one that was not the scheme
  for (let k = frame; k >= 0; k--) if (data.frames[k].plan !== "position") return data.frames[k].plan;
  return "position";
}
function draw() {
  const f = data.frames[state.frame], seen = seenAt(state.frame), lit = new Set([...f.terms, ...f.makes, ...f.uses]);
  scheme.draw(state.index, seen, lit);
  const key = planOf(state.frame);
  $("plan-panel").hidden = key === "position";
  if (key !== "position") plan.show(key, state.index, seen, lit, f.makes);
  else if (f.makes.length) f.makes.forEach(m => Plan.prototype.trace.call(scheme, data.traces[m], m, state.index));
  const p = data.plans.find(p => p.key === key);
  if (p) $("plan-title").innerHTML = `${p.title[state.lang]}, μ = ${p.mu[state.lang]}`;
  told(f);
  equations(f, key);
  crank();
}
function told(f) {
  const failed = data.failed[state.index];
  $("number").textContent = `${state.frame + 1} / ${data.frames.length}`;
  $("sentence").innerHTML = sentence(f.said[state.lang]);
  $("moved").hidden = state.index === data.drive.at;
  $("failed").hidden = !failed;
  $("failed").textContent = failed ? failed[state.lang] : "";
  const plain = f.said[state.lang].replace(/[⟨⟩]/g, "");
  $("scheme").setAttribute("aria-label", `${say("scheme")}. ${plain}`);
  $("plan").setAttribute("aria-label", plain);
  $("back").disabled = state.frame === 0;
  $("next").disabled = state.frame === data.frames.length - 1;
  $("progress").value = state.frame + 1;
}
function equations(f, key) {
  $("equations").innerHTML = data.equations.map((e, k) => e.plan !== key || key === "position" ? "" : lines(e, k === f.equation, f)).join("");
}
function lines(e, current, f) {
  const term = t => `<span class="term known${t.known}${f.terms.includes(t.name) ? " lit" : ""}" data-name="${t.name}">` +
    `<b class="vec">${html(t.name)}</b><small>${t.action === "=0" ? "= 0" : html2(t.action)}</small></span>`;
  const sum = chain => chain.map(term).join(" + ");
  const total = e.total ? `<span class="term" data-name="${e.total}"><b class="vec">${html(e.total)}</b></span> = ` : "";
  const body = e.total ? e.chains.filter(c => c.length).map(c => total + sum(c)).join("<br>")
    : `${sum(e.chains[0].concat(e.chains[1]))} = 0`;
  return `<div class="equation${current ? " current" : ""}">${body}</div>`;
}
function html2(action) { return action.replace(/^[-+]?([va]q?)_(\w+)$/, (_, a, b) => `∥${a}<sub>${b}</sub>`); }
function crank() {
  const v = data.drive.values[state.index], unit = data.drive.symbol === "φ" ? "°" : " m";
  const shown = data.drive.symbol === "φ" ? ((v % 360) + 360) % 360 : v;
  const number = (x, d) => (state.lang === "ru" ? x.toFixed(d).replace(".", ",") : x.toFixed(d));
  $("value").textContent = `${data.drive.symbol} = ${number(shown, unit === "°" ? 1 : 4)}${unit}`;
  $("crank").value = state.index;
  $("crank").setAttribute("aria-valuetext", $("value").textContent);
  $("rates").innerHTML = Object.entries(data.rates).map(([n, r]) => r[state.index] === null ? "" :
    `<span><i class="name" data-name="${n}">${html(n)}</i> = ${number(r[state.index], 2)}</span>`).join(" ");
}
function zones() { // positions that fail, and blunt ones, marked on the slider by pattern as well as colour
  const n = data.drive.values.length;
  $("zones").innerHTML = data.drive.values.map((_, i) => {
    const kind = data.failed[i] ? "bad" : data.sharp[i] !== null && data.sharp[i] < 0.259 ? "blunt" : "";
    return kind ? `<i class="${kind}" style="left:${100 * i / n}%;width:${100 / n + 0.05}%"></i>` : "";
  }).join("");
}
function language() {
  document.documentElement.lang = state.lang;
  document.querySelectorAll("[data-word]").forEach(e => { e.textContent = say(e.dataset.word); });
  document.querySelectorAll("[data-title]").forEach(e => { e.title = say(e.dataset.title); e.setAttribute("aria-label", e.title); });
  document.title = $("title").textContent = data.title[state.lang] || "planes";
  $("lang").textContent = state.lang === "ru" ? "English" : "Русский";
}
function go(frame) { state.frame = clamp(frame, 0, data.frames.length - 1); writeAddress(); draw(); }
function turn(index) { state.index = clamp(index, 0, data.drive.values.length - 1); writeAddress(); requestAnimationFrame(draw); }
function play() {
  if (state.timer) { clearInterval(state.timer); state.timer = 0; }
  else state.timer = setInterval(() => state.frame + 1 < data.frames.length ? go(state.frame + 1) : play(), 2500);
  $("play").textContent = state.timer ? "❚❚" : "▶";
}
function light(name, on) {
  document.querySelectorAll("[data-name]").forEach(e => { if (e.dataset.name === name) e.classList.toggle("hover", on); });
}
function handout() { // every frame as a numbered picture and its sentence, for printing
  $("handout").innerHTML = "";
  data.frames.forEach((f, k) => {
    const item = document.createElement("li");
    const seen = seenAt(k), key = planOf(k), lit = new Set([...f.terms, ...f.makes, ...f.uses]);
    const figure = svg("svg", { class: "figure" }, item);
    if (key === "position") new Scheme(figure, data).draw(data.drive.at, seen, lit);
    else new Plan(figure, data).show(key, data.drive.at, seen, lit, f.makes, true);
    item.insertAdjacentHTML("beforeend", `<p>${sentence(f.said[state.lang])}</p>`);
    $("handout").appendChild(item);
  });
}
$("back").onclick = () => go(state.frame - 1);
$("next").onclick = () => go(state.frame + 1);
$("play").onclick = play;
$("progress").oninput = e => go(+e.target.value - 1);
$("crank").oninput = e => turn(+e.target.value);
$("home").onclick = () => turn(data.drive.at);
$("lang").onclick = () => { state.lang = state.lang === "ru" ? "en" : "ru"; language(); writeAddress(); draw(); };
addEventListener("keydown", e => {
  if (e.target.tagName === "INPUT" && e.target.id === "crank") return;
  if (e.key === "ArrowRight") go(state.frame + 1);
  else if (e.key === "ArrowLeft") go(state.frame - 1);
  else if (e.key === "Home") go(0);
  else if (e.key === "End") go(data.frames.length - 1);
  else if (e.key === " " && e.target.tagName !== "BUTTON") play();
  else return;
  e.preventDefault();
});
addEventListener("mouseover", e => { const t = e.target.closest("[data-name]"); if (t) light(t.dataset.name, true); });
addEventListener("mouseout", e => { const t = e.target.closest("[data-name]"); if (t) light(t.dataset.name, false); });
addEventListener("hashchange", () => { readAddress(); language(); draw(); });
addEventListener("beforeprint", handout);
readAddress(); language(); zones(); draw();
