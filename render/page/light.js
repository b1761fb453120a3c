// A name under the pointer, lit with its term, its segment and its link wherever they are.
import { on } from "./dom.js";
import { data } from "./page.js";

let lit = [];
function light(names, on) {
  lit = on ? names : [];
  const all = new Set(names);
  for (const n of names) {
    for (const r of data.related[n] || []) all.add(r);
    if (n.startsWith("link:") ||
      n.startsWith("position:")) for (const k in data.related) if (data.related[k].includes(n)) all.add(k);
  }
  document.querySelectorAll("main [data-name]").forEach(e => {
    if (e.dataset.name.split(" ").some(n => all.has(n))) e.classList.toggle("hover", on);
  });
}
export function relight() { if (lit.length) light(lit, true); } // on a page drawn anew
on(window, "mouseover",
  e => { const t = e.target.closest("[data-name]"); if (t) light(t.dataset.name.split(" "), true); });
on(window, "mouseout",
  e => { const t = e.target.closest("[data-name]"); if (t) light(t.dataset.name.split(" "), false); });
