"""The rows of a class table, as plain data that a later run can read again.

Unreadable drawings come first, then those with parts not seen or not explained, then wrong ones, then right ones. Next
to a picture of each wrong place is one of the right construction.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import field, fields, replace

from planes.check.outcome import EXIT_STATUS_OF_VERDICT, Outcome
from planes.check.report import Checked
from planes.check.report.places import jpeg_data_address, thumbnail_jpeg, wrong_places
from planes.plans.measuring import plan_name_in_words, scene_lettering
from planes.words import Lang, capitalize_first_letter, join_sentences, say
from planes.words.frozen import frozen
from planes.words.names import PlanId
from planes.words.naming import Naming
from planes.words.records import Json

UNREADABLE_RANK, UNSURE_RANK, WRONG_RANK, RIGHT_RANK = range(4)
HEADING_KEYS = {
    "file": "check_file",
    "whose": "check_whose",
    "plan": "check_plan",
    "verdict": "check_verdict",
    "first": "check_mark",
    "said": "check_first",
}
"""The headings of columns, as keys of the table of words."""


@frozen
class ClassRow:
    """One drawing of a class: its owner, its outcome, the link to its report (or to itself), small pictures."""

    file: str
    verdict: str
    rank: int
    first: str = ""
    said: str = ""
    whose: str = ""
    plan: str = ""
    link: str = ""
    mistake: str = ""  # the sentence without its mark, if the mistake has a name
    picture: str = ""  # as a data: address
    places: list[Json] = field(default_factory=list)
    object: Json = field(default_factory=dict)  # the output of --json
    task: str = ""  # the file of its scene
    lettering: Json = field(default_factory=dict)  # the lettering of names on its sheets

    @classmethod
    def from_checked(cls, one: Checked, lang: Lang) -> ClassRow:
        """The row of an outcome."""
        outcome = one.found
        said = one.verdict_text(lang)
        bare = said.removeprefix(f"{one.read_from}: ").removeprefix(f"{one.file}: ")  # that has a separate column
        said = said if bare == said else capitalize_first_letter(bare)
        cause = (
            outcome.sentence.told(lang).removeprefix(f"{one.first_error_place}: ")
            if outcome and outcome.mistake
            else ""
        )
        return cls(
            file=one.file,
            verdict=one.verdict,
            rank=teacher_priority(one),
            first=one.first_error_place,
            said=said,
            whose=one.whose,
            plan=_plan_text(outcome, lang) if outcome else "",
            link=one.report,
            mistake=cause if cause in said else "",
            picture=jpeg_data_address(thumbnail_jpeg(outcome, one.picture)),
            places=wrong_places(outcome) if outcome else [],
            object=one.as_json(lang),
            lettering=scene_lettering(outcome.bench.asked.scene, outcome.bench.plans) if outcome else {},
        )

    @property
    def text_names(self) -> list[str]:
        """The names that may occur in its text."""
        results = (str(row["name"]) for row in self.object.get("results", ()))
        return [self.first, *(str(row["mark"]) for row in self.object.get("marks", ())), *results]

    @property
    def plan_kind(self) -> str:
        """The kind of its plan, "" if unknown."""
        if "plan" in self.object:
            return PlanId.read(self.object["plan"]).kind
        return ""

    @property
    def plan_task_and_student(self) -> tuple[str, str, str]:
        """The plan, and the task and student it belongs to."""
        return self.task, self.whose, self.plan

    def with_text(self, more: str) -> ClassRow:
        """The same row with an additional text."""
        if more:
            return replace(self, said=join_sentences([self.said, more]))
        return self

    @classmethod
    def from_saved(cls, data: Json) -> ClassRow:
        """A row saved by an earlier run; TypeError or ValueError if it is none."""
        if set(data) != {f.name for f in fields(cls)} or data["verdict"] not in EXIT_STATUS_OF_VERDICT:
            raise ValueError("no row of a class")
        return cls(**data)


def _plan_text(outcome: Outcome, lang: Lang) -> str:
    if outcome.has_only_results:
        return say("check_numbers", lang)
    return plan_name_in_words(outcome.bench.plan, lang)


def teacher_priority(one: Checked) -> int:
    """Its priority for a teacher."""
    if one.verdict == "unreadable" or one.found is None:
        return UNREADABLE_RANK
    doubtful = one.found.unseen or (one.verdict == "wrong" and one.found.mistake is None)
    if doubtful:
        return UNSURE_RANK
    if one.verdict == "wrong":
        return WRONG_RANK
    return RIGHT_RANK


def table_columns(rows: Sequence[ClassRow], lang: Lang) -> tuple[list[str], list[str]]:
    """The keys and headings of a table's columns: the owner only where known, the plan only where they differ."""
    whose, plans = ({getattr(row, key) for row in rows} - {""} for key in ("whose", "plan"))
    more = ["whose"] * bool(whose) + ["plan"] * (bool(whose) or len(plans) > 1)
    keys = ["file", *more, "verdict", "first", "said"]
    return keys, [say(HEADING_KEYS[key], lang) for key in keys]


def row_cells(row: ClassRow, keys: Sequence[str], lang: Lang) -> list[str]:
    """The cells of a row in those columns."""
    shown = {"verdict": say(f"verdict_{row.verdict}", lang)}
    return [shown.get(key) or str(getattr(row, key)) for key in keys]


def cells_as_typed(row: ClassRow, cells: Sequence[str], lang: Lang) -> list[str]:
    """The cells of a row with names as people type them."""
    naming = Naming(lang, **row.lettering)
    return [naming.retell_in_typed_names(cell, row.text_names) for cell in cells]
