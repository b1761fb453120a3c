"""Answers as questions a learning platform can ask: what is given, what is asked, how far off a pencil may be."""

import base64
import json
import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from planes.accuracy.errors import add_errors
from planes.course.numbers import main_answers
from planes.drafting import skill
from planes.drafting.instruments import Pencil
from planes.scene import Scene
from planes.solving import solve
from planes.words import Lang, Phrase, say
from planes.words.errors import PlanesError
from planes.words.names import parts_of
from planes.words.records import Json

PUPIL = Pencil(skill.HAND.point_mm, skill.HAND.ray_deg, skill.RULER_MM)
"""A pupil's pencil: by it answers are allowed to be off."""
SIGMAS, LEAST = 2.0, 0.03
"""What is let pass: two standard deviations of that pencil, or this part of the value."""


@dataclass(frozen=True)
class QuizItem:
    """One number that is asked: the name of the result, its value in ``unit`` and how far off an answer may be."""

    name: str
    unit: str
    value: float
    tolerance: float

    @property
    def key(self) -> str:
        """Its name in letters any platform takes."""
        return self.name.replace("^", "")


@dataclass(frozen=True)
class Quiz:
    """All questions of one student: whose, of which assignment, the numbers given, the questions, the scheme."""

    student: str
    group: str
    assignment: str
    title: str
    place: str
    given: dict[str, float]
    questions: tuple[QuizItem, ...]
    picture: bytes

    def json(self) -> Json:
        """As it is kept."""
        own = {**vars(self), "questions": [vars(q) for q in self.questions]}
        return {**own, "picture": base64.b64encode(self.picture).decode()}

    @classmethod
    def read(cls, text: str) -> "Quiz":
        """What was kept."""
        held: dict[str, Any] = json.loads(text)
        questions = tuple(QuizItem(**q) for q in held.pop("questions"))
        return cls(**{**held, "picture": base64.b64decode(held["picture"]), "questions": questions})


def questions(scene: Scene, lang: Lang) -> tuple[QuizItem, ...]:
    """The main answers of a scene, each with what a pupil's pencil makes of it."""
    exact, drawn = solve(scene, lang=lang), solve(scene, None, PUPIL, lang)
    if not exact.positions or not drawn.positions:
        raise PlanesError(Phrase("quiz_not_drawn", why=(exact.failed or drawn.failed)[0]["error"]))
    add_errors(drawn, PUPIL)
    errors = drawn.positions[0].results["errors"]
    answers = main_answers(scene, exact.json())
    return tuple(_question(name, unit, value, errors) for (name, unit), value in answers.items())


def _question(name: str, unit: str, value: float, errors: Json) -> QuizItem:
    sigma = error_of(name, errors)
    value = 0.0 if abs(value) < 1e-9 else value
    return QuizItem(name, unit, value, float(f"{max(SIGMAS * sigma, LEAST * abs(value), 1e-6):.3g}"))


def error_of(name: str, errors: Json) -> float:
    """One standard deviation of a main answer."""
    if name in errors.get("vectors", {}):
        return math.hypot(*(x or 0.0 for x in errors["vectors"][name]))
    if name in errors.get("values", {}):
        return float(errors["values"][name] or 0.0)
    letter, of, _ = parts_of(name)
    if letter in ("omega", "epsilon"):
        return float(errors["links"][of][letter] or 0.0)
    if letter in ("v", "a"):
        return math.hypot(*(x or 0.0 for x in errors["points"][of][letter]))
    return float(errors.get("balancing_moment") or errors.get("balancing_force") or 0.0)


def varied(quizzes: Sequence[Quiz]) -> list[str]:
    """The given numbers that are not the same for everybody."""
    names = dict.fromkeys(name for quiz in quizzes for name in quiz.given)
    return [name for name in names if len({quiz.given.get(name) for quiz in quizzes}) > 1]


def by_assignment(quizzes: Iterable[Quiz]) -> dict[str, list[Quiz]]:
    """The quizzes of each assignment."""
    found: dict[str, list[Quiz]] = {}
    for quiz in quizzes:
        found.setdefault(quiz.assignment, []).append(quiz)
    return found


def task_text(given: Iterable[tuple[str, str]], lang: Lang) -> str:
    """What is to be done, with the numbers given, each as (name, value)."""
    numbers = ", ".join(f"{name} = {value}" for name, value in given)
    return say("quiz_task", lang, numbers=numbers)
