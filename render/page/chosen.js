// What is chosen on the canvas: its name and its sizes to be typed, a copy of it, its removal.
import { bench, say } from "./bench.js";
import { canvas, paint, step } from "./canvas.js";
import { ask } from "./carrier.js";
import { $, on } from "./dom.js";
import { along, distance, heading } from "./geometry.js";
import { problems, touched } from "./problems.js";
import { copied, renamed, shifted } from "./sketch.js";
import { asTyped, typed } from "./typed.js";

const BESIDE = 3; // steps of the grid from a part to its copy
/** @type {() => string} */
function chosenKind() {
  const { chosen, sketch } = canvas;
  return chosen in sketch.points ? "point" : chosen in sketch.links ? "link" : "";
}
/** The places that sizes are typed for: of a point, itself; of a link, its first two. @type {() => string[]} */
const ends = () => chosenKind() === "point" ? [canvas.chosen] :
  canvas.sketch.links[canvas.chosen]?.points.slice(0, 2) ?? [];
/** @type {(id: string, value: string) => void} */
function typedIn(id, value) {
  if (document.activeElement !== $(id)) $(id).value = value;
}
/** @type {(v: number) => string} */
const inMetres = v => String(+v.toFixed(5));
export function chosenShown() {
  const own = chosenKind(), [a, b] = ends().map(p => canvas.sketch.points[p]);
  const none = !own && !bench.text;
  $("chosen").classList.toggle("none", none);
  $("chosen").inert = none;
  $("called").parentElement?.toggleAttribute("hidden", !!own); // of nothing chosen, the title of all
  $("name").parentElement?.toggleAttribute("hidden", !own);
  for (const id of ["copy", "bin"]) $(id).hidden = !own;
  $("x").parentElement?.toggleAttribute("hidden", own !== "point");
  $("y").parentElement?.toggleAttribute("hidden", own !== "point");
  $("long").parentElement?.toggleAttribute("hidden", own !== "link" || !b);
  if (!own) { typedIn("called", $("title").textContent ?? ""); return; }
  typedIn("name", canvas.chosen);
  if (own === "point") [typedIn("x", inMetres(a[0])), typedIn("y", inMetres(a[1]))];
  else if (b) typedIn("long", inMetres(distance(a, b)));
}
async function rename() {
  const was = canvas.chosen, now = $("name").value.trim(), what = chosenKind(), { text, lang } = bench;
  if (!now || now === was) return;
  const taken = now in canvas.sketch.points || now in canvas.sketch.links;
  const answer = text || !taken ? text && await ask({ ask: "rename", text, lang, path: [what, was], value: now }) :
    { problems: [{ line: 1, said: say("name_taken").replace("{name}", now), help: [] }] };
  $("name").setAttribute("aria-invalid", String(!!answer?.problems.length));
  if (answer && answer.text === undefined) { problems(answer.problems); return; }
  if (text && !answer) return;
  renamed(canvas.sketch, what, was, now);
  canvas.chosen = now;
  paint();
  if (!answer) return;
  await bench.take(answer.text, "named");
  touched(answer.lines);
}
function copy() {
  const what = chosenKind();
  if (!what) return;
  canvas.chosen = copied(canvas.sketch, what, canvas.chosen, BESIDE * step());
  paint();
  canvas.changed("copy", true);
}
/** Numbers of the mechanism as they were typed; whether its text has them.
 * @type {(names: string[], value: number, typedAs: string) => Promise<boolean>} */
async function putAsTyped(names, value, typedAs) {
  const { text, lang } = bench;
  /** @type {<T>(one: T) => Record<string, T>} */
  const each = one => Object.fromEntries(names.map(n => [n, one]));
  const answer = text && await ask({ ask: "numbers", text, lang, numbers: each(value), said: each(typedAs) });
  if (!answer?.text || answer.text === text) return false;
  await bench.take(answer.text);
  touched(answer.lines);
  return true;
}
/** @type {(axis: number, value: number, text: string) => Promise<void>} */
async function placed(axis, value, text) {
  if (await putAsTyped([`place_${canvas.chosen}.${"xy"[axis]}`], value, text)) return;
  const to = canvas.sketch.points[canvas.chosen].map((v, k) => k === axis ? value : v);
  shifted(canvas.sketch, canvas.chosen, to);
  paint();
  canvas.changed("move", true);
}
/** The length of a link: that of the mechanism, or of the drawing where there is none yet.
 * @type {(value: number, text: string) => Promise<void>} */
async function stretched(value, text) {
  const [a, b] = ends(), { sketch } = canvas;
  if (await putAsTyped([`l_${a}${b}`, `l_${b}${a}`], value, text)) return;
  const [still, far] = sketch.fixed.includes(b) ? [b, a] : [a, b];
  shifted(sketch, far, along(sketch.points[still], value, heading(sketch.points[still], sketch.points[far])));
  paint();
  canvas.changed("move", true);
}
/** @type {(id: string, act: (value: number, text: string) => Promise<void>, least?: number) => void} */
function sizeField(id, act, least = -Infinity) {
  on($(id), "change", () => {
    const value = typed($(id).value), sound = Number.isFinite(value) && value > least && chosenKind() !== "";
    $(id).setAttribute("aria-invalid", String(!sound));
    if (sound) void act(value, asTyped($(id).value));
  });
}
sizeField("x", (v, text) => placed(0, v, text));
sizeField("y", (v, text) => placed(1, v, text));
sizeField("long", stretched, 0);
on($("name"), "change", rename);
on($("called"), "change", async () => {
  const { text, lang } = bench, value = JSON.stringify($("called").value.trim());
  const answer = await ask({ ask: "put", text, lang, path: ["title"], value });
  if (!answer?.text) return;
  await bench.take(answer.text, "named");
  touched(answer.lines);
});
on($("chosen"), "submit", e => { e.preventDefault(); });
$("copy").onclick = copy;
$("bin").onclick = () => {
  $("canvas").focus();
  $("canvas").dispatchEvent(new KeyboardEvent("keydown", { key: "Delete" }));
};
on($("canvas"), "keydown", e => {
  if (e.key === "F2" && chosenKind()) { $("name").focus(); $("name").select(); e.preventDefault(); }
  if (e.code === "KeyD" && (e.ctrlKey || e.metaKey)) { copy(); e.preventDefault(); }
});
