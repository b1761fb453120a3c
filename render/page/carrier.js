// Carries a message to the engine and its answer back: by the server of this page, or by a worker with the engine
// itself. The answer to an outdated message of the same kind is dropped, and one that waits for a worker is not sent.
import { $ } from "./dom.js";

/** @type {{ kind: string, address: string, native: boolean }} */
export const way = JSON.parse($("way").textContent);
const waiting = /** @type {Map<number, (answer: any) => void>} */ (new Map());
const latest = /** @type {Record<string, number>} */ ({});
let line = /** @type {Promise<any>} */ (Promise.resolve()); // a worker answers one message after another
let count = 0, pending = 0, worker = /** @type {Worker | null} */ (null);
export const engine = { ready: way.kind === "server", said: /** @type {(step: string) => void} */ (() => {}),
  idle: () => pending === 0 };

/** @type {(answer: any) => void} */
function heard(answer) {
  if (answer.step) {
    engine.ready = answer.step === "ready";
    engine.said(answer.step);
    return;
  }
  waiting.get(answer.id)?.(answer);
  waiting.delete(answer.id);
}
/** @type {(message: any) => Promise<any>} */
async function carried(message) {
  if (way.kind === "server") {
    const found = await fetch("ask", { method: "POST", headers: { "Content-Type": "application/json" },
      body: JSON.stringify(message) });
    return found.json();
  }
  if (way.kind === "none") return { id: message.id, none: true, problems: [] };
  if (!worker) {
    worker = new Worker("worker.js", { type: "module" });
    worker.onmessage = e => heard(typeof e.data === "string" ? JSON.parse(e.data) : e.data);
    worker.onerror = () => engine.said("failed");
    worker.postMessage(JSON.stringify({ runtime: way.address }));
  }
  if (!message.id) return null;
  const sent = line.then(() => latest[message.ask] === message.id ? posted(message) : null); // not an outdated one
  line = sent;
  return sent;
}
/** @type {(message: any) => Promise<any>} */
function posted(message) {
  worker?.postMessage(JSON.stringify(message));
  return new Promise(resolve => waiting.set(message.id, resolve));
}
export function wake() { if (way.kind === "worker" && !worker) void carried({ id: 0, ask: "ready" }); }

/** The answer, or null if a newer message of its kind was sent meanwhile. @type {(message: any) => Promise<any>} */
export async function ask(message) {
  const id = ++count;
  latest[message.ask] = id;
  pending++;
  const answer = await carried({ ...message, id }).finally(() => { pending--; });
  return latest[message.ask] === id ? answer : null;
}
