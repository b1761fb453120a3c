"""Hodographs: the ends of a vector laid off from one pole through the cycle, the positions numbered."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from planes.words import say
from planes.words.lettering import Naming
from planes.words.names import letter_of
from planes.words.units import standard_mu
from render import labels
from render.paper.marks import Arrow, Line, Mark
from render.paper.numbers import scale
from render.paper.symbols import dot
from render.views import View, view

WIDE_MM = 70.0  # the larger side of a hodograph
AXIS_MM = 8.0  # of the axes beyond it
APART_MM = 14.0


@dataclass(frozen=True)
class Hodograph:
    """A vector over the cycle, as complex numbers in ``unit`` (None where the mechanism does not assemble; a single one
    is a jump), and at the numbered positions."""

    name: str
    unit: str
    path: tuple[complex | None, ...]
    stations: tuple[complex | None, ...]


def hodograph_view(loops: Sequence[Hodograph], naming: Naming) -> View:
    """Hodographs side by side, each under its name and scale."""
    marks: list[Mark] = []
    left = 0.0
    for one in (_one(loop, naming) for loop in loops):
        marks += one.placed(left, 0.0)
        left += one.width + APART_MM
    return view("hodographs", "", marks, figure=True)


def _one(loop: Hodograph, naming: Naming) -> View:
    lang = naming.lang
    known = [z for z in loop.path if z is not None] + [0j]
    wide = max(
        max(z.real for z in known) - min(z.real for z in known), max(z.imag for z in known) - min(z.imag for z in known)
    )
    mu = standard_mu(wide, WIDE_MM)
    title = f"{say('hodograph', lang, name=loop.name)}, μ_{{{letter_of(loop.name)}}} = {scale(mu, loop.unit, lang)}"
    return view("hodograph", title, _drawn(loop, mu, [z * mu for z in known]), height=3.5)


def _drawn(loop: Hodograph, mu: float, inked: Sequence[complex]) -> list[Mark]:
    low = complex(min(z.real for z in inked) - AXIS_MM, min(z.imag for z in inked) - AXIS_MM)
    high = complex(max(z.real for z in inked) + AXIS_MM, max(z.imag for z in inked) + AXIS_MM)
    ground: list[Mark] = [
        Arrow(complex(low.real, 0), complex(high.real, 0), "thin", "dimension"),
        Arrow(complex(0, low.imag), complex(0, high.imag), "thin", "dimension"),
    ]
    for piece, jump in _pieces([None if z is None else z * mu for z in loop.path]):
        ground.append(Line(tuple(piece), "dash" if jump else "thick", "plan"))
    ends = (("x", complex(high.real, 0)), ("y", complex(0, high.imag)), ("p", 0j))
    named = [labels.Label(text, z, 3.5, clear=0.8, name=text) for text, z in ends]
    seen: list[complex] = []
    for k, z in enumerate(loop.stations):
        if z is None or any(abs(z - other) * mu < 0.4 for other in seen):
            continue
        seen.append(z)
        ground += dot(z * mu, 0.6, "plan")
        named.append(labels.Label(str(k), z * mu, 2.5, clear=0.8, name=f"position {k}"))
    placed = labels.place(named, ground)
    return [*ground, *placed.marks]


def _pieces(path: Sequence[complex | None]) -> list[tuple[list[complex], bool]]:
    """Runs of a path, with the jumps over its single gaps."""
    found: list[tuple[list[complex], bool]] = []
    run: list[complex] = []
    gap = 0
    for z in path:
        if z is None:
            gap += 1
            continue
        if gap == 1 and run:
            found += [(run, False), ([run[-1], z], True)]
        elif gap and run:
            found.append((run, False))
        run = [z] if gap else [*run, z]
        gap = 0
    return [(piece, jump) for piece, jump in [*found, (run, False)] if len(piece) > 1]
