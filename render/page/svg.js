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
/** @type {(points: Spot[]) => string} */
export function coordinates(points) { return points.map(p => p.map(v => v.toFixed(1)).join(",")).join(" "); }
/** @type {(at: Spot, r: number, cls: string, parent: Element, more?: Attributes) => any} */
export function circle([x, y], r, cls, parent, more = {}) {
  return svg("circle", { ...more, class: cls, cx: x.toFixed(1), cy: y.toFixed(1), r: +r.toFixed(2) }, parent);
}
/** An arc about a centre, from an angle to another one, radians, clockwise where they grow.
 * @type {(o: Spot, r: number, from: number, to: number, attributes: Attributes, parent: Element) => any} */
export function arc([x, y], r, from, to, attributes, parent) {
  const [a, b] = [from, to].map(t => `${(x + r * Math.cos(t)).toFixed(1)} ${(y + r * Math.sin(t)).toFixed(1)}`);
  const large = Math.abs(to - from) > Math.PI ? 1 : 0, by = r.toFixed(1);
  return svg("path", { ...attributes, d: `M${a}A${by} ${by} 0 ${large} ${to > from ? 1 : 0} ${b}` }, parent);
}
