"""Stated vectors and loads that depend on an angle or a length: laws without a mechanism."""

from planes.drafting.draft import Draft
from planes.drafting.steps.laws import Follow
from planes.scene.expressions import names_in
from planes.scene.mechanism import FRAME, Drive, Link, LoadLaw, Mechanism, Where
from planes.words.names import Meaning

STANDING = Drive(FRAME, "s", 0.0)
"""Takes the place of a drive where nothing depends on one."""


def follow(draft: Draft, drive: Drive | None, name: str, law: LoadLaw, means: Meaning) -> str:
    """The name of a value that is computed anew in every position of the drive."""
    assert drive
    place = draft.give(drive.given, drive.position)
    return draft.step(Follow(name, law, tuple((n, place) for n in dict.fromkeys(names_in(law.text))), means=means))


def standing(drive: Drive | None, where: Where) -> Mechanism:
    """No mechanism: only laws of the scene's drive."""
    return Mechanism(Link(FRAME, {}), {}, drive or STANDING, where=where)
