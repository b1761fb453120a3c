"""One view by itself, for a textbook, a slide or a notebook: a page cut to its ink with a margin around it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType

from planes.solving import Position
from planes.solving.vectors import PLAN, VectorResults
from planes.words import Phrase, say
from planes.words.errors import PlanesError
from planes.words.names import kind_of, links_of
from render.files import svg
from render.paper.marks import Mark
from render.sheet import unseen
from render.sheet.composer import Composer
from render.sheet.forces import ForceSheet
from render.sheet.project import Project
from render.views import View
from render.views.plotted import of_position, of_vectors
from render.views.tables import Tables

MARGIN_MM = 5.0
LETTER_MM = 3.5  # letter height of tables; equations are a step larger

Makers = Mapping[str, Callable[[], View | None]]
"""The views that can be asked for, by name, each made when it is asked for."""


@dataclass(frozen=True)
class Page:
    """Marks on a page of their own size, width × height in mm."""

    marks: tuple[Mark, ...]
    size: tuple[float, float]
    title: str
    lang: str = "ru"
    warnings: tuple[str, ...] = ()

    def __repr__(self) -> str:
        return f"<Page {self.title!r}, {self.size[0]:.0f} × {self.size[1]:.0f} mm>"

    def _repr_svg_(self) -> str:
        """The picture a notebook shows."""
        return svg.inline(self.marks, self.size, self.title, self.lang)


def page(makers: Makers, name: str, composer: Composer) -> Page:
    """The page of one view; a view that does not exist, or is empty, is a sentence."""
    if name not in makers:
        raise PlanesError(Phrase("bad_view", view=name, known=tuple(makers)))
    one = makers[name]()
    if one is None:
        raise PlanesError(Phrase("empty_view", view=name))
    marks = one.placed(MARGIN_MM, MARGIN_MM + one.height)
    title = composer.scene.title.get(composer.lang, "")
    size = (one.width + 2 * MARGIN_MM, one.height + 2 * MARGIN_MM)
    return Page(marks, size, ": ".join(t for t in (title, name) if t), composer.lang, tuple(unseen(one, composer.lang)))


def of_mechanism(
    position: Position, composer: Composer, project: Callable[[], Project], more: Makers = MappingProxyType({})
) -> Makers:
    """The views of a mechanism in one position; ``project`` turns its driver once around, where a view needs that.

    ``more`` are views of what is not seen in a position: constructions over the cycle, the self-aligning variant.
    """
    plotted, plans = of_position(position), position.plans
    bare, loaded, tables = Project(composer), ForceSheet(composer), composer.tables(position, LETTER_MM)
    rates = tuple(p for p in plans.drawn if p in ("velocity", "acceleration") and not plotted.still(p))
    forces = tuple(p for p in plans.drawn if kind_of(p) == "force" and not plotted.still(p))
    found: dict[str, Callable[[], View | None]] = {"position": lambda: composer.scheme(position)}
    found["positions"] = lambda: project().many(position)
    found["structure"] = lambda: bare.groups(position, LETTER_MM)
    for rate in rates:
        found[f"{rate}-plan"] = lambda plan=rate: composer.plan(plotted, plan)  # type: ignore[misc]
    found["equations"] = lambda: composer.formulas(plotted, rates, LETTER_MM, say("equations", composer.lang))
    found["diagrams"] = lambda: project().diagrams(position)
    found["hodographs"] = lambda: project().hodographs()
    found["loads"] = lambda: loaded.loaded(position)
    for force in forces:
        own = links_of(force)
        links = "-".join(own)
        found[f"group-{links}"] = lambda plan=force, of=own: loaded.group(position, plan, of)  # type: ignore[misc]
        if len(own) > 1:
            found[f"links-{links}"] = lambda of=own: loaded.apart(position, of)  # type: ignore[misc]
        found[f"force-{links}"] = lambda plan=force: composer.plan(plotted, plan)  # type: ignore[misc]
    balance = say("balance_equations", composer.lang)
    found["force-equations"] = lambda: composer.formulas(plotted, forces, LETTER_MM, balance)
    found["moments"] = lambda: composer.moments(position, LETTER_MM)
    found["lever"] = lambda: loaded.lever(position, LETTER_MM)
    found |= {
        "given": tables.given,
        "velocities": lambda: tables.plan("velocity"),
        "accelerations": lambda: tables.plan("acceleration"),
        "links": tables.links,
        "reactions": tables.reactions,
        "check": tables.check,
        **more,
    }
    return found


def of_scene_of_vectors(results: VectorResults, composer: Composer) -> Makers:
    """The views of a scene of vectors alone."""
    plotted = of_vectors(results)
    written = say("equations", composer.lang)
    return {
        "vectors": lambda: composer.plan(plotted, PLAN),
        "equations": lambda: composer.formulas(plotted, (PLAN,), LETTER_MM, written),
        "measured": lambda: Tables.of_vectors(results, composer.naming, LETTER_MM),
    }
