// A scene in the address: compressed and written in letters after the #, so that a link contains the mechanism.
import { remember, remembered } from "./memory.js";

const LETTERS = /[-_]/g, KEPT = 60, SHELF = "planes.scenes";

/** @type {(bytes: Uint8Array) => string} */
const written = bytes => btoa(Array.from(bytes, b => String.fromCharCode(b)).join("")).replace(/\+/g, "-")
  .replace(/\//g, "_").replace(/=+$/, "");
/** @type {(text: string) => Uint8Array} */
const bytesOf = text => Uint8Array.from(atob(text.replace(LETTERS, c => c === "-" ? "+" : "/")), c => c.charCodeAt(0));

/** @type {(bytes: any, through: any) => Promise<Uint8Array>} */
async function sent(bytes, through) {
  const stream = new Blob([bytes]).stream().pipeThrough(through);
  return new Uint8Array(await new Response(stream).arrayBuffer());
}
/** @type {(text: string) => Promise<string>} */
export async function pressed(text) {
  return written(await sent(new TextEncoder().encode(text), new CompressionStream("deflate-raw")));
}
/** @type {(text: string) => Promise<string>} */
export async function unpressed(text) {
  return new TextDecoder().decode(await sent(bytesOf(text), new DecompressionStream("deflate-raw")));
}
/** The contents of the address: a scene, or the name of one of the gallery. @type {() => URLSearchParams} */
export function asked() { return new URLSearchParams(location.hash.slice(1)); }

/** @type {() => { title: string, text: string, when: number }[]} */
export function kept() { // the last scenes on this machine, the latest first
  return remembered(SHELF, []);
}
/** @type {(title: string, text: string) => void} */
export function keep(title, text) {
  const others = kept().filter(one => one.text !== text && one.title !== title);
  remember(SHELF, [{ title, text, when: Date.now() }, ...others].slice(0, KEPT));
}
