// Evaluates a tape: plain straight-line arithmetic, exported with the drawing. Values forwards, slopes backwards.
import { dot } from "./geometry.js";

const CODES = ["add", "sub", "mul", "inv", "neg", "abs", "sqrt", "hypot", "sin", "cos", "atan2", "floor", "max", "min",
  "sel", "lt", "le", "eq", "and", "or", "not"];
/** @type {Record<string, (v: number, a: any, b: number) => number[]>} */
const SLOPES = { // of an operation's result with respect to each of its arguments
  add: () => [1, 1], sub: () => [1, -1], mul: (v, a, b) => [b, a], inv: v => [-v * v], neg: () => [-1],
    abs: (v, a) => [Math.sign(a)],
  sqrt: v => [v ? 0.5 / v : 0], hypot: (v, a, b) => v ? [a / v, b / v] : [0, 0], sin: (v, a) => [Math.cos(a)],
    cos: (v, a) => [-Math.sin(a)],
  atan2: (v, a, b) => { const n = a * a + b * b || 1; return [b / n, -a / n]; }, floor: () => [0],
  max: (v, a, b) => a >= b ? [1, 0] : [0, 1], min: (v, a, b) => a <= b ? [1, 0] : [0, 1],
    sel: (v, ok) => ok ? [0, 1, 0] : [0, 0, 1],
};

/** @type {(code: number, x: number, y: number, z: number) => number} */
function made(code, x, y, z) { // by the operations after the third
  switch (code) {
    case 3: return 1 / x;
    case 4: return -x;
    case 5: return Math.abs(x);
    case 6: return x < 0 ? 0 : Math.sqrt(x);
    case 7: return Math.hypot(x, y);
    case 8: return Math.sin(x);
    case 9: return Math.cos(x);
    case 10: return Math.atan2(x, y);
    case 11: return Math.floor(x);
    case 12: return Math.max(x, y);
    case 13: return Math.min(x, y);
    case 14: return x ? y : z;
    case 15: return +(x < y);
    case 16: return +(x <= y);
    case 17: return +(x === y);
    case 18: return +(x && y);
    case 19: return +(x || y);
    default: return +!x;
  }
}

/** @type {(text: string, names: [string, number][]) => any[][]} */
function unlettered(text, names) { // operations in order: a letter for its name, then how far back each argument stands
  const digit = (/** @type {number} */ k) => { const c = text.charCodeAt(k);
    return c > 96 ? c - 71 : c > 64 && c < 91 ? c - 65 : c > 47 && c < 58 ? c + 4 : c === 45 ? 62 : 63; }, ops = [];
  for (let k = 0; k < text.length;) {
    const [name, count] = names[digit(k++)], op = /** @type {any[]} */ ([name]);
    while (op.length <= count) {
      let back = 0, times = 1, d;
      do { d = digit(k++); back += (d & 31) * times; times *= 32; } while (d > 31);
      op.push(ops.length - back);
    }
    ops.push(op);
  }
  return ops;
}

export class Tape {
  /** @param {TapeData} data */
  constructor(data) {
    this.givens = data.givens;
    this.sources = data.sources || [];
    this.ops = unlettered(data.ops, Object.entries(data.names));
    this.values = new Float64Array(this.ops.length);
    this.slope = new Float64Array(this.ops.length);
    this.code = Int32Array.from(this.ops.flatMap(([op, ...args], p) => {
      const code = CODES.indexOf(op);
      return code < 0 ? [] : [code, p, args[0], args[1] ?? 0, args[2] ?? 0];
    }));
    for (const p in data.consts) this.values[+p] = data.consts[p] === null ? NaN : data.consts[p];
  }
  /** @type {(given: Numbers) => void} */
  run(given) { // sources of error are zero
    for (const name in this.givens) this.values[this.givens[name]] = given[name];
    const v = this.values, c = this.code;
    for (let k = 0; k < c.length; k += 5) {
      const x = v[c[k + 2]], y = v[c[k + 3]];
      v[c[k + 1]] = c[k] < 3 ? (c[k] === 0 ? x + y : c[k] === 1 ? x - y : x * y) : made(c[k], x, y, v[c[k + 4]]);
    }
  }
  /** @type {(place: number) => Float64Array} */
  slopes(place) { // of the number at a place, with respect to every number of the tape
    const g = this.slope.fill(0), v = this.values;
    g[place] = 1;
    for (let p = place; p >= 0; p--) {
      if (!g[p]) continue;
      const [op, ...args] = this.ops[p], slopes = SLOPES[op], [a, b] = args;
      if (!slopes) continue;
      slopes(v[p], v[a], v[b]).forEach((s, k) => { if (s) g[args[k]] += s * g[p]; });
    }
    return g;
  }
  /** @type {(place: number) => number[]} */
  errors(place) { // the effect of each error source, of its size, on the number at a place
    const g = this.slopes(place);
    return this.sources.map(([p, size]) => Number.isFinite(g[p]) ? g[p] * size : 0);
  }
  /** @type {(places: number[], least: number) => Miss} */
  miss([x, y], least) { // a vector with the covariance of its errors
    const ex = this.errors(x), ey = this.errors(y), floor = least * least;
    return new Miss(this.values[x], this.values[y], dot(ex, ex) + floor, dot(ex, ey), dot(ey, ey) + floor, [ex, ey]);
  }
}

// every miss given those before it; a wrong mark says nothing about others
/** @type {(misses: Map<string, Miss>, order: string[], limit: number, least: number) => Map<string, Miss>} */
export function givenBefore(misses, order, limit, least) {
  const names = order.filter(n => misses.has(n)), off = names.flatMap(n => [misses.get(n).x, misses.get(n).y]);
  /** @type {number[][]} */
  const errors = names.flatMap(n => misses.get(n).errors), found = new Map();
  const cov = errors.map((a, i) => errors.map((b, j) => dot(a, b) + (i === j ? least * least : 0)));
  names.forEach((n, i) => {
    const [x, y] = [2 * i, 2 * i + 1];
    found.set(n, new Miss(off[x], off[y], cov[x][x], cov[x][y], cov[y][y], misses.get(n).errors));
    if (!(found.get(n).sigmas <= limit)) return;
    for (const k of [x, y]) {
      const row = [...cov[k]], gain = row.map(c => c / row[k]), seen = off[k];
      gain.forEach((g, j) => { off[j] -= g * seen; row.forEach((c, m) => { cov[j][m] -= g * c; }); });
    }
  });
  return found;
}

export class Miss { // the error of a mark, mm, and its covariance
  /** @param {number} x @param {number} y @param {number} xx @param {number} xy @param {number} yy
   * @param {any} [errors] */
  constructor(x, y, xx, xy, yy, errors) {
    this.x = x; this.y = y;
    this.xx = xx; this.xy = xy; this.yy = yy;
    this.errors = errors;
  }
  get size() { return Math.hypot(this.x, this.y); }
  get sigmas() {
    const { x, y, xx, xy, yy } = this, squared = (yy * x * x - 2 * xy * x * y + xx * y * y) / (xx * yy - xy * xy);
    return Number.isNaN(squared) ? NaN : Math.sqrt(Math.max(squared, 0));
  }
  /** @type {(limit: number) => number} */
  reach(limit) { // the tolerance, mm, in the direction of the miss
    const s = this.sigmas;
    if (s > 1e-9 && this.size > 1e-9) return limit * this.size / s;
    return limit * Math.sqrt((this.xx + this.yy) / 2 + Math.hypot((this.xx - this.yy) / 2, this.xy));
  }
  get mean() { return Math.max(this.xx * this.yy - this.xy * this.xy, 0) ** 0.25; }
  /** @type {(to: { x: number, y: number }, from: { x: number, y: number }) => Miss} */
  moved(to, from) { return new Miss(to.x - from.x, to.y - from.y, this.xx, this.xy, this.yy); }
  get density() { return -0.5 * this.sigmas ** 2 - Math.log(2 * Math.PI) - 0.5 *
    Math.log(this.xx * this.yy - this.xy * this.xy); }
}
