// What a page remembers on this machine; a private window remembers nothing.

/** @type {(key: string, otherwise: any) => any} */
export function remembered(key, otherwise) {
  try { return JSON.parse(localStorage.getItem(key) ?? "null") ?? otherwise; } catch { return otherwise; }
}
/** @type {(key: string, value: any) => void} */
export function remember(key, value) {
  try { localStorage.setItem(key, JSON.stringify(value)); } catch { /* nothing is kept */ }
}
