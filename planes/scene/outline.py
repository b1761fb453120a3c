"""The keys of a scene file, and the kind of scene they make: a mechanism, vectors alone, bodies in equilibrium."""

from planes.scene.reader import Reader, absent
from planes.scene.source import SourceTable
from planes.words import Phrase
from planes.words.errors import SceneError, shown

FORMAT = "1"
COMMON_KEYS = ("planes", "title", "note", "text", "missing", "parameters", "variants", "find", "sheet", "plans")
MECHANISM_KEYS = ("frame", "links", "assembly", "drive", "loads", "gravity", "friction", "crank_slider", "equations")
VECTORS_KEYS = ("vectors", "equations", "values", "mu", "drive")
STATICS_KEYS = ("points", "bodies", "members", "supports", "loads", "method", "pole", "drive")
KINDS = {"frame": MECHANISM_KEYS, "vectors": VECTORS_KEYS, "points": STATICS_KEYS}
"""The keys of a scene, by the key that decides its kind."""
KEYS = tuple(dict.fromkeys((*COMMON_KEYS, *MECHANISM_KEYS, *VECTORS_KEYS, *STATICS_KEYS)))
NEEDED = {"frame": ("frame", "links", "drive"), "vectors": ("vectors", "equations"), "points": ("points",)}
_EXAMPLES = {
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
    version = reader.text(table.entries["planes"], "planes")
    if version != FORMAT:
        raise reader.fault("other_format", table.entries["planes"], version=shown(version))
    reader.table(table, Phrase("the_scene"), KEYS)
    vectors = next((key for key in VECTORS_KEYS if key in table.entries and key not in MECHANISM_KEYS), None)
    alone = vectors or ("equations" in table.entries and not {"frame", "links"} & table.entries.keys())
    kind = "points" if "points" in table.entries else "vectors" if alone else "frame"
    own = KINDS[kind]
    other = next((key for key in table.entries if key not in (*COMMON_KEYS, *own)), None)
    if other:
        if vectors == "mu":
            raise reader.fault("mu_place", table.lines["mu"])
        first = next(key for key in own if key in table.entries)
        why = Phrase("two_scenes", one=first, other=other)
        raise reader.error(why, max(table.lines[first], table.lines[other]))
    _check_required(reader, table, kind)


def _check_required(reader: Reader, table: SourceTable, kind: str) -> None:
    for key in NEEDED[kind]:
        if key not in table.entries:
            example, call = _EXAMPLES[key]
            raise SceneError(Phrase("part_missing", key=key, example=example, call=call), reader.file, 1)
        if absent(table.entries[key]):
            raise reader.fault("part_empty", table.lines[key], what=key)
