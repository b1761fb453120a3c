// One result over the driver's whole range, by the page's tape: a curve with a cursor at the driver's position.
import { $, on, safe } from "./dom.js";
import { html } from "./letters.js";
import { data, live, state } from "./page.js";
import { begin, circle, end, svg } from "./svg.js";
import { local, number, say } from "./words.js";

const COUNT = 180, W = 640, H = 190, EDGE = [64, 14, 28, 26]; // px: left, top, right, bottom
const RESULT = /^(‖[va]_|omega_|epsilon_|M_|MZ_|F|‖F_|\|F_)/;
const NAMES = Object.keys(data.values).filter(n => data.units[n] && RESULT.test(n));
let drawnOf = "", rows = /** @type {(number | null)[]} */ ([]);

/** @type {(k: number) => number} */
const place = k => data.drive.from + k * (data.drive.to - data.drive.from) / COUNT;

/** @type {(name: string) => void} */
function swept(name) { // the crank is put back
  const now = live.drive;
  rows = Array.from({ length: COUNT + 1 }, (_, k) => {
    live.set({ [data.drive.given]: place(k) });
    return live.failed ? null : live.value(name);
  });
  live.set({ [data.drive.given]: now });
}
export function curve() {
  if (!$("curves").hasAttribute("open") || state.practising || !NAMES.length) return;
  const name = $("curved").value, { given, from, to } = data.drive;
  const others = Object.entries(live.given).filter(([n]) => n !== given).map(([, v]) => v);
  const key = [name, state.lang, ...others].join();
  if (key !== drawnOf) { swept(name); drawnOf = key; }
  const all = rows.filter(v => v !== null);
  const low = Math.min(0, ...all), high = Math.max(0, ...all), span = high - low || 1;
  const x = (/** @type {number} */ at) => EDGE[0] + (W - EDGE[0] - EDGE[2]) * (at - from) / (to - from || 1);
  const y = (/** @type {number} */ v) => EDGE[1] + (H - EDGE[1] - EDGE[3]) * (high - v) / span;
  const node = /** @type {any} */ ($("curve"));
  begin(node);
  for (const v of [low, 0, high].filter((v, k, own) => own.indexOf(v) === k && (v === 0 || all.length))) {
    svg("line", { x1: EDGE[0], y1: y(v), x2: W - EDGE[2], y2: y(v), class: `scale-line${v ? " faint" : ""}` },
      node);
    svg("text", { x: EDGE[0] - 6, y: y(v) + 4, "text-anchor": "end", class: "number" }, node, number(v));
  }
  const marks = data.drive.symbol === "φ" ? [0, 1, 2, 3, 4].map(k => from + k * (to - from) / 4) : [from, to];
  for (const at of marks) svg("text", { x: x(at), y: H - 8, "text-anchor": "middle", class: "number" }, node,
    local(String(+at.toPrecision(4))) + (data.drive.symbol === "φ" ? "°" : ""));
  let d = "";
  rows.forEach((v, k) => { d += v === null ? "" : `${k && rows[k - 1] !== null ? "L" : "M"}${x(place(k)).toFixed(1)} ${
    y(v).toFixed(1)}`; });
  svg("path", { d, class: "run" }, node);
  const at = x(live.drive), v = live.failed ? null : live.value(name);
  svg("line", { x1: at, y1: EDGE[1], x2: at, y2: H - EDGE[3], class: "cursor" }, node);
  if (v !== null) circle([at, y(v)], 4, "cursor-dot", node);
  end();
  $("curve-value").textContent = v === null ? "" : `${number(v)} ${data.units[name][state.lang]}`;
  $("curve").setAttribute("aria-label", `${name.replace(/[‖|]/g, "")}: ${number(low)} … ${number(high)}`);
}
/** The present curve, for scripts. @type {() => { name: string, rows: (number | null)[] }} */
export const curveOf = () => ({ name: $("curved").value, rows });
export function curveNames() {
  $("curves").hidden = !NAMES.length || data.drive.from === data.drive.to;
  $("curve").setAttribute("aria-label", say("curves"));
  const chosen = $("curved").value || NAMES.find(n => /^‖v_[A-Z]\d*‖$/.test(n)) || NAMES[0];
  $("curved").innerHTML = NAMES.map(n => `<option value="${safe(n)}"${n === chosen ? " selected" : ""}>${
    html(n.replace(/[‖|]/g, "")).replace(/<[^>]*>/g, "")}, ${data.units[n][state.lang]}</option>`).join("");
}
on($("curves"), "toggle", curve);
on($("curved"), "change", curve);
