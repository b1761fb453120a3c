"""A paper's marks laid over a plan: by label, from the pole, a force polygon rebuilt from its vectors."""

from __future__ import annotations

from collections.abc import Mapping

from planes.check.grading.paper import ReadMark, ReadPaper
from planes.check.grading.polygons import Rebuilt, rebuild
from planes.check.grading.prepared_plan import PreparedPlan, mark_names
from planes.words import Phrase
from planes.words.errors import PlanesError
from planes.words.names import POLE, kind_of, mu_of
from planes.words.spelling import Names


def align(bench: PreparedPlan, plan: str, paper: ReadPaper) -> tuple[dict[str, ReadMark], Rebuilt | None, list[str]]:
    """The paper's marks by label, from the pole; the rebuilt polygon of a force plan; names that are no marks."""
    names = mark_names(bench.plans, plan)
    pole = next((s for s in paper.spots if names.find(s.name) == POLE), None)
    if kind_of(plan) == "force":
        if pole is None:
            raise PlanesError(Phrase("check_no_pole"))
        rebuilt = rebuild(bench.plans, plan, paper.spots, paper.whole)
        return rebuilt.spots, rebuilt, rebuilt.unknown
    found: dict[str, ReadMark] = {}
    unknown = []
    for spot in paper.spots:
        name = names.find(spot.name)
        if name is None and not _fixed(bench, spot.name):
            unknown.append(spot.name)
        elif name and name != POLE:
            found.setdefault(name, spot)
    origin = pole.place if pole else _origin(bench, plan, found)
    moved = {n: ReadMark(n, s.place - origin, s.error_mm) for n, s in found.items()}
    return moved, None, unknown


def _fixed(bench: PreparedPlan, name: str) -> bool:
    """Whether a name is that of a fixed point, which stands at the pole of a motion plan."""
    return Names(bench.plans.mechanism.frame.points).find(name) is not None


def _origin(bench: PreparedPlan, plan: str, found: Mapping[str, ReadMark]) -> complex:
    """Where the pole is when it was not read: from a fixed point of the scheme."""
    if plan != "position":
        raise PlanesError(Phrase("check_no_pole"))
    for name, place in bench.plans.mechanism.frame.points.items():
        if name in found:
            return complex(found[name].place - place * bench.given[mu_of(plan)])
    raise PlanesError(Phrase("check_no_fixed", names=", ".join(bench.plans.mechanism.frame.points)))
