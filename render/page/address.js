// The reader's place in the address: the frame, the drive, the language, every number that differs from the scene's.
import { clamp } from "./geometry.js";
import { allowed } from "./grips.js";
import { data, live, state, words } from "./page.js";

let timer = 0;

export function readAddress() {
  const q = new URLSearchParams(location.hash.length > 1 ? location.hash.slice(1) : location.search);
  const numbers = /** @type {Record<string, any>} */ ({});
  state.seed = /^\d{1,6}$/.test(q.get("seed")) ? +q.get("seed") : 0;
  if (q.has("step")) state.frame = clamp(+q.get("step") - 1, 0, data.frames.length - 1);
  if (q.has("at") && Number.isFinite(+q.get("at"))) numbers[data.drive.given] = live.placed(+q.get("at"));
  for (const k of data.knobs) numbers[k.given] = q.has(k.given) && allowed(k, +q.get(k.given)) ? +q.get(k.given) : k.at;
  live.back(data.home);
  live.set(numbers);
  if (live.altered.length) live.scan();
  state.coloured = q.get("colour") === "1";
  if (q.get("lang") in words) state.lang = q.get("lang");
}
export function writeAddress() {
  clearTimeout(timer);
  const own = live.altered.map(n => `&${encodeURIComponent(n)}=${+live.given[n].toPrecision(9)}`).join("");
  const seeded = state.practising && state.seed;
  const colour = state.coloured ? "&colour=1" : "";
  const text = `#${seeded ? `seed=${state.seed}` :
    `step=${state.frame + 1}&at=${+live.drive.toFixed(6)}`}&lang=${state.lang}${colour}${
      state.practising ? "" : own}`;
  timer = setTimeout(() => { try { history.replaceState(null, "", text);
    } catch { /* a page inside a page has no address */ } }, 120);
}
