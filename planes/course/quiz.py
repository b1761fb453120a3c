"""Answers as questions for a learning platform: the data, the questions, and the tolerance of a pencil."""

import base64
import json
import math
import re
from collections import defaultdict
from collections.abc import Callable, Iterable, Sequence
from functools import cached_property
from itertools import zip_longest

from planes.accuracy.errors import add_errors_to_results
from planes.course.numbers import main_answers
from planes.drafting import skill
from planes.drafting.instruments import Pencil
from planes.scene import Scene
from planes.solving import solve
from planes.words import Lang, Phrase, say, with_decimal_sign
from planes.words.errors import PlanesError
from planes.words.frozen import frozen, replace
from planes.words.lettering import GREEK_LETTER_BY_NAME, without_index_markup
from planes.words.names import NameTuple, letter_of, split_value_name
from planes.words.records import Json

PUPIL_PENCIL = Pencil(skill.STUDENT_SKILL.point_mm, skill.STUDENT_SKILL.ray_deg, skill.RULER_RESOLUTION_MM)
"""A student's pencil: it sets the tolerance of answers."""
TOLERANCE_SIGMAS = 2.0
LEAST_TOLERANCE_SHARE = 0.03
"""What is let pass: two standard deviations of that pencil, or this part of the value."""
_PLANS_BY_LETTER = {"v": "velocity", "omega": "velocity", "a": "acceleration", "epsilon": "acceleration"}
"""The plans that main answers are found by; others are loads."""
_GREEK_LETTER_NAMES = {letter: name for name, letter in GREEK_LETTER_BY_NAME.items()}


@frozen
class QuizItem:
    """One question: the name of the result, its value in ``unit`` and its tolerance."""

    name: str
    unit: str
    value: float
    tolerance: float

    @property
    def platform_key(self) -> str:
        """Its name in letters valid on any platform."""
        return self.name.replace("^", "")


@frozen
class QuizGiven:
    """A given number: its lettered name, its value, the key of its unit."""

    name: str
    value: float
    unit: str

    @property
    def platform_key(self) -> str:
        """Its name in letters valid on any platform."""
        first = self.name.partition(" = ")[0].replace("∠", "angle_").replace("–", "_")
        spelt = "".join(_GREEK_LETTER_NAMES.get(letter, letter) for letter in first if letter not in "{}^")
        return re.sub(r"[^A-Za-z0-9_]", lambda m: f"u{ord(m[0]):x}", spelt)


@frozen
class Quiz:
    """All questions of one student: whose, for which assignment, the numbers given, further conditions (``said``, with
    indices in braces), the questions, the scheme."""

    student: str
    group: str
    assignment: str
    title: str
    place: str
    given: tuple[QuizGiven, ...]
    said: str
    questions: tuple[QuizItem, ...] = ()
    picture: bytes = b""

    def json(self) -> Json:
        """The quiz as stored."""
        own = {**vars(self), **{k: [*map(vars, getattr(self, k))] for k in ("given", "questions")}}
        return {**own, "picture": base64.b64encode(self.picture).decode()}

    @classmethod
    def from_stored_text(cls, text: str) -> "Quiz":
        """A stored quiz."""
        held = json.loads(text)
        kinds = {"given": QuizGiven, "questions": QuizItem}
        lists = {key: tuple(kind(**one) for one in held[key]) for key, kind in kinds.items()}
        return cls(**{**held, **lists, "picture": base64.b64decode(held["picture"])})


def quiz_items(scene: Scene, lang: Lang, plans: Sequence[str] = ()) -> tuple[QuizItem, ...]:
    """The main answers of a scene, of a mechanism those of some ``plans`` (all, if none is named), each with what a
    pupil's pencil makes of it."""
    exact = solve(scene, lang=lang)
    drawn = solve(scene, None, PUPIL_PENCIL, lang)
    if not exact.positions or not drawn.positions:
        raise PlanesError(Phrase("quiz_not_drawn", why=(exact.failed or drawn.failed)[0]["error"]))
    add_errors_to_results(drawn, PUPIL_PENCIL)
    errors = drawn.positions[0].results["errors"]
    answers = main_answers(scene, exact.json())
    if plans and scene.mechanism:
        answers = {
            key: value for key, value in answers.items() if _PLANS_BY_LETTER.get(letter_of(key[0]), "force") in plans
        }
    return tuple(_quiz_item(name, unit, value, errors) for (name, unit), value in answers.items())


def _quiz_item(name: str, unit: str, value: float, errors: Json) -> QuizItem:
    sigma = answer_deviation(name, errors)
    value = 0.0 if abs(value) < 1e-9 else value
    return QuizItem(
        name, unit, value, float(f"{max(TOLERANCE_SIGMAS * sigma, LEAST_TOLERANCE_SHARE * abs(value), 1e-6):.3g}")
    )


def answer_deviation(name: str, errors: Json) -> float:
    """One standard deviation of a main answer."""
    letter, index, _ = split_value_name(name)
    stated = {**errors.get("vectors", {}), **errors.get("values", {})}
    if name in stated or letter not in _PLANS_BY_LETTER:
        sigmas = stated.get(name, errors.get("balancing_moment", errors.get("balancing_force")))
    else:
        sigmas = errors["points" if letter in ("v", "a") else "links"][index][letter]
    return math.hypot(*(x or 0.0 for x in (sigmas if isinstance(sigmas, list) else [sigmas])))


# of a value: with this tolerance both half and double the value would pass, so the question is useless
MOST_TOLERANCE_SHARE = 0.5


def too_uncertain_results(quizzes: Iterable[Quiz]) -> dict[str, list[str]]:
    """By assignment the results that are not asked for: with some student's numbers the pencil's error may be half of
    one."""
    names_by_assignment = dict[str, dict[str, None]]()
    for quiz in quizzes:
        wide = [q.name for q in quiz.questions if q.tolerance > MOST_TOLERANCE_SHARE * abs(q.value)]
        names_by_assignment.setdefault(quiz.assignment, {}).update(dict.fromkeys(wide))
    return {name: list(names) for name, names in names_by_assignment.items() if names}


def judgeable_quizzes(quizzes: Sequence[Quiz]) -> list[Quiz]:
    """The quizzes without unsuitable questions; empty for an assignment with none left."""
    wide = too_uncertain_results(quizzes)
    asked = [
        replace(z, questions=tuple(q for q in z.questions if q.name not in wide.get(z.assignment, ()))) for z in quizzes
    ]
    return [quiz for quiz in asked if quiz.questions]


def quizzes_by_assignment(quizzes: Iterable[Quiz]) -> dict[str, list[Quiz]]:
    """The quizzes of each assignment."""
    quizzes_of = defaultdict(list)
    for quiz in quizzes:
        quizzes_of[quiz.assignment].append(quiz)
    return quizzes_of


@frozen
class Pool:
    """One question for all students of an assignment (or for one): the common text, and the numbers of each."""

    group: Sequence[Quiz]
    lang: Lang

    @cached_property
    def numbers_by_key(self) -> dict[str, list[float]]:
        """Everybody's given numbers by their keys; 0 for students who lack one."""
        keys = dict.fromkeys(n.platform_key for quiz in self.group for n in quiz.given)
        tables = [{n.platform_key: n.value for n in quiz.given} for quiz in self.group]
        return {key: [table.get(key, 0.0) for table in tables] for key in keys}

    @cached_property
    def varied_numbers(self) -> dict[str, list[float]]:
        """Those that differ between students, including those of laws."""
        own = {key: values for key, values in self.numbers_by_key.items() if len({*values}) > 1}
        return own | {
            f"law_{k}": [*map(_read_number, column)] for k, column in self.columns_of_conditions if len({*column}) > 1
        }

    @cached_property
    def columns_of_conditions(self) -> list[tuple[int, NameTuple]]:
        """The numbers in the conditions, as each student has them."""
        return list(enumerate(zip(*(_NUMBER_PATTERN.findall(quiz.said) for quiz in self.group), strict=True)))

    def task_text(self, mark: Callable[[str], str]) -> str:
        """The work and the data, indices in braces; ``mark`` writes a number that differs between students."""
        self.check_same_conditions()
        named = {n.platform_key: n for quiz in self.group for n in quiz.given}
        given_texts = []
        for key, values in self.numbers_by_key.items():
            value = mark(key) if key in self.varied_numbers else with_decimal_sign(f"{values[0]:.6g}", self.lang)
            unit = named[key].unit
            given_texts.append(f"{named[key].name} = {value}{' ' + say(unit, self.lang) if unit else ''}")
        said = (
            mark(f"law_{k}") if f"law_{k}" in self.varied_numbers else column[0]
            for k, column in self.columns_of_conditions
        )
        words = _NUMBER_PATTERN.split(self.group[0].said)
        more = "".join(x for pair in zip_longest(words, said, fillvalue="") for x in pair)
        return f"{say('quiz_task', self.lang, numbers=', '.join(given_texts))} {more}".strip()

    def check_same_conditions(self) -> None:
        """:class:`PlanesError` where students have different conditions, not only different numbers."""
        first = self.group[0]
        for other in self.group[1:]:
            names = {n.platform_key: n for n in first.given + other.given}
            alone = {*(n.platform_key for n in first.given)} ^ {*(n.platform_key for n in other.given)}
            apart = [names[one].name for one in alone if names[one].unit == "m" and letter_of(one) != "e"]
            if apart or _NUMBER_PATTERN.sub("", first.said) != _NUMBER_PATTERN.sub("", other.said):
                which = ", ".join(map(without_index_markup, apart)) or Phrase("quiz_words")
                raise PlanesError(Phrase("quiz_apart", name=first.assignment, which=which, place=other.place))


_NUMBER_PATTERN = re.compile(r"(?<![\w{^.,])[-−]?\d+(?:[.,]\d+)?(?![\w}])")


def _read_number(number: str) -> float:
    return float(number.replace("−", "-").replace(",", "."))
