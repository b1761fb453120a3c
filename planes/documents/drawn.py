"""Drawings of a scene: it is solved, its sheet or view composed, and the file written."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from planes.check.grading.by_hand import unreliable_rate_names
from planes.course.ledger import Sentences
from planes.documents import constructed
from planes.documents.graphs import graphical_constructions, views_without_position
from planes.documents.sheets import DrawnPosition, DrivePositions, project_over_turn, sheet_of
from planes.drafting.drawing import Drawing
from planes.scene import Scene
from planes.solving import Position, solve
from planes.solving.of_scene import AnyScene, scene_from
from planes.words import Lang, Phrase, home_lang, say
from planes.words.errors import PlanesError
from planes.words.formats import DRAWING_SUFFIXES
from planes.words.lettering import terminal_spelling
from render.files import Page
from render.files.dxf_entities import Lettered
from render.paper.hues import colour_vectors
from render.paper.marks import using_face
from render.paper.outlines import face_of_scene
from render.sheet import Sheet
from render.sheet.composer import Composer
from render.sheet.single import Makers, mechanism_view_makers, traced_plans_page, vector_view_makers, view_page
from render.sheet.sizes import Sizes
from render.views import stack_views


def shown(thing: Drawing | Scene | Position) -> str | None:
    """The picture for a notebook: a drawing with its construction lines, or a scheme; empty if it cannot be drawn."""
    try:
        page = traced_plans_page(thing) if isinstance(thing, Drawing) else picture(thing)
    except PlanesError:
        return None
    return page._repr_svg_() if page else None


class DrawnSheet(NamedTuple):
    """What was drawn: the format and the size of the paper ("A2, 594 × 420 mm"), what must be said of it, and what of
    a drawing by hand."""

    size: str
    said: Sentences
    remarks: Sentences = ()


def draw_sheet(
    scene: Scene,
    values: DrivePositions,
    output: str,
    lang: Lang = "ru",
    number: int | None = None,
    view: str | None = None,
    text: Lettered = "text",
) -> DrawnSheet:
    """Draw the sheet of a scene into a file; on failure :class:`PlanesError` in one sentence, and no file.

    Returns its format and size, and remarks: parts without room, or that cannot be seen or read.

    ``number`` 1 or 2 is that sheet of a course project; without it everything is on one page. ``view`` is a single
    view, without a frame. ``text`` "pieces" writes the indices of a DXF as separate texts, "strokes" draws its letters
    by lines.
    """
    suffix = Path(output).suffix.lower()
    others = constructed.format_suffixes()
    if suffix not in DRAWING_SUFFIXES + others:
        raise PlanesError(Phrase("bad_suffix", file=output, known=DRAWING_SUFFIXES + others))
    if suffix in others:
        if number:
            raise PlanesError(Phrase("constructed_sheet", file=output, known=DRAWING_SUFFIXES))
        return DrawnSheet("", constructed.draw_constructed(scene, view, values, output, lang))
    drawn = page_of_view(scene, view, values, lang) if view else sheet_of(scene, values, lang, number)
    drawn.write(output, text)
    paper = f"{drawn.paper.name.replace('x', '×')}, " if isinstance(drawn, Sheet) else ""
    size = " × ".join(f"{mm:.0f}" for mm in drawn.size)
    remarks = tuple(_hand_uncertainty_remark(scene, values, lang)) if view is None and number != 2 else ()
    return DrawnSheet(f"{paper}{size} {say('mm', lang)}", tuple(drawn.warnings), remarks)


def _hand_uncertainty_remark(scene: Scene, values: DrivePositions, lang: Lang) -> Iterator[str]:
    """The remark that velocities and accelerations on the sheet are uncertain in a drawing by hand, as in a check of
    one."""
    for position in solve(scene, values, lang=lang).positions if scene.mechanism else ():
        naming = replace(position.plans.default_naming, lang=lang)
        if names := ", ".join(
            terminal_spelling(naming.lettered_vector(name)) for name in unreliable_rate_names(position)
        ):
            yield say("unsure_by_hand", lang, names=names)


def draw_constructions(scene: Scene, sections: int, pole_mm: float | None, output: str, lang: Lang) -> None:
    """Draw both graphical constructions of a scene, one beneath the other, into a file."""
    composer = Composer(scene, lang)
    with using_face(face_of_scene(scene)):
        both = stack_views("graphical", graphical_constructions(scene, composer, sections, pole_mm), 20.0)
        view_page({both.key: lambda: both}, both.key, composer).write(output)


def picture(drawn: AnyScene | Position, view: str | None = None, lang: Lang | None = None) -> Page:
    """One view (the scheme, unless another is named) of a scene, or of a position solved before, for a notebook.

    A position is drawn as it is, by whatever instrument; the sheet settings of a scene are unknown then.
    """
    lang = lang or home_lang()
    if not isinstance(drawn, Position):
        return page_of_view(scene_from(drawn), view, None, lang)
    scene = Scene(mechanism=drawn.plans.mechanism, mu=drawn.scales)
    composer = Composer(scene, lang, drawn.plans)
    return view_page(_mechanism_views(scene, drawn, composer), view, composer)


def page_of_view(scene: Scene, view: str | None, values: DrivePositions = None, lang: Lang = "ru") -> Page:
    """One view of a scene on a separate page, by name (by default the first)."""
    shown = _page_of_view(scene, view, values, lang)
    if scene.sheet.get("colour"):
        return replace(shown, marks=colour_vectors(shown.marks))
    return shown


def _page_of_view(scene: Scene, view: str | None, values: DrivePositions, lang: Lang) -> Page:
    with using_face(face_of_scene(scene)):
        drawn = DrawnPosition(replace(scene, find=None), values, lang)
        composer = Composer(scene, lang, drawn.plans_and_wanted[0])
        return view_page(_mechanism_views(drawn.scene, drawn.position_at_sizes(Sizes()), composer), view, composer)


def _mechanism_views(scene: Scene, drawn: Position, composer: Composer) -> Makers:
    if not drawn.plans.has_mechanism:
        return vector_view_makers(drawn, composer)
    more = views_without_position(scene, drawn, composer)
    return mechanism_view_makers(drawn, composer, lambda: project_over_turn(scene, drawn.plans, composer, True), more)
