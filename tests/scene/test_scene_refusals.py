"""Floor 2: every bad scene gets one sentence with its line, and any text is answered in time."""

import random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from planes.scene import Scene, loads
from planes.words.errors import SceneError
from tests.helpers.counting import at_most
from tests.helpers.scene_texts import SIX_LINK, VECTORS, changed

BAD = [
    ("planes: 1\n", "\n", '"planes: 1" is missing', 1),
    ("planes: 1", "planes: 2", 'format "2"', 1),
    ("planes: 1", "planes: [1]", "must be a word", 1),
    ("planes: 1", "planes:", "no value", 1),
    ("gravity:", "gravitation:", 'no key "gravitation"; valid: planes', 21),
    ("gravity:", "gravit:", "did you mean gravity?", 21),
    ("  points: {A: [0", "  point: {A: [0", "the frame has no key", 7),
    ("mass: 60", "mas: 60", "did you mean mass?", 10),
    ("mass: 60", "mass: 0,6", "decimal point: 0.6", 10),
    ("mass: 60", "mass: [6, 0]", "must be a number", 10),
    ("mass: 60", "mass: heavy", 'the name "heavy" is not defined', 10),
    ("mass: 60", "mass: .inf", "finite", 10),
    ("mass: 60", "mass: .nan", "finite", 10),
    ("mass: 60", "mass: 1e999", "too large", 10),
    ("mass: 60", "mass: 1:2", '":"', 10),
    ("mass: 60", "mass: 60 kg", "units are not written, all values are in SI", 10),
    ("inertia: 5", "inertia: -5", "cannot be negative, but is -5", 10),
    ("y-y: 0.15", "y-y: -0.15", "cannot be negative", 22),
    ("y-y: 0.15", "y-x: 0.15", "did you mean y-y?", 22),
    ("slides: y-y, ", "", 'no link slides on guide "y-y"', 22),
    ("friction: {y-y", "friction: {CL: 1, z", "no guide", 22),
    ("l_BC: 0.3", "l_BC: l_BD", 'parameter l_BC: "l_BD"', 3),
    ("l_BC: 0.3", "l_BC: phi_1*l_BC", "l_BC refers to itself", 3),
    ("l_BC: 0.3", "pi: 0.3", "cannot be named pi", 3),
    ("l_BC: 0.3", "l-BC: 0.3", "name of a parameter", 3),
    ("l_BC: 0.3", "l_BC: ", "no value", 3),
    ("l_BC: 0.3", "l_BC: {}", "must be a number, not a table", 3),
    ("l_BC: 0.3", "l_BC: 0,3", "decimal point: 0.3", 3),
    ("l_BC: 0.3", "l_BC: sqrt(-1)", "has no value", 3),
    ("l_BC: 0.3", "l_AB: 0.3", "occurs twice", 3),
    ("l_BC: 0.3", "l_BC: 9**9**9", "too large", 3),
    ("А: {phi_1", "А: {phi_2", "did you mean phi_1?", 5),
    ("А: {phi_1", "А Б: {phi_1", "name of a variant", 5),
    ("А: {phi_1: 160}", "А: 160", "must be a table", 5),
    ("А: {phi_1: 160}", "А: {phi_1: [1]}", "must be a number", 5),
    ("A: [0, 0]", "A: [0, 0, 0]", "must be [x, y], two numbers, not 3", 7),
    ("A: [0, 0]", "A: [0]", "not 1", 7),
    ("A: [0, 0]", "A: {r: 1, phi: 2}", "valid: r, angle", 7),
    ("A: [0, 0]", "A: {angle: 2}", "needs the key r", 7),
    ("A: [0, 0]", "A B: [0, 0]", "name of a point", 7),
    ("A: [0, 0]", "'A:': 0", "name of a point", 7),
    ("A: [0, 0]", "A: ", "no value", 7),
    ("D: [-0.35", "A: [-0.35", '"A" occurs twice, in line 7', 7),
    ("{x: -0.42}", "{x: 1, y: 2}", "both x and y", 8),
    ("{x: -0.42}", "{}", "one of the keys x, y, through", 8),
    ("{x: -0.42}", "{x: 1, angle: 2}", "remove angle", 8),
    ("{x: -0.42}", "{through: Z}", 'no point of the frame called "Z"', 8),
    ("{x: -0.42}", "-0.42", "must be a table", 8),
    ("{x: -0.42}", "{x: 1, mark: a b}", "name of a mark", 8),
    ("{x: -0.42}", "{x: -0,42}", "decimal point: -0.42", 8),
    ("through: C", "through: D", "no point of link 2", 12),
    ("{CL: {through: C", "{y-y: {through: C", "has the same name as a guide of the frame", 12),
    ("  1: {points", "  0: {points", "cannot be named 0", 10),
    ("  1: {points", "  a b: {points", "name of a link", 10),
    ("  1: {points: {A: 0, B: l_AB}", "  1: {points: {}", "has no points", 10),
    ("  1: {points: {A: 0, B: l_AB},", "  1: {", "link 1 needs the key points", 10),
    ("{D: 0, C: 0.15}", "[D, C]", "a table", 13),
    ("  3: {points", "  2: {points", '"2" occurs twice, in line 11 and in line 13', 13),
    ("centre: S2", "centre: S3", "mean S2?", 12),
    ("slides: CL", "slides: CM", "did you mean CL?", 14),
    ("slides: CL", "slides: {guide: CL, of: 1}", "valid: guide", 14),
    ("slides: CL", "slides: {angle: 1}", "needs the key guide", 14),
    ("slides: CL", "slides: [CL]", "a table", 14),
    ("centre: S2", "slides: CL", "link 2 slides on its own guide CL", 12),
    ("C: right", "C: rihgt", "did you mean right?", 16),
    ("C: right", "Z: right", 'no point or guide "Z"', 16),
    ("C: right", "C: {near: 3}", "near of assembly of C must be [x, y]", 16),
    ("C: right", "C: {near: [1]}", "must be [x, y]", 16),
    ("C: right", "C: {far: [1, 1]}", "valid: near", 16),
    ("C: right", "C: ", "no value", 16),
    ("{C: right}", "right", "must be a table", 16),
    ("{link: 1, phi", "{link: 6, phi", "no link", 17),
    ("{link: 1, phi", "{link: 0, phi", "the frame, which does not move; valid: 1", 17),
    ("{link: 1, phi", "{phi", "key link", 17),
    ("phi: phi_1, omega", "omega", "drive needs one of the keys phi, s", 17),
    ("phi: phi_1", "phi: 1, s: 1", "both phi and s", 17),
    ("omega: -20", "velocity: -20", "given by phi has no velocity; write omega", 17),
    ("phi: phi_1, omega: -20", "s: 0", "given by s has no epsilon; write acceleration", 17),
    ("phi: phi_1, omega: -20, epsilon: 80", "s: 0", "link 1 slides on no straight guide", 17),
    ("omega: -20", "omega: fast", '"fast" is not defined', 17),
    ("phi: phi_1", "phi: phi_2", "did you mean phi_1?", 17),
    ("drive: {link: 1, phi: phi_1, omega: -20, epsilon: 80}", "drive:", "drive is empty", 17),
    ("{link: 5, point: H", "{link: 7, point: H", 'no link "7"', 19),
    ("point: H", "point: G", "no point of link 5", 19),
    ("point: H, force", "force", "needs the key point; valid: H", 19),
    ("against: motion}   #", "}   #", "no direction; write", 19),
    ("against: motion}   #", "against: wind}   #", '"wind"; valid: motion', 19),
    ("force: 6000, ", "", "keys force, moment", 19),
    ("force: 6000", "force: 6000, moment: 3", "both force and moment", 19),
    ("force: 6000", "force: ", "no value", 19),
    ("force: 6000", "force: 6000, along: motion", "both along and against", 19),
    ("force: 6000", "forse: 6000", "mean force?", 19),
    ("against: motion}   #", "direction: {link: 9, angle: 0}}  #", 'no link "9"', 19),
    ("against: motion}   #", "direction: {link: 3}}  #", "needs the key angle", 19),
    ("against: motion}   #", "direction: down}  #", '"down" is not defined', 19),
    ("moment: 45, against: motion", "moment: 4, direction: 9", "direction", 20),
    ("moment: 45", "moment: 45, point: C", "is a moment, so it has no point", 20),
    ("  - {link: 3", "  - [link, 3", "", 20),
    ("gravity: 9.81", "gravity: -9.81", "cannot be negative", 21),
    ("gravity: 9.81", "gravity: 9,81", "point: 9.81", 21),
    ("mu: 250 mm/m", "mu: 250 mm/s", "write it in mm/m or m/mm", 24),
    ("mu: 250 mm/m", "mu: 0 mm/m", "positive", 24),
    ("mu: 250 mm/m", "mu: 250", "no unit", 24),
    ("mu: 250 mm/m", "scale: 1", "valid: mu", 24),
    ("  position:", "  positon:", "position?", 24),
    ("mu: 30 mm/(m/s)", "mu: 30 mm/m", "a scale of the position plan", 25),
    ("mu: 2 mm/(m/s²)", "mu: [2]", "must be a word", 26),
    ("find: [v_C", "find: [v C", "name of a result", 28),
    ("find: [v_C", "find: [[v_C]", "must be a word", 28),
    ("[v_C, a_H, omega_2, F_21, M_1]", "[]", "find is empty", 28),
    ("[v_C, a_H, omega_2, F_21, M_1]", "{a: 1}", "a list", 28),
    ("title: Ш", "title: [Ш", "", None),
    ("title: Шестизвенный рычажный механизм", "title: {de: a}", "valid: ru, en", 2),
    ("frame:\n", "frame:\n  number: a b\n", "name of the frame", 7),
    ("  3: {points", "\t3: {points", "tab", 13),
    ("find: [v_C", "vectors: [v_C", "do not go together", 28),
    ("find: [v_C, a_H, omega_2, F_21, M_1]", "mu: 2 mm/m", "under plans", 28),
    ("find: [v_C, a_H, omega_2, F_21, M_1]", "sheet: {studnet: I}", "did you mean student?", 28),
    ("find: [v_C, a_H, omega_2, F_21, M_1]", "sheet: {lang: de}", 'sheet has no key "lang"', 28),
    ("{A: 0, B", "{" + "A" * 41 + ": 0, B", "longer than 40", 10),
    ("C: l_BC", "C: hypot(l_BC, 1)", "needs quotes", 11),
    ("find: [v_C, a_H, omega_2, F_21, M_1]", "note: a\ntext: b", "both note", 29),
    ("A: [0, 0]", "A: &a [0, 0]", "anchor", 7),
    ("A: [0, 0]", "A: !!float 0", "tag", 7),
    ("A: [0, 0]", "A: *a", "alias", 7),
]
BAD_VECTORS = [
    ("value: 2", "value: two", '"two" is not defined', 3),
    ("value: 2", "length: 2", "valid: value, direction", 3),
    ("v_B:  {", "v B:  {", "name of a vector", 3),
    ("direction: 35", "direction: 35, perpendicular_to: 1", "both", 4),
    ("equations: ", "equation: ", "did you mean equations?", 6),
    ('["v_C = v_B + v_CB"]', "[v_C]", "is not an equation", 6),
    ('["v_C = v_B + v_CB"]', "[]", "equations is empty", 6),
    ("mu: 30 mm/(m/s)", "mu: 30", "no unit", 7),
    ("mu: 30 mm/(m/s)", "frame: {}", "vectors and frame do not go together", 7),
    ("mu: 30 mm/(m/s)", "drive: {}", "drive needs one of the keys phi, s", 7),
    ('equations: ["v_C = v_B + v_CB"]\n', "", "missing", 1),
    ("  v_C:  {direction: 80}\n", "  v_C: 3\n", "must be a table", 5),
    ("vectors:\n", "vectors: {}\nmu: {\n", "", None),
]


@pytest.mark.parametrize(("old", "new", "piece", "line"), BAD)
def test_a_bad_scene_gets_one_sentence(old, new, piece, line):
    check_refusal(changed(old, new), piece, line)


@pytest.mark.parametrize(("old", "new", "piece", "line"), BAD_VECTORS)
def test_a_bad_scene_of_vectors_gets_one_sentence(old, new, piece, line):
    check_refusal(changed(old, new, VECTORS), piece, line)


@pytest.mark.parametrize("key", ["frame", "links", "drive"])
def test_a_missing_part_is_named(key):
    rest = {"frame": "{points: {A: 0}}", "links": "{1: {points: {A: 0}}}", "drive": "{link: 1, phi: 0}"}
    text = "planes: 1\n" + "".join(f"{k}: {v}\n" for k, v in rest.items() if k != key)
    check_refusal(text, f"the key {key} is missing", 1)


def test_an_unknown_variant_is_refused_with_the_list():
    check_refusal(SIX_LINK, 'no variant "Б"; valid: А', 4, "Б")
    check_refusal(VECTORS, "the scene has no variants", 1, "Б")


def check_refusal(text, piece, line, variant=None):
    with pytest.raises(SceneError) as caught:
        loads(text, "s.yaml", variant)
    error = caught.value
    assert piece in str(error.phrase)
    assert line is None or error.line == line, str(error)
    assert str(error) == f"s.yaml:{error.line}: {error.phrase!s}"
    assert "\n" not in str(error) and len(str(error)) < 500


PIECES = [
    "{",
    "}",
    "[",
    "]",
    ":",
    ",",
    "\n",
    "  ",
    "- ",
    "0",
    "-1",
    "1e9",
    ".nan",
    "~",
    "A",
    "C",
    "CL",
    "y-y",
    "phi",
    "links: ",
    "&a ",
    "*a",
    "!!str ",
    "'",
    '"',
    "#",
    "\t",
    "\0",
    "²",
    "и\u0306",
    "1/0",
    "sqrt(",
    "motion",
    "mu: ",
    "|",
    "? ",
    "\ud800",
]


@settings(max_examples=500)
@given(st.integers(0, 10**9), st.integers(1, 4), st.sampled_from([SIX_LINK, VECTORS]))
def test_any_text_is_a_scene_or_a_sentence(seed, times, text):
    rng = random.Random(seed)
    for _ in range(times):
        start = rng.randrange(len(text) + 1)
        stop = min(len(text), start + rng.choice((0, 0, 1, 3, 10)))
        text = text[:start] + rng.choice([*PIECES, text[stop : stop + rng.randrange(20)]]) + text[stop:]
    check_any(text)


@settings(max_examples=200)
@given(st.data())
def test_any_words_swapped_are_a_scene_or_a_sentence(data):
    words = SIX_LINK.replace(",", " , ").split(" ")
    for _ in range(data.draw(st.integers(1, 3))):
        i, j = (data.draw(st.integers(0, len(words) - 1)) for _ in "ij")
        words[i] = words[j]
    check_any(" ".join(words))


def check_any(text):
    try:
        assert isinstance(loads(text), Scene)
    except SceneError as error:
        assert str(error.phrase) and "\n" not in str(error)


START = "planes: 1\nframe: {points: {A: 0}}\nlinks:\n  1: {points: {A: 0}}\n"
END = "drive: {link: 1, phi: 0}\n"
HOSTILE = {
    "links": START + "".join(f"  l{i}: {{points: {{A: 0, B{i}: 0.1}}}}\n" for i in range(25_000)) + END,
    "slides": START + "".join(f"  l{i}: {{points: {{A: 0}}, slides: g}}\n" for i in range(25_000)) + END,
    "loads": START + END + "loads:\n" + " - {link: 1, point: A, force: 1, along: motion}\n" * 18_000,
    "chain": START + END + "parameters:\n" + "".join(f"  a{i}: a{i + 1}\n" for i in range(55_000)) + "  a55000: 1\n",
    "sums": START + END + "parameters:\n" + "".join(f"  a{i}: {'1+' * 490}1\n" for i in range(950)),
    "roots": START + END + "parameters:\n" + "".join(f"  a{i}: {'9^' * 35}9\n" for i in range(10_000)),
    "names": START + END + "parameters:\n" + "".join(f"  a{i}: 1\n" for i in range(80_000)) + "  b: zz\n",
    "variants": START + END + "parameters: {a: 1}\nvariants:\n" + "".join(f" v{i}: {{a: 1}}\n" for i in range(50_000)),
    "points": "planes: 1\nframe:\n points:\n" + "".join(f"  P{i}: 0\n" for i in range(80_000)) + START[36:] + END,
    "find": START + END + "find: [" + "v_C, " * 190_000 + "]\n",
    "vectors": "planes: 1\nequations: [a = b]\nvectors:\n" + "".join(f" v{i}: {{value: 1}}\n" for i in range(45_000)),
}


@pytest.mark.slow
@pytest.mark.few(4)
@pytest.mark.parametrize("name", HOSTILE)
def test_large_scenes_take_a_bounded_time(name):
    with at_most(20_000_000):
        check_any(HOSTILE[name])
