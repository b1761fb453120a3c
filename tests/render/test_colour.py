"""Colour for teaching: off unless it is asked for; then a vector, its head and its bar have the hue of their kind."""

from __future__ import annotations

import re

import pytest

from planes.cli import main
from render.files import pdf, svg
from render.paper.hues import (
    ACCELERATION_COLOUR,
    DETAIL_NAME_SUFFIX,
    INERTIA_COLOUR,
    LOAD_COLOUR,
    REACTION_COLOUR,
    VELOCITY_COLOUR,
)
from render.paper.marks import Arrow, Line, Text
from render.paper.style import BLACK_COLOUR, pen_of_style
from tests.helpers import ROOT
from tests.helpers.sheets import sheet

SIX_LINK = str(ROOT / "samples" / "six-link.yaml")
HUES = {VELOCITY_COLOUR, ACCELERATION_COLOUR, INERTIA_COLOUR, LOAD_COLOUR, REACTION_COLOUR}


def colours(found):
    return {m.name: pen_of_style(m.style).colour for m in found.marks if isinstance(m, (Arrow, Line)) and m.name}


@pytest.mark.parametrize("number", [1, 2])
def test_a_sheet_is_black_unless_colours_are_asked_for(number):
    assert set(colours(sheet("six-link", number=number)).values()) == {BLACK_COLOUR}


def test_every_kind_of_vector_has_its_hue_and_so_has_its_bar():
    seen = colours(sheet("six-link", number=1, colour=True)) | colours(sheet("six-link", number=2, colour=True))
    wanted = {
        "v_CB": VELOCITY_COLOUR,
        "a_CB^n": ACCELERATION_COLOUR,
        "G_2": LOAD_COLOUR,
        "P_5": LOAD_COLOUR,
        "I_2": INERTIA_COLOUR,
        "F_21": REACTION_COLOUR,
    }
    assert {name: seen[name] for name in wanted} == wanted
    bars = {
        "v_{CB}": VELOCITY_COLOUR,
        "a_{CB}^{n}": ACCELERATION_COLOUR,
        "G_{2}": LOAD_COLOUR,
        "Φ_{2}": INERTIA_COLOUR,
        "F_{21}^{t}": REACTION_COLOUR,
    }
    assert {name: seen[f"{name} bar"] for name in bars} == bars
    assert seen["leader"] == BLACK_COLOUR


def test_hues_change_nothing_else():
    plain, hued = (sheet("six-link", number=2, colour=c) for c in (False, True))
    assert [m for m in plain.marks if isinstance(m, Text)] == [m for m in hued.marks if isinstance(m, Text)]
    arrows = [
        [(m.start, m.end, pen_of_style(m.style).width) for m in s.marks if isinstance(m, Arrow)] for s in (plain, hued)
    ]
    assert arrows[0] == arrows[1]


def test_the_hues_are_those_of_the_written_files():
    found = sheet("six-link", number=2, colour=True)
    used = set(re.findall(r'(?:stroke|fill)="(#[0-9A-Fa-f]{6})"', svg.write(found.marks, found.size, "").decode()))
    assert {LOAD_COLOUR, INERTIA_COLOUR, REACTION_COLOUR} <= used and not used & {VELOCITY_COLOUR, ACCELERATION_COLOUR}
    assert pdf.write(found.marks, found.size, "") != pdf.write(sheet("six-link", number=2).marks, found.size, "")


def test_the_option_colours_a_view(tmp_path):
    for option in ([], ["--colour"]):
        assert main(["sheet", SIX_LINK, "--view", "velocity-plan", "-o", str(tmp_path / "v.svg"), *option]) == 0
        assert (VELOCITY_COLOUR in (tmp_path / "v.svg").read_text(encoding="utf-8")) == bool(option)


def test_what_a_detail_shows_of_a_vector_has_its_hue():
    seen = colours(sheet("assignments/12", number=2, colour=True))
    shown = {name: hue for name, hue in seen.items() if name.endswith(DETAIL_NAME_SUFFIX) and name[0] in "FGI"}
    assert len(shown) > 2 and all(
        hue == seen[name.removesuffix(DETAIL_NAME_SUFFIX)] != BLACK_COLOUR for name, hue in shown.items()
    )
