"""The tracing-paper page in a real browser: a picture is opened in it, the plan is laid over it, nothing is sent."""

from __future__ import annotations

import json
import shlex
import struct
import zlib
from pathlib import Path
from typing import Any

import pytest

from planes.cli import main
from tests.helpers import ROOT
from tests.helpers.browser import until, watched

SIX = str(ROOT / "samples" / "six-link.yaml")
WIDE = {"width": 1200, "height": 900}
MARKS = {"b": 30 + 51.9615j, "c": 71.6 - 8.18j}
POLE, TURN = 500 + 900j, 8 * (0.9962 + 0.0872j)  # of the picture's pixels, y down; turned by five degrees


@pytest.fixture(scope="module")
def trace(tmp_path_factory: pytest.TempPathFactory) -> Path:
    target = tmp_path_factory.mktemp("trace") / "trace.html"
    assert main(["check", SIX, "--plan", "velocity", "--trace", "-o", str(target), "--lang", "en"]) == 0
    return target


def png(file: Path, width: int = 1600, height: int = 1400) -> None:
    """A white picture."""

    def chunk(name: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    rows = (b"\0" + b"\xff" * width) * height
    head = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
    parts = chunk(b"IHDR", head), chunk(b"IDAT", zlib.compress(rows)), chunk(b"IEND", b"")
    file.write_bytes(b"\x89PNG\r\n\x1a\n" + b"".join(parts))


def on_picture(z: complex) -> complex:
    """Where a place of the plan is on the picture."""
    return POLE + TURN * z.conjugate()


def drag(page: Any, name: str, to: complex) -> None:
    """Drag a handle to a pixel of the picture."""
    box = page.locator("#sheet").bounding_box()
    zoom, start = page.evaluate("sheet.zoom"), page.evaluate(f"sheet.px(sheet.at({name!r}))")
    page.mouse.move(box["x"] + start[0], box["y"] + start[1])
    page.mouse.down()
    page.mouse.move(box["x"] + to.real * zoom, box["y"] + to.imag * zoom, steps=4)
    page.mouse.up()


@pytest.mark.slow
def test_two_handles_lay_the_plan_over_a_picture(browser: Any, trace: Path, tmp_path: Path) -> None:
    page = browser.new_page()
    errors = watched(page)
    page.goto(trace.as_uri())
    picture = tmp_path / "my plan.png"
    png(picture)
    page.set_input_files("#file", str(picture))
    until(page, "state.size[0] === 1600 && !document.getElementById('image').hidden")
    page.select_option("#by", "b")
    drag(page, "p", POLE)
    drag(page, "b", on_picture(MARKS["b"]))
    x, y = (v / page.evaluate("sheet.zoom") for v in page.evaluate("sheet.px(sheet.at('c'))"))
    assert abs(complex(x, y) - on_picture(MARKS["c"])) < 8
    said = page.inner_text("#said")
    assert "−5." in said or "−4.9" in said
    words = shlex.split(page.inner_text("#command"))
    assert words[:4] == ["planes", "check", SIX, "my plan.png"]
    at = [complex(*map(float, w.rpartition("=")[2].split(","))) for w in (words[-3], words[-1])]
    assert words[-4::2] == ["--pole", "--mark"] and words[-1].startswith("b=")
    assert abs(at[0] - POLE) <= 2 and abs(at[1] - on_picture(MARKS["b"])) <= 2
    page.close()
    assert [e for e in errors if not e.startswith("blob:")] == []


def test_keys_layers_and_other_plans(browser: Any, trace: Path) -> None:
    page = browser.new_page()
    errors = watched(page)
    page.goto(trace.as_uri())
    page.focus('[data-mark="p"]')
    before = page.evaluate("state.pole")
    page.keyboard.press("ArrowRight")
    page.keyboard.press("Shift+ArrowUp")
    assert page.evaluate("state.pole") == pytest.approx([before[0] + 1, before[1] - 10])
    assert page.locator(".arrow.ink").count() > 4 and page.locator(".label").count() > 4
    page.uncheck("#ink")
    page.uncheck("#names")
    assert page.locator(".arrow.ink").count() == page.locator(".label").count() == 0
    page.check("#ink")
    keys = page.evaluate("data.plans.map(p => p.key)")
    assert keys[0] == "velocity" and {"position", "acceleration", "force:2-3"} <= set(keys)
    for key in keys:
        page.select_option("#plan", key)
        assert page.locator(".ink").count() > 2 and page.locator(".handle").count() == 2, key
        assert "NaN" not in page.inner_html("#sheet")
    page.evaluate("document.getElementById('zoom').value = 300; lay()")
    wide, seen = (page.evaluate(f"document.querySelector('.table').{k}Width") for k in ("scroll", "client"))
    assert wide > 2 * seen
    page.close()
    assert errors == []


def test_a_file_that_is_no_picture_is_said(browser: Any, trace: Path, tmp_path: Path) -> None:
    page = browser.new_page()
    page.goto(trace.as_uri())
    file = tmp_path / "x.png"
    file.write_text(json.dumps([1]))
    page.set_input_files("#file", str(file))
    until(page, "document.getElementById('said').textContent.includes('does not open')")
    page.close()


def test_nothing_is_loaded_from_elsewhere(trace: Path) -> None:
    text = trace.read_text(encoding="utf-8").replace("http://www.w3.org", "")
    assert "http:" not in text and "https:" not in text and "fetch(" not in text


def test_the_drawing_and_the_page_exclude_each_other(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    page = str(tmp_path / "t.html")
    assert main(["check", SIX, "x.csv", "--plan", "velocity", "--trace", "-o", page, "--lang", "en"]) == 2
    assert main(["check", SIX, "--plan", "velocity", "--trace", "--lang", "en"]) == 2
    assert main(["check", SIX, "--plan", "velocity", "--lang", "en"]) == 2
    told = capsys.readouterr().err.splitlines()
    assert len(told) == 3 and "tracing paper" in told[0] and "no drawing" in told[2]
