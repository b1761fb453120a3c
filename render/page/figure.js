"use strict";
// Draws the scheme and the plans as lines between exported marks. Nothing is reckoned here but where ink goes.
const NS = "http://www.w3.org/2000/svg";
const GREEK = { omega: "ω", epsilon: "ε", phi: "φ" };

function lettered(name) { // "v_CB" -> [["v", ""], ["CB", "sub"]], "a_CB^t" -> … ["t", "sup"]
  let primes = (name.match(/['′]+$/) || [""])[0].length;
  name = name.replace(/['′]+$/, "").replace(/_given$/, "").replace(/[|‖°]/g, "");
  const [body, part] = name.split("^");
  let [letter, ...rest] = body.split("_");
  let index = rest.join(",");
  if (!index) { const m = body.match(/^([^\d]+)(\d+)$/); if (m) [letter, index] = [m[1], m[2]]; }
  if (letter === "I" && index) letter = "Φ";
  if (letter === "MI") [letter, index] = ["M", "Φ" + index];
  const out = [[GREEK[letter] || letter, ""]];
  if (index) out.push([index, "sub"]);
  if (part) out.push([part, "sup"]);
  if (primes) out.push(["′".repeat(primes), ""]);
  return out;
}
function html(name) {
  return lettered(name).map(([t, k]) => k ? `<${k}>${t}</${k}>` : t).join("");
}
function svg(tag, attributes, parent) {
  const e = document.createElementNS(NS, tag);
  for (const k in attributes) e.setAttribute(k, attributes[k]);
  if (parent) parent.appendChild(e);
  return e;
}
function labelText(parent, names, x, y, size, cls) {
  const t = svg("text", { x, y, "font-size": size, class: cls || "label", "text-anchor": "middle" }, parent);
  names.forEach((name, i) => {
    if (i) svg("tspan", {}, t).textContent = ", ";
    let back = 0;
    for (const [text, kind] of lettered(name)) {
      const shift = kind === "sub" ? 0.3 : kind === "sup" ? -0.4 : 0;
      const a = { dy: (shift * size - back).toFixed(2) };
      if (kind) a["font-size"] = size * 0.7;
      svg("tspan", a, t).textContent = text;
      back = shift * size;
    }
    if (back) svg("tspan", { dy: (-back).toFixed(2) }, t).textContent = "\u200b";
  });
  return t;
}

class Figure { // one panel: a flipped plane in mm, redrawn from marks
  constructor(node, data) { this.node = node; this.data = data; }
  at(name, i) {
    const m = this.data.marks[name];
    return m && m[0][i] !== null && m[1][i] !== null ? [m[0][i], -m[1][i]] : null;
  }
  box(names, indices) {
    let b = [0, 0, 0, 0], any = false;
    for (const i of indices) for (const n of names) {
      const p = this.at(n, i);
      if (!p) continue;
      b = any ? [Math.min(b[0], p[0]), Math.min(b[1], p[1]), Math.max(b[2], p[0]), Math.max(b[3], p[1])] : [...p, ...p];
      any = true;
    }
    const m = Math.max(b[2] - b[0], b[3] - b[1], 10) * 0.14;
    return [b[0] - m, b[1] - m, b[2] - b[0] + 2 * m, b[3] - b[1] + 2 * m];
  }
  start(box) {
    this.node.textContent = "";
    this.unit = Math.max(box[2], box[3] * 1.25) / 100;
    this.node.setAttribute("viewBox", box.map(v => v.toFixed(2)).join(" "));
    this.view = box;
  }
  line(a, b, cls, name) {
    const l = svg("line", { x1: a[0], y1: a[1], x2: b[0], y2: b[1], class: cls }, this.node);
    if (name) l.dataset.name = name;
    return l;
  }
  arrow(a, b, cls, name) {
    const dx = b[0] - a[0], dy = b[1] - a[1], n = Math.hypot(dx, dy);
    if (n < this.unit * 0.6) return;
    const h = Math.min(this.unit * 3.4, n * 0.5), w = h * 0.3, ux = dx / n, uy = dy / n;
    const g = svg("g", { class: cls }, this.node);
    if (name) { g.dataset.name = name; g.setAttribute("tabindex", "-1"); }
    const c = [b[0] - ux * h, b[1] - uy * h];
    svg("line", { x1: a[0], y1: a[1], x2: c[0], y2: c[1] }, g);
    svg("polygon", { points: `${b[0]},${b[1]} ${c[0] - uy * w},${c[1] + ux * w} ${c[0] + uy * w},${c[1] - ux * w}` }, g);
    return g;
  }
  labels(marks, i, lines) { // coincident marks share a label; each stands away from the lines that meet there
    const groups = [];
    for (const full of marks) {
      const p = this.at(full, i), name = full.slice(full.lastIndexOf(":") + 1);
      if (!p || /[°⊥]/.test(name)) continue;
      const g = groups.find(g => Math.hypot(g.p[0] - p[0], g.p[1] - p[1]) < this.unit * 0.8);
      if (g) g.names.push(name); else groups.push({ p, names: [name] });
    }
    const taken = [];
    for (const g of groups) {
      let best = null;
      for (let k = 0; k < 16; k++) for (const far of [3.2, 4.6, 6.4]) {
        const c = Math.cos(k * Math.PI / 8), s = Math.sin(k * Math.PI / 8), wide = 1 + 0.45 * (g.names.join(",").length - 1);
        const q = [g.p[0] + c * this.unit * far * (1 + 0.25 * (wide - 1) * Math.abs(c)), g.p[1] + s * this.unit * far];
        let cost = far * 0.05 + (Math.abs(s) < 0.4 ? 0 : 0.02);
        for (const l of lines) cost += near(q, l, this.unit * 2.4);
        for (const t of taken) cost += Math.max(0, 1 - Math.hypot(q[0] - t[0], q[1] - t[1]) / (this.unit * 4.4)) * 2;
        if (!best || cost < best.cost) best = { cost, q };
      }
      taken.push(best.q);
      labelText(this.node, g.names, best.q[0], best.q[1] + this.unit * 1.2, this.unit * 3.6);
    }
  }
}
function near(p, [a, b], reach) { // 1 on the segment, 0 farther than reach
  const dx = b[0] - a[0], dy = b[1] - a[1], n = dx * dx + dy * dy;
  const t = n ? Math.max(0, Math.min(1, ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / n)) : 0;
  return Math.max(0, 1 - Math.hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy) / reach);
}

class Scheme extends Figure {
  constructor(node, data) {
    super(node, data);
    const names = Object.keys(data.marks).filter(n => n.startsWith("position:") && n !== "position:p");
    this.names = names;
    const indices = data.drive.values.map((_, i) => i).filter(i => i % 6 === 0 || i === data.drive.at);
    this.full = this.box(names.filter(n => !/[⊥]/.test(n)), indices);
  }
  draw(i, seen, lit) {
    const { scheme, turned } = this.data, lines = [];
    this.start(this.full);
    const u = this.unit, there = n => seen.has(n) && this.at(n, i);
    for (const g of scheme.guides) {
      const p = there(g.mark), angle = (turned[g.name] || [])[i];
      if (!p || angle == null) continue;
      const far = Math.hypot(this.full[2], this.full[3]) * (g.link === "0" ? 1 : 0.45);
      const c = Math.cos(angle * Math.PI / 180), s = -Math.sin(angle * Math.PI / 180);
      this.line([p[0] - c * far, p[1] - s * far], [p[0] + c * far, p[1] + s * far], g.link === "0" ? "axis" : "rail", g.name);
    }
    for (const l of scheme.links) {
      const pts = l.points.map(n => there(n)).filter(Boolean);
      const cls = "link" + (l.name === scheme.driver ? " driver" : "");
      if (pts.length > 2) svg("polygon", { points: hull(pts).map(p => p.join(",")).join(" "), class: cls }, this.node);
      else if (pts.length === 2) this.line(pts[0], pts[1], cls, l.name);
      if (pts.length > 1) lines.push(...hull(pts).map((p, k, a) => [p, a[(k + 1) % a.length]]));
    }
    for (const l of scheme.links) if (l.slides) {
      const p = there(l.points[0]), angle = (turned[l.slides] || [])[i];
      if (p && angle != null) svg("rect", {
        x: -u * 4, y: -u * 2.3, width: u * 8, height: u * 4.6, class: "block",
        transform: `translate(${p[0]} ${p[1]}) rotate(${-angle})`,
      }, this.node);
    }
    for (const n of scheme.pivots) { const p = there(n); if (p) this.ground(p); }
    const joints = new Set();
    for (const l of scheme.links) for (const n of l.points) joints.add(n);
    for (const n of joints) {
      const p = there(n);
      if (p) svg("circle", { cx: p[0], cy: p[1], r: u * 1.1, class: "hinge" + (lit.has(n) ? " lit" : "") }, this.node);
    }
    this.labels([...joints, ...scheme.pivots].filter((n, k, a) => seen.has(n) && a.indexOf(n) === k), i, lines);
  }
  ground(p) {
    const u = this.unit, [x, y] = p;
    svg("path", { class: "ground", d: `M${x} ${y}l${-u * 2.6} ${u * 4.4}h${u * 5.2}z` }, this.node);
    for (let k = -3; k < 4; k++) this.line([x + k * u * 1.1 + u, y + u * 4.4], [x + k * u * 1.1, y + u * 5.8], "hatch");
  }
}
function hull(points) { // the outline of a link of three points or more
  const p = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  if (p.length < 3) return p;
  const turn = (o, a, b) => (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
  const half = list => {
    const h = [];
    for (const q of list) { while (h.length > 1 && turn(h[h.length - 2], h[h.length - 1], q) <= 0) h.pop(); h.push(q); }
    return h.slice(0, -1);
  };
  return [...half(p), ...half(p.reverse())];
}

class Plan extends Figure {
  show(key, i, seen, lit, made, fixed) {
    const { segments, traces, drive } = this.data;
    const marks = Object.keys(this.data.marks).filter(n => n.slice(0, n.lastIndexOf(":")) === key);
    const now = this.box(marks, [i]), own = this.box(marks, [drive.at]);
    const big = now[2] > own[2] * 1.02 || now[3] > own[3] * 1.02 || now[0] < own[0] || now[1] < own[1];
    this.start(fixed || (!big && i === drive.at) ? own : union(own, clipped(now, own)));
    const lines = [], u = this.unit;
    for (const m of made) this.trace(traces[m], m, i);
    for (const s of segments) {
      const a = `${s.plan}:${s.start}`, b = `${s.plan}:${s.end}`;
      if (s.plan !== key || !seen.has(a) || !seen.has(b)) continue;
      const p = this.at(a, i), q = this.at(b, i);
      if (!p || !q) continue;
      const absolute = s.start === "p" && !key.startsWith("force");
      this.arrow(p, q, (absolute ? "result" : "part") + (lit.has(s.name) ? " lit" : ""), s.name);
      lines.push([p, q]);
      if (key.startsWith("force")) this.beside(p, q, s.name, lines);
    }
    const pole = this.at(`${key}:p`, i);
    if (pole && seen.has(`${key}:p`)) svg("circle", { cx: pole[0], cy: pole[1], r: u * 0.7, class: "pole" }, this.node);
    const shown = marks.filter(n => seen.has(n) && !/[+-]$/.test(n));
    this.labels(key.startsWith("force") ? shown.filter(n => n.endsWith(":p")) : shown, i, lines);
  }
  beside(p, q, name) {
    const n = Math.hypot(q[0] - p[0], q[1] - p[1]);
    if (n < this.unit * 3) return;
    const x = (p[0] + q[0]) / 2 - (q[1] - p[1]) / n * this.unit * 2.8, y = (p[1] + q[1]) / 2 + (q[0] - p[0]) / n * this.unit * 2.8;
    labelText(this.node, [name], x, y + this.unit, this.unit * 2.9, "label small");
  }
  trace(t, made, i) { // the lines or arcs that cross at a mark, drawn a little past it
    const c = this.at(made, i);
    if (!t || !c) return;
    for (const n of t.lines || []) {
      const p = this.at(n, i);
      if (!p) continue;
      const dx = c[0] - p[0], dy = c[1] - p[1], d = Math.hypot(dx, dy);
      if (d < 1e-6) continue;
      const far = 6 * this.unit / d;
      this.line([p[0] - dx * far, p[1] - dy * far], [c[0] + dx * far, c[1] + dy * far], "trace");
    }
    for (const n of t.arcs || []) {
      const p = this.at(n, i);
      if (p) svg("circle", { cx: p[0], cy: p[1], r: Math.hypot(c[0] - p[0], c[1] - p[1]), class: "trace" }, this.node);
    }
  }
}
function union(a, b) {
  const x = Math.min(a[0], b[0]), y = Math.min(a[1], b[1]);
  return [x, y, Math.max(a[0] + a[2], b[0] + b[2]) - x, Math.max(a[1] + a[3], b[1] + b[3]) - y];
}
function clipped(b, own) { // near a dead point a plan runs off any paper: show three times the usual
  const m = 3 * Math.max(own[2], own[3]);
  return union([0, 0, 0, 0], [Math.max(b[0], -m), Math.max(b[1], -m), Math.min(b[2], 2 * m), Math.min(b[3], 2 * m)]);
}
