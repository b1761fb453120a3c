"use strict";
// Reads a tape: plain arithmetic in a straight line, exported with the drawing. Values forwards, slopes backwards.

const OPERATIONS = {
  add: (a, b) => a + b, sub: (a, b) => a - b, mul: (a, b) => a * b, inv: a => 1 / a, neg: a => -a, abs: Math.abs,
  sqrt: a => Math.sqrt(Math.max(a, 0)), hypot: Math.hypot, sin: Math.sin, cos: Math.cos, atan2: Math.atan2, floor: Math.floor,
  max: Math.max, min: Math.min, sel: (ok, a, b) => ok ? a : b, lt: (a, b) => +(a < b), le: (a, b) => +(a <= b),
  eq: (a, b) => +(a === b), and: (a, b) => +(a && b), or: (a, b) => +(a || b), not: a => +!a,
};
const SLOPES = { // of an operation's result with respect to each of its arguments
  add: () => [1, 1], sub: () => [1, -1], mul: (v, a, b) => [b, a], inv: v => [-v * v], neg: () => [-1], abs: (v, a) => [Math.sign(a)],
  sqrt: v => [v ? 0.5 / v : 0], hypot: (v, a, b) => v ? [a / v, b / v] : [0, 0], sin: (v, a) => [Math.cos(a)], cos: (v, a) => [-Math.sin(a)],
  atan2: (v, a, b) => { const n = a * a + b * b || 1; return [b / n, -a / n]; }, floor: () => [0],
  max: (v, a, b) => a >= b ? [1, 0] : [0, 1], min: (v, a, b) => a <= b ? [1, 0] : [0, 1], sel: (v, ok) => ok ? [0, 1, 0] : [0, 0, 1],
};

class Tape {
  constructor(data) {
    Object.assign(this, data);
    this.values = new Float64Array(data.ops.length);
    this.slope = new Float64Array(data.ops.length);
    for (const p in data.consts) this.values[p] = data.consts[p] === null ? NaN : data.consts[p];
  }
  run(given) { // sources of error are nothing
    for (const name in this.givens) this.values[this.givens[name]] = given[name];
    const v = this.values;
    this.ops.forEach(([op, ...args], p) => {
      const made = OPERATIONS[this.names[op]];
      if (made) v[p] = made(...args.map(a => v[a]));
    });
  }
  errors(place) { // how far each source's own error, of its size, moves the number at a place
    const g = this.slope.fill(0), v = this.values;
    g[place] = 1;
    for (let p = place; p >= 0; p--) {
      if (!g[p]) continue;
      const [op, ...args] = this.ops[p], slopes = SLOPES[this.names[op]];
      if (!slopes) continue;
      slopes(v[p], ...args.map(a => v[a])).forEach((s, k) => { if (s) g[args[k]] += s * g[p]; });
    }
    return this.sources.map(([p, size]) => Number.isFinite(g[p]) ? g[p] * size : 0);
  }
  miss([x, y], least) { // a vector with the covariance of its errors
    const ex = this.errors(x), ey = this.errors(y), floor = least * least;
    const sum = (a, b) => a.reduce((s, e, k) => s + e * b[k], 0);
    return new Miss(this.values[x], this.values[y], sum(ex, ex) + floor, sum(ex, ey), sum(ey, ey) + floor, [ex, ey]);
  }
}

function givenBefore(misses, order, limit, least) { // every miss with those before it known; what is off tells nothing of others
  const names = order.filter(n => misses.has(n)), off = names.flatMap(n => [misses.get(n).x, misses.get(n).y]);
  const errors = names.flatMap(n => misses.get(n).errors), found = new Map();
  const cov = errors.map((a, i) => errors.map((b, j) => a.reduce((s, e, k) => s + e * b[k], i === j ? least * least : 0)));
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

class Miss { // by how much a mark is off, mm, and how surely
  constructor(x, y, xx, xy, yy, errors) { Object.assign(this, { x, y, xx, xy, yy, errors }); }
  get size() { return Math.hypot(this.x, this.y); }
  get sigmas() {
    const { x, y, xx, xy, yy } = this, squared = (yy * x * x - 2 * xy * x * y + xx * y * y) / (xx * yy - xy * xy);
    return Number.isNaN(squared) ? NaN : Math.sqrt(Math.max(squared, 0));
  }
  reach(limit) { // the tolerance, mm, the way the miss lies
    const s = this.sigmas;
    if (s > 1e-9 && this.size > 1e-9) return limit * this.size / s;
    return limit * Math.sqrt((this.xx + this.yy) / 2 + Math.hypot((this.xx - this.yy) / 2, this.xy));
  }
  get mean() { return Math.max(this.xx * this.yy - this.xy * this.xy, 0) ** 0.25; }
  moved(to, from) { return new Miss(to.x - from.x, to.y - from.y, this.xx, this.xy, this.yy); }
  get density() { return -0.5 * this.sigmas ** 2 - Math.log(2 * Math.PI) - 0.5 * Math.log(this.xx * this.yy - this.xy * this.xy); }
}
