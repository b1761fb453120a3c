"""The owner and the plan of each sheet of a class: by its mark, else by the name of its file, else by the options."""

import math
from collections.abc import Callable
from dataclasses import dataclass, field

from planes.check.grading.evidence import MOST_CHANCE_OF_RANDOM_MARKS
from planes.check.grading.paper import ReadPaper, read_table
from planes.check.grading.prepared_plan import Asked, known_plans
from planes.check.handed_in import TABLE_SUFFIXES, HandedSheet, open_picture
from planes.check.outcome import Outcome, check
from planes.check.saved_marks import saved_table_name
from planes.check.sheet_mark import SheetMark, read_mark_on_picture
from planes.course.handed_out import (
    HandedOut,
    Task,
    are_of_several_assignments,
    plan_in_file_name,
    variant_in_file_name,
)
from planes.course.numbers import main_answer_names
from planes.plans.statements.of_scene import scene_plans
from planes.scene import Scene
from planes.words import Phrase
from planes.words.errors import PlanesError, quoted_excerpt
from planes.words.frozen import frozen, replace

THUMBNAIL_WIDTH_PX = 300
ROUNDING_SHARE = 0.005  # of a number written with three digits
Asking = Callable[[Scene, str, float | None, float | None], Asked]


@frozen
class Glance:
    """A first look at a sheet: its mark, if any, and a small picture of it (JPEG)."""

    mark: SheetMark | None = None
    picture: bytes = b""
    blanks: int = 1  # on the picture, including one that is only partly visible


def preview_sheet(file: str, page: int | None = None) -> Glance:
    """The first look; :class:`PlanesError` for a file that cannot be opened."""
    picture = open_picture(file, page)
    if picture is None:
        return Glance()
    from planes.check.vision.image.opencv import cv, reduce_to_longest_side
    from planes.check.vision.image.picture import find_blanks

    small = cv().imencode(".jpg", reduce_to_longest_side(picture.grey, THUMBNAIL_WIDTH_PX)[0])[1]
    blanks = find_blanks(picture.grey).sheet_count if page is None else 1
    return Glance(read_mark_on_picture(picture.grey), bytes(small), blanks)


@dataclass
class Sorter:
    """Settles the question for each sheet. ``variant`` and ``plan`` are from the options, ``asking`` is the rest."""

    handed: HandedOut
    asking: Asking
    variant: str | None = None
    plan: str | None = None
    known: dict[tuple[object, ...], Asked] = field(default_factory=dict)

    def identify_question(self, sheet: HandedSheet, mark: SheetMark | None) -> tuple[Task, Asked, str]:
        """The task, the question, and the owner in words; :class:`PlanesError` where nothing identifies it."""
        stem = sheet.file.stem
        task = self._identify_task(sheet, mark)
        variant = (
            mark.variant if mark else variant_in_file_name(stem, task.scene_in_variant(None).variants) or self.variant
        )
        scene = task.scene_in_variant(variant)
        plan = (
            (mark.plan if mark else plan_in_file_name(stem, scene)) or self.plan or _plan_of_results_table(sheet, scene)
        )
        if not plan:
            raise PlanesError(Phrase("check_which_plan", file=sheet.name))
        value, mu = (mark.value, mark.mu) if mark else (None, None)
        key = task, scene.variant, plan, value, mu
        if key not in self.known:
            asked = self.asking(scene, plan, value, mu)
            self.known[key] = replace(asked, answers=main_answer_names(scene, value))
        return (
            task,
            self.known[key],
            owner_text(scene, mark, task.scene if are_of_several_assignments(self.handed.tasks) else ""),
        )

    def actual_owner(self, task: Task, asked: Asked, outcome: Outcome) -> str:
        """The student whose work it is, where it is not right for its own task and is right for one other's, in all of
        several results or in a whole plan; "" where nobody's."""
        paper = replace(outcome.paper, signs=[], notes=[])
        if outcome.verdict not in ("wrong", "unreadable") or not (paper.results or paper.spots):
            return ""
        others = [t for t in self.handed.tasks if t.scene == task.scene and t.student not in ("", task.student)]
        theirs = [
            t
            for t in others
            if _fits_other_task(outcome, replace(asked, scene=t.scene_in_variant(None), answers=()), paper, len(others))
        ]
        if len(theirs) == 1:
            return str(theirs[0].scene_in_variant(None).sheet.get("student", theirs[0].student))
        return ""

    def _identify_task(self, sheet: HandedSheet, mark: SheetMark | None) -> Task:
        task = self.handed.task_of_mark(mark) if mark else self.handed.task_of_file_name(sheet.file.stem)
        if task is None and mark:
            details = {"scene": quoted_excerpt(mark.scene), "student": quoted_excerpt(mark.student)}
            raise PlanesError(Phrase("check_other_mark", file=sheet.name, **details))
        if task is None and len(self.handed.tasks) == 1:
            task = self.handed.tasks[0]
        if task is None:
            own = saved_table_name(sheet.file) if sheet.file.suffix.lower() in TABLE_SUFFIXES else ""
            key = "check_marks_alone" if own else "check_whose_is_it"
            suffix = sheet.file.suffix
            raise PlanesError(Phrase(key, file=sheet.name, name=own, suffix=suffix))
        return task


def _fits_other_task(own: Outcome, asked: Asked, paper: ReadPaper, others: int) -> bool:
    """Whether a work that is wrong for its own task is right for another's: the whole plan, or the numbers.

    The numbers that are wrong for its own must be so near to the other's that none of ``others`` would fit by chance.
    """
    outcome = check(asked, paper)
    if paper.spots or not outcome.results:
        return outcome.verdict == "right"
    wrong = [s.figure.name for s in own.results.scored if s.verdict != "right"] if own.results else None
    scored = [s for s in outcome.results.scored if s.verdict == "right" and (wrong is None or s.figure.name in wrong)]
    shares = (min(2 * max(s.deviation_from_true / max(abs(s.true), 1e-12), ROUNDING_SHARE), 1.0) for s in scored)
    return outcome.verdict != "wrong" and others * math.prod(shares) < MOST_CHANCE_OF_RANDOM_MARKS


def _plan_of_results_table(sheet: HandedSheet, scene: Scene) -> str:
    """The plan for a table with results only: velocities, if there is such a plan; "" for any other sheet."""
    if sheet.file.suffix.lower() not in TABLE_SUFFIXES:
        return ""
    paper = read_table(sheet.file)
    plans = known_plans(scene_plans(scene))
    alone = paper.results and not (paper.spots or paper.segments)
    if alone:
        return next((p for p in plans if p == "velocity"), plans[0])
    return ""


def owner_text(scene: Scene, mark: SheetMark | None, assignment: str = "") -> str:
    """The student, the assignment if there are several, and the variant, as far as they are known."""
    student = str(scene.sheet.get("student", "")) or (mark.student if mark else "")
    return ", ".join(filter(None, (student, assignment, (mark.variant if mark else "") or scene.variant or "")))
