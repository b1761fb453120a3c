// The studio: one text, shown as a lesson, drawn on a canvas, shared as a link; every change asks the engine again.
import { scenesIn } from "./archive.js";
import { bench, say, words } from "./bench.js";
import { canvas, dropped, fit, listen, NOTHING, paint, show, sized, TOOLS } from "./canvas.js";
import { ask, engine, wake, way } from "./carrier.js";
import { chosenShown } from "./chosen.js";
import { $, on, worded } from "./dom.js";
import { gallery, shelf } from "./gallery.js";
import { problems, touched } from "./problems.js";
import { asked, keep, kept, pressed, unpressed } from "./share.js";
import { holders } from "./sketch.js";
import { STAMPS } from "./stamps.js";
import { checked, offered } from "./take.js";
import { typed } from "./typed.js";

const REST_MS = 250, APART_MS = 400; // until a text at rest is shown, and its practice asked for
/** A text, and the sketch of it where that is known. @typedef {{ text: string, sketch: Sketch | null }} Moment */
const past = /** @type {Moment[]} */ ([]), future = /** @type {Moment[]} */ ([]);
let typing = 0, resting = 0, drawn = /** @type {Sketch | null} */ (null);
const frame = /** @type {any} */ ($("lesson"));
let shown = /** @type {any} */ (null), shownShape = "";

/** @type {(selector: string, which: (button: any) => boolean) => void} */
function held(selector, which) {
  document.querySelectorAll(selector).forEach(b => b.setAttribute("aria-pressed", String(which(b))));
}
/** @type {(view: string) => void} */
function turnTo(view) {
  bench.view = document.body.dataset.view = view;
  held("#views button", b => b.dataset.view === view);
  if (engine.ready) $("state").textContent = ""; // said of another view
  if (view === "draw") fit();
  if (view === "gallery") gallery();
}
/** Open a text, with its origin, and update everything. @type {(text: string, from?: string) => Promise<void>} */
async function take(text, from = "") {
  if (text !== bench.text && bench.text) { past.push({ text: bench.text, sketch: drawn }); future.length = 0; }
  bench.text = text;
  if (["canvas", "named"].includes(from)) drawn = structuredClone(canvas.sketch);
  else if (from === "scene") drawn = null;
  if (from !== "scene") $("scene").value = text;
  touched([]);
  await renewal(from);
}
/** @type {(from: string) => Promise<void>} */
async function renewal(from) {
  const { text, lang } = bench;
  [$("undo").disabled, $("redo").disabled] = [!past.length, !future.length];
  if (way.kind === "worker" && !engine.ready) {
    wake();
    if (!shown) await prepared();
  }
  const answer = await ask({ ask: "lesson", text, lang });
  if (!answer) return;
  problems(answer.problems);
  if (answer.data) {
    seen(answer);
    completing(shown, text);
    keep(titleOf(answer.data), text);
    offered(answer.data);
    if (from !== "canvas") sketched();
  } else if (answer.none) {
    await prepared();
    if (text !== (await shelf()).find(s => s.name === bench.name)?.text) $("state").textContent = say("engine_none");
  }
  void address();
}
async function sketched() { // the sketch of a text for the canvas
  const answer = await ask({ ask: "sketch", text: bench.text, lang: bench.lang });
  if (!answer) return;
  if (answer.sketch) drawn = structuredClone(answer.sketch);
  if (drawn) show(drawn);
}
async function prepared() { // a prepared lesson of the gallery, while the engine loads or is missing
  if (!bench.name) return;
  const found = await fetch(`lessons/${bench.name}.txt`).then(async r =>
    r.ok ? JSON.parse(await unpressed(await r.text())) : null).catch(() => null);
  if (found && !shown) seen(found);
}
/** @type {(data: LessonData) => string} */
const titleOf = data => data.title[bench.lang] || data.title.en || data.title.ru || "planes";

/** The slow part of a lesson, once its text is at rest. @type {(lesson: any, text: string) => void} */
function completing(lesson, text) {
  clearTimeout(resting);
  if (!lesson.data.pending) return;
  resting = setTimeout(async () => {
    const more = text === bench.text && await ask({ ask: "practice", text, lang: bench.lang });
    if (!more?.data || text !== bench.text || shown !== lesson) return; // it came too late
    for (const [tongue, letters] of Object.entries(more.letters)) Object.assign(lesson.letters[tongue], letters);
    const inner = frame.contentWindow?.planes;
    if (inner?.data === lesson.data) inner.completed(more.data); else Object.assign(lesson.data, more.data);
  }, APART_MS);
}
/** @type {(answer: any) => void} */
function seen(answer) {
  const { tape, home, frames } = answer.data, shape = JSON.stringify([tape.ops, tape.names, Object.keys(home), frames]);
  const own = frame.contentWindow?.planes, same = shown && own?.live && shape === shownShape;
  $("title").textContent = document.title = titleOf(answer.data);
  chosenShown();
  $("nothing").hidden = true;
  frame.hidden = false;
  if (!same) shown = answer;
  shownShape = shape;
  globalThis.planes.lesson = shown;
  if (same) { // the existing tape, with other numbers
    Object.assign(own.data.home, answer.data.home);
    own.data.knobs.forEach((/** @type {Knob} */ k, /** @type {number} */ n) => { k.at = answer.data.knobs[n].at; });
    own.renewed();
    return;
  }
  const stays = own?.state && own.data.frames.length === answer.data.frames.length;
  const told = stays ? own.state.frame : answer.data.frames.findLastIndex((/** @type {Frame} */ f) =>
    f.plan === "velocity"); // start with the finished velocity plan
  const step = (told < 0 ? answer.data.frames.length - 1 : told) + 1;
  frame.src = `lesson.html?${Date.now()}#step=${step}&lang=${bench.lang}`;
}
on(frame, "load", () => { // numbers changed in the lesson are written back
  const inner = frame.contentWindow;
  if (!inner) return;
  on(inner, "rested", async e => {
    const { given } = shown.data.drive, numbers = { ...e.detail.numbers };
    const figures = /** @type {[string, {value: number, text: string}][]} */ (Object.entries(e.detail.figures));
    const kept = figures.filter(([n, one]) => numbers[n] === one.value);
    const said = Object.fromEntries(kept.map(([n, one]) => [n, one.text]));
    delete numbers[given];
    if (!Object.keys(numbers).length) return;
    const answer = await ask({ ask: "numbers", text: bench.text, lang: bench.lang, numbers, said });
    if (answer?.text) { await take(answer.text, "lesson"); touched(answer.lines); }
    else if (answer) problems(answer.problems);
  });
});
async function address() { // the scene in the address
  history.replaceState(null, "", `#s=${await pressed(bench.text)}&lang=${bench.lang}`);
}
/** @type {(from: Moment[], to: Moment[]) => void} */
function back(from, to) {
  if (!from.length) return;
  to.push({ text: bench.text, sketch: drawn });
  ({ text: bench.text, sketch: drawn } = from.pop());
  $("scene").value = bench.text;
  if (drawn) show(drawn);
  void renewal("undo");
}
const metres = () => typed($("width").value); // NaN for anything but a number
function labelled() { // the meaning of the number beside the picture beneath: a length drawn on it, or its whole width
  document.querySelector("[data-word=underlay_width]").textContent =
    say(canvas.ruled ? "underlay_length" : "underlay_width");
}
canvas.changed = async (what, more) => {
  if (what === "measure") { // the field is for the length drawn
    labelled();
    $("width").value = "";
    $("width").focus();
    return;
  }
  const { text, lang } = bench, sketch = structuredClone(canvas.sketch);
  if (!Object.keys(sketch.links).length) return; // nothing to report yet
  if (more?.load || more?.mass) {
    const edited = await (more.load ? loaded(more.load) : weighed(more.mass, more.centre));
    if (edited.text !== text) { await take(edited.text); touched(edited.lines); }
    return;
  }
  const answer = await ask({ ask: "drawn", text, lang, sketch, was: drawn });
  if (!answer) return;
  const still = JSON.stringify(sketch) === JSON.stringify(canvas.sketch) && !canvas.from;
  if (answer.sketch && still) { canvas.sketch = answer.sketch; paint(); }
  if (answer.text !== undefined && answer.text !== text) {
    await take(answer.text, "canvas");
    touched(answer.lines ?? []);
  }
  if (answer.problems.length) problems(answer.problems);
};
/** @typedef {{ text: string, lines: number[] }} Edited */
/** @type {(point: string) => Promise<Edited>} */
async function loaded(point) {
  const link = holders(canvas.sketch, point).pop() ?? "1", { text, lang } = bench;
  const value = `{link: ${link}, point: ${point}, force: 100, against: motion}`;
  return await ask({ ask: "append", text, lang, path: ["loads"], value }) ?? { text, lines: [] };
}
/** Mass and moment of inertia of a link that has none; its centre, where a point was pressed.
 * @type {(link: string, centre: string) => Promise<Edited>} */
async function weighed(link, centre) {
  const { lang } = bench, { heavy, slides } = canvas.sketch.links[link];
  const own = { ...heavy ? {} : { mass: "1", ...slides ? {} : { inertia: "0.01" } }, ...centre ? { centre } : {} };
  let { text } = bench, lines = /** @type {number[]} */ ([]);
  for (const [key, value] of Object.entries(own)) {
    const edited = await ask({ ask: "put", text, lang, path: ["links", link, key], value });
    if (edited?.text) [text, lines] = [edited.text, [...lines, ...edited.lines]];
  }
  return { text, lines };
}
/** @type {(tool: string) => void} */
function tool(name) {
  canvas.tool = name;
  dropped();
  held("#tools button", b => b.dataset.tool === name);
  $("hint").textContent = say(`hint_${name}`);
}
function spoken() {
  document.documentElement.lang = bench.lang;
  worded(say);
  labelled();
  /** @type {(names: string[]) => string} */
  const buttons = names => names.map(t =>
    `<button type="button" data-tool="${t}">${say(`tool_${t}`)}</button>`).join("");
  $("tools").innerHTML = `<div>${buttons(TOOLS)}</div><div><span class="group">${say("stamps")}</span>${
    buttons(STAMPS)}</div>`;
  tool(canvas.tool);
  $("lang").innerHTML = Object.keys(words).map(l => `<option value="${l}"${l === bench.lang ? " selected" : ""}>${
    words[l].language}</option>`).join("");
}
/** A scene of the gallery, or another one. @type {(text: string, name: string) => void} */
function open(text, name) {
  bench.name = name;
  canvas.chosen = ""; // a field that is left now belongs to the scene before
  past.length = future.length = 0;
  bench.text = "";
  turnTo(name ? "see" : "draw");
  if (text) { void take(text); return; }
  shown = null;
  frame.removeAttribute("src");
  frame.hidden = true;
  const names = kept().map(one => one.title), fresh = say("fresh"); // each under a title of its own
  const title = [fresh, ...names.map((_, k) => `${fresh} ${k + 2}`)].find(t => !names.includes(t));
  $("title").textContent = title;
  drawn = null;
  $("scene").value = "";
  $("nothing").hidden = false;
  $("nothing").textContent = say("nothing");
  show({ ...NOTHING, title });
  problems([]);
  tool("fix");
}
async function started() {
  const q = asked(), name = q.get("scene"), own = q.get("s");
  if (q.get("lang") in words) bench.lang = q.get("lang");
  spoken();
  const found = name && (await shelf()).find(s => s.name === name);
  const text = own ? await unpressed(own).catch(() => "") : found ? found.text : JSON.parse($("first").textContent);
  if (text) { open(text, name || "own"); return; }
  turnTo("gallery");
}
engine.said = step => {
  $("state").textContent = say(`engine_${step}`);
  if (step === "ready" && bench.text) void renewal("");
};
on($("views"), "click", e => { if (e.target.dataset.view) turnTo(e.target.dataset.view); });
on($("tools"), "click", e => { if (e.target.dataset.tool) tool(e.target.dataset.tool); });
on($("tools"), "focusin", e => { // by a key: under a finger a button has to stay
  if (e.target.matches(":focus-visible")) e.target.scrollIntoView({ block: "nearest", inline: "center" });
});
on($("scene"), "input", () => {
  clearTimeout(typing);
  typing = setTimeout(() => take($("scene").value, "scene"), REST_MS);
  touched([]);
});
on($("scene"), "scroll", () => { $("lines").scrollTop = $("scene").scrollTop; });
$("undo").onclick = () => back(past, future);
$("redo").onclick = () => back(future, past);
$("fresh").onclick = () => open("", "");
$("share").onclick = async () => {
  await address();
  const [, web] = bench.text.match(/\bstudio:\s*["']?(https?:\/\/[^\s"',}]+)/) ?? [];
  await navigator.clipboard?.writeText(web ? web + location.hash : location.href).catch(() => {});
  $("state").textContent = say(web || way.kind !== "server" ? "shared" : "shared_here").replace(/([{}])\1/g, "$1");
};
$("lang").onchange = () => {
  bench.lang = $("lang").value;
  shown = null;
  spoken();
  if (bench.text) void renewal("lang");
  void gallery();
};
/** A picture beneath the drawing; the next thing to do is to mark a length on it. @type {(file: File) => void} */
function beneath(file) {
  const picture = new Image();
  picture.onerror = () => { $("state").textContent = say("picture_wrong").replace("{name}", file.name); };
  picture.onload = () => {
    canvas.ruled = null;
    labelled();
    canvas.under = { href: picture.src, at: canvas.view.m([20, 20]), width: metres() || 0.6,
      ratio: picture.height / picture.width };
    tool("measure");
  };
  picture.src = URL.createObjectURL(file);
}
on($("underlay"), "change", () => { for (const file of [...$("underlay").files ?? []]) beneath(file); });
on($("width"), "change", () => { // of the picture, or of the length drawn on it
  $("width").setAttribute("aria-invalid", String(!(metres() > 0)));
  if (canvas.ruled) sized(metres());
  else if (canvas.under) canvas.under.width = metres() || 0.6;
  paint();
});
on(window, "keydown", e => {
  const key = (e.ctrlKey || e.metaKey) && !e.altKey ? e.code : "";
  if (e.target === $("scene") || !["KeyZ", "KeyY"].includes(key)) return; // a field of text has its own
  e.preventDefault();
  if (key === "KeyY" || e.shiftKey) back(future, past); else back(past, future);
});
/** Scenes of a folder, or of an archive: the first is opened, all are kept. Another file is a picture to draw over, or
 * a drawing to be checked where its mechanism is open. @type {(files: FileList | null) => Promise<void>} */
async function brought(files) {
  const all = [...files ?? []], scenes = await scenesIn(all), [other] = all, { view } = bench;
  const below = /^image\/(?!vnd)/.test(other?.type) && (!way.native || ["gallery", "draw"].includes(view));
  for (const { name, text } of [...scenes].reverse()) keep(name, text);
  if (scenes[0]) open(scenes[0].text, "own");
  else if (all.length === 1 && below) {
    if (view === "gallery") open("", ""); else turnTo("draw");
    beneath(other);
  } else if (all.length === 1 && way.native && bench.text && view !== "gallery") await checked(other);
  else $("state").textContent = say("files_none");
  void gallery();
}
for (const id of ["files-in", "folder-in"]) on($(id), "change", async () => {
  await brought($(id).files);
  $(id).value = "";
});
/** Files dropped on a document; a text that is dragged stays with its field. @type {(where: EventTarget) => void} */
function dropsOn(where) {
  on(where, "dragover", e => { if (e.dataTransfer.types.includes("Files")) e.preventDefault(); });
  on(where, "drop", e => {
    if (!e.dataTransfer.files.length) return;
    e.preventDefault();
    void brought(e.dataTransfer.files);
  });
}
dropsOn(document);
for (const id of ["lesson", "verdict"]) { // a frame would open the file itself
  on($(id), "load", () => { dropsOn(/** @type {any} */ ($(id)).contentWindow); });
}
on(window, "hashchange", () => { if (asked().has("scene")) void started(); });
Object.assign(bench, { take, open, act: (/** @type {string} */ name) => { turnTo("draw"); tool(name); } });
globalThis.planes = { lesson: null, bench, canvas, ask, engine, tool };
canvas.seen = chosenShown;
listen();
void started();
