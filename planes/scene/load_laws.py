"""Loads that change with the position: ``force``, ``moment`` and their angles as laws of the motion. A parameter that
gives the drive's position stands for it in every position."""

from collections.abc import Iterable, Iterator, Mapping
from itertools import pairwise
from typing import Literal, cast

from planes.geometry.arithmetic import Arithmetic
from planes.scene.expressions import (
    MAX_EXPRESSION_DEPTH,
    MAX_EXPRESSION_LENGTH,
    is_parameter_name,
    names_in_expression,
    split_into_tokens,
)
from planes.scene.law_expressions import LawParser
from planes.scene.mechanism import FRAME, Amount, Drive, DriveKind, Links, LoadLaw, StrokeLoad
from planes.scene.parameters import names_in_node, names_reachable_from, parameters_depending_on
from planes.scene.paths import entries_of_table
from planes.scene.reader import Fields, section_in_words
from planes.scene.source import Items, Node, Nodes, SourceScalar, SourceTable
from planes.words import Phrase
from planes.words.errors import ExpressionError, list_valid_choices, quoted_excerpt
from planes.words.frozen import frozen
from planes.words.names import letter_of

MOST_TABLE_PAIRS = 400
LAW_KEYS = ("over", "table")
STROKE_KEYS = ("working", "idle", "stroke", "slider")
FORCE_LETTERS = ("F", "R", "M", "MZ", "Fb", "FZ", "P", "G", "I", "N")
"""Letters of results found after the loads, or of loads."""
Sort = Literal["drive", "link", "slider", "point"]


@frozen
class Coordinate:
    """The meaning of a name in a law: ``letter`` of a link, of a slider along its guide, or of a point."""

    letter: str
    sort: Sort
    of: str

    @property
    def coordinate_in_words(self) -> Phrase:
        """The same in words."""
        return Phrase(f"law_{self.sort}_{self.letter}", name=self.of)


def coordinates_by_name(links: Links, drive: Drive) -> dict[str, list[Coordinate]]:
    """All names a law may use, each with all its meanings; two meanings are one too many."""
    meanings: dict[str, list[Coordinate]] = {}
    for name, coordinate in _named_coordinates(links, drive):
        if is_parameter_name(name) and coordinate not in meanings.setdefault(name, []):
            meanings[name].append(coordinate)
    return meanings


def _named_coordinates(links: Links, drive: Drive) -> Iterator[tuple[str, Coordinate]]:
    own = Coordinate(drive.kind, "drive", drive.link)
    yield drive.kind, own
    for link in links.values():
        for letter in ("phi", "omega", "epsilon"):
            here = Coordinate(letter, "link", link.name)
            yield f"{letter}_{link.name}", own if (letter, link.name) == (drive.kind, drive.turning) else here
        for letter in ("s", "v", "a") if link.slides else ():
            here = Coordinate(letter, "slider", link.name)
            yield f"{letter}_{link.name}", own if (letter, link.name) == (drive.kind, drive.link) else here
        for point in link.points:
            yield from ((f"{letter}_{point}", Coordinate(letter, "point", point)) for letter in ("x", "y", "v", "a"))


def check_law(text: str, known: Mapping[str, list[Coordinate]], parameters: Iterable[str] = ()) -> None:
    """Raise :class:`ExpressionError` for an expression that has no definite value from the known names."""
    for name in names_in_expression(text):
        meanings = known.get(name, ())
        if len(meanings) > 1:
            one, two = (m.coordinate_in_words for m in meanings[:2])
            raise ExpressionError(Phrase("law_ambiguous", name=name, one=one, two=two))
        if (
            not meanings and letter_of(name) in FORCE_LETTERS and name != letter_of(name)
        ):  # a letter alone may be a unit
            raise ExpressionError(Phrase("law_later", name=name, valid=list_valid_choices("", known)))
    LawParser(text, dict.fromkeys(known, 1.0), Arithmetic(), [*known, *parameters]).parse_expression()


def law_reader_without_mechanism(scene: Fields, stated: Nodes) -> "LawReader | None":
    """A reader of laws for a scene without a mechanism, where some part of it follows an angle or a length."""
    node = scene.optional_node("drive")
    if node is None:
        return None
    own = Fields(scene.reader, node, section_in_words("drive"), ("phi", "s"))
    kind = cast(DriveKind, own.require_one_key("phi", "s"))
    return LawReader(scene, {}, Drive(FRAME, kind, own.read_number(kind)), stated)


class LawReader:
    """Reads numbers of loads that may be laws; ``stated`` are the parameters as written."""

    def __init__(self, scene: Fields, links: Links, drive: Drive, stated: Nodes) -> None:
        self.reader = scene.reader
        self.links = links
        self.drive = drive
        self.stated = stated
        self.known = coordinates_by_name(links, drive)
        given = entries_of_table(scene.required_node("drive"))
        place = given[drive.kind]
        self.own = {place.text.strip()} if isinstance(place, SourceScalar) else set()
        if self.reader.parameters.get(drive.kind) == drive.position:
            self.own.add(drive.kind)
        uses = {name: names_in_node(node) for name, node in stated.items()}
        self.following = parameters_depending_on(
            self.own & stated.keys(), uses
        )  # the drive's position and what depends on it
        driven = [name for node in given.values() for name in names_in_node(node)]
        self.driven = names_reachable_from(driven, uses)  # parameters that give the drive
        self.written: dict[str, str] = {}  # parameters expressed by the drive's position

    def read_load_magnitude(self, node: Node, what: Phrase, link: str) -> Amount | StrokeLoad:
        """The magnitude of a load: a number, a law, or one for each stroke."""
        if not isinstance(node, SourceTable) or not {"working", "idle"} & node.entries.keys():
            return self.read_amount_or_law(node, what)
        load = Fields(self.reader, node, what, STROKE_KEYS)
        kind = Phrase("sliding_pairs")
        working, idle = (
            self.read_amount_or_law(load.required_node(key), load.phrase_of_key(key)) for key in ("working", "idle")
        )
        sliders = [n for n, x in self.links.items() if x.slides]
        if "slider" in load:
            slider = load.read_known_name("slider", sliders, kind)
        elif link in sliders or len(sliders) == 1:
            slider = link if link in sliders else sliders[0]
        else:
            valid = self.reader.valid_names_in_words("", sliders)
            raise load.error_by_key("law_slider", what=what, link=link, valid=valid)
        behind = load.optional_node("stroke") is not None and load.read_word("stroke", ("ahead", "behind")) == "behind"
        return StrokeLoad(working, idle, slider, "behind" if behind else "ahead")

    def read_amount_or_law(self, node: Node, what: Phrase) -> Amount:
        """A number, a law, or a table over one."""
        if not isinstance(node, SourceTable):
            return self._read_number_or_law(node, what)
        table = Fields(self.reader, node, what, LAW_KEYS)
        over = table.required_node("over")
        law = self._read_number_or_law(over, table.phrase_of_key("over"))
        if not isinstance(law, LoadLaw):
            raise self.reader.error_by_key("law_over", over, what=what, valid=list_valid_choices("", self.known))
        return self._read_table(law.text, table.required_node("table"), table.phrase_of_key("table"))

    def _read_table(self, over: str, node: Node, what: Phrase) -> LoadLaw:
        items = self.reader.read_list(node, what)
        if not 2 <= len(items) <= MOST_TABLE_PAIRS:
            raise self.reader.error_by_key("law_pairs", node, what=what, count=len(items), most=MOST_TABLE_PAIRS)
        pairs = [self._read_table_pair(item, what) for item in items]
        for (one, two), item in zip(pairwise(pairs), items[1:], strict=True):
            if two[0] <= one[0]:
                raise self.reader.error_by_key("law_order", item, what=what, one=one[0], two=two[0])
        law = LoadLaw(over, tuple(pairs))
        if law.turning and abs(pairs[0][1] - pairs[-1][1]) > 1e-9 * max(abs(y) for _, y in pairs):
            raise self.reader.error_by_key("law_turn", items[-1], what=what, first=pairs[0][1], last=pairs[-1][1])
        return law

    def _read_table_pair(self, node: Node, what: Phrase) -> tuple[float, float]:
        if not isinstance(node, Items):
            raise self.reader.error_by_key("law_pair", node, what=what)
        pair = self.reader.read_place(node, what)
        return pair.real, pair.imag

    def changes_with_drive(self, node: Node) -> bool:
        """Whether a number changes with the drive: a table does, and so does an expression of the drive's position."""
        if not isinstance(node, SourceScalar):
            return isinstance(node, SourceTable)
        return not node.is_blank and any(n in self.following or n in self.known for n in names_in_node(node))

    def _read_number_or_law(self, node: Node, what: Phrase) -> Amount:
        """A number; a law where it names a variable of the motion."""
        if (
            not isinstance(node, SourceScalar)
            or node.is_blank
            or not any(map(self._is_moving_name, names_in_node(node)))
        ):
            return self.reader.read_number(node, what)
        try:
            text = self._law_text(node.text)
            check_law(text, self.known, self.reader.parameters)
        except ExpressionError as error:
            raise self.reader.error_by_key("about", node, what=what, why=error.phrase) from None
        if names_in_expression(text):
            return LoadLaw(text)
        return self.reader.read_number(node, what)

    def _is_moving_name(self, name: str) -> bool:
        """Whether a name changes with the position; an unknown name counts too, for it is hardly part of a number."""
        return name in self.following or name not in self.stated or name in self.known

    def _parameter_as_law(self, name: str, depth: int) -> str:
        """A parameter that follows the drive's position, as a law."""
        if name not in self.written:
            if depth > MAX_EXPRESSION_DEPTH:
                raise ExpressionError(Phrase("expression_deep", most=MAX_EXPRESSION_DEPTH))
            node = self.stated[name]
            assert isinstance(node, SourceScalar)  # like every parameter that depends on others
            self.written[name] = f"({self._law_text(node.text, depth + 1)})"
        return self.written[name]

    def _law_text(self, text: str, depth: int = 0) -> str:
        """An expression with the drive's position by its letter, and numbers for parameters."""
        said = ""
        before = "sign"
        for kind, word in split_into_tokens(text):
            said += " " * ("sign" not in (kind, before)) + self._law_word(kind, word, depth)
            before = kind
        if len(said) > MAX_EXPRESSION_LENGTH:
            raise ExpressionError(
                Phrase("about", what=quoted_excerpt(text), why=Phrase("expression_long", most=MAX_EXPRESSION_LENGTH))
            )
        return said

    def _law_word(self, kind: str, word: str, depth: int) -> str:
        if kind != "name":
            return word
        if word in self.stated and word in self.known and not self._is_drive_parameter(word):
            raise ExpressionError(Phrase("law_parameter", name=word, meant=self.known[word][0].coordinate_in_words))
        if word in self.own or (word not in self.stated and any(m.sort == "drive" for m in self.known.get(word, ()))):
            return self.drive.kind
        if word not in self.stated:
            return word
        if word in self.following:
            return self._parameter_as_law(word, depth)
        value = self.reader.parameters[word]
        return repr(value) if value >= 0 else f"({value!r})"

    def _is_drive_parameter(self, name: str) -> bool:
        """Whether a parameter gives the drive and has the name of the same coordinate of the driven link."""
        owners = {"drive": {self.drive.link}, "link": {self.drive.turning}, "slider": {self.drive.link}, "point": ()}
        return name in self.own | self.driven and any(m.of in owners[m.sort] for m in self.known[name])
