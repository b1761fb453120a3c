"""ruff, its layout too, and mypy --strict are clean, on both packages and on what tests share."""

from __future__ import annotations

import subprocess
import sys

import pytest

from tests.helpers import ROOT


@pytest.mark.parametrize(
    "tool",
    [
        pytest.param(["ruff", "check", "."], marks=pytest.mark.needs("ruff")),
        pytest.param(["ruff", "format", "--check", "."], marks=pytest.mark.needs("ruff")),
        pytest.param(["mypy"], marks=[pytest.mark.slow, pytest.mark.needs("mypy")]),
    ],
    ids=["ruff", "format", "mypy"],
)
def test_tool_is_clean(tool: list[str]) -> None:
    done = subprocess.run([sys.executable, "-m", *tool], cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout[-4000:] + done.stderr[-2000:]
