"""A group as a free body before its forces are found: the forces on it, the number of unknowns, resolved reactions."""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

from planes.drafting.drawing import Drawing
from planes.drafting.equations import Term
from planes.lesson.formulas import in_brackets
from planes.lesson.frame import Frame, Frames, Make
from planes.plans import Plans
from planes.plans.force.reactions import Reaction
from planes.words import Phrase
from planes.words.frozen import frozen
from planes.words.names import NameTuple, PlanId, scheme_mark, split_value_name
from planes.words.records import Json


@frozen
class Split:
    """A reaction of unknown direction, by its components along a line and across it; the latter comes from moments
    ``about`` a point."""

    force: str
    normal: Term
    tangential: Term
    line: str
    about: str


@dataclass
class FreeBodies:
    """The links of each force polygon as free bodies, with the forces drawn so far."""

    plans: Plans
    drawing: Drawing

    def insert_free_bodies(self, frames: Frames, make: Make) -> Frames:
        """The frames with each force polygon preceded by the free bodies of its links, and its pole after its
        equation."""
        opened = Frames()
        waiting = {}
        for f in frames:
            if f.key == "pole" and f.plan.is_force and self.plans.has_mechanism:
                waiting[f.plan] = f
                opened += self.free_body_frames(f.plan, make)
                continue
            pole = [waiting.pop(f.plan)] if f.plan in waiting else []
            opened += [f, *pole] if f.key == "equation" else [*pole, f]
        return opened

    def free_body_frames(self, plan: PlanId, make: Make) -> Iterator[Frame]:
        """The forces on the links and the unknowns; then the reactions that are resolved."""
        known = [f["name"] for f in self.known_forces(plan)]
        sought = self.outer(plan)
        balancing = self.balancing_load(plan)
        unknown = tuple(Phrase(f"lesson_free_{r.pair.kind}", name=name) for name, r in sought.items())
        if balancing:
            unknown += (Phrase("lesson_free_size", name=balancing),)
        carried = [n for n in known if any(n in r.both_reaction_names for r in self.plans.reactions.values())]
        key = "driver" if balancing else "next" if carried else "first"
        why = Phrase(f"why_free_body_{key}", forces=in_brackets(carried))
        yield make(
            "free_body",
            plan,
            reason=why,
            terms=tuple(known),
            links=links_phrase(plan.links),
            known=in_brackets(known) or "—",
            unknown=unknown,
            count=str(2 * len(sought) + bool(balancing)),
        )
        for one in self.resolved_reactions(plan):
            parts = {"force": one.force, "normal": one.normal.name, "tangential": one.tangential.name, "line": one.line}
            terms = one.normal.name, one.tangential.name
            why = Phrase("why_split", **parts, about=one.about)
            yield make("split", plan, reason=why, terms=terms, **parts)

    def known_forces(self, plan: PlanId) -> Iterator[Json]:
        """The known forces and couples on the links of a polygon, and how each is drawn."""
        own = self.reactions_from_polygon(plan)
        for link in plan.links:
            for f in self.plans.acting.forces.get(link, ()):
                outside = f.quantity in ("weight", "inertia", "load")
                if f.size in self.drawing and (outside or (f.quantity == "reaction" and f.name not in own)):
                    yield f.shown
            for c in self.plans.acting.couples.get(link, ()):
                if not c.handed and c.value in self.drawing:
                    yield c.shown

    def reactions_from_polygon(self, plan: PlanId) -> dict[str, Reaction]:
        """The reactions found from a polygon, by their names on its links: internal ones have both names."""
        reactions = (r for r in self.plans.reactions.values() if r.plan == plan)
        links = plan.links
        return {name: r for r in reactions for name, link in r.both_reaction_names.items() if link in links}

    def outer(self, plan: PlanId) -> dict[str, Reaction]:
        """Those from other links."""
        return {
            name: r
            for name, r in self.reactions_from_polygon(plan).items()
            if not {*r.both_reaction_names.values()} <= {*plan.links}
        }

    def balancing_load(self, plan: PlanId) -> str:
        """The balancing load, if the polygon is the driver's."""
        if plan == PlanId("force", self.plans.drive.link):
            return self.plans.balancing
        return ""

    def resolved_reactions(self, plan: PlanId) -> Iterator[Split]:
        """The reactions of a polygon with both components in its equation."""
        terms = {t.name: t for e in self.plans.equations if e.plan == plan for t in e.all_terms}
        about = {m.unknown: m.about for m in self.plans.moments}
        for name, tangential in terms.items():
            letter, index, part = split_value_name(name)
            force = f"{letter}_{index}"
            normal = terms.get(f"{letter}_{index}^n")
            if part == "t" and normal and normal.direction and name in about:
                line = self.plans.means[normal.direction].line_name
                yield Split(force, normal, tangential, line, about[name])

    @cached_property
    def forces_by_polygon(self) -> Json:
        """For a page: by polygon the forces on its links, and both components of the resolved reactions."""
        bodies: Json = {}
        for plan in self.plans.force_plans:
            known = [*self.known_forces(plan)]
            forces = [{**f, "foot": None} for f in known if "mark" in f]
            couples = [c for c in known if "link" in c]
            for one in self.resolved_reactions(plan):
                reaction = self.plans.reactions.get(one.force)
                if reaction:
                    mark = scheme_mark(reaction.pair.point)
                    for t in (one.normal, one.tangential):
                        forces.append({"name": t.name, "mark": mark, "along": t.direction, "size": "", "foot": None})
            bodies[plan] = {"about": "", "forces": forces, "couples": couples}
        return bodies


def links_phrase(links: NameTuple, between: str = "–") -> Phrase:
    """The links of a force polygon, or of a moment equation."""
    return Phrase("lesson_link" if len(links) == 1 else "lesson_links", links=between.join(links))
