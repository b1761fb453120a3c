// Letters of a figure at the best of some places: clear of strokes, of other letters and of the edge.
import { distance, gap } from "./geometry.js";
import { lettered } from "./letters.js";
import { alter, svg } from "./svg.js";

// cost of overlapping labels: more than any number of strokes
const UPON = 40, ROUNDS = 4;
// and what one nearer to another vector than to its own, which it would name: as much as several strokes through it
const STRANGE = 8;

const ruler = /** @type {any} */ (document.createElement("canvas").getContext("2d")), widths = new Map();
/** @type {(names: string[], plan: string, size: number) => number} */
function wide(names, plan, size) { // the width of a label, px
  const key = `${document.documentElement.lang} ${plan} ${size} ${names.join(" ")}`;
  if (!widths.has(key)) {
    /** @type {(text: string, small?: string) => number} */
    const one = (text, small) => {
      ruler.font = `italic ${small ? 0.7 * size : size}px "DejaVu Serif", Georgia, serif`;
      return ruler.measureText(text).width;
    };
    const all = names.map(n => lettered(n, plan).reduce((s, [text, kind]) => s + one(text, kind), 0));
    widths.set(key, all.reduce((w, own, i) => w + (i ? one(" = ") : 0) + own, 0));
  }
  return widths.get(key);
}
/** @type {(parent: Element, names: string[], x: any, y: any, size: number, plan: string, joint?: string,
 * as?: string) => any} */
export function letters(parent, names, x, y, size, plan, joint = ", ", as = names.join(" ")) {
  const t = svg("text", { x, y, "font-size": size, class: "label", "text-anchor": "middle", "data-name": as }, parent);
  let back = 0;
  /** @type {(text: string, shift: number, small?: string) => void} */
  const put = (text, shift, small) => {
    svg("tspan", { dy: (shift - back).toFixed(2), ...(small ? { "font-size": (size * 0.7).toFixed(1) } : {}) },
      t, text);
    back = shift;
  };
  names.forEach((name, i) => {
    if (i) put(name[0] === "(" ? " " : joint, 0);
    for (const [text, kind] of lettered(name, plan)) put(text,
      kind === "sub" ? 0.3 * size : kind === "sup" ? -0.42 * size : 0, kind);
  });
  return t;
}
/** @type {(a: any, b: any, size: number) => boolean} */
function crowds(a, b, size) { // whether labels overlap, [x, y, half the width]
  return a[2] + b[2] + 3 > Math.abs(a[0] - b[0]) && size * 1.32 > Math.abs(a[1] - b[1]);
}

export class Labels {
  /** @param {any} node @param {number[]} [size] */
  constructor(node, size) {
    this.node = node;
    this.size = size;
    this.kept = /** @type {Map<string, number>} */ (new Map());
    this.strokes = /** @type {Ends[]} */ ([]);
    this.taken = /** @type {any[]} */ ([]);
    this.w = this.h = 0;
  }
  get letter() { return this.size ? 13 : 17; }
  /** @type {(names: string[], spots: Places, plan: string, joint?: string, as?: string, of?: Ends) => any} */
  put(names, spots, plan, joint, as, of) { // a label at the best of some places: clear of strokes and of other labels
    const size = this.letter, half = wide(names, plan, size) / 2;
    const label = /** @type {Label} */ ({ names, half, size, all: spots(half, size * 0.5), key: names.join(" "), of });
    const [x, y] = this.best(label);
    label.node = letters(this.node, names, x.toFixed(1), (y + size * 0.34).toFixed(1), size, plan, joint, as);
    this.taken.push([x, y, half, label]);
    return label.node;
  }
  /** @type {(label: Label) => number[]} */
  best(label) { // its last place, unless another is clearly better: a label should not jump
    const { all, key } = label, kept = this.kept.get(key);
    let best = /** @type {number[]} */ (/** @type {any} */ (null));
    for (let k = -1; k < all.length; k++) {
      const n = k < 0 ? kept : k;
      if (n === undefined || n >= all.length || (k >= 0 && n === kept)) continue;
      const own = all[n][2] - (k < 0 ? 0.6 : 0);
      if (best && own >= best[0]) continue;
      const cost = this.price(label, all[n], own, best ? best[0] : Infinity);
      if (!best || cost < best[0]) best = [cost, n];
      if (k < 0 && cost <= 0) break;
    }
    this.kept.set(key, best[1]);
    return all[best[1]];
  }
  // the cost of a place: strokes, other labels, the edge of the figure; up to a limit
  /** @type {(label: Label, place: number[], own: number, most: number) => number} */
  price({ half, size, of }, [x, y], own, most) {
    const tall = size * 0.5, parts = Math.max(2, Math.ceil(1.6 * half / size)); // nothing crosses it between two places
    let cost = own;
    const far = of ? gap([x, y], of) - 1 : 0;
    if (of && this.strokes.some(s => gap([x, y], s) < far)) cost += STRANGE;
    for (const t of this.taken) if (crowds([x, y, half], t, size)) cost += UPON;
    for (const s of this.strokes) {
      if (cost >= most) return cost;
      for (let k = 0; k <= parts; k++) {
        const d = gap([x + (1.6 * k / parts - 0.8) * half, y], s);
        if (d < tall + 3) cost += (tall + 3 - d) / tall;
      }
    }
    const over = Math.max(half - x, x + half - this.w, tall - y, y + tall - this.h); // a clipped label is unreadable
    return over > 0 ? cost + 2 * UPON : over > -2 ? cost + 6 : cost;
  }
  settle() { // overlapping labels are placed again, now that all are known
    for (let round = 0; round < ROUNDS; round++) {
      const crowded = this.taken.filter(t => t[3] && this.taken.some(o => o !== t && crowds(t, o, t[3].size)));
      for (const t of crowded) {
        this.taken.splice(this.taken.indexOf(t), 1);
        const { node, size, half } = t[3], [x, y] = this.best(t[3]);
        alter(node, { x: x.toFixed(1), y: (y + size * 0.34).toFixed(1) });
        this.taken.push([x, y, half, t[3]]);
      }
      if (!crowded.length) return;
    }
  }
  /** @type {(p: Spot, half: number, tall: number) => number[][]} */
  around([x, y], half, tall) { // places of a label about a point
    return [0, 7, 15, 26, 40, 58, 90].flatMap(far => [...Array(16).keys()].map(k => {
      const c = Math.cos(k * Math.PI / 8), s = Math.sin(k * Math.PI / 8);
      return [x + c * (half + far), y + s * (tall + far), far * 0.06 + (k % 4 ? 0.05 : 0)];
    }));
  }
  /** @type {(p: Spot, names: string[], plan: string, clear?: number, as?: string) => any} */
  beside(p, names, plan, clear = 5, as = names.join(" ")) { // around a mark
    return this.put(names, (half, tall) => this.around(p, half + clear, tall + clear), plan, undefined, as);
  }
  /** @type {(a: Spot, b: Spot, names: string[], plan: string, ends?: string) => any} */
  along(a, b, names, plan, ends) { // beside a vector; after its names, its ends
    const n = distance(a, b) || 1, ux = (b[0] - a[0]) / n, uy = (b[1] - a[1]) / n;
    return this.put(ends ? [...names, ends] : names, (half, tall) => {
      const places = [], off = Math.abs(uy) * half + Math.abs(ux) * tall + 5;
      for (const t of [0.5, 0.35, 0.65, 0.2, 0.8, 0.95, 0.08]) for (const side of [1, -1]) for (const far of [0, 10, 22,
        36, 54, 74, 96, 130, 170]) {
        places.push([a[0] + t * n * ux - side * uy * (off + far), a[1] + t * n * uy + side * ux * (off + far),
          far * 0.05 + Math.abs(t - 0.5)]);
      }
      const short = n < 2 * half + 10; // it has more room about it than beside it
      return short ? [...places, ...this.around([(a[0] + b[0]) / 2, (a[1] + b[1]) / 2], half + 5, tall + 5)] : places;
    }, plan, " = ", names.join(" "), [a, b]);
  }
}
