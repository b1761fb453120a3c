"""A plan for GeoGebra: a slider sets the drive's position, and scheme and plans follow it."""

from collections.abc import Iterator

from planes.documents.constructed import SCHEME, LiveFigure
from planes.documents.constructed._numbers import GivenNumbers
from planes.documents.constructed._steps import Labels, Translator
from planes.geometry.plane import corners
from planes.words import say
from planes.words.names import POLE, aimed, given_of, label_of, letter_of, links_of, parts_of, plan_of
from render.files.ggb import BLUE, HIDDEN, INK, RED, Aspect, GeogebraFile

HEADS = {"position": "P", "velocity": "V", "acceleration": "A", "motion": "V", "lever": "L"}
GREEK = {"omega": "ω", "epsilon": "ε", "mu": "μ", "angle": "α", "phi": "φ", "": "n"}
SIGNS = str.maketrans({"'": "p", "′": "p", "⊥": "n", "∥": "p", "→": "to", "−": "m", "-": "m", "↓": "down"})
AXES = ("x", "y", "z")
SLIDERS_FROM, SLIDER_STEP = 40 + 40j, 40j  # px from the upper left corner
MARGIN_MM, ABOVE_MM = 40.0, 120.0
SHARE = 0.5  # relative range of the slider for a length
TURN = 360.0


def written(figure: LiveFigure) -> tuple[bytes, list[str]]:
    """The file, and the sentences about it: the objects that GeoGebra does not draw itself."""
    numbers = GivenNumbers(figure)
    labels = labels_of(figure, numbers)
    corner = min((figure.at(m).real for m in figure.marks), default=0.0) - MARGIN_MM
    top = max((figure.at(m).imag for m in figure.marks), default=0.0) + ABOVE_MM
    made = GeogebraFile(figure.title, complex(corner, top))
    _given(figure, numbers, made, labels)
    translator = Translator(figure, made, labels, lambda mark: _look(figure, mark))
    for step in figure.program.steps:
        translator.of(step)
    _shafts(figure, made, labels)
    for k, (plan, title) in enumerate(zip(figure.plans, figure.titles, strict=True)):
        own = [figure.at(m) for m in figure.marks if plan_of(m) == plan]
        low, high = corners(own)
        made.caption(f"T{k}", title, complex(low.real, high.imag + 20))
    return made.packed(), [*_said(figure, translator)]


def _said(figure: LiveFigure, translator: Translator) -> Iterator[str]:
    """The objects that stay in place when the drive moves."""
    stuck = [s.makes for s in translator.left]
    stuck += [n for n in figure.stated.laws if n in figure.program.givens]
    if stuck:
        names = ", ".join(figure.naming.named(label_of(n), plan_of(n)) for n in stuck)
        yield say("ggb_numbers", figure.lang, names=names)


def labels_of(figure: LiveFigure, numbers: GivenNumbers) -> Labels:
    """A unique label for each name of the program."""
    names = [*numbers.free, *_reckoned(numbers), *(s.makes for s in figure.program.steps)]
    labels, taken = Labels(), set[str]()
    for name in names:
        label = wanted = _label(figure, name)
        count = 1
        while label in taken:
            count += 1
            label = f"{wanted[:-1]}n{count}}}"
        taken.add(label)
        labels[name] = label
    return labels


def _label(figure: LiveFigure, name: str) -> str:
    """A label in the style of GeoGebra: a letter and an index."""
    drive, plan = figure.stated.mechanism.drive, plan_of(name)
    if figure.stated.moves and name == drive.given:
        return f"{'φ' if drive.rotates else 's'}_{{{drive.link}}}"
    own = given_of(name)
    head, tail, part = parts_of(own)
    tail += part
    if plan:
        head, tail = HEADS.get(plan, "F"), label_of(name) + "".join(links_of(plan))
    elif not head.isalpha() or not tail or head in AXES:
        head, tail = "u", own
    tail = "".join(c for c in tail.translate(SIGNS) if c.isalnum()) + name[len(own) + 1 :]
    return f"{GREEK.get(head, head)}_{{{tail or '0'}}}"


def _reckoned(numbers: GivenNumbers) -> Iterator[str]:
    """Names of computed numbers, and of both coordinates of computed places."""
    for name in numbers.reckoned:
        yield from (f"{name}.x", f"{name}.y") if isinstance(numbers.given[name], complex) else (name,)


def _given(figure: LiveFigure, numbers: GivenNumbers, made: GeogebraFile, labels: Labels) -> None:
    """The free numbers on sliders, and formulas for those computed from them."""
    drive, place = figure.stated.drive_given, SLIDERS_FROM
    for name, value in numbers.free.items():
        shown = name == drive or letter_of(name) in ("l", "omega", "epsilon")
        slider = _range(name, value, name == drive)
        made.number(labels[name], value, slider, place if shown and slider else 0j)
        place += SLIDER_STEP * bool(shown and slider)
    for name in numbers.reckoned:
        texts = numbers.formulas(name, labels)
        for own, text in zip([name] if len(texts) == 1 else [f"{name}.x", f"{name}.y"], texts, strict=True):
            made.formula("numeric", labels[own], text)


def _range(name: str, value: float, drives: bool) -> tuple[float, float] | None:
    """The range of a number's slider, None for a number without one."""
    if letter_of(name) == "side":
        return None
    if aimed(name) or (drives and letter_of(name) == "angle"):
        return (0.0, TURN) if 0 <= value <= TURN else (value - TURN / 2, value + TURN / 2)
    return ((1 - SHARE) * value, (1 + SHARE) * value) if value else None


def _look(figure: LiveFigure, mark: str) -> Aspect:
    """The appearance of a point."""
    if mark not in figure.marks or (label_of(mark) == POLE and plan_of(mark) == SCHEME):
        return HIDDEN
    return Aspect(INK, figure.text(mark), 4 if plan_of(mark) == SCHEME else 2)


def _shafts(figure: LiveFigure, made: GeogebraFile, labels: Labels) -> None:
    """The sides of links, and the vectors of the plans."""
    for k, bar in enumerate(figure.bars):
        made.command("segment", [f"s_{{{k}}}"], "Segment", [labels[bar.start], labels[bar.end]], Aspect(INK, thick=6))
    for k, shaft in enumerate(figure.shafts):
        from_pole = label_of(shaft.start) == POLE
        look = Aspect(RED if from_pole else BLUE, shaft.text, 5 if from_pole else 4)
        made.command("vector", [f"w_{{{k}}}"], "Vector", [labels[shaft.start], labels[shaft.end]], look)
