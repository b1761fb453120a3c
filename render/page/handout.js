// The lesson on paper: a page per plan, in the position shown, in true millimetres if it fits; its steps beneath.
import { $ } from "./dom.js";
import { lines } from "./equations.js";
import { seenAt } from "./frames.js";
import { html } from "./letters.js";
import { data, live, state } from "./page.js";
import { Plan } from "./plan.js";
import { inWords, noted } from "./rows.js";
import { Scheme } from "./scheme.js";
import { svg } from "./svg.js";
import { filled, number, say, sentence } from "./words.js";
const PAPER = 96 / 25.4, WIDE = 690, TALL = 269 * PAPER, BODY = [250, 215], ARMS = [300, 200];
// the height of a figure, the size of the type
const FITS = [[400, 1], [400, 0.93], [330, 1], [330, 0.9], [270, 0.9], [230, 0.85], [200, 0.8], [200, 0.72]];

/** @type {() => { key: string, frames: number[] }[]} */
function parts() { // the frames of each plan; moments belong to the plan that needs them
  const found = /** @type {any[]} */ ([]);
  data.frames.forEach((f, k) => {
    const last = found[found.length - 1];
    const links = f.plan === "position" && f.moments !== null ? data.moments[f.moments].links : [];
    const own = f.chapter === "centres" ? f.chapter : f.plan;
    const key = data.plans.find(p => p.links.includes(links[0]))?.key || own;
    if (last && last.key === key) last.frames.push(k); else found.push({ key, frames: [k] });
  });
  return found;
}
/** @type {(key: string, k: number, most: number[], parent: Element, shown?: { full?: boolean,
 * frame?: Frame }) => boolean} */
function drawn(key, k, most, parent, shown = {}) { // a figure no larger than that, at 1:1 if possible
  const node = svg("svg", { class: "figure" }, parent);
  const figure = key === "position" ? new Scheme(node, data, most) : new Plan(node, data, most), seen = seenAt(k);
  const paint = () => figure.show(key, seen, shown.frame);
  paint();
  if (shown.full && figure.k >= PAPER) {
    figure.size = most.map((side, i) => Math.min(side,
      side - (figure.k - PAPER) * (figure.view[i + 2] - figure.view[i])));
    paint();
  }
  node.setAttribute("width", figure.w);
  node.setAttribute("height", figure.h);
  return Math.abs(figure.k - PAPER) < 1e-6;
}
export function handout() {
  const own = live.altered.map(n => data.knobs.find(k => k.given === n)).map(k => `; ${k.plan ? "μ" :
    html(k.name)} = ${number(live.given[k.given])} ${k.plan ? "" : k.unit[state.lang]}`);
  $("handout").innerHTML = "";
  $("handout").className = "laid";
  for (const part of parts()) {
    const page = $("handout").appendChild(document.createElement("article"));
    const fits = /** @param {number[]} how */ ([tall, type]) => {
      page.style.setProperty("--type", String(type));
      sheet(page, part, tall, own.join(""));
      return page.offsetHeight < TALL;
    };
    FITS.some(fits) || fits(FITS[0]); // too much for a page: take two
  }
  $("handout").className = "";
}
/** @type {(page: HTMLElement, part: { key: string, frames: number[] }, tall: number, own: string) => void} */
function sheet(page, { key, frames }, tall, own) { // a plan, its group, its steps
  const centres = key === "centres", of = centres ? "position" : key, last = frames[frames.length - 1];
  const p = data.plans.find(p => p.key === of);
  page.innerHTML = `<h2>${centres ? say("centres") : p.title[state.lang]}, μ = ${filled(p.mu[state.lang])} <small>${$(
    "value").textContent}${own}</small></h2><div class="figures"></div>`;
  const figures = page.querySelector(".figures"), group = key.startsWith("force") && p.links.length;
  const exact = drawn(of, last, group ? [WIDE - BODY[0] - 10, tall] : [WIDE, tall], figures,
    { full: true, frame: centres ? data.frames[last] : undefined });
  if (exact) page.querySelector("small").insertAdjacentText("beforeend", "; 1 : 1");
  if (group) drawn("position", last, BODY, figures,
    { frame: data.frames[frames.filter(k => data.frames[k].plan === key).pop()] });
  page.insertAdjacentHTML("beforeend", `<ol${data.frames.length > 99 ? ' class="hundreds"' : ""}></ol>`);
  frames.forEach(k => step(k, /** @type {Element} */ (page.lastElementChild)));
}
/** @type {(k: number, list: Element) => void} */
function step(k, list) { // the words of a frame; the equation it begins; the arms of a moment equation
  const f = data.frames[k], item = document.createElement("li"), onScheme = f.plan === "position";
  item.value = k + 1;
  const begins = f.equation !== null && data.frames.findIndex(g => g.equation === f.equation) === k && !onScheme;
  item.innerHTML = `${begins ? lines(data.equations[f.equation], false, f, data.frames.length) :
    ""}<p>${sentence(inWords(f) + noted(f), f.plan)}</p><p class="why">${sentence(f.why[state.lang], f.plan)}</p>`;
  if (onScheme && f.moments !== null && f.key === "moments") drawn("position", k, ARMS, item, { frame: f });
  list.appendChild(item);
}
