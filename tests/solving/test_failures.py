"""Every failure in words, in both languages, with its names and numbers; never a traceback, never a NaN."""

from __future__ import annotations

import json
import math
import random
import re
from typing import Any

import pytest

from planes.scene import loads
from planes.solving import solve
from planes.words.errors import PlanFailure, SceneError
from tests.helpers.mechanisms import KINDS, make, to_yaml

FOUR_BAR = """\
planes: 1
frame: {points: {A: [0, 0], D: [0.4, 0]}}
links:
  1: {points: {A: 0, B: 0.1}, mass: 1}
  2: {points: {B: 0, C: 0.3}, mass: 2, inertia: 0.1}
  3: {points: {D: 0, C: 0.3}, mass: 2}
assembly: {C: left}
drive: {link: 1, phi: 60, omega: 10}
plans: {position: {mu: 1000 mm/m}}
"""
SLIDER = """\
planes: 1
frame: {points: {A: [0, 0]}, guides: {x-x: {y: 0}}}
links:
  1: {points: {A: 0, B: 0.1}, mass: 1}
  2: {points: {B: 0, C: 0.3}, mass: 2}
  3: {points: {C: 0}, slides: x-x, mass: 2}
assembly: {C: ahead}
drive: {link: 1, phi: 30, omega: 10}
plans: {position: {mu: 1000 mm/m}}
"""
ROCKER = """\
planes: 1
frame: {points: {A: [0, 0], D: [0.2, 0]}}
links:
  1: {points: {A: 0, B: 0.1}, mass: 1}
  2: {points: {B: 0}, slides: g, mass: 1}
  3: {points: {D: 0}, guides: {g: {through: D, angle: 0}}, mass: 1, inertia: 0.1}
assembly: {g: ahead}
drive: {link: 1, phi: 60, omega: 10}
plans: {position: {mu: 1000 mm/m}}
"""
CROSS_SLIDE = """\
planes: 1
frame: {points: {A: [0, 0]}, guides: {x-x: {y: 0.3}}}
links:
  1: {points: {A: 0}, guides: {g: {y: 0.2}}}
  2: {points: {C: 0}, slides: g}
  3: {points: {C: 0}, slides: x-x}
drive: {link: 1, phi: 30, omega: 10}
plans: {position: {mu: 1000 mm/m}}
"""

CASES: dict[str, tuple[str, str, str]] = {  # scene, in Russian, in English
    "arcs apart": (
        FOUR_BAR.replace("B: 0.1", "B: 0.3").replace("phi: 60", "phi: 180"),
        "дуги l_BC из B и l_DC из D не встречаются, не хватает 0,1 м (100 мм на бумаге): C не построить; механизм в "
        "этом положении не собирается",
        "the arcs l_BC about B and l_DC about D are 0.1 m apart (100 mm on paper): C cannot be drawn; the mechanism "
        "does not assemble in this position",
    ),
    "arcs inside": (
        FOUR_BAR.replace("{D: 0, C: 0.3}", "{D: 0, C: 0.9}"),
        "дуга l_BC из B и дуга l_DC из D лежат одна внутри другой на 0,2394 м (239,4 мм на бумаге): C не построить; "
        "механизм в этом положении не собирается",
        "of the arcs l_BC about B and l_DC about D one lies inside the other by 0.2394 m (239.4 mm on paper): C "
        "cannot be drawn; the mechanism does not assemble in this position",
    ),
    "arcs coincide": (
        FOUR_BAR.replace("D: [0.4, 0]", "D: [0.1, 0]").replace("phi: 60", "phi: 0"),
        "дуги l_BC из B и l_DC из D совпадают: C на них не определена, механизм в точке разветвления; возьмите "
        "соседнее положение",
        "the arcs l_BC about B and l_DC about D coincide: any point of them could be C, the mechanism is at a change "
        "point; take a neighbouring position",
    ),
    "arc short": (
        SLIDER.replace("C: 0.3", "C: 0.03"),
        "дуга радиуса l_BC из B не достаёт до прямой направляющей x-x на 0,02 м (20 мм на бумаге): C не построить; "
        "механизм в этом положении не собирается",
        "the arc l_BC about B misses the line of guide x-x by 0.02 m (20 mm on paper): C cannot be drawn; the "
        "mechanism does not assemble in this position",
    ),
    "dead point of RRR": (
        FOUR_BAR.replace("C: 0.3", "C: 0.25").replace("B: 0.1", "B: 0.3").replace("phi: 60", "phi: 90"),
        "прямые ⊥BC через b и ⊥DC через p параллельны и отстоят на 60 мм на бумаге: c бесконечно далеко, механизм в "
        "особом положении; измените положение ведущего звена",
        "the lines ⊥BC through b and ⊥DC through p are parallel, 60 mm apart on paper: c is infinitely far, the "
        "mechanism is at a dead point; take another position of the driver",
    ),
    "dead point of RRP": (
        SLIDER.replace("C: 0.3", "C: 0.08").replace("phi: 30", "phi: 53.13010235415598"),
        "",
        "the lines ⊥BC through b and ∥x-x through p are parallel, 60 mm apart on paper: c is infinitely far, the "
        "mechanism is at a dead point; take another position of the driver",
    ),
    "change point": (
        FOUR_BAR.replace("{B: 0, C: 0.3}", "{B: 0, C: 0.4}")
        .replace("{D: 0, C: 0.3}", "{D: 0, C: 0.1}")
        .replace("phi: 60", "phi: 0"),
        "прямые ⊥BC через b и ⊥DC через p совпадают: c на них не определена (0/0), механизм в точке разветвления; "
        "возьмите соседнее положение",
        "the lines ⊥BC through b and ⊥DC through p coincide: any point of them could be c (0/0), the mechanism is at "
        "a change point; take a neighbouring position",
    ),
    "guides parallel": (
        CROSS_SLIDE.replace("phi: 30", "phi: 0"),
        "прямые направляющей g и направляющей x-x параллельны и отстоят на 100 мм на бумаге: C бесконечно далеко, "
        "механизм в особом положении; измените положение ведущего звена",
        "the lines of guide g and of guide x-x are parallel, 100 mm apart on paper: C is infinitely far, the mechanism "
        "is at a dead point; take another position of the driver",
    ),
    "guides coincide": (
        CROSS_SLIDE.replace("phi: 30", "phi: 0").replace("y: 0.2", "y: 0.3"),
        "прямые направляющей g и направляющей x-x совпадают: C на них не определена (0/0), механизм в точке "
        "разветвления; возьмите соседнее положение",
        "the lines of guide g and of guide x-x coincide: any point of them could be C (0/0), the mechanism is "
        "at a change point; take a neighbouring position",
    ),
    "offset circle too large": (
        ROCKER.replace("through: D", "through: [0, 0.15]").replace("phi: 60", "phi: 0"),
        "точка B ближе к D, чем смещение направляющей, на 0,05 м (50 мм на бумаге): касательной для направляющей g "
        "не провести; механизм в этом "
        "положении не собирается",
        "B is closer to D than the guide's offset, by 0.05 m (50 mm on paper): no tangent for guide g can be drawn; "
        "the mechanism does not "
        "assemble in this position",
    ),
    "points meet": (
        ROCKER.replace("D: [0.2, 0]", "D: [0.1, 0]").replace("phi: 60", "phi: 0"),
        "точки D и B совпали: направление направляющей g не определено; возьмите соседнее положение",
        "D and B coincide: the direction of guide g is not determined; take a neighbouring position",
    ),
}


def failure(text: str, lang: Any = "en", value: float | None = None) -> str:
    """The sentence of the only position of a scene, which fails."""
    solved = solve(loads(text), None if value is None else [value], None, lang)
    assert not solved.positions and len(solved.failed) == 1
    return str(solved.failed[0]["error"])


def near_offered(sentence: str) -> tuple[str, float | None]:
    """A failure without its offer of the nearest position that works, and that position."""
    found = re.fullmatch(r"(.*?)(?:; (?:the nearest that works|ближайшее рабочее положение): φ = (.*)°)?", sentence)
    assert found
    return found[1], None if found[2] is None else float(found[2].replace(",", "."))


@pytest.mark.parametrize("name", CASES)
def test_a_failure_is_told_with_its_names_and_numbers(name: str) -> None:
    text, russian, english = CASES[name]
    said, works = near_offered(failure(text))
    place, sentence = said.split(": ", 1)
    assert place.startswith("at φ = ")
    assert sentence == english
    in_russian, same = near_offered(failure(text, "ru"))
    assert in_russian.startswith("при φ = ") and same == works
    if russian:
        assert in_russian.split(": ", 1)[1] == russian
    if works is not None:
        assert solve(loads(text), [works]).positions


JAM = (
    SLIDER.replace("y: 0}", "y: 0.02}")
    + """\
gravity: 9.81
loads: [{link: 3, point: C, force: 100, against: motion}]
friction: {x-x: 1.2}
"""
)


@pytest.mark.slow
def test_self_locking_without_an_answer_and_with_two() -> None:
    """Friction that locks: driven near the dead point no side of the guide fits, or both do."""
    found = set()
    for f in (0.5, 1.2, 3.0, 8.0):
        scene = loads(JAM.replace("1.2", str(f)))
        for lang in ("ru", "en"):
            solved = solve(scene, [float(phi) for phi in range(0, 360, 5)], None, lang)
            json.dumps(solved.json(), allow_nan=False)
            for fail in solved.failed:
                found.add(fail["error"].split(": ", 1)[1])
    english = [s for s in found if s.startswith("the forces at")]
    assert any("(0 solutions instead of one): self-locking" in s for s in english)
    assert any("(2 solutions instead of one): self-locking" in s for s in english)
    assert any("(0 решений вместо одного): самоторможение" in s for s in found)
    assert all("coefficient" in s for s in english)


@pytest.mark.parametrize(
    "extra", ["friction: {x-x: 0.1}\n", "loads: [{link: 3, point: C, force: 9, against: motion}]\n"]
)
def test_a_standstill_is_warned_of(extra: str) -> None:
    for value in (0.0, 180.0):
        for lang, words in (("en", "the speed is zero"), ("ru", "скорость равна нулю")):
            solved = solve(loads(SLIDER + extra), [value], None, lang)  # type: ignore[arg-type]
            assert any(words in w for w in solved.positions[0].results["warnings"])
    assert not solve(loads(SLIDER + extra), [30.0]).positions[0].results["warnings"]


def test_a_load_at_a_fixed_point_is_zero_with_a_warning() -> None:
    text = SLIDER + "loads: [{link: 1, point: A, force: 9, along: motion}]\n"
    results = solve(loads(text)).positions[0].results
    assert results["reactions"]["F_10"] == solve(loads(SLIDER)).positions[0].results["reactions"]["F_10"]
    assert any("the speed is zero" in w for w in results["warnings"])


def test_a_blunt_crossing_is_warned_of_with_its_angle() -> None:
    text = FOUR_BAR.replace("B: 0.1", "B: 0.3").replace("phi: 60", "phi: 97")
    angles = {lang: solve(loads(text), None, None, lang).positions[0].results["warnings"] for lang in ("ru", "en")}
    assert not angles["en"]
    stretched = (
        FOUR_BAR.replace("B: 0.1", "B: 0.2").replace("D: [0.4, 0]", "D: [0.796, 0]").replace("phi: 60", "phi: 0")
    )
    said = solve(loads(stretched)).positions[0].results["warnings"]
    assert any("the lines meet at" in w and "less than 15°" in w for w in said)
    assert any("меньше 15°" in w for w in solve(loads(stretched), None, None, "ru").positions[0].results["warnings"])


def test_a_missing_side_prints_both_places_with_their_words() -> None:
    with pytest.raises(SceneError) as caught:
        solve(loads(FOUR_BAR.replace("assembly: {C: left}\n", "")))
    assert str(caught.value) == (
        "scene.yaml:3: links 2, 3 (RRR) can be assembled in two ways and the scene does not say which; add assembly: "
        "{C: left} for C at (0.2826, 0.27607) or assembly: {C: right} for C at (0.1674, -0.18947)"
    )


@pytest.mark.parametrize("word, place", [("left", (0.2826, 0.27607)), ("right", (0.1674, -0.18947))])
def test_the_printed_places_are_where_the_words_lead(word: str, place: tuple[float, float]) -> None:
    results = solve(loads(FOUR_BAR.replace("C: left", f"C: {word}"))).positions[0].results
    assert results["points"]["C"]["r"] == pytest.approx(place, abs=1e-5)


def test_a_missing_side_of_a_slider_and_of_a_rocker() -> None:
    with pytest.raises(SceneError, match=r"links 2, 3 \(RRP\).*C: ahead} for C at \(0.38.*C: behind} for C at \(-0.2"):
        solve(loads(SLIDER.replace("assembly: {C: ahead}\n", "")))
    with pytest.raises(SceneError, match=r"links 2, 3 \(RPR\).*{g: ahead}.*{g: behind}"):
        solve(loads(ROCKER.replace("assembly: {g: ahead}\n", "")))


@pytest.mark.parametrize(
    "text, old, new, words",
    [
        (
            FOUR_BAR,
            "C: left",
            "C: ahead",
            "ahead does not fit a group RRR (links 2, 3); valid: left, right or {near: [x, y]}",
        ),
        (
            SLIDER,
            "C: ahead",
            "C: left",
            "left does not fit a group RRP (links 2, 3); valid: ahead, behind or {near: [x, y]}",
        ),
        (
            ROCKER,
            "g: ahead",
            "g: left",
            "left does not fit a group RPR (links 2, 3); valid: ahead, behind or {near: [x, y]}",
        ),
    ],
)
def test_a_word_of_another_group_is_refused_with_those_that_fit(text: str, old: str, new: str, words: str) -> None:
    line = text[: text.index("assembly")].count("\n") + 1
    with pytest.raises(SceneError) as caught:
        solve(loads(text.replace(old, new)))
    assert str(caught.value) == f"scene.yaml:{line}: assembly {new.split(':')[0]}: {words}"


def test_near_that_cannot_tell_is_refused() -> None:
    text = FOUR_BAR.replace("D: [0.4, 0]", "D: [0.7, 0]").replace("phi: 60", "phi: 0")
    with pytest.raises(SceneError, match="point C is at the same place in both assemblies, so near cannot tell"):
        solve(loads(text.replace("C: left", "C: {near: [0.3, 0.3]}")))


def test_near_where_nothing_assembles_says_why() -> None:
    text = FOUR_BAR.replace("D: [0.4, 0]", "D: [1.4, 0]").replace("C: left", "C: {near: [0.3, 0.3]}")
    with pytest.raises(
        SceneError, match="the nearer position cannot be found, because at the drive's value the arcs l_BC"
    ):
        solve(loads(text))


def test_near_picks_the_nearer_of_the_two_and_keeps_its_side() -> None:
    for near, sign in (([0.3, 0.3], 1), ([0.3, -0.3], -1)):
        scene = loads(FOUR_BAR.replace("C: left", f"C: {{near: {near}}}"))
        for position in solve(scene, [0.0, 90.0, 180.0, 270.0]).positions:
            b, c = (complex(*position.results["points"][n]["r"]) for n in "BC")
            assert math.copysign(1, ((0.4 - b).conjugate() * (c - b)).imag) == sign


def test_no_digits_left_is_a_failure_and_not_a_number() -> None:
    with pytest.raises(PlanFailure) as caught:
        raise PlanFailure("no_digits", makes="c")
    assert caught.value.told("ru") == "в c не осталось верных цифр"


@pytest.mark.slow
def test_whatever_the_position_there_is_a_number_or_a_sentence() -> None:
    """Random mechanisms far from where they were assembled: finite JSON, or words without NaN."""
    failed = 0
    for seed in range(40):
        rng = random.Random(seed)
        case = make(rng, rng.choices(KINDS, k=rng.randint(1, 3)), friction=rng.random() < 0.5)
        scene = loads(to_yaml(case.scene))
        turns = "phi" in case.scene["drive"]
        values = [rng.choice((rng.uniform(-400, 400), 90.0 * rng.randint(-4, 4))) for _ in range(4)]
        solved = solve(scene, values if turns else [v / 200 for v in values])
        json.dumps(solved.json(), allow_nan=False)
        failed += len(solved.failed)
        for fail in solved.failed:
            assert "nan" not in fail["error"] and "inf " not in fail["error"]
    assert failed
