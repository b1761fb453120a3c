"""The keys of a scene file, and the kind of scene they make: a mechanism, vectors alone, bodies in equilibrium."""

from planes.scene.reader import Reader, has_no_value
from planes.scene.source import SourceTable
from planes.words import Phrase
from planes.words.errors import SceneError, quoted_excerpt

SCENE_FORMAT_VERSION = "1"
COMMON_KEYS = ("planes", "title", "note", "text", "missing", "parameters", "variants", "find", "sheet", "plans")
MECHANISM_KEYS = ("frame", "links", "assembly", "drive", "loads", "gravity", "friction", "crank_slider", "equations")
VECTORS_KEYS = ("vectors", "equations", "values", "mu", "drive")
STATICS_KEYS = ("points", "bodies", "members", "supports", "loads", "method", "pole", "drive")
KEYS_BY_SCENE_KIND = {"frame": MECHANISM_KEYS, "vectors": VECTORS_KEYS, "points": STATICS_KEYS}
"""The keys of a scene, by the key that decides its kind."""
ALL_SCENE_KEYS = tuple(dict.fromkeys((*COMMON_KEYS, *MECHANISM_KEYS, *VECTORS_KEYS, *STATICS_KEYS)))
REQUIRED_KEYS = {"frame": ("frame", "links", "drive"), "vectors": ("vectors", "equations"), "points": ("points",)}
_PART_EXAMPLES = {
    "frame": ("frame: {points: {O: [0, 0]}}", "fix(O=(0, 0))"),
    "links": ("links: {1: {points: {O: 0, A: 0.1}}}", "link(1, O=0, A=0.1)"),
    "drive": ("drive: {link: 1, phi: 30, omega: 10}", "drive(1, phi=30, omega=10)"),
    "equations": ('equations: ["v_C = v_B + v_CB"]', ""),
    "vectors": ("vectors: {v_B: {value: 2, direction: 120}, v_C: {direction: 80}}", ""),
}
"""The form of a part in a file, and the call that adds it in Python."""


def check_outline(reader: Reader, table: SourceTable) -> None:
    """Check the format and the keys, and tell the kind: a mechanism, vectors or statics."""
    if "planes" not in table.entries:
        raise SceneError(Phrase("no_format"), reader.file, 1)
    version = reader.read_text(table.entries["planes"], "planes")
    if version != SCENE_FORMAT_VERSION:
        raise reader.error_by_key("other_format", table.entries["planes"], version=quoted_excerpt(version))
    reader.read_table(table, Phrase("the_scene"), ALL_SCENE_KEYS)
    vectors = next((key for key in VECTORS_KEYS if key in table.entries and key not in MECHANISM_KEYS), None)
    alone = vectors or ("equations" in table.entries and not {"frame", "links"} & table.entries.keys())
    kind = "points" if "points" in table.entries else "vectors" if alone else "frame"
    own = KEYS_BY_SCENE_KIND[kind]
    other = next((key for key in table.entries if key not in COMMON_KEYS + own), None)
    if other:
        if vectors == "mu":
            raise reader.error_by_key("mu_place", table.lines["mu"])
        first = next(key for key in own if key in table.entries)
        why = Phrase("two_scenes", one=first, other=other)
        raise reader.error(why, max(table.lines[first], table.lines[other]))
    _check_required_keys(reader, table, kind)


def _check_required_keys(reader: Reader, table: SourceTable, kind: str) -> None:
    for key in REQUIRED_KEYS[kind]:
        if key not in table.entries:
            example, call = _PART_EXAMPLES[key]
            raise SceneError(Phrase("part_missing", key=key, example=example, call=call), reader.file, 1)
        if has_no_value(table.entries[key]):
            raise reader.error_by_key("part_empty", table.lines[key], what=key)
