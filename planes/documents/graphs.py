"""What a sheet shows of the whole cycle beside positions: asked diagrams, hodographs, graphical constructions, and the
self-aligning variant. The mechanics are read off the one program here; ``render`` draws them."""

from collections.abc import Callable, Mapping, Sequence
from functools import partial

import numpy

from planes.diagrams.curves import Curve, CycleVector, Sample, arrows_of, curves_of
from planes.diagrams.graphical_text import constructed
from planes.diagrams.motion import Runs
from planes.diagrams.turn import turn_of, unwound
from planes.geometry.arithmetic import Real
from planes.geometry.arrays import Array
from planes.plans import Plans
from planes.plans.alignment import aligned
from planes.scene import Scene
from planes.solving import Position
from planes.words import Phrase, say
from planes.words.errors import SceneError, choices
from planes.words.lettering import Naming, lettered_curve
from planes.words.names import letter_of
from render.sheet.composer import Composer
from render.sheet.single import LETTER_MM, Makers
from render.views import View, view
from render.views.alignment import alignment_view
from render.views.diagrams import DiagramCurve, Hodograph
from render.views.graphical import Graphical

STATIONS = 12
SHOWN = ("diagrams", "hodographs")


def over_cycle(
    scene: Scene, plans: Plans, angles: Sequence[float], naming: Naming
) -> tuple[tuple[DiagramCurve, ...], tuple[Hodograph, ...]]:
    """The diagrams and hodographs that ``sheet:`` of a scene asks for, over the angles of a turn."""
    names, loops = (asked(scene.sheet, key) for key in SHOWN)
    if not names and not loops:
        return (), ()
    turn = turn_of(plans, names, loops, scene.file)
    runs = Runs(plans, min(angles), max(angles))
    pieces, at = [(p, turn.sample(p)) for p in runs.pieces()], turn.sample(runs.read_stations())
    curves = tuple(_curve(c, pieces, naming) for c in turn.curves)
    found = ((a, lettered_curve(a.name, naming)) for a in turn.arrows)
    return curves, tuple(Hodograph(n, a.unit, known(joined(pieces, a)[1]), known(a.read(at))) for a, n in found)


def check_names(scene: Scene, plans: Plans | None) -> None:
    """Whether there is every diagram and hodograph that ``sheet:`` names, on whichever sheet they are drawn."""
    for key, names in ((key, asked(scene.sheet, key)) for key in SHOWN):
        line = scene.where.get(("sheet", key))
        if names and plans is None:
            raise SceneError(Phrase("cycle_no_mechanism", file=f"sheet.{key}"), scene.file, line)
        if names and plans:
            there: Mapping[str, object] = curves_of(plans) if key == "diagrams" else arrows_of(plans)
            for n, name in enumerate(names):
                if name not in there:
                    why = Phrase("no_curve", name=name, file=f"sheet.{key}", valid=choices(name, there))
                    raise SceneError(why, scene.file, scene.where.get(("sheet", key, str(n)), line))


def joined(pieces: Sequence[tuple[Array, Sample]], curve: Curve | CycleVector) -> tuple[Array, Array]:
    """A curve's runs as one row of places and one of values, with nothing between them."""
    x = numpy.concatenate([part for places, _ in pieces for part in (places, places[-1:])][:-1])
    rows = [curve.read(sample) + numpy.zeros(len(places)) for places, sample in pieces]
    return x, numpy.concatenate([part for row in rows for part in (row, [numpy.nan])][:-1])


def _curve(curve: Curve, pieces: Sequence[tuple[Array, Sample]], naming: Naming) -> DiagramCurve:
    """A curve as the sheet draws it; an angle is unwound."""
    places, values = joined(pieces, curve)
    if curve.angular:
        values = unwound(values)
    name = lettered_curve(curve.name, naming)
    return DiagramCurve(letter_of(name), curve.unit, known(values), name, known(places))


def known(values: Array) -> tuple[Real, ...]:
    """Plain numbers, None where there are none."""
    return tuple(None if v != v else v for v in values.tolist())


def asked(sheet: Mapping[str, object], key: str) -> list[str]:
    """Names under a key of ``sheet:``, as a list or with commas between them."""
    said = sheet.get(key)
    names = said if isinstance(said, list) else str(said or "").split(",")
    return [str(n).strip() for n in names if str(n).strip()]


def constructions(
    scene: Scene, composer: Composer, sections: int = STATIONS, pole_mm: float | None = None
) -> list[View]:
    """Both graphical constructions of the driven link's motion."""
    found = []
    for one in constructed(scene, sections, pole_mm):
        title = say(one.kind, composer.lang, link=composer.naming.link(one.motion.link))
        marks = Graphical(one, one.drawn(), composer.naming).drawn()
        found.append(view(one.kind, title, marks, figure=True))
    return found


def views_beside(scene: Scene, drawn: Position, composer: Composer) -> Makers:
    """Views of the mechanism that belong to no one position, by their names."""

    def graphical(kind: str) -> View:
        return next(v for v in constructions(scene, composer) if v.key == kind)

    def alignment() -> View:
        title = say("self_aligning", composer.lang)
        return alignment_view(drawn, aligned(drawn.plans, scene.file), composer.naming, title, LETTER_MM)

    makers: dict[str, Callable[[], View | None]] = {"self-aligning": alignment}
    drive = drawn.plans.mechanism.drive
    if drive.kind == "phi" and drive.velocity:
        makers |= {kind: partial(graphical, kind) for kind in ("differentiation", "integration")}
    return makers
