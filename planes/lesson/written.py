"""Vector equations as a lesson writes them: terms with their ends, what is known of each, and their lines of action."""

from planes.drafting.equations import Equation, Term
from planes.lesson.steps import whole
from planes.plans import Plans
from planes.words.names import at
from planes.words.records import Json


def equation_written(plans: Plans, e: Equation) -> Json:
    """An equation as it is written: without the vectors that are nothing, a vector along the frame's guide itself."""
    if not e.total:
        sides = [[{**_term(plans, e.plan, t), "minus": sign < 0} for sign, t in side] for side in e.written]
        return {"plan": e.plan, "total": None, "closed": e.closed, "sides": sides}
    total: Json | None = {"name": e.total, "action": "", "known": 0}
    sides = []
    for chain in e.chains:
        alone = [t for t in chain if total and whole(e, t.name) == e.total and t.name != e.total]
        if alone and total:
            total.update(action=_acted(plans, alone[0]), known=alone[0].known)
        elif chain:
            sides.append([{**_term(plans, e.plan, t), "minus": t.sign < 0} for t in chain])
    return {"plan": e.plan, "total": total, "closed": False, "sides": sides}


def _term(plans: Plans, plan: str, t: Term) -> Json:
    start, end = (at(plan, label) for label in ((t.start, t.end) if t.sign > 0 else (t.end, t.start)))
    own = {"name": t.name, "start": start, "end": end, "at": at(plan, t.end)}
    return {**own, "action": _acted(plans, t), "known": t.known}


def _acted(plans: Plans, t: Term) -> str:
    """The line of action beneath a term."""
    return plans.means[t.direction].action if t.direction else t.action
