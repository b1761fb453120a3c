"""A result's curve in the lesson: the engine's numbers over the whole run, a cursor where the driver stands."""

from __future__ import annotations

from pathlib import Path

import numpy
import pytest

from planes.batch.cycle import Cycle
from planes.plans.statements.of_scene import scene_plans
from planes.scene import load
from tests.helpers import ROOT
from tests.helpers.browser import chromium, until
from tests.helpers.lessons import lesson_written


def test_a_curve_has_the_numbers_of_a_cycle(tmp_path: Path) -> None:
    """Each place of the run, those that fail left out; the curve is drawn anew when a dimension changes."""
    scene = load(ROOT / "samples" / "six-link.yaml")
    cycle = Cycle(scene_plans(scene), ["omega_2", "v_C", "M_1"])
    table = next(iter(cycle.blocks(numpy.linspace(0.0, 360.0, 181))))
    columns = {column.name: row for column, row in zip(cycle.columns, table.table, strict=True)}
    speed = numpy.hypot(columns["v_C_x"], columns["v_C_y"])
    own = {"omega_2": columns["omega_2"], "‖v_C‖": speed, "M_1": columns["M_1"]}
    with chromium() as browser:
        page = browser.new_page(viewport={"width": 1280, "height": 1000})
        page.goto(lesson_written(tmp_path, ROOT / "samples" / "six-link.yaml"))
        page.locator("#curves summary").click()
        for name, values in own.items():
            page.select_option("#curved", value=name)
            until(page, f"curveOf().name === {name!r}")
            rows = [numpy.nan if v is None else v for v in page.evaluate("curveOf().rows")]
            numpy.testing.assert_allclose(rows, values, rtol=1e-6, atol=1e-9)
        before = page.evaluate("document.querySelector('#curve .run').getAttribute('d')")
        page.evaluate("live.set({ l_BC: 0.31 }); draw()")
        assert page.evaluate("document.querySelector('#curve .run').getAttribute('d')") != before
        at = page.evaluate("+document.querySelector('#curve .cursor').getAttribute('x1')")
        page.evaluate("turn(200)")
        until(page, f"+document.querySelector('#curve .cursor').getAttribute('x1') > {at}")
        assert page.evaluate("live.drive") == pytest.approx(200)
