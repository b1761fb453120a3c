"""Machine code is kept between processes, and whatever is wrong with a kept file it is compiled anew."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from planes.batch import compiled, kept_code
from planes.batch.cycle import Cycle
from planes.plans import plans_of
from planes.scene import load
from tests.helpers import ROOT

pytestmark = pytest.mark.needs("llvmlite")
VALUES = np.linspace(150.0, 500.0, 40)


@pytest.fixture
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("PLANES_CACHE", str(tmp_path / "code"))
    compiled._compiled_run_function.cache_clear()
    return tmp_path / "code"


def table() -> np.ndarray:
    """A few positions by machine code."""
    compiled._compiled_run_function.cache_clear()
    scene = load(str(ROOT / "samples" / "kind-2-rrp.yaml"))
    (block,) = Cycle(plans_of(scene.mechanism)).blocks(VALUES, fast=True)
    return np.array(block.table)


def test_what_was_compiled_once_is_not_compiled_again(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    first = table()
    assert len(list(home.iterdir())) == 1
    monkeypatch.setattr(compiled, "_make_object_file", lambda *_: pytest.fail("compiled again"))
    assert np.array_equal(table(), first, equal_nan=True)


@pytest.mark.parametrize("harm", [lambda data: data[:-1], lambda data: b"", lambda data: data[:50] + b"?" + data[51:]])
def test_a_file_that_is_not_whole_is_made_anew(home: Path, harm: object) -> None:
    first = table()
    (file,) = home.iterdir()
    whole = file.read_bytes()
    file.write_bytes(harm(whole))  # type: ignore[operator]
    assert np.array_equal(table(), first, equal_nan=True) and file.read_bytes() == whole


def test_nothing_is_kept_where_nothing_can_be_or_is_to_be(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (taken := tmp_path / "file").write_text("", "utf-8")
    for told in ("off", str(taken)):
        monkeypatch.setenv("PLANES_CACHE", told)
        assert np.isfinite(table()).any()
    assert [f.name for f in tmp_path.iterdir()] == ["file"] and not taken.read_bytes()


def test_the_longest_unused_go(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(kept_code, "MOST_KEPT_FILES", 2)
    for name in "abc":
        kept_code.keep_object_file(name, name.encode())
    assert len(list(home.iterdir())) == 2 and kept_code.kept_object_file("c") == b"c"
