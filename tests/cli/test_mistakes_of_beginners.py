"""What beginners write wrong, as a review of the program as a new user found it: nothing is taken in silence, nothing
ends in a traceback, and both languages say the same place."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from planes.cli import main
from planes.cli.start import TEMPLATES

BASE = (TEMPLATES / "crank-slider.yaml").read_text("utf-8")
ONCE_SILENT = {
    "radians": ("phi_1: 60", "phi_1: 1.047"),
    "a part of pi": ("phi: phi_1", "phi: pi/3"),
    "millimetres": ("l_OA: 0.1, l_AB: 0.35", "l_OA: 100, l_AB: 350"),
    "a mass among the points": ("{B: 0}, slides: x-x, mass: 3", "{B: 0, mass: 3}, slides: x-x"),
    "no omega": (", omega: 20", ""),
    "inertia without mass": ("centre: S2, mass: 2,", "centre: S2,"),
    "mass without centre": ("centre: S2, mass: 2", "mass: 2"),
    "empty gravity": ("gravity: 9.81", "gravity:"),
    "friction above one": ("gravity: 9.81", "gravity: 9.81\nfriction: {x-x: 1.5}"),
    "a crank of no length": ("l_OA: 0.1", "l_OA: 0"),
    "a sine for an angle": ("phi: phi_1", "phi: sin(phi_1)"),
    "a format there is not": ("gravity: 9.81", "gravity: 9.81\nsheet: {format: A5}"),
    "a font there is not": ("gravity: 9.81", "gravity: 9.81\nsheet: {font: Nonesuch}"),
    "a diagram there is not": ("gravity: 9.81", "gravity: 9.81\nsheet: {diagrams: [u_99]}"),
}
REFUSED = {
    "decimal comma": ("l_OA: 0.1", "l_OA: 0,1"),
    "a unit": ("l_OA: 0.1", "l_OA: 100 mm"),
    "degrees": ("phi_1: 60", "phi_1: 60°"),
    "a tab": ("frame:\n  points", "frame:\n\tpoints"),
    "Cyrillic A": ("2: {points: {A: 0", "2: {points: {А: 0"),
    "a key in Russian": ("links:", "звенья:"),
    "a key misspelt": ("assembly:", "asembly:"),
    "American": ("centre: S2", "center: S2"),
    "a name misspelt": ("slides: x-x", "slides: xx"),
    "a word misspelt": ("against: motion", "against: movement"),
    "no assembly": ("assembly: {B: ahead}", ""),
    "a side of another group": ("{B: ahead}", "{B: left}"),
    "no colon": ("phi: phi_1", "phi phi_1"),
    "an open brace": ("loads:\n  - {link: 3, point: B", "loads:\n  - {link: 3, point: {B"),
    "a key twice": ("gravity: 9.81", "gravity: 9.81\ngravity: 9.8"),
    "a circle of parameters": ("l_OA: 0.1", "l_OA: l_AB - 0.25 + 0*l_OA"),
    "an unknown parameter": ("phi: phi_1", "phi: φ_1"),
    "a link too many": ("assembly:", "  4: {points: {A: 0, B: 0.2}}\nassembly:"),
    "hinges in one place": ("l_AB: 0.35", "l_AB: 0"),
    "it does not reach": ("l_AB: 0.35", "l_AB: 0.01"),
    "another format": ("planes: 1", "planes: 2"),
    "a negative mass": ("mass: 3", "mass: -3"),
    "a scale of another unit": ("gravity: 9.81", "gravity: 9.81\nplans: {velocity: {mu: 30 mm/m}}"),
    "a result there is not": ("gravity: 9.81", "gravity: 9.81\nfind: [v_Q]"),
    "division by zero": ("l_OA: 0.1", "l_OA: 1/0"),
    "nothing": (BASE, ""),
}


def told(change: tuple[str, str], folder: Path, capsys: pytest.CaptureFixture[str]) -> dict[str, tuple[int, str]]:
    """What a sheet of the scene so changed comes to, in both languages."""
    assert change[0] in BASE
    (folder / "s.yaml").write_text(BASE.replace(*change), "utf-8")
    found = {}
    for lang in ("en", "ru"):
        status = main(["sheet", str(folder / "s.yaml"), "-o", str(folder / "x.svg"), "--lang", lang])
        found[lang] = status, capsys.readouterr().err
    assert found["en"][0] == found["ru"][0]
    places = [re.findall(r"s\.yaml:(\d+):", text) for _, text in found.values()]
    assert places[0] == places[1]
    assert re.search("[а-я]", found["ru"][1]) and not re.search("[а-яА-Я]{2,}", re.sub('".*?"', "", found["en"][1]))
    return found


@pytest.mark.parametrize("name", ONCE_SILENT)
def test_nothing_is_taken_in_silence(name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    status, said = told(ONCE_SILENT[name], tmp_path, capsys)["en"]
    assert status in (0, 2) and re.search(r"s\.yaml:\d+: ", said)


@pytest.mark.parametrize("name", REFUSED)
def test_a_mistake_is_one_sentence_with_its_line(name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    status, said = told(REFUSED[name], tmp_path, capsys)["en"]
    assert status == 2 and "Traceback" not in said and not (tmp_path / "x.svg").exists()
    last = said.strip().splitlines()[-1]
    assert re.search(r"s\.yaml:(\d+: )?", last) and len(last) < 700
