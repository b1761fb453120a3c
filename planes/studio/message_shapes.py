"""The shapes of messages: any other shape is refused in a sentence before work begins."""

import math
import re
from collections.abc import Callable
from typing import Any

from planes.words import Phrase
from planes.words.errors import PlanesError
from planes.words.records import Json

NAME = re.compile(r"[^\W_][\w'′.-]{0,19}")
SUM = re.compile(r"[-+*/().\deE]{1,60}(?:\*pi/\d+)?")
MOST = 200  # limits: points, links, guides of a sketch; keys of a path; numbers


def checked(message: Json) -> Json:
    """The message itself; :class:`PlanesError` where a part that its ``ask`` reads has another shape."""
    for part in PARTS.get(str(message.get("ask")), ()):
        if not SHAPES[part](message.get(part)):
            raise PlanesError(Phrase("studio_bad_message"))
    return message


def _number(x: Any) -> bool:
    return isinstance(x, int | float) and not isinstance(x, bool) and math.isfinite(x) and abs(x) < 1e9


def _name(x: Any) -> bool:
    return isinstance(x, str) and bool(NAME.fullmatch(x))


def _place(x: Any) -> bool:
    return isinstance(x, list) and len(x) == 2 and all(map(_number, x))


def _table(x: Any, key: Callable[[Any], bool], value: Callable[[Any], bool]) -> bool:
    return isinstance(x, dict) and len(x) <= MOST and all(key(k) and value(v) for k, v in x.items())


def _text(x: Any) -> bool:
    return isinstance(x, str) and 0 < len(x) < 1000 and "\n" not in x


def _path(x: Any) -> bool:
    return isinstance(x, list | tuple) and 0 < len(x) <= MOST and all(isinstance(k, str) and k.strip() for k in x)


def _among(x: Any, table: Any) -> bool:
    return isinstance(x, str) and x in table


def _sketch(x: Any) -> bool:
    """A sketch: points with places, links of those points, guides with places; every name used must be defined."""
    if not isinstance(x, dict) or not all(isinstance(x.get(k), dict) for k in ("points", "guides", "links")):
        return False
    points, guides, links = x["points"], x["guides"], x["links"]

    def named(some: Any) -> bool:
        return isinstance(some, list) and all(_among(p, points) for p in some)

    def guide(g: Any) -> bool:
        owned = isinstance(g, dict) and _among(g.get("link"), ("0", *links))
        return owned and _place(g.get("at")) and _number(g.get("angle"))

    def link(one: Any) -> bool:
        if not isinstance(one, dict) or not (own := one.get("points")) or not named(own):
            return False
        slides = one.get("slides")
        return _among(one.get("centre") or own[0], points) and (slides is None or _among(slides, guides))

    tables = _table(points, _name, _place) and _table(guides, _name, guide) and _table(links, _name, link)
    return tables and named(x.get("fixed")) and _drive(x.get("drive"), links)


def _drive(drive: Any, links: Json) -> bool:
    if not isinstance(drive, dict) or not _among(drive.get("link"), links):
        return drive is None
    moved = drive.get("kind") == "phi" or (drive.get("kind") == "s" and links[drive["link"]].get("slides"))
    return bool(moved) and _number(drive.get("rate")) and _among(drive.get("on", "0"), ("0", *links))


SHAPES: dict[str, Callable[[Any], bool]] = {
    "sketch": _sketch,
    "was": lambda x: x is None or _sketch(x),
    "numbers": lambda x: _table(x, lambda name: isinstance(name, str) and len(name) < 100, _number),
    "said": lambda x: x is None or _table(x, lambda name: isinstance(name, str), lambda t: bool(SUM.fullmatch(str(t)))),
    "path": _path,
    "value": _text,
}
PARTS = {
    "numbers": ("numbers", "said"),
    "drawn": ("sketch", "was"),
    **dict.fromkeys(("rename", "put", "append"), ("path", "value")),
    "leave out": ("path",),
}
"""The parts of its message that each kind reads, besides text and language."""
