"""A point or a link under another name: every mention of it in a scene's text, and nothing else."""

import re
from collections.abc import Callable

from planes.plans import Plans
from planes.plans.quantities import catalogue
from planes.scene import loads
from planes.scene.source import SourceScalar, parse, walk
from planes.solving import plans_of
from planes.studio.message_shapes import NAME
from planes.studio.text_edits import FILE, Edited
from planes.words import Phrase
from planes.words.errors import PlanesError

NAMED = {"point": ("centre", "through", "point"), "link": ("link", "on", "slider")}
"""Keys whose values are names."""
IN_LAWS = {"point": "x|y|v|a", "link": "phi|omega|epsilon|s|v|a"}
"""The letters of the motion in laws of loads."""
PART = "part"
KEYS = {
    "point": "(frame|links/[^/]+)/points/[^/]+|(assembly|friction)/[^/]+",
    "link": "links/[^/]+",
    PART: "(frame|links/[^/]+)/(points|guides)/[^/]+|links/[^/]+",
}
"""The places of keys that are names."""
VECTOR = re.compile(r"[^\W\d]\w*(?:\^\w+)?")
Path = tuple[str, ...]


def renamed(text: str, kind: str, name: str, to: str) -> Edited:
    """The text with a point or a link under another name. :class:`PlanesError` where that name is taken, or is none, or
    the mechanism cannot have it."""
    paths = [path for path, _, _ in walk(parse(text, FILE))]
    names = {path[-1] for path in paths if _names_a(PART, path)}
    key = "none" if name not in names else "taken" if to in (*names, "0") else "" if NAME.fullmatch(to) else "wrong"
    if key:
        raise PlanesError(Phrase(f"studio_name_{key}", name=name if key == "none" else to))
    law = re.compile(rf"(?<!\w)({IN_LAWS.get(kind)})_{re.escape(name)}(?!\w)")

    def other(path: Path, value: str) -> str:
        if value == name and path[-1] in NAMED.get(kind, ()):
            return to
        return law.sub(rf"\1_{to}", value) if path[0] == "loads" else value

    edited = _changed(Edited(text), other)
    for path in paths:
        if path[-1:] == (name,) and _names_a(kind, path):
            edited = edited.rekeyed(path, to)
    try:
        before = _plans(text)
    except PlanesError:
        return edited  # no mechanism yet
    return _asked(edited, before, _plans(edited.text))


def _plans(text: str) -> Plans:
    """The plans of a mechanism, whatever is asked of them."""
    return plans_of(loads(Edited(text).without(("find",)).without(("equations",)).text, FILE), shown=True)[0]


def _asked(edited: Edited, before: Plans, after: Plans) -> Edited:
    """The text with other names of the quantities asked for, and of the vectors in equations."""
    pairs = [*zip(catalogue(before), catalogue(after), strict=True)]
    others = dict(pairs) | {before.naming.typed(was): after.naming.typed(now) for was, now in pairs}
    names = ("find", "equations")
    return _changed(
        edited, lambda path, value: VECTOR.sub(lambda v: others.get(v[0], v[0]), value) if path[0] in names else value
    )


def _names_a(kind: str, path: Path) -> bool:
    """Whether the last key of a path is the name of a part of this kind."""
    return bool(re.fullmatch(KEYS.get(kind, ""), "/".join(path)))


def _changed(edited: Edited, other: Callable[[Path, str], str]) -> Edited:
    """The text with other values where they differ; a quoted one stays quoted."""
    for path, node, _ in walk(parse(edited.text, FILE)):
        if isinstance(node, SourceScalar) and (value := other(path, node.text)) != node.text:
            edited = edited.put(path, value if node.plain else f'"{value}"')
    return edited
