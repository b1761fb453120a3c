"""The shapes of messages: any other shape is refused in a sentence before work begins."""

import math
import re
from collections.abc import Callable
from typing import Any

from planes.words import Phrase
from planes.words.errors import PlanesError
from planes.words.records import Json

NAME_PATTERN = re.compile(r"[^\W_][\w'′.-]{0,19}")
SUM_PATTERN = re.compile(r"[-+*/().\deE]{1,60}(?:\*pi/\d+)?")
MOST_ENTRIES = 200  # limits: points, links, guides of a sketch; keys of a path; numbers


def checked_message(message: Json) -> Json:
    """The message itself; :class:`PlanesError` where a part that its ``ask`` reads has another shape."""
    for part in MESSAGE_PARTS_BY_KIND.get(str(message.get("ask")), ()):
        if not SHAPE_TESTS_BY_PART[part](message.get(part)):
            raise PlanesError(Phrase("studio_bad_message"))
    return message


def _is_number(x: Any) -> bool:
    return isinstance(x, int | float) and not isinstance(x, bool) and math.isfinite(x) and abs(x) < 1e9


def _is_name(x: Any) -> bool:
    return isinstance(x, str) and bool(NAME_PATTERN.fullmatch(x))


def _is_place(x: Any) -> bool:
    return isinstance(x, list) and len(x) == 2 and all(map(_is_number, x))


def _is_table(x: Any, key: Callable[[Any], bool], value: Callable[[Any], bool]) -> bool:
    return isinstance(x, dict) and len(x) <= MOST_ENTRIES and all(key(k) and value(v) for k, v in x.items())


def _is_text(x: Any) -> bool:
    return isinstance(x, str) and 0 < len(x) < 1000 and "\n" not in x


def _is_path(x: Any) -> bool:
    return (
        isinstance(x, list | tuple) and 0 < len(x) <= MOST_ENTRIES and all(isinstance(k, str) and k.strip() for k in x)
    )


def _is_name_in_table(x: Any, table: Any) -> bool:
    return isinstance(x, str) and x in table


def _is_sketch(x: Any) -> bool:
    """A sketch: points with places, links of those points, guides with places; every name used must be defined."""
    if not isinstance(x, dict) or not all(isinstance(x.get(k), dict) for k in ("points", "guides", "links")):
        return False
    points = x["points"]
    guides = x["guides"]
    links = x["links"]

    def named(some: Any) -> bool:
        return isinstance(some, list) and all(_is_name_in_table(p, points) for p in some)

    def guide(g: Any) -> bool:
        owned = isinstance(g, dict) and _is_name_in_table(g.get("link"), ("0", *links))
        return owned and _is_place(g.get("at")) and _is_number(g.get("angle"))

    def link(one: Any) -> bool:
        if not isinstance(one, dict) or not (own := one.get("points")) or not named(own):
            return False
        slides = one.get("slides")
        return _is_name_in_table(one.get("centre") or own[0], points) and (
            slides is None or _is_name_in_table(slides, guides)
        )

    tables = (
        _is_table(points, _is_name, _is_place)
        and _is_table(guides, _is_name, guide)
        and _is_table(links, _is_name, link)
    )
    return tables and named(x.get("fixed")) and _is_drive(x.get("drive"), links)


def _is_drive(drive: Any, links: Json) -> bool:
    if not isinstance(drive, dict) or not _is_name_in_table(drive.get("link"), links):
        return drive is None
    moved = drive.get("kind") == "phi" or (drive.get("kind") == "s" and links[drive["link"]].get("slides"))
    return bool(moved) and _is_number(drive.get("rate")) and _is_name_in_table(drive.get("on", "0"), ("0", *links))


SHAPE_TESTS_BY_PART: dict[str, Callable[[Any], bool]] = {
    "sketch": _is_sketch,
    "was": lambda x: x is None or _is_sketch(x),
    "numbers": lambda x: _is_table(x, lambda name: isinstance(name, str) and len(name) < 100, _is_number),
    "said": lambda x: (
        x is None or _is_table(x, lambda name: isinstance(name, str), lambda t: bool(SUM_PATTERN.fullmatch(str(t))))
    ),
    "path": _is_path,
    "value": _is_text,
}
MESSAGE_PARTS_BY_KIND = {
    "numbers": ("numbers", "said"),
    "drawn": ("sketch", "was"),
    **dict.fromkeys(("rename", "put", "append"), ("path", "value")),
    "leave out": ("path",),
}
"""The parts of its message that each kind reads, besides text and language."""
