// The engine, unchanged, in a worker: Python (Pyodide), the packages in one archive; one message in, one answer out.
let answer = /** @type {any} */ (null), ready = /** @type {Promise<void> | null} */ (null);
const say = (/** @type {string} */ step) => postMessage(JSON.stringify({ step }));

/** @type {(runtime: string) => Promise<void>} */
async function start(runtime) {
  say("loading");
  const home = new URL(runtime, location.href).href;
  const [{ loadPyodide }, packages] = await Promise.all([import(`${home}pyodide.mjs`),
    fetch("planes.zip").then(found => found.arrayBuffer())]);
  const python = await loadPyodide({ indexURL: home });
  say("starting");
  python.unpackArchive(packages, "zip", { extractDir: "/home/pyodide/planes" });
  python.runPython("import sys; sys.path.insert(0, '/home/pyodide/planes')");
  const carried = python.pyimport("render.page.studio_page").carried;
  answer = (/** @type {string} */ text) => carried(text);
  say("ready");
}
onmessage = async ({ data }) => {
  const message = JSON.parse(data);
  if (message.runtime) {
    ready = start(message.runtime).catch(() => { say("failed"); });
    return;
  }
  await ready;
  if (answer && message.id) postMessage(answer(data));
};
