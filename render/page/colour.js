// On request a link and its vectors have one colour in both figures and in the equations: those of Okabe and Ito,
// distinct for the colour-blind; they are in the style sheet, the lightest darkened.
import { writeAddress } from "./address.js";
import { $ } from "./dom.js";
import { data, draw, state } from "./page.js";

const FIGURES = "#scheme [data-name], #plan [data-name], #equations .term", COLOURS = 7;

/** @type {(mark: string) => string} */
function carrier(mark) { // the link of the point: of several the one about a pivot, or on a guide of the frame
  const { links, guides, pivots } = data.scheme, own = links.filter(l => l.points.includes(mark));
  const fixed = (/** @type {Link} */ l) => guides.some(g => g.name === l.slides && g.link === "0");
  const one = own.length > 1 ? own.find(l => l.points.some(p => pivots.includes(p))) || own.find(fixed) : own[0];
  return one ? `link:${one.name}` : "";
}
/** @type {(name: string) => string} */
function ownerOf(name) {
  const own = name.startsWith("link:") ? name : (data.related[name] || [""])[0];
  return own.startsWith("position:") ? carrier(own) : own;
}
export function coloured() { // on new elements; the colours themselves are in the style sheet
  document.body.classList.toggle("coloured", state.coloured);
  $("colour").setAttribute("aria-pressed", String(state.coloured));
  if (!state.coloured) return;
  const numbered = new Map(data.scheme.links.map((l, k) => [`link:${l.name}`, k % COLOURS]));
  document.querySelectorAll(FIGURES).forEach(e => {
    const found = e.dataset.name.split(" ").map(ownerOf).find((/** @type {string} */ l) => numbered.has(l));
    if (found) e.dataset.own = numbered.get(found);
    else delete e.dataset.own;
  });
}
$("colour").onclick = () => { state.coloured = !state.coloured; writeAddress(); draw(); };
