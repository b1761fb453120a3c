"""The keys of a scene file, and the kind of scene they make: a mechanism, vectors alone, or the subject of a pack."""

from collections.abc import Sequence
from itertools import chain

from planes.scene.packs import PARTS_OF_PACKS, SUBJECTS_BY_KEY
from planes.scene.reader import Reader, has_no_value
from planes.scene.source import SourceTable
from planes.words import Phrase
from planes.words.errors import SceneError, quoted_excerpt

SCENE_FORMAT_VERSION = "1"
COMMON_KEYS = ("planes", "title", "note", "text", "missing", "parameters", "variants", "find", "sheet", "plans")
MECHANISM_KEYS = ("frame", "links", "assembly", "drive", "loads", "gravity", "friction", *PARTS_OF_PACKS, "equations")
VECTORS_KEYS = ("vectors", "equations", "values", "mu", "drive")
KEYS_BY_SCENE_KIND: dict[str, Sequence[str]] = {"frame": MECHANISM_KEYS, "vectors": VECTORS_KEYS}
KEYS_BY_SCENE_KIND |= {key: pack.scene_keys for key, pack in SUBJECTS_BY_KEY.items()}
"""The keys of a scene, by the key that decides its kind."""
ALL_SCENE_KEYS = tuple(dict.fromkeys(chain(COMMON_KEYS, *KEYS_BY_SCENE_KIND.values())))
REQUIRED_KEYS: dict[str, Sequence[str]] = {"frame": ("frame", "links", "drive"), "vectors": ("vectors", "equations")}
REQUIRED_KEYS |= {key: (key,) for key in SUBJECTS_BY_KEY}
_PART_EXAMPLES = {
    "frame": ("frame: {points: {O: [0, 0]}}", "fix(O=(0, 0))"),
    "links": ("links: {1: {points: {O: 0, A: 0.1}}}", "link(1, O=0, A=0.1)"),
    "drive": ("drive: {link: 1, phi: 30, omega: 10}", "drive(1, phi=30, omega=10)"),
    "equations": ('equations: ["v_C = v_B + v_CB"]', ""),
    "vectors": ("vectors: {v_B: {value: 2, direction: 120}, v_C: {direction: 80}}", ""),
}
"""The form of a part in a file, and the call that adds it in Python."""


def kind_of_scene(reader: Reader, table: SourceTable) -> str:
    """Check the format and the keys; returns the key that decides the kind of the scene."""
    if "planes" not in table.entries:
        raise SceneError(Phrase("no_format"), reader.file, 1)
    version = reader.read_text(table.entries["planes"], "planes")
    if version != SCENE_FORMAT_VERSION:
        raise reader.error_by_key("other_format", table.entries["planes"], version=quoted_excerpt(version))
    reader.read_table(table, Phrase("the_scene"), ALL_SCENE_KEYS)
    vectors = next((key for key in VECTORS_KEYS if key in table.entries and key not in MECHANISM_KEYS), None)
    alone = vectors or ("equations" in table.entries and not {"frame", "links"} & table.entries.keys())
    usual = "vectors" if alone else "frame"
    kind = next((key for key in SUBJECTS_BY_KEY if key in table.entries), usual)
    own = KEYS_BY_SCENE_KIND[kind]
    other = next((key for key in table.entries if key not in (*COMMON_KEYS, *own)), None)
    if other:
        if vectors == "mu":
            raise reader.error_by_key("mu_place", table.lines["mu"])
        first = next(key for key in own if key in table.entries)
        why = Phrase("two_scenes", one=first, other=other)
        raise reader.error(why, max(table.lines[first], table.lines[other]))
    _check_required_keys(reader, table, kind)
    return kind


def _check_required_keys(reader: Reader, table: SourceTable, kind: str) -> None:
    for key in REQUIRED_KEYS[kind]:
        if key not in table.entries:
            example, call = _PART_EXAMPLES[key]
            raise SceneError(Phrase("part_missing", key=key, example=example, call=call), reader.file, 1)
        if has_no_value(table.entries[key]):
            raise reader.error_by_key("part_empty", table.lines[key], what=key)
