"""The self-aligning variant drawn: the scheme with the signs of cylindrical and spherical pairs, and their names."""

import math
from collections import defaultdict
from dataclasses import dataclass, replace

from planes.plans.assur.alignment import Aligned, Sign
from planes.plans.assur.groups import Pair
from planes.scene.mechanism import FRAME, Link
from planes.solving import Position
from planes.words import say
from planes.words.naming import Naming
from render.labels import Label
from render.labels.candidates import Size
from render.paper import symbols
from render.paper.marks import Arc, Line, Mark, Text, move_mark
from render.paper.style import HINGE_RADIUS_MM
from render.paper.symbols import Marks
from render.views import View, make_view, stack_views
from render.views.plotted import direction_deg
from render.views.scheme import Scheme

CUP_RADIUS_MM = 2.4  # radius of the cup about a spherical pair's ball
BUSHING_RADIUS_MM = 2.4  # of the bushing about a cylindrical pair's pin
ROD_OVERHANG_MM = 3.5  # of a round rod seen through its bushing, beyond it
PAIR_CLASSES = {"R": 5, "P": 5, "C": 4, "S": 3}


@dataclass(kw_only=True)
class AlignedScheme(Scheme):
    """A scheme whose pairs have the signs of a self-aligning variant."""

    aligned: Aligned

    def add_pairs(self) -> None:
        """Hinges and their legs, then the signs of cylindrical or spherical pairs."""
        super().add_pairs()
        for pair, sign in self.aligned.pairs:
            if pair.kind == "R" and sign != "R" and self.places.is_drawn(pair.point):
                self.hinges += self.pair_sign_marks(pair, sign)

    def pair_sign_marks(self, pair: Pair, sign: Sign) -> Marks:
        """A ball in its cup, open towards its link; or a pin in a bushing, seen along its axis."""
        z = self.places.point_place(pair.point)
        if sign == "C":
            return (Arc(z, BUSHING_RADIUS_MM, fill="paper"), *symbols.hinge(z))
        ways = [self.direction_to_link(z, link) for link in (pair.link, pair.other)]
        towards = next((math.degrees(math.atan2(w.imag, w.real)) for w in ways if w), 0.0)
        return (Arc(z, CUP_RADIUS_MM, towards + 55, towards + 305), *symbols.hinge(z))

    def direction_to_link(self, z: complex, link: str) -> complex:
        """The direction from a pair towards the rest of a link."""
        points = [self.places.point_place(p) - z for p in self.mechanism.link(link).points if self.places.is_drawn(p)]
        if link != FRAME:
            return max((w for w in points if abs(w) > 1.0), key=abs, default=0j)
        return 0j

    def add_slider(self, link: Link, foot: complex, along: complex) -> None:
        """A cylindrical slider is a bushing: the round rod is visible through it, its axis chain-dotted."""
        super().add_slider(link, foot, along)
        pairs = (p for p in self.position.plans.structure.pairs if p.kind == "P" and p.link == link.name)
        if any(self.aligned.new_kind_of_pair(pair) == "C" for pair in pairs):  # none for a passive link
            long = self.block_size(link)[0] / 2 + ROD_OVERHANG_MM
            self.hinges.append(Line((foot - long * along, foot + long * along), "axis", "axis"))
            self.hinges += _bushing_edges(foot, direction_deg(along), self.block_size(link))

    def add_letters(self) -> None:
        """Letters of the points, with the signs of the pairs there."""
        super().add_letters()
        said = defaultdict(list)
        for pair, sign in self.aligned.pairs:
            short = say(f"short_{sign}", self.naming.lang)
            if pair.kind == "R":
                said[pair.point].append(short)
            elif self.places.is_drawn((link := self.mechanism.links[pair.link]).first_point):
                foot, _ = self.places.foot_on_guide(link)
                text = f"{sliding_pair_name(pair, self.naming)}_{{{short}}}"
                self.named.append(Label(text, foot, 3.5, clear=4.5, name=f"sign {pair.guide}"))
        for k, label in enumerate(self.named):
            if label.name in said and label.name in self.shared:
                text = f"{label.text}_{{{', '.join(said[label.name])}}}"
                self.named[k] = replace(label, text=text, clear=CUP_RADIUS_MM)


def _bushing_edges(foot: complex, angle: float, size: Size) -> Marks:
    """Short strokes over both ends of a slider's block: the edges of its bore."""
    along = symbols.unit_vector(angle)
    long, wide = size
    starts = (foot + side * 1j * along * (0.28 * wide) for side in (-1, 1))
    return tuple(Line((z - long / 2 * along, z + long / 2 * along), "thin") for z in starts)


def sliding_pair_name(pair: Pair, naming: Naming) -> str:
    """A sliding pair by its links: "(4–5)"."""
    return f"({'–'.join(sorted(map(naming.link_number, (pair.other, pair.link))))})"


def alignment_view(position: Position, aligned: Aligned, naming: Naming, title: str, letter: float) -> View:
    """Scheme, count and signs, one beneath another."""
    scheme = AlignedScheme(position, naming, aligned=aligned)
    drawn = make_view("self-aligning", title, scheme.drawn_marks(False), figure=True)
    return stack_views("self-aligning", [drawn, alignment_text_view(aligned, naming, "", letter)])


def alignment_text_view(aligned: Aligned, naming: Naming, title: str, letter: float) -> View:
    """Count and signs."""
    count = make_view("self-aligning", title, mobility_formula(aligned, letter))
    signs = pair_sign_legend(aligned, naming, letter)
    return stack_views("self-aligning", [count, signs])


def mobility_formula(aligned: Aligned, letter: float) -> list[Mark]:
    """The formula of Somov and Malyshev, with its numbers beneath."""
    p1, p2, p3 = aligned.pair_counts_by_class
    freedom = aligned.degree_of_freedom
    redundant = aligned.redundant_constraints
    numbers = f"= 6·{aligned.n} − 5·{p1} − 4·{p2} − 3·{p3} = {freedom};   q = {redundant}"
    lines = ("W = 6n − 5p_{1} − 4p_{2} − 3p_{3} =", numbers)
    high = 1.4 * letter
    return [Text(line, complex(0, -1.9 * high * k), high) for k, line in enumerate(lines)]


def pair_sign_legend(aligned: Aligned, naming: Naming, letter: float) -> View:
    """The sign of every kind of pair present, seen from its side, with its name, class and places."""
    marks = []
    there = {sign for _, sign in aligned.pairs}
    for row, kind in enumerate(k for k in PAIR_CLASSES if k in there):
        y = -13.0 * row
        marks += [move_mark(m, 1j * y) for m in _PAIR_SIGNS[kind]]
        named = [p for p, sign in aligned.pairs if sign == kind]
        places = ", ".join(naming.lettered_point(p.point) if p.point else sliding_pair_name(p, naming) for p in named)
        words = say(f"pair_{kind}", naming.lang, cls=PAIR_CLASSES[kind])
        marks.append(Text(f"{words}: {places}", complex(16, y - letter / 2), letter))
    return make_view("signs", "", marks)


_SHAFT_STROKES = (
    *(Line((complex(-4, y), complex(4, y))) for y in (-2.2, 2.2)),  # a rod in a sleeve, in which it turns and slides
    Line((-10 + 0j, 10 + 0j)),
)
_LEGEND_CUP_RADIUS_MM = 1.7 * HINGE_RADIUS_MM * 1.2
_PAIR_SIGNS = {
    "R": (
        *_SHAFT_STROKES,
        *(Line((complex(x, -1.8), complex(x, 1.8))) for x in (-5.2, 5.2)),
    ),  # a shaft held by collars
    "P": (*symbols.hatched_base(-3.25j, 0, 18.0), *symbols.block(0j)),
    "C": _SHAFT_STROKES,
    "S": (
        Arc(0j, _LEGEND_CUP_RADIUS_MM, 55, 305),
        Line((HINGE_RADIUS_MM + 0j, 10 + 0j)),
        Line((-_LEGEND_CUP_RADIUS_MM + 0j, -10 + 0j)),
        *symbols.hinge(0j),
    ),
}
"""The signs of ГОСТ 2.770, seen from the side."""
