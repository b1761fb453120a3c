"""What a notebook shows of a scene, a position, a table, a check; the crank; the notebooks of docs/."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest

import planes
from tests.helpers import ROOT

pytestmark = pytest.mark.needs("anywidget", "nbclient", "ipykernel")
FOUR_BAR, CRANK = (ROOT / "samples" / f"{name}.yaml" for name in ("kind-1-rrr", "kind-2-rrp"))
NOTEBOOKS = sorted((ROOT / "docs" / "notebooks").glob("*.ipynb"))


def cells(html: str) -> list[str]:
    return [re.sub("<.*?>", "", cell) for cell in re.findall("<t[dh]>(.*?)</t[dh]>", html)]


def test_each_thing_shows_its_numbers(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("LC_ALL", "C")
    scene = planes.load(FOUR_BAR)
    here = planes.solve(scene)
    assert {"l_AB", "0.12"} <= {*cells(scene._repr_html_())} and "W = 1" in scene._repr_html_()
    shown = here._repr_html_()
    assert f"{abs(here.v['C']):.3f}" in shown and "<svg" in shown and "φ = 310°" in shown
    table = planes.cycle(scene, ["omega_2"], phi=range(0, 360, 10))
    assert cells(table._repr_html_())[:2] == ["phi, °", "omega_2, rad/s"]
    assert "…" in cells(table._repr_html_()) and "36 × 2" in table._repr_html_()
    planes.sheet(scene, tmp_path / "v.svg", view="velocity-plan", lang="en")
    found = planes.check(scene, tmp_path / "v.svg", "velocity")
    assert found.sentence.told("en") in found._repr_html_()
    for thing in (scene, here, table, found):
        body = thing._repr_html_().partition("</style>")[2]
        ElementTree.fromstring(body.replace("<br>", "<br/>"))


def test_it_speaks_the_language_of_the_system(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("LC_ALL", "ru_RU.UTF-8")
    scene = planes.load(FOUR_BAR)
    assert "Ворошилка" in scene._repr_html_() and "м/с²" in planes.solve(scene)._repr_html_()


def test_what_cannot_be_drawn_is_told_all_the_same() -> None:
    scene = planes.load(FOUR_BAR, l_BC=5.0)
    assert "l_BC" in scene._repr_html_()


def test_markup_in_a_title_stays_text() -> None:
    text = FOUR_BAR.read_text("utf-8").replace("A four-bar", "<script>").replace("en: Hay", "en: <script>Hay")
    assert "<script>" not in planes.loads(text)._repr_html_()


def test_the_crank_turns() -> None:
    turned = planes.crank(planes.load(CRANK), lang="en")
    first = turned.svg
    assert first.count("<svg") == 2 and turned.position.at == 15.0
    turned.value = 100.0
    assert turned.svg != first and turned.position.at == 100.0 and not turned.failure
    sample = planes.load(ROOT / "samples" / "six-link.yaml")
    stuck = planes.crank(sample, lang="ru")
    stuck.value = 10.0
    assert stuck.position is None and "не собирается" in stuck.failure
    stuck.value = 200.0
    assert stuck.position.at == 200.0 and not stuck.failure


def plain(cell: dict[str, Any]) -> list[str]:
    """What a cell shows as text, without the places of things in memory."""
    texts = (out.get("data", {}).get("text/plain", "") for out in cell.get("outputs", []))
    return [re.sub(r"0x[0-9a-f]+|model_id='\w+'", "…", "".join(text)) for text in texts]


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("file", NOTEBOOKS, ids=lambda f: f.stem)
def test_a_notebook_runs(file: Path) -> None:
    import nbformat
    from nbclient import NotebookClient

    assert len(NOTEBOOKS) >= 3
    book = nbformat.read(file, as_version=4)
    kept = [plain(cell) for cell in book.cells]
    assert any(kept)
    NotebookClient(book, timeout=300, resources={"metadata": {"path": str(file.parent)}}).execute()
    shown = [out for cell in book.cells for out in cell.get("outputs", []) if "data" in out]
    assert any("text/html" in out["data"] for out in shown)
    assert [plain(cell) for cell in book.cells] == kept  # what a reader sees is what it gives
