"""Builds the wheel with setuptools. In the source the renderer is the folder ``render``, in the wheel it is the package
``planes.render``: no package of another project can take its name, nor it theirs.
"""

from __future__ import annotations

import contextlib
import re
import shutil
import tempfile
from pathlib import Path
from typing import Any

from setuptools import build_meta
from setuptools.build_meta import (
    build_editable,
    build_sdist,
    get_requires_for_build_editable,
    get_requires_for_build_sdist,
    get_requires_for_build_wheel,
    prepare_metadata_for_build_editable,
)

__all__ = [
    "build_editable",
    "build_sdist",
    "build_wheel",
    "get_requires_for_build_editable",
    "get_requires_for_build_sdist",
    "get_requires_for_build_wheel",
    "prepare_metadata_for_build_editable",
]

FILES = ("pyproject.toml", "README.md", "LICENSE", ".ci/build_backend.py")
IMPORT = re.compile(r"^(\s*(?:from|import)\s+)render\b", re.MULTILINE)
NAME = re.compile(r"""(["'(]|\bf["'])render(?=\.[a-z_{]|["'])""")
"""The package in a text: ``files("render")``, ``import_module(f"render.report.{suffix}")``."""


def build_wheel(wheel_directory: str, config_settings: Any = None, metadata_directory: str | None = None) -> str:
    """The wheel of a copy of the source in which ``render`` lies within ``planes``."""
    target = Path(wheel_directory).resolve()
    with tempfile.TemporaryDirectory() as folder, contextlib.chdir(copied(Path.cwd(), Path(folder))):
        return str(build_meta.build_wheel(str(target), config_settings))


def copied(source: Path, copy: Path) -> Path:
    """The source as the wheel has it."""
    unwanted = shutil.ignore_patterns("__pycache__", "*.pyc")
    shutil.copytree(source / "planes", copy / "planes", ignore=unwanted)
    shutil.copytree(source / "render", copy / "planes" / "render", ignore=unwanted)
    for name in FILES:
        (copy / name).parent.mkdir(exist_ok=True)
        shutil.copy(source / name, copy / name)
    for file in (copy / "planes").rglob("*.py"):
        text = file.read_text("utf-8")
        file.write_text(NAME.sub(r"\1planes.render", IMPORT.sub(r"\1planes.render", text)), "utf-8")
    ours = copy / "planes" / "documents" / "ours.py"
    ours.write_text('"""In a wheel no other package can stand in for the renderer."""\n', "utf-8")
    about = copy / "pyproject.toml"
    settings = about.read_text("utf-8")
    about.write_text(re.sub(r"^render = (?=\[)", '"planes.render" = ', settings, flags=re.MULTILINE), "utf-8")
    return copy
