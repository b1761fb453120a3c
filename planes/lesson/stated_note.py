"""The explanatory note of a scene of vectors: no structure, no mechanism, only the vectors and values found."""

from collections.abc import Iterator, Sequence

from planes.lesson.note import Note
from planes.plans.statements.of_scene import found_of
from planes.scene import Scene
from planes.solving import Position
from planes.solving.document import Block, Heading, Paragraph
from planes.solving.text_tables import NOISE, largest
from planes.words import Lang
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
        plans, given = self.position.plans, self.given_vectors()
        return found_of(self.scene) or [*(n for n in plans.vectors if n not in given), *plans.values]

    def given_vectors(self) -> set[str]:
        """The vectors with given length and direction."""
        return {t.name for e in self.position.plans.equations for t in e.terms if t.known == 2 and not t.drawn}

    def vectors(self) -> Iterator[Block]:
        """The results of a scene of vectors."""
        yield Heading(self.say("note_results"))
        vectors, values = (self.position.of(group).values() for group in ("vectors", "values"))
        head = tuple(map(self.say, ("note_vector", "value", "note_angle", "note_unit")))
        rows = [(f"⟨{f.quantity.name}⟩", *self.vector(f), self.say(f.unit)) for f in vectors]
        yield from self.table("note_vectors_table", head, rows)
        noise, head = NOISE * largest(self.position), tuple(map(self.say, ("quantity", "value", "note_unit")))
        rounded = ((f, f.number if abs(f.number) > noise else 0.0) for f in values)
        computed = [(f"⟨{f.quantity.name}⟩", number(x, self.lang), f.unit and self.say(f.unit)) for f, x in rounded]
        yield from self.table("note_values_table", head, computed)
        yield from self.warned()


class StaticsNote(StatedNote):
    """The note of bodies in equilibrium: why they are determinate, a space diagram, diagrams of a beam."""

    task = "note_task_statics"

    def given_vectors(self) -> set[str]:
        """The loads."""
        return {f.name for f in self.position.plans.acting.every}

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
