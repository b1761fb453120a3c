// Text of the page: where only numbers have changed, no element is replaced.
import { $ } from "./dom.js";

const shown = /** @type {Record<string, any>} */ ({}), TAG = /(<[^>]*>)/, VALUE = /="[^"]*"/g;
/** @type {(a: string, b: string) => boolean} */
const alike = (a, b) => a.startsWith("<") ? a.replace(VALUE, "") === b.replace(VALUE, "") : !b.startsWith("<");

/** @type {(id: string, parts: string[]) => (Node | null)[]} */
function nodes(id, parts) { // an element or a text for each part, none for the end of an element
  const walk = document.createTreeWalker($(id), NodeFilter.SHOW_ELEMENT | NodeFilter.SHOW_TEXT);
  const found = parts.map(p => p.startsWith("</") ? null : walk.nextNode());
  return walk.nextNode() ? [] : found;
}
/** @type {(node: any, was: string, now: string) => void} */
function amend(node, was, now) {
  if (!now.startsWith("<")) { node.data = now; return; }
  const old = was.match(VALUE);
  now.replace(/([\w-]+)(="[^"]*")/g, (_, name, value) => {
    if (value !== old.shift()) node.setAttribute(name, value.slice(2, -1));
    return "";
  });
}
/** @type {(id: string, text: string) => void} */
export function put(id, text) {
  const was = shown[id];
  if (was?.text === text) return;
  const parts = text.split(TAG).filter(Boolean);
  const same = parts.length === was?.nodes.length && parts.every((p, k) => alike(p, was.parts[k]));
  if (!same || /&/.test(text + was.text)) {
    $(id).innerHTML = text;
    shown[id] = { text, parts, nodes: nodes(id, parts) };
    return;
  }
  parts.forEach((p, k) => { if (p !== was.parts[k]) amend(was.nodes[k], was.parts[k], p); });
  Object.assign(was, { text, parts });
}
