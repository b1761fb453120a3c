"""Stated vectors and loads that depend on an angle or a length: laws without a mechanism."""

from planes.drafting.draft import Draft
from planes.drafting.steps.laws import Follow
from planes.scene.expressions import names_in_expression
from planes.scene.mechanism import FRAME, Drive, Link, LoadLaw, Mechanism, Where
from planes.words.names import Meaning

STANDING_DRIVE = Drive(FRAME, "s", 0.0)
"""Takes the place of a drive where nothing depends on one."""


def value_name_of_law(draft: Draft, drive: Drive | None, name: str, law: LoadLaw, means: Meaning) -> str:
    """The name of a value that is computed anew in every position of the drive."""
    assert drive
    place = draft.add_given(drive.coordinate_name, drive.position)
    return draft.add_step(
        Follow(name, law, tuple((n, place) for n in dict.fromkeys(names_in_expression(law.text))), means=means)
    )


def mechanism_of_drive_alone(drive: Drive | None, where: Where) -> Mechanism:
    """No mechanism: only laws of the scene's drive."""
    return Mechanism(Link(FRAME, {}), {}, drive or STANDING_DRIVE, where=where)
