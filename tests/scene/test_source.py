"""Floor 1: the text of a file as a tree with lines, and every way it is refused."""

import os

import pytest
import yaml

from planes.scene import source
from planes.scene.source import Items, SourceScalar, SourceTable, parse_yaml, read_file_text, walk_nodes
from planes.words.errors import SceneError
from tests.helpers.counting import at_most

SIZE = 999_000
ACCENTS = "a" + "\u0300\u0316" * 200

BAD = [
    ("a:\n\tb: 1\n", "there is a tab here", 2),
    ("a: 1\n\tb: 1\n", "", 2),
    ("a: [1, 2\n", "not closed", 1),
    ("a: {b: 1\nc: 2\n", "not closed", 1),
    ('a: "b\n', "a quote is not closed", 1),
    ("a: b: c\n", "second ':'", 1),
    ("a: 1\n  b: 2\n", "second ':'", 2),
    ("a: 1\nb\n", "':' is missing", 2),
    ("a: 1\n b: 2\n", "", 2),
    ("a: &x 1\n", "anchor &x", 1),
    ("a: 1\nb: *a\n", "alias *a", 2),
    ("a: !!python/object:os.x 1\n", "tag !!python", 1),
    ("a: !t 1\n", "tag !t", 1),
    ("a: 1\nb: 2\na: 3\n", "in line 1 and in line 3", 3),
    ("{a: 1, a: 2}", "line 1", 1),
    ("a: {b: 1, c: {d: 1, d: 2}}", '"d" occurs twice', 1),
    ("a: 1\n---\nb: 1\n", "second document", 2),
    ("", "empty", 1),
    ("  \n\n", "empty", 1),
    ("# only a comment\n", "empty", 1),
    ("---\n", "empty", 1),
    ("null", "empty", 1),
    ("- 1\n- 2\n", "key: value", 1),
    ("hello", "key: value", 1),
    ("[a]: 1\n", "a key must be a word", 1),
    ("? {a: 1}\n: 2\n", "a key must be a word", 1),
    (": 1\n", "", 1),
    ("? \n: 1\n", "key is missing", 1),
    ("a: b\0c\n", "U+0000", 1),
    ("a: 1\nb: \x07\n", "U+0007", 2),
    ("a: \ud800\n", "U+D800", 1),
    ("a: @b\n", "begin with @", 1),
    ("a: `b`\n", "begin with `", 1),
    ("a: %b\n", "begin with %", 1),
    ('a: "\\q"\n', "escape", 1),
    ("a: ]\n", "", 1),
    ("a: {b: 0,5}\n", "decimal point: 0.5", 1),
    ("a: {l: hypot(3,4)}\n", 'quotes: "hypot(3, 4)"', 1),
    ("a: -\n", "", 1),
    ("a: 1\n- b\n", "", 2),
    ("<<: *x\n", "alias", 1),
    ("a: 'b'c\n", "", 1),
    ("%YAML 9.9\n---\na: 1", "", 1),
    ("a: " + "[" * 60 + "]" * 60, "deeper than 50", 1),
    ("a" * 1_000_001, "longer than", None),
    ("й: 1\nи\u0306: 2\n", "occurs twice", 2),
    ("a: 1 \ufeff b\n", "U+FEFF", 1),
]


@pytest.mark.parametrize(("text", "piece", "line"), BAD)
def test_refusal(text, piece, line):
    with pytest.raises(SceneError) as caught:
        parse_yaml(text, "s.yaml")
    assert piece in str(caught.value.phrase) and caught.value.line == line
    assert "\n" not in str(caught.value) and str(caught.value).startswith("s.yaml")
    assert len(str(caught.value)) < 250


def test_everything_stays_text_and_knows_its_line():
    tree = parse_yaml("planes: 1\non: yes\ny: 1:2\n1: 1e-3\nlist: [a,\n  'b c']\nempty:\nnone: ~\nquoted: ''\n", "s")
    texts = {key: node.text for key, node in tree.entries.items() if isinstance(node, SourceScalar)}
    assert texts == {"planes": "1", "on": "yes", "y": "1:2", "1": "1e-3", "empty": "", "none": "~", "quoted": ""}
    assert [key for key, node in tree.entries.items() if isinstance(node, SourceScalar) and node.is_blank] == [
        "empty",
        "none",
    ]
    assert isinstance(tree.entries["list"], Items) and [n.line for n in tree.entries["list"].items] == [5, 6]
    assert tree.lines["none"] == 8
    assert {path: line for path, _, line in walk_nodes(tree)}["list", "1"] == 6


def test_one_document_may_have_marks_and_windows_lines():
    for text in ("---\na: 1\nb: 2\n...\n", "\ufeffa: 1\r\nb: 2\r\n", "# c\na: 1\n\nb: 2"):
        assert list(parse_yaml(text, "s").entries) == ["a", "b"]


def test_the_slow_reader_reads_the_same(monkeypatch):
    text = "a: [1, {b: 'c'}]\nd:\n  e: 1\n"
    fast = parse_yaml(text, "s")
    monkeypatch.delattr(yaml, "CSafeLoader")
    assert parse_yaml(text, "s") == fast
    with pytest.raises(SceneError, match="tab"):
        parse_yaml("a:\n\tb: 1", "s")
    with pytest.raises(SceneError, match="longer than"):
        parse_yaml("a" * 200_000, "s")


def test_reading_files(tmp_path):
    good = tmp_path / "й.yaml"
    good.write_bytes("\ufeffa: й\n".encode())
    assert isinstance(parse_yaml(read_file_text(good), str(good)), SourceTable)
    for data, piece in (
        (b"a: 1\nb: \xff\n", ":2: byte 0xff"),
        ("a: 1".encode("utf-16"), "UTF-16"),
        (b"a" * 1_000_001, "1 MB"),
        ("a: й".encode("cp1251"), ":1: byte 0xe9"),
    ):
        bad = tmp_path / "bad.yaml"
        bad.write_bytes(data)
        with pytest.raises(SceneError) as caught:
            read_file_text(bad)
        assert piece in str(caught.value) and "bad.yaml" in str(caught.value)


def test_what_is_no_file(tmp_path):
    os.mkfifo(tmp_path / "pipe")
    for name, piece in (
        ("nothing", "no such file"),
        ("", "a folder"),
        ("pipe", "not an ordinary file"),
        ("x" * 3000, "cannot be read"),
        ("\0", "cannot be read"),
        ("a\ud800", "be read"),
    ):
        with pytest.raises(SceneError, match=piece):
            read_file_text(tmp_path / name)


def filled(unit, before="", after=""):
    return before + unit * ((SIZE - len(before) - len(after)) // len(unit)) + after


UNITS = (
    "[",
    "{",
    ":",
    ": ",
    "&a ",
    "*a ",
    "!",
    "? ",
    "- ",
    "-\n",
    '"',
    "'",
    "a\n b",
    "\t",
    "#",
    "a: a: ",
    "---\n",
    "%TAG ! a\n",
    "|\n",
    "[]",
    "- - - - a\n",
    "{a: ",
    "a\x85",
    "{} ",
)
HOSTILE = [filled(unit) for unit in UNITS]
HOSTILE += [
    filled("a: ,", "[", "]"),
    filled("[],", "a: [", "]"),
    filled("a ", '"'),
    filled(" \n", "a: |\n"),
    filled("\\\n", 'a: "', '"'),
    filled("?,", "[", "]"),
    filled("\u0316\u0300", "a: x")[:500_000],
    "".join(" " * i + "a:\n" for i in range(1300)),
    "".join(f"k{i}: {ACCENTS}\n" for i in range(2000)),
]


@pytest.mark.few(8)
@pytest.mark.parametrize("number", range(len(HOSTILE)))
def test_hostile_files_take_a_bounded_time(number):
    with at_most(20_000_000):
        try:
            assert isinstance(parse_yaml(HOSTILE[number], "s"), SourceTable)
        except SceneError as error:
            assert str(error)


def test_a_file_of_too_many_words_is_refused_by_their_count_not_by_a_clock():
    with pytest.raises(SceneError, match=f"more than {source.MAX_YAML_PARTS}"):
        parse_yaml(filled("1,", "a: [", "]"), "s")
