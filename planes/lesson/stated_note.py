"""The explanatory note of a scene of vectors: no structure, no mechanism, only the vectors and values found."""

from collections.abc import Iterator, Sequence

from planes.lesson.note import Note
from planes.plans.statements.of_scene import found_of
from planes.scene import Scene
from planes.solving import Position
from planes.solving.document import Block, Heading, Paragraph
from planes.solving.text_tables import NOISE, largest
from planes.words import Lang, say
from planes.words.units import number


class StatedNote(Note):
    """Writes that note."""

    task = "note_task_stated"
    given_table = "note_stated_table"
    alone = "note_link_forces"

    def blocks(self) -> list[Block]:
        return [*self.opening(), *self.plans(), *self.vectors()]

    def answers(self) -> Iterator[Block]:
        return self.vectors()

    def sought(self) -> Sequence[str]:
        """The requested results, or all vectors without given data, and the values."""
        plans = self.position.plans
        given = {t.name for e in plans.equations for t in e.terms if t.known == 2 and not t.drawn}
        return found_of(self.scene) or [*(n for n in plans.vectors if n not in given), *plans.values]

    def transfers(self) -> Iterator[Block]:
        return iter(())

    def vectors(self) -> Iterator[Block]:
        """The results of a scene of vectors."""
        yield Heading(self.say("note_results"))
        angle, rows = self.say("note_angle"), []
        for f in self.position.of("vectors").values():
            rows.append((f"⟨{f.quantity.name}⟩", *self.vector(f), say(f.quantity.columns[0].unit, self.lang)))
        head: tuple[str, ...] = (self.say("note_vector"), self.say("value"), angle, self.say("note_unit"))
        yield from self.table("note_vectors_table", head, rows)
        numbers, most = (
            ((f, f.quantity.columns[0].unit) for f in self.position.of("values").values()),
            largest(self.position),
        )
        rounded = ((f, k, f.number if abs(f.number) > NOISE * most else 0.0) for f, k in numbers)
        values = [(f"⟨{f.quantity.name}⟩", number(x, self.lang), k and say(k, self.lang)) for f, k, x in rounded]
        yield from self.table(
            "note_values_table", (self.say("quantity"), self.say("value"), self.say("note_unit")), values
        )
        yield from self.warned()


class StaticsNote(StatedNote):
    """The note of bodies in equilibrium: why they are determinate, a space diagram, diagrams of a beam."""

    task = "note_task_statics"

    def sought(self) -> Sequence[str]:
        """The requested results, or all reactions, and the values."""
        plans = self.position.plans
        loads = {f.name for f in plans.acting.every}
        return found_of(self.scene) or [*(n for n in plans.vectors if n not in loads), *plans.values]

    def blocks(self) -> list[Block]:
        figure = self.position.plans.figure
        assert figure
        blocks = [*self.opening(), *(Paragraph(x.told(self.lang)) for x in figure.counted), *self.plans()]
        blocks += [self.figure("beam", self.say("beam_diagrams"))] if figure.moments else []
        return [*blocks, *self.vectors()]

    def heading(self, plan: str) -> str:
        return self.say("space_diagram") if plan == "position" else super().heading(plan)

    def caption(self, plan: str, group: str = "") -> str:
        return self.say("note_space", mu=self.mu(plan)) if plan == "position" else super().caption(plan, group)


def note_of(scene: Scene, position: Position, lang: Lang) -> Note:
    """The note of a position, for any kind of scene."""
    plain = StaticsNote if position.plans.figure else StatedNote
    return (Note if position.plans.moves else plain)(scene, position, lang)
