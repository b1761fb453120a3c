"""Formats of ГОСТ 2.301: the size of the page, which is chosen, and what is said where one is too small."""

from __future__ import annotations

import re
from dataclasses import replace

import pypdfium2
import pytest

from planes.documents.sheets import sheet_of
from planes.plans.scales import plan_sizes_on_format
from planes.scene import load, loads
from planes.scene.settings import SHEET_WORD_CHOICES
from planes.words.errors import PlanesError, SceneError
from render.files import pdf
from render.paper.marks import Text
from render.sheet.frame import EXTENDED_FORMATS, FORMATS, Paper
from tests.helpers import ROOT
from tests.helpers.scene_texts import SIX_LINK

PLAIN = SIX_LINK.replace("find:", "# find:").replace("friction:", "# friction:")
FREE = re.sub(r"(?m)^plans:.*\n(?:[ #].*\n)*", "", PLAIN)


def scene(text: str, **settings: str):
    said = ", ".join(f"{key}: {value}" for key, value in settings.items())
    return loads(text + f"\nsheet: {{{said}}}\n")


def test_extended_formats_are_so_many_of_a_format_side_by_side() -> None:
    assert {
        "A4x3": (630, 297),
        "A4x4": (841, 297),
        "A3x3": (891, 420),
        "A2x3": (1261, 594),
    }.items() <= EXTENDED_FORMATS.items()
    for name, (wide, high) in EXTENDED_FORMATS.items():
        base, count = FORMATS[name[:2]], int(name[3:])
        assert high == max(base) or (name == "A0x2" and high == 1189)
        assert abs(wide - count * min(base)) < count  # sides are rounded to a millimetre
    assert len(EXTENDED_FORMATS) == 19


def test_a_scene_may_ask_for_every_format_there_is() -> None:
    assert {*FORMATS, *EXTENDED_FORMATS} == {*SHEET_WORD_CHOICES["format"]} - {"auto"}


@pytest.mark.parametrize("written", ["A3x3", "a3X3", "A3×3", "А3х3"])  # the last in Russian letters
def test_an_extended_format_is_written_as_people_write_it(written: str) -> None:
    assert scene(PLAIN, format=written).sheet["format"] == "A3x3"


def test_a_format_that_is_none_is_refused() -> None:
    with pytest.raises(SceneError, match="A3x8"):
        scene(PLAIN, format="A3x8")


@pytest.mark.parametrize("name", [*FORMATS, *EXTENDED_FORMATS])
def test_the_page_of_a_file_is_of_the_very_size_and_says_its_format(name: str) -> None:
    paper = Paper(name)
    page = pypdfium2.PdfDocument(pdf.write(paper.frame_marks({}), paper.size, "a"))[0]
    assert page.get_size() == pytest.approx([side / 25.4 * 72 for side in paper.size], abs=0.01)
    (said,) = (m.text for m in paper.frame_marks({}) if isinstance(m, Text) and m.name == "cell format")
    assert said == name.replace("x", "×")


@pytest.mark.parametrize("name", EXTENDED_FORMATS)
def test_plans_are_as_large_on_an_extended_format_as_on_one_as_high(name: str) -> None:
    as_high = [usual for usual, size in FORMATS.items() if min(size) == EXTENDED_FORMATS[name][1]] or ["A0"]
    fits, usual = plan_sizes_on_format({"format": name}), plan_sizes_on_format({"format": as_high[0]})
    assert fits == usual or (name[:2] == "A0" and fits["position"] > usual["position"])


@pytest.mark.slow
def test_an_extended_sheet_is_filled() -> None:
    found = sheet_of(scene(FREE, format="A3x3"), None)
    assert (found.size, found.warnings) == ((891, 420), ())
    assert all(found.paper.field[0] <= left for _, left, _ in found.views)


@pytest.mark.slow
def test_what_is_too_much_for_a1_is_as_high_and_longer() -> None:
    nine_links = load(ROOT / "samples" / "class-three" / "three-basic-links.yaml")
    found = sheet_of(replace(nine_links, sheet={}), None, number=2)
    assert (found.paper.name, found.size, found.warnings) == ("A2x3", (1261, 594), ())


@pytest.mark.slow
def test_only_where_nothing_less_holds_the_views_a0_is_taken() -> None:
    assert sheet_of(scene(PLAIN), None).paper.name == "A2"
    large = PLAIN
    larger = {
        "velocity: {mu: 30": 110,
        "acceleration: {mu: 2": 4.5,
        "position: {mu: 250": 750,
        "force: {mu: 0.01": 0.02,
    }
    for stated, mu in larger.items():
        large = large.replace(f"{stated} ", f"{stated.rpartition(' ')[0]} {mu} ")
    assert sheet_of(scene(large), None).paper.name == "A0"


@pytest.mark.few(0, slow=3)
@pytest.mark.parametrize(("text", "number"), [(FREE, 1), (FREE, 2), (PLAIN, None)])
@pytest.mark.parametrize("small", ["A4", "A3"])
def test_a_format_that_is_said_to_hold_all_does_and_what_is_blamed_is_to_blame(
    text: str, number: int | None, small: str
) -> None:
    with pytest.raises(PlanesError) as refused:
        sheet_of(scene(text, format=small), None, number=number)
    said = str(refused.value)
    wide, high = (int(n) for n in re.search(r"\((\d+) × (\d+) мм\)", said).groups())  # type: ignore[union-attr]
    x0, y0, x1, y1 = Paper(small).field
    room = x1 - x0, y1 - y0 - 55 - 14  # beside the title block and graph 26
    if "вместе не помещаются" in said:
        assert wide <= room[0] and high <= room[1]
    else:  # nor would it, with the least distance of 10 mm around it
        assert wide > room[0] - 20 or high > room[1] - 20
    advised = re.search(r"поместится на формате (\w+)$", said)
    assert advised
    found = sheet_of(scene(text, format=advised[1]), None, number=number)
    assert not [w for w in found.warnings if "опущены" in w and "«Направления»" not in w]  # which wait for room
