// Elements of a drawing: made once, reused when it is redrawn, updated only where they change.
const NS = "http://www.w3.org/2000/svg", spare = new WeakMap(), had = new WeakMap(), begun = /** @type {any[]} */ ([]);

/** @type {(parent: Element) => void} */
export function begin(parent) { // its elements are to be reused, in order
  spare.set(parent, parent.firstChild);
  begun.push(parent);
}
export function end() { // unused elements are removed
  for (const parent of begun.splice(0)) {
    for (let e = spare.get(parent), next; e; e = next) { next = e.nextSibling; e.remove(); }
    spare.delete(parent);
  }
}
/** @type {(e: Element, attributes: Attributes) => void} */
export function alter(e, attributes) { // only changed attributes
  const was = had.get(e) ?? {};
  for (const k in attributes) if (was[k] !== attributes[k]) e.setAttribute(k, String(was[k] = attributes[k]));
  had.set(e, was);
}
/** @type {(tag: string, attributes: Attributes, parent?: any, text?: string) => any} */
export function svg(tag, attributes, parent, text) {
  let e = parent && spare.get(parent);
  if (e) spare.set(parent, e.nextSibling);
  if (e?.nodeName !== tag) {
    const made = document.createElementNS(NS, tag);
    if (e) e.replaceWith(made); else parent?.appendChild(made);
    e = made;
  } else {
    for (const k in had.get(e)) if (!(k in attributes)) { e.removeAttribute(k); delete had.get(e)[k]; }
    if (text === undefined && e.firstElementChild) begin(e);
    else if (text === undefined && e.firstChild) e.textContent = "";
  }
  if (text !== undefined && (e.firstElementChild || e.textContent !== text)) e.textContent = text;
  alter(e, attributes);
  return e;
}
