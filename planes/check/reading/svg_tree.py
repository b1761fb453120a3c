"""An SVG file as a tree of elements: counted while it is read, and without entities, which may grow without bound."""

from __future__ import annotations

from xml.etree import ElementTree
from xml.parsers import expat

from planes.check.reading.opened import too_many
from planes.words import Phrase
from planes.words.errors import PlanesError, guarded

MOST = 60_000  # elements
DEEPEST = 200


def tree(data: bytes, file: str) -> ElementTree.Element:
    """The root element. :class:`PlanesError` where it is no XML, holds entities, or too many elements."""
    builder, parser, count, depth = ElementTree.TreeBuilder(), expat.ParserCreate(None, "}"), 0, 0

    def start(tag: str, attributes: dict[str, str]) -> None:
        nonlocal count, depth
        count, depth = count + 1, depth + 1
        if count > MOST or depth > DEEPEST:
            raise too_many(file, "elements" if count > MOST else "levels", MOST if count > MOST else DEEPEST)
        builder.start(_name(tag), {_name(k): v for k, v in attributes.items()})

    def end(tag: str) -> None:
        nonlocal depth
        depth -= 1
        builder.end(_name(tag))

    def entity(*_: object) -> None:
        raise PlanesError(Phrase("check_svg_entities", file=file))

    parser.buffer_text = True
    parser.StartElementHandler, parser.EndElementHandler = start, end
    parser.CharacterDataHandler, parser.EntityDeclHandler = builder.data, entity
    with guarded("check_svg", file):
        parser.Parse(data, True)
        return builder.close()


def _name(name: str) -> str:
    """A name with its namespace as ElementTree writes it."""
    return "{" + name if "}" in name else name
