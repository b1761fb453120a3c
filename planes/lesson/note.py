"""The explanatory note: the frames of a lesson as prose, with tables and figures, in the usual order."""

import cmath
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import count, groupby
from pathlib import Path

from planes.check.grading.by_hand import unreliable_rate_names
from planes.lesson import Teller, slot_value
from planes.lesson.conditions import condition_sentences
from planes.lesson.formulas import LEAST_NONZERO_VALUE, fill_slots, plan_scale_text, unit_of_name
from planes.lesson.frame import ROW_PATTERN, Frame
from planes.lesson.mathematics import Typesetter
from planes.lesson.rows import Row, row_remark
from planes.lesson.standing import point_at_rest_sentence
from planes.lesson.transfers import TransferFunctions
from planes.plans.apart import links_with_own_polygon
from planes.plans.assur.alignment import self_aligning_variant
from planes.plans.measuring import counted_structure_numbers, scene_lettering
from planes.plans.quantities import Measured
from planes.plans.statements.of_scene import names_to_find
from planes.scene import Scene
from planes.scene.mechanism import FRAME
from planes.solving import Position, drive_position_in_words
from planes.solving.document import Block, Blocks, Cover, DocumentTable, DrawnViews, Figure, Formula, Heading, Paragraph
from planes.solving.given import GivenTable
from planes.solving.own_equations import own_equation_rows
from planes.solving.structure_text import alignment_report, class_lowering_drivers_text, group_equilibrium_sentence
from planes.solving.tables import relative_difference
from planes.words import Lang, capitalize_first_letter, say, text_in, with_decimal_sign
from planes.words.errors import PlanesError
from planes.words.lettering import plan_phrase
from planes.words.names import NO_PLAN, SCHEME_PLAN, VELOCITY_PLAN, PlanId
from planes.words.naming import Naming
from planes.words.units import number_text

HANDWRITTEN_NAME_BLANK = "_" * 24  # a name to be written by hand


def student_and_group(name: str, scene: Scene, lang: Lang) -> str:
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
        self.plans = p.plans
        self.teller = Teller(p.plans, p.drawing, convention=self.scene.mu_convention)
        self.frames = self.teller.lesson_frames()
        self.naming = Naming(self.lang, **scene_lettering(self.scene, p.plans))
        self.tables = self.figures = self.formulas = 0
        self.given: set[str] = set()  # reasons given already

    def document_blocks(self) -> list[Block]:
        """The whole note."""
        return [*self.opening_blocks(), *self.structure_blocks(), *self.plan_blocks(), *self.result_blocks()]

    def answer_blocks(self) -> Blocks:
        """The results, without the derivation."""
        return iter([*self.structure_blocks(), *self.result_blocks()])

    def say(self, key: str, **names: object) -> str:
        return say(key, self.lang, **names)

    def numbered_table(self, key: str, head: tuple[str, ...], rows: Sequence[tuple[str, ...]]) -> Blocks:
        """A numbered table, unless it is empty."""
        if rows:
            self.tables += 1
            yield DocumentTable(self.say("note_table", number=self.tables, title=self.say(key)), (head, *rows))

    def numbered_figure(self, key: str, title: str = "") -> Figure:
        """A view, numbered if it has a title."""
        self.figures += bool(title)
        caption = self.say("note_figure", number=self.figures, title=title) if title else ""
        return Figure(DrawnViews(self.scene, self.position, ((key,),)), caption)

    def plan_figure(self, plan: PlanId) -> Figure:
        """The figure of a plan, or of the scheme."""
        return self.numbered_figure("scheme" if plan == "position" else plan, self.plan_caption(plan))

    def opening_blocks(self) -> Blocks:
        """Title, task and given numbers."""
        drive = self.plans.drive
        title = text_in(self.lang, self.scene.title)
        yield self.title_page_blocks(title)
        yield Heading(self.say("note_given"))
        where = drive_position_in_words(self.position.at, drive.kind, self.lang)
        where = f"{'φ' if drive.rotates else 's'} = {with_decimal_sign(where, self.lang)}"
        asked = tuple(f"⟨{name}⟩" for name in self.wanted_results())
        named = {"title": title or Path(self.scene.file).stem, "drive": where, "names": asked}
        yield Paragraph(self.say(f"{self.task}_find" if asked else "note_task", **named))
        head = tuple(map(self.say, ("quantity", "value", "note_unit")))
        given = GivenTable(self.position, self.naming, self.scene.used)
        yield from self.numbered_table(self.given_table, head, [*given.given_rows(), *given.load_law_rows()])
        yield from map(Paragraph, condition_sentences(self.plans, self.lang))
        if remark := text_in(self.lang, self.scene.note):
            yield Paragraph(self.say("note_remark", text=" ".join(remark.split())))

    def title_page_blocks(self, title: str) -> Cover:
        """The title page by the cells of the sheet's title block; lines to fill in for whom it does not name."""
        cells = {key: str(cell) for key, cell in self.scene.sheet.items()}
        above = tuple(cells[key] for key in ("university", "company", "department") if cells.get(key))
        student = ", ".join(cells[key] for key in ("student", "group") if cells.get(key)) or HANDWRITTEN_NAME_BLANK
        people = (
            f"{self.say('note_student')}: {student}",
            f"{self.say('note_teacher')}: {cells.get('teacher') or HANDWRITTEN_NAME_BLANK}",
        )
        return Cover(self.say("note"), self.say("note_contents"), title, above, people, cells.get("date", ""))

    def wanted_results(self) -> Sequence[str]:
        """The results that the task asks for."""
        return names_to_find(self.scene)

    def structure_blocks(self) -> Blocks:
        """Degree of freedom, groups, formula."""
        s = self.plans.structure
        n = len(self.plans.mechanism.links)
        freedom, redundant = counted_structure_numbers(s)
        told_of = self.say("note_freedom", n=n, p=len(s.pairs), W=freedom, q=redundant)
        yield from (Heading(self.say("note_structure")), Paragraph(told_of))
        yield from self.group_blocks()
        yield Paragraph(self.say("note_formula", formula=s.formula_with_frame_number(self.scene.frame_number, True)))
        for way in class_lowering_drivers_text(s, self.lang, self.naming.frame, True):
            yield Paragraph(capitalize_first_letter(way) + ".")
        yield from [Paragraph(self.say("passive", links=", ".join(s.passive)) + ".")] if s.passive else []
        yield from self.self_aligning_blocks() if self.scene.find is None else ()

    def group_blocks(self) -> Iterator[Paragraph]:
        """The class of each group, and why it is determinate."""
        for g in self.plans.structure.groups:
            told_of = self.say(
                "note_group_class", links=", ".join(g.all_links), said=g.group_description.told(self.lang)
            )
            yield Paragraph(" ".join([told_of, *group_equilibrium_sentence(g, self.lang)]))

    def self_aligning_blocks(self) -> Blocks:
        """The variant without redundant constraints, where there is one."""
        try:
            variant = self_aligning_variant(self.plans, self.scene.file)
        except PlanesError:
            return
        count, numbers, *pairs = alignment_report(variant, self.lang, self.naming.frame).splitlines()
        yield Paragraph(f"{self.say('note_self_aligning')} {count}.")
        yield Paragraph(f"{numbers}: {'; '.join(pair.strip() for pair in pairs)}.")
        yield self.numbered_figure("self-aligning", self.say("note_aligned"))

    def plan_blocks(self) -> Blocks:
        """Every plan with its equations, its steps in words, and its figure."""
        numbers = count(1)
        for plan, chapter in groupby(self.frames, key=lambda frame: frame.chapter):
            yield Heading(self.plan_heading(plan))
            steps = [[*self.frame_blocks(frame, next(numbers))] for frame in chapter]
            if figures := [*self.free_body_figures(plan)]:  # of the forces that the first step names
                yield from steps.pop(0)
            yield from figures
            if plan not in ("position", "lever"):
                yield self.numbered_figure(f"equations {plan}")
            for step in steps:
                yield from step
            if plan == "lever":
                yield from self.balancing_comparison()
                continue
            yield self.plan_figure(plan)
            for one in links_with_own_polygon(self.plans, plan):
                if one.polygon and one.vector_end_marks(self.plans, self.position.drawing):
                    yield self.numbered_figure(one.plan, self.plan_caption(one.plan, plan))
            if plan == "velocity" and self.scene.find is None:
                yield from self.transfer_blocks()

    def free_body_figures(self, plan: PlanId) -> Blocks:
        """The free body of a force polygon: first the mechanism with its loads, then the links with their forces and
        arms; for the lever its forces."""
        plans = self.plans
        if not plans.has_mechanism:
            return
        mu = f", μ = {self.scale_text(VELOCITY_PLAN if plan == 'lever' else SCHEME_PLAN)}"
        if plan == "lever":
            yield self.numbered_figure("lever", self.say("lever") + mu)
        if plan.is_force:
            if plan == plans.force_plans[0]:
                yield self.numbered_figure("loaded", self.say("loaded") + mu)
            links = plan.links
            key = "group" if len(links) > 1 else "driver" if links == (plans.structure.driver,) else "link"
            title = self.say(f"loaded_{key}", links="–".join(map(self.naming.link_number, links)))
            yield self.numbered_figure(f"group {plan}", title + mu)

    def scale_text(self, plan: PlanId) -> str:
        """The scale of a plan, as written in this language."""
        return fill_slots(
            plan_scale_text(plan, self.lang, self.scene.mu_convention), self.position.scales.__getitem__, self.lang
        )

    def transfer_blocks(self) -> Blocks:
        """Analogues of velocities and ratios, by segments of the velocity plan."""
        rows = [tuple(row) for row in TransferFunctions(self.position, self.naming).transfer_rows()]
        head = tuple(map(self.say, ("quantity", "note_by_segments", "value", "note_unit")))
        yield from self.numbered_table("of_transfers", head, rows)

    def plan_heading(self, plan: PlanId) -> str:
        if not plan.is_force:
            return self.say(f"note_{plan}")
        links = [x for x in plan.links if x]
        driver = tuple(links) == (self.plans.structure.driver,)
        alone = self.alone if driver else "note_link_forces"
        return self.say("note_group" if len(links) > 1 else alone if links else "note_forces", links=", ".join(links))

    def plan_caption(self, plan: PlanId, group: PlanId = NO_PLAN) -> str:
        mu = self.scale_text(group or plan)
        if plan == "position":
            return self.say("note_scheme", mu=mu)
        return self.say("note_plan", plan=plan_phrase(plan), mu=mu)

    def frame_blocks(self, frame: Frame, index: int) -> Blocks:
        """A frame in words, its lines of reckoning set apart."""
        lead, *after = ROW_PATTERN.split(frame.marked[self.lang])
        yield Paragraph(
            fill_slots(lead.strip() or self.say("note_reckon"), self.value_by_name, self.lang), index, frame.plan
        )
        for k, text in zip(after[::2], after[1::2], strict=True):
            row = frame.rows[int(k)]
            yield self.numbered_formula(row, frame.plan)
            text += "" if row.head else row_remark(row.kind, self.lang)
            if words := text.lstrip(".,:; "):
                yield Paragraph(fill_slots(words, self.value_by_name, self.lang), plan=frame.plan)
        if still := point_at_rest_sentence(frame, self.position.drawing, self.lang):
            yield Paragraph(still, plan=frame.plan)
        why = frame.why[self.lang]
        if why and why not in self.given:
            self.given.add(why)
            yield Paragraph(why, plan=frame.plan, why=True)

    def numbered_formula(self, row: Row, plan: PlanId) -> Formula:
        """A line of reckoning, numbered."""
        self.formulas += 1
        return Formula(Typesetter(self.value_by_name, self.naming, plan).typeset_row(row), str(self.formulas))

    def value_by_name(self, name: str) -> float:
        """A value by its name."""
        return float(slot_value(name, self.teller, self.position.drawing))

    def balancing_comparison(self) -> Blocks:
        """The balancing load found in two ways."""
        plans = self.plans
        drawing = self.position.drawing
        balancing = float(drawing[plans.balancing])
        check = float(drawing[plans.zhukovsky])
        percent = 100 * relative_difference(balancing, check)
        shown = number_text(percent if percent > 1e-6 else 0.0, self.lang, 2)
        own = number_text(balancing, self.lang)
        other = number_text(check, self.lang)
        yield Paragraph(
            self.say("note_difference", found=own, check=other, unit=unit_of_name(plans.balancing), percent=shown)
        )

    def result_blocks(self) -> Blocks:
        """Tables of the results, and warnings about them."""
        p = self.position
        angle = self.say("note_angle")
        if self.scene.find is None and not p.plans.force_plans:
            yield Paragraph(self.say("note_no_forces"))
        yield Heading(self.say("note_results"))
        v, a, w, e = (unit_of_name(x).told(self.lang) for x in ("v", "a", "omega", "epsilon"))
        head = (self.say("note_point"), f"v, {v}", angle, f"a, {a}", angle)
        rows = [
            (f"⟨{n}⟩", *self.vector_cells(x.get("v")), *self.vector_cells(x.get("a")))
            for n, x in p.rows("points").items()
        ]
        yield from self.numbered_table("note_points_table", head, rows)
        shown = [
            (k, self.number_cell(x.get("omega")), self.number_cell(x.get("epsilon")))
            for k, x in p.rows("links").items()
        ]
        head_of_links = (self.say("note_link"), f"ω, {w}", f"ε, {e}")
        yield from self.numbered_table("note_links_table", head_of_links, [row for row in shown if row[0] != FRAME])
        told_of = own_equation_rows(p, (self.scene.equations, self.scene.file), self.lang)
        yield from self.numbered_table("own_equations", (self.say("own_equations"), ""), told_of)
        yield from self.reactions_table()
        for f in p.found:
            if f.quantity.group.startswith("balancing"):
                size = f"⟨{f.quantity.name}⟩ = {self.number_cell(f)} {self.say(f.unit)}"
                yield Paragraph(f"{self.say(f.quantity.group)}: {size}.")
        yield from self.result_warnings()

    def reactions_table(self) -> Blocks:
        """The table of reactions, unless all are zero."""
        forces = list(self.position.of("reactions").items())
        if any(max(abs(f.vector.real), abs(f.vector.imag)) > LEAST_NONZERO_VALUE for _, f in forces):
            head = (self.say("reaction"), f"|F|, {unit_of_name('F').told(self.lang)}", self.say("note_angle"))
            shown = [(f"⟨{k}⟩", *self.vector_cells(f)) for k, f in forces]
            yield from self.numbered_table("note_reactions_table", head, shown)
        for name, f in self.position.of("bearings").items():
            yield Paragraph(self.say("note_bearing", name=f"⟨{name}⟩", force=self.number_cell(f)))

    def result_warnings(self) -> Blocks:
        """Warnings about the results."""
        names = ", ".join(f"⟨{name}⟩" for name in unreliable_rate_names(self.position))
        by_hand = [self.say("unsure_by_hand", names=names)] if names else []
        for warning in (*self.position.results["warnings"], *by_hand):
            yield Paragraph(self.say("note_warning", text=warning.rstrip(".")))

    def vector_cells(self, measured: Measured | None) -> tuple[str, str]:
        """Magnitude and direction."""
        if measured is None:
            return "—", "—"
        size = abs(measured.vector)
        angle = math.degrees(cmath.phase(measured.vector))
        if size > 1e-9:
            return (number_text(size, self.lang), number_text(round(angle, 1), self.lang))
        return ("0", "—")

    def number_cell(self, measured: Measured | None) -> str:
        if measured is None:
            return "—"
        return number_text(0.0 if abs(measured.number) <= 1e-9 else measured.number, self.lang)
