"""The explanatory note of a scene that states vectors: no structure, no mechanism, the vectors and values found."""

from collections.abc import Iterator, Sequence

from planes.lesson.note import Note
from planes.plans.statements.of_scene import found_of
from planes.scene import Scene
from planes.solving import Position
from planes.solving.document import Block, Heading, Paragraph
from planes.words import Lang, say
from planes.words.units import number


class StatedNote(Note):
    """Writes that note."""

    task = "note_task_stated"
    given_table = "note_stated_table"
    alone = "note_link_forces"

    def blocks(self) -> list[Block]:
        beam = [self.figure("beam", self.say("beam_diagrams"))] if self.beam else []
        return [*self.opening(), *self.counted(), *self.plans(), *beam, *self.vectors()]

    @property
    def beam(self) -> bool:
        """Whether it is of a beam with diagrams."""
        figure = self.position.plans.figure
        return bool(figure and figure.moments)

    def counted(self) -> Iterator[Block]:
        """Why bodies in equilibrium are statically determinate."""
        figure = self.position.plans.figure
        yield from (Paragraph(x.told(self.lang)) for x in figure.counted) if figure else ()

    def answers(self) -> Iterator[Block]:
        return self.vectors()

    def sought(self) -> Sequence[str]:
        """What is asked, or all vectors that are not given, and the values."""
        plans = self.position.plans
        given = {t.name for e in plans.equations for t in e.terms if t.known == 2 and not t.drawn}
        return found_of(self.scene) or [*(n for n in plans.vectors if n not in given), *plans.values]

    def transfers(self) -> Iterator[Block]:
        return iter(())

    def vectors(self) -> Iterator[Block]:
        """What was found of a scene that states vectors."""
        yield Heading(self.say("note_results"))
        angle, rows = self.say("note_angle"), []
        for f in self.position.of("vectors").values():
            rows.append((f"⟨{f.quantity.name}⟩", *self.vector(f), say(f.quantity.columns[0].unit, self.lang)))
        head: tuple[str, ...] = (self.say("note_vector"), self.say("value"), angle, self.say("note_unit"))
        yield from self.table("note_vectors_table", head, rows)
        found = ((f, f.quantity.columns[0].unit) for f in self.position.of("values").values())
        values = [(f"⟨{f.quantity.name}⟩", number(f.number, self.lang), k and say(k, self.lang)) for f, k in found]
        yield from self.table(
            "note_values_table", (self.say("quantity"), self.say("value"), self.say("note_unit")), values
        )
        yield from self.warned()


def note_of(scene: Scene, position: Position, lang: Lang) -> Note:
    """The note of a position, whatever its scene states."""
    return (Note if position.plans.moves else StatedNote)(scene, position, lang)
