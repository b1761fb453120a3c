// Downloads: files as from the command line, a checked drawing; without a server, the command itself.
import { bench, say } from "./bench.js";
import { way } from "./carrier.js";
import { $, on, safe } from "./dom.js";
import { download } from "./download.js";

/** The available files, each with its command. @type {Record<string, string[]>} */
const FILES = JSON.parse($("takeaway").textContent);

/** @type {(data: LessonData) => void} */
export function offered(data) {
  const own = Object.keys(FILES).filter(file => data.moves || FILES[file][0] !== "cycle");
  /** @type {(file: string) => string} */
  const named = file => safe(`${say(`file_${file.split(".")[0]}`)}, ${file.split(".")[1].toUpperCase()}`);
  $("files").innerHTML = `<button type="button" data-file="yaml">scene.yaml</button>` + own.map(file =>
    `<button type="button" data-file="${file}">${named(file)}</button>`).join("");
  $("plan").innerHTML = data.plans.filter(p => p.key !== "lever").map(p =>
    `<option value="${p.key}">${safe(p.title[bench.lang] ?? p.key)}</option>`).join("");
  $("checking").hidden = !way.native;
}
on($("files"), "click", async e => {
  const file = e.target.dataset.file;
  if (!file) return;
  if (file === "yaml") { download("scene.yaml", bench.text, "text/yaml"); return; }
  const [verb, ...options] = FILES[file];
  const command = ["planes", verb, "scene.yaml", ...options, "-o", file].join(" ");
  if (!way.native) { $("state").textContent = `${say("by_command")} ${command}`; return; }
  $("state").textContent = say("making");
  const found = await fetch("file", { method: "POST", headers: { "Content-Type": "application/json" },
    body: JSON.stringify({ text: bench.text, lang: bench.lang, file }) });
  $("state").textContent = found.ok ? "" : await found.text();
  if (found.ok) download(file, await found.arrayBuffer(), found.headers.get("Content-Type") ?? "");
});
let last = /** @type {File | null} */ (null); // of the plan chosen later
/** The verdict on a drawing, or why there is none. @type {(drawing: File) => Promise<void>} */
export async function checked(drawing) {
  const data = await drawing.arrayBuffer().catch(() => null);
  if (!data) { $("state").textContent = say("files_none"); return; } // a folder
  const bytes = new Uint8Array(data), letters = [];
  for (let k = 0; k < bytes.length; k += 32768) letters.push(String.fromCharCode(...bytes.subarray(k, k + 32768)));
  last = drawing;
  $("state").textContent = say("making");
  const found = await fetch("check", { method: "POST", headers: { "Content-Type": "application/json" }, body:
    JSON.stringify({ text: bench.text, lang: bench.lang, plan: $("plan").value, name: drawing.name,
      drawing: btoa(letters.join("")) }) });
  const text = await found.text();
  $("state").textContent = found.ok ? "" : text;
  $("verdict").hidden = !found.ok;
  if (found.ok) /** @type {any} */ ($("verdict")).src = text;
}
on($("drawing"), "change", () => { for (const file of [...$("drawing").files ?? []]) void checked(file); });
on($("plan"), "change", () => { if (last) void checked(last); });
