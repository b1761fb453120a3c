"""Numbers changed by hand, written back into the text: in a parameter, or in the place itself.

Trial shows which number of the text changes which number of the mechanism: each is changed a little and the scene read
again. So a length given by an expression is reached through its parameters.
"""

import math
import re
from collections.abc import Mapping, Sequence
from contextlib import suppress
from types import MappingProxyType

from planes.drafting.steps.settling import eliminated
from planes.lesson.knobs import Knobs
from planes.scene import loads
from planes.scene.source import SourceScalar, parse, walk
from planes.solving import plans_of
from planes.studio.text_edits import Edited
from planes.words import Phrase
from planes.words.errors import PlanesError
from planes.words.frozen import frozen
from planes.words.names import is_scale, plan_of_scale, said_of_given
from planes.words.units import mu_text

STEP = 1e-3  # relative: trial change of a number
ROUNDS, CLOSE = 8, 1e-9
WRITTEN = 1e-4  # relative: closer than this two numbers are the same as written
DIGITS, EVERY = 5, 17  # digits written for a number set by hand; all that a number has
NUMBER = re.compile(r"([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)(\s*[^\d\s].*)?")
LEFT_OUT = (("drive", "epsilon"), ("drive", "acceleration"))  # where they are zero
PARAMETER = re.compile(r"(?!pi\b)\b[^\W\d]")
PARTS = ("parameters", "frame", "links", "drive", "loads", "gravity", "vectors", "friction")


@frozen
class NumberInText:
    """A number in the text, with the unit it was written in."""

    path: tuple[str, ...]
    value: float
    unit: str = ""


def home_of(text: str) -> dict[str, float]:
    """The numbers of a scene that a reader may change, by name, SI and degrees."""
    plans, _ = plans_of(loads(text), shown=True)
    given = {**plans.given, **plans.at(plans.drive.position)}
    knobs = Knobs(plans, given)
    names = {plans.drive_given, *(knob["given"] for knob in knobs.all)}
    return {name: value for name, value in knobs.home.items() if name in names}


def with_numbers(text: str, wanted: Mapping[str, float], said: Mapping[str, str] = MappingProxyType({})) -> Edited:
    """The text with the mechanism's numbers as wanted, in the figures of a hand where it ``said`` them (310*0.001);
    :class:`PlanesError` where no number of the text can achieve that."""
    edited = Edited(text)
    for name, value in wanted.items():
        if is_scale(name):
            plan = plan_of_scale(name)
            edited = edited.put(("plans", plan, "mu"), mu_text(value, plan))
    rest = {name: value for name, value in wanted.items() if not is_scale(name)}
    return _solved(edited, rest, said) if rest else edited


def _figures(text: str) -> list[NumberInText]:
    """The numbers of the text that a mechanism depends on, in its order; then those that it may leave out."""
    numbers = []
    for path, node, _ in walk(parse(text, "")):
        if path and path[0] in PARTS and isinstance(node, SourceScalar) and (digits := NUMBER.fullmatch(node.text)):
            numbers.append(NumberInText(path, float(digits[1]), digits[2] or ""))
    there = {figure.path for figure in numbers}
    return numbers + [NumberInText(path, 0.0) for path in LEFT_OUT if path not in there]


Slopes = Mapping[NumberInText, Mapping[str, float]]


def _solved(edited: Edited, wanted: Mapping[str, float], said: Mapping[str, str]) -> Edited:
    """One number after another, by Newton's steps in the numbers of the text that change it; some are already right
    through an expression."""
    home = home_of(edited.text)
    figures = _figures(edited.text)
    wanted = {name: value for name, value in wanted.items() if name in home and _off(home[name], value) > CLOSE}
    slopes = {f: _moved(edited, f, home) for f in figures if f.path[-1] in map(said_of_given, wanted)}
    chosen: dict[str, NumberInText] = {}
    solved = edited
    for name, value in wanted.items():
        now = home_of(solved.text) if chosen else home
        if _off(now.get(name, math.inf), value) <= WRITTEN:
            continue
        if not (able := _able(name, slopes, chosen)) and len(slopes) < len(figures):
            slopes |= {f: _moved(edited, f, home) for f in figures if f not in slopes}
            able = _able(name, slopes, chosen)
        if not able:
            raise PlanesError(Phrase("studio_no_number", names=said_of_given(name)))
        chosen[name] = min(able, key=lambda f: _rank(f, slopes[f], wanted))
        solved = _reached(edited, [*chosen.values()], {n: wanted[n] for n in chosen})
    for name, figure in chosen.items():
        typed = solved.put(figure.path, said[name]) if name in said and not PARAMETER.search(figure.unit) else solved
        with suppress(PlanesError):
            solved = typed if _off(home_of(typed.text)[name], wanted[name]) <= WRITTEN else solved
    return solved


def _off(one: float, other: float) -> float:
    """The difference of two numbers relative to the larger; absolute for angles and places near zero."""
    return abs(one - other) / max(abs(one), abs(other), 1e-3)


def _able(name: str, slopes: Slopes, chosen: Mapping[str, NumberInText]) -> list[NumberInText]:
    return [f for f, moved in slopes.items() if moved.get(name) and f not in chosen.values()]


def _rank(figure: NumberInText, moved: Mapping[str, float], wanted: Mapping[str, float]) -> tuple[bool, int, bool]:
    """Zeros stay; then numbers that change the fewest others, the parameters first."""
    return not figure.value, len(moved.keys() - wanted.keys()), figure.path[0] != "parameters"


def _moved(edited: Edited, figure: NumberInText, home: Mapping[str, float]) -> dict[str, float]:
    """The numbers of the mechanism that change with one of the text, and their rates."""
    step = STEP * (abs(figure.value) or 1.0)
    try:
        there = home_of(edited.put(figure.path, f"{figure.value + step!r}{figure.unit}").text)
    except PlanesError:
        return {}
    return {n: (there[n] - v) / step for n, v in home.items() if n in there and abs(there[n] - v) > 1e-9 * abs(step)}


def _reached(edited: Edited, chosen: Sequence[NumberInText], wanted: Mapping[str, float]) -> Edited:
    """The text with numbers that give the wanted ones, as closely as their digits allow."""
    values = [f.value for f in chosen]

    def text_of(numbers: Sequence[float], digits: int = EVERY) -> Edited:
        text = edited
        for figure, value in zip(chosen, numbers, strict=True):
            text = text.put(figure.path, f"{value:.{digits}g}{figure.unit}")
        return text

    for _ in range(ROUNDS):
        home = home_of(text_of(values).text)
        miss = [v - home[n] for n, v in wanted.items()]
        if all(abs(m) <= CLOSE * max(abs(v), 1.0) for m, v in zip(miss, wanted.values(), strict=True)):
            break
        columns = []
        for k, value in enumerate(values):
            step = STEP * (abs(value) or 1.0)
            there = home_of(text_of([v + step * (j == k) for j, v in enumerate(values)]).text)
            columns.append([(there[n] - home[n]) / step for n in wanted])
        values = [v + by for v, by in zip(values, eliminated(columns, miss)[0], strict=True)]
    return text_of(values, DIGITS)
