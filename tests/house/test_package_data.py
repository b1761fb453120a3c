"""Every file that the rooms read beside their modules goes into the wheel."""

from __future__ import annotations

import tomllib
from fnmatch import fnmatch
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LEFT_OUT = {".py", ".pyc", ".md"}


def test_every_data_file_is_named_in_the_package_data() -> None:
    packages = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["tool"]["setuptools"]["package-data"]
    for package, patterns in packages.items():
        files = [f for f in (ROOT / package).rglob("*") if f.is_file() and f.suffix not in LEFT_OUT]
        names = [f.relative_to(ROOT / package).as_posix() for f in files]
        lost = [n for n in names if not any(fnmatch(n, p) and n.count("/") == p.count("/") for p in patterns)]
        assert not lost, package
        unused = [p for p in patterns if not any(fnmatch(n, p) for n in names)]
        assert not unused, package
