// By choice a link and the vectors that are its own have one colour in both figures and in the equations: Okabe and
// Ito's colours, told apart by who sees colours otherwise; the style has them, the lightest with some ink.
import { writeAddress } from "./address.js";
import { $ } from "./dom.js";
import { data, draw, state } from "./page.js";

const FIGURES = "#scheme [data-name], #plan [data-name], #equations .term", COLOURS = 7;

/** @type {(mark: string) => string} */
function carrier(mark) { // the link whose point it is: of several that about a pivot, or on a guide of the frame
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
export function coloured() { // on what is drawn anew; the colours themselves are the style's
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
