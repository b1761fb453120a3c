// The table of a class: sorted by its columns; the teacher's own decisions, kept on this machine and saved as a table.
import { $, on } from "./dom.js";
import { download } from "./download.js";
import { remember, remembered } from "./memory.js";

const heads = [...document.querySelectorAll("thead th")], choice = document.querySelector(".sort select");
/** @type {(th: any) => void} */
function sort(th) { // by its column, reversed if already sorted by it
  const down = th.ariaSort === "ascending", body = document.querySelector("tbody");
  const key = (/** @type {any} */ row) => row.children[th.cellIndex].textContent;
  const rows = [...body.rows].sort((a, b) => Number(key(a) === "") - Number(key(b) === "") ||
    key(a).localeCompare(key(b),
    document.documentElement.lang, { numeric: true }) * (down ? -1 : 1));
  for (const one of heads) one.removeAttribute("aria-sort");
  th.ariaSort = down ? "descending" : "ascending";
  choice.value = th.cellIndex;
  body.append(...rows);
}
for (const th of heads) th.firstChild.onclick = () => sort(th);
choice.onchange = () => { if (choice.value) sort(heads[choice.value]); };

const KEY = `planes.class.${document.title}`, decisions = remembered(KEY, {}), body = document.querySelector("tbody");
const decided = $("decided"), rows = () => /** @type {any[]} */ ([...body.rows]);
/** @type {(row: any) => string} */
const nameOf = row => row.cells[0].textContent;
function show() { // the decisions in their rows, and how many there are
  const count = /** @type {Numbers} */ ({ accepted: 0, rejected: 0 });
  for (const row of rows()) {
    const own = decisions[nameOf(row)] || "";
    for (const b of row.querySelectorAll(".decide button")) b.ariaPressed = String(b.value === own);
    row.dataset.own = own;
    if (own) count[own]++;
  }
  decided.hidden = !count.accepted && !count.rejected;
  const said = decided.querySelector("output");
  said.textContent = said.dataset.said.replace("{accepted}", count.accepted).replace("{rejected}", count.rejected);
}
on(body, "click", e => { // pressed again, a decision is taken back
  const button = e.target.closest(".decide button"), name = button && nameOf(button.closest("tr"));
  if (!button) return;
  if (decisions[name] === button.value) delete decisions[name]; else decisions[name] = button.value;
  remember(KEY, decisions);
  show();
});
/** @type {(text: string) => string} */
const cell = text => `"${text.replace(/"/g, '""').trim()}"`;
decided.querySelector("button").onclick = () => { // every row without its sentence, and the decision
  const lines = rows().map(row => [...row.cells].slice(0, -1).map(c => c.textContent).concat(row.dataset.own &&
    row.querySelector(`.decide [value=${row.dataset.own}]`).textContent));
  const head = [...heads.slice(0, -1).map(th => th.textContent), decided.dataset.head];
  const table = [head, ...lines].map(line => line.map(cell).join(",")).join("\n");
  download(`${document.title}.csv`, "\ufeff" + table + "\n", "text/csv");
};
show();
