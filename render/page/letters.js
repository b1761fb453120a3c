// Names as on a sheet: letters, with their lowered and raised indices.
import { safe } from "./dom.js";

const LETTERS = JSON.parse(document.getElementById("letters").textContent) ?? parent.planes.lesson.letters;

/** @type {(mark: string) => string} */
export function labelOf(mark) { return mark.slice(mark.lastIndexOf(":") + 1); }
/** @type {(mark: string) => string} */
export function keyOf(mark) { return mark.slice(0, mark.lastIndexOf(":")); } // of its plan
/** @type {(name: string, plan?: string) => string[][]} */
export function lettered(name, plan) { // "v_CB" -> [["v", ""], ["CB", "sub"]]: as on a sheet
  const own = LETTERS[document.documentElement.lang] || {}, first = Object.values(LETTERS)[0], full = `${plan}:${name}`;
  return own[full] || first[full] || own[name] || first[name] || [[name, ""]];
}
/** @type {(name: string, plan?: string) => string} */
export function html(name, plan) { // letters are upright, indices stay whole
  return lettered(name, plan).map(([t, k]) => k ? `<${k}>${safe(t)}</${k}>` : safe(t)).join("");
}
