// Modules of the pages by themselves, in node: the folder has them, and told.json what Python reckons.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";
import { pathToFileURL } from "node:url";

const room = process.env.PAGE_MODULES, told = JSON.parse(readFileSync(`${room}/told.json`, "utf8"));
const held = id => ({ textContent: told.held[id] });
globalThis.document = { getElementById: held, documentElement: { lang: "en" } }; // all they ask of a document
const of = name => import(pathToFileURL(`${room}/${name}.js`).href);
const { Tape, Miss, givenBefore } = await of("tape");
const { data, live, state } = await of("page");
const words = await of("words"), rows = await of("rows");
const near = (a, b, far, of_) => assert.ok(Math.abs(a - b) <= far, `${of_}: ${a}, not ${b}`);

test("marks of a lesson at changed numbers are where the engine draws them", () => {
  for (const { given, marks, failed } of told.drawn) {
    live.back(data.home);
    live.set(given);
    assert.equal(Boolean(live.failed), failed);
    if (failed) continue;
    for (const [name, [x, y]] of Object.entries(marks)) {
      const found = live.at(name), far = 1e-6 * Math.max(1, Math.hypot(x, y) / 1000);
      near(found[0], x, far, name);
      near(found[1], y, far, name);
    }
  }
});

test("sentences have the numbers and names that Python tells", () => {
  for (const { given, lang, said } of told.said) {
    live.back(data.home);
    live.set(given);
    state.lang = lang;
    assert.deepEqual(data.frames.map(f => words.filled(rows.inWords(f))), said);
  }
  assert.match(words.sentence("⟨v_CB⟩ <", "velocity"), /^<i class="name" data-name="v_CB">v<sub>CB<\/sub><\/i> <$/);
});

test("numbers are written as Python writes them", () => {
  for (const lang of ["ru", "en"]) {
    state.lang = lang;
    assert.deepEqual(told.numbers.map(v => words.number(v)), told.written[lang]);
  }
});

test("slopes of a tape are those of its numbers", () => {
  live.back(data.home);
  for (const mark of ["position:C", "velocity:c", "acceleration:c'"]) for (const place of data.marks[mark]) {
    const slopes = live.tape.slopes(place), at = live.tape.givens;
    for (const name of ["l_BC", data.drive.given]) {
      const step = 1e-6 * Math.max(1, Math.abs(data.home[name])), value = by => {
        live.tape.run({ ...data.home, [name]: data.home[name] + by });
        return live.tape.values[place];
      };
      const found = slopes[at[name]], seen = (value(step) - value(-step)) / (2 * step);
      near(found, seen, 1e-5 * Math.max(1, Math.abs(found)), `${mark} by ${name}`);
      live.tape.run(data.home);
    }
  }
});

test("a hand moves a mark by the numbers it has, and no others", () => {
  live.back(data.home);
  const [x, y] = live.at("velocity:c"), names = live.handles("velocity:c", ""), before = { ...live.given };
  assert.ok(live.follow("velocity:c", names, [x + 3, y - 2]) <= 0.01);
  assert.deepEqual(Object.keys(before).filter(n => before[n] !== live.given[n]).sort(), [...names].sort());
});

test("a tape reads its letters, and a miss what is known before it", () => {
  const names = { given: 0, mul: 2, sqrt: 1 }; // x; x · x; its root
  const tape = new Tape({ names, ops: "A" + "BBB" + "CB", consts: {}, givens: { x: 0 }, sources: [] });
  tape.run({ x: -3 });
  assert.deepEqual([...tape.values], [-3, 9, 3]);
  assert.deepEqual([...tape.slopes(2)], [-1, 1 / 6, 1]);
  const miss = new Miss(3, 4, 1, 0, 1, [[1], [0]]);
  near(miss.sigmas, 5, 1e-12, "sigmas");
  near(miss.reach(2), 2, 1e-12, "reach");
  const after = givenBefore(new Map([["a", new Miss(1, 0, 1, 0, 1, [[1], [0]])], ["b", new Miss(1, 0, 1, 0, 1, [[1], [0]])]]),
    ["a", "b"], 3, 0.1);
  assert.ok(Math.abs(after.get("b").x) < 0.02, "the same error is not counted twice");
});

test("a number is read as people type it, in SI", async () => {
  const { typed } = await of("typed");
  const right = { "0,31": 0.31, "310 mm": 0.31, "12 in": 0.3048, "120 rpm": 4 * Math.PI, "90 °/s": Math.PI / 2, "0.3 + 0.01": 0.31,
    "2*(0.1+0.05)": 0.3, "-1/4": -0.25, "1e-3 m": 0.001, "60 об/мин": 2 * Math.PI, ".5": 0.5 };
  for (const [text, value] of Object.entries(right)) near(typed(text), value, 1e-12, text);
  for (const text of ["", "abc", "3 parsec", "1+", "(2", "alert(1)", "1..2", "2 2", "*3"]) assert.ok(Number.isNaN(typed(text)), text);
});

test("a link holds a scene, and gives it back to the last letter", async () => {
  const { pressed, unpressed } = await of("share");
  for (const text of [told.held.brought.slice(0, 3000), "planes: 1\n# Пример ё\n", ""]) {
    const link = await pressed(text);
    assert.match(link, /^[\w-]*$/);
    assert.equal(await unpressed(link), text);
  }
});
