"""One student's work: numbers drawn, the scene written (the assignment's with other numbers for its parameters, as a
new file), the mechanism solved. A task for any worker."""

import json
import math
import traceback
from collections.abc import Mapping
from pathlib import Path

from planes.check.grading.figures import quantity_figure
from planes.course import Course, ParameterChoice
from planes.course.ledger import program_fingerprint
from planes.course.papers import given_data_table
from planes.course.random_numbers import draw_numbers, parameter_choices, seeded_generator
from planes.course.students import Share
from planes.plans.force.derived import unit_key_of_value
from planes.plans.quantities import quantities_by_name
from planes.plans.statements.of_scene import names_to_find
from planes.scene import Scene, loads
from planes.scene.mechanism import FRAME
from planes.scene.source import Nodes, SourceScalar
from planes.scene.vectors import Statement
from planes.scene.writing import scene_text_with_numbers
from planes.solving import solve
from planes.words import Lang, Phrase
from planes.words.errors import PlanesError
from planes.words.frozen import frozen, replace
from planes.words.names import NamePair, NamesByName, NameTuple
from planes.words.records import Json
from planes.words.units import UNIT_OF_RATE_LETTER

Answers = dict[NamePair, float]  # by name and unit
SETTLED_FILE_NAME = "scene.yaml"
SCALE_KEYS_LEFT_OUT = ("plans",)
"""Keys of a scene that are left out where numbers are drawn: its scales were chosen for its own."""


@frozen
class Question:
    """All inputs for a student's numbers; ``copy`` counts how often they coincided with somebody else's."""

    text: str
    file: str
    variant: str | None
    draw: Mapping[str, ParameterChoice] | None
    sharpness_deg: float
    seed: int
    student: NamePair
    sheet: Nodes
    lang: Lang
    copy: int = 0
    program: str = ""  # the worker's program must match, where it may be another


@frozen
class SettledNumbers:
    """A student's scene and its solution as JSON; or the sentence why there is none."""

    scene: str = ""
    key: str = ""
    fault: str = ""


def worker_question(course: Course, share: Share, lang: Lang) -> Question:
    """The question to a worker for one share."""
    s = share.student
    said = {"student": s.name, "group": s.group}
    return Question(
        text=share.assignment.text,
        file=str(share.assignment.file),
        variant=share.variant,
        draw=None if course.draw is None else dict(course.draw),
        sharpness_deg=course.sharpness_deg,
        seed=course.seed,
        student=(s.name, s.group),
        sheet={**course.sheet, **{k: SourceScalar(v, 0, False) for k, v in said.items() if v}},
        lang=lang,
    )


def settle_numbers(q: Question) -> SettledNumbers:
    """Draw the numbers if they are not given, write the scene, solve it."""
    if q.program and q.program != program_fingerprint():
        return SettledNumbers(fault=Phrase("course_other_program").told(q.lang))
    try:
        return _settled_numbers(q)
    except Exception as error:
        return SettledNumbers(fault=missing_document_reason(error, q.lang))


def _settled_numbers(q: Question) -> SettledNumbers:
    numbers = {} if q.variant else draw_student_numbers(q)
    text = scene_text_with_numbers(q.text, q.file, q.variant, numbers, q.sheet, SCALE_KEYS_LEFT_OUT if numbers else ())
    solved = solve(scene := loads(text, SETTLED_FILE_NAME), lang=q.lang)
    if not solved.positions:
        return SettledNumbers(fault=solved.failed[0]["error"])
    original = replace(scene, file=q.file, where=loads(q.text, q.file, q.variant).where)
    given_data_table(original, solved.positions[0], q.lang)  # a sheet must be able to state it
    return SettledNumbers(text, json.dumps(solved.json(), ensure_ascii=False, allow_nan=False, indent=1) + "\n")


def missing_document_reason(error: Exception, lang: Lang) -> str:
    """Why somebody's document is missing, as one sentence, even for a fault of the program: the others still get
    theirs."""
    if isinstance(error, PlanesError):
        return error.told(lang)
    last = traceback.extract_tb(error.__traceback__)[-1]
    place = f"{Path(last.filename).name}:{last.lineno}"
    text = " ".join(str(error).split())
    return Phrase("course_slip", kind=type(error).__name__, text=text, place=place).told(lang)


def draw_student_numbers(q: Question) -> NamesByName:
    """One student's numbers."""

    def make(numbers: Mapping[str, str]) -> Scene:
        return loads(scene_text_with_numbers(q.text, q.file, None, numbers, {}, SCALE_KEYS_LEFT_OUT), q.file)

    chance = seeded_generator(q.seed, *q.student, q.file.rpartition("/")[2], q.copy)
    return draw_numbers(parameter_choices(q.text, q.file, q.draw), make, q.sharpness_deg, chance)


def main_answers(scene: Scene, key: Json) -> Answers:
    """The results a teacher compares first, by name and unit: links' ω and ε, sliders' v and a, the balancing load; of
    stated vectors the unknown ones, and the values."""
    answers: Answers = {}
    if scene.statement is not None:
        return _vector_answers(scene, scene.statement, key)
    if not key["positions"] or scene.mechanism is None:
        return answers
    at = key["positions"][0]
    m = scene.mechanism
    for name, link in m.links.items():
        rates = at.get("links", {}).get(name, {})
        slide = at.get("slides", {}).get(name)
        if link.slides and slide and m.owner_of_guide(link.slides.guide) == FRAME:
            point = at.get("points", {}).get(link.first_point, {})
            answers |= {
                (f"{k}_{link.first_point}", UNIT_OF_RATE_LETTER[k]): math.hypot(*point[k]) for k in "va" if k in point
            }
        elif name != m.drive.link and not link.slides:
            answers |= {(f"{k}_{name}", UNIT_OF_RATE_LETTER[k]): rates[k] for k in ("omega", "epsilon") if k in rates}
    for kind, unit, letter in (("moment", "N·m", "M"), ("force", "N", "Fb")):
        if (value := at.get(f"balancing_{kind}")) is not None:
            answers[f"{letter}_{m.drive.link}", unit] = value
    return answers


def main_answer_names(scene: Scene, value: float | None = None, plan: str = "") -> NameTuple:
    """The names of the main answers at a position of the drive, by default the scene's, or of those from one plan;
    empty where the position fails, and where a scene asks for other results."""
    if scene.find:
        return ()
    solved = solve(scene, None if value is None else [value])
    names = [name for name, _ in main_answers(scene, solved.json())] if solved.positions else []
    known = quantities_by_name(solved.plans) if plan else {}
    return tuple(n for n in names if not plan or (n in known and quantity_figure(n, known[n], 0.0).plan == plan))


def _vector_answers(scene: Scene, stated: Statement, key: Json) -> Answers:
    """The lengths of the vectors asked for or without a given length, and the values."""
    units = {s["name"]: s["unit"] for plan in key["plans"].values() for s in plan["segments"].values()}
    given = {n for n, v in stated.vectors.items() if v.value is not None}
    asked = names_to_find(scene) or [*(n for n in stated.vectors if n not in given), *stated.values]
    answers = {(n, units[n]): float(key["vectors"][n]["value"]) for n in asked if n in key["vectors"] and n in units}
    return answers | {(n, unit_key_of_value(n)): float(key["values"][n]) for n in asked if n in key.get("values", {})}
