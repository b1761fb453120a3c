"use strict";
// Words of the page: sentences with their numbers, names with their indices, the equations of a plan.

const [words, data] = JSON.parse(inflated(JSON.parse(document.getElementById("packed").textContent)));
function seenAt(frame) {
  const seen = new Set(["position:p"]);
  for (const f of data.frames.slice(0, frame + 1)) for (const m of f.makes) seen.add(m);
  return seen;
}
function planOf(frame) { // the plan on the right: of this frame, or the last one that was begun
  for (let k = frame; k >= 0; k--) if (data.frames[k].plan !== "position" && begunAt(data.frames[k].plan) <= frame) return data.frames[k].plan;
  return "position";
}
function begunAt(plan) { // the frame that makes its first mark
  begunAt.of ||= {};
  return begunAt.of[plan] ??= data.frames.findIndex(f => f.plan === plan && f.makes.length);
}
function clamp(v, a, b) { return Math.min(b, Math.max(a, Number.isFinite(v) ? v : a)); }
function say(key) { return words[key][state.lang]; }
function local(text) { return state.lang !== "en" ? text.replace(".", ",") : text; }
function fixed(x, digits) { // as the engine rounds: a tie goes to the even digit
  const all = x.toFixed(Math.min(digits + 30, 100)), cut = all.indexOf(".") + 1 + digits;
  if (!/^50*$/.test(all.slice(cut))) return x.toFixed(digits);
  const low = all.slice(0, cut).replace(/\.$/, "");
  return /[02468]$/.test(low) ? low : x.toFixed(digits);
}
function number(v) { // four digits, as the engine prints them
  if (v === null || v === undefined) return "—";
  if (v === 0) return "0";
  const [mantissa, exponent] = v.toExponential(3).split("e"), power = +exponent;
  const short = t => t.includes(".") ? t.replace(/0+$/, "").replace(/\.$/, "") : t;
  const raised = () => short(mantissa) + "·10" + String(power).replace(/./g, c => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(c)]);
  return local((power > -5 && power < 7 ? short(fixed(v, Math.max(3 - power, 0))) : raised()).replace("-", "−"));
}
function scaled(mu, inverse) { // a scale as the engine writes it: exact, its inverse with three digits if need be
  if (!inverse) return local(String(+mu.toPrecision(12)));
  const four = +(1 / mu).toPrecision(4);
  return local(String(Math.abs(four * mu - 1) < 1e-12 ? four : +(1 / mu).toPrecision(3)));
}
function product(name, sign) { // of a slot: a value, or values by *, after a minus of their own; null where one fails
  const values = name.replace(/^−/, "").split("*").map(n => live.value(n));
  const signs = sign ? values.map(v => v !== null && Math.abs(v) < 1e-12 ? 1 : v && Math.sign(v)) : values;
  return values.includes(null) ? null : signs.reduce((z, v) => z * v, name[0] === "−" ? -1 : 1);
}
function filled(text) { // the numbers of a sentence, for what is shown
  return text.replace(/⟦(\w+)¦([^¦⟧]+)(?:¦([^⟧]+))?⟧/g, (_, how, name, mu) => {
    if (how === "n") return local(name); // a number that is its own name
    if (how === "d") return number(Math.asin(live.zone ? live.zone.least : live.sharpness(name)) * 180 / Math.PI);
    const found = product(name, how === "join" || how === "lead"), v = Math.abs(found) < 1e-12 ? 0 : found; // noise is nothing
    if (found === null) return "—";
    if (how === "mm") return local(fixed(Math.abs(v * live.given[mu]), 1).replace(/\.0$/, ""));
    if (how === "s") return say(v > 0 ? "ccw" : v < 0 ? "cw" : "still");
    if (how === "k" || how === "i") return scaled(v, how === "i").replace("-", "−");
    if (how === "join" || how === "lead") return how === "join" ? (v < 0 ? " − " : " + ") : v < 0 ? "−" : "";
    const shown = number(how === "a" ? Math.abs(v) : v);
    return how === "b" && shown.startsWith("−") ? `(${shown})` : shown;
  });
}
function sentence(text, key) {
  return filled(text).replace(/⟨([^⟩]*)⟩/g, (_, n) => `<i class="name" data-name="${n}">${html(n, key)}</i>`);
}
function spoken(name, key) { return lettered(name, key).map(([t]) => t).join(""); }
function plain(text, key) { return filled(text).replace(/⟨([^⟩]*)⟩/g, (_, n) => spoken(n, key)); }
function described(figure, seen, key) { // what is on a figure, for those who hear it
  const list = figure instanceof Scheme
    ? [...new Set(data.scheme.links.flatMap(l => l.points))].filter(n => seen.has(n) && live.at(n)).map(n => n.slice(9))
    : data.segments.filter(s => s.plan === key && seen.has(`${key}:${s.start}`) && seen.has(`${key}:${s.end}`)).flatMap(s => s.names);
  const title = figure instanceof Scheme ? say("scheme") : data.plans.find(p => p.key === key)?.title[state.lang] ?? "";
  const names = [...new Set(list)].map(n => spoken(n, figure instanceof Scheme ? "position" : key)).join(", ");
  return `${title}. ${names ? say(figure instanceof Scheme ? "hear_points" : "hear_vectors").replace("{names}", names) : say("hear_nothing")}`;
}
function found(name) { // the frame in which a value is first told
  found.at ||= {};
  return found.at[name] ??= data.frames.findIndex(f => f.tells.includes(name));
}
function born(name, key) { // the frame of its plan in which a vector is first in hand
  if (!born.of) {
    born.of = {};
    data.frames.forEach((f, k) => { if (f.moments === null && k >= begunAt(f.plan)) for (const t of f.terms) born.of[f.plan + " " + t] ??= k; });
    for (const s of data.segments) { // what no frame speaks of is there with its end
      const k = data.frames.findIndex(f => f.makes.includes(`${s.plan}:${s.end}`));
      for (const n of s.names) born.of[s.plan + " " + n] ??= k;
    }
  }
  return born.of[key + " " + name] ?? -1;
}
function written(f, key, frame, plainly) { // the equations of a plan: those begun, the one in hand framed
  const stated = k => data.frames.findIndex(g => g.key === "equation" && g.equation === k);
  const begun = (e, k) => key.startsWith("force") ? stated(k) <= frame : terms(e).some(t => t.action !== "=0" && born(t.name, key) <= frame);
  const own = e => f.terms.length && terms(e).some(t => f.terms.includes(t.name));
  const index = f.equation !== null ? f.equation : data.equations.findIndex(e => e.plan === key && own(e));
  return data.equations.map((e, k) => e.plan === key && key !== "position" && (begun(e, k) || k === f.equation) ? lines(e, !plainly && k === index, f, frame, plainly) : "").join("");
}
function terms(e) { return e.sides.flat(); }
function lines(e, current, f, frame, plainly) {
  const one = t => term(t, e.plan, f, frame, plainly);
  const side = list => list.map((t, k) => (t.minus ? '<span class="sign">−</span>' : k ? '<span class="sign">+</span>' : "") + one(t)).join("");
  const first = e.total ? one(e.total) : "";
  const rows = e.sides.filter(s => s.length).map((s, k) => `<div class="side">${k ? '<span class="sign">=</span>' : first ? first + '<span class="sign">=</span>' : ""}${side(s)}</div>`);
  const body = e.closed ? `<div class="side">${side(e.sides.flat())}<span class="sign">= 0</span></div>` : rows.join("");
  return `<div class="equation${current ? " current" : ""}">${body}</div>`;
}
function term(t, key, f, frame, plainly) { // a vector: its own small segment, its letters, underlines, line of action
  const lit = !plainly && f.terms.includes(t.name), later = born(t.name, key) > frame - (plainly ? 1 : 0);
  const secret = plainly && later; // what the reader is to find
  const action = secret ? "" : t.action === "=0" ? "= 0" : t.action === "↓" ? "↓" : acted(t.action);
  const known = secret || (plainly && practice.asking(t.name)) ? practice.given(t.name) : t.known;
  return `<span class="term known${known}${lit ? " lit" : ""}${later ? " later" : ""}" data-name="${t.name}">` +
    `${secret ? '<svg class="mini"></svg>' : mini(t, later)}<b>${html(t.name, key)}</b><span class="sr"> (${say("known" + known)})</span><small>${action}</small></span>`;
}
function acted(text) { return text.replace(/^([-+])([va]q?_\w+)$/, (_, s, v) => `${s === "-" ? "↑↓" : "↑↑"} ${html(v)}`); }
function mini(t, later) { // the segment itself, as small as a word: an arrow, or only its line while its length is sought
  const s = t.start ? t : data.segments.find(s => s.names.includes(t.name)) || {};
  const full = n => n && (n.includes(":") ? n : `${s.plan}:${n}`), a = live.at(full(s.start)), b = live.at(full(s.end));
  const n = a && b ? Math.hypot(b[0] - a[0], b[1] - a[1]) : 0;
  if (n < 1e-6) return '<svg class="mini"></svg>';
  const ux = (b[0] - a[0]) / n, uy = (a[1] - b[1]) / n, h = Math.min(19 / Math.max(Math.abs(ux), 1e-6), 8 / Math.max(Math.abs(uy), 1e-6), 19);
  const x = 22 + ux * h, y = 10 + uy * h, f = v => v.toFixed(1), line = `<line x1="${f(22 - ux * h)}" y1="${f(10 - uy * h)}" x2="${f(x)}" y2="${f(y)}"`;
  if (later && t.known < 2) return `<svg class="mini" viewBox="0 0 44 20">${t.known ? line + ' class="ray"/>' : ""}</svg>`;
  return `<svg class="mini" viewBox="0 0 44 20">${line}/><polygon points="${f(x)},${f(y)} ${f(x - 6 * ux - 2.2 * uy)},${f(y - 6 * uy + 2.2 * ux)} ${f(x - 6 * ux + 2.2 * uy)},${f(y - 6 * uy - 2.2 * ux)}"/></svg>`;
}
