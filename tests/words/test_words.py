"""Floor 2: one table of words, and every refusal told from it in both languages with the same names and numbers."""

import ast
import json
import re
from functools import cache
from pathlib import Path

import pytest

from planes import cli, words
from planes.scene import loads
from planes.scene.expressions import evaluate_expression
from planes.scene.ranges import read_range
from planes.scene.source import parse_yaml
from planes.scene.vector_equations import read_equation
from planes.solving import solve
from planes.words import Phrase, say, sentence_table
from planes.words.errors import PlanesError, PlanFailure, SceneError
from planes.words.lettering import with_index_markup
from planes.words.units import read_mu
from tests.helpers import ROOT
from tests.helpers.scene_texts import SIX_LINK, VECTORS, changed
from tests.scene import test_expressions, test_source
from tests.scene.test_scene_refusals import BAD, BAD_VECTORS
from tests.words import test_units

FOLDERS = {
    lang: Path(words.__file__).parent / lang
    for lang in words.available_languages()
    if len(words.fallback_languages(lang)) == 1
}
TABLE = {key: (sentence_table("ru")[key], sentence_table("en")[key]) for key in sentence_table("en")}
HOUSES = [Path(words.__file__).parents[1], Path(words.__file__).parents[2] / "render"]
SOURCES = [p for house in HOUSES for p in house.rglob("*.py") if not p.name.startswith("words")]


TELLING = (ast.Call, ast.Constant, ast.ImportFrom, ast.JoinedStr)


@cache
def nodes() -> dict[str, list[ast.AST]]:
    """What may name a key in the sources of the house, walked once for all tests."""
    trees = {str(p): ast.parse(p.read_text(encoding="utf-8")) for p in SOURCES}
    return {file: [node for node in ast.walk(tree) if isinstance(node, TELLING)] for file, tree in trees.items()}


TELLERS = ("Phrase", "say", "PlanFailure", "_help", "help_of")
REFUSALS = (
    "PlanesError",
    "SceneError",
    "StructureError",
    "EquationError",
    "ExpressionError",
    "UnitError",
    "ProgramError",
)

FOUR_BAR = """\
planes: 1
frame: {points: {A: [0, 0], D: [0.4, 0]}, guides: {g: {y: 0}}}
links:
  1: {points: {A: 0, B: 0.1}}
  2: {points: {B: 0, C: 0.3}}
  3: {points: {D: 0, C: 0.3}}
assembly: {C: left}
drive: {link: 1, phi: 60, omega: 10}
"""
TRIANGLE = """\
planes: 1
frame: {points: {A: [0, 0], E: [1, 0], F: [2, 0]}}
links:
  1: {points: {A: 0, B: 0.1}}
  2: {points: {B: 0, P: 1}}
  3: {points: {P: 0, Q: 0.3, R: [0.1, 1]}}
  4: {points: {Q: 0, E: 1}}
  5: {points: {R: 0, F: 1}}
drive: {link: 1, phi: 60}
"""
BAD_MECHANISMS = [
    (FOUR_BAR, "assembly: {C: left}\n", "", "двумя способами"),
    (FOUR_BAR, "left", "ahead", "группе RRR"),
    (FOUR_BAR, "D: 0, C", "D: 0, E", "не хватает звена или пары"),
    (FOUR_BAR, "D: 0, C", "D: 0, A: 1, C", "лишних связей 2: проверьте имена"),
    (FOUR_BAR, "link: 1", "link: 2", "шарнир на стойке, а со стойкой его соединяют: нет"),
    (TRIANGLE, "phi: 60", "phi: 0", "III класса"),
    (FOUR_BAR, "left}", "{near: [1, 1]}}", "сборку не найти"),
    (FOUR_BAR, "drive:", "find: [v_Q]\ndrive:", "нет величины v_Q"),
]
BAD_EQUATIONS = ["a", "a = a", "0 = 0", "a = ", "a b = c", " - = c", "v_C = v_CB + v_B", "v_C = v_CB"]
BAD_PLANS_OF_VECTORS = [
    ("a: , b: , c: ", "a = b + c", "неизвестные: величина a, направление a"),
    ("a: {value: 1, direction: 2}, b: {value: 1, direction: 3}", "a = b", "не замыкается"),
    ("a: , b: ", "a = b + cc", "нет вектора cc; допустимо: a, b"),
    ("a: {value: 1, direction: 0}, b: {value: 2}, c: {value: 2}", "a = b + c", "near: 75.52 или near: -75.52"),
    (
        "a: {value: 1, direction: 0}, b: {value: 3}, c: {value: 1}",
        "a = b + c",
        "один из векторов b и c длиннее, чем нужно, на 1",
    ),
]


def places(template):
    """Names a template asks for, each as often as it does."""
    return sorted(name for _, name, _, _ in words._Teller("en").parse(template) if name is not None)


def test_no_key_stands_in_two_tables():
    for lang, folder in FOLDERS.items():
        pairs = [
            pair for file in folder.iterdir() for pair in json.loads(file.read_text("utf-8"), object_pairs_hook=list)
        ]
        assert len(pairs) == len(dict(pairs)) == len(sentence_table(lang)) > 1000


def test_the_files_of_all_languages_hold_the_same_keys_in_one_order():
    ru, en = ({f.name: list(json.loads(f.read_text("utf-8"))) for f in folder.iterdir()} for folder in FOLDERS.values())
    assert ru == en


def test_both_languages_hold_the_same_names_and_numbers():
    for key, (russian, english) in (
        (k, both) for k, both in TABLE.items() if k not in sentence_table("en", "language")
    ):
        assert russian and english and "|" not in english and russian.count("|") <= 1, key
        for form in russian.split("|"):
            assert set(places(form)) == set(places(english)), key


def keys_told():
    """Keys that the program tells, as patterns: from constants, "a" if … else "b", and f"kind_{…}"."""
    for file, own in nodes().items():
        ours = {
            name.asname or name.name
            for node in own
            if isinstance(node, ast.ImportFrom) and node.module in ("planes.words", "planes.words.errors")
            for name in node.names
        }
        for node in own:
            name = node.func.id if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) else ""
            fault = isinstance(node, ast.Call) and getattr(node.func, "attr", "") == "fault"  # of a reader
            if fault or (name in TELLERS and (name in ours or name == "_help") and node.args):
                yield from ((file, pattern) for pattern in patterns(node.args[0]))


def patterns(node):
    match node:
        case ast.Constant():
            yield re.escape(node.value)
        case ast.IfExp():
            yield from (*patterns(node.body), *patterns(node.orelse))
        case ast.JoinedStr():
            yield "".join(re.escape(p.value) if isinstance(p, ast.Constant) else "[A-Za-z0-9_]+" for p in node.values)


@pytest.mark.slow
def test_every_key_that_is_told_is_in_the_table():
    told = list(keys_told())
    assert len(told) > 150
    plain = set(map(re.escape, TABLE))
    made = {one for _, one in told} - plain
    unknown = {one for one in made if not any(map(re.compile(one).fullmatch, TABLE))}
    assert not [(file, one) for file, one in told if one in unknown]


def report_keys():
    """Keys that the report of a crank-slider tells: a line begins with its key, after its marks."""
    lines = (HOUSES[0] / "crank_slider" / "report.txt").read_text("utf-8").splitlines()
    return {found[1] for line in lines if (found := re.match(r"(?:\?\S+ )?(?:[#!]+ )?([a-z]\w*)", line))} | {
        f"sub_{key}" for line in lines for key in re.findall(r"§(\w+)§", line)
    }


def test_every_key_of_the_report_is_in_the_table():
    assert len(report_keys()) > 80 and report_keys() <= TABLE.keys()


@pytest.mark.slow
def test_no_key_is_left_over():
    said = report_keys() | {
        n.value for own in nodes().values() for n in own if isinstance(n, ast.Constant) and isinstance(n.value, str)
    }
    made = {
        one
        for own in nodes().values()
        for n in own
        if isinstance(n, ast.JoinedStr)
        for one in patterns(n)
        if re.match("[a-z_]+_\\[", one)
    }
    begun = {
        f"{n.args[0].value}.*"
        for own in nodes().values()
        for n in own
        if isinstance(n, ast.Call) and getattr(n.func, "id", "") == "sentences_with_prefix"
    }
    known = re.compile("|".join({*made, *begun, "usage_.*", "[Mkmµ](N|N·m|W)"}))  # prefixes of units
    said |= {line.rpartition(" = ")[2] for text in said for line in text.splitlines()}  # keys in a table of text
    left = [key for key in TABLE if key not in said and not known.fullmatch(key)]
    assert not [key for key in left if key.removesuffix("_in_python") not in said]


@pytest.mark.slow
def test_refusals_are_told_from_the_table():
    """No sentence is put together where it is raised."""
    for file, own in nodes().items():
        for node in own:
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") in REFUSALS and node.args:
                assert not isinstance(node.args[0], ast.Constant | ast.JoinedStr | ast.BinOp), (file, node.lineno)


def leaves(phrase):
    """Names and numbers of a phrase that its sentence asks for."""
    for name in places(TABLE[phrase.key][1]):
        value = phrase.parts[name]
        for one in value if isinstance(value, tuple) else (value,):
            yield from leaves(one) if isinstance(one, Phrase) else ([one] if isinstance(one, str) else [])


def check_both(error):
    russian, english = error.told("ru"), error.told("en")
    assert str(error) == english == error.told()
    assert re.search("[а-яё]", russian.removeprefix(error.place)) and "\n" not in russian and len(russian) < 600
    assert russian.startswith(error.place) and english.startswith(error.place)
    assert sorted(re.findall(r"\d+", russian)) == sorted(re.findall(r"\d+", english))
    for leaf in leaves(error.phrase):
        assert leaf in russian and leaf in english
    latin = re.compile(r"[A-Za-z_]{2,}")
    assert set(latin.findall(russian)) <= {*latin.findall(english), "III"}
    return russian


def refused(ask, *given):
    with pytest.raises(PlanesError) as caught:
        ask(*given)
    return check_both(caught.value)


@pytest.mark.parametrize(
    ("text", "old", "new", "line"),
    [
        *((SIX_LINK, old, new, line) for old, new, _, line in BAD),
        *((VECTORS, old, new, line) for old, new, _, line in BAD_VECTORS),
    ],
)
def test_a_bad_scene_in_both_languages(text, old, new, line):
    told = refused(loads, changed(old, new, text), "s.yaml")
    assert re.match(f"s.yaml:{line or ''}", told) and re.match(r"s\.yaml:\d+: \S", told)


@pytest.mark.parametrize("text", [text for text, _, line in test_source.BAD if line])
def test_a_bad_file_in_both_languages(text):
    assert re.match(r"s\.yaml:\d+: \S", refused(parse_yaml, text, "s.yaml"))


@pytest.mark.parametrize("text", [text for text, _ in test_expressions.BAD])
def test_a_bad_expression_in_both_languages(text):
    refused(evaluate_expression, text, test_expressions.NAMES)


@pytest.mark.parametrize(("text", "plan"), [(text, plan) for text, plan, _ in test_units.BAD])
def test_a_bad_scale_in_both_languages(text, plan):
    with pytest.raises(PlanesError) as caught:
        read_mu(text, plan)
    assert text[:40] in caught.value.told("ru") or plan in caught.value.told("ru")


@pytest.mark.parametrize(("text", "old", "new", "words"), BAD_MECHANISMS)
def test_a_bad_mechanism_in_both_languages(text, old, new, words):
    if "near" in new:
        text = text.replace("C: 0.3", "C: 0.03")
    told = refused(lambda: solve(loads(changed(old, new, text), "s.yaml")))
    assert re.search(words, told) and re.match(r"s\.yaml:\d+: ", told)


@pytest.mark.parametrize("text", BAD_EQUATIONS)
def test_a_bad_equation_in_both_languages(text):
    assert refused(read_equation, text, float, 1).startswith(f"{text}: ")


@pytest.mark.parametrize(("vectors", "equation", "words"), BAD_PLANS_OF_VECTORS)
def test_bad_vectors_in_both_languages(vectors, equation, words):
    text = f"planes: 1\nvectors: {{{vectors}}}\nequations: [{equation}]\n"
    told = refused(lambda: solve(loads(text, "s.yaml")))
    assert words in told and re.match(r"s\.yaml:\d+: ", told)


@pytest.mark.parametrize("text", ["a", "1:2", "1:2:-1", "0:1e9:1e-3"])
def test_a_bad_range_in_both_languages(text):
    assert refused(read_range, text).startswith(f"--phi {text!r}")


def test_parts_are_told_in_their_form():
    link = Phrase("link", name="2")
    mass = Phrase("part", key="mass", what=link)
    assert Phrase("no_value", what=link).told("ru") == "звено 2: нет значения"
    assert Phrase("no_value", what=mass).told("ru") == "mass звена 2: нет значения"
    assert str(Phrase("no_value", what=mass)) == "mass of link 2 has no value"
    assert say("negative", "ru", what=Phrase("part", key="r", what=mass), value=-0.5).startswith("r в mass звена 2: ")


def test_every_error_tells_itself():
    failure = PlanFailure("no_digits", makes="c")
    assert (failure.told("ru"), str(failure)) == ("в c не осталось верных цифр", "no correct digit is left in c")
    placed = SceneError(failure.phrase, "s.yaml", 3)
    assert placed.told("ru") == "s.yaml:3: в c не осталось верных цифр"
    assert str(placed.phrase) == str(failure) and str(placed) == f"s.yaml:3: {failure}"
    assert PlanesError("as it is").told("ru") == "as it is"


@pytest.mark.parametrize(
    ("home", "lang", "words"),
    [
        ("uk_UA.UTF-8", [], "такого файла немає"),
        ("C", [], "there is no such file"),
        ("C", ["--lang", "ru"], "такого файла нет"),
        ("be_BY", ["--lang", "en"], "there is no such file"),
    ],
)
def test_the_command_refuses_in_the_language_asked(monkeypatch, capsys, home, lang, words):
    monkeypatch.setenv("LC_ALL", home)
    assert cli.main(["solve", "no.yaml", *lang]) == 2
    assert capsys.readouterr().err == f"no.yaml: {words}\n"


@pytest.mark.parametrize(
    ("home", "given", "words"),
    [
        ("ru_RU", ["--help"], "планы"),
        ("C", ["--help"], "usage: planes"),
        ("ru_RU", ["solve"], "не указано: SCENE"),
        ("C", ["solve"], "required: SCENE"),
        ("ru_RU", ["sovle"], "не подходит 'sovle'"),
    ],
)
def test_the_command_line_speaks_the_home_language(monkeypatch, capsys, home, given, words):
    monkeypatch.setenv("LC_ALL", home)
    with pytest.raises(SystemExit):
        cli.main(given)
    told = capsys.readouterr()
    assert words in (told.out + told.err).replace("Планы", "планы")


def test_names_in_a_sentence_have_indices_and_other_words_have_not() -> None:
    told = with_index_markup("crank_slider: v_H, F21^t, phi_1, l_AB, omega_2, my_long_word")
    assert told == "crank_slider: v_{H}, F21^{t}, φ_{1}, l_{AB}, ω_{2}, my_long_word"


@pytest.mark.parametrize(("lang", "sign"), [("en", "."), ("ru", ","), ("uk", ","), ("be", ",")])
def test_numbers_of_a_message_have_the_decimal_sign_of_its_language(
    lang: str, sign: str, capsys: pytest.CaptureFixture[str]
) -> None:
    """Of a failed position and the nearest that works, and of the places of two assemblies."""
    file = ROOT / "samples" / "six-link.yaml"
    assert cli.main(["solve", str(file), "--phi", "90.5", "--lang", lang]) == 2
    said = capsys.readouterr().err
    assert re.findall(r"[0-9]([.,])[0-9]", said.partition("six-link.yaml")[2]) == [sign] * 4
    text = file.read_text("utf-8").replace("assembly: {C: right}", "assembly: {}")
    with pytest.raises(PlanesError) as refused:
        solve(loads(text))
    told = refused.value.told(lang)
    assert set(re.findall(r"[0-9]([.,])[0-9]", told)) == {sign}


def test_no_remedy_asks_an_index_for_this_project() -> None:
    """It is on none: what a bare name there brings is somebody else's package."""
    told = [*ROOT.glob("planes/words/*/*.json"), *ROOT.glob("docs/site/*/*.md"), *ROOT.glob("README*.md")]
    asked = re.compile(r"pip install (-U )?['\"]?planes\b")
    assert len(told) > 100 and not [file for file in told if asked.search(file.read_text("utf-8"))]
