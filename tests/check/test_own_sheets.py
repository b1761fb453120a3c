"""Sheets written by this program, given to its own check: right ones are right, with a step spoiled they are wrong."""

from __future__ import annotations

import random
import re
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy
import pytest

from planes.check.grading.handwork import Hand
from planes.check.grading.paper import Known
from planes.check.grading.prepared_plan import Asked, known_plans, mistake_variants, prepare
from planes.check.grading.variants import Variant
from planes.check.handed_in import read_paper
from planes.check.outcome import Outcome, check
from planes.check.reading.arrowheads import assign_arrowheads
from planes.check.reading.dxf import read_dxf
from planes.check.reading.parts import connected_parts, merge_word_pieces, remove_letter_strokes
from planes.check.reading.pdf import read_pdf
from planes.check.reading.strokes import Arrowhead, ReadDrawing
from planes.check.reading.svg import read_embedded_svg, read_svg
from planes.check.reading.whole_page import detail_enlargement, read_page
from planes.check.reading.written import Words
from planes.cli import main
from planes.documents.drawn import _mechanism_views
from planes.documents.sheets import DrawnPosition
from planes.drafting.skill import STUDENT_SKILL
from planes.scene import Scene, load
from planes.solving import Position
from render.files import dxf
from render.paper.marks import Arrow, Text
from render.sheet import Sheet
from render.sheet.composer import Composer
from render.sheet.single import Page, view_page
from render.sheet.sizes import Sizes
from tests.helpers import ROOT

SAMPLES = ROOT / "samples"
READERS = {".svg": read_svg, ".dxf": read_dxf, ".pdf": read_pdf, ".png": read_embedded_svg}
SCENES = sorted(p.stem for p in SAMPLES.glob("*.yaml") if p.stem != "vectors")
ASSIGNMENTS = sorted(f"assignments/{p.stem}" for p in (SAMPLES / "assignments").glob("*.yaml"))
FAR_MM = 5.0  # a mistake that moves its mark by less is no mistake worth drawing


@cache
def drawn(sample: str) -> tuple[Scene, Position]:
    """A sample's position as a sheet of one view draws it."""
    scene = load(str(SAMPLES / f"{sample}.yaml"))
    return scene, DrawnPosition(replace(scene, find=None), None, "ru").position_at_sizes(Sizes())


def view(sample: str, plan: str, position: Position) -> Page:
    """The page of one plan of a position."""
    scene = drawn(sample)[0]
    kind, _, links = plan.partition(":")
    name = f"force-{links}" if links else plan if plan == "position" else f"{kind}-plan"
    composer = Composer(scene, "ru")
    return view_page(_mechanism_views(replace(scene, find=None), position, composer), name, composer)


def checked(sample: str, plan: str, written: Page | Sheet, file: Path) -> Outcome:
    """What the check says of a page written into a file."""
    scene = drawn(sample)[0]
    file.write_bytes(written.file_contents(file.suffix))
    sketch = READERS[file.suffix](file)
    assert sketch
    asked = Asked(scene, plan)
    return check(asked, read_page(sketch, prepare(asked)))


def made(sample: str, plan: str, position: Position, k: int) -> tuple[Position, Variant, float]:
    """A position with a mistake of the catalogue made in the plan, and all that follows; how far its mark moves."""
    bench = prepare(Asked(drawn(sample)[0], plan, mu=position.scales[f"mu_{plan}"]))
    hand = Hand(bench.program, {**bench.given, **position.scales}, STUDENT_SKILL, {})
    variant = mistake_variants(bench, {}, bench.said_mu)[k]
    under = {n: numpy.ravel(v)[0].item() for n, v in hand.redraw_with_variant(variant).items() if v is not None}
    moved = [abs(under[m] - position.drawing[m]) for m in bench.marks if m in under and m.label == variant.blames]
    fits = all(abs(under[m]) < 400 for m in bench.marks if m in under)
    things = {**position.drawing.things, **{n: v for n, v in under.items() if n in position.drawing}}
    wrong = replace(position, drawing=replace(position.drawing, things=things))
    return wrong, variant, moved[0] if moved and fits else 0.0


def mistakes(sample: str, plan: str) -> list[Variant]:
    """The catalogue for a plan of a sample."""
    bench = prepare(Asked(drawn(sample)[0], plan))
    return mistake_variants(bench, {}, bench.said_mu)


def spoiled(sample: str, plan: str, seed: int | str) -> int | None:
    """A mistake of the catalogue that moves its mark far, by its place there."""
    order = list(range(len(mistakes(sample, plan))))
    random.Random(seed).shuffle(order)
    return next((k for k in order if made(sample, plan, drawn(sample)[1], k)[2] > FAR_MM), None)


VIEWS = (
    ("kind-1-rrr", "velocity", ".svg"),
    ("six-link", "velocity", ".pdf"),
    ("kind-4-prp", "velocity", ".dxf"),
    ("kind-3-rpr", "acceleration", ".dxf"),
    ("six-link", "acceleration", ".svg"),
    ("kind-2-rrp", "position", ".svg"),
    ("six-link", "position", ".pdf"),
    ("kind-5-rpp", "position", ".dxf"),
    ("six-link", "force:2-3", ".dxf"),
    ("kind-5-rpp", "force:2-3", ".pdf"),
    ("kind-4-prp", "force:2-3", ".svg"),
    ("sliding-driver", "velocity", ".png"),
    ("kind-1-rrr", "position", ".png"),
)


@pytest.mark.few(5)
@pytest.mark.parametrize(("sample", "plan", "suffix"), VIEWS)
def test_a_view_is_right_and_with_one_step_spoiled_wrong_there(
    sample: str, plan: str, suffix: str, tmp_path: Path
) -> None:
    found = checked(sample, plan, view(sample, plan, drawn(sample)[1]), tmp_path / f"right{suffix}")
    assert found.verdict == "right", found.sentence.told("en")
    assert all(v == "right" for v in found.grading.verdicts.values()) or plan != "velocity"  # type: ignore[union-attr]
    k = spoiled(sample, plan, 1)
    assert k is not None
    wrong, variant, _ = made(sample, plan, drawn(sample)[1], k)
    found = checked(sample, plan, view(sample, plan, wrong), tmp_path / f"wrong{suffix}")
    assert (found.verdict, found.first_wrong) == ("wrong", variant.blames), found.sentence.told("en")


CROWDED = (
    ("01", "acceleration", ".svg"),
    ("33", "acceleration", ".dxf"),
    ("38", "velocity", ".pdf"),
    ("38", "position", ".svg"),
    ("42", "acceleration", ".svg"),
    ("44", "acceleration", ".pdf"),
    ("58", "velocity", ".dxf"),
    ("12", "force:4-5", ".dxf"),
    ("43", "force:2-3", ".svg"),
    ("02", "force:4-5", ".pdf"),
)


@pytest.mark.few(3)
@pytest.mark.parametrize(("number", "plan", "suffix"), CROWDED)
def test_where_marks_crowd_a_word_nearer_to_another_mark_misleads_nobody(
    number: str, plan: str, suffix: str, tmp_path: Path
) -> None:
    sample = f"assignments/{number}"
    found = checked(sample, plan, view(sample, plan, drawn(sample)[1]), tmp_path / f"view{suffix}")
    assert found.verdict == "right", found.sentence.told("en")


@pytest.mark.parametrize(("plan", "suffix"), [("velocity", ".svg"), ("acceleration", ".dxf"), ("force:1", ".pdf")])
def test_a_plan_at_another_scale_than_its_title_says_is_not_right(plan: str, suffix: str, tmp_path: Path) -> None:
    """A force plan with its only force doubled looks like one at another scale; its title tells them apart."""
    sample, file = "crank-slider", tmp_path / f"view{suffix}"
    scene, position = drawn(sample)
    file.write_bytes(view(sample, plan, position).file_contents(suffix))
    asked = Asked(scene, plan)
    found = {}
    for said in ("", "1"):  # in front of the number: another scale
        sketch = READERS[suffix](file)
        assert sketch
        sketch.words = [replace(w, text=re.sub(r"= (?=\d)", f"= {said}", w.text)) for w in sketch.words]
        found[said] = check(asked, read_page(sketch, prepare(asked)))
    assert found[""].verdict == "right" and found["1"].verdict != "right", found["1"].sentence.told("en")


REVERSED = (("30", ".svg"), ("04", ".dxf"), ("65", ".svg"), ("17", ".pdf"))


@pytest.mark.few(2)
@pytest.mark.parametrize(("number", "suffix"), REVERSED)
def test_two_forces_there_and_back_are_told_apart_by_their_words(number: str, suffix: str, tmp_path: Path) -> None:
    """The reaction on the driver carried over unreversed makes nearly the same polygon with the names exchanged."""
    sample, plan = f"assignments/{number}", "force:1"
    found = checked(sample, plan, view(sample, plan, drawn(sample)[1]), tmp_path / f"right{suffix}")
    assert found.verdict == "right", found.sentence.told("en")
    k = next(
        k for k, v in enumerate(mistakes(sample, plan)) if v.mistake == "reaction_not_reversed" and v.blames == "F_12"
    )
    found = checked(
        sample, plan, view(sample, plan, made(sample, plan, drawn(sample)[1], k)[0]), tmp_path / f"t{suffix}"
    )
    assert (found.verdict, found.first_wrong) == ("wrong", "F_12"), found.sentence.told("en")


def test_a_force_that_is_nowhere_on_its_plan_is_left_out_however_unsure_its_size(tmp_path: Path) -> None:
    sample, plan = "assignments/27", "force:1"
    k = next(k for k, v in enumerate(mistakes(sample, plan)) if (v.mistake, v.blames) == ("force_missing", "F_12"))
    wrong = made(sample, plan, drawn(sample)[1], k)[0]
    found = checked(sample, plan, view(sample, plan, wrong), tmp_path / "t.dxf")
    assert (found.first_wrong, found.mistake) == ("F_12", "force_missing"), found.sentence.told("en")


@pytest.mark.few(0, slow=25)
@pytest.mark.parametrize("sample", [*SCENES, *ASSIGNMENTS])
@pytest.mark.parametrize("suffix", READERS)
def test_every_view_of_every_sample(sample: str, suffix: str, tmp_path: Path) -> None:
    position = drawn(sample)[1]
    for plan in known_plans(position.plans):
        marks = [m for m in position.drawing.things if m.startswith(f"{plan}:")]
        if plan != "position" and all(abs(position.drawing[m]) < 1e-6 for m in marks):
            continue  # there is nothing to draw
        found = checked(sample, plan, view(sample, plan, position), tmp_path / f"t{suffix}")
        assert found.verdict == "right", (plan, found.sentence.told("en"))


def test_two_vectors_from_one_place_are_no_open_head() -> None:
    """Short shafts that spread alike from the pole, each with its own head, stay vectors."""
    shafts = [(0j, 5 + 1j), (0j, 5 - 1j)]
    heads = [Arrowhead(b + 2 * b / abs(b), b / abs(b), 4.0) for _, b in shafts]
    sketch = ReadDrawing(strokes=[*shafts, (0j, -30 + 0j)], heads=heads)
    assign_arrowheads(sketch)
    assert sketch.strokes == [(0j, heads[0].tip), (0j, heads[1].tip), (0j, -30 + 0j)] and sketch.ways == [1, 1, 0]


def test_a_shaft_that_ends_within_its_head_reaches_the_tip() -> None:
    """A construction line that begins at the tip does not take the head away."""
    sketch = ReadDrawing(strokes=[(0j, 20 + 0j), (23 + 0j, 35 + 0j)], heads=[Arrowhead(23 + 0j, 1 + 0j, 3.75)])
    assign_arrowheads(sketch)
    assert sketch.strokes[0] == (0j, 23 + 0j) and sketch.ways == [1, 0]


def test_a_label_with_indices_and_a_head_that_is_filled_and_outlined_are_read_once(tmp_path: Path) -> None:
    marks = [Arrow(10 + 10j, 50 + 10j), Arrow(90 + 10j, 50 + 10j), Text("a_{CB}^{n} = 2", 20 + 12j)]
    (tmp_path / "a.dxf").write_bytes(dxf.write(marks, (100, 100), "a"))
    sketch = read_dxf(tmp_path / "a.dxf")
    assert sketch.strokes == [(10 + 10j, 50 + 10j), (90 + 10j, 50 + 10j)] and sketch.ways == [1, 1]
    assert len(sketch.heads) == 2
    (word,) = sketch.words
    assert (word.text, abs(word.place - 20 - 12j) < 0.2) == ("aCBn = 2", True)


def test_a_straight_polyline_with_a_middle_vertex_is_one_vector() -> None:
    sketch = ReadDrawing(strokes=[(0j, 20 + 0j), (20 + 0j, 40 + 0j)], heads=[Arrowhead(40 + 0j, 1 + 0j)])
    assign_arrowheads(sketch)
    assert sketch.strokes == [(0j, 40 + 0j)]


def test_letters_drawn_in_strokes_go_and_vectors_stay() -> None:
    letter = [(1 + 1j, 2 + 4j), (2 + 4j, 3 + 1j)]
    sketch = ReadDrawing(strokes=[*letter, (-20 + 2j, 20 + 2j)], words=[Words("A", 0.5 + 0.5j, 4.0, 3.0)])
    remove_letter_strokes(sketch)
    assert sketch.strokes == [(-20 + 2j, 20 + 2j)]


def test_a_letter_and_its_indices_written_apart_are_one_name() -> None:
    pieces = [
        Words("F", 0j, 5.0, 2.3),
        Words("21", 2.4 - 1.1j, 3.5, 2.8),
        Words("t", 2.4 + 2j, 3.5, 1.2),
        Words("b", 30 + 0j, 5.0, 2.0),
        Words("′", 32.2 + 0j, 5.0, 0.6),
    ]
    assert [w.text for w in merge_word_pieces(pieces)] == ["F21t", "b′"]


def test_what_stands_apart_on_a_page_is_another_part() -> None:
    strokes = [(0j, 30 + 0j), (30 + 0j, 30 + 20j), (100 + 0j, 130 + 0j), (130 + 0j, 130 + 30j), (130 + 30j, 100 + 0j)]
    found = connected_parts(ReadDrawing(strokes=strokes, words=[Words("b", 31 + 21j)]))
    assert [len(p.strokes) for p in found] == [3, 2] and [len(p.words) for p in found] == [0, 1]


def test_a_table_is_no_drawing_and_a_small_part_is_one_where_it_is_asked_for() -> None:
    rows, columns = [(8j * k, 60 + 8j * k) for k in range(4)], [(20.0 * k + 0j, 20 * k + 24j) for k in range(4)]
    small = [(100 + 0j, 100 + 3j), (102 + 3j, 102 + 0j)]
    page = ReadDrawing(strokes=[*rows, *columns, *small])
    assert connected_parts(page) == [] and [p.strokes for p in connected_parts(page, 0.0)] == [small]


def test_a_detail_is_as_much_enlarged_as_its_sign_says() -> None:
    part = ReadDrawing(strokes=[(0j, 20j), (2 + 20j, 2 + 0j)])
    signs = [Words("Д (20:1)", -8 + 25j, 5.0, 18.0), Words("Г (5:1)", 90 + 25j, 5.0, 18.0)]
    assert (
        detail_enlargement(signs, part) == 20.0
        and detail_enlargement(signs[1:], part) == detail_enlargement([], part) == 1.0
    )


@pytest.mark.slow
@pytest.mark.parametrize("phi", ["240", "280"])
def test_the_polygon_of_a_law_is_right_in_its_own_position_alone(phi: str, tmp_path: Path) -> None:
    scene, plan, file = str(SAMPLES / "shaper.yaml"), ["--plan", "force:4-5"], str(tmp_path / "idle.svg")
    assert main(["sheet", scene, "--phi", phi, "-o", file]) == 0
    assert [main(["check", scene, file, *plan, "--phi", at]) for at in (phi, "60")] == [0, 1]


@pytest.mark.few(1)
def test_short_forces_that_are_not_seen_are_no_gap(tmp_path: Path) -> None:
    """Forces of 0.2 to 0.7 mm are hardly seen: that is no polygon that does not close; one that is far off is."""
    scene, file = str(SAMPLES / "class-three" / "press.yaml"), str(tmp_path / "own.svg")
    assert main(["sheet", scene, "--phi", "0", "--view", "force-2-3-4-5", "-o", file]) == 0
    asked = Asked(load(scene), "force:2-3-4-5", value=0.0)
    paper = read_paper(file, asked, Known())
    found = check(asked, paper)
    assert found.verdict in ("right", "right_as_seen")
    paper.spots = [replace(s, place=s.place + 8) if s.name == "F_40n" else s for s in paper.spots]
    assert check(asked, paper).mistake == "not_closed"
