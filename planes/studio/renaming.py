"""A point or a link under another name: every mention of it in a scene's text, and nothing else."""

import re
from collections.abc import Callable
from itertools import permutations

from planes.plans import Plans
from planes.plans.quantities import catalogue
from planes.scene import loads
from planes.scene.source import SourceScalar, parse, walk
from planes.scene.vector_equations import VECTOR
from planes.solving import plans_of
from planes.studio.message_shapes import NAME
from planes.studio.text_edits import FILE, Edited
from planes.words import Phrase
from planes.words.errors import PlanesError

KINDS = {
    "point": ("(frame|links/[^/]+)/points/[^/]+|(assembly|friction)/[^/]+", "x|y|v|a", ("centre", "through", "point")),
    "link": ("links/[^/]+", "phi|omega|epsilon|s|v|a", ("link", "on", "slider")),
}
"""The places of keys that are names; the letters of the motion in laws of loads; keys whose values are names."""
PARTS = "(frame|links/[^/]+)/(points|guides)/[^/]+|links/[^/]+"
ASKED = ("find",), ("sheet", "diagrams"), ("sheet", "hodographs")
"""The places of names of quantities and curves."""
LETTERS = "v", "a", "aq", "phi", "s", "epsilonq"
"""Of vectors and curves that are no quantities to be found."""
Path = tuple[str, ...]


def renamed(text: str, kind: str, name: str, to: str) -> Edited:
    """The text with a point or a link under another name. :class:`PlanesError` where that name is taken, or is none, or
    the mechanism cannot have it."""
    keys, letters, valued = KINDS["point" if kind == "point" else "link"]
    places = {"/".join(path): path for path, _, _ in walk(parse(text, FILE))}
    names = {path[-1] for place, path in places.items() if re.fullmatch(PARTS, place)}
    key = "none" if name not in names else "taken" if to in (*names, "0") else "" if NAME.fullmatch(to) else "wrong"
    if key:
        raise PlanesError(Phrase(f"studio_name_{key}", name=name if key == "none" else to))
    law = re.compile(rf"(?<!\w)({letters})_{re.escape(name)}(?!\w)")

    def other(path: Path, value: str) -> str:
        if value == name and path[-1] in valued:
            return to
        return law.sub(rf"\1_{to}", value) if path[0] == "loads" else value

    edited = _changed(Edited(text), other)
    for place, path in places.items():
        if path[-1:] == (name,) and re.fullmatch(keys, place):
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
    """The text with other names of the quantities and curves asked for, however they are typed, and of the vectors in
    equations, which have the program's names."""
    pairs = dict(zip(_all_names(before), _all_names(after), strict=True))
    names = before.naming.names(pairs, poles=False)

    def other(path: Path, value: str) -> str:
        if path[0] == "equations":
            return re.sub(VECTOR, lambda v: pairs.get(v[0], v[0]), value)
        meant = names.meant(value)[:1] if path[:1] in ASKED or path[:2] in ASKED else ()
        return next((after.naming.typed(pairs[name]) for name in meant if pairs[name] != name), value)

    return _changed(edited, other)


def _all_names(plans: Plans) -> list[str]:
    """The names of quantities, of vectors of one point relative to any other and of curves, in an order that no name
    changes."""
    subjects = [*plans.points, *plans.mechanism.links, *map("".join, permutations(plans.points, 2))]
    names = [*catalogue(plans), *(f"{letter}_{subject}" for letter in LETTERS for subject in subjects)]
    return [*names, *(f"{name}_{axis}" for name in names for axis in "xy")]


def _changed(edited: Edited, other: Callable[[Path, str], str]) -> Edited:
    """The text with other values where they differ; a quoted one stays quoted, and one with a comma needs to be."""
    for path, node, _ in walk(parse(edited.text, FILE)):
        if isinstance(node, SourceScalar) and (value := other(path, node.text)) != node.text:
            edited = edited.put(path, value if node.plain and "," not in value else f'"{value}"')
    return edited
