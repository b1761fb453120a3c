// A name under the pointer, highlighted with its term, its segment and its link wherever they are.
import { on } from "./dom.js";
import { data } from "./page.js";

let lit = /** @type {any[]} */ ([]);
/** @type {(names: string[], on: boolean) => void} */
function light(names, on) {
  lit = on ? names : [];
  const all = new Set(names);
  for (const n of names) {
    for (const r of data.related[n] || []) all.add(r);
    if (n.startsWith("link:") ||
      n.startsWith("position:")) for (const k in data.related) if (data.related[k].includes(n)) all.add(k);
  }
  document.querySelectorAll("main [data-name]").forEach(e => {
    if (e.dataset.name.split(" ").some((/** @type {string} */ n) => all.has(n))) e.classList.toggle("hover", on);
  });
}
export function relight() {
  document.querySelectorAll(".hover").forEach(e => e.classList.remove("hover"));
  light(lit, true);
} // after redrawing
for (const kind of ["mouseover", "mouseout"]) on(window, kind, e => {
  const t = e.target.closest("[data-name]");
  if (t) light(t.dataset.name.split(" "), kind === "mouseover");
});
