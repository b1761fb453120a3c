"""The questions of a defence: each is answered from its scene, by numbers that ``planes solve`` gives."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from planes.cli import main
from planes.documents.lesson import position_questions, questions_as_text
from planes.lesson.questions import QUESTIONS_BY_CHAPTER, Questions
from planes.scene import load, loads
from planes.solving.document import Block, Chart, DocumentTable, Figure, Formula, Heading, Paragraph
from planes.words import available_languages, sentence_table
from planes.words.errors import PlanesError
from tests.helpers import ROOT

SAMPLES = ROOT / "samples"
SCENES = ["six-link", "shaper", "crank-slider", "kind-1-rrr", "kind-5-rpp", "sliding-driver", "friction-circles"]
KEYS = [key for keys in QUESTIONS_BY_CHAPTER.values() for key in keys.split()]
NUMBER = re.compile(r"[−-]?\d+(?:[.,]\d+)?(?:·10(?:\^\{?[−-]?\d+\}?|[⁻⁰¹²³⁴-⁹]+))?")
RAISED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")


def asked(name: str, lang: str = "en") -> Questions:
    return position_questions(load(str(SAMPLES / f"{name}.yaml")), None, lang)


def answers(blocks: list[Block]) -> Iterator[tuple[str, list[Block]]]:
    """Every question with the blocks of its answer."""
    starts = [k for k, b in enumerate(blocks) if isinstance(b, Heading) and b.level == 2]
    for start, end in zip(starts, [*starts[1:], len(blocks)], strict=True):
        yield blocks[start].text, [b for b in blocks[start + 1 : end] if not isinstance(b, Heading)]  # type: ignore[union-attr]


def leaves(thing: Any) -> Iterator[float]:
    """All numbers of JSON data, and those in its texts."""
    if isinstance(thing, dict | list | tuple):
        for one in thing.values() if isinstance(thing, dict) else thing:
            yield from leaves(one)
    elif isinstance(thing, int | float):
        yield float(thing)
    elif isinstance(thing, complex):
        yield from (thing.real, thing.imag, abs(thing), math.degrees(math.atan2(thing.imag, thing.real)))
    elif isinstance(thing, str):
        yield from map(read, NUMBER.findall(thing))


def read(text: str) -> float:
    """A number as printed."""
    size, _, power = text.replace("−", "-").replace(",", ".").partition("·10")
    return float(size) * 10.0 ** int(power.strip("^{}").translate(RAISED) or 0)


def printed(blocks: list[Block]) -> Iterator[str]:
    """What is told with numbers: sentences without names and indices, lines of calculation, cells."""
    for b in blocks:
        texts = [b.text] if isinstance(b, Paragraph) else [b.tex_source] if isinstance(b, Formula) else []
        texts += [cell for row in b.rows[1:] for cell in row[1:]] if isinstance(b, DocumentTable) else []
        for text in texts:
            yield re.sub(r"⟨[^⟩]*⟩|[_^]\{[^{}]*\}|[A-Za-zΦ_]+\d\w*|\\\w+", " ", text)


def known(q: Questions) -> list[float]:
    """Numbers of the JSON of ``solve``, of the structure, of the drawing in SI and on paper, and of the whole cycle."""
    p, drawing = q.position, q.position.drawing
    found = [*leaves(p.results), *leaves(p.plans.structure.json()), *leaves(dict(p.scales)), *map(float, range(60))]
    si = [x for x in leaves(dict(drawing.things)) if math.isfinite(x)]
    found += si + [x * mu for x in si for mu in p.scales.values()]
    found += [x for row in q.cycle_summary.extremes_by_curve.values() for e in row for x in (e.place, e.value)]
    stroke = q.cycle_summary.driven_stroke
    found += [x for x in (stroke.swing, stroke.forth, stroke.back, stroke.time_ratio) if x] if stroke else []
    found += [x.number for x in p.of("transfers").values()]
    found += [complex(f.vector).real for f in p.found if len(f.numbers) > 1] + [
        abs(f.vector) for f in p.found if len(f.numbers) > 1
    ]
    found += [math.degrees(math.atan2(f.vector.imag, f.vector.real)) for f in p.found if len(f.numbers) > 1]
    found += [x for f in q.scene.mechanism.friction.values() for x in (f,)] if q.scene.mechanism else []
    return [abs(x) for x in found if math.isfinite(x)]


def is_in(number: float, text: str, every: list[float]) -> bool:
    """Whether a printed number is one of those, rounded as it is printed."""
    digits = len(re.sub(r"·10.*", "", text).partition("." if "." in text else ",")[2])
    power = number / read(re.sub(r"·10.*", "", text)) if number else 1.0
    half = 0.5000001 * 10.0**-digits * power
    return any(abs(abs(number) - x) <= half + 6e-4 * abs(number) * (digits == 0) for x in every)


@pytest.mark.parametrize("name", SCENES)
def test_every_number_is_one_of_the_results(name: str) -> None:
    q = asked(name)
    blocks, every = q.document_blocks(), known(q)
    told = 0
    for question, answer in answers(blocks):
        for text in printed(answer):
            for one in NUMBER.findall(text):
                told += 1
                assert is_in(read(one), one, every), (question, one, text)
    assert told > 60


@pytest.mark.parametrize("name", ["class-three/rods", pytest.param("class-three/truss", marks=pytest.mark.slow)])
def test_a_first_group_of_leads_has_no_kind_to_tell(name: str) -> None:
    """Its extreme positions are told as of any mechanism."""
    assert len(dict(answers(asked(name).document_blocks()))) == len(KEYS)


@pytest.mark.few(2)
@pytest.mark.parametrize("name", SCENES)
def test_no_question_is_left_without_an_answer(name: str) -> None:
    for lang in available_languages():
        replies = dict(answers(asked(name, lang).document_blocks()))
        assert len(replies) == len(KEYS) == 29
        for question, answer in replies.items():
            assert question and answer and all(b.text.strip() for b in answer if isinstance(b, Paragraph)), question
            assert not any(
                "{" in b.text and "_{" not in b.text and "^{" not in b.text for b in answer if isinstance(b, Paragraph)
            )


def test_the_words_are_there_in_every_language() -> None:
    """None is borrowed from another language, and none is left in a wrong alphabet."""
    keys = list(sentence_table("en", "questions"))
    for lang in available_languages():
        own = json.loads((ROOT / "planes" / "words" / lang / "questions.json").read_text("utf-8"))
        assert list(own) == keys
        assert all(bool(re.search("[а-яіїєў]", own[k])) == (lang != "en") for k in keys), lang
        assert not any(set("ыэъё") & set(own[k].lower()) for k in keys) or lang != "uk"
        assert not any(set("ищъ") & set(own[k].lower()) for k in keys) or lang != "be"
    assert all({f"question_{k}", f"reply_{k}"} <= {*keys} for k in KEYS)


SAID = {
    "six-link": {
        "link": "connecting rod with a guide",
        "mobility": "W = 6n − 5p_{1} = 6·5 − 5·7 = −5",
        "groups": "order is 2, by the number of outer pairs: ⟨CL⟩ (2–4), ⟨y-y⟩ (6–5)",
        "coriolis": "Link 4 slides along ⟨CL⟩, which turns with link 2: it arises here.",
        "stages": "4;5 → 2;3; last comes the driver 1",
    },
    "shaper": {"extremes": "perpendicular to it", "link": "slotted lever", "graph": "⟨", "coriolis": "x-x"},
    "kind-1-rrr": {"coriolis": "all pairs are revolute", "size_k": "nothing has to be reckoned", "link": "rocker"},
    "crank-slider": {"reactions": "Friction is counted here in: x-x", "coriolis": "of link 0, which does not turn"},
    "bntu-1": {"normal": "the driver is at rest"},
}


@pytest.mark.parametrize("name", SAID)
def test_what_is_answered_is_of_this_mechanism(name: str) -> None:
    q = asked(name)
    replies = dict(zip(KEYS, (answer for _, answer in answers(q.document_blocks())), strict=True))
    for key, words in SAID[name].items():
        texts = [b.text for b in replies[key] if isinstance(b, Paragraph)]
        texts += [cell for b in replies[key] if isinstance(b, DocumentTable) for row in b.rows for cell in row]
        charts = [b for b in replies[key] if isinstance(b, Figure) and isinstance(b.of, Chart)]
        assert charts if key == "graph" else any(words in text for text in texts), (key, texts)


def test_a_mechanism_without_loads_says_why_no_forces_are_found() -> None:
    text = (SAMPLES / "kind-1-rrr.yaml").read_text("utf-8")
    bare = re.sub(r", (mass|inertia): [\d.]+", "", text.partition("loads:")[0]).replace("gravity", "#")
    replies = [*answers(position_questions(loads(bare), None, "en").document_blocks())]
    assert all("no masses and no loads" in answer[-1].text for _, answer in replies[20:])  # type: ignore[union-attr]


@pytest.mark.few(1)
@pytest.mark.parametrize("suffix", [".html", ".pdf", ".docx"])
def test_each_format_is_written(suffix: str, tmp_path: Path) -> None:
    if suffix == ".docx":
        pytest.importorskip("docx")
        pytest.importorskip("mathml2omml")
    out = tmp_path / f"q{suffix}"
    assert main(["questions", str(SAMPLES / "shaper.yaml"), "-o", str(out), "--lang", "uk"]) == 0
    head = out.read_bytes()
    assert head.startswith({".html": b"<!", ".pdf": b"%PDF", ".docx": b"PK"}[suffix]) and len(head) > 50_000


def test_as_text(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["questions", str(SAMPLES / "six-link.yaml"), "--lang", "be"]) == 0
    told = capsys.readouterr().out
    assert "29. Як вядуць" in told and "якая круціцца са звяном 2" in told and "⟨" not in told


@pytest.mark.parametrize(
    ("given", "said"),
    [
        (["vectors.yaml"], "has no mechanism, and the questions are about one"),
        (["statics/beam.yaml"], "has no mechanism, and the questions are about one"),
        (["six-link.yaml", "-o", "q.odt"], "is written as .html, .pdf or .docx"),
        (["six-link.yaml", "--phi", "0:90:45"], "for one position"),
        (["six-link.yaml", "--phi", "90"], "at φ = 90°"),
    ],
)
def test_what_is_refused(
    given: list[str], said: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["questions", str(SAMPLES / given[0]), *given[1:], "--lang", "en"]) == 2
    told = capsys.readouterr()
    assert said in told.err and told.err.count("\n") == 1 and not told.out and not list(tmp_path.iterdir())


def test_what_is_asked_for_elsewhere_does_not_shorten_the_answers() -> None:
    text = (SAMPLES / "kind-1-rrr.yaml").read_text("utf-8")
    assert questions_as_text(position_questions(loads(text + "\nfind: [v_C]\n"), None, "en")) == questions_as_text(
        position_questions(loads(text), None, "en")
    )


def test_a_scene_without_a_mechanism_is_refused_in_python() -> None:
    with pytest.raises(PlanesError, match="has no mechanism"):
        position_questions(load(str(SAMPLES / "vectors.yaml")), None, "en")
