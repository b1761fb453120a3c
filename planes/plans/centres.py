"""Instantaneous centres of pairs of links: where each stands, what it is found by, what is checked by it."""

from planes.scene.mechanism import FRAME
from planes.words.frozen import frozen


@frozen
class CentreLine:
    """A line of centres, of two links and a third: through ``mark`` along a direction, and through ``other`` if that
    is no direction given, as a centre at infinity has it."""

    third: str
    mark: str
    along: str
    other: str = ""


@frozen
class Centre:
    """The centre of two links: its ``mark``, or the direction ``along`` which it lies at infinity; where it is found by
    ``lines``, or the ``point`` that is a hinge of both; "" of its name."""

    links: tuple[str, str]
    name: str
    mark: str = ""
    along: str = ""
    lines: tuple[CentreLine, ...] = ()
    point: str = ""


@frozen
class Check:
    """Speeds that are equal: of a centre as a point of each of two links, or of a point by the centre of its link and
    as the velocity plan has it (``read``): of its link, or of one that ``slides`` and has one velocity everywhere.
    ``sides`` are those that are an angular velocity times a length, by name."""

    name: str
    centre: Centre
    sides: tuple[tuple[str, str], ...]
    read: bool = False
    slides: str = ""


def centre_name(one: str, two: str, frame: str) -> str:
    """P_13; P_16 of a link and the ``frame`` that has the number 6."""
    said = (two, frame) if one == FRAME else (one, two)
    return f"P_{('' if max(map(len, said)) == 1 else ',').join(said)}"
