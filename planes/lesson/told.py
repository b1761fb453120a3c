"""A scene drawn in its given position, with the frames of its lesson."""

from collections.abc import Mapping
from functools import cached_property

from planes.drafting.drawing import Drawing, run
from planes.drafting.equations import Equation, Term
from planes.drafting.instruments import InLists
from planes.drafting.tools import Thing
from planes.geometry.listed import Listed
from planes.lesson import Teller, value_of
from planes.lesson.formulas import in_both
from planes.lesson.frame import Frame, needed
from planes.lesson.knobs import Knobs
from planes.lesson.practice import Practice
from planes.lesson.steps import whole
from planes.plans import Plans
from planes.plans.scales import fits_on, scales
from planes.plans.three_centres import with_centres
from planes.scene import Scene
from planes.solving import plans_of
from planes.words import Phrase
from planes.words.errors import PlanesError, PlanFailure, SceneError
from planes.words.frozen import frozen
from planes.words.names import at
from planes.words.records import Json

TRIED = 180  # positions that decide which terms are zero


@frozen
class Told:
    """A scene drawn in its given position, and the frames of its lesson."""

    scene: Scene
    plans: Plans
    given: Mapping[str, Thing]
    drawing: Drawing
    knobs: Knobs
    teller: Teller
    frames: list[Frame]

    @classmethod
    def of(cls, scene: Scene, centres: bool = False) -> "Told":
        """The lesson of a scene; :class:`SceneError` where there is no mechanism or its given position fails."""
        plans, _ = plans_of(scene, shown=True)
        plans = with_centres(plans) if centres else plans
        try:
            mus = scales(plans, scene.mu, fit_mm=fits_on(scene.sheet, plans))
            given = {**plans.given, **plans.at(plans.drive.position), **mus}
            drawing = run(plans.program, given)
        except PlanFailure as failure:
            raise SceneError(Phrase("lesson_fails", failure=failure.phrase), scene.file, 1) from None
        knobs = Knobs(plans, given)
        teller = Teller(plans, drawing, _cycle(knobs), scene.mu_convention)
        return cls(scene, plans, given, drawing, knobs, teller, teller.frames())

    def under(self) -> Json:
        """By the points of sliders, those under them, each with the frame whose equation first needs it."""
        numbered = ((k, f.equation) for k, f in enumerate(self.frames) if f.key == "equation")
        stated = [(k, self.plans.equations[n]) for k, n in numbered if n is not None]
        marks, sliding = {}, self.teller.stating.sliding
        for u in self.teller.stating.under.values():
            first = (k for k, e in stated if any(s and s.other == u.other for s in map(sliding, e.terms)))
            marks[at("position", u.point)] = {"name": u.other, "from": next(first, -1)}
        return marks

    @cached_property
    def leaning(self) -> dict[int, Frame] | None:
        """Frames with more to say where guides are turned, by their number; None where the frames differ altogether."""
        if not any("stays" in knob for knob in self.knobs.all):
            return {}
        frames = Teller(self.plans, self.drawing, _cycle(self.knobs, True), self.scene.mu_convention).frames()
        if [f.makes for f in frames] != [f.makes for f in self.frames]:
            return None
        return {k: f for k, (f, own) in enumerate(zip(frames, self.frames, strict=True)) if f != own}

    @cached_property
    def equations(self) -> list[Json]:
        """The vector equations as written."""
        return [equation_written(self.plans, e) for e in self.plans.equations]

    @cached_property
    def drive(self) -> Json:
        """The driver's number, and its range."""
        return drive_of(self.plans)

    @cached_property
    def practice(self) -> Practice:
        """The questions to a reader."""
        values = {n: float(value_of(n, self.teller, self.drawing)) for n in needed(self.frames)}
        own = self.plans, self.drawing, self.frames, self.equations, fits_on(self.scene.sheet, self.plans)
        return Practice(*own, self.given, values, self.teller.spans)


def _cycle(knobs: Knobs, leaning: bool = False) -> Drawing:
    """The drawing of many positions, and of numbers near those of the scene."""
    plans = knobs.plans
    drive = drive_of(plans)
    start, reach = drive["from"], drive["to"] - drive["from"]
    values = Listed(start + reach * k / TRIED for k in range(TRIED))
    return run(plans.program, {**knobs.given, **knobs.shaken(TRIED, leaning), plans.drive_given: values}, InLists())


def drive_of(plans: Plans) -> Json:
    """The driver's number, and its range: a single value, where a law is valid in the given position alone."""
    drive = plans.drive
    turns = drive.rotates
    reach, start = (0.0, drive.position % 1.0) if turns else (plans.reach, drive.position)
    still: Json = {"symbol": "φ" if turns else "s", "given": plans.drive_given, "at": drive.position, "held": None}
    still |= {"from": drive.position, "to": drive.position}
    if not plans.turns:
        return still
    try:
        plans.at(drive.position + 1.0)
    except SceneError as law:  # a number valid only at the drive's position in the file
        return {**still, "held": in_both(PlanesError(law.phrase).told)}
    return {**still, "from": start - reach, "to": start + (reach or 360.0)}


def equation_written(plans: Plans, e: Equation) -> Json:
    """An equation as written: without zero vectors, with a vector along the frame's guide as itself."""
    if not e.total:
        sides = [[_term(plans, e.plan, t, sign) for sign, t in side] for side in e.written]
        return {"plan": e.plan, "total": None, "closed": e.closed, "sides": sides}
    total: Json = {"name": e.total, "action": "", "known": 0}
    sides = []
    for chain in e.chains:
        alone = [t for t in chain if whole(e, t.name) == e.total and t.name != e.total]
        if alone:
            total.update(action=_acted(plans, alone[0]), known=alone[0].known)
        elif chain:
            sides.append([_term(plans, e.plan, t, t.sign) for t in chain])
    return {"plan": e.plan, "total": total, "closed": False, "sides": sides}


def _term(plans: Plans, plan: str, t: Term, sign: int) -> Json:
    start, end = (at(plan, label) for label in t.ends)
    own = {"name": t.name, "start": start, "end": end, "at": at(plan, t.end)}
    return {**own, "action": _acted(plans, t), "known": t.known, "minus": sign < 0}


def _acted(plans: Plans, t: Term) -> str:
    """The line of action beneath a term."""
    return plans.means[t.direction].action if t.direction else t.action
