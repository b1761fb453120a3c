"""Instantaneous centres of pairs of links: the place, the construction and the check of each."""

from planes.scene.mechanism import FRAME
from planes.words.frozen import frozen
from planes.words.names import NO_MARK, Mark, NamePair


@frozen
class CentreLine:
    """A line of centres, of two links and a third: through ``mark`` along a direction, and through ``other`` unless a
    centre at infinity gives the direction."""

    third: str
    mark: Mark
    along: str
    other: str = ""


@frozen
class Centre:
    """The centre of two links: its ``mark``, or the direction ``along`` which it lies at infinity; the ``lines`` that
    give it, or the ``point`` that is a hinge of both; "" if it has its own name."""

    links: NamePair
    name: str
    mark: Mark = NO_MARK
    along: str = ""
    lines: tuple[CentreLine, ...] = ()
    point: str = ""


@frozen
class Check:
    """Equal speeds: of a centre as a point of each of two links, or of a point by the centre of its link and from the
    velocity plan (``read``): of its link, or of one that ``slides`` and has one velocity everywhere. ``sides`` are the
    names of those that are an angular velocity times a length."""

    name: str
    centre: Centre
    sides: tuple[NamePair, ...]
    read: bool = False
    slides: str = ""


def instant_centre_name(one: str, two: str, frame: str) -> str:
    """P_13; P_16 for a link and the ``frame`` with the number 6."""
    said = (two, frame) if one == FRAME else (one, two)
    return f"P_{('' if max(map(len, said)) == 1 else ',').join(said)}"
