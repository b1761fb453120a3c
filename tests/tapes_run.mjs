// The marks of a page at other numbers against those of the engine: read by tests/tapes_run.py.
import { readFileSync } from "node:fs";

const { held, drawn } = JSON.parse(readFileSync(process.argv[2], "utf8"));
globalThis.document = { getElementById: id => ({ textContent: held[id] }), documentElement: { lang: "en" } };
const { data, live } = await import("./page.js");
const seen = { sets: drawn.length, places: 0, refused: 0, unlike: 0, worst: 0, where: "" };
for (const { given, marks, failed } of drawn) {
  live.back(data.home);
  live.set(given);
  if (Boolean(live.failed) !== failed) seen.unlike++;
  else if (failed) seen.refused++;
  else {
    const size = Math.max(1, ...Object.values(marks).map(([x, y]) => Math.hypot(x, y)));
    for (const [name, [x, y]] of Object.entries(marks)) {
      const place = live.at(name), off = place ? Math.hypot(place[0] - x, place[1] - y) / size : Infinity;
      seen.places++;
      if (!(off <= seen.worst)) Object.assign(seen, { worst: off, where: name });
    }
  }
}
console.log(JSON.stringify(seen));
