"""Run a program with an instrument: the drawing, with its marks in mm, sharpness, warnings and failures."""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import reduce

from planes.drafting.instruments import Exact, Instrument, Shaken, is_exact
from planes.drafting.program import Program
from planes.drafting.proofs import MOST_AGREEMENT_GAP_RATIO, Facts, Proof, Twofold
from planes.drafting.steps import Step
from planes.drafting.tools import Env, Thing, Things, Tool
from planes.geometry.arithmetic import Real, Truth
from planes.words import Phrase
from planes.words.errors import Contradiction, PlanFailure, ProgramError, list_valid_choices
from planes.words.lettering import name_in_words, plan_phrase
from planes.words.records import Pictured

LEAST_NORMAL_NUMBER = 1e-290  # SI: smaller numbers have fewer digits than a normal double
SHAKEN_DRAWING_SEEDS = range(4)  # seeds of the blunter drawings
Instead = Mapping[str, Sequence[Step]]  # steps that replace the step for a name; the last of them makes that name too
NO_REPLACED_STEPS: Instead = {}


@dataclass
class Drawing(Pictured):
    """The result of a run: every object by name, and the tool that drew it."""

    program: Program
    things: Env
    tool: Tool

    def __getitem__(self, name: str) -> Thing:
        try:
            return self.things[name]
        except KeyError:
            valid = list_valid_choices(name, self.things)
            raise ProgramError(Phrase("not_drawn", name=name, valid=valid)) from None

    def __contains__(self, name: object) -> bool:
        return name in self.things

    @property
    def crossing_sharpness(self) -> dict[str, Real]:
        """How sharply lines meet at each crossed mark: the sine of the angle."""
        return self.tool.sharpness

    def failed_mask(self) -> Truth:
        """Of many drawings, those that failed: a mask (False when all succeeded)."""
        mask: Truth = False
        for _, _, ok, _ in self.tool.failures:
            mask = mask | ~ok
        return mask


def draw_program(program: Program, given: Things, instrument: Instrument | None = None) -> Drawing:
    """Draw every step. With an array among the givens many drawings are made at once.

    Raises :class:`ProgramError` when a given is missing, :class:`PlanFailure` when a single drawing cannot continue,
    :class:`Contradiction` where its two balancing loads differ; of many drawings, failed ones are NaN and listed by
    :meth:`Drawing.failed_mask`.
    """
    drawing, failure = draw_until_failure(program, given, instrument)
    if failure:
        raise failure
    return drawing


def draw_until_failure(
    program: Program, given: Things, instrument: Instrument | None = None
) -> tuple[Drawing, PlanFailure | None]:
    """The drawing up to the first failure, and that failure."""
    missing = [n for n in program.given_names if n not in given]
    if missing:
        raise ProgramError(Phrase("give_first", names=tuple(missing)))
    by = instrument or Exact()
    shapes = [v.shape for v in given.values() if hasattr(v, "shape") and v.shape]
    tool = by.tool(bool(shapes))
    if shapes:
        tool.shape = tool.ar.common_shape(shapes)
    drawing = Drawing(
        program,
        {name: tool.spread_over_drawings(tool.given_in_tool_type(value)) for name, value in given.items()},
        tool,
    )
    try:
        draw_steps(program.steps, drawing.things, tool)
    except PlanFailure as failure:
        return replace(drawing, program=Program(tuple(s for s in program.steps if s.makes in drawing))), failure
    if is_exact(by):
        _check_proofs(drawing, given, [p for p in program.proofs if isinstance(p, Twofold)])
    return drawing, None


def draw_steps(steps: Iterable[Step], things: Env, tool: Tool, instead: Instead = NO_REPLACED_STEPS) -> Env:
    """Draw steps one after another into ``things``, some replaced by those of ``instead``; returns the result of each.

    Later steps use the entries that the tool leaves in ``things``; of many drawings, failed ones are NaN.
    """
    name = ""
    made = {}
    try:
        with tool.ar.ignoring_warnings():
            for step in steps:
                name = step.makes
                made[name] = tool.draw_by_other_steps(step, instead.get(name, (step,)), things)
    except (OverflowError, ZeroDivisionError):  # overflow of a double
        raise PlanFailure("no_digits", makes=name_in_words(name)) from None
    return made


def refuse_unproved_drawing(program: Program, given: Things, drawn: Drawing | None = None) -> None:
    """Refuse a single position whose exact drawing (``drawn``, if it exists) fails any proof; a position that cannot be
    drawn is not checked."""
    try:
        drawing = drawn or draw_program(program, given)
    except PlanFailure:
        return
    _check_proofs(drawing, given, program.proofs)


def mask_unproved_drawings(drawing: Drawing, given: Things) -> None:
    """Mask those of many exact drawings that fail any proof; balancing loads were compared when they were drawn."""
    _check_proofs(drawing, given, [p for p in drawing.program.proofs if not isinstance(p, Twofold)])


def _check_proofs(drawing: Drawing, given: Things, proofs: Sequence[Proof]) -> None:
    """Refuse, or mask, gaps larger than drawings with a thousand times the rounding error can explain."""
    tool = drawing.tool
    blunter = None
    apart = []
    shown = Facts(drawing.things, tool.ar)
    with tool.ar.ignoring_warnings():
        for proof in proofs:
            gap, size = proof.gap_and_comparison_size(shown)
            wrong = tool.spread_over_drawings(gap > MOST_AGREEMENT_GAP_RATIO * size + LEAST_NORMAL_NUMBER)
            if wrong.any() if tool.many else wrong:
                apart.append((proof, wrong, gap, size))
    for proof, wrong, gap, size in apart:
        blunter = _drawings_with_more_rounding(drawing.program, given) if blunter is None else blunter
        wrong = wrong & (gap > _gap_variation(blunter, proof, gap, size, tool))
        if tool.many:
            _mask_refused_drawings(drawing, proof, ~wrong)
        elif wrong:
            numbers = proof.numbers_for_failure(drawing.things, gap, size)
            raise Contradiction(proof.reason, plan=plan_phrase(proof.plan), **numbers)


def _drawings_with_more_rounding(program: Program, given: Things) -> list[Things]:
    """Drawings with a thousand times the rounding error of doubles; those that fail are left out."""
    try:
        return [draw_program(program, given, Shaken(seed)).things for seed in SHAKEN_DRAWING_SEEDS]
    except PlanFailure:
        return []


def _gap_variation(blunter: list[Things], proof: Proof, gap: Real, size: Real, tool: Tool) -> Real:
    """How much the gap varies among them; infinite where there are none, or where their sizes differ altogether."""
    with tool.ar.ignoring_warnings():
        drawn = [proof.gap_and_comparison_size(Facts(things, tool.ar)) for things in blunter]
        moved = [tool.ar.where(abs(big - size) > size / 2, math.inf, abs(off - gap)) for off, big in drawn]
        return reduce(tool.ar.maximum, moved) if moved else math.inf


def _mask_refused_drawings(drawing: Drawing, proof: Proof, ok: Truth) -> None:
    """Of many drawings, set those that a proof refuses to NaN."""
    tool = drawing.tool
    before = len(tool.failures)
    tool.fail_unless(ok, proof, proof.reason)
    for step in drawing.program.steps:
        drawing.things[step.makes] = tool.mask_failed_results(drawing.things[step.makes], step, before)
