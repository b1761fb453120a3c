// Elements of the page and what happens to them.

/** An element of the page by its id: whoever asks knows that it is there. @type {(id: string) => HTMLInputElement} */
export const $ = id => /** @type {HTMLInputElement} */ (document.getElementById(id));
/** @type {(node: EventTarget, kind: string, act: (e: any) => void, how?: AddEventListenerOptions | boolean) => void} */
export const on = (node, kind, act, how) => node.addEventListener(kind, act, how);
/** @type {(text: any) => string} */
export function safe(text) { return String(text).replace(/[&<>"]/g, c => `&#${c.charCodeAt(0)};`); }
