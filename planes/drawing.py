"""Run a program with an instrument: the drawing, with its marks in mm, sharpness, warnings and failures."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from planes.instruments import Exact, Hand, Instrument
from planes.program import Program
from planes.thing_names import called
from planes.wording import PlanFailure, ProgramError, valid_names
from planes.words import Phrase

NOWHERE = complex("nan+nanj")  # the mark of a drawing of many that could not be drawn


painters: list[Callable[[Drawing], str | None]] = []
"""How a drawing is shown in a notebook; the renderer says it, once it is there."""


@dataclass
class Drawing:
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

    def _repr_svg_(self) -> str | None:
        """The picture a notebook shows: nothing before ``planes.roof`` is imported, as drawings know no pictures."""
        return painters[-1](self) if painters else None

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

    Raises :class:`ProgramError` when something is not given, :class:`PlanFailure` when a single drawing cannot go on;
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
    return Drawing(program, things, hand)


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
