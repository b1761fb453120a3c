"""The command line: what goes to stdout and stderr, exit statuses, and the object printed with --json."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from planes.cli import main
from tests.helpers import ROOT

SAMPLES = ROOT / "samples"
SIX, CRANK, SLIDING = (str(SAMPLES / f"{n}.yaml") for n in ("six-link", "kind-2-rrp", "sliding-driver"))
MODULE = [sys.executable, "-m", "planes"]
Run = Callable[..., tuple[int, str, str]]


@pytest.fixture
def cli(capsys: pytest.CaptureFixture[str]) -> Run:
    """The command in this process: (exit status, stdout, stderr)."""

    def run(*argv: str) -> tuple[int, str, str]:
        try:
            status = main(argv)
        except SystemExit as stop:
            status = int(stop.code or 0)
        said = capsys.readouterr()
        return status, said.out, said.err

    return run


@pytest.fixture
def write(tmp_path: Path) -> Callable[..., str]:
    """A scene file made from a sample by one change (or from a text of its own)."""

    def make(old: str = "", new: str = "", text: str | None = None) -> str:
        source = Path(SIX).read_text(encoding="utf-8") if text is None else text
        assert old in source
        path = tmp_path / "scene.yaml"
        path.write_text(source.replace(old, new, 1) if old else source, encoding="utf-8")
        return str(path)

    return make


def outside(*argv: str) -> subprocess.CompletedProcess[str]:
    """The command as a process of its own."""
    return subprocess.run([*MODULE, *argv], capture_output=True, text=True, encoding="utf-8", check=False)


def refused(said: tuple[int, str, str]) -> str:
    """Bad input: nothing on stdout, one line on stderr, exit status 2; the line."""
    status, out, err = said
    assert (status, out) == (2, "") and err.endswith("\n") and err.count("\n") == 1, said
    assert "Traceback" not in err
    return err


def solved(said: tuple[int, str, str]) -> dict[str, Any]:
    """The object printed with --json."""
    status, out, err = said
    assert status == 0 and out.count("\n") == 1, err

    def never(text: str) -> None:
        raise AssertionError(text)

    found: dict[str, Any] = json.loads(out, parse_constant=never)
    return found


# what is printed


def test_tables_in_both_languages(cli: Run) -> None:
    status, out, err = cli("solve", SIX, "--lang", "ru")
    assert (
        (status, err) == (0, "") and "Шестизвенный" in out and "I(6;1) -> II(2;3) -> II(4;5)" in out and "F_56" in out
    )
    assert all(word in out for word in ("287,2", "Точки", "план скоростей", "Н·м", "По рычагу Жуковского"))
    status, out, err = cli("solve", SIX, "--lang", "en")
    assert (status, err) == (0, "") and "Six-link" in out and "velocity polygon" in out and "N·m" in out
    assert not any("а" <= c.lower() <= "я" for c in out)


def test_the_command_as_a_process() -> None:
    done = outside("solve", SIX, "--lang", "en")
    assert done.returncode == 0 and done.stderr == "" and "Six-link" in done.stdout
    done = outside("solve", str(SAMPLES / "nowhere.yaml"))
    assert done.returncode == 2 and done.stdout == "" and done.stderr.count("\n") == 1


def keys(node: Any, *, of: str = "") -> Any:
    """The keys of an object, recursively; tables keyed by names of the scene become one entry "*"."""
    if isinstance(node, list):
        return [keys(node[0])] if node and isinstance(node[0], dict) else type(node[0]).__name__ if node else "list"
    if not isinstance(node, dict):
        return type(node).__name__
    if of in ("points", "links", "slides", "reactions", "plans", "segments", "sharpness"):
        found = [keys(value) for value in node.values()]
        return {"*": [f for i, f in enumerate(found) if f not in found[:i]]}
    return {key: keys(value, of=key) for key, value in node.items()}


SEGMENT = {"mm": "float", "value": "float", "unit": "str", "error_mm": "float", "name": "str"}
POSITION = {
    "points": {"*": [{"r": "float", "v": "float", "a": "float"}]},
    "links": {"*": [{"angle_deg": "float", "omega": "float", "epsilon": "float"}]},
    "slides": {"*": [{"guide": "str", "v": "float", "a": "float", "coriolis": "float"}]},
    "plans": {"*": [{"mu": "str", "segments": {"*": [SEGMENT]}, "sharpness": {"*": ["float"]}}]},
}


def test_json_has_exactly_the_agreed_keys(cli: Run) -> None:
    found = solved(cli("solve", SIX, "--json"))
    assert found.pop("failed", []) == [] and set(found) == {"planes", "scene", "variant", "structure", "positions"}
    assert found["planes"] == 1 and Path(found["scene"]).name == "six-link.yaml" and found["variant"] is None
    assert found["structure"] == {
        "W": 1,
        "q": 6,
        "formula": "I(0;1) -> II(2;3) -> II(4;5)",
        "groups": [{"links": ["2", "3"], "kind": 1, "name": "RRR"}, {"links": ["4", "5"], "kind": 4, "name": "PRP"}],
    }
    (position,) = found["positions"]
    forces = {"reactions", "loads", "balancing_moment", "zhukovsky_moment"}
    assert set(position) == {*POSITION, "phi_deg", "transfers", *forces, "warnings"}
    for part, want in POSITION.items():
        got = keys(position[part], of=part)
        if part == "plans":
            plans = [p for p in position[part].values() if p["sharpness"]]
            assert plans and [keys(p["segments"], of="segments") for p in plans] == [{"*": [SEGMENT]}] * len(plans)
            assert all(set(p) == {"mu", "segments", "sharpness"} for p in position[part].values())
            continue
        assert got == want, part
    assert position["phi_deg"] == 150.0 and position["warnings"] == []
    assert set(position["links"]) == {"1", "2", "3", "4", "5"} and set(position["slides"]) == {"4", "5"}
    assert {"velocity", "acceleration", "force:4-5", "force:2-3", "force:1"} <= set(position["plans"])
    segment = position["plans"]["velocity"]["segments"]["pc"]
    assert segment["name"] == "v_C" or segment["name"].startswith("v_C")
    assert segment["mm"] == pytest.approx(72.114, abs=1e-3) and segment["unit"] == "m/s"
    assert position["plans"]["velocity"]["mu"] == "30 mm/(m/s)"


def test_reactions_are_named_once_with_the_later_link_first(cli: Run) -> None:
    (position,) = solved(cli("solve", SIX, "--json"))["positions"]
    assert set(position["reactions"]) == {"F_21", "F_32", "F_30", "F_42", "F_54", "F_50", "F_10"}
    for name in ("F_42", "F_50"):
        assert set(position["reactions"][name]) == {"force", "arm", "moment"}
    for name in ("F_21", "F_32", "F_30", "F_54", "F_10"):
        assert len(position["reactions"][name]) == 2


def test_a_sliding_driver_has_its_own_keys(cli: Run) -> None:
    found = solved(cli("solve", SLIDING, "--json", "--s", "0.1:0.2:0.05"))
    assert [p["s"] for p in found["positions"]] == pytest.approx([0.1, 0.15, 0.2])
    for position in found["positions"]:
        assert {"balancing_force", "zhukovsky_force"} <= set(position)
        assert not {"phi_deg", "balancing_moment"} & set(position)


def test_find_keeps_only_what_was_asked(cli: Run, write: Callable[..., str]) -> None:
    scene = write("gravity: 9.81", "gravity: 9.81\nfind: [v_C, a_H, omega_2, F_21, M_1]")
    (position,) = solved(cli("solve", scene, "--json"))["positions"]
    (whole,) = solved(cli("solve", SIX, "--json"))["positions"]
    assert position["points"] == {"C": {"v": whole["points"]["C"]["v"]}, "H": {"a": whole["points"]["H"]["a"]}}
    assert position["links"] == {"2": {"omega": whole["links"]["2"]["omega"]}}
    assert set(position["reactions"]) == {"F_21"} and "slides" not in position
    assert position["balancing_moment"] == pytest.approx(-287.1734174082857)
    assert "zhukovsky_moment" not in position
    assert cli("solve", scene, "--lang", "en")[0] == 0
    err = refused(cli("solve", write("gravity: 9.81", "gravity: 9.81\nfind: [v_Q]")))
    assert "v_Q" in err and "v_C" in err and f"scene.yaml:{line_of(scene, 'find')}" in err


def line_of(path: str, word: str) -> int:
    lines = Path(path).read_text(encoding="utf-8").splitlines()
    return next(i for i, line in enumerate(lines, 1) if line.startswith(word))


# positions


@pytest.mark.parametrize(
    ("asked", "values"),
    [
        ("0:90:30", [0, 30, 60, 90]),
        ("0:100:30", [0, 30, 60, 90]),
        ("10", [10]),
        ("1e1", [10]),
        ("90:0:-45", [90, 45, 0]),
        ("0:0.3:0.1", [0, 0.1, 0.2, 0.3]),
        ("5:5:1", [5]),
    ],
)
def test_ranges_include_their_end(cli: Run, asked: str, values: list[float]) -> None:
    found = solved(cli("solve", CRANK, "--json", "--phi", asked))
    assert [p["phi_deg"] for p in found["positions"]] == pytest.approx(values)


@pytest.mark.parametrize(("option", "values"), [("--phi=-90", [-90]), ("--phi=-90:-30:30", [-90, -60, -30])])
def test_negative_angles(cli: Run, option: str, values: list[float]) -> None:
    found = solved(cli("solve", CRANK, "--json", option))
    assert [p["phi_deg"] for p in found["positions"]] == values


def test_a_whole_turn_has_both_ends(cli: Run) -> None:
    found = solved(cli("solve", CRANK, "--json", "--phi", "0:360:30"))
    first, last = found["positions"][0], found["positions"][-1]
    assert len(found["positions"]) == 13
    assert first["balancing_moment"] == pytest.approx(last["balancing_moment"], rel=1e-9)


@pytest.mark.parametrize("asked", ["0:10:0", "10:0:1", "0:360", "a", "", "nan", "inf", "0:1:nan", "1:2:3:4", "0,5"])
def test_bad_ranges(cli: Run, asked: str) -> None:
    assert "phi" in refused(cli("solve", CRANK, "--json", f"--phi={asked}"))


@pytest.mark.parametrize(
    "argv", [(SIX, "--s", "0.1"), (SLIDING, "--phi", "30"), (str(SAMPLES / "vectors.yaml"), "--phi", "30")]
)
def test_a_drive_of_the_other_kind(cli: Run, argv: tuple[str, ...]) -> None:
    assert argv[1] in refused(cli("solve", *argv))


def test_failed_positions_are_told_and_the_others_come_out(cli: Run) -> None:
    status, out, err = cli("solve", SIX, "--json", "--phi", "90:150:30", "--lang", "en")
    found = json.loads(out)
    assert status == 0 and [p["phi_deg"] for p in found["positions"]] == [150]
    assert [f["phi_deg"] for f in found["failed"]] == [90, 120] and set(found["failed"][0]) == {"phi_deg", "error"}
    assert err.splitlines() == [f"{SIX}: {f['error']}" for f in found["failed"]]
    assert "90°" in err and "mm" in err and "C" in err
    status, out, err = cli("solve", SIX, "--phi", "90:150:30", "--lang", "ru")
    assert status == 0 and "φ = 150°" in out and err.count("\n") == 2 and "мм" in err


def test_all_positions_failed(cli: Run) -> None:
    status, out, err = cli("solve", SIX, "--json", "--phi", "0:60:30")
    assert status == 2 and err.count("\n") == 3
    found = json.loads(out)
    assert found["positions"] == [] and len(found["failed"]) == 3
    status, out, err = cli("solve", SIX, "--phi", "0")
    assert (status, out) == (2, "") and err.count("\n") == 1


# variants and structure


def test_variants(cli: Run) -> None:
    scene = str(SAMPLES / "assignment-12.yaml")
    found = solved(cli("solve", scene, "--json", "--variant", "Б"))
    assert found["variant"] == "Б" and found["positions"][0]["phi_deg"] == 120
    assert found["positions"][0]["links"]["1"] == {"angle_deg": pytest.approx(120), "omega": 16, "epsilon": 70}
    err = refused(cli("solve", scene, "--variant", "Щ"))
    assert '"Щ"' in err and "А, Б, В, Г, Д, Е" in err
    assert "no variants" in refused(cli("solve", SIX, "--variant", "А"))


def test_structure(cli: Run) -> None:
    status, out, err = cli("structure", SIX, "--lang", "en")
    assert (status, err) == (0, "") and all(t in out for t in ("W = 1", "q = 6", "RRR", "PRP", "II(4;5)"))
    assert "вид 4" in cli("structure", SIX, "--lang", "ru")[1]
    status, out, err = cli("structure", SIX, "--json")
    found = json.loads(out)
    variant = found.pop("self_aligning")
    assert found == solved(cli("solve", SIX, "--json"))["structure"]
    assert (variant["W"], variant["q"], variant["p5"], variant["p4"], variant["p3"]) == (1, 0, 2, 4, 1)
    assert {"pair": "C", "links": ["2", "3"], "kind": "spherical", "freedoms": 3} in variant["pairs"]
    assert "vectors" in refused(cli("structure", str(SAMPLES / "vectors.yaml")))


def test_vectors_alone(cli: Run) -> None:
    scene = str(SAMPLES / "vectors.yaml")
    status, out, err = cli("solve", scene, "--lang", "en")
    assert (status, err) == (0, "") and "v_CB" in out and "84.53" in out
    found = solved(cli("solve", scene, "--json"))
    assert found["planes"] == 1 and found["vectors"]["v_C"]["value"] == pytest.approx(2.8176641056)


# bad input

BAD = [
    ("mass: 60", "weight: 60", "weight"),
    ("omega: -20", "omega: nan", "omega"),
    ("omega: -20", "omega: 0,5", "decimal"),
    ("slides: CL", "slides: CM", "CM"),
    ("phi: phi_1", "phi: phi_2", "phi_2"),
    ("l_AB: 0.1", "l_AB: l_AB", "l_AB"),
    ("mu: 30 mm/(m/s)", "mu: 30 mm/N", "mm/N"),
    ("assembly: {C: right}", "assembly: {C: up}", "up"),
    ("assembly: {C: right}", "", "right"),
    ("gravity: 9.81", "gravity: 9.81\ngravity: 1", "gravity"),
    ("planes: 1", "planes: 2", "2"),
    ("point: H", "point: K", "K"),
    ("link: 5, point", "link: 7, point", "7"),
    ("phi: phi_1", "phi: 1/0", "phi"),
    ("frame:", "frame: {", ""),
    ("5: {points: {H: 0}, slides: y-y, mass: 50}", "5: {points: {H: 0}, mass: 50}", "W"),
]


@pytest.mark.parametrize(("old", "new", "word"), BAD)
def test_bad_scenes_are_refused_in_one_line_with_their_place(
    cli: Run, write: Callable[..., str], old: str, new: str, word: str
) -> None:
    path = write(old, new)
    for command in (("solve",), ("solve", "--json"), ("structure",)):
        if command == ("structure",) and (word in ("right",) or new.endswith("up}")):
            continue
        err = refused(cli(command[0], path, *command[1:]))
        assert word in err and path in err
        place = err[err.index(path) + len(path) :].split(":")
        assert place[1].isdigit(), err


@pytest.mark.parametrize("text", ["", "\n\n", "null", "[1, 2]", "a: &x 1\nb: *x", "\t- a", "planes: 1", "{" * 3000])
def test_files_that_are_no_scenes(cli: Run, write: Callable[..., str], text: str) -> None:
    refused(cli("solve", write(text=text)))


def test_missing_files_and_folders(cli: Run, tmp_path: Path) -> None:
    for command in ("solve", "structure"):
        assert "no such file" in refused(cli(command, str(tmp_path / "none.yaml")))
        assert "folder" in refused(cli(command, str(tmp_path)))
    (tmp_path / "bytes.yaml").write_bytes(b"planes: 1\nnote: \xff\xfe")
    assert "bytes.yaml:2" in refused(cli("solve", str(tmp_path / "bytes.yaml")))


@pytest.mark.parametrize(
    "argv", [(), ("solve",), ("nothing", SIX), ("solve", SIX, "--lang", "de"), ("solve", SIX, "--what")]
)
def test_wrong_options(cli: Run, argv: tuple[str, ...]) -> None:
    status, out, err = cli(*argv)
    assert status == 2 and out == "" and "usage" in err


# pencil and what is loaded


def test_a_pencil_errs_and_says_by_how_much(cli: Run) -> None:
    first, again, other = (solved(cli("solve", CRANK, "--json", "--pencil", "--seed", seed)) for seed in "117")
    assert first == again != other
    exact = solved(cli("solve", CRANK, "--json"))["positions"][0]["plans"]["velocity"]["segments"]
    for key, drawn in first["positions"][0]["plans"]["velocity"]["segments"].items():
        assert abs(drawn["mm"] - exact[key]["mm"]) < 6 * drawn["error_mm"] + 0.5 and 0 < drawn["error_mm"] < 3
    assert first["positions"][0]["points"] != solved(cli("solve", CRANK, "--json"))["positions"][0]["points"]


def loaded(argv: list[str]) -> Iterator[str]:
    program = (
        "import sys, io, contextlib; from planes.cli import main\n"
        f"with contextlib.redirect_stdout(io.StringIO()): status = main({argv!r})\n"
        "print(status, *sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    status, *modules = done.stdout.split()
    assert status == "0"
    yield from modules


@pytest.mark.few(2)
@pytest.mark.parametrize(
    "argv",
    [
        ["solve", SIX],
        ["solve", SIX, "--json"],
        ["structure", SIX],
        ["solve", str(SAMPLES / "vectors.yaml")],
        ["solve", CRANK, "--phi", "0:360:30"],
    ],
)
def test_solving_loads_nothing_heavy(argv: list[str]) -> None:
    heavy = {"numpy", "matplotlib", "shapely", "reportlab", "svgwrite", "scipy", "mpmath", "ezdxf", "render"}
    assert not heavy & {name.partition(".")[0] for name in loaded(argv)}


def test_a_sheet_is_told_at_the_end_with_its_format_and_size(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = str(tmp_path / "six-link.pdf")
    assert main(["sheet", SIX, "-o", file, "--lang", "en"]) == 0
    remark = r"Remark: a_C, a_S2, .*, a_4, v_5, a_5: drawn by hand, .* of their value: a short vector, or .*\n"
    assert re.fullmatch(rf"{file} written: A2, 594 × 420 mm, [0-9]+ kB\n{remark}", capsys.readouterr().err)
    assert main(["sheet", SIX, "--view", "velocity-plan", "-o", str(tmp_path / "v.svg"), "--lang", "ru"]) == 0
    assert re.search(r"^записан .*v\.svg: [0-9]+ × [0-9]+ мм, [0-9]+ кБ\n$", capsys.readouterr().err)
