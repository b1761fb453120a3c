"""ruff, its layout too, and mypy --strict are clean, on both packages and on what tests share."""

from __future__ import annotations

import subprocess
import sys

import pytest

from tests.helpers import ROOT


@pytest.mark.parametrize(
    "tool",
    [
        ["ruff", "check", "."],
        ["ruff", "format", "--check", "planes", "render", "tests"],
        pytest.param(["mypy"], marks=pytest.mark.slow),
    ],
    ids=["ruff", "format", "mypy"],
)
def test_tool_is_clean(tool: list[str]) -> None:
    done = subprocess.run([sys.executable, "-m", *tool], cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout[-4000:] + done.stderr[-2000:]
