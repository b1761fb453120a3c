"""What one begins with: templates that solve at once, schemas, completions, ``-`` for a pipe, Latin variants."""

from __future__ import annotations

import io
import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

from planes import load, loads, solve
from planes.cli import main
from planes.cli.start import TEMPLATE_FOLDER, TEMPLATES_BY_GROUP_KIND, template_in_language, template_names
from planes.documents.schema import json_schema
from planes.plans import structure_of
from planes.words import available_languages
from planes.words.errors import SceneError
from tests.helpers import ROOT

SCENES = sorted(f.stem for f in TEMPLATE_FOLDER.glob("*.yaml") if f.stem not in ("course", "vectors"))
TWELVE = ROOT / "samples" / "assignments" / "12.yaml"


@pytest.mark.parametrize("name", SCENES)
def test_a_template_solves_at_once_and_is_told_in_both_languages(name: str) -> None:
    text = (TEMPLATE_FOLDER / f"{name}.yaml").read_text("utf-8")
    scene = load(TEMPLATE_FOLDER / f"{name}.yaml")
    assert not scene.doubts and scene.title["ru"] != scene.title["en"]
    assert abs(solve(scene).value("M_1" if scene.mechanism else "R_A")) > 0.01
    for line in (line for line in text.splitlines() if " # " in line):
        remark = line.partition(" # ")[2]
        assert "--" in remark or " / " in remark, remark


@pytest.mark.parametrize(("kind", "name"), TEMPLATES_BY_GROUP_KIND.items())
def test_the_template_of_a_kind_has_that_group(kind: str, name: str) -> None:
    scene = load(TEMPLATE_FOLDER / f"{name}.yaml")
    assert scene.mechanism
    assert [g.pair_letters for g in structure_of(scene.mechanism, "x").groups] == [kind.upper()]


def test_the_quick_returns_are_quick_returns() -> None:
    """Whitworth's lever turns all round; that of the shaper swings."""
    for name, round_ in (("whitworth", True), ("shaper", False)):
        scene = load(TEMPLATE_FOLDER / f"{name}.yaml")
        rates = [solve(scene, phi=float(phi)).omega["3"] for phi in range(0, 360, 15)]
        assert (min(rates) * max(rates) > 0) == round_


def test_new_writes_and_leaves_what_is_there(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "my.yaml"
    assert main(["new", "four-bar", "-o", str(file)]) == 0
    before = file.read_text("utf-8")
    assert main(["new", "shaper", "-o", str(file), "--lang", "en"]) == 2
    assert file.read_text("utf-8") == before and "was not changed" in capsys.readouterr().err
    assert main(["new", "fourbar", "--lang", "en"]) == 2 and "did you mean four-bar" in capsys.readouterr().err
    assert main(["new", "--lang", "ru"]) == 0
    listed = capsys.readouterr().out
    assert all(name in listed for name in template_names()) and "Синусный механизм" in listed


@pytest.mark.parametrize("file", sorted(TEMPLATE_FOLDER.glob("*.yaml")), ids=lambda f: f.stem)
def test_a_template_is_told_in_one_language(file: Path) -> None:
    """Its remarks and its title; what it says to the program is the same."""
    text = file.read_text("utf-8")
    english, russian, *others = (template_in_language(text, lang) for lang in ("en", "ru", "uk", "be"))
    assert not re.search("[а-яё]", english, re.I) and "# " in english
    assert re.search("[а-яё]", russian) and " / " not in russian + english
    for other, foreign in zip(others, ("[ыэёъ]", "[ищъ]"), strict=True):
        assert other.count("\n") == russian.count("\n") and not re.search(foreign, other, re.I)
    if file.stem != "course":
        whole = loads(text)
        for said, lang in ((english, "en"), (russian, "ru")):
            assert loads(said).mechanism == whole.mechanism and loads(said).title[lang] == whole.title[lang]


def test_new_makes_the_folder(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A folder takes the scene, and the course, under the names the course asks for."""
    for name, output in (("four-bar", "made/here/my.yaml"), ("four-bar", "hw/"), ("course", "hw")):
        assert main(["new", name, "-o", str(tmp_path) + "/" + output]) == 0
    made = {file.relative_to(tmp_path).as_posix() for file in tmp_path.rglob("*.yaml")}
    assert made == {"made/here/my.yaml", "hw/scene.yaml", "hw/course.yaml"}
    assert main(["new", "four-bar", "-o", f"{tmp_path}/hw/scene.yaml/my.yaml", "--lang", "en"]) == 2
    assert "cannot be written" in capsys.readouterr().err


@pytest.mark.parametrize(("name", "kind"), [("four-bar", "scene"), ("course", "course")])
def test_what_is_begun_names_the_schema_beside_it(name: str, kind: str, tmp_path: Path) -> None:
    """An editor finds it, whatever folder the file is moved to with it; one that is there is left alone."""
    assert main(["new", name, "-o", str(tmp_path / "my.yaml"), "--lang", "ru"]) == 0
    first, _, rest = (tmp_path / "my.yaml").read_text("utf-8").partition("\n")
    beside = tmp_path / first.removeprefix("# yaml-language-server: $schema=")
    assert rest == template_in_language((TEMPLATE_FOLDER / f"{name}.yaml").read_text("utf-8"), "ru")
    held = beside.read_text("utf-8")
    assert beside.name == f"{kind}.schema.json" and json.loads(held) == json_schema(kind, "ru")
    beside.write_text("{}", "utf-8")
    assert main(["new", name, "-o", str(tmp_path / "other.yaml"), "--lang", "en"]) == 0
    assert beside.read_text("utf-8") == "{}" and len(list(tmp_path.iterdir())) == 3


@pytest.mark.slow
def test_a_scene_comes_through_a_pipe_and_a_sheet_goes_through_one() -> None:
    text = (TEMPLATE_FOLDER / "four-bar.yaml").read_bytes()
    run = [sys.executable, "-m", "planes"]
    told = subprocess.run([*run, "solve", "-", "--json"], input=text, capture_output=True, check=True).stdout
    assert json.loads(told)["scene"] == "-"
    drawn = subprocess.run([*run, "sheet", "-", "-o", "-.pdf"], input=text, capture_output=True, check=True).stdout
    assert drawn.startswith(b"%PDF-") and drawn.rstrip().endswith(b"%%EOF")
    bad = subprocess.run([*run, "solve", "-", "--lang", "en"], input=b"planes: 2\n", capture_output=True, check=False)
    assert bad.returncode == 2 and bad.stderr.startswith(b"-:1: ")


@pytest.mark.parametrize("shell", ["bash", "zsh", "tcsh"])
def test_completions_know_every_command(shell: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["completion", shell, "--lang", "en"]) == 0
    script = capsys.readouterr().out
    assert all(name in script for name in ("crank-slider", "hodograph", "schema"))
    if shell == "bash":
        subprocess.run(["bash", "-n"], input=script, text=True, check=True)


@pytest.mark.parametrize(
    ("asked", "got"), [("А", "А"), ("A", "А"), ("V", "В"), ("G", "Г"), ("D", "Д"), ("E", "Е"), ("2", "Б"), ("6", "Е")]
)
def test_a_variant_by_its_latin_letter_or_its_number(asked: str, got: str) -> None:
    assert load(TWELVE, asked).variant == got
    assert load(TWELVE, asked).parameters == load(TWELVE, got).parameters


def test_a_latin_letter_of_two_meanings_is_refused() -> None:
    with pytest.raises(SceneError, match=r"may mean Б \(--variant 2\) or В \(--variant 3\)"):
        load(TWELVE, "B")
    with pytest.raises(SceneError, match="no variant"):
        load(TWELVE, "7")


def test_a_clock_is_shown_to_a_person_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    from planes.words import waiting

    class Terminal(io.StringIO):
        def isatty(self) -> bool:
            return True

    monkeypatch.setattr(waiting, "CLOCK_DELAY_S", 0.0)
    monkeypatch.setattr(waiting, "CLOCK_STEP_S", 0.001)
    for stream, shown in ((Terminal(), True), (io.StringIO(), False)):
        monkeypatch.setattr(sys, "stderr", stream)
        with waiting.waiting_clock():
            for _ in range(2000):
                if " s" in stream.getvalue():
                    break
                waiting.Event().wait(0.001 if shown else 0.0)
        assert (" s" in stream.getvalue()) == shown
        assert not shown or stream.getvalue().endswith("\r\033[K")


def test_every_language_has_a_name() -> None:
    assert available_languages()[:2] == ("ru", "en")


def test_every_command_says_which_file_it_wrote(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """In the same words on the standard error: what goes to the standard output may be read by a program."""
    scene = str(ROOT / "samples/kind-1-rrr.yaml")
    for words, name in (
        (["sheet", scene, "--view", "velocity-plan"], "plan.svg"),
        (["lesson", scene], "lesson.html"),
        (["note", scene], "note.html"),
        (["blank", scene, "--plan", "velocity"], "blank.svg"),
        (["cycle", scene, "--phi", "0:30:10"], "turn.csv"),
        (["schema", "scene"], "schema.json"),
        (["new", "four-bar"], "new.yaml"),
    ):
        file = tmp_path / name
        assert main([*words, "-o", str(file), "--lang", "en"]) == 0
        size, told = -(-file.stat().st_size // 1000), capsys.readouterr()
        made = "[0-9]+ × [0-9]+ mm, " if words[0] == "sheet" else ""
        assert re.search(rf"(^|\n){file} written: {made}{size} kB\n$", told.err) and not told.out


@pytest.mark.parametrize(("command", "searches"), [("sheet", False), ("lesson", True)])
def test_a_short_command_is_never_searched_for_cycles(command: str, searches: bool, tmp_path: Path) -> None:
    """Nor is any of its objects when the interpreter ends."""
    out = tmp_path / {"sheet": "made.svg", "lesson": "made.html"}[command]
    code = (
        "import gc, sys; from planes.__main__ import run; began = [];"
        "gc.callbacks.append(lambda phase, _: began.append(phase));"
        f"sys.argv = ['planes', {command!r}, {str(TWELVE)!r}, '-o', {str(out)!r}];"
        "status = run(); print(status, len(began), gc.isenabled(), gc.get_freeze_count() > 50_000)"
    )
    made = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    status, began, enabled, frozen = made.stdout.split()
    assert (status, enabled, frozen) == ("0", str(searches), "True")
    assert searches or began == "0"
