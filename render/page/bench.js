// What is on the bench of the studio: the text in hand, the language, and who takes another one in hand.
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
