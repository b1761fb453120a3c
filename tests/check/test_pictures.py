"""Pictures of plans on paper: where their marks are read, what is found in them, and what is no plan at all."""

from __future__ import annotations

import cmath
import json
import math
import random
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from planes.cli import main
from tests import confusion
from tests.confusion import SAMPLES, Easel, easel
from tests.helpers.counting import at_most
from tests.helpers.drawings import Mistake

cv2 = pytest.importorskip("cv2")
import numpy as np  # noqa: E402

from planes.check.fiducials import SHEET_MM  # noqa: E402
from planes.check.grading.paper import Known, ReadPaper  # noqa: E402
from planes.check.grading.prepared_plan import Asked  # noqa: E402
from planes.check.outcome import Outcome, check  # noqa: E402
from planes.check.report import as_json  # noqa: E402
from planes.check.vision.image.decoding import channel_without_grid  # noqa: E402
from planes.check.vision.image.frame import PAPER_SIZES_MM, aspect_ratio_and_obliqueness, frame_corners  # noqa: E402
from planes.check.vision.image.picture import flatten  # noqa: E402
from planes.check.vision.photograph import read_picture  # noqa: E402
from tests import picture_corpus as corpus  # noqa: E402
from tests.helpers import photographs  # noqa: E402
from tests.helpers.photographs import PHONE, SCAN, Camera  # noqa: E402

SIX = str(SAMPLES / "six-link.yaml")
MOTION = [
    ("six-link", "velocity"),
    ("six-link", "acceleration"),
    ("kind-2-rrp", "acceleration"),
    ("kind-4-prp", "acceleration"),
    ("kind-5-rpp", "velocity"),
    ("sliding-driver", "acceleration"),
]
FORCES = [
    ("six-link", "force:2-3"),
    ("six-link", "force:4-5"),
    ("bntu-4", "force:2-3"),
    ("kind-3-rpr", "force:1"),
    ("kind-4-prp", "force:2-3"),
    ("sliding-driver", "force:1"),
]


def looked(
    one: Easel, camera: Camera, folder: Path, mistake: Mistake | None = None, seed: int = 1
) -> tuple[corpus.Drawn, Outcome]:
    """A drawing on its blank, and what the checker finds in its picture."""
    rng, file = random.Random(seed), folder / "p.jpg"
    drawn = corpus.drawn(one, mistake, rng)
    assert drawn is not None
    corpus.picture(drawn, corpus.pole_of(one), camera, rng, file)
    return drawn, corpus.looked_at(one, file)[0]


@pytest.mark.slow
def test_a_vector_that_is_none_of_the_plan_s_is_told_of(tmp_path: Path) -> None:
    """All marks are right: the verdict says so, and a note that there is more; of the bare plan there is none."""
    one, notes = easel("six-link", "velocity"), []
    for more in ([], [(0j, -35 - 25j)]):
        drawn = corpus.drawn(one, None, random.Random(1))
        assert drawn is not None
        whole = replace(drawn, strokes=[*drawn.strokes, *more])
        corpus.picture(whole, corpus.pole_of(one), SCAN, random.Random(1), tmp_path / "p.jpg")
        found = corpus.looked_at(one, tmp_path / "p.jpg")[0]
        assert found.verdict == "right"
        notes.append([n.key for n in found.notes])
    assert notes == [[], ["check_strangers"]]


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize("first", range(2))
@pytest.mark.parametrize(("camera", "most"), [(SCAN, 1.0), (PHONE, 1.5)], ids=["scan", "phone"])
def test_marks_are_read_where_they_were_put(camera: Camera, most: float, first: int, tmp_path: Path) -> None:
    errors, count = [], 0
    for sample, plan in MOTION[first::2]:
        drawn, found = looked(easel(sample, plan), camera, tmp_path)
        assert found.verdict == "right", (sample, plan, found.sentence.told("en"))
        errors += corpus.mark_errors(easel(sample, plan), drawn, found)
        count += len(drawn.marks)
    errors.sort()
    assert len(errors) >= 0.95 * count
    assert errors[len(errors) // 2] < 0.3 and errors[int(0.95 * len(errors))] < most


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("first", range(2))
@pytest.mark.parametrize("camera", [SCAN, PHONE], ids=["scan", "phone"])
def test_force_polygons_are_read_in_any_order(camera: Camera, first: int, tmp_path: Path) -> None:
    """The weight of slider 5 lies within two longer forces of its line, no end of it is seen: that is said."""
    for sample, plan in FORCES[first::2]:
        drawn, found = looked(easel(sample, plan), camera, tmp_path, seed=3)
        hidden = {"force:4-5": {"G_5", "I_5"}, "force:2-3": {"I_3", "F_30", "F_21n"}}  # ends no head shows among others
        told = found.verdict, set(found.unseen) - hidden.get(plan, set())
        assert told in (("right", set()), ("right_as_seen", set())), (sample, plan, found.sentence.told("en"))
        assert found.verdict == "right" or plan in hidden
        assert {s.name for s in found.paper.spots} >= set(drawn.marks), (sample, plan)


@pytest.mark.few(0, slow=3)
@pytest.mark.parametrize(
    "camera",
    [
        replace(SCAN, dpi=150, grid="millimetre", erased=3),
        replace(SCAN, dpi=300, grid="square", turn_deg=2),
        replace(PHONE, grid="square", erased=3, shade=0.45),
        replace(SCAN, wobble_mm=0.2, noise=6, quality=50),
    ],
    ids=["150 dpi", "300 dpi", "dark", "rough"],
)
def test_any_paper(camera: Camera, tmp_path: Path) -> None:
    """Grids, lines rubbed out, letters, uneven light: none of it is taken for the plan."""
    for sample, plan in (MOTION[1], FORCES[1]):
        assert looked(easel(sample, plan), camera, tmp_path)[1].verdict in ("right", "right_as_seen")


@pytest.mark.slow
@pytest.mark.parametrize("plan", ["velocity", "acceleration", "force:4-5"])
def test_lines_drawn_beyond_their_crossings(plan: str, tmp_path: Path) -> None:
    """Thin lines of construction go on past the marks; a polygon that cannot surely be told from them is not judged."""
    one, rng, file = easel("six-link", plan), random.Random(3), tmp_path / "p.jpg"
    drawn, pole, page = corpus.drawn(one, None, rng), corpus.pole_of(one), photographs.Page(200)
    assert drawn is not None
    page.print_blank(pole, True)
    for a, b in drawn.strokes:
        page.stroke(a + pole, b + pole, 0.1, rng)
        if abs(a) > 1:
            u = (b - a) / abs(b - a)
            page.line([a - 3 * u + pole, b + rng.uniform(4, 10) * u + pole], 120, 0.2)
    photographs.save(str(file), photographs.shot(page.grey, SCAN, rng), SCAN)
    found = corpus.looked_at(one, file)[0]
    assert found.verdict in (("right", "right_as_seen", "unreadable") if plan.startswith("force") else ("right",))


@pytest.mark.few(0, slow=5)
@pytest.mark.parametrize(
    ("plan", "mistake"),
    [
        ("velocity", Mistake("omega1_reversed", "b")),
        ("velocity", Mistake("along_link", "c")),
        ("acceleration", Mistake("normal_outward", "n_CB")),
        ("acceleration", Mistake("coriolis_half", "k_HL")),
        ("force:4-5", Mistake("force_missing", "P_5")),
        ("force:2-3", Mistake("inertia_along_acceleration", "I_2")),
        ("force:2-3", Mistake("tangential_reversed", "F_21t")),
        ("force:1", Mistake("not_closed", "F_10")),
    ],
)
def test_mistakes_are_seen_and_named(plan: str, mistake: Mistake, tmp_path: Path) -> None:
    for camera in (SCAN, PHONE):
        _, found = looked(easel("six-link", plan), camera, tmp_path, mistake)
        assert (found.verdict, found.mistake, found.first_wrong) == ("wrong", mistake.name, mistake.where)


@pytest.mark.slow
def test_a_mistake_of_no_catalogue_is_found_where_it_is(tmp_path: Path) -> None:
    one, rng, file = easel("six-link", "velocity"), random.Random(2), tmp_path / "p.png"
    drawn = corpus.drawn(one, None, rng)
    assert drawn is not None
    h, elsewhere = drawn.marks["h"], drawn.marks["h"] + 12 - 9j
    strokes = [tuple(elsewhere if abs(z - h) < 1e-9 else z for z in s) for s in drawn.strokes]
    corpus.picture(replace(drawn, strokes=strokes), corpus.pole_of(one), SCAN, rng, file)
    found = corpus.looked_at(one, file)[0]
    assert (found.verdict, found.first_wrong) == ("wrong", "h")
    place = next(s.place for s in found.paper.spots if s.name == "h")
    assert abs(place - corpus.pole_of(one) - elsewhere) < 0.5


def test_the_frame_tells_the_format() -> None:
    for name, (w, h) in list(PAPER_SIZES_MM.items())[:3]:
        for size in ((w, h), (h, w)):
            camera = replace(SCAN, dpi=110, corners=False, turn_deg=1)
            page = photographs.sheet([(0j, 60 + 30j)], [], 100 + 100j, camera, random.Random(1), size)
            grey = photographs.shot(page, camera, random.Random(2))
            corners = frame_corners(grey)
            assert corners is not None, name
            ratio, _ = aspect_ratio_and_obliqueness(corners, grey.shape)
            assert ratio == pytest.approx((size[0] - 25) / (size[1] - 10), rel=0.002)


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize(
    ("size", "camera"),
    [("A4", SCAN), ("A3", replace(SCAN, dpi=150)), ("A3", replace(PHONE, dpi=150))],
    ids=["A4", "A3", "A3 photo"],
)
@pytest.mark.parametrize("told", [False, True])
def test_a_sheet_without_corner_marks(size: str, camera: Camera, told: bool, tmp_path: Path) -> None:
    """By the frame alone, its format guessed or told; the pole is where the plan fits."""
    one, rng, file = easel("six-link", "velocity"), random.Random(4), tmp_path / "f.png"
    drawn, pole = corpus.drawn(one, None, rng), 140 + 110j
    assert drawn is not None
    camera = replace(camera, corners=False)
    page = photographs.sheet(drawn.strokes, drawn.words, pole, camera, rng, PAPER_SIZES_MM[size])
    cv2.imwrite(str(file), photographs.shot(page, camera, rng))
    b = confusion.bench(one.sample, one.plan)
    paper = read_picture(str(file), b, Known(format=size if told else None))
    assert check(b.asked, paper).verdict == "right"
    assert abs(paper.spots[0].place - pole) < 0.6
    if told:  # a wrong format is a wrong scale, never a pass
        assert check(b.asked, read_picture(str(file), b, Known(format="A2"))).verdict != "right"


def photo_of(what: str) -> Any:
    """Pictures that hold no plan."""
    rng = np.random.default_rng(1)
    if what == "empty sheet":
        return photographs.shot(photographs.sheet([], [], 150 + 100j, PHONE, random.Random(1)), PHONE, random.Random(2))
    if what == "10 000 lines":
        ends = rng.uniform((25, 10), (290, 200), (20000, 2)) @ np.array([1, 1j])
        page = photographs.sheet([], [], 150 + 100j, SCAN, random.Random(1))
        for a, b in ends.reshape(-1, 2):
            one, two = ((int(z.real * 15.75), int((210 - z.imag) * 15.75)) for z in (a, b))
            cv2.line(page, one, two, 60, 6)
        return photographs.shot(page, SCAN, random.Random(2))
    if what == "hatching":
        lines = [(complex(x, -60) - 60, complex(x + 20, 60) - 60) for x in range(0, 100, 6)]
        page = photographs.sheet(lines, [], 150 + 100j, SCAN, random.Random(1))
        return photographs.shot(page, SCAN, random.Random(2))
    small = rng.uniform(60, 220, (9, 13))
    return cv2.resize(small, (1300, 900), interpolation=cv2.INTER_CUBIC).astype(np.uint8)  # a landscape, say


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize("plan", ["velocity", "force:2-3"])
@pytest.mark.parametrize("what", ["empty sheet", "10 000 lines", "hatching", "landscape"])
def test_what_is_no_plan_is_said_to_be_none(
    what: str, plan: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "x.png"
    cv2.imwrite(str(file), photo_of(what))
    with at_most(30_000_000):
        status = main(["check", SIX, str(file), "--plan", plan, "--json", "--lang", "en"])
    told = capsys.readouterr()
    assert status == 2
    if told.out:
        found = json.loads(told.out)
        assert found["verdict"] == "unreadable" and found["mistake"] is None and found["sentence"]["en"]
    else:
        assert len(told.err.strip().splitlines()) == 1


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize("plan", ["velocity", "acceleration"])
def test_another_scene_is_unreadable(plan: str, tmp_path: Path) -> None:
    asked = Asked(confusion.bench("six-link", plan).asked.scene, plan, mu=confusion.bench("six-link", plan).said_mu)
    for other in ("kind-1-rrr", "kind-5-rpp", "assignment-12"):
        looked(easel(other, plan), SCAN, tmp_path)
        paper = read_picture(str(tmp_path / "p.jpg"), confusion.prepare(asked))
        assert check(asked, paper).verdict == "unreadable", other


def on_plain_paper(one: Easel, askew_deg: float, file: Path, name: str) -> tuple[corpus.Drawn, ReadPaper]:
    """A right drawing on paper without any print, scanned askew, read by its pole and a mark."""
    rng, turn = random.Random(6), cmath.rect(1, math.radians(askew_deg))
    drawn, camera = corpus.drawn(one, None, rng), replace(SCAN, corners=False)
    assert drawn is not None
    k, h = camera.dpi / 25.4, 210.0
    page = photographs.Page(camera.dpi)
    pole = 140 + 90j
    for a, b in drawn.strokes:
        page.stroke(a * turn + pole, b * turn + pole, 0.1, rng)
    cv2.imwrite(str(file), photographs.shot(page.grey, camera, rng))

    def pixel(z: complex) -> complex:
        return complex((z * turn + pole).real * k - 0.5, (h - (z * turn + pole).imag) * k - 0.5)

    b = confusion.bench(one.sample, one.plan)
    return drawn, read_picture(str(file), b, Known(pixel(0j), {name: pixel(drawn.marks[name])}))


@pytest.mark.slow
def test_the_vector_that_gave_the_scale_is_not_judged_in_length(tmp_path: Path) -> None:
    one = easel("six-link", "velocity")
    drawn, paper = on_plain_paper(one, 0.0, tmp_path / "p.png", "b")
    found = as_json(check(confusion.bench(one.sample, one.plan).asked, paper))
    assert paper.scale_mark == "b" and found["verdict"] == "right"
    rows = {m["mark"]: m for m in found["marks"]}
    assert rows["b"]["unjudged"] == "length" and all("unjudged" not in r for n, r in rows.items() if n != "b")
    assert sum("could not be judged" in w for w in found["warnings"]) == 1
    assert not any("askew" in w for w in found["warnings"])
    stretched = 60 / abs(drawn.marks["b"])  # as if b had been laid off exactly
    for name, row in rows.items():
        assert abs(complex(*row["read_mm"]) - drawn.marks[name] * stretched) < 0.5, name


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("askew", [-2.0, 3.0])
def test_a_sheet_without_print_that_lies_askew_is_turned_straight(askew: float, tmp_path: Path) -> None:
    """By the vector it takes its scale from; what is turned further is no sheet askew, but a wrong vector."""
    one = easel("six-link", "velocity")
    drawn, paper = on_plain_paper(one, askew, tmp_path / "p.png", "b")
    found = as_json(check(confusion.bench(one.sample, one.plan).asked, paper))
    assert found["verdict"] == "right", found["sentence"]["en"]
    told = next(float(w.split("askew by ")[1].split("°")[0]) for w in found["warnings"] if "askew by" in w)
    assert abs(told - abs(askew)) < 0.5  # the vector itself is drawn by hand
    marks, pole = {s.name: s.place for s in paper.spots}, paper.spots[0].place
    assert all(abs(marks[n] - pole - z * 60 / abs(drawn.marks["b"])) < 0.6 for n, z in drawn.marks.items())
    assert not [n for n in on_plain_paper(one, 8.0, tmp_path / "q.png", "b")[1].notes if n.key == "check_askew"]


@pytest.mark.slow
def test_a_pole_named_on_a_blank_counts_more_than_the_printed_one(tmp_path: Path) -> None:
    """Somebody began elsewhere than at the cross: the corner marks still give the scale."""
    one, rng, file = easel("six-link", "velocity"), random.Random(7), tmp_path / "p.png"
    drawn, camera, shift = corpus.drawn(one, None, rng), replace(SCAN, dpi=300), 11 - 7j
    assert drawn is not None
    strokes = [(a + shift, b + shift) for a, b in drawn.strokes]
    corpus.picture(replace(drawn, strokes=strokes, words=[]), corpus.pole_of(one), camera, rng, file)
    place, k = corpus.pole_of(one) + shift, camera.dpi / 25.4
    b = confusion.bench(one.sample, one.plan)
    paper = read_picture(str(file), b, Known(complex(place.real * k, (210 - place.imag) * k)))
    assert check(b.asked, paper).verdict == "right" and abs(paper.spots[0].place - place) < 0.2


def coloured(easel_: Easel, camera: Camera, inks: tuple[float, float, float], file: Path) -> corpus.Drawn:
    drawn = corpus.drawn(easel_, None, random.Random(5))
    assert drawn is not None
    pole = corpus.pole_of(easel_)
    picture = photographs.coloured(drawn.strokes, drawn.words, pole, camera, 3, inks)
    cv2.imwrite(str(file), picture, [cv2.IMWRITE_JPEG_QUALITY, camera.quality])
    return drawn


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize(("lens", "curl_mm"), [(-0.08, 0), (-0.03, 0), (0.08, 0), (0, 4), (0.05, -3)])
def test_a_lens_that_bends_and_paper_that_curls_are_told_by_the_frame(
    lens: float, curl_mm: float, tmp_path: Path
) -> None:
    errors, count = [], 0
    for sample, plan in MOTION[:3]:
        drawn, found = looked(easel(sample, plan), replace(PHONE, lens=lens, curl_mm=curl_mm), tmp_path)
        assert found.verdict in ("right", "right_as_seen"), (sample, plan, found.sentence.told("en"))
        errors += corpus.mark_errors(easel(sample, plan), drawn, found)
        count += len(drawn.marks)
    errors.sort()
    assert len(errors) >= 0.95 * count and errors[int(0.85 * len(errors))] < 0.6


@pytest.mark.slow
def test_pixels_of_a_bent_picture_are_found_on_the_sheet() -> None:
    camera, place = replace(SCAN, lens=0.06), 90 + 150j
    page = photographs.sheet([], [], 150 + 100j, camera, random.Random(1))
    flat = flatten(photographs.shot(page, camera, random.Random(2)))
    assert flat is not None and flat.bend is not None
    half = abs(complex(*SHEET_MM)) / 2
    z = (place - complex(*SHEET_MM) / 2) / half / (1 + camera.lens)
    off = z * (1 + camera.lens * (abs(z) * (1 + camera.lens)) ** 2)
    seen = complex(*SHEET_MM) / 2 + half * off
    k = camera.dpi / 25.4
    assert abs(flat.sheet_point_of_pixel(complex(seen.real * k, (SHEET_MM[1] - seen.imag) * k)) - place) < 0.3


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize(
    "inks", [(0.2, 1.2, 2.2), (0.5, 2.9, 3.8), (3.9, 2.9, 0.4)], ids=["blue", "dark blue", "dark orange"]
)
@pytest.mark.parametrize("camera", [SCAN, PHONE], ids=["scan", "phone"])
def test_a_coloured_grid_is_looked_past(camera: Camera, inks: tuple[float, float, float], tmp_path: Path) -> None:
    """Printed so dark that in grey it is as dark as a pencil."""
    one, file = easel("six-link", "acceleration"), tmp_path / "p.jpg"
    drawn = coloured(one, replace(camera, grid="millimetre"), inks, file)
    found = corpus.looked_at(one, file)[0]
    assert found.verdict in ("right", "right_as_seen"), found.sentence.told("en")
    assert max(corpus.mark_errors(one, drawn, found)) < 0.9


def test_what_is_drawn_in_colour_does_not_fade() -> None:
    """A pen as blue as a faint grid keeps its ink: grey is looked at."""
    colour = np.full((900, 1300, 3), 245, np.uint8)
    for x in range(0, 1300, 8):
        colour[:, x] = (240, 215, 200)
    cv2.line(colour, (300, 200), (900, 700), (200, 60, 30), 5, cv2.LINE_AA)
    assert np.array_equal(channel_without_grid(cv2, colour), cv2.cvtColor(colour, cv2.COLOR_BGR2GRAY))


@pytest.mark.long
@pytest.mark.parametrize("first", range(2))
def test_a_small_corpus(first: int) -> None:
    """Shares of right drawings accepted and of mistakes found, blamed and named; ``picture_corpus`` counts them all."""
    whole = corpus.Count()
    chosen = [e for e in confusion.easels() if e.sample in ("kind-1-rrr", "bntu-3")][first::2]
    for _, _, count in corpus.draw_all(1, chosen):
        whole.add(count)
    doubted = sum("-> right_as_seen" in f for f in whole.failures)  # a mistake leaves nearly the same polygon
    assert whole.right > 7 and whole.accepted + doubted >= 0.98 * whole.right and doubted <= 1, whole.failures
    assert whole.wrong > 4 and whole.found >= 0.98 * whole.wrong and whole.named >= 0.9 * whole.wrong, whole.failures
    assert whole.blamed >= 0.95 * whole.wrong and whole.innocent_blamed <= 0.02 * whole.innocent, whole.failures
