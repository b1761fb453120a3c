"""The origin of a vector equation, explained before it is drawn, and the sense of a link's rotation, before its angular
velocity."""

from collections.abc import Iterator
from functools import cached_property
from itertools import permutations

from planes.drafting.equations import Equation, Term
from planes.drafting.steps.reckoning import Calculate
from planes.lesson.formulas import slot
from planes.lesson.frame import Frame, Make
from planes.lesson.reckoning import plain, quotient
from planes.lesson.steps import once, whole
from planes.plans import Plans
from planes.plans.force.loads import force_name
from planes.words import Phrase
from planes.words.frozen import frozen, replace
from planes.words.names import at, kind_of, links_of, parts_of

LETTERS = {"velocity": "v", "acceleration": "a"}


@frozen
class Under:
    """The ``other`` point, on the link with a guide, that coincides with the ``point`` of a slider; "" on the frame."""

    point: str
    other: str
    link: str
    guide: str


@frozen
class Stating:
    """Explains the equations of a mechanism, and the rotation of its links."""

    plans: Plans

    def stated(self, frames: list[Frame], make: Make) -> list[Frame]:
        """The frames, each vector equation before the first frame that draws one of its vectors."""
        frames_with_equations, stated_equations = list[Frame](), set[int]()
        for f in frames:
            new = f.equation not in stated_equations and f.plan != "position" and self.plans.moves  # otherwise given
            if f.equation is not None and new:
                stated_equations.add(f.equation)
                e = self.plans.equations[f.equation]
                named = {"equation": self.written(e), "unknown": self.unknown(e)}
                frame = make("equation", f.plan, reason=self.why(e), terms=(), **named)
                frames_with_equations.append(replace(frame, equation=f.equation))
            frames_with_equations.append(f)
        return frames_with_equations

    def written(self, e: Equation) -> str:
        """The equation in letters, without a side that is the total itself, along a guide of the frame."""
        chains = [list(dict.fromkeys(whole(e, t.name) for t in chain)) for chain in e.chains]
        if e.total is None:
            return " + ".join(f"⟨{n}⟩" for chain in chains for n in chain) + " = 0"
        along = any(t.action == "=0" and t.name.endswith("0") for t in e.terms)  # the absolute vector along that guide
        sides = [names for names in chains if names and not (along and e.total in names)]
        return " = ".join([f"⟨{e.total}⟩", *(" + ".join(f"⟨{n}⟩" for n in names if n != e.total) for names in sides)])

    def unknown(self, e: Equation) -> Phrase:
        """What is sought, in words."""
        parts: dict[str, dict[str, None]] = {}
        for name, part in e.unknowns:
            parts.setdefault(part, {})[f"⟨{whole(e, name)}⟩"] = None
        said = (
            Phrase(f"lesson_unknown_{part}{'s' * (len(names) > 1)}", names=(*names,)) for part, names in parts.items()
        )
        return Phrase("lesson_unknowns", parts=(*said,))

    def why(self, e: Equation) -> Phrase:
        """For forces, the bodies in equilibrium; for velocities and accelerations, the two motions of a point."""
        if kind_of(e.plan) in LETTERS:
            parts = once(self.parted(e))
            return Phrase("why_equation_parts", parts=parts) if parts else Phrase("why_equation_circle")
        links = tuple(links_of(e.plan))
        inner = {force_name(a, b): a for a, b in permutations(links, 2)}
        links = next(((inner[t.name],) for t in e.terms if t.name in inner), links)
        return Phrase("why_equation_links" if len(links) > 1 else "why_equation_link", links="–".join(links))

    def parted(self, e: Equation) -> Iterator[Phrase]:
        """The motion of each relative vector."""
        for term in e.terms:
            _, index, _ = parts_of(term.name)
            if link := self.carrying.get(index):
                yield Phrase("why_equation_turns", one=link[1], two=link[2], link=link[0])
            elif under := self.sliding(term):
                key = "why_equation_slides" if under.other else "why_equation_guide"
                key = key if under.guide else "why_equation_driven"
                yield Phrase(key, **vars(under))

    @cached_property
    def under(self) -> dict[str, Under]:
        """The sliders by the names of their motion relative to the guide: HL, B3B."""
        m, sliders = self.plans.mechanism, {}
        for x in m.links.values():
            if x.slides:
                owner = m.owner(x.slides.guide)
                for pair in (parts_of(s.name)[1] for s in self.plans.segments if s.plan == "velocity"):
                    p = x.first_point
                    other = pair.removesuffix(p) if pair.endswith(p) else pair.removeprefix(p)
                    marks = m.guide(x.slides.guide).mark, p + owner
                    if p != pair and other not in (pair, "", "0") and owner in m.links and other in marks:
                        sliders[pair] = Under(p, other, owner, x.slides.guide)
        return self.driven() | sliders

    def driven(self) -> dict[str, Under]:
        """The hinge moved by a drive inside a group, by the names of its motion relative to the link on the frame."""
        for g in self.plans.structure.driven:
            means = (t.means for e in self.plans.equations for t in e.terms if t.means)
            hinge, guide = g.inner.point, g.drive.guide if g.drive else ""
            given = (m.of for m in means if m.quantity == "relative")
            return {index: Under(hinge, index.removeprefix(hinge), g.held, guide) for index in given}
        return {}

    def sliding(self, term: Term) -> Under | None:
        """The slider whose motion along a guide a vector is."""
        line = self.plans.means.get(term.direction or "")
        _, index, _ = parts_of(term.name)
        if index in self.under or line is None or line.quantity != "along":
            return self.under.get(index)
        frame = self.plans.mechanism.frame
        links = self.plans.mechanism.links.values()
        point = next((x.first_point for x in links if x.slides and x.slides.guide == line.line), "")
        return Under(point, "", frame.name, line.line) if point and line.line in frame.guides else None

    @cached_property
    def carrying(self) -> dict[str, tuple[str, str, str]]:
        """The link with both points of "CB", and these; a point under a slider is on its link too."""
        own = {x.name: {*x.points} for x in self.plans.mechanism.links.values()}
        for under in self.under.values():
            own[under.link].add(under.other)
        return {a + b: (link, a, b) for link, points in own.items() for a, b in permutations(sorted(points), 2)}

    def turns(self, rates: list[Calculate], plan: str, make: Make) -> Iterator[Frame]:
        """For each angular velocity or acceleration given by a vector over a length, the vector carried to its
        point."""
        places = {under.other: under.point for under in self.under.values()}
        for rate in rates:
            vector = plain((quotient(rate) or ("",))[0])
            letter, index, _ = parts_of(vector)
            link = self.carrying.get(index)
            if link and letter in LETTERS.values():
                name, point, about = link
                ends, vectors = {"point": point, "about": about}, {"vector": vector, "rate": rate.makes}
                sense = slot(rate.makes, "s")
                frame = make("sense", plan, terms=(vector,), link=name, sense=sense, **ends, **vectors)
                spots = {k: at("position", places.get(p, p)) for k, p in ends.items()}
                yield replace(frame, turns={**spots, **vectors})
