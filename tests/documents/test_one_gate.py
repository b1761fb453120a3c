"""Every name that is printed is read wherever a name is asked, and a number three times too large under it is wrong."""

import re
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest

import planes
from planes.check.grading.paper import ReadPaper
from planes.check.grading.prepared_plan import Asked, known_plans
from planes.check.outcome import check
from planes.course.numbers import main_answers
from planes.documents.lesson import note_file_contents
from planes.documents.sheets import sheet_of
from planes.lesson.told import SceneLesson
from planes.plans.curves import curve_or_vector_by_name, curves_by_name
from planes.plans.quantities import Quantity, quantities_asked_for, quantities_by_name
from planes.plans.statements.of_scene import scene_plans
from planes.scene import Scene
from planes.solving import Solved, solve
from planes.solving.tables import solve_report_text
from planes.words import Lang, available_languages
from planes.words.errors import PlanesError
from planes.words.naming import Names
from render.paper.marks import Text

SAMPLES = Path(__file__).parents[2] / "samples"
FEW = ["six-link", "assignments/27"]
OTHERS = [
    str(p.relative_to(SAMPLES).with_suffix(""))
    for p in sorted(SAMPLES.rglob("*.yaml"))
    if re.search("^links:|^vectors:", p.read_text(encoding="utf-8"), re.MULTILINE)
]
SHEETS = [(None, False), ("7", True), ("0", True), ("12", False)]
CELL = re.compile(r"  (\S*[A-Za-zωεφΦ]\S*)  ")
ON_SHEET = re.compile(
    r"(?<![\w}])([FR](?=_\{\d+,?\d)|[MGΦωε](?=_\{\d)|[va](?=_\{[A-Z]))_\{([^{}]*)\}(?:\^\{?([^{}\s]*)\}?)?"
)
LETTERED = re.compile(r"([A-Za-zωεΦ])<sub>([^<]*)</sub>(?:<sup>([^<]*)</sup>)?")


@cache
def scene_of(sample: str, sheet: int) -> Scene:
    """A sample with the frame's number and the convention of its sheets changed."""
    scene, (number, from_on) = planes.load(SAMPLES / f"{sample}.yaml"), SHEETS[sheet]
    order = {"reactions": "from-on"} if from_on else {}
    scene = replace(scene, sheet={**scene.sheet, **order}, find=None)
    if scene.mechanism is None or number is None:
        return scene
    number = "99" if number in scene.mechanism.links else number  # else a printed name means two things
    return replace(scene, mechanism=replace(scene.mechanism, frame_number=number))


@cache
def solved(sample: str, sheet: int) -> Solved:
    return solve(scene_of(sample, sheet))


@cache
def known_of(sample: str, sheet: int) -> tuple[dict[str, Quantity], Names]:
    plans = solved(sample, sheet).plans
    known = quantities_by_name(plans)
    return known, plans.default_naming.name_finder(known, poles=False)


def printed(sample: str, sheet: int, lang: Lang) -> set[str]:
    """The names in the tables of ``planes solve``."""
    lines = solve_report_text(solved(sample, sheet), lang).splitlines()
    cells = {match[1] for line in lines if (match := CELL.match(line))}
    plans = solved(sample, sheet).plans
    return cells - {*plans.points, *plans.links, *plans.mechanism.point_names}


def meant(sample: str, sheet: int, written: str) -> list[Quantity]:
    """The quantities a written name may mean, each once."""
    known, names = known_of(sample, sheet)
    return [*{known[n].json_path: known[n] for n in names.possible_names(written)}.values()]


def gate(sample: str, sheet: int, lang: Lang) -> Iterator[tuple[str, Quantity]]:
    """Every printed name with what it means."""
    for written in sorted(printed(sample, sheet, lang)):
        quantities = meant(sample, sheet, written)
        assert len(quantities) == 1, (written, [q.name for q in quantities])
        yield written, quantities[0]


def accepted(sample: str, sheet: int, lang: Lang) -> None:
    """Printed names are those of ``find:``, of Python and of ``--show``, and the numbers beside them are the same."""
    here, plans = solved(sample, sheet).positions[0], solved(sample, sheet).plans
    curves = curves_by_name(plans) if plans.has_mechanism else {}
    rows = list(gate(sample, sheet, lang))
    assert [q.json_path for q in quantities_asked_for(plans, [written for written, _ in rows])] == [
        q.json_path for _, q in rows
    ]
    for written, quantity in rows:
        if written[0] in "FR" and quantity.group == "reactions":
            size = abs(here.value(quantity.name))  # F_12 is opposite to F_21
            assert abs(here.value(written)) == pytest.approx(size, nan_ok=True)
            assert curve_or_vector_by_name(written, curves, plans, "") is curves[quantity.name]
    if sheet != list(available_languages()).index(lang) % len(
        SHEETS
    ):  # a note in each language, and of each kind of sheets
        return
    for answer, _ in main_answers(scene_of(sample, sheet), solved(sample, sheet).json()):
        assert len(meant(sample, sheet, answer)) == 1, answer
    for name in taught(sample, sheet) & known_of(sample, sheet)[0].keys():
        written = re.sub(r"[{}]", "", plans.default_naming.lettered_vector(name))
        assert [q.json_path for q in meant(sample, sheet, written)] == [known_of(sample, sheet)[0][name].json_path], (
            written
        )
    for number in (1, 2) if plans.has_mechanism else ():
        marks = sheet_of(scene_of(sample, sheet), None, lang=lang, number=number).marks
        texts = (m.text for m in marks if isinstance(m, Text))
        for letter, index, part in {found for text in texts for found in ON_SHEET.findall(text)}:
            written = f"{letter}_{index}" + (f"^{part}" if part else "")
            assert written in scene_of(sample, sheet).parameters or len(meant(sample, sheet, written)) == 1, written
    text = note_file_contents(scene_of(sample, sheet), None, ".html", lang).decode()
    for letter, index, part in set(LETTERED.findall(text)):
        if letter == ("R" if SHEETS[sheet][1] else "F") and re.fullmatch(r"\d+(,\d+)?", index) and len(index) > 1:
            assert len(meant(sample, sheet, f"{letter}_{index}" + (f"^{part}" if part else ""))) == 1, (index, part)


def taught(sample: str, sheet: int) -> set[str]:
    """The names in the sentences of a lesson, as the program has them."""
    frames = SceneLesson.of(scene_of(sample, sheet)).frames if solved(sample, sheet).plans.has_mechanism else ()
    return {name for f in frames for said in f.words_with_rows.values() for name in re.findall("⟨([^⟩]*)⟩", said)}


def blamed(sample: str, sheet: int, lang: Lang) -> int:
    """How many numbers three times too large were found wrong under the names that are printed: every one but zeros."""
    scene, here, count = scene_of(sample, sheet), solved(sample, sheet).positions[0], 0
    ask = Asked(scene, known_plans(scene_plans(scene))[0])
    for written, quantity in gate(sample, sheet, lang):
        value = quantity.column_to_write.read_from_drawing(here.drawing.things, here.drawing.tool.ar)
        if quantity.columns[0].unit in ("°", "1") or not abs(value) > 1e-6:
            continue
        outcome = check(ask, ReadPaper("t.csv", results=[(written, 3 * value, "")]))
        (scored,) = outcome.results.scored if outcome.results else ()
        assert outcome.verdict == ("wrong" if scored.verdict == "wrong" else "right_as_seen"), written
        count += scored.verdict == "wrong"
    return count


@pytest.mark.few(1)
@pytest.mark.parametrize("sheet", range(len(SHEETS)))
@pytest.mark.parametrize("sample", FEW)
def test_a_printed_name_is_read_wherever_one_is_asked(sample: str, sheet: int) -> None:
    for lang in ("ru", "en"):
        accepted(sample, sheet, lang)


@pytest.mark.parametrize(("sample", "sheet"), [("six-link", 0), ("six-link", 1)])
def test_a_number_three_times_too_large_is_wrong_under_its_printed_name(sample: str, sheet: int) -> None:
    assert blamed(sample, sheet, "en") > 15


@pytest.mark.few(0, slow=4)
@pytest.mark.parametrize("sample", OTHERS)
def test_every_sample_has_names_that_are_read(sample: str) -> None:
    for sheet in range(len(SHEETS)) if scene_of(sample, 0).mechanism else (0,):
        for lang in available_languages():
            accepted(sample, sheet, lang)
    blamed(sample, 0, "ru")


def test_either_number_of_the_frame_and_either_order_mean_one_reaction() -> None:
    here = solved("six-link", 0).positions[0]
    for written in ("F_30", "F_36", "F36", "R_63", "R_03", "F_{36}"):
        assert here.value(written) == here.value("F_30")
    assert here.value("v_\N{CYRILLIC CAPITAL LETTER ES}") == here.value("v_C")  # a Cyrillic letter that looks the same
    assert here.omega[2] == here.omega["2"] == here.omega["omega_2"] and here.v["v_C"] == here.v["C"]
    table = planes.cycle(scene_of("six-link", 0), ["F_36"], phi=[150.0])
    assert table["R_63"] == table["F_30"] == pytest.approx(here.value("F_30"))


def test_a_name_that_nothing_has_is_answered_by_those_there_are() -> None:
    here = solved("six-link", 0).positions[0]
    with pytest.raises(KeyError, match="F_36"):
        here.of("reactions")["F_99"]
    with pytest.raises(PlanesError, match="there is no Q here; valid: A, D, B, C, S2, H"):
        here.v["Q"]


def test_a_name_that_may_mean_two_things_is_said_so() -> None:
    scene = scene_of("six-link", 0)
    assert scene.mechanism
    scene = replace(scene, mechanism=replace(scene.mechanism, frame_number="2"))
    with pytest.raises(PlanesError, match=r"the name F_32 may mean F_3[02], F_3[02] here; write one of them"):
        quantities_asked_for(scene_plans(scene), ["F_32"])
    ask = Asked(scene, "force:2-3")
    assert check(ask, ReadPaper("t.csv", results=[("F_32", 1.0, "N"), ("omega_2", 8.122, "")])).verdict != "right"
