"""The teacher's table: everybody's variant and main answers, as CSV for programs and as blocks of a page."""

import json
from collections.abc import Iterator, Mapping, Sequence

from planes.course.numbers import main_answers
from planes.course.papers import parameter_unit
from planes.course.students import Share
from planes.scene import loads
from planes.scene.settings import Words
from planes.solving.document import Blocks, DocumentTable, Heading, Paragraph
from planes.words import Lang, say
from planes.words.frozen import frozen
from planes.words.lettering import parameter_lettering
from planes.words.names import NamePair, NumbersByName
from planes.words.records import csv_text as csv_of
from planes.words.units import number_text

LARGEST_ZERO_ANSWER = 1e-9


@frozen
class StudentRow:
    """One row: whose, the numbers, the answers by name and unit, or why there are none."""

    share: Share
    group: str
    title: Words
    numbers: NumbersByName
    found: Mapping[NamePair, float]
    fault: str

    @classmethod
    def of_share(cls, share: Share, text: str, key: str, fault: str) -> "StudentRow":
        """The row of a share, from its scene and its key."""
        scene = loads(text or share.assignment.text, "scene.yaml")
        if fault:
            return cls(share, share.student.group, scene.title, {}, {}, fault)
        answers = main_answers(scene, json.loads(key))
        return cls(share, str(scene.sheet.get("group", "")), scene.title, scene.parameters, answers, "")


def varied_parameters(rows: Sequence[StudentRow]) -> list[str]:
    """The parameters of an assignment that differ between students."""
    names = dict.fromkeys(name for row in rows for name in row.numbers)
    return [n for n in names if len({row.numbers.get(n) for row in rows if not row.fault}) > 1]


def rows_by_assignment(rows: Sequence[StudentRow]) -> dict[str, list[StudentRow]]:
    """The rows of each assignment."""
    names = dict.fromkeys(row.share.assignment.name for row in rows)
    return {name: [row for row in rows if row.share.assignment.name == name] for name in names}


def answer_names_and_units(rows: Sequence[StudentRow]) -> list[NamePair]:
    """Names and units of all answers of some rows."""
    return list(dict.fromkeys(key for row in rows for key in row.found))


def as_csv(rows: Sequence[StudentRow], lang: Lang) -> str:
    """A row for everybody, a column for every number and answer; numbers in the format of programs."""
    numbers = list(dict.fromkeys(n for own in rows_by_assignment(rows).values() for n in varied_parameters(own)))
    answers = answer_names_and_units(rows)
    heads = [say(k, lang) for k in ("sum_student", "sum_group", "sum_assignment", "sum_variant")]
    units = [f"{n} [{unit}]" if (unit := parameter_unit(n, lang)) else n for n in numbers]
    table = [[*heads, *units, *(f"{n} [{say(u, lang)}]" for n, u in answers), say("sum_fault", lang)]]
    for row in rows:
        who = [row.share.student.name, row.group, row.share.assignment.name, variant_text(row, lang)]
        said = (f"{row.numbers[n]:.10g}" if n in row.numbers else "" for n in numbers)
        answer_cells = (repr(row.found[key]) if key in row.found else "" for key in answers)
        table.append([*who, *said, *answer_cells, row.fault])
    return csv_of(table)


def variant_text(row: StudentRow, lang: Lang) -> str:
    """The name of the variant, or that the numbers are the student's own."""
    return row.share.variant or say("sum_own", lang)


def as_blocks(rows: Sequence[StudentRow], title: str, lang: Lang) -> Blocks:
    """Two tables for each assignment: numbers and answers."""
    yield Heading(title or say("sum_title", lang), 0)
    for name, lines in rows_by_assignment(rows).items():
        own = [row for row in lines if not row.fault]
        names = varied_parameters(lines)
        answers = answer_names_and_units(lines)
        yield Heading(lines[0].title.get(lang) or name)
        heads = (say("sum_student", lang), say("sum_variant", lang))
        units = (
            f"{parameter_lettering(n)}, {unit}" if (unit := parameter_unit(n, lang)) else parameter_lettering(n)
            for n in names
        )
        numbers = (tuple(number_text(row.numbers[n], lang, 6) for n in names) for row in own)
        whose = [(row.share.student.name, variant_text(row, lang)) for row in own]
        yield from _table_blocks("sum_numbers", (*heads, *units), whose, numbers, lang)
        units = (f"⟨{n}⟩, {say(u, lang)}" for n, u in answers)
        answer_rows = (tuple(_answer_text(row.found.get(k), lang) for k in answers) for row in own)
        yield from _table_blocks("sum_answers", (*heads, *units), whose, answer_rows, lang)
        yield from (Paragraph(f"{row.share.student.name}: {row.fault}") for row in lines if row.fault)


def _answer_text(value: float | None, lang: Lang) -> str:
    """An answer for people: rounding noise is shown as zero."""
    if value is None:
        return "—"
    return number_text(0.0 if abs(value) <= LARGEST_ZERO_ANSWER else value, lang)


def _table_blocks(
    key: str, head: tuple[str, ...], whose: list[tuple[str, str]], cells: Iterator[tuple[str, ...]], lang: Lang
) -> Blocks:
    if whose and len(head) > len(whose[0]):
        yield DocumentTable(say(key, lang), (head, *(w + c for w, c in zip(whose, cells, strict=True))))
