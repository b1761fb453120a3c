"""Run a program with an instrument: the drawing, with its marks in mm, sharpness, warnings and failures."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from planes.drafting.instruments import Exact, Hand, Instrument, Shaken
from planes.drafting.program import Program
from planes.drafting.proofs import TOLD_APART, Proof, Twofold
from planes.words import Phrase
from planes.words.errors import Contradiction, PlanFailure, ProgramError, valid_names
from planes.words.pictures import Pictured
from planes.words.things import called, plan_phrase

NOWHERE = complex("nan+nanj")  # the mark of a drawing of many that could not be drawn
SHAKEN = range(4)  # seeds of the blunter drawings


@dataclass
class Drawing(Pictured):
    """What was drawn: everything by name, and the hand that drew it."""

    program: Program
    things: dict[str, Any]
    hand: Hand

    def __getitem__(self, name: str) -> Any:
        try:
            return self.things[name]
        except KeyError:
            valid = valid_names(name, list(self.things))
            raise ProgramError(Phrase("not_drawn", name=name, valid=valid)) from None

    def __contains__(self, name: object) -> bool:
        return name in self.things

    @property
    def sharpness(self) -> dict[str, Any]:
        """How sharply lines met at each crossed mark: the sine of the angle."""
        return self.hand.sharpness

    def failed(self) -> Any:
        """Of many drawings, which failed: a mask (None when every one came out)."""
        mask = None
        for _, _, ok, _ in self.hand.failures:
            mask = ~ok if mask is None else mask | ~ok
        return mask


def run(program: Program, given: Mapping[str, Any], instrument: Instrument | None = None) -> Drawing:
    """Draw every step. With an array among the givens many drawings are made at once.

    Raises :class:`ProgramError` when something is not given, :class:`PlanFailure` when a single drawing cannot go on,
    :class:`Contradiction` where its two balancing loads differ;
    of many, those that cannot are NaN and named by :meth:`Drawing.failed`.
    """
    missing = [n for n in program.givens if n not in given]
    if missing:
        raise ProgramError(Phrase("give_first", names=tuple(missing)))
    things = dict(given)
    shapes = [v.shape for v in things.values() if hasattr(v, "shape") and v.shape]
    many = bool(shapes)
    hand = (instrument or Exact()).tool(many)
    things = {name: hand.given(value) for name, value in things.items()}
    if many:
        import numpy

        hand.shape = numpy.broadcast_shapes(*shapes)
    if many:
        _run_many(program, things, hand)
    else:
        _run_one(program, things, hand)
    drawing = Drawing(program, things, hand)
    if isinstance(instrument or Exact(), Exact):
        _prove(drawing, given, [p for p in program.proofs if isinstance(p, Twofold)])
    return drawing


def proved(program: Program, given: Mapping[str, Any]) -> None:
    """Refuse a single position whose exact drawing fails any proof; one that cannot be drawn proves nothing."""
    try:
        drawing = run(program, given)
    except PlanFailure:
        return
    _prove(drawing, given, program.proofs)


def _prove(drawing: Drawing, given: Mapping[str, Any], proofs: Sequence[Proof]) -> None:
    """Refuse, or mask, what is apart by more than a drawing a thousand times blunter can tell."""
    hand = drawing.hand
    for proof in proofs:
        gap, size = proof.gap(drawing.things, hand.ar)
        wrong = gap > TOLD_APART * size
        if not (wrong.any() if hand.many else wrong):
            continue
        wrong = wrong & (gap > _doubt(drawing.program, given, proof, gap))
        if hand.many:
            _mask(drawing, proof, ~wrong)
        elif wrong:
            numbers = proof.numbers(drawing.things, (gap, size))
            raise Contradiction(proof.reason, plan=plan_phrase(proof.plan), **numbers)


def _doubt(program: Program, given: Mapping[str, Any], proof: Proof, gap: Any) -> Any:
    """How much a drawing a thousand times blunter than doubles moves a gap; without end where it cannot be drawn."""
    most: Any = 0.0
    for seed in SHAKEN:
        try:
            drawing = run(program, given, Shaken(seed))
        except PlanFailure:
            return math.inf
        most = drawing.hand.ar.maximum(most, abs(proof.gap(drawing.things, drawing.hand.ar)[0] - gap))
    return most


def _mask(drawing: Drawing, proof: Proof, ok: Any) -> None:
    """Of many drawings, nothing is left of those a proof refuses."""
    import numpy

    if not ok.all():
        drawing.hand.require(ok, proof, proof.reason)
        for name in drawing.program.made:
            thing = drawing.things[name]
            drawing.things[name] = numpy.where(ok, thing, NOWHERE if numpy.iscomplexobj(thing) else numpy.nan)


def _run_one(program: Program, things: dict[str, Any], hand: Hand) -> None:
    name = ""
    try:
        for step in program.steps:
            name = step.makes
            things[name] = step.draw(things, hand)
    except (OverflowError, ZeroDivisionError):  # numbers so far apart that no double holds them
        raise PlanFailure("no_digits", makes=called(name)) from None


def _run_many(program: Program, things: dict[str, Any], hand: Hand) -> None:
    import numpy

    with numpy.errstate(all="ignore"):
        for step in program.steps:
            before = len(hand.failures)
            made = step.draw(things, hand)
            for _, _, ok, _ in hand.failures[before:]:
                made = numpy.where(ok, made, NOWHERE if numpy.iscomplexobj(made) else numpy.nan)
            things[step.makes] = made
