// The stepper: one frame after another, by buttons, keys or automatically, and the words of each.
import { writeAddress } from "./address.js";
import { $, on, safe } from "./dom.js";
import { clamp } from "./geometry.js";
import { kit } from "./kit.js";
import { data, draw, live, state } from "./page.js";
import { put } from "./put.js";
import { noted, typeset } from "./rows.js";
import { SCHEME, say, sentence } from "./words.js";

let faced = /** @type {any} */ (null), roomy = true;

// on a narrow screen one figure is visible: that of the step; the other is a swipe away
/** @type {(f: Frame, resized: boolean) => void} */
export function facing(f, resized) {
  const panels = document.querySelector(".panels"), on = f.plan !== "position" && !f.turns ? 1 : 0;
  if (faced === f && !(roomy && resized)) return; // reading the width forces a layout
  faced = f;
  roomy = panels.scrollWidth <= panels.clientWidth + 2;
  if (roomy) return;
  panels.scrollLeft = on * panels.clientWidth;
}
const chapters = data.frames.map((f, k) => k).filter(k => !k ||
  data.frames[k].chapter !== data.frames[k - 1].chapter);
export function contents() { // the plans in their order, each by its title
  const title = (/** @type {string} */ key) => key === "position" ? say(SCHEME) :
    key === "centres" ? say("centres") : data.plans.find(p => p.key === key).title[state.lang];
  $("chapter").innerHTML = chapters.map((k, n) =>
    `<option value="${n}">${n + 1}. ${safe(title(data.frames[k].chapter))}</option>`).join("");
}
/** @type {(f: Frame) => void} */
export function told(f) {
  $("number").textContent = `${state.frame + 1} / ${data.frames.length}`;
  // missing parts are not mentioned
  put("sentence", live.failed ? say("zone_bad") : typeset(f) + sentence(noted(f), f.plan));
  put("why", live.failed ? "" : sentence(f.why[state.lang], f.plan));
  $("back").disabled = state.frame === 0;
  $("next").disabled = state.frame === data.frames.length - 1;
  $("progress").value = String(state.frame + 1);
  $("chapter").value = String(chapters.filter(k => k <= state.frame).length - 1);
  $("progress").setAttribute("aria-valuetext", $("number").textContent);
}
/** @type {(frame: number) => void} */
export function go(frame) { // one step forward with the tools in motion
  const next = clamp(frame, 0, data.frames.length - 1), forward = next === state.frame + 1;
  state.frame = next;
  writeAddress();
  draw();
  if (forward) kit.show(data.frames[next], true);
}
export function play() {
  if (state.timer) { clearInterval(state.timer); state.timer = 0; }
  else state.timer = setInterval(() => state.frame + 1 < data.frames.length ? go(state.frame + 1) : play(), 3500);
  $("play").textContent = state.timer ? "❚❚" : "▶▶";
}
$("back").onclick = () => state.practising || go(state.frame - 1);
$("next").onclick = () => state.practising || go(state.frame + 1);
$("play").onclick = play;
$("chapter").onchange = () => go(chapters[+$("chapter").value]);
$("progress").oninput = () => go(+$("progress").value - 1);
on(window, "keydown", e => {
  if (/^(INPUT|SELECT)$/.test(e.target.tagName) || e.altKey || e.ctrlKey || e.metaKey || state.practising) return;
  if (e.key === "ArrowRight") go(state.frame + 1);
  else if (e.key === "ArrowLeft") go(state.frame - 1);
  else if (e.key === "Home") go(0);
  else if (e.key === "End") go(data.frames.length - 1);
  else if (e.key === " " && !/^(BUTTON|SUMMARY)$/.test(e.target.tagName)) play();
  else return;
  e.preventDefault();
});
