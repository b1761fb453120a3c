"""The origin of a vector equation, explained before it is drawn, and the sense of a link's rotation, before its angular
velocity."""

from collections.abc import Iterator
from functools import cached_property
from itertools import permutations

from planes.drafting.equations import Equation, Term
from planes.drafting.steps.reckoning import Calculate
from planes.lesson.formulas import value_slot
from planes.lesson.frame import Frame, Frames, Make
from planes.lesson.reckoning import displayed_name, value_and_length
from planes.lesson.steps import displayed_term_name, without_repeats
from planes.plans import Plans
from planes.plans.force.loads import name_of_force
from planes.words import Phrase
from planes.words.frozen import frozen, replace
from planes.words.names import NameTriple, PlanId, scheme_mark, split_value_name

VECTOR_LETTERS_BY_PLAN = {"velocity": "v", "acceleration": "a"}


@frozen
class GuidedPoint:
    """The ``other`` point, on the link with a guide, that coincides with the ``point`` of a slider; "" on the frame."""

    point: str
    other: str
    link: str
    guide: str


@frozen
class Stating:
    """Explains the equations of a mechanism, and the rotation of its links."""

    plans: Plans

    def insert_vector_equations(self, frames: Frames, make: Make) -> Frames:
        """The frames, each vector equation before the first frame that draws one of its vectors."""
        frames_with_equations = []
        stated_equations = set()
        for f in frames:
            new = (
                f.equation not in stated_equations and f.plan != "position" and self.plans.has_mechanism
            )  # otherwise given
            if f.equation is not None and new:
                stated_equations.add(f.equation)
                e = self.plans.equations[f.equation]
                named = {"equation": self.equation_in_letters(e), "unknown": self.unknowns_phrase(e)}
                frame = make("equation", f.plan, reason=self.equation_reason(e), terms=(), **named)
                frames_with_equations.append(replace(frame, equation=f.equation))
            frames_with_equations.append(f)
        return frames_with_equations

    def equation_in_letters(self, e: Equation) -> str:
        """The equation in letters, without a side that is the total itself, along a guide of the frame."""
        chains = [list(dict.fromkeys(displayed_term_name(e, t.name) for t in chain)) for chain in e.chains]
        if e.total is None:
            return " + ".join(f"⟨{n}⟩" for chain in chains for n in chain) + " = 0"
        along = any(
            t.action == "=0" and t.name.endswith("0") for t in e.all_terms
        )  # the absolute vector along that guide
        sides = [names for names in chains if names and not (along and e.total in names)]
        return " = ".join([f"⟨{e.total}⟩", *(" + ".join(f"⟨{n}⟩" for n in names if n != e.total) for names in sides)])

    def unknowns_phrase(self, e: Equation) -> Phrase:
        """What is sought, in words."""
        parts: dict[str, dict[str, None]] = {}
        for name, part in e.unknown_parts:
            parts.setdefault(part, {})[f"⟨{displayed_term_name(e, name)}⟩"] = None
        said = (
            Phrase(f"lesson_unknown_{part}{'s' * (len(names) > 1)}", names=(*names,)) for part, names in parts.items()
        )
        return Phrase("lesson_unknowns", parts=(*said,))

    def equation_reason(self, e: Equation) -> Phrase:
        """For forces, the bodies in equilibrium; for velocities and accelerations, the two motions of a point."""
        if e.plan.kind in VECTOR_LETTERS_BY_PLAN:
            parts = without_repeats(self.relative_motion_phrases(e))
            if parts:
                return Phrase("why_equation_parts", parts=parts)
            return Phrase("why_equation_circle")
        links = tuple(e.plan.links)
        inner = {name_of_force(a, b): a for a, b in permutations(links, 2)}
        links = next(((inner[t.name],) for t in e.all_terms if t.name in inner), links)
        return Phrase("why_equation_links" if len(links) > 1 else "why_equation_link", links="–".join(links))

    def relative_motion_phrases(self, e: Equation) -> Iterator[Phrase]:
        """The motion of each relative vector."""
        for term in e.all_terms:
            _, index, _ = split_value_name(term.name)
            if link := self.links_by_point_pair.get(index):
                yield Phrase("why_equation_turns", one=link[1], two=link[2], link=link[0])
            elif under := self.slider_of_vector(term):
                key = "why_equation_slides" if under.other else "why_equation_guide"
                key = key if under.guide else "why_equation_driven"
                yield Phrase(key, **vars(under))

    @cached_property
    def guided_points_by_motion(self) -> dict[str, GuidedPoint]:
        """The sliders by the names of their motion relative to the guide: HL, B3B."""
        m = self.plans.mechanism
        sliders = {}
        for x in m.links.values():
            if x.slides:
                owner = m.owner_of_guide(x.slides.guide)
                for pair in (split_value_name(s.name)[1] for s in self.plans.segments if s.plan == "velocity"):
                    p = x.first_point
                    other = pair.removesuffix(p) if pair.endswith(p) else pair.removeprefix(p)
                    marks = m.guide(x.slides.guide).mark, p + owner
                    if p != pair and other not in (pair, "", "0") and owner in m.links and other in marks:
                        sliders[pair] = GuidedPoint(p, other, owner, x.slides.guide)
        return self.driven() | sliders

    def driven(self) -> dict[str, GuidedPoint]:
        """The hinge moved by a drive inside a group, by the names of its motion relative to the link on the frame."""
        for g in self.plans.structure.driven:
            means = (t.means for e in self.plans.equations for t in e.all_terms if t.means)
            hinge = g.inner.point
            guide = g.drive.guide if g.drive else ""
            given = (m.of for m in means if m.quantity == "relative")
            return {index: GuidedPoint(hinge, index.removeprefix(hinge), g.held_link, guide) for index in given}
        return {}

    def slider_of_vector(self, term: Term) -> GuidedPoint | None:
        """The slider whose motion along a guide a vector is."""
        line = self.plans.means.get(term.direction or "")
        _, index, _ = split_value_name(term.name)
        if index in self.guided_points_by_motion or line is None or line.quantity != "along":
            return self.guided_points_by_motion.get(index)
        frame = self.plans.mechanism.frame
        links = self.plans.mechanism.links.values()
        point = next((x.first_point for x in links if x.slides and x.slides.guide == line.line_name), "")
        if point and line.line_name in frame.guides:
            return GuidedPoint(point, "", frame.name, line.line_name)
        return None

    @cached_property
    def links_by_point_pair(self) -> dict[str, NameTriple]:
        """The link with both points of "CB", and these; a point under a slider is on its link too."""
        own = {x.name: {*x.points} for x in self.plans.mechanism.links.values()}
        for under in self.guided_points_by_motion.values():
            own[under.link].add(under.other)
        return {a + b: (link, a, b) for link, points in own.items() for a, b in permutations(sorted(points), 2)}

    def rotation_sense_frames(self, rates: list[Calculate], plan: PlanId, make: Make) -> Iterator[Frame]:
        """For each angular velocity or acceleration given by a vector over a length, the vector carried to its
        point."""
        places = {under.other: under.point for under in self.guided_points_by_motion.values()}
        for rate in rates:
            vector = displayed_name((value_and_length(rate) or ("",))[0])
            letter, index, _ = split_value_name(vector)
            link = self.links_by_point_pair.get(index)
            if link and letter in VECTOR_LETTERS_BY_PLAN.values():
                name, point, about = link
                ends = {"point": point, "about": about}
                vectors = {"vector": vector, "rate": rate.makes}
                sense = value_slot(rate.makes, "s")
                frame = make("sense", plan, terms=(vector,), link=name, sense=sense, **ends, **vectors)
                spots = {k: scheme_mark(places.get(p, p)) for k, p in ends.items()}
                yield replace(frame, turns={**spots, **vectors})
