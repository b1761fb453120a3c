"""The text of a YAML file as a tree of tables, lists and texts, each with its line number.

Values get no type here: every scalar stays a text, so ``on``, ``y`` and ``1`` are names, ``1:2`` is not a number of
seconds, and ``0,5`` can be refused in words. A file that is not one plain document (anchors, tags, duplicate keys,
wrong encoding) is refused in one sentence with its line.
"""

from __future__ import annotations

import errno
import re
import stat
import sys
import unicodedata
from collections.abc import Iterator, Mapping
from contextlib import suppress
from pathlib import Path

import yaml

from planes.scene.unit_words import SI_REPLACEMENTS
from planes.scene.yaml_faults import explain_yaml_error
from planes.words import Phrase
from planes.words.errors import SceneError, quoted_excerpt, suggest_file
from planes.words.frozen import field, frozen
from planes.words.names import NameTuple
from planes.words.records import decode_table

MAX_FILE_BYTES = 1_000_000
STANDARD_STREAM_PATH = "-"
"""The path of standard input, and, with the suffix of a format, of standard output."""
MAX_SLOW_READER_BYTES = 100_000  # limit where only the slow YAML reader is installed
MAX_NESTING_DEPTH = 50
MAX_YAML_PARTS = 200_000  # words, numbers, beginnings and ends of tables and lists
_BLANK_VALUES = ("", "~", "null", "Null", "NULL")
_REASONS_BY_ERRNO = {errno.EACCES: "no_permission", errno.ENAMETOOLONG: "name_too_long", None: "bad_file_name"}


@frozen
class SourceScalar:
    """A scalar as written; ``plain`` if it had no quotes, ``glued`` if it came right after a comma."""

    text: str
    line: int
    plain: bool = True
    glued: bool = False

    @property
    def is_blank(self) -> bool:
        """Whether it is blank: an empty value, ``~`` or ``null``."""
        return self.plain and self.text in _BLANK_VALUES


@frozen
class Items:
    """A list."""

    items: list[Node]
    line: int


@frozen
class SourceTable:
    """Keys and values in the order of the file, with the line of each key."""

    entries: dict[str, Node]
    line: int
    lines: dict[str, int] = field(default_factory=dict)


Node = SourceScalar | Items | SourceTable
Nodes = Mapping[str, Node]  # by their keys


def walk_nodes(node: Node, path: NameTuple = (), line: int = 0) -> Iterator[tuple[NameTuple, Node, int]]:
    """Every node of the tree with its path of keys (and indices in lists, from "0") and the line of its key."""
    yield path, node, line or node.line
    if isinstance(node, SourceTable):
        for key, value in node.entries.items():
            yield from walk_nodes(value, (*path, key), node.lines.get(key, 0))
    elif isinstance(node, Items):
        for index, value in enumerate(node.items):
            yield from walk_nodes(value, (*path, str(index)))


def read_file_text(path: str | Path, table: bool = False) -> str:
    """The text of a file (a ``table``: in whichever way a spreadsheet saves it), of what is piped in where it is ``-``,
    or a SceneError that says why it cannot be read."""
    name = str(path)
    if name == STANDARD_STREAM_PATH:
        return decode_utf8(sys.stdin.buffer.read(MAX_FILE_BYTES + 1), name)
    try:
        mode = Path(path).stat().st_mode
        if stat.S_ISDIR(mode):
            raise SceneError(Phrase("is_folder"), name)
        if not stat.S_ISREG(mode):
            raise SceneError(Phrase("not_ordinary"), name)
        with open(path, "rb") as stream:
            data = stream.read(MAX_FILE_BYTES + 1)
    except SceneError:
        raise
    except FileNotFoundError:
        raise SceneError(Phrase("no_file", near=suggest_file(path)), name) from None
    except (OSError, TypeError, ValueError) as error:
        key = _REASONS_BY_ERRNO.get(getattr(error, "errno", None))
        reason = Phrase(key) if key else getattr(error, "strerror", None) or str(error)
        raise SceneError(Phrase("unreadable_file", reason=reason), name) from None
    if table and len(data) <= MAX_FILE_BYTES:
        with suppress(UnicodeDecodeError):
            return decode_table(data)
    return decode_utf8(data, name)


def decode_utf8(data: bytes, file: str) -> str:
    """UTF-8 bytes, with or without a byte order mark, as text."""
    if len(data) > MAX_FILE_BYTES:
        raise SceneError(Phrase("file_large", size=MAX_FILE_BYTES // 1_000_000), file)
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        raise SceneError(Phrase("utf_16"), file, 1)
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        byte = data[error.start]
        raise SceneError(Phrase("not_utf_8", byte=byte), file, line) from None


def parse_yaml(text: str, file: str) -> SourceTable:
    """The tree of a document whose outermost node is a table."""
    text = text.removeprefix("\ufeff")
    _check_text_size(text, file)
    loader: type = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    try:
        root = _Builder(file, yaml.parse(text, Loader=loader)).outermost_node()
    except yaml.YAMLError as error:
        phrase, line = explain_yaml_error(error, text)
        raise SceneError(phrase, file, line) from None
    except RecursionError:
        raise SceneError(Phrase("deep_file", most=MAX_NESTING_DEPTH), file) from None
    if root is None or (isinstance(root, SourceScalar) and root.is_blank):
        raise SceneError(Phrase("empty_file"), file, 1)
    if not isinstance(root, SourceTable):
        raise SceneError(Phrase("not_keys"), file, root.line)
    return root


def _check_text_size(text: str, file: str) -> None:
    limit = MAX_FILE_BYTES if hasattr(yaml, "CSafeLoader") else MAX_SLOW_READER_BYTES
    if len(text) > limit:
        raise SceneError(Phrase("text_long", limit=limit), file)
    if not text.strip():
        raise SceneError(Phrase("empty_file"), file, 1)
    for index, char in enumerate(text):
        if (char < " " and char not in "\n\r\t") or char in "\x7f\ufeff\ufffe\uffff" or "\ud800" <= char < "\ue000":
            line = text.count("\n", 0, index) + 1
            raise SceneError(Phrase("control_character", code=ord(char)), file, line)


class _Builder:
    """Builds the tree from the reader's events."""

    def __init__(self, file: str, events: Iterator[yaml.Event]) -> None:
        self.file = file
        self.events = events
        self.line, self.end = 1, -2  # where the last event begins, and where the last scalar ends
        self.left = MAX_YAML_PARTS

    def error_at_line(self, words: str, line: int, /, **parts: object) -> SceneError:
        """An error at a line."""
        return SceneError(Phrase(words, **parts), self.file, line)

    def outermost_node(self) -> Node | None:
        """The outermost node of the only document."""
        root = None
        documents = 0
        while not isinstance(event := self._next_event(), yaml.StreamEndEvent):
            if isinstance(event, yaml.NodeEvent):
                root = self._build_node(event, 0)
            elif isinstance(event, yaml.DocumentStartEvent):
                documents += 1
                if documents > 1:
                    raise self.error_at_line("second_document", self.line)
        return root

    def _next_event(self) -> yaml.Event:
        event = next(self.events)
        self.line = event.start_mark.line + 1 if event.start_mark else self.line
        self.left -= 1
        if self.left < 0:
            raise self.error_at_line("full_file", self.line, most=MAX_YAML_PARTS)
        if isinstance(event, yaml.NodeEvent):
            self._refuse_marks(event)
        return event

    def _refuse_marks(self, event: yaml.NodeEvent) -> None:
        if isinstance(event, yaml.AliasEvent):
            raise self.error_at_line("alias", self.line, name=_shortened_text(event.anchor or ""))
        if event.anchor is not None:
            raise self.error_at_line("anchor", self.line, name=_shortened_text(event.anchor))
        if (tag := getattr(event, "tag", None)) is not None:
            raise self.error_at_line("tag", self.line, name=_shortened_text(tag.replace("tag:yaml.org,2002:", "!!")))

    def _build_node(self, event: yaml.Event, depth: int) -> Node:
        """The node that begins with an event."""
        if isinstance(event, yaml.ScalarEvent):
            return self._build_scalar(event)
        if depth >= MAX_NESTING_DEPTH:
            raise self.error_at_line("deep_file", self.line, most=MAX_NESTING_DEPTH)
        if isinstance(event, yaml.MappingStartEvent):
            return self._build_table(event, depth)
        items = Items([], self.line)
        while not isinstance(event := self._next_event(), yaml.SequenceEndEvent):
            items.items.append(self._build_node(event, depth + 1))
        return items

    def _build_scalar(self, event: yaml.ScalarEvent) -> SourceScalar:
        text = unicodedata.normalize("NFC", event.value) if len(event.value) <= 1000 else event.value
        start, end = (mark.index if mark else 0 for mark in (event.start_mark, event.end_mark))
        glued = start == self.end + 1
        self.end = end
        return SourceScalar(text, self.line, event.style in (None, ""), glued)

    def _build_table(self, event: yaml.MappingStartEvent, depth: int) -> SourceTable:
        table = SourceTable({}, self.line)
        last = None
        while not isinstance(one := self._next_event(), yaml.MappingEndEvent):
            key = self._build_key(one, table)
            value = self._build_node(self._next_event(), depth + 1)
            if event.flow_style and isinstance(value, SourceScalar) and isinstance(last, SourceScalar):
                self._refuse_decimal_comma(last, key, value)
            table.entries[key] = last = value
        return table

    def _build_key(self, event: yaml.Event, table: SourceTable) -> str:
        if not isinstance(event, yaml.ScalarEvent):
            raise self.error_at_line("key_not_word", self.line)
        text = self._build_scalar(event).text
        if not text:
            raise self.error_at_line("key_absent", self.line)
        first = table.lines.setdefault(text, self.line)
        if text in table.entries:
            key = "key_twice" if first == self.line else "key_twice_apart"
            raise self.error_at_line(key, self.line, key=quoted_excerpt(text), line=first, second=self.line)
        return text

    def _refuse_decimal_comma(self, last: SourceScalar, key: str, value: SourceScalar) -> None:
        """In {a: 0,5} the comma ends the value and 5 becomes a key: explain the decimal comma."""
        if value.text:
            return
        if last.text.count("(") > last.text.count(")"):
            written = quoted_excerpt(f"{last.text}, {key}")
            raise self.error_at_line("quotes_needed", last.line, written=written)
        if key[0].isdigit() and last.text[-1:].isdigit():
            figures, unit = [*re.split(r"(?<=\d)\s*(?=\D)", key, maxsplit=1), ""][:2]
            in_si = SI_REPLACEMENTS.get(unit.lower())
            number = f"{last.text}.{figures}{in_si}" if in_si else f"{last.text}.{key}"
            why = Phrase("decimal_point", number=_shortened_text(number))
            raise self.error_at_line("about", last.line, what=quoted_excerpt(f"{last.text},{key}"), why=why)


def _shortened_text(text: str) -> str:
    return quoted_excerpt(text)[1:-1]
