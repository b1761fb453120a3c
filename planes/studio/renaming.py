"""A point or a link under another name: every mention of it in a scene's text, and nothing else."""

import re
from collections.abc import Callable, Iterable, Iterator

import yaml

from planes.plans import Plans
from planes.plans.quantities import catalogue
from planes.scene import loads
from planes.solving import plans_of
from planes.studio.message_shapes import NAME
from planes.studio.text_edits import FILE, Edited, tree_of
from planes.words import Phrase
from planes.words.errors import PlanesError

NAMED = {"point": ("centre", "through", "point"), "link": ("link", "on", "slider")}
"""Keys whose values are names."""
IN_LAWS = {"point": "x|y|v|a", "link": "phi|omega|epsilon|s|v|a"}
"""The letters of the motion in laws of loads."""
VECTOR = re.compile(r"[^\W\d]\w*(?:\^\w+)?")
Scalar = tuple[tuple[str, ...], yaml.ScalarNode, bool]


def renamed(text: str, kind: str, name: str, to: str) -> Edited:
    """The text with a point or a link under another name. :class:`PlanesError` where that name is taken, or is none, or
    the mechanism cannot have it."""
    scalars = [*_scalars(tree_of(text))]
    names = {node.value for path, node, key in scalars if key and _names_a_part(path)} | {"0"}
    wrong = {"wrong": not NAME.fullmatch(to), "taken": to in names, "none": name not in names}
    for key in (k for k, holds in wrong.items() if holds):
        raise PlanesError(Phrase(f"studio_name_{key}", name=name if key == "none" else to))
    law = re.compile(rf"(?<!\w)({IN_LAWS[kind]})_{re.escape(name)}(?!\w)")

    def other(path: tuple[str, ...], value: str, key: bool) -> str:
        if value == name and (_names_a_part(path, kind) if key else path[-1] in NAMED[kind]):
            return to
        return value if key or path[0] != "loads" else law.sub(rf"\1_{to}", value)

    edited = _changed(text, scalars, other)
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
    known = catalogue(before)
    others = dict(zip(known, catalogue(after), strict=True))
    letters = before.naming.names(known, poles=False)

    def other(path: tuple[str, ...], value: str, key: bool) -> str:
        if path[0] == "find" and not key:
            own = letters.one(value, "no_quantity", lambda n: known[n].path)
            return value if others[own] == own else after.naming.typed(others[own])
        return VECTOR.sub(lambda hit: others.get(hit[0], hit[0]), value) if path[0] == "equations" else value

    return _changed(edited.text, _scalars(tree_of(edited.text)), other, edited.lines)


def _names_a_part(path: tuple[str, ...], kind: str = "") -> bool:
    """Whether a key is the name of a point or a link."""
    match path:
        case ("links", _):
            return kind != "point"
        case ("frame", "points", _) | ("links", _, "points", _):
            return kind != "link"
        case ("assembly" | "friction", _):
            return kind == "point"
    return not kind and path[-2:-1] == ("guides",)


def _scalars(node: yaml.Node, path: tuple[str, ...] = ()) -> Iterator[Scalar]:
    """The scalars of a tree with their paths; whether one is a key."""
    if isinstance(node, yaml.ScalarNode):
        yield path, node, False
    elif isinstance(node, yaml.MappingNode):
        for key, value in node.value:
            yield (*path, key.value), key, True
            yield from _scalars(value, (*path, key.value))
    elif isinstance(node, yaml.SequenceNode):
        for k, item in enumerate(node.value):
            yield from _scalars(item, (*path, str(k)))


def _changed(
    text: str,
    scalars: Iterable[Scalar],
    other: Callable[[tuple[str, ...], str, bool], str],
    lines: tuple[int, ...] = (),
) -> Edited:
    """The text with other scalars, from the last to the first; their quotes stay."""
    for path, node, key in reversed([*scalars]):
        value = other(path, node.value, key)
        if value != node.value:
            start, end = node.start_mark.index, node.end_mark.index
            text = text[:start] + text[start:end].replace(node.value, value) + text[end:]
            lines = (*lines, node.start_mark.line + 1)
    return Edited(text, tuple(sorted({*lines})))
