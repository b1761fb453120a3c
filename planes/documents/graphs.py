"""Parts of a sheet beside the positions: graphical constructions over the cycle, and the self-aligning variant."""

from functools import partial

from planes.diagrams.graphical_text import both_graphical_constructions
from planes.plans.assur.alignment import self_aligning_variant
from planes.scene import Scene
from planes.solving import Position
from planes.words import say
from render.sheet.composer import Composer
from render.sheet.single import TABLE_LETTER_MM, Makers
from render.views import View, make_view
from render.views.alignment import alignment_view
from render.views.graphical import Graphical

DEFAULT_SECTION_COUNT = 12


def graphical_constructions(
    scene: Scene, composer: Composer, sections: int = DEFAULT_SECTION_COUNT, pole_mm: float | None = None
) -> list[View]:
    """Both graphical constructions of the driven link's motion."""
    views = []
    for one in both_graphical_constructions(scene, sections, pole_mm):
        title = say(one.kind, composer.lang, link=composer.naming.link_number(one.motion.link))
        marks = Graphical(one, one.draw_construction(), composer.naming).drawn_marks()
        views.append(make_view(one.kind, title, marks, figure=True))
    return views


def views_without_position(scene: Scene, drawn: Position, composer: Composer) -> Makers:
    """Views of the mechanism that do not belong to a position, by their names."""

    def graphical(kind: str) -> View:
        return next(v for v in graphical_constructions(scene, composer) if v.key == kind)

    def alignment() -> View:
        title = say("self_aligning", composer.lang)
        return alignment_view(
            drawn, self_aligning_variant(drawn.plans, scene.file), composer.naming, title, TABLE_LETTER_MM
        )

    makers = {"self-aligning": alignment}
    drive = drawn.plans.drive
    if drive.rotates and drive.velocity:
        makers |= {kind: partial(graphical, kind) for kind in ("differentiation", "integration")}
    return makers
