"""The explanatory note of a scene of vectors: no structure, no mechanism, only the vectors and values found."""

from collections.abc import Sequence

from planes.lesson.note import Note
from planes.plans.statements.of_scene import names_to_find
from planes.scene import Scene
from planes.solving import Position
from planes.solving.document import Block, Blocks, Heading, Paragraph
from planes.solving.text_tables import ZERO_RESULT_RATIO, largest_equilibrium_result
from planes.words import Lang
from planes.words.names import NO_PLAN, PlanId
from planes.words.units import number_text


class StatedNote(Note):
    """Writes that note."""

    task = "note_task_stated"
    given_table = "note_stated_table"
    alone = "note_link_forces"

    def document_blocks(self) -> list[Block]:
        return [*self.opening_blocks(), *self.plan_blocks(), *self.vectors_table()]

    def answer_blocks(self) -> Blocks:
        return self.vectors_table()

    def wanted_results(self) -> Sequence[str]:
        """The requested results, or all vectors without given data, and the values."""
        given = self.given_vectors()
        return names_to_find(self.scene) or [*(n for n in self.plans.vectors if n not in given), *self.plans.values]

    def given_vectors(self) -> set[str]:
        """The vectors with given length and direction."""
        return {t.name for e in self.plans.equations for t in e.all_terms if t.known_part_count == 2 and not t.drawn}

    def vectors_table(self) -> Blocks:
        """The results of a scene of vectors."""
        yield Heading(self.say("note_results"))
        vectors, values = (self.position.of(group).values() for group in ("vectors", "values"))
        head = tuple(map(self.say, ("note_vector", "value", "note_angle", "note_unit")))
        rows = [(f"⟨{f.quantity.name}⟩", *self.vector_cells(f), self.say(f.unit)) for f in vectors]
        yield from self.numbered_table("note_vectors_table", head, rows)
        noise = ZERO_RESULT_RATIO * largest_equilibrium_result(self.position)
        head = tuple(map(self.say, ("quantity", "value", "note_unit")))
        rounded = ((f, f.number if abs(f.number) > noise else 0.0) for f in values)
        computed = [
            (f"⟨{f.quantity.name}⟩", number_text(x, self.lang), f.unit and self.say(f.unit)) for f, x in rounded
        ]
        yield from self.numbered_table("note_values_table", head, computed)
        yield from self.result_warnings()


class StaticsNote(StatedNote):
    """The note of bodies in equilibrium: why they are determinate, a space diagram, diagrams of a beam."""

    task = "note_task_statics"

    def given_vectors(self) -> set[str]:
        """The loads."""
        return {f.name for f in self.plans.acting.every}

    def document_blocks(self) -> list[Block]:
        figure = self.plans.figure
        assert figure
        blocks = [*self.opening_blocks(), *(Paragraph(x.told(self.lang)) for x in figure.counted), *self.plan_blocks()]
        if figure.moments:
            blocks.append(self.numbered_figure("beam", self.say("beam_diagrams")))
        return [*blocks, *self.vectors_table()]

    def plan_heading(self, plan: PlanId) -> str:
        if plan == "position":
            return self.say("space_diagram")
        return super().plan_heading(plan)

    def plan_caption(self, plan: PlanId, group: PlanId = NO_PLAN) -> str:
        if plan == "position":
            return self.say("note_space", mu=self.scale_text(plan))
        return super().plan_caption(plan, group)


def position_note(scene: Scene, position: Position, lang: Lang) -> Note:
    """The note of a position, for any kind of scene."""
    plain = StaticsNote if position.plans.figure else StatedNote
    return (Note if position.plans.has_mechanism else plain)(scene, position, lang)
