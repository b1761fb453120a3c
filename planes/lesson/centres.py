"""Instantaneous centres in a lesson: a separate chapter after the velocities, if requested."""

from collections.abc import Callable, Iterator
from itertools import combinations

from planes.lesson.formulas import value_slot
from planes.lesson.frame import CENTRES_CHAPTER, Frame, Frames, Make
from planes.lesson.rows import Row
from planes.lesson.steps import Names
from planes.plans import Plans
from planes.plans.centres import Centre, CentreLine, Check, instant_centre_name
from planes.scene.mechanism import FRAME
from planes.words import Phrase
from planes.words.frozen import frozen, replace
from planes.words.names import VELOCITY_PLAN, PlanId, name_without_plan
from planes.words.records import Json

UNSEEN_CENTRE_REMARKS = ("off", "parallel", "lost")
"""What a page says of a centre that cannot be seen."""


@frozen
class CentreFrames:
    """The frames of the chapter; ``reading`` gives the row of a velocity measured on its plan."""

    plans: Plans
    make: Make
    reading: Callable[[str, PlanId], Row]

    def insert_chapter(self, frames: Frames) -> Frames:
        """The frames, the chapter after the velocities."""
        if not self.plans.centres:
            return frames
        last = max(k for k, f in enumerate(frames) if f.plan == "velocity")
        return [
            *frames[: last + 1],
            *(replace(f, chapter=CENTRES_CHAPTER) for f in self.chapter_frames()),
            *frames[last + 1 :],
        ]

    def chapter_frames(self) -> Iterator[Frame]:
        """The centres of pairs, then one after another, each with its check."""
        seen = [c for c in self.plans.centres if not c.lines and (c.along or self.are_hinged(c))]
        makes = tuple(c.mark for c in seen if c.mark)
        yield self.make("centres_first", "position", makes, **self.names_of_first_centres(seen))
        for c in self.plans.centres:
            if c not in seen:
                yield self.centre_frame(c)
                yield from (self.check_frame(k) for k in self.plans.checks if k.centre == c)
        known = {c.links for c in self.plans.centres}
        links = (FRAME, *self.plans.mechanism.links)
        pairs = (pair for pair in combinations(links, 2) if pair not in known)
        left = [f"⟨{instant_centre_name(*pair, self.plans.mechanism.frame_number)}⟩" for pair in pairs]
        if left:
            yield self.make("centres_left", "position", names=", ".join(left))

    def are_hinged(self, centre: Centre) -> bool:
        """Whether two links are hinged to each other."""
        i, j = centre.links
        return any(p.has_link(i) and p.has_link(j) and p.point == centre.point for p in self.plans.structure.pairs)

    def names_of_first_centres(self, seen: list[Centre]) -> Names:
        """The names of the centres known at once."""
        means = self.plans.means
        hinges = ", ".join(f"⟨{c.name}⟩ = ⟨{c.point}⟩" for c in seen if c.mark)
        far = ", ".join(f"⟨{c.name}⟩ {means[c.along].written_action}" for c in seen if c.along)
        return {"hinges": hinges or "—", "far": Phrase("lesson_centres_sliders", far=far) if far else ""}

    def centre_frame(self, c: Centre) -> Frame:
        """A centre found by two lines, or by a hinge of three links."""
        if not c.lines:
            return self.make("centre_same", "position", (c.mark,), name=c.name, point=c.point)
        first, second = map(self.line_phrase, (c.lines + c.lines)[:2])
        uses = tuple(dict.fromkeys(m for line in c.lines for m in (line.mark, line.other) if m))
        if c.along:
            return self.make("centre_far", "position", uses=uses, name=c.name, first=first)
        one, two = (self.plans.default_naming.link_number(x.third) for x in c.lines[:2])
        why = Phrase("why_centre", one=one, two=two)
        return self.make("centre", "position", (c.mark,), uses, why, name=c.name, first=first, second=second)

    def line_phrase(self, line: CentreLine) -> Phrase:
        """A line of centres in words."""
        one = name_without_plan(line.mark)
        if line.other:
            return Phrase("lesson_centre_line", one=one, two=name_without_plan(line.other))
        return Phrase("lesson_centre_line_far", one=one, action=self.plans.means[line.along].written_action)

    def check_frame(self, check: Check) -> Frame:
        """The same velocity twice."""
        sides = (
            (f"∣⟨{w}⟩∣ · ⟨{far}⟩", f"{value_slot(w, 'a')} · {value_slot(far)}", f"{w}*{far}") for w, far in check.sides
        )
        rows = tuple(Row(check.name, letters, numbers, value_slot(both, "a")) for letters, numbers, both in sides)
        if check.read:
            rows += (self.reading(check.name, VELOCITY_PLAN),)
        key = "centre_slider" if check.slides else "centre_speed" if check.read else "centre_equal"
        uses = (check.centre.mark,)
        return self.make(key, "position", uses=uses, rows=rows, name=check.centre.name, link=check.slides)


def crossing_lines_by_centre(plans: Plans) -> Json:
    """For a page: by centre the lines that cross in it, each by a mark and another mark, or a direction."""
    return {c.mark: [[x.mark, x.other or x.along] for x in c.lines] for c in plans.centres if c.mark}
