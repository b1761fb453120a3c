"""Each number and millimetre that note, lesson, answers and both sheets print of a scene is that of its results."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import NamedTuple

import pytest

from planes.course.papers import answer_key_blocks
from planes.documents.lesson import note_position
from planes.documents.sheets import sheet_of
from planes.lesson import slot_value
from planes.lesson.formulas import fill_slots
from planes.lesson.note import Note
from planes.lesson.told import SceneLesson
from planes.plans.measuring import scene_lettering
from planes.scene import load
from planes.solving import solve
from planes.solving.document import Block, DocumentTable
from planes.words.errors import PlanesError
from planes.words.naming import Naming
from render.paper.marks import Text
from tests.documents.test_one_truth import told
from tests.helpers import ROOT

FOLDERS = ("samples", "class-three", "class-four", "assignments")
SCENES = [
    p
    for p in sorted((ROOT / "samples").rglob("*.yaml"))
    if p.parent.name in FOLDERS and not p.stem.startswith("vectors")
]
RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
NUMBER = re.compile(r"([−-]?\d+(?:,\d+)?)(?:·10([⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+))?\s?")
SEGMENT = re.compile(r"([\d,]+) мм / ")
ONE = re.compile(r"⟨([^⟩]+)⟩$")
HALF_OF_THIRD = 0.005  # sheets give three digits: 2130 is any of 2125 to 2135
SUM = re.compile(r"[+−·] ⟨[^⟩]+⟩$")


class Printed(NamedTuple):
    """A number as it is printed of a name, how far off its last digit leaves it, and where."""

    name: str
    unit: str
    value: float
    off: float
    where: str


def number(text: str) -> tuple[float, float, str] | None:
    """A number at the beginning of a text, half of its last place, and what follows."""
    if not (found := NUMBER.match(text.strip())):
        return None
    base, power = found.group(1).replace("−", "-").replace(",", "."), int((found.group(2) or "0").translate(RAISED))
    value, places = float(base) * 10.0**power, len(base.partition(".")[2])
    return value, 0.5 * 10.0 ** (power - places), text.strip()[found.end() :]


def of_text(text: str, where: str) -> Iterator[Printed]:
    """What sentences say: ``⟨v_C⟩ = 40 мм / 30 = 1,33 м/с`` is a length of paper and a velocity."""
    for part in re.split(r"; |\. |\n|, (?=⟨)", text):
        first, *rest = (bit.strip() for bit in part.split(" = "))
        of = ONE.search(first)
        if not of or not rest or SUM.search(first):
            continue
        if (last := number(rest[-1])) and last[2].split(" ")[0].rstrip(".;,") and not last[2].startswith("·"):
            yield Printed(of.group(1), last[2].split(" ")[0].rstrip(".;,"), last[0], last[1], f"{where}: {part}")
        if len(rest) <= 3:
            for bit in rest:
                if (mm := SEGMENT.match(bit)) and (size := number(mm.group(1))):
                    yield Printed(of.group(1), "мм", size[0], size[1], f"{where}: {part}")


def of_answers(blocks: Iterable[Block]) -> Iterator[Printed]:
    """What the key to a task says, by the heads of its columns."""
    for head, *rows in (block.rows for block in blocks if isinstance(block, DocumentTable)):
        columns = {
            "вектор": [(2, "", "мм"), (3, "", head[-1])],
            "Реакция": [(1, "", "Н")],
            "Звено": [(1, "omega_", "рад/с"), (2, "epsilon_", "рад/с²")],
            "Точка": [(1, "v_", "м/с"), (3, "a_", "м/с²")],
        }.get(head[0], [])
        for row in rows:
            for column, letter, unit in columns:
                if column < len(row) and (size := number(row[column])):
                    yield Printed(letter + row[0].strip("⟨⟩"), unit, size[0], size[1], f"answers: {row}")


def rows_of_sheets(path: Path) -> Iterator[list[str]]:
    """Texts that stand on one line, from left to right, from each one on."""
    for page in (1, 2):
        lines: dict[float, list[tuple[float, str]]] = {}
        for mark in sheet_of(load(str(path)), None, "ru", page).marks:
            if isinstance(mark, Text):
                lines.setdefault(round(mark.place.imag, 1), []).append((mark.place.real, mark.text))
        for line in lines.values():
            texts = [text for _, text in sorted(line)]
            yield from (texts[k:] for k in range(len(texts)))


@pytest.mark.few(1, slow=20)
@pytest.mark.parametrize("path", SCENES, ids=[p.stem for p in SCENES])
def test_each_number_is_that_of_the_results(path: Path) -> None:
    scene = load(str(path))
    drawn, solved, shown = note_position(scene, None, "ru"), solve(scene).positions[0], SceneLesson.of(scene)

    def read(name: str) -> float:
        own = name in shown.drawing.things
        return float((shown.drawing[name] if own else slot_value(name, shown.teller, shown.drawing)).real)

    lesson = "\n".join(fill_slots(frame.words_with_rows["ru"], read, "ru") for frame in shown.frames)
    papers = [
        *of_text(told(Note(scene, drawn, "ru").document_blocks()), "note"),
        *of_text(lesson, "lesson"),
        *of_answers(answer_key_blocks(scene, drawn, ("",), "ru")),
    ]
    assert len(papers) > 30
    said: dict[tuple[str, str], Printed] = {}
    for one in papers:
        other = said.setdefault((one.name, one.unit), one)
        assert abs(abs(one.value) - abs(other.value)) <= 1.02 * (one.off + other.off), (one, other)
        try:
            true = None if one.unit == "мм" else solved.value(one.name)
        except (PlanesError, KeyError):
            continue
        assert true is None or abs(abs(one.value) - abs(true)) <= 1.02 * one.off, (one, true)


@pytest.mark.few(0, slow=6)
@pytest.mark.parametrize("path", SCENES, ids=[p.stem for p in SCENES])
def test_each_row_of_a_sheet_is_that_of_the_results(path: Path) -> None:
    scene = load(str(path))
    drawn = note_position(scene, None, "ru")
    naming, found = Naming("ru", **scene_lettering(scene, drawn.plans)), 0
    rows: dict[str, list[list[str]]] = {}
    for row in rows_of_sheets(path):
        rows.setdefault(row[0], []).append(row)
    for plan in (p for p in drawn.plans.plan_names if p in ("velocity", "acceleration")):
        for vector, _, measured in drawn.measured_on(plan):
            for row in rows.get(naming.lettered_name(vector, plan), []):
                numbers = [number(text) for text in row[2:4]]
                if len(row) < 4 or number(row[1]) or any(n is None or n[2] for n in numbers):
                    continue
                found += 1
                for n, true in zip(numbers, (measured["mm"], measured["value"]), strict=True):
                    assert n and abs(abs(n[0]) - abs(true)) <= max(1.02 * n[1], HALF_OF_THIRD * abs(true)), (
                        row,
                        measured,
                    )
    assert found > 3 or not drawn.plans.mechanism.drive.velocity
