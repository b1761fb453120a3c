"""Friction in a scene: by its coefficient in sliding pairs, by coefficient and pin radius in hinges."""

from collections import Counter
from collections.abc import Iterator

from planes.scene.mechanism import Journal, Link, Links
from planes.scene.reader import Fields, Reader
from planes.scene.source import Node, SourceTable
from planes.words import Phrase
from planes.words.names import NumbersByName

PIN_KEYS = ("coefficient", "radius")


def read_friction(reader: Reader, node: Node, frame: Link, links: Links) -> tuple[NumbersByName, dict[str, Journal]]:
    """Coefficients of straight guides by guide; pins of hinges, and circular guides, by their names."""
    table = reader.read_table(node, "friction")
    bodies = (frame, *links.values())
    radii = {name: guide.radius for link in bodies for name, guide in link.round_guides.items()}
    slid = set(_guides_slid_on(links))
    hinges = set(_hinge_points(bodies))
    guides = {}
    journals = {}
    for name, entry in table.entries.items():
        what = Phrase("friction_of", name=name[:60])
        if name in hinges and isinstance(entry, SourceTable):
            pin = Fields(reader, entry, what, PIN_KEYS)
            journals[name] = Journal(pin.read_non_negative("coefficient"), pin.read_non_negative("radius"))
        elif name in slid and name in radii:
            journals[name] = Journal(reader.read_non_negative(entry, what), radii[name], round=True)
        elif name in slid:
            guides[name] = reader.read_non_negative(entry, what)
        elif name in hinges:
            raise reader.error_by_key("friction_of_pin", entry, what=what, name=name)
        else:
            idle = {*radii, *(guide for link in bodies for guide in link.guides)}
            valid = reader.valid_names_in_words(name, sorted(slid | hinges))
            why = Phrase("friction_no_slide" if name in idle else "friction_no_pair", name=name[:60], valid=valid)
            raise reader.error(why, table.lines[name])
    return guides, journals


def _guides_slid_on(links: Links) -> Iterator[str]:
    for link in links.values():
        yield from (slide.guide for slide in (link.slides, link.slides_round) if slide)


def _hinge_points(bodies: tuple[Link, ...]) -> Iterator[str]:
    held = Counter(point for link in bodies for point in list(link.points)[: -1 if link.slides_round else None])
    return (point for point, count in held.items() if count > 1)
