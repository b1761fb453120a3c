"""Numbers changed by hand, written back into the text: in a parameter, or in the place itself.

Trial shows which number of the text changes which number of the mechanism: each is changed a little and the scene read
again. So a length given by an expression is reached through its parameters.
"""

import math
import re
from collections.abc import Mapping, Sequence
from contextlib import suppress
from types import MappingProxyType

from planes.drafting.steps.settling import solve_by_elimination
from planes.lesson.knobs import Knobs
from planes.scene import loads
from planes.scene.source import SourceScalar, parse_yaml, walk_nodes
from planes.solving import plans_and_requested_results
from planes.studio.text_edits import Edited
from planes.words import Phrase
from planes.words.errors import PlanesError
from planes.words.frozen import frozen
from planes.words.names import NumbersByName, given_name_without_suffix, is_scale, plan_of_scale
from planes.words.units import mu_text

TRIAL_STEP_SHARE = 1e-3  # relative: trial change of a number
MOST_NEWTON_ROUNDS = 8
CONVERGENCE_SHARE = 1e-9
SAME_AS_WRITTEN_SHARE = 1e-4  # relative: closer than this two numbers are the same as written
HAND_SET_DIGITS = 5  # digits written for a number set by hand
ALL_DIGITS = 17  # all that a number has
NUMBER_PATTERN = re.compile(r"([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)(\s*[^\d\s].*)?")
OPTIONAL_NUMBER_PATHS = (("drive", "epsilon"), ("drive", "acceleration"))  # where they are zero
PARAMETER_PATTERN = re.compile(r"(?!pi\b)\b[^\W\d]")
SCENE_PARTS_WITH_NUMBERS = ("parameters", "frame", "links", "drive", "loads", "gravity", "vectors", "friction")


@frozen
class NumberInText:
    """A number in the text, with the unit it was written in."""

    path: tuple[str, ...]
    value: float
    unit: str = ""


def changeable_numbers(text: str) -> dict[str, float]:
    """The numbers of a scene that a reader may change, by name, SI and degrees."""
    plans, _ = plans_and_requested_results(loads(text), shown=True)
    given = {**plans.given, **plans.drive_givens_at(plans.drive.position)}
    knobs = Knobs(plans, given)
    names = {plans.drive_given_name, *(knob["given"] for knob in knobs.offered_numbers)}
    return {name: value for name, value in knobs.values_in_scene.items() if name in names}


def text_with_numbers(text: str, wanted: NumbersByName, said: Mapping[str, str] = MappingProxyType({})) -> Edited:
    """The text with the mechanism's numbers as wanted, in the figures of a hand where it ``said`` them (310*0.001);
    :class:`PlanesError` where no number of the text can achieve that."""
    edited = Edited(text)
    for name, value in wanted.items():
        if is_scale(name):
            plan = plan_of_scale(name)
            edited = edited.with_value(("plans", plan, "mu"), mu_text(value, plan))
    rest = {name: value for name, value in wanted.items() if not is_scale(name)}
    return _text_solved_for_numbers(edited, rest, said) if rest else edited


def _numbers_in_text(text: str) -> list[NumberInText]:
    """The numbers of the text that a mechanism depends on, in its order; then those that it may leave out."""
    numbers = []
    for path, node, _ in walk_nodes(parse_yaml(text, "")):
        if (
            path
            and path[0] in SCENE_PARTS_WITH_NUMBERS
            and isinstance(node, SourceScalar)
            and (digits := NUMBER_PATTERN.fullmatch(node.text))
        ):
            numbers.append(NumberInText(path, float(digits[1]), digits[2] or ""))
    there = {figure.path for figure in numbers}
    return numbers + [NumberInText(path, 0.0) for path in OPTIONAL_NUMBER_PATHS if path not in there]


Slopes = Mapping[NumberInText, NumbersByName]


def _text_solved_for_numbers(edited: Edited, wanted: NumbersByName, said: Mapping[str, str]) -> Edited:
    """One number after another, by Newton's steps in the numbers of the text that change it; some are already right
    through an expression."""
    home = changeable_numbers(edited.text)
    figures = _numbers_in_text(edited.text)
    wanted = {
        name: value
        for name, value in wanted.items()
        if name in home and _relative_difference(home[name], value) > CONVERGENCE_SHARE
    }
    slopes = {
        f: _rates_of_numbers(edited, f, home) for f in figures if f.path[-1] in map(given_name_without_suffix, wanted)
    }
    chosen: dict[str, NumberInText] = {}
    solved = edited
    for name, value in wanted.items():
        now = changeable_numbers(solved.text) if chosen else home
        if _relative_difference(now.get(name, math.inf), value) <= SAME_AS_WRITTEN_SHARE:
            continue
        if not (able := _numbers_that_affect(name, slopes, chosen)) and len(slopes) < len(figures):
            slopes |= {f: _rates_of_numbers(edited, f, home) for f in figures if f not in slopes}
            able = _numbers_that_affect(name, slopes, chosen)
        if not able:
            raise PlanesError(Phrase("studio_no_number", names=given_name_without_suffix(name)))
        chosen[name] = min(able, key=lambda f: _rank_of_number(f, slopes[f], wanted))
        solved = _text_reaching_values(edited, [*chosen.values()], {n: wanted[n] for n in chosen})
    for name, figure in chosen.items():
        typed = (
            solved.with_value(figure.path, said[name])
            if name in said and not PARAMETER_PATTERN.search(figure.unit)
            else solved
        )
        with suppress(PlanesError):
            solved = (
                typed
                if _relative_difference(changeable_numbers(typed.text)[name], wanted[name]) <= SAME_AS_WRITTEN_SHARE
                else solved
            )
    return solved


def _relative_difference(one: float, other: float) -> float:
    """The difference of two numbers relative to the larger; absolute for angles and places near zero."""
    return abs(one - other) / max(abs(one), abs(other), 1e-3)


def _numbers_that_affect(name: str, slopes: Slopes, chosen: Mapping[str, NumberInText]) -> list[NumberInText]:
    return [f for f, moved in slopes.items() if moved.get(name) and f not in chosen.values()]


def _rank_of_number(figure: NumberInText, moved: NumbersByName, wanted: NumbersByName) -> tuple[bool, int, bool]:
    """Zeros stay; then numbers that change the fewest others, the parameters first."""
    return not figure.value, len(moved.keys() - wanted.keys()), figure.path[0] != "parameters"


def _rates_of_numbers(edited: Edited, figure: NumberInText, home: NumbersByName) -> dict[str, float]:
    """The numbers of the mechanism that change with one of the text, and their rates."""
    step = TRIAL_STEP_SHARE * (abs(figure.value) or 1.0)
    try:
        there = changeable_numbers(edited.with_value(figure.path, f"{figure.value + step!r}{figure.unit}").text)
    except PlanesError:
        return {}
    return {n: (there[n] - v) / step for n, v in home.items() if n in there and abs(there[n] - v) > 1e-9 * abs(step)}


def _text_reaching_values(edited: Edited, chosen: Sequence[NumberInText], wanted: NumbersByName) -> Edited:
    """The text with numbers that give the wanted ones, as closely as their digits allow."""
    values = [f.value for f in chosen]

    def text_of(numbers: Sequence[float], digits: int = ALL_DIGITS) -> Edited:
        text = edited
        for figure, value in zip(chosen, numbers, strict=True):
            text = text.with_value(figure.path, f"{value:.{digits}g}{figure.unit}")
        return text

    for _ in range(MOST_NEWTON_ROUNDS):
        home = changeable_numbers(text_of(values).text)
        miss = [v - home[n] for n, v in wanted.items()]
        if all(abs(m) <= CONVERGENCE_SHARE * max(abs(v), 1.0) for m, v in zip(miss, wanted.values(), strict=True)):
            break
        columns = []
        for k, value in enumerate(values):
            step = TRIAL_STEP_SHARE * (abs(value) or 1.0)
            there = changeable_numbers(text_of([v + step * (j == k) for j, v in enumerate(values)]).text)
            columns.append([(there[n] - home[n]) / step for n in wanted])
        values = [v + by for v, by in zip(values, solve_by_elimination(columns, miss)[0], strict=True)]
    return text_of(values, HAND_SET_DIGITS)
