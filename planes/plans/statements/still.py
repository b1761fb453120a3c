"""The record of plans without a mechanism: stated vectors, bodies in equilibrium."""

from collections.abc import Mapping

from planes.drafting.draft import Draft
from planes.drafting.program import Program
from planes.drafting.steps.laws import Follow
from planes.plans.assur.groups import Pair
from planes.plans.assur.structure import Structure
from planes.plans.force.loads import Loads
from planes.plans.passive_motion import LinkValues
from planes.plans.proving import closing_proofs
from planes.plans.record import STILL_DRIVE_GIVEN, Plans
from planes.plans.structures.figure import StaticsFigure
from planes.scene.mechanism import FRAME, Mechanism
from planes.words.frozen import replace
from planes.words.names import MarkPair


def plans_of_still_draft(
    d: Draft,
    mechanism: Mechanism,
    acting: Loads,
    vectors: Mapping[str, MarkPair],
    values: Mapping[str, str],
    figure: StaticsFigure | None = None,
) -> Plans:
    """All that was drafted, with the end marks of its vectors and the names of its values."""
    program = Program(tuple(d.steps.values()), tuple(closing_proofs(d)))
    return Plans(
        mechanism=mechanism,
        structure=Structure(0, 0, Pair("R", FRAME, FRAME), (), FRAME),
        program=program,
        given={**d.given, STILL_DRIVE_GIVEN: 0.0},
        equations=tuple(d.equations),
        moments=tuple(d.moments),
        segments=tuple(dict.fromkeys(d.segments)),
        acting=replace(acting, laws={s.makes: s.law for s in program.steps if isinstance(s, Follow)}),
        means=d.means | {s.makes: s.means for s in program.steps if s.means},
        vectors=vectors,
        values=values,
        links={FRAME: LinkValues("", "", "")},
        figure=figure,
    )
