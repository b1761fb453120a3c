"""The self-aligning variant drawn: the scheme with the signs of cylindrical and spherical pairs, and their names."""

import math
from dataclasses import dataclass, replace

from planes.plans.assur.alignment import Aligned, Sign
from planes.plans.assur.groups import Pair
from planes.scene.mechanism import FRAME, Link
from planes.solving import Position
from planes.words import say
from planes.words.naming import Naming
from render.labels import Label
from render.paper import symbols
from render.paper.marks import Arc, Line, Mark, Text, moved
from render.paper.style import HINGE_MM
from render.paper.symbols import Marks
from render.views import View, stacked, view
from render.views.plotted import degrees
from render.views.scheme import Scheme

CUP_MM = 2.4  # radius of the cup about a spherical pair's ball
RING_MM = 2.4  # of the bushing about a cylindrical pair's pin
ROD_MM = 3.5  # of a round rod seen through its bushing, beyond it
CLASSES = {"R": 5, "P": 5, "C": 4, "S": 3}


@dataclass(kw_only=True)
class AlignedScheme(Scheme):
    """A scheme whose pairs have the signs of a self-aligning variant."""

    aligned: Aligned

    def pairs(self) -> None:
        """Hinges and their legs, then the signs of cylindrical or spherical pairs."""
        super().pairs()
        for pair, sign in self.aligned.pairs:
            if pair.kind == "R" and sign != "R" and self.places.has(pair.point):
                self.hinges += self.sign(pair, sign)

    def sign(self, pair: Pair, sign: Sign) -> Marks:
        """A ball in its cup, open towards its link; or a pin in a bushing, seen along its axis."""
        z = self.places.at(pair.point)
        if sign == "C":
            return (Arc(z, RING_MM, fill="paper"), *symbols.hinge(z))
        ways = [self.way(z, link) for link in (pair.link, pair.other)]
        towards = next((math.degrees(math.atan2(w.imag, w.real)) for w in ways if w), 0.0)
        return (Arc(z, CUP_MM, towards + 55, towards + 305), *symbols.hinge(z))

    def way(self, z: complex, link: str) -> complex:
        """The direction from a pair towards the rest of a link."""
        points = [self.places.at(p) - z for p in self.mechanism.link(link).points if self.places.has(p)]
        return max((w for w in points if abs(w) > 1.0), key=abs, default=0j) if link != FRAME else 0j

    def slider(self, link: Link, foot: complex, along: complex) -> None:
        """A cylindrical slider is a bushing: the round rod is visible through it, its axis chain-dotted."""
        super().slider(link, foot, along)
        pairs = (p for p in self.position.plans.structure.pairs if p.kind == "P" and p.link == link.name)
        if any(self.aligned.sign(pair) == "C" for pair in pairs):  # none for a passive link
            long = self.size(link)[0] / 2 + ROD_MM
            self.hinges.append(Line((foot - long * along, foot + long * along), "axis", "axis"))
            self.hinges += _bushing(foot, degrees(along), self.size(link))

    def letters(self) -> None:
        """Letters of the points, with the signs of the pairs there."""
        super().letters()
        said: dict[str, list[str]] = {}
        for pair, sign in self.aligned.pairs:
            short = say(f"short_{sign}", self.naming.lang)
            if pair.kind == "R":
                said.setdefault(pair.point, []).append(short)
            elif self.places.has((link := self.mechanism.links[pair.link]).first_point):
                foot, _ = self.places.foot(link)
                text = f"{between(pair, self.naming)}_{{{short}}}"
                self.named.append(Label(text, foot, 3.5, clear=4.5, name=f"sign {pair.guide}"))
        for k, label in enumerate(self.named):
            if label.name in said and label.name in self.shared:
                text = f"{label.text}_{{{', '.join(said[label.name])}}}"
                self.named[k] = replace(label, text=text, clear=CUP_MM)


def _bushing(foot: complex, angle: float, size: tuple[float, float]) -> Marks:
    """Short strokes over both ends of a slider's block: the edges of its bore."""
    along, (long, wide) = symbols.unit(angle), size
    starts = (foot + side * 1j * along * (0.28 * wide) for side in (-1, 1))
    return tuple(Line((z - long / 2 * along, z + long / 2 * along), "thin") for z in starts)


def between(pair: Pair, naming: Naming) -> str:
    """A sliding pair by its links: "(4–5)"."""
    return f"({'–'.join(sorted(map(naming.link, (pair.other, pair.link))))})"


def alignment_view(position: Position, aligned: Aligned, naming: Naming, title: str, letter: float) -> View:
    """Scheme, count and signs, one beneath another."""
    scheme = AlignedScheme(position, naming, aligned=aligned)
    drawn = view("self-aligning", title, scheme.drawn(False), figure=True)
    return stacked("self-aligning", [drawn, alignment_told(aligned, naming, "", letter)])


def alignment_told(aligned: Aligned, naming: Naming, title: str, letter: float) -> View:
    """Count and signs."""
    count, signs = view("self-aligning", title, counted(aligned, letter)), legend(aligned, naming, letter)
    return stacked("self-aligning", [count, signs])


def counted(aligned: Aligned, letter: float) -> list[Mark]:
    """The formula of Somov and Malyshev, with its numbers beneath."""
    p1, p2, p3 = aligned.counts
    numbers = f"= 6·{aligned.n} − 5·{p1} − 4·{p2} − 3·{p3} = {aligned.W};   q = {aligned.q}"
    lines, high = ("W = 6n − 5p_{1} − 4p_{2} − 3p_{3} =", numbers), 1.4 * letter
    return [Text(line, complex(0, -1.9 * high * k), high) for k, line in enumerate(lines)]


def legend(aligned: Aligned, naming: Naming, letter: float) -> View:
    """The sign of every kind of pair present, seen from its side, with its name, class and places."""
    marks = []
    there = {sign for _, sign in aligned.pairs}
    for row, kind in enumerate(k for k in CLASSES if k in there):
        y = -13.0 * row
        marks += [moved(m, 1j * y) for m in _SIGNS[kind]]
        named = [p for p, sign in aligned.pairs if sign == kind]
        places = ", ".join(naming.point(p.point) if p.point else between(p, naming) for p in named)
        words = say(f"pair_{kind}", naming.lang, cls=CLASSES[kind])
        marks.append(Text(f"{words}: {places}", complex(16, y - letter / 2), letter))
    return view("signs", "", marks)


_SHAFT = (
    *(Line((complex(-4, y), complex(4, y))) for y in (-2.2, 2.2)),  # a rod in a sleeve, in which it turns and slides
    Line((-10 + 0j, 10 + 0j)),
)
_CUP = 1.7 * HINGE_MM * 1.2
_SIGNS = {
    "R": (*_SHAFT, *(Line((complex(x, -1.8), complex(x, 1.8))) for x in (-5.2, 5.2))),  # a shaft held by collars
    "P": (*symbols.base(-3.25j, 0, 18.0), *symbols.block(0j)),
    "C": _SHAFT,
    "S": (Arc(0j, _CUP, 55, 305), Line((HINGE_MM + 0j, 10 + 0j)), Line((-_CUP + 0j, -10 + 0j)), *symbols.hinge(0j)),
}
"""The signs of ГОСТ 2.770, seen from the side."""
