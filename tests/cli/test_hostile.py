"""The roof: scenes wrong as students write them get one sentence with its line, whatever is asked of them."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from planes import cli
from tests.helpers.scene_texts import SIX_LINK, VECTORS
from tests.solving.test_failures import CROSS_SLIDE, FOUR_BAR, ROCKER, SLIDER

LOAD = SLIDER + "loads: [{link: 3, point: C, force: 5, direction: 0}]\n"
PARALLEL_GUIDES = """\
planes: 1
frame: {points: {A: [0, 0]}, guides: {x-x: {y: 0}, y-y: {x: 1}}}
links:
  1: {points: {A: 0, B: 0.1}}
  2: {points: {C: 0}, slides: x-x}
  3: {points: {C: 0}, slides: y-y}
drive: {link: 1, phi: 1}
"""
TWO_EQUATIONS = """\
planes: 1
vectors: {a: {value: 1, direction: 0}, b: {direction: 90}, c: {direction: 45}, d: {direction: 45}, e: {direction: 45}}
equations:
  - c = a + b
  - d = e + a
"""
LENGTHS = "planes: 1\nvectors: {a: {value: 10, direction: 0}, b: {value: 1}, c: {value: 2}}\nequations: [a = b + c]\n"
ARC = LENGTHS.replace("c: {value: 2}", "c: {direction: 90}").replace("a = b + c", "c = a + b")

BAD = [  # scene, what stands there, what instead, a piece of the sentence, its line
    (FOUR_BAR, "D: 0, C: 0.3", "D: 0, С: 0.3", "С of link 3 and point C of link 2 look the same but", 6),
    (FOUR_BAR, "A: [0, 0]", "А: [0, 0]", "point A of link 1 and point А of the frame look the same", 4),
    (FOUR_BAR, "{C: left}", "{С: left}", "C looks the same but is written in other letters", 7),
    (SLIDER, "slides: x-x", "slides: х-х", "x-x looks the same", 6),
    (FOUR_BAR, "phi: 60", "рhi: 60", "phi looks the same", 8),
    (LOAD, "point: C", "point: С", "C looks the same", 10),
    (VECTORS, '"v_C =', '"v_С =', "there is no vector v_С; valid: v_B, v_CB, v_C; v_C looks the same", 6),
    (FOUR_BAR, "C: left", "C left", "a ':' is missing after the key \"C\"", 7),
    (FOUR_BAR, "phi: 60", "phi 60", "a ':' is missing after the key \"phi\"", 8),
    (FOUR_BAR, "links:\n", "links\n", "a ':' is missing", 3),
    (FOUR_BAR, "  2: {points", "    2: {points", "indentation", 5),
    (FOUR_BAR, "  3: {points", "3: {points", 'the scene has no key "3"', 6),
    (FOUR_BAR, "{A: 0, B: 0.1}", "[A, B]", "points of link 1 must be a table", 4),
    (FOUR_BAR, "link: 1", "link: 4", 'no link "4"', 8),
    (FOUR_BAR, "link: 1", "link: 2", "one hinge on the frame, but it is joined to the frame by: none", 8),
    (FOUR_BAR, "{link: 1, phi: 60, omega: 10}", "[{link: 1, phi: 60}]", "there is only one driver", 8),
    (FOUR_BAR, "plans:", "drive:", '"drive" occurs twice, in line 8 and in line 9', 9),
    (FOUR_BAR, "omega: 10", "omega: 600 rpm", '"rpm" is not expected here: units are not written', 8),
    (FOUR_BAR, "B: 0.1", "B: 100 mm", "units are not written", 4),
    (FOUR_BAR, "inertia: 0.1", "inertia: 0.1 кг·м²", '"кг" is not expected here: units', 5),
    (FOUR_BAR, "[0.4, 0]", "[0,4, 0]", "not 3; a decimal fraction is written with a point", 2),
    (FOUR_BAR, "mass: 1", "mass: [1, 0]", "must be a number, not a list", 4),
    (SIX_LINK, "mu: 30 mm/(m/s)", 'mu: "1:4"', "only the scale of the position plan is written like this", 25),
    (SIX_LINK, "mu: 0.01 mm/N", "mu: 0,01 mm/N", "decimal point: 0.01 mm/N", 27),
    (SIX_LINK, "{C: right}", "{H: right}", "add to assembly: C: left for C at (-0.20697, -0.22479) or C: right", 16),
    (FOUR_BAR, "{B: 0, C: 0.3}", "{B: 0, C: 0.3, D: 0.5}", "2 constraint(s) too many: check the names", 5),
    (FOUR_BAR, "D: 0, C: 0.3", "D: 0, E: 0.3", "a link or a pair is missing", 6),
    (ROCKER, "slides: g", "slides: 3", 'link 2 slides on "3", but there is no such guide', 5),
    (ROCKER, "B: 0}, slides: g", "B: 0}, slides: g, guides: {h: {through: D}}", "no point of link 2", 5),
    (LOAD, "point: C", "point: B", 'no point of link 3 called "B"; valid: C', 10),
    (PARALLEL_GUIDES, "A: [0, 0]", "A: [0, 0]", "links 2 and 3 both slide on guides of link 0", 6),
    (TWO_EQUATIONS, "a", "a", "d = e + a: d and e are parallel, so the polygon cannot close", 5),
    (LENGTHS, "a", "a", "a = b + c: b and c together are too short by 7", 3),
    (LENGTHS, "c: {value: 2}", "c: {value: 20}", "one of b and c is too long by 9", 3),
    (LENGTHS, "value: 10", "value: 0", "one of b and c is too long by 1", 3),
    (LENGTHS, "value: 2}", "value: 0}", "one of the values b, c is zero", 3),
    (ARC, "a", "a", "b is too short to reach the line of c, by 9", 3),
    (FOUR_BAR, "omega: 10", "omega: 1e60", "omega of drive is 1e+60, beyond what can be calculated with", 8),
    (FOUR_BAR, "B: 0.1", "B: 1e300", "point B of link 1 is 1e+300", 4),
    (SLIDER, "1000 mm/m", "1e30 mm/m", "nothing can be drawn at this scale", 9),
    (FOUR_BAR, "{B: 0, C: 0.3}", "{B: 0, C: 0}", "hinges B and C of link 2 coincide: the length BC is zero", 5),
    (SLIDER, "C: 0.3", "C: 0", "hinges B and C of link 2 coincide: the length BC is zero", 5),
]
UNDRAWN = [  # the same for positions that cannot be drawn
    (
        SLIDER,
        "slides: x-x",
        "slides: {guide: x-x, offset: 0.5}",
        "misses the line of C along guide x-x by 0.15 m (150 mm on paper)",
    ),
    (CROSS_SLIDE, "phi: 30", "phi: 180", "the lines of guide g and of guide x-x are parallel"),
    (FOUR_BAR, "B: 0.1", "B: 1e30", "mm on paper): C cannot be drawn"),
]


def asked(capsys: pytest.CaptureFixture[str], *args: str) -> tuple[int, str, str]:
    status = cli.main(list(args))
    return status, *capsys.readouterr()


def refused(capsys: pytest.CaptureFixture[str], folder: Path, text: str) -> dict[str, str]:
    """What solving and drawing a bad scene says, in both languages, stdout being empty and no file left."""
    scene, sheet = folder / "s.yaml", folder / "sheet.svg"
    scene.write_text(text, encoding="utf-8")
    said = {}
    for lang in ("ru", "en"):
        status, out, said[lang] = asked(capsys, "solve", str(scene), "--lang", lang)
        *doubts, last = said[lang].splitlines(keepends=True)  # what is doubted is said before it is refused
        assert (status, out) == (2, "") and len(doubts) <= 2
        status, out, again = asked(capsys, "sheet", str(scene), "--lang", lang, "-o", str(sheet))
        assert (status, out, again) == (2, "", said[lang]) and not sheet.exists()
        said[lang] = last
        assert not re.search(r"\b(nan|inf)\b|[°⊥∥|‖∠→](?=[A-Za-z])(?!B|D)", said[lang].partition("φ")[2])
    return {lang: words.replace(f"{scene}:", "s:") for lang, words in said.items()}


@pytest.mark.few(20)
@pytest.mark.parametrize(("text", "old", "new", "piece", "line"), BAD)
def test_a_scene_as_students_spoil_it(capsys, tmp_path, text, old, new, piece, line):
    assert old in text
    said = refused(capsys, tmp_path, text.replace(old, new, 1))
    assert said["en"].startswith(f"s:{line}: ") and said["ru"].startswith(f"s:{line}: ")
    assert piece in said["en"] and re.search("[а-яё]{3}", said["ru"])


@pytest.mark.parametrize(("text", "old", "new", "piece"), UNDRAWN)
def test_a_position_as_students_spoil_it(capsys, tmp_path, text, old, new, piece):
    assert old in text
    said = refused(capsys, tmp_path, text.replace(old, new, 1))
    assert said["en"].startswith("s: at φ = ") and piece in said["en"] and said["ru"].startswith("s: при φ = ")


GREAT = {"omega: 10": "omega: 1e50, epsilon: 1e50", "mass: 2": "mass: 1e50", "inertia: 0.1": "inertia: 1e50"}


@pytest.mark.parametrize("size", ["1e50", "1e-200", "1e-310"])
def test_the_largest_and_the_smallest_numbers_end_in_finite_ones_or_a_sentence(capsys, tmp_path, size):
    scene = tmp_path / "s.yaml"
    text = FOUR_BAR.replace("plans: {position: {mu: 1000 mm/m}}\n", "")
    for old, new in GREAT.items():
        text = text.replace(old, new.replace("1e50", size))
    for length in ("0.1}", "0.3}", "0.4,"):
        text = text.replace(length, f"{length[:-1]}*{size}{length[-1]}")
    scene.write_text(text, encoding="utf-8")
    for extra in ([], ["--pencil"], ["--phi", "0:360:45"]):
        status, out, said = asked(capsys, "solve", str(scene), "--json", *extra)
        assert status == 0 or said
        assert "NaN" not in out and "Infinity" not in out and "nan" not in said
        json.loads(out)


def test_an_angle_of_the_drive_is_refused_where_nothing_is_driven(capsys, tmp_path):
    scene = tmp_path / "v.yaml"
    scene.write_text(VECTORS, encoding="utf-8")
    for command in (["solve"], ["sheet", "-o", str(tmp_path / "v.svg")]):
        status, out, said = asked(capsys, command[0], str(scene), *command[1:], "--phi", "3", "--lang", "en")
        assert (status, out) == (2, "") and said == f"--phi does not fit {scene}: it has no driver\n"
