"""The questions asked at the defence of a sheet, each answered from its scene: the parts of the note in another order,
between words about this mechanism."""

import re
from collections.abc import Iterable, Mapping
from functools import cached_property
from itertools import count

from planes.diagrams.summary import Summary, summary_of_scene
from planes.diagrams.text import stroke_sentences
from planes.lesson.formulas import in_brackets
from planes.lesson.note import Note
from planes.plans.assur.alignment import group_pairs
from planes.plans.assur.groups import Group, Pair
from planes.plans.curves import curves_by_name, driven_link_analogues, driven_link_and_sliding, driven_link_curves
from planes.plans.force.loads import names_of_loads
from planes.plans.measuring import counted_structure_numbers
from planes.scene.mechanism import FRAME
from planes.solving.document import Block, Blocks, Chart, Figure, Heading, Paragraph, PlottedLine
from planes.words import put_decimal_signs, sentence_table
from planes.words.frozen import replace
from planes.words.lettering import without_index_markup
from planes.words.names import RATE_PLANS, SCHEME_PLAN, NamePair, NamesByName, PlanTuple

QUESTIONS_BY_CHAPTER: NamesByName = {
    "structure": "link pair chain apart mobility surplus synthesis groups classes",
    "kinematics": "extremes graph scheme order polygons omega similar analytic normal coriolis size_k",
    "forces": "tasks external stages before determinate reactions inertia last statics_surplus",
}
"""The questions of each chapter, by the keys of their words."""
ANSWERING_FRAMES: Mapping[str, NamePair] = {
    "order": ("equation", "-"),
    "omega": ("sense", "(omega|epsilon)_"),
    "similar": ("similar image", "-"),
    "normal": ("", r"a_\w+\^n"),
    "size_k": ("", r"a_\w+\^k"),
    "inertia": ("", "M?I_"),
}
"""The frames of the lesson that answer a question, and the pattern of results whose lines of calculation do."""
ANSWERING_FIGURES: Mapping[str, PlanTuple] = {"scheme": (SCHEME_PLAN,), "polygons": RATE_PLANS}


class Questions(Note):
    """Writes the questions and answers of one position of a mechanism."""

    def __post_init__(self) -> None:
        super().__post_init__()
        self.s = self.plans.structure
        self.m = self.plans.mechanism

    def document_blocks(self) -> list[Block]:
        """All questions, in three chapters, numbered throughout."""
        numbers = count(1)
        cover = self.title_page_blocks(self.scene.title.get(self.lang, ""))
        blocks: list[Block] = [replace(cover, kind=self.say("questions"))]
        for chapter, keys in QUESTIONS_BY_CHAPTER.items():
            blocks.append(Heading(self.say(f"questions_{chapter}")))
            for key in keys.split():
                blocks.append(Heading(f"{next(numbers)}. {self.say(f'question_{key}')}", 2))
                blocks += self.scene_sentence(f"reply_{key}")
                blocks += (
                    self.answer_for_scene(key)
                    if self.m.loaded or chapter != "forces"
                    else self.scene_sentence("reply_no_forces")
                )
        return blocks

    def answer_for_scene(self, key: str) -> list[Block]:
        """What this mechanism gives for an answer; where that is nothing, why the question does not arise."""
        shown = [
            *self.scene_sentence(f"reply_{key}_here"),
            *self.lesson_frames_blocks(*ANSWERING_FRAMES.get(key, ("", "-"))),
        ]
        shown += (self.plan_figure(plan) for plan in ANSWERING_FIGURES.get(key, ()) if plan in self.plans.plan_names)
        return [*shown, *getattr(self, f"of_{key}", tuple)()] or [*self.scene_sentence(f"reply_{key}_none")]

    def scene_sentence(self, key: str, **more: object) -> Blocks:
        """A sentence about the scene, if there is one for the key."""
        if key in sentence_table("en", "questions"):
            yield Paragraph(self.say(key, **self.scene_names, **more))

    @cached_property
    def scene_names(self) -> dict[str, object]:
        """The names and numbers of the scene that answers may use."""
        s = self.s
        p = self.position
        n = len(self.m.links)
        return {
            "n": n,
            "p": len(s.pairs),
            "contours": len(s.pairs) - n,
            "level": s.mechanism_class,
            "driver": s.driver,
            **dict(zip(("W", "q"), counted_structure_numbers(s), strict=True)),
            "spatial": f"{s.W - s.q}".replace("-", "−"),
            "frame": self.naming.link_number(FRAME),
            "formula": s.formula_with_frame_number(self.scene.frame_number, True),
            "pair": self.pairs_text(s.pairs[:1]),
            "chain": s.groups[0].formula_members.replace(";", "–"),
            "backwards": " → ".join(g.formula_members for g in reversed(s.groups)),
            "output": driven_link_and_sliding(p.plans)[0],
            "curve": self.naming.lettered_curve(driven_link_curves(p.plans)[0]),
            "mu": self.scale_text(SCHEME_PLAN),
            "balancing": f"⟨{p.plans.balancing}⟩",
            "reactions": in_brackets(p.of("reactions")),
            "loads": in_brackets(names_of_loads(self.m)) or "—",
        }

    @cached_property
    def cycle_summary(self) -> Summary:
        """The whole cycle of the mechanism."""
        return summary_of_scene(self.scene)

    def pairs_text(self, pairs: Iterable[Pair]) -> str:
        """Pairs by their points or guides, and their links."""
        link = self.naming.link_number
        return ", ".join(f"⟨{p.point or p.guide}⟩ ({link(p.other)}–{link(p.link)})" for p in pairs)

    def lesson_frames_blocks(self, keys: str, results: str) -> Blocks:
        """The frames of some keys on the plans of motion; and lines of calculation, those of a vector with its
        direction."""
        given = set()
        for f in self.frames:
            rows = [r for r in f.rows if r.numbers and r.name not in given and re.match(results, r.name)]
            given |= {r.name for r in rows}
            if (rows and f.key == "lay_off") or (f.key in keys.split() and f.plan in RATE_PLANS):
                yield from self.frame_blocks(f, 0)
                continue
            yield from (self.numbered_formula(r, f.plan) for r in rows)

    of_surplus = Note.self_aligning_blocks
    of_analytic = Note.transfer_blocks
    of_determinate = Note.group_blocks
    of_last = Note.balancing_comparison

    def of_link(self) -> Blocks:
        yield from (Paragraph(f"{n} — {self.say(f'link_kind_{self.link_kind(n)}')}.") for n in self.m.links)

    def link_kind(self, name: str) -> str:
        """The kind of a link by its pairs and its motion."""
        link = self.m.links[name]
        if name == self.s.driver:
            return "driver"
        if link.slides:
            if self.m.owner_of_guide(link.slides.guide) == FRAME:
                return "slider"
            return "block"
        if not any(p.has_link(name) and p.has_link(FRAME) for p in self.s.pairs):
            return "rod_guide" if link.guides else "rod"
        rounds = self.cycle_summary.grid.turns_fully(curves_by_name(self.plans)[f"phi_{name}"])
        if link.guides:
            return "lever"
        if rounds:
            return "crank"
        return "rocker"

    def of_pair(self) -> Blocks:
        for kind in "RP":
            if some := self.pairs_text(p for p in self.s.pairs if p.kind == kind):
                yield Paragraph(f"{self.say(f'pair_kind_{kind}')}: {some}.")

    def of_groups(self) -> Blocks:
        for g, classed in zip(self.s.groups, self.group_blocks(), strict=True):
            outer = [p for p in group_pairs(g) if {p.link, p.other} - {*g.all_links}]
            yield classed
            yield from self.scene_sentence("reply_join", order=len(outer), pairs=self.pairs_text(outer))

    def of_extremes(self) -> Blocks:
        first = self.s.groups[0]
        kind = first.kind if isinstance(first, Group) and self.m.drive.rotates else 0
        yield from self.scene_sentence(f"reply_extremes_{kind}")
        for line in stroke_sentences(self.cycle_summary, self.lang) or [self.say("reply_extremes_none")]:
            line = re.sub(r"(\w+_\w+)(?= =)", r"⟨\1⟩", line.replace("= -", "= −"))
            yield Paragraph(put_decimal_signs(line, self.lang))

    def of_graph(self) -> Blocks:
        plans = self.plans
        grid = self.cycle_summary.grid
        unit = "°" if plans.drive.rotates else self.say("m")
        over = f"{without_index_markup(self.naming.lettered_curve(plans.drive.motion_names[0]))}, {unit}"
        for name in (driven_link_curves(plans)[0], *driven_link_analogues(plans)):
            curve = curves_by_name(plans)[name]
            label = f"{without_index_markup(self.naming.lettered_curve(name))}, {self.say(curve.unit)}".removesuffix(
                ", 1"
            )
            yield Figure(Chart(over, label, (PlottedLine(grid.places, grid.curve_values(curve)),), height_mm=40))

    def of_coriolis(self) -> Blocks:
        for link, slide in self.plans.acceleration_slides.items():
            owner = self.naming.link_number(self.m.owner_of_guide(slide.guide))
            key = f"reply_coriolis_{'turns' if slide.coriolis else 'still'}"
            yield from self.scene_sentence(key, link=link, guide=f"⟨{slide.guide}⟩", owner=owner)

    def of_external(self) -> Blocks:
        yield self.numbered_figure("loaded", self.say("loaded"))

    def of_stages(self) -> Blocks:
        for plan in self.plans.force_plans:
            for f in self.frames:
                if f.plan == plan and f.key in ("free_body", "equation"):
                    yield from self.frame_blocks(f, 0)
            yield self.plan_figure(plan)

    def of_reactions(self) -> Blocks:
        rubbing = ", ".join((*self.m.friction, *self.m.journals))
        yield from self.scene_sentence("reply_friction" if rubbing else "reply_no_friction", pairs=rubbing)
        yield from self.reactions_table()
