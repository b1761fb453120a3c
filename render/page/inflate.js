// What the page brings along, packed (RFC 1951) and written in letters: unpacked at once, with nothing asked of
// anybody.
const LONG = [3, 4, 5, 6, 7, 8, 9, 10, 11, 13, 15, 17, 19, 23, 27, 31, 35, 43, 51, 59, 67, 83, 99, 115, 131, 163, 195,
  227, 258];
const FAR = [1, 2, 3, 4, 5, 7, 9, 13, 17, 25, 33, 49, 65, 97, 129, 193, 257, 385, 513, 769, 1025, 1537, 2049, 3073,
  4097, 6145, 8193, 12289, 16385, 24577];
const LENGTHS = [16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15];
// trees of a block without its own
const COMMON = [Array.from({ length: 288 }, (_, k) => k < 144 ? 8 : k < 256 ? 9 : k < 280 ? 7 : 8),
  new Array(30).fill(5)];

/** @type {(text: string) => string} */
export function inflated(text) {
  const read = atob(text), bytes = new Uint8Array(read.length);
  for (let k = 0; k < bytes.length; k++) bytes[k] = read.charCodeAt(k);
  let out = new Uint8Array(8 * bytes.length), end = 0, held = 0, count = 0, at = 0;
  const need = (/** @type {number} */ n) => { for (; count < n; count += 8) held |= bytes[at++] << count; };
  const bits = (/** @type {number} */ n) => { need(n); const v = held & ((1 << n) - 1); held >>>= n; count -= n;
    return v; };
  /** @param {number[]} lengths */
  const tree = lengths => { // by as many bits as the longest code has: a symbol and the length of its code
    const most = Math.max(...lengths), found = new Uint16Array(1 << most);
    for (let n = 1, code = 0; n <= most; n++, code <<= 1) lengths.forEach((long, s) => {
      if (long !== n) return;
      let back = 0;
      for (let k = 0; k < n; k++) back |= (code >> k & 1) << (n - 1 - k);
      for (code++; back < found.length; back += 1 << n) found[back] = s << 4 | n;
    });
    return { most, found };
  };
  const symbol = (/** @type {any} */ { most, found }) => {
    need(most);
    const one = found[held & ((1 << most) - 1)], n = one & 15;
    if (!n || at > bytes.length + 2) throw new Error("packed data");
    held >>>= n;
    count -= n;
    return one >> 4;
  };
  const room = (/** @type {number} */ n) => {
    if (end + n > out.length) { const more = new Uint8Array(2 * out.length + n); more.set(out);
    out = more; } };
  const table = () => { // the two trees of a block
    const literals = bits(5) + 257, all = literals + bits(5) + 1, own = bits(4) + 4, sizes = new Array(19).fill(0);
    const lengths = /** @type {number[]} */ ([]);
    for (let k = 0; k < own; k++) sizes[LENGTHS[k]] = bits(3);
    for (const code = tree(sizes); lengths.length < all;) {
      const s = symbol(code);
      if (s < 16) { lengths.push(s); continue; }
      /** @type {number} */
      const last = s === 16 ? lengths[lengths.length - 1] : 0;
      for (let k = s === 16 ? 3 + bits(2) : s === 17 ? 3 + bits(3) : 11 + bits(7); k; k--) lengths.push(last);
    }
    return [tree(lengths.slice(0, literals)), tree(lengths.slice(literals))];
  };
  let last = 0;
  while (!last) {
    last = bits(1);
    const [letters, ways] = bits(2) === 1 ? COMMON.map(tree) : table();
    for (let s; (s = symbol(letters)) !== 256;) {
      if (s < 256) { room(1); out[end++] = s; continue; }
      s -= 257;
      const long = LONG[s] + bits(s < 8 || s > 27 ? 0 : (s - 4) >> 2), w = symbol(ways);
      const far = FAR[w] + bits(w < 4 ? 0 : (w - 2) >> 1);
      room(long);
      for (let k = 0; k < long; k++, end++) out[end] = out[end - far];
    }
  }
  return new TextDecoder().decode(out.subarray(0, end));
}
