// The bench of the studio: the current text, the language, and the functions that open another text.
import { $ } from "./dom.js";

/** @type {Record<string, Record<string, string>>} */
export const words = JSON.parse($("words").textContent);
export const bench = {
  text: "", name: "", view: "gallery", lang: document.documentElement.lang,
  take: /** @type {(text: string, from?: string) => Promise<void>} */ (async () => {}),
  open: /** @type {(text: string, name: string) => void} */ (() => {}),
  act: /** @type {(act: string) => void} */ (() => {}),
};
/** @type {(key: string) => string} */
export const say = key => words[bench.lang]?.[key] ?? words.en[key] ?? key;
