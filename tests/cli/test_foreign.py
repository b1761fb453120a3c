"""Another project's package of the same name on the path; the number of the version."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

import planes
from tests.helpers import ROOT


@pytest.mark.parametrize(("lang", "words"), [("en", "the drawing part of planes"), ("ru", "чертёжная часть planes")])
@pytest.mark.parametrize("name", ["render/__init__.py", "render.py"])
def test_somebody_elses_render_is_one_sentence_with_its_path(tmp_path: Path, name: str, lang: str, words: str) -> None:
    theirs = tmp_path / name
    theirs.parent.mkdir(exist_ok=True)
    theirs.write_text("raise SystemExit('it was run')\n", "utf-8")
    argv = ["sheet", str(ROOT / "samples/kind-1-rrr.yaml"), "-o", str(tmp_path / "s.svg"), "--lang", lang]
    way = [str(tmp_path), str(ROOT)]
    program = f"import sys; sys.path[:0] = {way}; from planes.cli import main; sys.exit(main({argv}))"
    done = subprocess.run([sys.executable, "-c", program], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 2 and done.stdout == "" and done.stderr.count("\n") == 1
    assert done.stderr.startswith(words) and str(theirs) in done.stderr
    assert not (tmp_path / "s.svg").exists()


def test_the_version_is_told(capsys: pytest.CaptureFixture[str]) -> None:
    from planes.cli import main

    with pytest.raises(SystemExit) as left:
        main(["--version"])
    assert left.value.code == 0 and capsys.readouterr().out == f"planes {planes.__version__}\n"
