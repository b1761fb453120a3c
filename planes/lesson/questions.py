"""The questions asked at the defence of a sheet, each answered from its scene: the parts of the note in another order,
between words about this mechanism."""

import re
from collections.abc import Iterable, Iterator, Mapping
from functools import cached_property
from itertools import count

from planes.diagrams.summary import Summary, of_cycle
from planes.diagrams.text import stroke_said
from planes.lesson.note import Note
from planes.plans.assur.alignment import pairs_of
from planes.plans.assur.groups import Group, Pair
from planes.plans.curves import curves_of, driven, output_curves, transfer_curves
from planes.plans.force.loads import load_names
from planes.plans.measuring import counted
from planes.scene.mechanism import FRAME
from planes.solving.document import Block, Chart, Figure, Heading, Paragraph, PlottedLine
from planes.words import decimals, table
from planes.words.frozen import replace
from planes.words.lettering import flat

ASKED: Mapping[str, str] = {
    "structure": "link pair chain apart mobility surplus synthesis groups classes",
    "kinematics": "extremes graph scheme order polygons omega similar analytic normal coriolis size_k",
    "forces": "tasks external stages before determinate reactions inertia last statics_surplus",
}
"""The questions of each chapter, by the keys of their words."""
FRAMES: Mapping[str, tuple[str, str]] = {
    "order": ("equation", "-"),
    "omega": ("sense", "(omega|epsilon)_"),
    "similar": ("similar image", "-"),
    "normal": ("", r"a_\w+\^n"),
    "size_k": ("", r"a_\w+\^k"),
    "inertia": ("", "M?I_"),
}
"""The frames of the lesson that answer a question, and the pattern of results whose lines of calculation do."""
MOTION = ("velocity", "acceleration")
FIGURES: Mapping[str, tuple[str, ...]] = {"scheme": ("position",), "polygons": MOTION}


class Questions(Note):
    """Writes the questions and answers of one position of a mechanism."""

    def __post_init__(self) -> None:
        super().__post_init__()
        self.s, self.m = self.position.plans.structure, self.position.plans.mechanism

    def blocks(self) -> list[Block]:
        """All questions, in three chapters, numbered throughout."""
        numbers, cover = count(1), self.cover(self.scene.title.get(self.lang, ""))
        blocks: list[Block] = [replace(cover, kind=self.say("questions"))]
        for chapter, keys in ASKED.items():
            blocks.append(Heading(self.say(f"questions_{chapter}")))
            for key in keys.split():
                blocks.append(Heading(f"{next(numbers)}. {self.say(f'question_{key}')}", 2))
                blocks += self.told(f"reply_{key}")
                blocks += self.here(key) if self.m.loaded or chapter != "forces" else self.told("reply_no_forces")
        return blocks

    def here(self, key: str) -> list[Block]:
        """What this mechanism gives for an answer; where that is nothing, why the question does not arise."""
        shown = [*self.told(f"reply_{key}_here"), *self.in_frames(*FRAMES.get(key, ("", "-")))]
        shown += (self.drawn(plan) for plan in FIGURES.get(key, ()) if plan in self.position.plans.drawn)
        return [*shown, *getattr(self, f"of_{key}", tuple)()] or [*self.told(f"reply_{key}_none")]

    def told(self, key: str, **more: object) -> Iterator[Block]:
        """A sentence about the scene, if there is one for the key."""
        if key in table("en", "questions"):
            yield Paragraph(self.say(key, **self.names, **more))

    @cached_property
    def names(self) -> dict[str, object]:
        """The names and numbers of the scene that answers may use."""
        s, p, n = self.s, self.position, len(self.m.links)
        return {
            "n": n,
            "p": len(s.pairs),
            "contours": len(s.pairs) - n,
            "level": s.level,
            "driver": s.driver,
            **dict(zip(("W", "q"), counted(s), strict=True)),
            "spatial": f"{s.W - s.q}".replace("-", "−"),
            "frame": self.naming.link(FRAME),
            "formula": s.formula_as(self.scene.frame_number, True),
            "pair": self.pairs(s.pairs[:1]),
            "chain": s.groups[0].members.replace(";", "–"),
            "backwards": " → ".join(g.members for g in reversed(s.groups)),
            "output": driven(p.plans)[0],
            "curve": self.naming.curve(output_curves(p.plans)[0]),
            "mu": self.mu("position"),
            "balancing": f"⟨{p.plans.balancing}⟩",
            "reactions": ", ".join(f"⟨{name}⟩" for name in p.of("reactions")),
            "loads": ", ".join(f"⟨{name}⟩" for name in load_names(self.m)) or "—",
        }

    @cached_property
    def cycle(self) -> Summary:
        """The whole cycle of the mechanism."""
        return of_cycle(self.scene)

    def pairs(self, pairs: Iterable[Pair]) -> str:
        """Pairs by their points or guides, and their links."""
        link = self.naming.link
        return ", ".join(f"⟨{p.point or p.guide}⟩ ({link(p.other)}–{link(p.link)})" for p in pairs)

    def in_frames(self, keys: str, results: str) -> Iterator[Block]:
        """The frames of some keys on the plans of motion; and lines of calculation, those of a vector with its
        direction."""
        given = set[str]()
        for f in self.frames:
            rows = [r for r in f.rows if r.numbers and r.name not in given and re.match(results, r.name)]
            given |= {r.name for r in rows}
            if (rows and f.key == "lay_off") or (f.key in keys.split() and f.plan in MOTION):
                yield from self.prose(f, 0)
                continue
            yield from (self.formula(r, f.plan) for r in rows)

    of_surplus, of_analytic, of_determinate, of_last = Note.self_aligning, Note.transfers, Note.groups, Note.compared

    def of_link(self) -> Iterator[Block]:
        yield from (Paragraph(f"{n} — {self.say(f'link_kind_{self.kind(n)}')}.") for n in self.m.links)

    def kind(self, name: str) -> str:
        """The kind of a link by its pairs and its motion."""
        link = self.m.links[name]
        if name == self.s.driver:
            return "driver"
        if link.slides:
            return "slider" if self.m.owner(link.slides.guide) == FRAME else "block"
        if not any(p.joins(name) and p.joins(FRAME) for p in self.s.pairs):
            return "rod_guide" if link.guides else "rod"
        rounds = self.cycle.grid.rounds(curves_of(self.position.plans)[f"phi_{name}"])
        return "lever" if link.guides else "crank" if rounds else "rocker"

    def of_pair(self) -> Iterator[Block]:
        for kind in "RP":
            if some := self.pairs(p for p in self.s.pairs if p.kind == kind):
                yield Paragraph(f"{self.say(f'pair_kind_{kind}')}: {some}.")

    def of_groups(self) -> Iterator[Block]:
        for g, classed in zip(self.s.groups, self.groups(), strict=True):
            outer = [p for p in pairs_of(g) if {p.link, p.other} - {*g.whole}]
            yield classed
            yield from self.told("reply_join", order=len(outer), pairs=self.pairs(outer))

    def of_extremes(self) -> Iterator[Block]:
        first = self.s.groups[0]
        kind = first.kind if isinstance(first, Group) and self.m.drive.rotates else 0
        yield from self.told(f"reply_extremes_{kind}")
        for line in stroke_said(self.cycle, self.lang) or [self.say("reply_extremes_none")]:
            line = re.sub(r"(\w+_\w+)(?= =)", r"⟨\1⟩", line.replace("= -", "= −"))
            yield Paragraph(decimals(line, self.lang))

    def of_graph(self) -> Iterator[Block]:
        plans, grid = self.position.plans, self.cycle.grid
        over = f"{flat(self.naming.curve(plans.drive.letters[0]))}, {'°' if plans.drive.rotates else self.say('m')}"
        for name in (output_curves(plans)[0], *transfer_curves(plans)):
            curve = curves_of(plans)[name]
            label = f"{flat(self.naming.curve(name))}, {self.say(curve.unit)}".removesuffix(", 1")
            yield Figure(Chart(over, label, (PlottedLine(grid.places, grid.values(curve)),), height_mm=40))

    def of_coriolis(self) -> Iterator[Block]:
        for link, slide in self.position.plans.acceleration_slides.items():
            owner = self.naming.link(self.m.owner(slide.guide))
            key = f"reply_coriolis_{'turns' if slide.coriolis else 'still'}"
            yield from self.told(key, link=link, guide=f"⟨{slide.guide}⟩", owner=owner)

    def of_external(self) -> Iterator[Block]:
        yield self.figure("loaded", self.say("loaded"))

    def of_stages(self) -> Iterator[Block]:
        for plan in self.position.plans.forces:
            for f in self.frames:
                if f.plan == plan and f.key in ("free_body", "equation"):
                    yield from self.prose(f, 0)
            yield self.drawn(plan)

    def of_reactions(self) -> Iterator[Block]:
        rubbing = ", ".join((*self.m.friction, *self.m.journals))
        yield from self.told("reply_friction" if rubbing else "reply_no_friction", pairs=rubbing)
        yield from self.reactions()
