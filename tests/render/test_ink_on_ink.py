"""Sheets read back from the files as they are written: no letter lies on another or on a line, or it is said."""

from __future__ import annotations

import cmath
import random
import re
from dataclasses import replace
from functools import cache
from pathlib import Path
from xml.etree import ElementTree

import pytest
import shapely

from planes.documents.drawn import page_of_view
from planes.documents.sheets import sheet_of
from planes.scene import Scene, load, loads
from planes.words.errors import PlanesError
from render.paper.typeset import plain_text
from render.sheet import Sheet
from render.sheet.single import Page
from tests.helpers import ROOT
from tests.helpers.mechanisms import KINDS, make, to_yaml

HERE = ROOT / "samples"
SOME = [HERE / f"{name}.yaml" for name in ("six-link", "kind-3-rpr", "sliding-driver", "assignments/44")]
SEEDS = range(20)
VIEWS = ("acceleration-plan", "accelerations", "lever")
NUMBER = re.compile(r"-?\d+\.?\d*")
BETWEEN_MM = 1e-3  # lines nearer than this touch; numbers of the file are rounded to it


def strokes(path: str) -> list[list[complex]]:
    """The strokes of a path of M, L, A and Z."""
    found: list[list[complex]] = []
    for letter, rest in re.findall(r"([MLAZ])([^MLAZ]*)", path):
        numbers = [float(x) for x in NUMBER.findall(rest)]
        if letter == "Z":
            found[-1].append(found[-1][0])
            continue
        end = complex(*numbers[-2:])
        if letter == "M":
            found.append([end])
        elif letter == "L":
            found[-1].append(end)
        else:
            found[-1] += arc(found[-1][-1], end, numbers[0])
    return found


def arc(start: complex, end: complex, radius: float) -> list[complex]:
    """Points of the lesser arc from start to end, counter-clockwise as it is seen (y is down)."""
    half = (end - start) / 2
    rise = max(radius**2 - abs(half) ** 2, 0.0) ** 0.5
    centre = start + half - 1j * half / abs(half) * rise
    turned = (end - centre) / (start - centre)
    angle = -abs(cmath.phase(turned))
    return [centre + (start - centre) * cmath.exp(1j * angle * k / 16) for k in range(1, 17)]


def shape(path: ElementTree.Element) -> shapely.Geometry:
    """The ink of one path."""
    width = float(path.get("stroke-width", "0"))
    lines = [[(z.real, z.imag) for z in line] for line in strokes(path.get("d", "")) if len(line) > 1]
    inked = [shapely.LineString(line).buffer(max(width / 2 - BETWEEN_MM, BETWEEN_MM)) for line in lines]
    if path.get("fill") not in (None, "none", "#ffffff"):
        inked += [shapely.Polygon(line).buffer(0) for line in lines if len(line) > 3]
    return shapely.union_all(inked)


def ink_on_ink(svg: bytes) -> list[str]:
    """The texts of a written drawing whose letters lie on other letters or on a line."""
    tree = ElementTree.fromstring(svg)
    space = {"s": "http://www.w3.org/2000/svg"}
    texts, own = [], set()
    for group in tree.iterfind(".//s:g[s:text]", space):
        paths = group.findall("s:path", space)
        own |= set(paths)
        name = "".join(t.text or "" for t in group.iterfind("s:text/s:tspan", space))
        texts.append((name, shapely.union_all([shape(p) for p in paths])))
    rest = shapely.STRtree([shape(p) for p in tree.iterfind(".//s:path", space) if p not in own])
    found = [name for name, letters in texts if len(rest.query(letters, predicate="intersects"))]
    letters = shapely.STRtree([one for _, one in texts])
    for k, (name, one) in enumerate(texts):
        found += [name for j in letters.query(one, predicate="intersects") if j != k]
    return found


def unsaid(drawn: Sheet | Page) -> list[str]:
    """Ink on ink that no sentence speaks of."""
    return [t for t in ink_on_ink(drawn.file_contents(".svg")) if not any(t in w for w in drawn.warnings)]


@pytest.mark.few(0)
@pytest.mark.parametrize("path", SOME, ids=[p.stem for p in SOME])
def test_no_ink_on_ink_on_a_written_sheet(path: Path) -> None:
    assert ink_on_ink(sheet_of(load(path), None, "ru").file_contents(".svg")) == []


@cache
def random_scene(seed: int) -> Scene:
    rng = random.Random(seed)
    return replace(loads(to_yaml(make(rng, rng.choices(KINDS, k=2), friction=seed % 3 == 0).scene)), find=None)


@pytest.mark.few(0, slow=4)
@pytest.mark.parametrize("seed", SEEDS)
def test_no_ink_on_ink_unsaid_on_random_mechanisms(seed: int) -> None:
    drawn = 0
    for view in VIEWS:
        try:
            page = page_of_view(random_scene(seed), view, None, "ru")
        except PlanesError as error:
            assert "нечего чертить" in str(error) or "φ = " in str(error) or "s = " in str(error)
            continue
        drawn += 1
        assert unsaid(page) == [], view
    assert drawn


@pytest.mark.few(0, slow=4)
@pytest.mark.parametrize("seed", range(100, 120))
def test_no_ink_on_ink_unsaid_on_crowded_sheets(seed: int) -> None:
    """Three groups, seven links, all loads: the labels that find no place are named."""
    rng = random.Random(seed)
    scene = replace(loads(to_yaml(make(rng, rng.choices(KINDS, k=3), friction=seed % 3 == 0).scene)), find=None)
    for number in (1, 2):
        try:
            drawn = sheet_of(scene, None, "ru", number)
        except PlanesError as error:
            assert "φ = " in str(error) or "s = " in str(error)
            continue
        assert unsaid(drawn) == []


def test_the_reader_sees_ink_on_ink() -> None:
    page = page_of_view(load(HERE / "kind-1-rrr.yaml"), "velocity-plan", None, "ru")
    text = next(m for m in page.marks if getattr(m, "text", "") == "c")
    line = next(m for m in page.marks if getattr(m, "points", ()))
    struck = replace(line, points=(text.place, text.place + 3 + 3j), style="thin")
    assert ink_on_ink(replace(page, marks=(*page.marks, struck)).file_contents(".svg")) == ["c"]
    twice = replace(text, place=text.place + 0.7)
    assert plain_text(twice.text) in ink_on_ink(replace(page, marks=(*page.marks, twice)).file_contents(".svg"))
