// The gallery: animated mechanisms, each a link to its scene; before them the recent scenes of this machine.
import { zipped } from "./archive.js";
import { bench, say } from "./bench.js";
import { $, on, safe } from "./dom.js";
import { download } from "./download.js";
import { moving } from "./moving.js";
import { kept } from "./share.js";

const LATEST = 6;
/** @type {Shelved[] | null} */
let scenes = null, laid = "";
export async function shelf() { // requested only once
  if (location.protocol === "file:") { $("state").textContent = say("from_disk"); return []; }
  scenes ??= await fetch("gallery.json").then(r => r.json(), () => []);
  return scenes ?? [];
}
/** @type {(scene: Shelved) => string} */
const titled = scene => scene.title[bench.lang] || scene.title.en || scene.title.ru || scene.name;

export async function gallery() {
  const all = await shelf(), sought = $("sought").value.trim().toLowerCase(), own = kept();
  const key = [bench.lang, sought, own.length, own[0]?.when].join("|");
  if (key === laid) return;
  laid = key;
  const cards = own.map((one, k) => `<button type="button" class="card" data-kept="${k}">` +
    `<b>${safe(one.title)}</b><small>${safe(say("kept"))}</small></button>`);
  $("kept").innerHTML = cards.slice(0, LATEST).join("") + (cards.length > LATEST ? `<details><summary>${
    safe(say("kept_more"))} (${cards.length})</summary>${cards.slice(LATEST).join("")}</details>` : "");
  $("files-out").disabled = !own.length;
  const some = all.filter(s => !sought || `${titled(s)} ${s.formula} ${s.name}`.toLowerCase().includes(sought));
  $("scenes").innerHTML = some.map(s => `<button type="button" class="card" data-scene="${safe(s.name)}">` +
    `<svg role="img" aria-label="${safe(titled(s))}"></svg><b>${safe(titled(s))}</b><small>${safe(s.formula)}</small>` +
    "</button>").join("");
  $("scenes").querySelectorAll("svg").forEach((/** @type {any} */ node, k) => moving(node, some[k].sketch));
}
on($("scenes"), "click", async e => {
  const name = e.target.closest("[data-scene]")?.dataset.scene, found = (await shelf()).find(s => s.name === name);
  if (found) bench.open(found.text, found.name);
});
$("files-out").onclick = () => { // all that is kept here, each under its title
  const names = /** @type {string[]} */ ([]);
  for (const { title } of kept()) {
    const plain = title.replace(/[\\/:*?"<>|\s]+/g, " ").trim().slice(0, 80) || "scene";
    const again = names.filter(n => n.toLowerCase().replace(/ \(\d+\)$/, "") === plain.toLowerCase()).length;
    names.push(again ? `${plain} (${again + 1})` : plain);
  }
  const files = kept().map(({ text }, k) => ({ name: `scenes/${names[k]}.yaml`, text }));
  download("scenes.zip", zipped(files), "application/zip");
};
on($("kept"), "click", e => {
  const one = kept()[e.target.closest("[data-kept]")?.dataset.kept];
  if (one) bench.open(one.text, "own");
});
on($("sought"), "input", gallery);
