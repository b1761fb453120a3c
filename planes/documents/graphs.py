"""Parts of a sheet beside the positions: graphical constructions over the cycle, and the self-aligning variant."""

from collections.abc import Callable
from functools import partial

from planes.diagrams.graphical_text import constructed
from planes.plans.assur.alignment import aligned
from planes.scene import Scene
from planes.solving import Position
from planes.words import say
from render.sheet.composer import Composer
from render.sheet.single import LETTER_MM, Makers
from render.views import View, view
from render.views.alignment import alignment_view
from render.views.graphical import Graphical

STATIONS = 12


def constructions(
    scene: Scene, composer: Composer, sections: int = STATIONS, pole_mm: float | None = None
) -> list[View]:
    """Both graphical constructions of the driven link's motion."""
    views = []
    for one in constructed(scene, sections, pole_mm):
        title = say(one.kind, composer.lang, link=composer.naming.link(one.motion.link))
        marks = Graphical(one, one.drawn(), composer.naming).drawn()
        views.append(view(one.kind, title, marks, figure=True))
    return views


def views_beside(scene: Scene, drawn: Position, composer: Composer) -> Makers:
    """Views of the mechanism that do not belong to a position, by their names."""

    def graphical(kind: str) -> View:
        return next(v for v in constructions(scene, composer) if v.key == kind)

    def alignment() -> View:
        title = say("self_aligning", composer.lang)
        return alignment_view(drawn, aligned(drawn.plans, scene.file), composer.naming, title, LETTER_MM)

    makers: dict[str, Callable[[], View | None]] = {"self-aligning": alignment}
    drive = drawn.plans.drive
    if drive.rotates and drive.velocity:
        makers |= {kind: partial(graphical, kind) for kind in ("differentiation", "integration")}
    return makers
