"""Modules of the pages are read by TypeScript: every name is somebody's, everything is asked as what it is."""

from __future__ import annotations

import os
import shutil
import subprocess

import pytest

from tests.helpers import ROOT


@pytest.mark.slow
def test_modules_of_the_pages_hold_together() -> None:
    compiler = os.environ.get("TSC") or shutil.which("tsc")
    if not compiler:
        pytest.skip("no TypeScript here: npm install -g typescript, or name its tsc in TSC")
    told = subprocess.run([compiler, "-p", ROOT / "render" / "page"], capture_output=True, text=True)
    assert told.stdout + told.stderr == ""
