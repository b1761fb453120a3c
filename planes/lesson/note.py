"""The explanatory note: the frames of a lesson as prose, with tables and figures, in the usual order."""

import cmath
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import count, groupby
from pathlib import Path

from planes.check.grading.by_hand import unsure
from planes.lesson import Teller, value_of
from planes.lesson.conditions import conditions
from planes.lesson.formulas import NOISE, fill, mu_said, unit
from planes.lesson.frame import ROW, Frame
from planes.lesson.mathematics import Typesetter
from planes.lesson.rows import Row, remark
from planes.lesson.standing import still_said
from planes.lesson.transfers import TransferFunctions
from planes.plans.apart import links_apart
from planes.plans.assur.alignment import aligned
from planes.plans.measuring import counted, lettering
from planes.plans.quantities import Measured
from planes.plans.statements.of_scene import found_of
from planes.scene import Scene
from planes.scene.mechanism import FRAME
from planes.solving import Position, told
from planes.solving.document import Block, Cover, DocumentTable, DrawnViews, Figure, Formula, Heading, Paragraph
from planes.solving.given import GivenTable
from planes.solving.own_equations import own_rows
from planes.solving.structure_text import alignment_report, group_counted, ways_told
from planes.solving.tables import difference
from planes.words import Lang, capital, decimal, say, text_in
from planes.words.errors import PlanesError
from planes.words.lettering import plan_phrase
from planes.words.names import kind_of, links_of
from planes.words.naming import Naming
from planes.words.units import number

BLANK = "_" * 24  # a name to be written by hand


def student_said(name: str, scene: Scene, lang: Lang) -> str:
    """The owner of a scene: the student, and the group if given."""
    group = str(scene.sheet.get("group", ""))
    return say("task_student", lang, name=name) + (say("task_group", lang, group=group) if group else "")


@dataclass
class Note:
    """Writes the note of one position of a scene."""

    scene: Scene
    position: Position
    lang: Lang
    task = "note_task"  # words that differ where vectors are stated
    given_table = "note_given_table"
    alone = "note_driver"

    def __post_init__(self) -> None:
        p = self.position
        self.teller = Teller(p.plans, p.drawing, convention=self.scene.mu_convention)
        self.frames = self.teller.frames()
        self.naming = Naming(self.lang, **lettering(self.scene, p.plans))
        self.tables = self.figures = self.formulas = 0
        self.given: set[str] = set()  # reasons given already

    def blocks(self) -> list[Block]:
        """The whole note."""
        return [*self.opening(), *self.structure(), *self.plans(), *self.results()]

    def answers(self) -> Iterator[Block]:
        """The results, without the derivation."""
        return iter([*self.structure(), *self.results()])

    def say(self, key: str, **names: object) -> str:
        return say(key, self.lang, **names)

    def table(self, key: str, head: tuple[str, ...], rows: Sequence[tuple[str, ...]]) -> Iterator[Block]:
        """A numbered table, unless it is empty."""
        if rows:
            self.tables += 1
            yield DocumentTable(self.say("note_table", number=self.tables, title=self.say(key)), (head, *rows))

    def figure(self, key: str, title: str = "") -> Figure:
        """A view, numbered if it has a title."""
        self.figures += bool(title)
        caption = self.say("note_figure", number=self.figures, title=title) if title else ""
        return Figure(DrawnViews(self.scene, self.position, ((key,),)), caption)

    def drawn(self, plan: str) -> Figure:
        """The figure of a plan, or of the scheme."""
        return self.figure("scheme" if plan == "position" else plan, self.caption(plan))

    def opening(self) -> Iterator[Block]:
        """Title, task and given numbers."""
        plans, drive = self.position.plans, self.position.plans.drive
        title = text_in(self.lang, self.scene.title)
        yield self.cover(title)
        yield Heading(self.say("note_given"))
        where = told(self.position.at, drive.kind, self.lang)
        where = f"{'φ' if drive.rotates else 's'} = {decimal(where, self.lang)}"
        asked = tuple(f"⟨{name}⟩" for name in self.sought())
        named = {"title": title or Path(self.scene.file).stem, "drive": where, "names": asked}
        yield Paragraph(self.say(f"{self.task}_find" if asked else "note_task", **named))
        head = tuple(map(self.say, ("quantity", "value", "note_unit")))
        given = GivenTable(self.position, self.naming, self.scene.used)
        yield from self.table(self.given_table, head, [*given.rows(), *given.laws()])
        yield from map(Paragraph, conditions(plans, self.lang))
        if remark := text_in(self.lang, self.scene.note):
            yield Paragraph(self.say("note_remark", text=" ".join(remark.split())))

    def cover(self, title: str) -> Cover:
        """The title page by the cells of the sheet's title block; lines to fill in for whom it does not name."""
        cells = {key: str(cell) for key, cell in self.scene.sheet.items()}
        above = tuple(cells[key] for key in ("university", "company", "department") if cells.get(key))
        student = ", ".join(cells[key] for key in ("student", "group") if cells.get(key)) or BLANK
        people = (
            f"{self.say('note_student')}: {student}",
            f"{self.say('note_teacher')}: {cells.get('teacher') or BLANK}",
        )
        return Cover(self.say("note"), self.say("note_contents"), title, above, people, cells.get("date", ""))

    def sought(self) -> Sequence[str]:
        """The results that the task asks for."""
        return found_of(self.scene)

    def structure(self) -> Iterator[Block]:
        """Degree of freedom, groups, formula."""
        s, n = self.position.plans.structure, len(self.position.plans.mechanism.links)
        freedom, redundant = counted(s)
        told_of = self.say("note_freedom", n=n, p=len(s.pairs), W=freedom, q=redundant)
        yield from (Heading(self.say("note_structure")), Paragraph(told_of))
        yield from self.groups()
        yield Paragraph(self.say("note_formula", formula=s.formula_as(self.scene.frame_number, True)))
        for way in ways_told(s, self.lang, self.naming.frame, True):
            yield Paragraph(capital(way) + ".")
        yield from [Paragraph(self.say("passive", links=", ".join(s.passive)) + ".")] if s.passive else []
        yield from self.self_aligning() if self.scene.find is None else ()

    def groups(self) -> Iterator[Paragraph]:
        """The class of each group, and why it is determinate."""
        for g in self.position.plans.structure.groups:
            told_of = self.say("note_group_class", links=", ".join(g.whole), said=g.said.told(self.lang))
            yield Paragraph(" ".join([told_of, *group_counted(g, self.lang)]))

    def self_aligning(self) -> Iterator[Block]:
        """The variant without redundant constraints, where there is one."""
        try:
            variant = aligned(self.position.plans, self.scene.file)
        except PlanesError:
            return
        count, numbers, *pairs = alignment_report(variant, self.lang, self.naming.frame).splitlines()
        yield Paragraph(f"{self.say('note_self_aligning')} {count}.")
        yield Paragraph(f"{numbers}: {'; '.join(pair.strip() for pair in pairs)}.")
        yield self.figure("self-aligning", self.say("note_aligned"))

    def plans(self) -> Iterator[Block]:
        """Every plan with its equations, its steps in words, and its figure."""
        numbers = count(1)
        for plan, chapter in groupby(self.frames, key=lambda frame: frame.chapter):
            yield Heading(self.heading(plan))
            steps = [[*self.prose(frame, next(numbers))] for frame in chapter]
            if figures := [*self.loaded(plan)]:  # of the forces that the first step names
                yield from steps.pop(0)
            yield from figures
            if plan not in ("position", "lever"):
                yield self.figure(f"equations {plan}")
            for step in steps:
                yield from step
            if plan == "lever":
                yield from self.compared()
                continue
            yield self.drawn(plan)
            for one in links_apart(self.position.plans, plan):
                if one.polygon and one.marks(self.position.plans, self.position.drawing):
                    yield self.figure(one.plan, self.caption(one.plan, plan))
            if plan == "velocity" and self.scene.find is None:
                yield from self.transfers()

    def loaded(self, plan: str) -> Iterator[Block]:
        """The free body of a force polygon: first the mechanism with its loads, then the links with their forces and
        arms; for the lever its forces."""
        plans = self.position.plans
        if not plans.moves:
            return
        mu = f", μ = {self.mu('velocity' if plan == 'lever' else 'position')}"
        if plan == "lever":
            yield self.figure("lever", self.say("lever") + mu)
        if kind_of(plan) == "force":
            if plan == plans.forces[0]:
                yield self.figure("loaded", self.say("loaded") + mu)
            links = links_of(plan)
            key = "group" if len(links) > 1 else "driver" if links == (plans.structure.driver,) else "link"
            title = self.say(f"loaded_{key}", links="–".join(map(self.naming.link, links)))
            yield self.figure(f"group {plan}", title + mu)

    def mu(self, plan: str) -> str:
        """The scale of a plan, as written in this language."""
        return fill(mu_said(plan, self.lang, self.scene.mu_convention), self.position.scales.__getitem__, self.lang)

    def transfers(self) -> Iterator[Block]:
        """Analogues of velocities and ratios, by segments of the velocity plan."""
        rows = [tuple(row) for row in TransferFunctions(self.position, self.naming).rows()]
        head = tuple(map(self.say, ("quantity", "note_by_segments", "value", "note_unit")))
        yield from self.table("of_transfers", head, rows)

    def heading(self, plan: str) -> str:
        if kind_of(plan) != "force":
            return self.say(f"note_{plan}")
        links = [x for x in links_of(plan) if x]
        driver = tuple(links) == (self.position.plans.structure.driver,)
        alone = self.alone if driver else "note_link_forces"
        return self.say("note_group" if len(links) > 1 else alone if links else "note_forces", links=", ".join(links))

    def caption(self, plan: str, group: str = "") -> str:
        mu = self.mu(group or plan)
        if plan == "position":
            return self.say("note_scheme", mu=mu)
        return self.say("note_plan", plan=plan_phrase(plan), mu=mu)

    def prose(self, frame: Frame, index: int) -> Iterator[Block]:
        """A frame in words, its lines of reckoning set apart."""
        lead, *after = ROW.split(frame.marked[self.lang])
        yield Paragraph(fill(lead.strip() or self.say("note_reckon"), self.read, self.lang), index, frame.plan)
        for k, text in zip(after[::2], after[1::2], strict=True):
            row = frame.rows[int(k)]
            yield self.formula(row, frame.plan)
            text += "" if row.head else remark(row.kind, self.lang)
            if words := text.lstrip(".,:; "):
                yield Paragraph(fill(words, self.read, self.lang), plan=frame.plan)
        if still := still_said(frame, self.position.drawing, self.lang):
            yield Paragraph(still, plan=frame.plan)
        why = frame.why[self.lang]
        if why and why not in self.given:
            self.given.add(why)
            yield Paragraph(why, plan=frame.plan, why=True)

    def formula(self, row: Row, plan: str) -> Formula:
        """A line of reckoning, numbered."""
        self.formulas += 1
        return Formula(Typesetter(self.read, self.naming, plan).line(row), str(self.formulas))

    def read(self, name: str) -> float:
        """A value by its name."""
        return float(value_of(name, self.teller, self.position.drawing))

    def compared(self) -> Iterator[Block]:
        """The balancing load found in two ways."""
        plans, drawing = self.position.plans, self.position.drawing
        balancing, check = float(drawing[plans.balancing]), float(drawing[plans.zhukovsky])
        percent = 100 * difference(balancing, check)
        shown = number(percent if percent > 1e-6 else 0.0, self.lang, 2)
        own, other = number(balancing, self.lang), number(check, self.lang)
        yield Paragraph(self.say("note_difference", found=own, check=other, unit=unit(plans.balancing), percent=shown))

    def results(self) -> Iterator[Block]:
        """Tables of the results, and warnings about them."""
        p, angle = self.position, self.say("note_angle")
        if self.scene.find is None and not p.plans.forces:
            yield Paragraph(self.say("note_no_forces"))
        yield Heading(self.say("note_results"))
        v, a, w, e = (unit(x).told(self.lang) for x in ("v", "a", "omega", "epsilon"))
        head = (self.say("note_point"), f"v, {v}", angle, f"a, {a}", angle)
        rows = [(f"⟨{n}⟩", *self.vector(x.get("v")), *self.vector(x.get("a"))) for n, x in p.rows("points").items()]
        yield from self.table("note_points_table", head, rows)
        shown = [(k, self.number(x.get("omega")), self.number(x.get("epsilon"))) for k, x in p.rows("links").items()]
        head_of_links = (self.say("note_link"), f"ω, {w}", f"ε, {e}")
        yield from self.table("note_links_table", head_of_links, [row for row in shown if row[0] != FRAME])
        told_of = own_rows(p, (self.scene.equations, self.scene.file), self.lang)
        yield from self.table("own_equations", (self.say("own_equations"), ""), told_of)
        yield from self.reactions()
        for f in p.found:
            if f.quantity.group.startswith("balancing"):
                size = f"⟨{f.quantity.name}⟩ = {self.number(f)} {self.say(f.unit)}"
                yield Paragraph(f"{self.say(f.quantity.group)}: {size}.")
        yield from self.warned()

    def reactions(self) -> Iterator[Block]:
        """The table of reactions, unless all are zero."""
        forces = list(self.position.of("reactions").items())
        if any(max(abs(f.vector.real), abs(f.vector.imag)) > NOISE for _, f in forces):
            head = (self.say("reaction"), f"|F|, {unit('F').told(self.lang)}", self.say("note_angle"))
            shown = [(f"⟨{k}⟩", *self.vector(f)) for k, f in forces]
            yield from self.table("note_reactions_table", head, shown)
        for name, f in self.position.of("bearings").items():
            yield Paragraph(self.say("note_bearing", name=f"⟨{name}⟩", force=self.number(f)))

    def warned(self) -> Iterator[Block]:
        """Warnings about the results."""
        names = ", ".join(f"⟨{name}⟩" for name in unsure(self.position))
        by_hand = [self.say("unsure_by_hand", names=names)] if names else []
        for warning in (*self.position.results["warnings"], *by_hand):
            yield Paragraph(self.say("note_warning", text=warning.rstrip(".")))

    def vector(self, measured: Measured | None) -> tuple[str, str]:
        """Magnitude and direction."""
        if measured is None:
            return "—", "—"
        size, angle = abs(measured.vector), math.degrees(cmath.phase(measured.vector))
        return (number(size, self.lang), number(round(angle, 1), self.lang)) if size > 1e-9 else ("0", "—")

    def number(self, measured: Measured | None) -> str:
        return "—" if measured is None else number(0.0 if abs(measured.number) <= 1e-9 else measured.number, self.lang)
