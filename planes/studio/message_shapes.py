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
        if not SHAPES[part](message.get("path" if part == "renamed" else part)):
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


def _sketch(x: Any) -> bool:
    """A sketch: points with places, links of those points, guides with places; every name used must be defined."""
    if not isinstance(x, dict) or not {"points", "fixed", "guides", "links"} <= x.keys():
        return False
    points, guides, links = x["points"], x["guides"], x["links"]
    if not _table(points, _name, _place) or not isinstance(x["fixed"], list) or not isinstance(links, dict):
        return False

    def point(p: Any) -> bool:
        return isinstance(p, str) and p in points

    def guide(g: Any) -> bool:
        owned = isinstance(g, dict) and isinstance(g.get("link"), str) and (g["link"] == "0" or g["link"] in links)
        return owned and _place(g.get("at")) and _number(g.get("angle"))

    def link(one: Any) -> bool:
        own = one.get("points") if isinstance(one, dict) else None
        if not isinstance(own, list) or not own or not all(map(point, own)):
            return False
        slides, centre = one.get("slides"), one.get("centre")
        if centre is not None and not point(centre):
            return False
        return slides is None or (isinstance(slides, str) and isinstance(guides, dict) and slides in guides)

    sound = all(map(point, x["fixed"])) and _table(guides, _name, guide) and _table(links, _name, link)
    return sound and _drive(x.get("drive"), x)


def _drive(drive: Any, sketch: Json) -> bool:
    if drive is None:
        return True
    if not isinstance(drive, dict) or not isinstance(name := drive.get("link"), str) or name not in sketch["links"]:
        return False
    slides, on = sketch["links"][name].get("slides"), drive.get("on", "0")
    moved = drive.get("kind") == "phi" or (drive.get("kind") == "s" and slides)
    return bool(moved) and _number(drive.get("rate")) and isinstance(on, str) and on in ("0", *sketch["links"])


SHAPES: dict[str, Callable[[Any], bool]] = {
    "sketch": _sketch,
    "was": lambda x: x is None or _sketch(x),
    "numbers": lambda x: _table(x, lambda name: isinstance(name, str) and len(name) < 100, _number),
    "said": lambda x: x is None or _table(x, lambda name: isinstance(name, str), lambda t: bool(SUM.fullmatch(str(t)))),
    "path": _path,
    "renamed": lambda x: _path(x) and len(x) == 2 and x[0] in ("point", "link"),
    "value": _text,
}
PARTS = {
    "numbers": ("numbers", "said"),
    "drawn": ("sketch", "was"),
    "rename": ("renamed", "value"),
    "put": ("path", "value"),
    "append": ("path", "value"),
    "leave out": ("path",),
}
"""The parts of its message that each kind reads, besides text and language."""
