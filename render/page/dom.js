// Elements of the page and their events.

/** An element of the page by its id; it must exist. @type {(id: string) => HTMLInputElement} */
export const $ = id => /** @type {HTMLInputElement} */ (document.getElementById(id));
/** @type {(node: EventTarget, kind: string, act: (e: any) => void, how?: AddEventListenerOptions | boolean) => void} */
export const on = (node, kind, act, how) => node.addEventListener(kind, act, how);
/** The words of a page's elements. @type {(say: (key: string) => string) => void} */
export function worded(say) {
  document.querySelectorAll("[data-word]").forEach(e => { e.textContent = say(e.dataset.word); });
  document.querySelectorAll("[data-title]").forEach(e => {
    e.setAttribute("aria-label", say(e.dataset.title));
    if (e.tagName !== "SECTION") e.title = say(e.dataset.title); // which would cover its contents
  });
}
/** @type {(text: any) => string} */
export function safe(text) { return String(text).replace(/[&<>"]/g, c => `&#${c.charCodeAt(0)};`); }
