"""Coulomb friction in sliding pairs: the reaction leans by arctan f against the sliding, on the side that bears.

Which side of the guide bears is known only once the plan is drawn; so each supposition is drawn and the one that
comes true is kept. None, or two different ones, is self-locking.
"""

from dataclasses import replace
from itertools import product

from planes.drafting.equations import Term
from planes.drafting.steps.crossings import Cross
from planes.drafting.steps.reckoning import Choose, Lean, Sense, Trial
from planes.plans.loads import Acting, force_name
from planes.plans.structure import Pair
from planes.words.names import Meaning, at, mu_of


def meet_with_friction(acting: Acting, plan: str, lines: list[Term], x: str, pairs: list[Pair]) -> dict[str, Term]:
    """Cross two lines of reactions at mark ``x``, those of the rubbing ``pairs`` leaning, by trial of each side.

    Returns the leaning terms by name, now with the direction they turned out to have.
    """
    d = acting.b.draft
    of = {name: p for p in pairs for name in (force_name(p.link, p.other), force_name(p.other, p.link))}
    rubbing = [(t, of[t.name]) for t in lines if t.name in of]
    trials = []
    for signs in product((1, -1), repeat=len(rubbing)):
        tag = "".join("+" if sign > 0 else "-" for sign in signs)
        leaning = {t.name: _lean(acting, p, sign) for (t, p), sign in zip(rubbing, signs, strict=True)}
        mark = at(plan, f"{x}{tag}")
        starts = [at(plan, t.start) for t in lines]
        along = [leaning.get(t.name, t.direction or "") for t in lines]
        d.step(Cross(mark, starts[0], along[0], starts[1], along[1], supposed=True, means=Meaning("trial")))
        pushes = tuple(_push(acting, plan, t, p, mark, tag) for t, p in rubbing)
        trials.append(Trial(mark, pushes, signs))
    d.step(Choose(at(plan, x), tuple(trials), at(plan, lines[0].start), mu_of(plan)))
    return {t.name: _leant(acting, plan, t, p, x) for t, p in rubbing}


def _leant(acting: Acting, plan: str, term: Term, pair: Pair, x: str) -> Term:
    ends = at(plan, term.start), at(plan, x)
    leaning = Meaning("leaning", pair.guide)
    along = acting.b.draft.through(f"∡{term.name}", *(ends if term.sign > 0 else ends[::-1]), leaning)
    return replace(term, direction=along, action=f"∠{term.action}")


def _lean(acting: Acting, pair: Pair, sign: int) -> str:
    d, guide = acting.b.draft, f"∥{pair.guide}"
    coefficient = d.give(f"f_{pair.guide}", acting.b.mechanism.friction[pair.guide])
    d.law(coefficient, acting.b.mechanism.laws.get(("friction", pair.guide)))
    reading = acting.motion.slides[pair.link]
    sense = Sense(f"slides_{pair.link}", *reading.ends, reading.along, tuple(acting.motion.driven))
    name, means = f"lean_{pair.link}{'+' if sign > 0 else '-'}", Meaning("leaning", pair.guide)
    return d.step(Lean(name, d.square(guide), guide, coefficient, d.step(sense), sign, means=means))


def _push(acting: Acting, plan: str, term: Term, pair: Pair, mark: str, tag: str) -> str:
    """The trial's normal push on the slider, signed along the guide's normal."""
    forward = (term.sign > 0) == (term.name == force_name(pair.link, pair.other))
    start = at(plan, term.start)
    ends = (start, mark) if forward else (mark, start)
    return acting.b.draft.measure(f"N_{pair.link}{pair.other}{tag}", *ends, f"⊥∥{pair.guide}")
