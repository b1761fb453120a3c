// A folder of scenes as one archive (ZIP, stored): written for any program, read as any program packs it.

const LOCAL = 0x04034b50, CENTRAL = 0x02014b50, END = 0x06054b50, UTF8 = 0x800, DAY_ONE = 0x21; // 1 January 1980
const MOST_FILES = 500, MOST_BYTES = 1e6, SCENE = /\.ya?ml$/i;
const CRC = Uint32Array.from({ length: 256 }, (_, n) => {
  for (let k = 0; k < 8; k++) n = n & 1 ? n >>> 1 ^ 0xedb88320 : n >>> 1;
  return n;
});
/** @typedef {{ name: string, text: string }} Filed */
/** @type {(bytes: Uint8Array) => number} */
const crcOf = bytes => ~bytes.reduce((c, b) => CRC[(c ^ b) & 255] ^ c >>> 8, -1) >>> 0;

/** Numbers of two and four bytes: [2, 20, 4, 0x…]. @type {(...parts: number[]) => Uint8Array} */
function packed(...parts) {
  const out = /** @type {number[]} */ ([]);
  for (let k = 0; k < parts.length; k += 2) {
    for (let byte = 0; byte < parts[k]; byte++) out.push(parts[k + 1] >>> 8 * byte & 255);
  }
  return Uint8Array.from(out);
}
/** @type {(files: Filed[]) => Blob} */
export function zipped(files) {
  const before = /** @type {Uint8Array[]} */ ([]), listed = /** @type {Uint8Array[]} */ ([]);
  const long = (/** @type {Uint8Array[]} */ parts) => parts.reduce((n, p) => n + p.length, 0);
  for (const { name, text } of files) {
    const [title, bytes] = [name, text].map(t => new TextEncoder().encode(t)), at = long(before);
    const about = [2, 20, 2, UTF8, 2, 0, 2, 0, 2, DAY_ONE, 4, crcOf(bytes), 4, bytes.length, 4, bytes.length, 2,
      title.length, 2, 0];
    before.push(packed(4, LOCAL, ...about), title, bytes);
    listed.push(packed(4, CENTRAL, 2, 20, ...about, 2, 0, 2, 0, 2, 0, 4, 0, 4, at), title);
  }
  const end = packed(4, END, 4, 0, 2, files.length, 2, files.length, 4, long(listed), 4, long(before), 2, 0);
  return new Blob(/** @type {BlobPart[]} */ ([...before, ...listed, end]), { type: "application/zip" });
}
/** @type {(bytes: Uint8Array) => Promise<string>} */
async function inflated(bytes) { // up to the size that a scene may have
  const packed = new Blob([/** @type {BlobPart} */ (bytes)]).stream();
  const reader = packed.pipeThrough(new DecompressionStream("deflate-raw")).getReader(), decoder = new TextDecoder();
  let text = "", size = 0;
  for (let part = await reader.read(); !part.done && size < MOST_BYTES; part = await reader.read()) {
    size += part.value.length;
    text += decoder.decode(part.value, { stream: true });
  }
  void reader.cancel();
  return size < MOST_BYTES ? text : "";
}
/** The scenes in an archive; none in what is no archive. @type {(data: ArrayBuffer) => Promise<Filed[]>} */
async function unzipped(data) {
  const view = new DataView(data), bytes = new Uint8Array(data), files = [];
  let end = data.byteLength - 22;
  while (end >= 0 && view.getUint32(end, true) !== END) end--;
  if (end < 0) return [];
  let at = view.getUint32(end + 16, true);
  for (let k = Math.min(view.getUint16(end + 10, true), MOST_FILES); k > 0; k--) {
    if (at + 46 > data.byteLength || view.getUint32(at, true) !== CENTRAL) break;
    const [named, extra, note] = [28, 30, 32].map(n => view.getUint16(at + n, true));
    const from = view.getUint32(at + 42, true);
    const name = new TextDecoder().decode(bytes.subarray(at + 46, at + 46 + named));
    const start = from + 30 + view.getUint16(from + 26, true) + view.getUint16(from + 28, true);
    const own = bytes.subarray(start, start + view.getUint32(at + 20, true)), stored = !view.getUint16(at + 10, true);
    if (SCENE.test(name) && own.length < MOST_BYTES) {
      files.push({ name, text: stored ? new TextDecoder().decode(own) : await inflated(own) });
    }
    at += 46 + named + extra + note;
  }
  return files;
}
/** The scenes among files and archives; a file's name without its folder.
 * @type {(files: File[]) => Promise<Filed[]>} */
export async function scenesIn(files) {
  const all = await Promise.all(files.slice(0, MOST_FILES).map(async f =>
    SCENE.test(f.name) && f.size < MOST_BYTES ? [{ name: f.name, text: await f.text() }] :
      /\.zip$/i.test(f.name) ? await f.arrayBuffer().then(unzipped).catch(() => []) : []));
  const bare = (/** @type {string} */ name) => name.replace(/^.*\//, "").replace(SCENE, "");
  return all.flat().filter(f => f.text.trim()).map(f => ({ ...f, name: bare(f.name) }));
}
