"""The lesson: its frames, its numbers, its page, in both languages, against what is solved."""

from __future__ import annotations

import cmath
import json
import random
import re
from functools import cache
from pathlib import Path

import pytest

from planes import cli
from planes.documents.lesson import Lesson, note_position
from planes.drafting.drawing import draw_program
from planes.drafting.steps import LayOff
from planes.lesson import Teller, slot_value
from planes.lesson.data import lesson_data
from planes.lesson.formulas import LESSON_LANGS, fill_slots
from planes.lesson.frame import values_of_frames
from planes.lesson.note import Note
from planes.plans import plans_of
from planes.plans.measuring import DrawingReader
from planes.plans.quantities import quantities_by_name
from planes.plans.scales import plan_scales
from planes.scene import load, loads
from planes.solving import solve
from planes.solving.document import Cover, DocumentTable, Figure, Formula, Heading, Paragraph
from planes.words.errors import PlanesError, PlanFailure, SceneError
from planes.words.names import SCHEME_PLAN, VELOCITY_PLAN, PlanId, label_of, scheme_mark
from planes.words.naming import Naming
from render.page.lesson_page import whole_lesson_page
from render.paper.marks import Line
from render.report import render_document
from render.report.figures import DocumentSetter
from render.sheet.composer import Composer
from render.views.plotted import plot_position
from tests.helpers import ROOT
from tests.helpers.other_sizes import drawn_anew
from tests.helpers.page_tape import PageTape

HERE = ROOT / "samples"
SAMPLES = [p for p in sorted(HERE.glob("*.yaml")) if p.stem != "vectors"]
HIGHER = sorted(HERE.glob("class-*/*.yaml"))
DRAWN = SAMPLES + sorted((HERE / "assignments").glob("*.yaml"))
NAMES = [p.stem for p in SAMPLES]
SIX = HERE / "six-link.yaml"
LARGEST = 220_000  # bytes of a page
LARGEST_NOTE = 3_000_000
SIGNS = str.maketrans({"·": "*", "−": "-", "²": "", "³": ""})


@cache
def data(path: Path) -> dict:
    return lesson_data(load(str(path)))


@cache
def told(path: Path):
    """The teller of a sample, its frames, and its drawing."""
    scene = load(str(path))
    plans = plans_of(scene.mechanism)
    mus = plan_scales(plans, scene.mu)
    drawing = draw_program(plans.program, {**plans.given, **mus})
    teller = Teller(plans, drawing)
    return teller, teller.lesson_frames(), drawing


@pytest.mark.few(1, slow=8)
@pytest.mark.parametrize("path", SAMPLES, ids=NAMES)
def test_every_mark_of_every_frame_is_exported(path: Path) -> None:
    exported = data(path)
    assert len(exported["frames"]) > 5
    for frame in exported["frames"]:
        for mark in (*frame["makes"], *frame["uses"]):
            assert mark in exported["marks"], mark
            assert cmath.isfinite(PageTape(exported).mark(mark))
    drawn = {m for f in exported["frames"] for m in f["makes"]}
    asked = [item["what"] for item in exported["practice"] if item["kind"] == "mark"]
    assert asked and len(set(asked)) == len(asked) and set(asked) <= drawn


@pytest.mark.few(3)
@pytest.mark.parametrize("path", SAMPLES, ids=NAMES)
def test_every_frame_says_what_and_why_in_both_languages(path: Path) -> None:
    teller, frames, drawing = told(path)
    for frame in frames:
        for lang in LESSON_LANGS:
            said = fill_slots(frame.words_with_rows[lang], lambda n: float(slot_value(n, teller, drawing)), lang)
            assert "⟦" not in said and "{" not in said and said.endswith("."), said
            assert frame.why[lang].endswith("."), frame.why[lang]
            cyrillic = bool(re.search("[а-яё]", re.sub("⟨[^⟩]*⟩", "", said)))
            assert cyrillic == (lang != "en"), said
        assert set(re.findall("⟨[^⟩]*⟩", frame.words_with_rows["ru"])) == set(
            re.findall("⟨[^⟩]*⟩", frame.words_with_rows["en"])
        )


@pytest.mark.few(3)
@pytest.mark.parametrize("path", SAMPLES, ids=NAMES)
def test_every_formula_comes_to_the_value_it_states(path: Path) -> None:
    teller, frames, drawing = told(path)
    found = 0
    for frame in frames:
        said = fill_slots(frame.words_with_rows["en"], lambda n: float(slot_value(n, teller, drawing)), "en")
        for part in re.split(r"[;:] |\. ", said):
            sides = part.rstrip(".").split(" = ")
            if len(sides) < 3 or "⟨" in sides[-2] or "mm" in sides[-2]:
                continue
            stated = float(re.match(r"[−\d.]+(·10[⁻⁰-⁹¹²³]+)?", sides[-1])[0].replace("−", "-").partition("·")[0])
            size = sum(abs(float(x)) for x in re.findall(r"\d+\.?\d*", sides[-2])[:1])
            if "·10" in sides[-1] or "⁻" in sides[-2]:
                continue
            assert reckoned(sides[-2]) == pytest.approx(stated, rel=5e-3, abs=2e-3 * max(size, 1)), part
            found += 1
    assert found or path.stem.startswith("bntu")


def reckoned(text: str) -> float:
    """The number a formula with its numbers comes to."""
    text = text.replace("²", "**2").replace("³", "**3").translate(SIGNS)
    assert re.fullmatch(r"[-+*/().\d\s]*", text), text
    return float(eval(text))


@pytest.mark.few(3)
@pytest.mark.parametrize("path", SAMPLES, ids=NAMES)
def test_the_numbers_of_sentences_are_those_that_are_solved(path: Path) -> None:
    teller, frames, drawing = told(path)
    reader, known = (
        DrawingReader(teller.plans, drawing, {n: float(drawing[n]) for n in drawing.things if n.startswith("mu_")}),
        quantities_by_name(teller.plans),
    )
    compared = 0
    for name in values_of_frames(frames):
        plain = name.strip("|‖")
        quantity = known.get(plain)
        if quantity is None or quantity.group == "plans":
            continue
        answer = reader.read_quantity(quantity)
        size = answer.number if len(answer.numbers) == 1 else abs(answer.vector)
        own = float(slot_value(name, teller, drawing))
        assert (own if len(answer.numbers) == 1 else abs(own)) == pytest.approx(size, rel=1e-9, abs=1e-9), name
        compared += 1
    assert compared


CLOSE_MM = 1e-6


@pytest.mark.few(2)
@pytest.mark.parametrize("path", SAMPLES, ids=NAMES)
def test_the_tape_of_a_page_draws_what_is_solved(path: Path) -> None:
    """At any value of the drive, not at whole degrees alone; and it fails where solving does."""
    exported, scene = data(path), load(str(path))
    plans, drive = plans_of(scene.mechanism), exported["drive"]
    mus = plan_scales(plans, scene.mu)
    mus = {n: exported["home"][n] for n in mus}
    draw, drawn = random.Random(path.stem), 0
    for value in [drive["at"]] + [draw.uniform(drive["from"], drive["to"]) for _ in range(12)]:
        shown = PageTape(exported, value)
        try:
            exact = draw_program(plans.program, {**plans.given, **mus, plans.drive_given_name: value})
        except PlanFailure as failure:
            assert shown.failed and failure.phrase.told("en").split(":")[0][:20] in shown.failed["en"]
            continue
        drawn += 1
        size = max(abs(exact[m]) for m in exported["marks"] if m in exact)
        assert not shown.failed and shown.worst(exact.things) < CLOSE_MM * max(1.0, size / 1e3)
    assert drawn


@pytest.mark.few(1, slow=15)
@pytest.mark.parametrize("path", [*SAMPLES, *HIGHER], ids=[*NAMES, *(p.stem for p in HIGHER)])
def test_a_page_with_other_numbers_draws_what_is_solved_with_them(path: Path) -> None:
    """Every number a reader may change, changed at once: against the mechanism stated anew with them, and drawn."""
    exported, scene = data(path), load(str(path))
    draw, drawn = random.Random(path.stem), 0
    for _ in range(8):
        apart = 0.05 if path in HIGHER else 0.15  # whose assemblies are followed from their own lengths
        given = {}
        for k in exported["knobs"]:
            size = 60.0 if k["given"].startswith("angle_") else k["at"]
            given[k["given"]] = k["at"] + size * draw.uniform(-apart, apart)
        given |= {n: given[k["given"]] * exported["home"][n] / k["at"] for k in exported["knobs"] for n in k["tied"]}
        shown = PageTape(exported, None, given)
        try:
            numbers = {**exported["home"], **given}
            near = scene.mechanism.assembly if path in HIGHER else ()
            places = {p: shown.mark(f"position:{p}") / numbers["mu_position"] for p in near}
            exact = drawn_anew(scene.mechanism, numbers, str(path), places)
        except PlanFailure:
            assert shown.failed
            continue
        if shown.failed and path in HIGHER:
            continue  # its own series leads no further, and says so
        drawn += 1
        size = max(abs(exact[m]) for m in exported["marks"] if m in exact)
        named = {n: z for n, z in exact.things.items() if label_of(n).upper() in scene.mechanism.point_names}
        same = named if path in HIGHER else exact.things  # other leads may meet in S
        assert not shown.failed and shown.worst(same) < CLOSE_MM * max(1.0, size / 1e3)
    assert drawn > 2


def test_a_page_of_other_lengths_agrees_with_the_scene_written_so() -> None:
    """The file itself rewritten, and solved by the command's own way: φ = 163.37°, other links, another mass."""
    text = SIX.read_text("utf-8")
    for old, new in (
        ("l_AB: 0.1", "l_AB: 0.093"),
        ("slides: y-y, mass: 50", "slides: y-y, mass: 61"),
        ("S2: l_BS2", "S2: 0.66*l_BC"),
    ):
        assert old in text
        text = text.replace(old, new)
    solved = solve(loads(text, "s.yaml"), [163.37]).positions[0]
    same = lesson_data(loads(SIX.read_text("utf-8").replace("S2: l_BS2", "S2: 0.66*l_BC"), "s.yaml"))
    shown = PageTape(same, 163.37, {"l_AB": 0.093, "m_5": 61.0})
    assert shown.value("M_1") == pytest.approx(solved.results["balancing_moment"], rel=1e-11)
    for point, marks in solved.plans.points.items():
        for letter, mark in (("r", marks.position), ("v", marks.velocity), ("a", marks.acceleration)):
            mu = same["home"][f"mu_{mark.rpartition(':')[0]}"]
            assert abs(shown.mark(mark) - complex(*solved.results["points"][point][letter]) * mu) < CLOSE_MM


def test_a_failure_is_told_by_the_step_that_fails() -> None:
    assert "arcs l_BC about B and l_DC about D" in PageTape(data(SIX), 40.0).failed["en"]
    short = PageTape(data(SIX), 150.0, {"l_BC": 0.05}).failed
    assert short and "C" in short["ru"] and "⟦v¦!miss_mm_" in short["ru"]


def built(names: list[str], plan: PlanId, drawing) -> complex:
    """The place of a mark drawn by nothing but the names its sentence tells, in their order."""
    mark = {n: drawing[plan.mark(n)] for n in names if plan == "position" or not n[0].isupper()}
    spot = {n: drawing[scheme_mark(n)] for n in names if n[0].isupper()}
    if len(names) == 7:  # first, second; one, two, own; own, end
        first, second, one, two, own = names[:5]
        return mark[first] + (mark[second] - mark[first]) * (spot[own] - spot[one]) / (spot[two] - spot[one])
    start, _, _, first, second, from_, own, one, two = names  # start, start, end; first, second; from, own; one, two
    return mark[start] + (mark[second] - mark[first]) * (spot[own] - spot[from_]) / (spot[two] - spot[one])


@pytest.mark.few(3)
@pytest.mark.parametrize("path", DRAWN, ids=[p.stem for p in DRAWN])
def test_similarity_is_told_as_it_is_drawn(path: Path) -> None:
    _, frames, drawing = told(path)
    for frame in (f for f in frames if f.key in ("image", "carried_image")):
        for lang in LESSON_LANGS:
            names = re.findall("⟨([^⟩]*)⟩", frame.words_with_rows[lang])
            assert built(names, frame.plan, drawing) == pytest.approx(drawing[frame.makes[0]], abs=1e-6)
            assert set(frame.uses) <= {(frame.plan if not n[0].isupper() else SCHEME_PLAN).mark(n) for n in names}


def test_the_sheet_draws_no_triangle_where_similarity_is_carried() -> None:
    scene = load(str(HERE / "kind-3-rpr.yaml"))
    drawn = note_position(scene, None, "en")
    marks = Composer(scene, "en").plan(plot_position(drawn), VELOCITY_PLAN).marks
    sides = [m.points for m in marks if isinstance(m, Line) and (m.style, m.layer) == ("thin", "construction")]
    assert sides == [tuple(drawn.drawing[f"velocity:{k}"] for k in ends) for ends in (("b", "s2"), ("b", "e"))]


@pytest.mark.few(2)
@pytest.mark.parametrize("path", [*SAMPLES, *HIGHER], ids=lambda f: f.stem)
def test_a_page_is_whole_small_and_loads_nothing(path: Path) -> None:
    sizes = [len(whole_lesson_page(data(path), lang).encode()) for lang in LESSON_LANGS]
    assert max(sizes) < LARGEST, sizes
    for lang in LESSON_LANGS:
        text = whole_lesson_page(data(path), lang)
        assert not re.search(r'(?:src|href)\s*=\s*["\']?(?:https?:)?//', text) and f'<html lang="{lang}">' in text
        assert "{" + "css}" not in text


@pytest.mark.few(3)
@pytest.mark.parametrize("path", SAMPLES, ids=NAMES)
def test_wrong_places_of_the_practice_are_wrong_and_have_names(path: Path) -> None:
    exported = data(path)
    home = PageTape(exported)
    assert exported["slips"]
    for slip in exported["slips"]:
        assert abs(home.pair(slip["place"]) - home.mark(slip["at"])) > 0.29, slip
        sentence = exported["mistakes"][slip["m"]]
        assert len(sentence["parts"]) == len(slip["names"]) and all(slip["names"]), slip
        for lang in LESSON_LANGS:
            assert set(re.findall(r"{(\w+)}", sentence["said"][lang])) == set(sentence["parts"])


RATIOS = {"force_doubled": 2, "coriolis_half": 0.5, "mass_for_weight": 1 / 9.81} | dict.fromkeys(
    ("force_missing", "weight_missing", "normal_missing", "coriolis_missing", "reaction_along_loaded_link"), 0
)


@pytest.mark.few(3)
@pytest.mark.parametrize("path", SAMPLES, ids=NAMES)
def test_a_wrong_length_is_what_its_explanation_says(path: Path) -> None:
    exported = data(path)
    steps = told(path)[0].plans.program.steps
    starts = {step.makes: step.start for step in steps if isinstance(step, LayOff)}
    at, reach = exported["drive"]["at"], exported["drive"]["to"] - exported["drive"]["from"]
    for drive in (at, at + reach / 300):  # the tape moves with what is given
        tape = PageTape(exported, drive)
        for slip in exported["slips"]:
            mark, ratio = slip["at"], RATIOS.get(slip["m"])
            if ratio is not None and mark in starts:
                start = tape.mark(starts[mark])
                right = tape.mark(mark) - start
                assert tape.pair(slip["place"]) - start == pytest.approx(ratio * right, abs=1e-6 * abs(right) + 1e-6), (
                    slip
                )


def test_the_practice_names_the_mistakes_of_the_method() -> None:
    mistakes = {slip["m"] for slip in data(SIX)["slips"]}
    assert {
        "normal_outward",
        "relative_reversed",
        "coriolis_reversed",
        "coriolis_half",
        "omega1_reversed",
        "similarity_mirrored",
        "along_link",
        "epsilon1_ignored",
        "other_assembly",
    } <= mistakes


def test_a_load_that_holds_in_one_position_leaves_the_lesson_standing_there() -> None:
    """A force of the drive's own parameter is not known elsewhere: the page shows one position and says why."""
    text = SIX.read_text("utf-8").replace("force: 6000", "force: 40*phi_1").replace("phi: phi_1", "phi: 1*phi_1")
    exported = lesson_data(loads(text, "s.yaml"))
    drive = exported["drive"]
    assert drive["from"] == drive["to"] == drive["at"] == 150.0 and not PageTape(exported).failed
    assert "phi_1" in drive["held"]["ru"] and "valid at phi = 150 only" in drive["held"]["en"]
    same = data(SIX)
    assert [f["key"] for f in exported["frames"]] == [f["key"] for f in same["frames"]]
    assert PageTape(exported).mark("acceleration:b'") == PageTape(same).mark("acceleration:b'")


def test_a_lesson_of_a_law_turns_and_says_the_law() -> None:
    exported = data(HERE / "shaper.yaml")
    assert exported["drive"]["to"] - exported["drive"]["from"] == 360.0 and not exported["drive"]["held"]
    frame = next(f for f in exported["frames"] if f["makes"] == ("force:4-5:P_5",))
    assert "⟨P_5⟩ = table over (⟨s_5⟩−0.0744865)/0.45 (0 → 0; 0.05 → 0;" in frame["why"]["en"]
    assert [PageTape(exported, k).value("P_5") for k in (0.0, 60.0, 270.0)] == pytest.approx([0.0, 800.0, 150.0])


def test_the_lesson_of_a_machine_at_rest_has_no_empty_plans() -> None:
    plans = {f["plan"] for f in data(HERE / "bntu-3.yaml")["frames"]}
    assert "velocity" not in plans and "force:1" in plans


def test_the_command_writes_a_page(tmp_path: Path, capsys) -> None:
    target = tmp_path / "l.html"
    assert cli.main(["lesson", str(SIX), "-o", str(target), "--lang", "en"]) == 0
    assert capsys.readouterr().err.startswith(f"{target} written: ")
    assert '<html lang="en">' in target.read_text(encoding="utf-8")
    assert cli.main(["lesson", str(SIX), "-o", str(tmp_path / "l.txt"), "--lang", "en"]) == 2
    assert "a lesson is written as .html" in capsys.readouterr().err
    assert cli.main(["lesson", str(SIX), "-o", str(tmp_path / "no" / "l.html"), "--lang", "en"]) == 2
    assert "cannot be written" in capsys.readouterr().err
    assert [p.name for p in tmp_path.iterdir()] == ["l.html"]


def test_a_notebook_shows_a_lesson_in_a_frame_of_its_own() -> None:
    shown = Lesson(load(str(SIX)), "en")._repr_html_()
    assert shown.startswith("<iframe srcdoc=") and shown.count('"') == 4 and "Six-link" in shown


def test_a_lesson_whose_own_position_fails_is_refused() -> None:
    text = SIX.read_text(encoding="utf-8").replace("phi_1: 150", "phi_1: 90")
    with pytest.raises(SceneError, match=r"^s\.yaml:1: the position the lesson starts from cannot be drawn: "):
        lesson_data(loads(text, "s.yaml"))


def test_a_note_says_whose_it_is_as_the_sheet_does() -> None:
    text = (HERE / "kind-1-rrr.yaml").read_text("utf-8")
    cells = "student: Smith J., group: M-31, teacher: Jones, company: BNTU, department: TMM, date: 2026"
    for sheet, people, above in (
        ("", ("Done by: " + "_" * 24, "Checked by: " + "_" * 24), ()),
        (f"sheet: {{{cells}}}\n", ("Done by: Smith J., M-31", "Checked by: Jones"), ("BNTU", "TMM")),
    ):
        scene = loads(text + sheet, "s.yaml")
        cover = next(Note(scene, note_position(scene, None, "en"), "en").opening_blocks())
        assert isinstance(cover, Cover) and (cover.people, cover.above) == (people, above)
        assert cover.foot == ("2026" if sheet else "")


@pytest.mark.few(3)
@pytest.mark.parametrize("path", SAMPLES, ids=NAMES)
@pytest.mark.parametrize("lang", LESSON_LANGS)
def test_a_note_stands_in_the_usual_order(path: Path, lang) -> None:
    scene = load(str(path))
    blocks = Note(scene, note_position(scene, None, lang), lang).document_blocks()
    kinds = [type(b) for b in blocks]
    assert (
        isinstance(blocks[0], Cover)
        and kinds.count(Cover) == 1
        and {Cover, Heading, Paragraph, Formula, Figure, DocumentTable} == set(kinds)
    )
    formulas = [b.number for b in blocks if isinstance(b, Formula)]
    assert formulas == [str(k + 1) for k in range(len(formulas))]
    numbers = [b.number for b in blocks if isinstance(b, Paragraph) and b.number]
    assert numbers == list(range(1, len(numbers) + 1))
    captions = [re.match(r"\D+(\d+)", b.caption)[1] for b in blocks if isinstance(b, Figure) and b.caption]
    assert captions == [str(k + 1) for k in range(len(captions))]
    assert all(len(row) == len(b.rows[0]) for b in blocks if isinstance(b, DocumentTable) for row in b.rows)
    told = [b.text if isinstance(b, Paragraph) else b.tex_source for b in blocks if isinstance(b, Paragraph | Formula)]
    assert not any("⟦" in text or "⟪" in text or "nan" in text for text in told)


@pytest.mark.few(1)
@pytest.mark.parametrize("suffix", [".html", ".pdf", ".docx"])
def test_the_command_writes_a_note(tmp_path: Path, suffix: str) -> None:
    if suffix == ".docx":
        pytest.importorskip("docx", reason="python-docx is not installed")
    target = tmp_path / f"note{suffix}"
    assert cli.main(["note", str(SIX), "-o", str(target), "--lang", "ru"]) == 0
    found = target.read_bytes()
    assert (
        found.startswith({".html": b"<!doctype", ".pdf": b"%PDF", ".docx": b"PK"}[suffix]) and len(found) < LARGEST_NOTE
    )
    if suffix != ".docx":
        cli.main(["note", str(SIX), "-o", str(target), "--lang", "ru"])
        assert target.read_bytes() == found


@pytest.mark.slow
def test_a_word_note_lowers_and_raises_its_indices(tmp_path: Path) -> None:
    docx = pytest.importorskip("docx", reason="python-docx is not installed")
    target = tmp_path / "note.docx"
    assert cli.main(["note", str(SIX), "-o", str(target), "--lang", "en"]) == 0
    paper = docx.Document(str(target))
    cells = [c for t in paper.tables for row in t.rows for c in row.cells]
    runs = [r for p in [*paper.paragraphs, *(p for c in cells for p in c.paragraphs)] for r in p.runs]
    lowered, raised = ({r.text for r in runs if getattr(r.font, key)} for key in ("subscript", "superscript"))
    assert {"CB", "AB", "21"} <= lowered and {"t", "n"} <= raised


def test_a_note_is_refused_in_a_sentence(tmp_path: Path, capsys) -> None:
    assert cli.main(["note", str(SIX), "-o", str(tmp_path / "n.odt"), "--lang", "ru"]) == 2
    assert "записка пишется" in capsys.readouterr().err
    assert cli.main(["note", str(SIX), "--phi", "90", "-o", str(tmp_path / "n.html"), "--lang", "en"]) == 2
    assert "φ = 90°" in capsys.readouterr().err
    with pytest.raises(PlanesError, match="one position, but 3"):
        note_position(load(str(SIX)), [150.0, 160.0, 170.0], "en")
    assert not list(tmp_path.iterdir())


def test_the_note_has_every_figure_it_speaks_of() -> None:
    scene = load(str(SIX))
    drawn = note_position(scene, None, "en")
    blocks, naming = Note(scene, drawn, "en").document_blocks(), Composer(scene, "en").naming
    keys = [b.of.views[0][0] for b in blocks if isinstance(b, Figure)]
    assert all(DocumentSetter(Naming("en")).shown(b)[0] for b in blocks if isinstance(b, Figure))
    assert "scheme" in keys and "force:2-3" in keys
    text = render_document(blocks, ".html", naming).decode()
    assert text.count("<svg") == len(keys) and "<i>v</i><i><sub>CB</sub></i>" in text
    assert json.dumps(text) and scheme_mark("C") not in text


def test_numbers_that_are_nothing_are_offered_as_far_as_others_of_their_kind() -> None:
    knobs = {k["given"]: k for k in lesson_data(load(str(ROOT / "samples" / "shaper.yaml")))["knobs"]}
    assert knobs["place_A.x"]["reach"] == 0.75 and knobs["epsilon_1"]["reach"] == 64.0
    assert all(("reach" in k) == (k["at"] == 0) for k in knobs.values())


def test_a_slider_on_an_arc_is_no_rod_to_its_centre() -> None:
    scene = loads(
        "planes: 1\nframe: {points: {O: [0, 0]}, guides: {arc: {centre: [0.3, 0], radius: 0.2}}}\n"
        "links:\n  1: {points: {O: 0, A: 0.1}}\n  2: {points: {A: 0, B: 0.3}}\n  3: {points: {B: 0}, slides: arc}\n"
        "assembly: {B: left}\ndrive: {link: 1, phi: 40, omega: 10}\n"
    )
    drawn = lesson_data(scene)["scheme"]
    assert drawn["links"][2]["points"] == ["position:B"] and drawn["pivots"] == ["position:O"]
    assert drawn["links"][2]["round"] == {"centre": "position:K", "link": "0"}
