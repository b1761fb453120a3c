"""Numbers drawn at random for a student: round ones around the scene's own, kept if the method works with them.

The mechanism must assemble for every position of the drive, and no lines of any plan may meet at less than the limit,
all the way round, if the original does; the position the student works with must give no warning.
"""

import hashlib
import math
import random
import re
from collections.abc import Callable, Mapping

import numpy

from planes.course import ParameterChoice
from planes.plans import Plans
from planes.plans.scales import drawn_in_si
from planes.plans.statements.of_scene import scene_plans
from planes.scene import Scene
from planes.scene.paths import entries_of_table
from planes.scene.source import SourceScalar, SourceTable
from planes.scene.source import parse_yaml as parse_text
from planes.solving import solve
from planes.words import Phrase
from planes.words.errors import Contradiction, PlanesError, SceneError
from planes.words.names import NamesByName, NameTuple, NumbersByName

MOST_TRIED_SETS = 1000  # sets of numbers tried before giving up
TEST_ANGLES_DEG = tuple(map(float, range(0, 360, 2)))  # the driver's test angles, degrees
_DRAWN_DRIVER_ANGLES = tuple(f"{k}" for k in range(0, 360, 15))
_NUMBER_PATTERN = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?", re.ASCII)
_PERCENT_BY_NAME_PREFIX = (
    ("l_", 10.0),
    ("x_", 10.0),
    ("y_", 10.0),
    ("omega_", 20.0),
    ("F_", 20.0),
    ("M_", 20.0),
    ("P_", 20.0),
)


def sharpness_over_turn(plans: Plans) -> list[float | None]:
    """The least sharpness of crossings at each angle of the driver, None where it cannot be drawn."""
    drawing = drawn_in_si(plans, numpy.array(TEST_ANGLES_DEG))
    least = numpy.ones(len(TEST_ANGLES_DEG))
    for sharpnesses in drawing.crossing_sharpness.values():
        least = numpy.fmin(least, numpy.broadcast_to(sharpnesses, least.shape))
    bad = numpy.broadcast_to(drawing.failed_mask(), least.shape)
    return [None if b else float(sharpness) for b, sharpness in zip(bad, least, strict=True)]


def parameter_choices(text: str, file: str, draw: Mapping[str, ParameterChoice] | None) -> dict[str, NameTuple]:
    """The choices for each drawn parameter of a scene, as written, in the order of the scene."""
    table = parse_text(text, file)
    own = entries_of_table(table.entries.get("parameters"))
    plain = {
        k: float(v.text) for k, v in own.items() if isinstance(v, SourceScalar) and _NUMBER_PATTERN.fullmatch(v.text)
    }
    asked = _default_choices(table, plain) if draw is None else {k: c for k, c in draw.items() if k in own}
    values_of = {}
    for name, choice in asked.items():
        if choice.percent is not None and name not in plain:
            raise SceneError(Phrase("course_not_plain", name=name), file, own[name].line)
        values_of[name] = choice.values if choice.percent is None else round_numbers_near(plain[name], choice.percent)
    if not values_of:
        raise SceneError(Phrase("course_nothing_drawn"), file, 1)
    return {name: values_of[name] for name in own if name in values_of}


def _default_choices(table: SourceTable, plain: NumbersByName) -> dict[str, ParameterChoice]:
    """The parameters drawn by default: the driver's position, lengths and coordinates, its speed, loads."""
    at = entries_of_table(table.entries.get("drive")).get("phi")
    angle = at.text if isinstance(at, SourceScalar) else ""
    choices = {}
    for name, value in plain.items():
        percent = next((p for head, p in _PERCENT_BY_NAME_PREFIX if name.startswith(head)), None)
        if name == angle:
            choices[name] = ParameterChoice(_DRAWN_DRIVER_ANGLES)
        elif percent is not None and value:
            choices[name] = ParameterChoice(percent=percent)
    return choices


def round_numbers_near(value: float, percent: float) -> NameTuple:
    """Round numbers within so many per cent of a value: multiples of 1, 2 or 5 units of some digit, four or more."""
    reach = abs(value) * percent / 100
    if not reach:
        return (f"{value:.10g}",)
    unit = math.floor(math.log10(reach / 2))
    step = next(k * 10.0**unit for k in (5, 2, 1) if k * 10.0**unit <= reach / 2 * (1 + 1e-9))
    first = math.ceil((value - reach) / step - 1e-9)
    last = math.floor((value + reach) / step + 1e-9)
    return tuple(f"{round(k * step, max(0, -unit)):.10g}" for k in range(first, last + 1))


def seeded_generator(seed: int, *names: object) -> random.Random:
    """A random generator that depends on the seed and the names alone: the same everywhere."""
    text = "\0".join(map(str, (seed, *names)))
    return random.Random(int.from_bytes(hashlib.sha256(text.encode()).digest()[:8]))


def draw_numbers(
    choices: Mapping[str, NameTuple],
    make: Callable[[Mapping[str, str]], Scene],
    least_deg: float,
    chance: random.Random,
) -> NamesByName:
    """The first set of numbers with which the method works all the way round; ``make`` gives their scene."""
    apart = blunt = 0
    own = scene_plans(make({}))
    goes_round = own.has_mechanism and own.mechanism.drive.rotates and None not in sharpness_over_turn(own)
    for _ in range(MOST_TRIED_SETS):
        numbers = {name: values[int(chance.random() * len(values))] for name, values in choices.items()}
        try:
            scene = make(numbers)
            fault = _fault_of_scene(scene, least_deg, goes_round)
        except Contradiction:  # not caused by the numbers
            raise
        except PlanesError:
            fault = "apart"
        if fault is None:
            return numbers
        apart = apart + (fault == "apart")
        blunt = blunt + (fault == "blunt")
    raise PlanesError(Phrase("course_none", count=MOST_TRIED_SETS, apart=apart, blunt=blunt, limit=least_deg))


def _fault_of_scene(scene: Scene, least_deg: float, goes_round: bool) -> str | None:
    """The fault of a scene for a student: none, or that it does not assemble, or its lines meet too bluntly."""
    limit = math.sin(math.radians(least_deg))
    around = sharpness_over_turn(scene_plans(scene)) if goes_round else []
    if None in around:
        return "apart"
    if any(sharpness < limit for sharpness in around if sharpness is not None):
        return "blunt"
    solved = solve(scene)
    if not solved.positions:
        return "apart"
    position = solved.positions[0]
    worst = min(position.drawing.crossing_sharpness.values(), default=1.0)
    return "blunt" if position.results["warnings"] or worst < limit else None
