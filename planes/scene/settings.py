"""The parts of a scene around the mechanism: parameters and variants, words, scales, the sheet."""

import re
from collections.abc import Mapping

from planes.scene.paths import texts_with_paths
from planes.scene.reader import MAX_NAME_LENGTH, Fields, Reader, part_in_words, section_in_words
from planes.scene.source import Items, Node, SourceScalar, SourceTable
from planes.words import Phrase, available_languages, fallback_languages
from planes.words.errors import quoted_excerpt
from planes.words.names import NameTuple
from planes.words.units import PLANS_WITH_MU, Convention, UnitError, plan_and_convention_of_mu, read_mu

Words = Mapping[str, str]  # by language

_SHEET_KEYS_TEXT = """
title number designation group student teacher checked approved department university company material letter
scale_note mass reactions mu_convention font lettering format positions date sheet sheets tech role person
teacher_date tech_date person_date checked_date approved_date revisions inventory inventory_accepted replaces
duplicate duplicate_accepted reference first_use copied diagrams hodographs paths colour frame
document_type values studio
"""
SHEET_KEYS = tuple(_SHEET_KEYS_TEXT.split())
_ESKD_ONLY_KEYS_TEXT = """
material mass role person checked copied teacher_date tech_date person_date checked_date approved_date inventory
inventory_accepted replaces duplicate duplicate_accepted reference first_use
"""
LARGEST_SCALE_MM_PER_SI = 1e20  # mm per SI unit
SHEET_NUMBER_KEYS = ("mass", "sheet", "sheets")
SHEET_LIST_KEYS = ("letter", "revisions", "diagrams", "hodographs", "paths")
_KEYS_WITHOUT_CELL = {"gost": ("document_type",), "iso": tuple(_ESKD_ONLY_KEYS_TEXT.split())}
_MOST_JOINED_FORMATS = {4: 9, 3: 7, 2: 5, 1: 4, 0: 3}  # how many of a format of ГОСТ 2.301 may be joined side by side
_JOINED_FORMAT_NAMES = tuple(
    f"A{n}x{k}" for n, most in _MOST_JOINED_FORMATS.items() for k in range(3 if n else 2, most + 1)
)
YES_OR_NO_KEYS = ("colour", "values")
SHEET_WORD_CHOICES = {
    "reactions": ("on-from", "from-on"),
    "mu_convention": ("mm_per_unit", "unit_per_mm"),
    "lettering": ("upright", "slanted"),
    "positions": ("true", "false", "12"),
    **dict.fromkeys(YES_OR_NO_KEYS, ("true", "false")),
    "frame": ("gost", "iso"),
    "format": ("auto", "A4", "A3", "A2", "A1", "A0", *_JOINED_FORMAT_NAMES),
}
_FORMAT_LETTER_REPLACEMENTS = str.maketrans("АХ×X", "Axxx")
_REVISION_COLUMNS = ("change", "sheet", "document", "sign", "date")  # columns of graphs 14–18
MOST_REVISION_ROWS = 4
MOST_STAGE_LETTERS = 3  # of graph 4
_NUMBER_PATTERN = re.compile(r"-?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?", re.ASCII)
_WEB_ADDRESS_PATTERN = re.compile(r"https?://[!-\"$-~]{1,300}")
_FIND_NAME_PATTERN = re.compile(r"[\w'′″^,]*\w[\w'′″^,]*")


def read_text_by_language(reader: Reader, node: Node | None, what: str) -> Words:
    """A text in every language; a text given once serves all."""
    if node is None or isinstance(node, SourceScalar):
        return dict.fromkeys(available_languages(), node.text if node else "")
    table = reader.read_table(node, what, available_languages())
    given = {
        lang: reader.read_text(entry, part_in_words(lang, section_in_words(what)))
        for lang, entry in table.entries.items()
    }
    if not given:
        raise reader.error_by_key("part_empty", table, what=what)
    any_one = next(iter(given.values()))
    return {
        lang: next((given[one] for one in fallback_languages(lang) if one in given), any_one)
        for lang in available_languages()
    }


def read_plan_scales(reader: Reader, node: Node | None) -> dict[str, float | None]:
    """μ of each plan in mm per SI unit; None where the program chooses."""
    scales = dict.fromkeys(PLANS_WITH_MU)
    if node is None:
        return scales
    for plan, entry in reader.read_table(node, "plans", PLANS_WITH_MU).entries.items():
        value: Node | None = entry
        if isinstance(entry, SourceTable):
            value = Fields(reader, entry, Phrase("plan_key", name=plan), ("mu",)).optional_node("mu")
        scales[plan] = None if value is None else _read_scale(reader, value, plan)
    return scales


def _read_scale(reader: Reader, node: Node, plan: str) -> float | None:
    if isinstance(node, SourceScalar) and (node.is_blank or node.text == "auto"):
        return None
    try:
        text = reader.read_text(node, part_in_words("mu", Phrase("the_plan", plan=Phrase(f"scale_{plan}"))))
        mu = read_mu(text, plan)
    except UnitError as error:
        raise reader.error(error.phrase, node) from None
    if not 1.0 / LARGEST_SCALE_MM_PER_SI <= mu <= LARGEST_SCALE_MM_PER_SI:
        raise reader.error_by_key("mu_range", node, mu=text, units="auto")
    return mu


def read_vector_scales(scene: Fields, plans: Mapping[str, float | None]) -> tuple[dict[str, float | None], str | None]:
    """μ of each plan of a scene of vectors in mm per SI unit, and the plan whose unit its ``mu`` has."""
    node = scene.optional_node("mu")
    mu = dict(plans)
    quantity = None
    if isinstance(node, SourceScalar) and (size := _read_scale(scene.reader, node, "vectors")) is not None:
        quantity = plan_and_convention_of_mu(node.text)[0]
        if mu[quantity] is not None:
            raise scene.error_by_key("both_keys", "mu", what=scene.what, one="mu", two=f"plans.{quantity}")
        mu[quantity] = size
    elif node is not None:
        _read_scale(scene.reader, node, "vectors")
    return {**mu, "contour": mu["position"], "vectors": None}, quantity


def written_mu_convention(table: SourceTable) -> Convention | None:
    """The convention of the first μ in a scene that has been read."""
    said = (
        node
        for path, node in texts_with_paths(table)
        if path == ("mu",) or (path[0] == "plans" and node.text != "auto")
    )
    return next((plan_and_convention_of_mu(node.text)[1] for node in said if not node.is_blank), None)


def read_names_to_find(reader: Reader, node: Node | None) -> NameTuple | None:
    """Names of the results asked for; whether they exist is checked later."""
    if node is None:
        return None
    nodes = [node] if isinstance(node, SourceScalar) else reader.read_list(node, "find")
    if not nodes:
        raise reader.error_by_key("find_empty", node)
    what = section_in_words("find")
    names = [reader.read_text(entry, Phrase("entry", number=n, what=what)) for n, entry in enumerate(nodes, 1)]
    for name, entry in zip(names, nodes, strict=True):
        if len(name) > MAX_NAME_LENGTH or not _FIND_NAME_PATTERN.fullmatch(name):
            raise reader.error_by_key("bad_result", entry, name=quoted_excerpt(name))
    return tuple(dict.fromkeys(names))


def read_sheet_settings(reader: Reader, node: Node | None) -> Mapping[str, object]:
    """Settings of the sheet as texts; numbers, words and lists only under the keys that accept them."""
    if node is None:
        return {}
    reader.read_table(node, "sheet", SHEET_KEYS)
    sheet = Fields(reader, node, section_in_words("sheet"))
    if all(map(sheet.optional_node, ("number", "designation"))):
        sheet.require_one_key("number", "designation")
    settings = {
        key: _read_sheet_setting(reader, key, entry) for key, entry in reader.non_empty_values(sheet.table).items()
    }
    frame = str(settings.get("frame", "gost"))
    for key in (k for k in settings if k in _KEYS_WITHOUT_CELL[frame]):
        raise sheet.error_by_key("no_cell", key, what=sheet.phrase_of_key(key), frame=frame)
    return settings


def _read_sheet_setting(reader: Reader, key: str, node: Node) -> object:
    what = part_in_words(key, section_in_words("sheet"))
    if key in SHEET_LIST_KEYS and isinstance(node, Items):
        return _read_listed_setting(reader, key, node)
    text = reader.read_text(node, what)
    if key == "revisions":
        reader.read_list(node, what)
    if key == "letter":
        return _read_listed_setting(
            reader, key, Items([SourceScalar(word, node.line) for word in text.split()], node.line)
        )
    if key == "format":  # in Latin or Russian letters
        node = SourceScalar(
            text if text == "auto" else text.strip().upper().translate(_FORMAT_LETTER_REPLACEMENTS), node.line
        )
    if key == "studio" and not _WEB_ADDRESS_PATTERN.fullmatch(text):
        raise reader.error_by_key("bad_studio", node, address=quoted_excerpt(text))
    if key in SHEET_WORD_CHOICES:
        word = reader.read_word(node, what, SHEET_WORD_CHOICES[key])
        if key in ("positions", *YES_OR_NO_KEYS):
            return word != "false"
        return word
    plain_number = isinstance(node, SourceScalar) and node.plain and len(text) <= 20 and _NUMBER_PATTERN.fullmatch(text)
    return float(text) if key in SHEET_NUMBER_KEYS and plain_number else text


def _read_listed_setting(reader: Reader, key: str, node: Items) -> object:
    """Names, letters, or rows of the table of revisions, as many as there is room for."""
    what = part_in_words(key, section_in_words("sheet"))
    most = {"revisions": MOST_REVISION_ROWS, "letter": MOST_STAGE_LETTERS}.get(key, len(node.items))
    if len(node.items) > most:
        raise reader.error_by_key("list_long", node.items[most], what=what, count=len(node.items), most=most)
    entries = ((Phrase("entry", number=n, what=what), entry) for n, entry in enumerate(node.items, 1))
    return [
        _read_revision_row(reader, entry, one) if key == "revisions" else reader.read_text(entry, one)
        for one, entry in entries
    ]


def _read_revision_row(reader: Reader, node: Node, what: Phrase) -> dict[str, str]:
    """A row of the table of revisions: a table, or a list in the order of the columns."""
    if isinstance(node, Items) and len(node.items) <= len(_REVISION_COLUMNS):
        lines = dict.fromkeys(_REVISION_COLUMNS, node.line)
        node = SourceTable(dict(zip(_REVISION_COLUMNS, node.items, strict=False)), node.line, lines)
    table = reader.read_table(node, what, _REVISION_COLUMNS)
    return {
        key: reader.read_text(entry, part_in_words(key, what)) for key, entry in reader.non_empty_values(table).items()
    }


def read_number_of_frame(reader: Reader, node: Node) -> str:
    """The number of the frame on sheets."""
    frame = Fields(reader, node, Phrase("the_frame"))
    if (entry := frame.optional_node("number")) is None:
        return "0"
    return reader.check_name(frame.read_text("number"), Phrase("the_frame"), entry)
