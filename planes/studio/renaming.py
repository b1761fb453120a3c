"""A point or a link under another name: every mention of it in a scene's text, and nothing else."""

import re
from collections.abc import Callable
from itertools import permutations

from planes.plans import Plans
from planes.plans.quantities import quantities_by_name
from planes.scene import loads
from planes.scene.mechanism import LOAD_POINT_KEYS
from planes.scene.source import SourceScalar, parse_yaml, walk_nodes
from planes.scene.vector_equations import VECTOR_NAME_PATTERN
from planes.solving import plans_and_requested_results
from planes.studio.message_shapes import NAME_PATTERN
from planes.studio.text_edits import SCENE_FILE_NAME, Edited
from planes.words import Phrase
from planes.words.errors import PlanesError

NAME_PLACES_BY_KIND = {
    "point": (
        "(frame|links/[^/]+)/points/[^/]+|(assembly|friction)/[^/]+",
        "x|y|v|a",
        ("centre", "through", *LOAD_POINT_KEYS),
    ),
    "link": ("links/[^/]+", "phi|omega|epsilon|s|v|a", ("link", "on", "slider")),
}
"""The places of keys that are names; the letters of the motion in laws of loads; keys whose values are names."""
NAMED_PART_PATTERN = "(frame|links/[^/]+)/(points|guides)/[^/]+|links/[^/]+"
ASKED_NAME_PATHS = ("find",), ("sheet", "diagrams"), ("sheet", "hodographs")
"""The places of names of quantities and curves."""
LETTERS_NOT_ASKED_FOR = "v", "a", "aq", "phi", "s", "epsilonq"
"""Of vectors and curves that are no quantities to be found."""
Path = tuple[str, ...]


def text_with_renamed_part(text: str, kind: str, name: str, to: str) -> Edited:
    """The text with a point or a link under another name. :class:`PlanesError` where that name is taken, or is none, or
    the mechanism cannot have it."""
    keys, letters, valued = NAME_PLACES_BY_KIND["point" if kind == "point" else "link"]
    places = {"/".join(path): path for path, _, _ in walk_nodes(parse_yaml(text, SCENE_FILE_NAME))}
    names = {path[-1] for place, path in places.items() if re.fullmatch(NAMED_PART_PATTERN, place)}
    key = (
        "none"
        if name not in names
        else "taken"
        if to in (*names, "0")
        else ""
        if NAME_PATTERN.fullmatch(to)
        else "wrong"
    )
    if key:
        raise PlanesError(Phrase(f"studio_name_{key}", name=name if key == "none" else to))
    law = re.compile(rf"(?<!\w)({letters})_{re.escape(name)}(?!\w)")

    def other(path: Path, value: str) -> str:
        if value == name and (path[-1] in valued or path[:2] == ("sheet", "paths")):
            return to
        return law.sub(rf"\1_{to}", value) if path[0] == "loads" else value

    edited = _with_replaced_values(Edited(text), other)
    for place, path in places.items():
        if path[-1:] == (name,) and re.fullmatch(keys, place):
            edited = edited.with_renamed_key(path, to)
    try:
        before = _plans_of_text(text)
    except PlanesError:
        return edited  # no mechanism yet
    return _with_renamed_quantities(edited, before, _plans_of_text(edited.text))


def _plans_of_text(text: str) -> Plans:
    """The plans of a mechanism, whatever is asked of them."""
    return plans_and_requested_results(
        loads(Edited(text).without_key(("find",)).without_key(("equations",)).text, SCENE_FILE_NAME), shown=True
    )[0]


def _with_renamed_quantities(edited: Edited, before: Plans, after: Plans) -> Edited:
    """The text with other names of the quantities and curves asked for, however they are typed, and of the vectors in
    equations, which have the program's names."""
    pairs = dict(zip(_names_of_quantities(before), _names_of_quantities(after), strict=True))
    names = before.default_naming.name_finder(pairs, poles=False)

    def other(path: Path, value: str) -> str:
        if path[0] == "equations":
            return re.sub(VECTOR_NAME_PATTERN, lambda v: pairs.get(v[0], v[0]), value)
        meant = names.possible_names(value)[:1] if path[:1] in ASKED_NAME_PATHS or path[:2] in ASKED_NAME_PATHS else ()
        return next((after.default_naming.typed_name(pairs[name]) for name in meant if pairs[name] != name), value)

    return _with_replaced_values(edited, other)


def _names_of_quantities(plans: Plans) -> list[str]:
    """The names of quantities, of vectors of one point relative to any other and of curves, in an order that no name
    changes."""
    subjects = [*plans.points, *plans.mechanism.links, *map("".join, permutations(plans.points, 2))]
    names = [
        *quantities_by_name(plans),
        *(f"{letter}_{subject}" for letter in LETTERS_NOT_ASKED_FOR for subject in subjects),
    ]
    return [*names, *(f"{name}_{axis}" for name in names for axis in "xy")]


def _with_replaced_values(edited: Edited, other: Callable[[Path, str], str]) -> Edited:
    """The text with other values where they differ; a quoted one stays quoted, and one with a comma needs to be."""
    for path, node, _ in walk_nodes(parse_yaml(edited.text, SCENE_FILE_NAME)):
        if isinstance(node, SourceScalar) and (value := other(path, node.text)) != node.text:
            edited = edited.with_value(path, value if node.plain and "," not in value else f'"{value}"')
    return edited
