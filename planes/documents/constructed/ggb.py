"""A plan for GeoGebra: a slider sets the drive's position, and scheme and plans follow it."""

from collections.abc import Iterator

from planes.documents.constructed import LiveFigure
from planes.documents.constructed._numbers import GivenNumbers
from planes.documents.constructed._steps import Labels, Translator
from planes.drafting.steps import MarkStep, Step
from planes.geometry.plane import bounding_corners
from planes.scene.ranges import Interval
from planes.words import say
from planes.words.names import (
    POLE_LABEL,
    SCHEME_PLAN,
    direction_of_given_angle,
    given_name_of_number,
    label_of,
    letter_of,
    plan_of,
    split_value_name,
)
from render.files.ggb import BLUE_COLOUR, HIDDEN_ASPECT, INK_COLOUR, RED_COLOUR, Aspect, GeogebraFile

LABEL_LETTERS_BY_PLAN = {"position": "P", "velocity": "V", "acceleration": "A", "motion": "V", "lever": "L"}
GREEK_LABEL_LETTERS = {"omega": "ω", "epsilon": "ε", "mu": "μ", "angle": "α", "phi": "φ", "": "n"}
SIGN_SPELLINGS = str.maketrans({"'": "p", "′": "p", "⊥": "n", "∥": "p", "→": "to", "−": "m", "-": "m", "↓": "down"})
AXIS_NAMES = ("x", "y", "z")
FIRST_SLIDER_PX = 40 + 40j  # px from the upper left corner
SLIDER_STEP_PX = 40j  # px to the next one
PICTURE_MARGIN_MM = 40.0
ROOM_ABOVE_FIGURES_MM = 120.0
LENGTH_SLIDER_SHARE = 0.5  # relative range of the slider for a length
FULL_TURN_DEG = 360.0


def file_and_limitations(figure: LiveFigure) -> tuple[bytes, list[str]]:
    """The file, and the sentences about it: the objects that GeoGebra does not draw itself."""
    numbers = GivenNumbers(figure)
    labels = unique_labels(figure, numbers)
    corner = min((figure.place_on_picture(m).real for m in figure.shown_marks), default=0.0) - PICTURE_MARGIN_MM
    top = max((figure.place_on_picture(m).imag for m in figure.shown_marks), default=0.0) + ROOM_ABOVE_FIGURES_MM
    made = GeogebraFile(figure.title, complex(corner, top))
    _write_given_numbers(figure, numbers, made, labels)
    translator = Translator(figure, made, labels, lambda step: _point_appearance(figure, step))
    for step in figure.shown_program.steps:
        translator.write_step(step)
    _write_sides_and_vectors(figure, made, labels)
    for k, (plan, title) in enumerate(zip(figure.plans, figure.titles, strict=True)):
        own = [figure.place_on_picture(m) for m in figure.shown_marks if m.plan == plan]
        low, high = bounding_corners(own)
        made.add_caption(f"T{k}", title, complex(low.real, high.imag + 20))
    return made.zip_bytes(), [*_stationary_objects_remark(figure, translator)]


def _stationary_objects_remark(figure: LiveFigure, translator: Translator) -> Iterator[str]:
    """The objects that stay in place when the drive moves."""
    stuck = [s.makes for s in translator.left]
    stuck += [n for n in figure.stated_plans.laws if n in figure.shown_program.given_names]
    if stuck:
        names = ", ".join(figure.naming.lettered_name(label_of(n), plan_of(n)) for n in stuck)
        yield say("ggb_numbers", figure.lang, names=names)


def unique_labels(figure: LiveFigure, numbers: GivenNumbers) -> Labels:
    """A unique label for each name of the program."""
    names = [*numbers.free_values, *_names_of_computed(numbers), *(s.makes for s in figure.shown_program.steps)]
    labels = Labels()
    taken = set()
    for name in names:
        label = wanted = _geogebra_label(figure, name)
        count = 1
        while label in taken:
            count += 1
            label = f"{wanted[:-1]}n{count}}}"
        taken.add(label)
        labels[name] = label
    return labels


def _geogebra_label(figure: LiveFigure, name: str) -> str:
    """A label in the style of GeoGebra: a letter and an index."""
    drive = figure.stated_plans.mechanism.drive
    plan = plan_of(name)
    if figure.stated_plans.has_mechanism and name == drive.coordinate_name:
        return f"{'φ' if drive.rotates else 's'}_{{{drive.link}}}"
    own = given_name_of_number(name)
    head, tail, part = split_value_name(own)
    tail += part
    if plan:
        head = LABEL_LETTERS_BY_PLAN.get(plan, "F")
        tail = label_of(name) + "".join(plan.links)
    elif not head.isalpha() or not tail or head in AXIS_NAMES:
        head = "u"
        tail = own
    tail = "".join(c for c in tail.translate(SIGN_SPELLINGS) if c.isalnum()) + name[len(own) + 1 :]
    return f"{GREEK_LABEL_LETTERS.get(head, head)}_{{{tail or '0'}}}"


def _names_of_computed(numbers: GivenNumbers) -> Iterator[str]:
    """Names of computed numbers, and of both coordinates of computed places."""
    for name in numbers.computed_names:
        yield from (f"{name}.x", f"{name}.y") if isinstance(numbers.given[name], complex) else (name,)


def _write_given_numbers(figure: LiveFigure, numbers: GivenNumbers, made: GeogebraFile, labels: Labels) -> None:
    """The free numbers on sliders, and formulas for those computed from them."""
    drive = figure.stated_plans.drive_given_name
    place = FIRST_SLIDER_PX
    for name, value in numbers.free_values.items():
        shown = name == drive or letter_of(name) in ("l", "omega", "epsilon")
        slider = _slider_range(name, value, name == drive)
        made.add_number(labels[name], value, slider, place if shown and slider else 0j)
        place += SLIDER_STEP_PX * bool(shown and slider)
    for name in numbers.computed_names:
        texts = numbers.coordinate_formulas(name, labels)
        for own, text in zip([name] if len(texts) == 1 else [f"{name}.x", f"{name}.y"], texts, strict=True):
            made.add_formula("numeric", labels[own], text)


def _slider_range(name: str, value: float, drives: bool) -> Interval | None:
    """The range of a number's slider, None for a number without one."""
    if letter_of(name) == "side":
        return None
    if direction_of_given_angle(name) or (drives and letter_of(name) == "angle"):
        if 0 <= value <= FULL_TURN_DEG:
            return (0.0, FULL_TURN_DEG)
        return (value - FULL_TURN_DEG / 2, value + FULL_TURN_DEG / 2)
    if value:
        return ((1 - LENGTH_SLIDER_SHARE) * value, (1 + LENGTH_SLIDER_SHARE) * value)
    return None


def _point_appearance(figure: LiveFigure, step: Step) -> Aspect:
    """The appearance of a point."""
    if not isinstance(step, MarkStep) or step.makes not in figure.shown_marks or step.makes == SCHEME_PLAN.pole:
        return HIDDEN_ASPECT
    return Aspect(INK_COLOUR, figure.mark_lettering(step.makes), 4 if step.plan == SCHEME_PLAN else 2)


def _write_sides_and_vectors(figure: LiveFigure, made: GeogebraFile, labels: Labels) -> None:
    """The sides of links, and the vectors of the plans."""
    for k, bar in enumerate(figure.link_sides):
        made.add_command(
            "segment", [f"s_{{{k}}}"], "Segment", [labels[bar.start], labels[bar.end]], Aspect(INK_COLOUR, thick=6)
        )
    for k, shaft in enumerate(figure.plan_vectors):
        from_pole = shaft.start.label == POLE_LABEL
        look = Aspect(RED_COLOUR if from_pole else BLUE_COLOUR, shaft.text, 5 if from_pole else 4)
        made.add_command("vector", [f"w_{{{k}}}"], "Vector", [labels[shaft.start], labels[shaft.end]], look)
