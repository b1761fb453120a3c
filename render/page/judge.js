// Judges moved marks by the exported numbers as the engine does: which step is wrong, and which mistake explains it.
import { Miss, Tape, givenBefore } from "./tape.js";

export class Judge {
  /** @param {any} data */
  constructor(data) { this.data = data; this.rule = data.rule; this.tape = new Tape(data.tape); }
  /** @type {(marks: Mark[]) => Found} */
  judge(marks) { // marks: {name, x, y, read}; the same with verdicts and misses, the first wrong one, the sentence
    const given = {}, rule = this.rule;
    for (const m of marks) Object.assign(given, { [m.key + ".x"]: m.x, [m.key + ".y"]: m.y, [m.key + "?"]: +m.read });
    this.tape.run({ ...this.data.earlier, ...given });
    const read = marks.filter(m => m.read);
    const out = /** @type {Found} */ (/** @type {any} */ ({ marks: {}, first: null, named: null }));
    out.limit = Math.sqrt(-2 * Math.log(rule.false_alarm / Math.max(read.length, 4)));
    const plain = new Map(read.map(m => [m.name, this.tape.miss(m.miss, rule.least)]));
    const misses = givenBefore(plain, rule.order, out.limit, rule.least);
    const free = new Map(read.map(m => [m.name,
      new Miss(m.x - m.true[0], m.y - m.true[1], m.free[0], m.free[1], m.free[2])]));
    const fits = (/** @type {Miss} */ miss) => miss.sigmas <= out.limit;
    let wrong = read.filter(m => !fits(misses.get(m.name))).map(m => m.name);
    const near = read.filter(m => misses.get(m.name).sigmas > rule.near).map(m => m.name);
    const close = near.some(n => misses.get(n).sigmas > rule.warn);
    const ranked = near.length ? this.ranked(plain, misses, wrong.length ? wrong.slice(0, 1) : near, out.limit) : [];
    const other = wrong.length ? Math.log(rule.other) + rule.broad - this.mixed(misses.get(wrong[0])) : close ?
      rule.too_well : Infinity;
    if (ranked.length && ranked[0].score >= Math.max(0, other)) {
      const [best, next] = ranked; // it beats "some other cause", or fits too well within limits
      if (!wrong.length) wrong = read.filter(m => m.name === best.v.blames).map(m => m.name);
      if (!next || best.score - next.score >= rule.margin) out.named = this.explained(best, out.limit);
    } else if (!wrong.length && ranked.length && ranked[0].score >= rule.as_well) out.asWell = ranked[0].v.blames;
    wrong = wrong.filter((n, k) => !k || !fits(free.get(n))); // displaced by a wrong mark, but in its right place
    out.first = out.named ? out.named.blames : wrong.length ? wrong[0] : null;
    this.verdicts(out, marks, misses, free, wrong);
    out.sentence = this.said(out, read, misses, wrong);
    return out;
  }
  /** @type {(miss: Miss) => number} */
  mixed(miss) { // logarithm of the density of a miss: normal, with occasional slips
    const { broad, slip } = this.rule, normal = Number.isFinite(miss.sigmas) ? miss.density : -Infinity;
    const high = Math.max(normal, broad), low = Math.min(normal, broad), likely = normal >= broad ? 1 - slip : slip;
    const a = high + Math.log(likely), b = low + Math.log(1 - likely), top = Math.max(a, b);
    return top + Math.log(Math.exp(a - top) + Math.exp(b - top));
  }
  /** @type {(plain: Map<string, Miss>, misses: Map<string, Miss>, suspects: string[], limit: number) => any[]} */
  ranked(plain, misses, suspects, limit) { // the mistakes that concern a suspected mark, the likeliest first
    const rule = this.rule, drawn = new Set([...misses.keys()].filter(n => !rule.absent.includes(n)));
    const groups = new Map();
    for (const v of this.data.variants) {
      const at = Object.entries(v.under).filter(([n]) => misses.has(n));
      const touched = new Map(at.map(([n, places]) => [n, this.tape.miss(places, rule.least)]));
      if (!suspects.some(n => touched.has(n) && Number.isFinite(touched.get(n).sigmas))) continue;
      const own = touched.has(v.blames) ? [[v.blames, touched.get(v.blames)]] : [...touched];
      if (!v.omits && !own.some(([n, miss]) => !(misses.get(n).moved(miss, plain.get(n)).sigmas <= limit))) continue;
      const under = givenBefore(new Map([...plain, ...touched]), rule.order, limit, rule.least);
      const at_it = under.get(v.blames);
      // nearer to its right place than to where this mistake puts it
      if (at_it && at_it.sigmas >= misses.get(v.blames).sigmas) continue;
      const likely = drawn.has(v.blames) !== v.omits ? 1 : rule.undrawn;
      let score = Math.log(v.weight * likely);
      for (const [n, miss] of under) score += this.mixed(miss) - this.mixed(misses.get(n));
      const group = groups.get(v.mistake) || [];
      groups.set(v.mistake, [...group, { score, v, under }]);
    }
    return [...groups.values()].map(group => {
      const best = group.reduce((/** @type {any} */ a, /** @type {any} */ b) => b.score > a.score ? b : a);
      return { ...best, score: best.score +
        Math.log(group.reduce((/** @type {number} */ s, /** @type {any} */ one) => s + Math.exp(one.score - best.score),
        0)) };
    }).sort((a, b) => b.score - a.score);
  }
  /** @type {(best: any, limit: number) => any} */
  explained(best, limit) { // the mistake with the marks it explains
    return { ...best.v, explained: [...best.under].filter(([, miss]) => miss.sigmas <= limit).map(([n]) => n) };
  }
  /** @type {(out: Found, marks: Mark[], misses: Map<string, Miss>, free: Map<string, Miss>,
   * wrong: string[]) => void} */
  verdicts(out, marks, misses, free, wrong) {
    const explained = out.named ? out.named.explained : [];
    let upset = false;
    for (const m of marks) {
      upset ||= m.name === out.first;
      /** @type {Judged} */
      const one = out.marks[m.name] = { verdict: "unread", close: false, own: misses.get(m.name),
        free: free.get(m.name) };
      if (!m.read) continue;
      if (wrong.includes(m.name) && !(explained.includes(m.name) && m.name !== out.first)) { one.verdict = "wrong";
        upset = true; }
      else one.verdict = (upset || wrong.includes(m.name)) && one.free.sigmas > out.limit ? "follows" : "right";
      one.close = one.verdict === "right" && one.own.sigmas > this.rule.warn;
    }
  }
  /** @type {(read: Mark[], misses: Map<string, Miss>, limit: number, size: number) => number} */
  chance(read, misses, limit, size) { // the probability that random marks would be as right: see evidence.py
    const { gap, free, same } = this.rule, shares = gap ? [Math.min(gap * limit / size, 1) ** 2] : [], stand = [[0, 0]];
    for (const m of read) {
      const reach = limit * misses.get(m.name).mean;
      if (!same.includes(m.name) &&
        stand.every(([x, y]) => Math.hypot(m.x - x, m.y - y) > reach)) shares.push(Math.min(reach / size, 1) ** 2);
      stand.push([m.x, m.y]);
    }
    // for a scale, the surest one keeps its direction
    const all = shares.reduce((a, b) => a * b, 1), surest = Math.min(...shares);
    return free && shares.length ? all / surest * Math.min(Math.sqrt(surest) / Math.PI, 1) : all;
  }
  /** @type {(name: string, read: Mark[], miss: Miss, fill: (text: string, names: any) => string) => string} */
  off(name, read, miss, fill) { // the measure of a wrong vector, and the right one from the marks before it
    const { said } = this.data, mark = read.find(m => m.name === name);
    const start = mark?.from === "p" ? { x: 0, y: 0 } : read.find(m => m.name === mark?.from);
    if (!mark || !start) return fill(said.unclear, { mark: name, off: miss.size.toFixed(1) });
    const x = mark.x - start.x, y = mark.y - start.y, right = [x - miss.x, y - miss.y];
    const angle = (/** @type {number[]} */ [u, v]) =>
      String(Math.round(Math.atan2(v, u) * 180 / Math.PI)).replace("-", "−");
    return fill(said.off_vector, { mark: name, vector: mark.vector, mm: Math.hypot(x, y).toFixed(1),
      angle: angle([x, y]), true_mm: Math.hypot(...right).toFixed(1), true_angle: angle(right) });
  }
  /** @type {(out: Found, read: Mark[], misses: Map<string, Miss>, wrong: string[]) => string} */
  said(out, read, misses, wrong) { // the outcome in a sentence, and its verdict
    const { said, rule } = this.data;
    const fill = (/** @type {string} */ text, /** @type {any} */ names) => text.replace(/⟦(\w+)⟧/g,
      (/** @type {string} */ _, /** @type {string} */ k) => names[k]);
    const found = rule.key.filter((/** @type {string} */ n) => misses.has(n)), count = misses.size;
    const missing = rule.key.filter((/** @type {string} */ n) => !misses.has(n)).join(", ");
    out.verdict = "unreadable";
    if (!count) return fill(said.nothing, { names: missing });
    if (found.length < rule.readable * rule.key.length) {
      // on a line of marks only one may be key
      const drawn = Object.keys(out.marks).filter(n => !rule.same.includes(n));
      return fill(said.too_little,
        { found: drawn.filter(n => misses.has(n)).length, count: drawn.length, names: missing });
    }
    const size = Math.max(...read.map(m => Math.hypot(m.x, m.y))), told = { count, size: size.toFixed(1) };
    if (size < rule.smallest) return fill(said.nothing_drawn, told);
    const left = this.data.otherwise, strays = left && !(left.mark && misses.has(left.mark));
    if (!out.first && !strays && this.chance(read, misses, out.limit, size) > rule.sure) return fill(said.by_chance,
      told);
    const bad = Object.values(out.marks).filter(m => m.verdict === "wrong").length;
    if (!out.named && count >= 3 && bad > 0.7 * count) return fill(said.other, { count, wrong: bad });
    out.verdict = "wrong";
    if (out.named) return out.named.said;
    if (wrong.length) return this.off(wrong[0], read, misses.get(wrong[0]), fill);
    if (strays) { out.first = left.first; return left.said; }
    const hidden = rule.shown_by.filter((/** @type {any} */ [,
      by]) => !by.some((/** @type {string[]} */ way) => way.every((/** @type {string} */ n) => misses.has(n)))).map(
      (/** @type {any} */ [n]) => n);
    const unseen = [...new Set([...hidden, ...(out.asWell ? [out.asWell] : [])])].join(", ");
    out.verdict = unseen ? "right_as_seen" : "right";
    return unseen ? fill(said.as_seen, { names: unseen }) : said.right;
  }
}
