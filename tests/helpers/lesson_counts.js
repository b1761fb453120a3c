// What is counted of a lesson's page from within it: labels upon one another, plan vectors dragged, frames a second.
(globalThis.counts = {
  state(numbers) { // the marks with other numbers given
    live.reset();
    live.set(numbers);
    const marks = Object.fromEntries(Object.keys(data.marks).map(m => [m, live.at(m)]));
    return { given: { ...live.given }, failed: Boolean(live.failed), marks };
  },
  ink(e) { // the box of the letters, without what a font keeps free above and below
    const r = e.getBBox(), y = +e.getAttribute("y"), size = +e.getAttribute("font-size");
    const small = [...e.children].map(c => +c.getAttribute("font-size") && +c.getAttribute("dy"));
    const over = small.some(d => d < 0) ? 0.95 : 0.74, under = small.some(d => d > 0) ? 0.34 : 0.04;
    return [r.x, y - size * over, r.x + r.width, y + size * under];
  },
  overlaps() { // over all frames, at home
    const told = [];
    live.reset();
    for (let k = 0; k < data.frames.length; k++) {
      go(k);
      for (const id of ["scheme", "plan"]) {
        if (id === "plan" && planOf(k) === "position") continue;
        const all = [...document.querySelectorAll(`#${id} .label`)].map(e => [e.textContent, this.ink(e)]);
        all.forEach(([n, a], i) => all.slice(i + 1).forEach(([m, b]) => {
          const x = Math.min(a[2], b[2]) - Math.max(a[0], b[0]), y = Math.min(a[3], b[3]) - Math.max(a[1], b[1]);
          if (x > 1 && y > 1) told.push(`${k + 1} ${id}: ${n} upon ${m}`);
        }));
      }
    }
    return told;
  },
  dragged(seed) { // the end of every plan vector to a place 6 to 12 mm off: reached, said why not, or neither
    const told = { reached: 0, said: 0, silent: [] };
    let s = seed;
    const chance = () => (s = (s * 16807) % 2147483647) / 2147483647;
    for (const key of data.plans.map(p => p.key).filter(k => k !== "position")) {
      go(data.frames.map(f => f.plan).lastIndexOf(key));
      for (const m of plan.own(key)) {
        live.reset();
        if (m.endsWith(":p") || !live.at(m)) continue;
        const p = live.at(m), d = 6 + 6 * chance(), a = 6.283 * chance(), goal = [p[0] + d * Math.cos(a), p[1] + d * Math.sin(a)];
        const short = drag(plan, m, goal), q = live.at(m), text = document.getElementById("follow").textContent;
        if (q && Math.hypot(q[0] - goal[0], q[1] - goal[1]) <= 0.01) told.reached++;
        else if (short > 0.01 && text) told.said++;
        else told.silent.push(m);
      }
    }
    live.reset();
    go(0);
    return told;
  },
  spun(frame) { // frames a second while the crank goes round
    go(frame);
    let n = 0, first = 0;
    spin(true);
    return new Promise(done => {
      const next = t => {
        first ||= t;
        n++;
        if (t - first < 1500) return requestAnimationFrame(next);
        spin(false);
        live.reset();
        done(1000 * (n - 1) / (t - first));
      };
      requestAnimationFrame(next);
    });
  },
}, 0)
