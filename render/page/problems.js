// Errors in the text, at their lines, with corrections as buttons; an assembly is chosen by its picture.
import { bench, say } from "./bench.js";
import { ask } from "./carrier.js";
import { $, on, safe } from "./dom.js";
import { boxOf, depicted, viewOf } from "./moving.js";

/** @type {Problem[]} */
let faults = [];
let lines = /** @type {number[]} */ ([]);

/** @type {(found: Problem[]) => void} */
export function problems(found) {
  faults = found;
  /** @type {(h: Help, k: number, n: number) => string} */
  const button = (h, k, n) => `<button type="button"${h.sketch ? ' class="card"' : ""} data-problem="${k}" ` +
    `data-help="${n}">${h.sketch ? "<svg></svg>" : ""}<b>${safe(h.label)}</b></button>`;
  $("problems").innerHTML = found.map((p, k) => `<li class="${p.doubt ? "doubt" : ""}"><b>${say("line")} ` +
    `${p.line}:</b> ${safe(p.said)}<div class="choices">${p.help.map((h, n) => button(h, k, n)).join("")}</div></li>`)
    .join("");
  $("problems").querySelectorAll(".choices svg").forEach((/** @type {any} */ node) => {
    const { problem, help } = node.parentElement.dataset, sketch = found[problem].help[help].sketch;
    node.setAttribute("viewBox", "0 0 220 150");
    if (sketch) depicted(node, sketch, viewOf(boxOf(sketch), 220, 150, 24));
  });
  numbered();
}
/** The lines changed by hand. @type {(found: number[]) => void} */
export function touched(found) {
  lines = found;
  numbered();
  const first = lines[0];
  if (first && document.activeElement !== $("scene")) $("scene").scrollTop = Math.max(0, (first - 6) * 21);
}
function numbered() {
  const count = $("scene").value.split("\n").length, wrong = new Set(faults.filter(p => !p.doubt).map(p => p.line));
  $("lines").innerHTML = Array.from({ length: count }, (_, k) => {
    const cls = wrong.has(k + 1) ? "wrong" : lines.includes(k + 1) ? "touched" : "";
    return cls ? `<span class="${cls}">${k + 1}</span>` : String(k + 1);
  }).join("\n");
}
on($("problems"), "click", async e => {
  const button = e.target.closest("button"), problem = faults[button?.dataset.problem];
  const h = problem?.help[button.dataset.help];
  if (!h) return;
  if (h.act) { bench.act(h.act); return; }
  if (h.path) {
    const answer = await ask({ ask: "put", text: bench.text, lang: bench.lang, path: h.path, value: h.value });
    if (answer?.text) { await bench.take(answer.text); touched(answer.lines); }
    return;
  }
  const rows = bench.text.split("\n"), k = problem.line - 1;
  rows[k] = rows[k].slice(0, problem.column - 1) + h.to + rows[k].slice(problem.column - 1 + h.from.length);
  await bench.take(rows.join("\n"));
});
