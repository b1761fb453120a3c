"""The parts of a scene around the mechanism: parameters and variants, words, scales, the sheet."""

import re
from collections.abc import Mapping

from planes.scene.paths import texts
from planes.scene.reader import MAX_NAME, Fields, Reader, part, section
from planes.scene.source import Items, Node, SourceScalar, SourceTable
from planes.words import Phrase, langs, stand_ins
from planes.words.errors import shown
from planes.words.units import PLANS, Convention, UnitError, read_mu, written_in

Words = dict[str, str]

_KEYS = """
title number designation group student teacher checked approved department university company material letter
scale_note mass reactions mu_convention font lettering format positions date sheet sheets tech role person
teacher_date tech_date person_date checked_date approved_date revisions inventory inventory_accepted replaces
duplicate duplicate_accepted reference first_use copied diagrams hodographs colour frame
document_type values studio
"""
SHEET_KEYS = tuple(_KEYS.split())
_ESKD = """
material mass role person checked copied teacher_date tech_date person_date checked_date approved_date inventory
inventory_accepted replaces duplicate duplicate_accepted reference first_use
"""
MOST_MU = 1e20  # mm per SI unit
SHEET_NUMBERS = ("mass", "sheet", "sheets")
SHEET_LISTS = ("letter", "revisions", "diagrams", "hodographs")
_NO_CELL = {"gost": ("document_type",), "iso": tuple(_ESKD.split())}
_MOST_FORMATS = {4: 9, 3: 7, 2: 5, 1: 4, 0: 3}  # how many of a format of ГОСТ 2.301 may be joined side by side
_SIDE_BY_SIDE = tuple(f"A{n}x{k}" for n, most in _MOST_FORMATS.items() for k in range(3 if n else 2, most + 1))
YES_OR_NO = ("colour", "values")
SHEET_WORDS = {
    "reactions": ("on-from", "from-on"),
    "mu_convention": ("mm_per_unit", "unit_per_mm"),
    "lettering": ("upright", "slanted"),
    "positions": ("true", "false", "12"),
    **dict.fromkeys(YES_OR_NO, ("true", "false")),
    "frame": ("gost", "iso"),
    "format": ("auto", "A4", "A3", "A2", "A1", "A0", *_SIDE_BY_SIDE),
}
_FORMAT_LETTERS = str.maketrans("АХ×X", "Axxx")
_REVISIONS = ("change", "sheet", "document", "sign", "date")  # columns of graphs 14–18
MOST_REVISIONS = 4
MOST_LETTERS = 3  # of graph 4
_NUMBER = re.compile(r"-?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?", re.ASCII)
_ADDRESS = re.compile(r"https?://[!-\"$-~]{1,300}")
_FIND = re.compile(r"[\w'′″^,]*\w[\w'′″^,]*")


def read_words(reader: Reader, node: Node | None, what: str) -> Words:
    """A text in every language; a text given once serves all."""
    if node is None or isinstance(node, SourceScalar):
        return dict.fromkeys(langs(), node.text if node else "")
    table = reader.table(node, what, langs())
    given = {lang: reader.text(entry, part(lang, section(what))) for lang, entry in table.entries.items()}
    if not given:
        raise reader.fault("part_empty", table, what=what)
    any_one = next(iter(given.values()))
    return {lang: next((given[one] for one in stand_ins(lang) if one in given), any_one) for lang in langs()}


def read_plans(reader: Reader, node: Node | None) -> dict[str, float | None]:
    """μ of each plan in mm per SI unit; None where the program chooses."""
    scales = dict.fromkeys(PLANS)
    if node is None:
        return scales
    for plan, entry in reader.table(node, "plans", PLANS).entries.items():
        value: Node | None = entry
        if isinstance(entry, SourceTable):
            value = Fields(reader, entry, Phrase("plan_key", name=plan), ("mu",)).optional("mu")
        scales[plan] = None if value is None else _mu(reader, value, plan)
    return scales


def _mu(reader: Reader, node: Node, plan: str) -> float | None:
    if isinstance(node, SourceScalar) and (node.absent or node.text == "auto"):
        return None
    try:
        text = reader.text(node, part("mu", Phrase("the_plan", plan=Phrase(f"scale_{plan}"))))
        mu = read_mu(text, plan)
    except UnitError as error:
        raise reader.error(error.phrase, node) from None
    if not 1.0 / MOST_MU <= mu <= MOST_MU:
        raise reader.fault("mu_range", node, mu=text, units="auto")
    return mu


def read_vector_mu(scene: Fields, plans: Mapping[str, float | None]) -> tuple[dict[str, float | None], str | None]:
    """μ of each plan of a scene of vectors in mm per SI unit, and the plan whose unit its ``mu`` has."""
    node, mu, quantity = scene.optional("mu"), dict(plans), None
    if isinstance(node, SourceScalar) and (size := _mu(scene.reader, node, "vectors")) is not None:
        quantity = written_in(node.text)[0]
        if mu[quantity] is not None:
            raise scene.fault("both_keys", "mu", what=scene.what, one="mu", two=f"plans.{quantity}")
        mu[quantity] = size
    elif node is not None:
        _mu(scene.reader, node, "vectors")
    return {**mu, "contour": mu["position"], "vectors": None}, quantity


def convention_written(table: SourceTable) -> Convention | None:
    """The convention of the first μ in a scene that has been read."""
    said = (node for path, node in texts(table) if path == ("mu",) or (path[0] == "plans" and node.text != "auto"))
    return next((written_in(node.text)[1] for node in said if not node.absent), None)


def read_find(reader: Reader, node: Node | None) -> tuple[str, ...] | None:
    """Names of the results asked for; whether they exist is checked later."""
    if node is None:
        return None
    nodes = [node] if isinstance(node, SourceScalar) else reader.items(node, "find")
    if not nodes:
        raise reader.fault("find_empty", node)
    what = section("find")
    names = [reader.text(entry, Phrase("entry", number=n, what=what)) for n, entry in enumerate(nodes, 1)]
    for name, entry in zip(names, nodes, strict=True):
        if len(name) > MAX_NAME or not _FIND.fullmatch(name):
            raise reader.fault("bad_result", entry, name=shown(name))
    return tuple(dict.fromkeys(names))


def read_sheet(reader: Reader, node: Node | None) -> Mapping[str, object]:
    """Settings of the sheet as texts; numbers, words and lists only under the keys that accept them."""
    if node is None:
        return {}
    reader.table(node, "sheet", SHEET_KEYS)
    sheet = Fields(reader, node, section("sheet"))
    if all(map(sheet.optional, ("number", "designation"))):
        sheet.one_of("number", "designation")
    settings = {key: _setting(reader, key, entry) for key, entry in reader.present(sheet.table).items()}
    frame = str(settings.get("frame", "gost"))
    for key in (k for k in settings if k in _NO_CELL[frame]):
        raise sheet.fault("no_cell", key, what=sheet.named(key), frame=frame)
    return settings


def _setting(reader: Reader, key: str, node: Node) -> object:
    what = part(key, section("sheet"))
    if key in SHEET_LISTS and isinstance(node, Items):
        return _listed(reader, key, node)
    text = reader.text(node, what)
    if key == "revisions":
        reader.items(node, what)
    if key == "letter":
        return _listed(reader, key, Items([SourceScalar(word, node.line) for word in text.split()], node.line))
    if key == "format":  # in Latin or Russian letters
        node = SourceScalar(text if text == "auto" else text.strip().upper().translate(_FORMAT_LETTERS), node.line)
    if key == "studio" and not _ADDRESS.fullmatch(text):
        raise reader.fault("bad_studio", node, address=shown(text))
    if key in SHEET_WORDS:
        word = reader.word(node, what, SHEET_WORDS[key])
        return word != "false" if key in ("positions", *YES_OR_NO) else word
    plain_number = isinstance(node, SourceScalar) and node.plain and len(text) <= 20 and _NUMBER.fullmatch(text)
    return float(text) if key in SHEET_NUMBERS and plain_number else text


def _listed(reader: Reader, key: str, node: Items) -> object:
    """Names, letters, or rows of the table of revisions, as many as there is room for."""
    what = part(key, section("sheet"))
    most = {"revisions": MOST_REVISIONS, "letter": MOST_LETTERS}.get(key, len(node.items))
    if len(node.items) > most:
        raise reader.fault("list_long", node.items[most], what=what, count=len(node.items), most=most)
    entries = ((Phrase("entry", number=n, what=what), entry) for n, entry in enumerate(node.items, 1))
    return [_revision(reader, entry, one) if key == "revisions" else reader.text(entry, one) for one, entry in entries]


def _revision(reader: Reader, node: Node, what: Phrase) -> dict[str, str]:
    """A row of the table of revisions: a table, or a list in the order of the columns."""
    if isinstance(node, Items) and len(node.items) <= len(_REVISIONS):
        lines = dict.fromkeys(_REVISIONS, node.line)
        node = SourceTable(dict(zip(_REVISIONS, node.items, strict=False)), node.line, lines)
    table = reader.table(node, what, _REVISIONS)
    return {key: reader.text(entry, part(key, what)) for key, entry in reader.present(table).items()}


def read_number_of_frame(reader: Reader, node: Node) -> str:
    """The number of the frame on sheets."""
    frame = Fields(reader, node, Phrase("the_frame"))
    if (entry := frame.optional("number")) is None:
        return "0"
    return reader.check_name(frame.text("number"), Phrase("the_frame"), entry)
