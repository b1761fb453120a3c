"""Everything accepted has an effect or is refused by name: options of the commands, keys of a sheet, doubtful input."""

from __future__ import annotations

import dataclasses
import errno
import json
import os
import re
from pathlib import Path

import pytest

from planes.batch.cycle import Cycle
from planes.cli import main
from planes.documents.sheets import sheet_of
from planes.plans import plans_of
from planes.scene import load, loads
from planes.scene.settings import MOST_REVISION_ROWS, SHEET_KEYS
from planes.words import say
from planes.words.errors import PlanesError, SceneError
from render.files import svg
from render.paper.form1 import fill_in_cells
from render.sheet.frame import cell_texts
from tests.helpers import ROOT

SAMPLES = ROOT / "samples"
CRANK, VECTORS, SLIDING = (str(SAMPLES / f"{n}.yaml") for n in ("kind-2-rrp", "vectors", "sliding-driver"))
LAW = """planes: 1
parameters: {l_OA: 0.08, l_AB: 0.3, alpha: 30, beta: 2*alpha, phi_1: 40}
frame: {points: {O: [0, 0]}, guides: {x-x: {y: 0}}}
links:
  1: {points: {O: 0, A: l_OA}}
  2: {points: {A: 0, B: l_AB}}
  3: {points: {B: 0}, slides: x-x}
assembly: {B: ahead}
drive: {link: 1, phi: phi_1, omega: 10}
loads: [{link: 3, point: B, force: "3000*sin(phi_1)", against: motion}]
"""
PLAIN = LAW.replace(", alpha: 30, beta: 2*alpha", "")
SOLVE = [["--json"], ["--pencil"], ["--seed", "4"], ["--explain"], ["--errors"], ["--phi", "20"], ["--s", "0.1"]]
CYCLE = [
    ["--show", "v_B"],
    ["--hodograph", "v_B"],
    ["--path", "B"],
    ["--film"],
    ["--listing"],
    ["--graphical"],
    ["--pole", "30"],
    ["--omega", "3"],
    ["--epsilon", "5"],
    ["--json"],
    ["--errors"],
    ["--hodograph", "F_99"],
    ["--path", "Z"],
    ["--show", ","],
]
CASES = [
    *((["solve", CRANK, *base], option) for base in ([], ["--pencil"], ["--explain"], ["--json"]) for option in SOLVE),
    *((["solve", VECTORS], option) for option in (*SOLVE, ["--remedy"])),
    *(
        (["cycle", CRANK, *base, "--phi", "0:60:20"], option)
        for option in CYCLE
        for base in ([], ["--listing"], ["-o", "t.csv"], ["-o", "t.csv", "--show", "a_B_x"], ["-o", "p.svg"])
    ),
    *(
        (["cycle", CRANK, *base], option)
        for option in (*CYCLE, ["--phi", "0:60:20"])
        for base in (["--graphical", "6"], ["--graphical", "6", "-o", "g.svg"])
    ),
    *(
        (["sheet", VECTORS, "-o", "v.svg"], option)
        for option in (["--sheet", "1"], ["--remedy"], ["--phi", "3"], ["--view", "equations"], ["--text", "strokes"])
    ),
]


def said(argv: list[str], capsys, folder: Path) -> tuple[int, str, str, dict[str, bytes]]:
    """What a command answers: its status, what it prints, and the files it writes."""
    for file in folder.glob("*"):
        file.unlink()
    try:
        status = main(argv)
    except SystemExit as stop:
        status = int(stop.code or 0)
    told = capsys.readouterr()
    return status, told.out, told.err, {f.name: f.read_bytes() for f in folder.glob("*")}


ONCE: dict[tuple[str, ...], tuple[object, ...]] = {}


@pytest.mark.few(25)
@pytest.mark.parametrize(("base", "option"), CASES, ids=lambda x: " ".join(Path(a).name for a in x))
def test_an_option_has_an_effect_or_is_refused(base, option, capsys, tmp_path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    if option[0] in base:
        return
    if tuple(base) not in ONCE:
        ONCE[tuple(base)] = said([*base, "--lang", "en"], capsys, tmp_path)
        assert ONCE[tuple(base)][0] == 0
    status, out, err, files = said([*base, *option, "--lang", "en"], capsys, tmp_path)
    if status == 2:
        assert (out, files) == ("", {}) and err.count("\n") == 1
        assert any(part.strip("-") in err for part in option), err
    else:
        assert (status, out, files) != (ONCE[tuple(base)][0], ONCE[tuple(base)][1], ONCE[tuple(base)][3])


@pytest.mark.few(3)
@pytest.mark.parametrize("option", [*SOLVE, ["--remedy"], ["--variant", "А"]])
def test_an_option_of_a_folder_has_an_effect_or_is_refused(option, capsys, tmp_path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    folder = tmp_path.parent / "scenes"
    folder.mkdir(exist_ok=True)
    varied = LAW.replace('"3000*sin(phi_1)"', "3000").replace(
        "frame", "variants: {А: {l_AB: 0.4}, Б: {l_AB: 0.5}}\nframe"
    )
    (folder / "law.yaml").write_text(varied, encoding="utf-8")
    base = said(["solve", str(folder), "--lang", "en"], capsys, tmp_path)
    status, out, err, _ = said(["solve", str(folder), *option, "--lang", "en"], capsys, tmp_path)
    assert (out != base[1] and status == base[0]) if status != 2 else option[0] in err and not out, (
        base,
        status,
        out,
        err,
    )


def test_options_may_stand_ahead_of_the_command(capsys) -> None:
    said = []
    for line in (
        ["structure", CRANK, "--lang", "uk"],
        ["--lang", "uk", "structure", CRANK],
        ["--lang=uk", "structure", CRANK],
    ):
        assert main(line) == 0
        said.append(capsys.readouterr().out)
    assert said[0] == said[1] == said[2]
    with pytest.raises(SystemExit):
        main(["--lang", "uk"])


def test_a_remedy_has_an_effect_where_a_plan_is_blunt(capsys, tmp_path) -> None:
    scene = tmp_path / "s.yaml"
    blunt = LAW.replace('"3000*sin(phi_1)"', "3000").replace("l_AB: 0.3", "l_AB: 0.0802")
    scene.write_text(blunt + "plans: {acceleration: {mu: 100 mm/(m/s²)}}\n", encoding="utf-8")
    for more in ([], ["--pencil"]):
        argv = ["solve", str(scene), "--phi", "89", *more, "--lang", "en"]
        before, after = (said([*argv, *remedy], capsys, tmp_path.parent / "none")[1] for remedy in ([], ["--remedy"]))
        assert before and before != after


@pytest.mark.parametrize(
    ("argv", "words"),
    [
        (
            ["check", CRANK, "t.csv", "--plan", "velocity", "--pole", "1,2"],
            "--pole has no effect on a table of numbers",
        ),
        (["check", CRANK, "t.csv", "--plan", "velocity", "--format", "A3"], "it is for a picture (.png, .jpg, .pdf)"),
        (["check", CRANK, "t.svg", "--plan", "velocity", "--format", "A3"], "--format has no effect on a drawing"),
        (["check", CRANK, "--plan", "velocity", "--trace", "-o", "t.html", "--work", "cad"], "--work has no effect"),
        (["check", CRANK, "t.csv", "--plan", "velocity", "--phi", "0:90:30"], "one position is needed, but 4 were"),
        (["blank", CRANK, "--phi", "0:90:30", "-o", "b.pdf"], "one position is needed, but 4 were"),
        (["crank-slider", str(SAMPLES / "crank-slider.yaml"), "--phi", "30"], "--phi has no effect without --sheet"),
        (["solve", str(SAMPLES), "--pencil"], "--pencil has no effect on the survey of a folder"),
        (["solve", CRANK, "--pencil", "--seed", "-1"], "--seed -1: give a whole number, 0 or more"),
        (["solve", CRANK, "--phi", "0,5"], "a decimal fraction is written with a point"),
    ],
)
def test_what_would_change_nothing_is_refused(argv, words, capsys, tmp_path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    status, out, err, files = said([*argv, "--lang", "en"], capsys, tmp_path)
    assert (status, out, files) == (2, "", {}) and words in err, err
    again = said([*argv, "--lang", "ru"], capsys, tmp_path)[2]
    assert re.search("[а-я]", again) and "Traceback" not in again


@pytest.mark.parametrize(("pole", "words"), [("290,7,883.6", "written with a point"), ("1.2.3,4", "expected X,Y")])
def test_a_pole_that_is_no_place(pole, words, capsys, tmp_path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    main(["sheet", CRANK, "--view", "velocity-plan", "-o", "../v.svg"])
    assert (
        words
        in said(["check", CRANK, "../v.svg", "--plan", "velocity", "--pole", pole, "--lang", "en"], capsys, tmp_path)[2]
    )


DRAWN = {
    "reactions": "from-on",
    "mu_convention": "unit_per_mm",
    "lettering": "slanted",
    "format": "A1",
    "font": "DejaVu Serif",
    "colour": "true",
    "values": "true",
    "frame": "iso",
    "studio": "https://planes.example.org/",
}
OF_SHEET_1 = ("positions", "diagrams", "hodographs", "paths")


@pytest.mark.parametrize("key", sorted({*SHEET_KEYS} - {*DRAWN, *OF_SHEET_1}))
def test_every_key_of_the_title_block_fills_a_cell(key) -> None:
    value = {"revisions": "[[1]]", "mass": "5"}.get(key, "Ж7")
    frame = "frame: iso, " if key == "document_type" else ""
    filled, bare = (cell_texts(loads(f"{LAW}{sheet}"), "ru") for sheet in (f"sheet: {{{frame}{key}: {value}}}\n", ""))
    last = [key for key in fill_in_cells((420.0, 297.0)) if key.startswith("revision_")][-1]
    assert filled != bare and last == f"revision_{MOST_REVISION_ROWS}_date"


@pytest.mark.few(1)
@pytest.mark.parametrize("key", DRAWN)
def test_every_other_key_changes_the_sheet(key) -> None:
    def ink(more: str) -> str:
        text = Path(CRANK).read_text(encoding="utf-8") + more
        sheet = sheet_of(loads(text), None, "ru")
        return svg.write(sheet.marks, sheet.size, "").decode()

    assert ink(f"\nsheet: {{{key}: {DRAWN[key]}}}\n") != ink("")


@pytest.mark.parametrize(
    ("sheet", "words"),
    [
        *((f"{key}: 3", f'sheet has no key "{key}"') for key in ("views", "layout", "lang", "language")),
        ("format: A5", 'format of sheet cannot be "A5"; valid: auto, A4'),
        ("frame: din", 'frame of sheet cannot be "din"; valid: gost, iso'),
        ("frame: iso, mass: 5", "mass of sheet has no cell in the title block of frame: iso"),
        ("document_type: Analysis", "document_type of sheet has no cell in the title block of frame: gost"),
        ("positions: 30", "valid: true, false, 12"),
        ("title: {ru: a}", "title of sheet must be a word, not a table"),
        ("student: [A, B]", "must be a word, not a list"),
        ("letter: У Э 1 2", "letter of sheet has 4 entries; the most is 3"),
        ("revisions: [[1], [2], [3], [4], [5]]", "the most is 4"),
        ("revisions: [{name: 1}]", 'has no key "name"'),
        ("number: 1, designation: 2", "has both number and designation"),
    ],
)
def test_a_setting_of_the_sheet_is_heeded_or_refused(sheet, words) -> None:
    with pytest.raises(SceneError, match=re.escape(words)) as caught:
        loads(f"{LAW}sheet: {{{sheet}}}\n", "s.yaml")
    assert caught.value.line == 11


@pytest.mark.parametrize("number", [None, 1, 2])
@pytest.mark.parametrize(("key", "name"), [("diagrams", "u_99"), ("hodographs", "F_99"), ("paths", "Z9")])
def test_an_unknown_diagram_is_refused_on_every_sheet(key, name, number) -> None:
    scene = loads(f"{LAW}sheet:\n  {key}: [{name}]\n", "s.yaml")
    with pytest.raises(SceneError, match=rf"s.yaml:12: sheet.{key}: this mechanism has no quantity {name}; valid"):
        sheet_of(scene, None, "en", number)


@pytest.mark.parametrize(
    ("argv", "right"),
    [
        (["solve"], True),
        (["solve", "--phi", "40"], True),
        (["solve", "--phi", "90"], False),
        (["solve", "--phi", "40:60:10"], False),
        (["cycle"], False),
        (["cycle", "--show", "v_B", "-o", "t.csv"], True),
        (["cycle", "--show", "F_21"], False),
        (["sheet", "-o", "s.svg"], True),
        (["sheet", "-o", "s.svg", "--phi", "9"], False),
        (["lesson", "-o", "l.html"], True),
    ],
)
def test_a_load_by_an_angle_the_drives_is_made_of_holds_there_alone(argv, right, capsys, tmp_path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    scene = tmp_path.parent / "law.yaml"
    made = LAW.replace("phi: phi_1", "phi: phi_1 + zero").replace("{l_OA", "{zero: 0, l_OA")
    scene.write_text(made, encoding="utf-8")
    status, _, err, _ = said([argv[0], str(scene), *argv[1:], "--lang", "en"], capsys, tmp_path)
    assert status == (0 if right else 2), err
    assert right or ("law.yaml:10: force of load 1 depends on phi_1" in err and "valid at phi = 40 only" in err)


@pytest.mark.parametrize("command", ["solve", "cycle", "lesson", "note", "sheet", "chart", "blank"])
def test_a_link_of_no_length_is_refused_in_one_sentence_that_says_what_to_do(command, capsys, tmp_path) -> None:
    scene = tmp_path.parent / "zero.yaml"
    scene.write_text(PLAIN[: PLAIN.index("loads")].replace("l_AB: 0.3", "l_AB: 0"), encoding="utf-8")
    more = {"cycle": [], "solve": []}.get(command, ["-o", "x.pdf"])
    more = ["-o", "x.html"] if command in ("lesson", "note") else more
    for lang, words in (("en", "give it a length"), ("ru", "задайте её")):
        status, out, err, files = said([command, str(scene), *more, "--lang", lang], capsys, tmp_path)
        assert (status, out, files) == (2, "", {}) and err.count("\n") == 1 and "zero.yaml:6" in err and words in err


@pytest.mark.parametrize(
    ("old", "new", "laws"),
    [
        ('"3000*sin(phi_1)"', "3000", 0),
        ("omega: 10", "omega: 10 + phi_1", 1),
        ('sin(phi_1)"', 'sin(beta)"', 0),
        ("against: motion", "direction: phi_1 + 3", 0),
        ("phi: phi_1", "phi: phi_1 + alpha", 1),  # either of two may be what moves
        ("{y: 0}", "{through: O, angle: alpha}", 0),
    ],
)
def test_which_numbers_share_a_parameter_with_the_drive(old, new, laws) -> None:
    text = LAW.replace(old, new)
    assert len(loads(text).mechanism.laws) == laws
    fixed = text.replace("phi: phi_1", "phi: beta").replace("{y: 0}", "{through: O, angle: alpha}")
    fixed = fixed.replace("phi_1", "psi")  # or a load could mean either
    assert "psi" in fixed and (laws == 1 or not loads(fixed).mechanism.laws or "beta" in new)


def test_parameters_of_a_scene_are_not_replaced_in_vain() -> None:
    scene = load(CRANK)
    with pytest.raises(TypeError):
        dataclasses.replace(scene, parameters={"l_AB": 1.0})
    assert dataclasses.replace(scene, find=None).parameters == scene.parameters


def test_a_cycle_is_given_only_what_its_program_knows() -> None:
    plans = plans_of(load(str(SAMPLES / "six-link.yaml")).mechanism)
    with pytest.raises(PlanesError, match=r"this program has no input called l_CD; valid: .*did you mean l_DC"):
        Cycle(plans, ["v_C"], known={"l_CD": 0.2})
    one, two = (Cycle(plans, ["v_C"], known={"l_DC": x}) for x in (0.15, 0.16))
    assert next(one.blocks([150.0])).table[0] != next(two.blocks([150.0])).table[0]


DOUBTS = [
    ("phi_1: 40", "phi_1: pi/3", "parameters", "looks like radians"),
    ("phi_1: 40", "phi_1: 1.047", "parameters", "radians"),
    ("phi: phi_1", "phi: -1.5708", "drive", "radians"),
    ("phi: phi_1", "phi: sin(phi_1)", "drive", "ratio of sides"),
    ("l_OA: 0.08", "l_OA: 80", "parameters", "link 1 is 80 m long: lengths are in metres; if millimetres"),
    ("{B: 0}", "{B: 0, mass: 3}", "3:", "mass of link 3 is under points"),
    ("loads", "gravity:\nloads", "gravity", "gravity has no value and therefore no effect"),
    ("loads", "gravity: 9.81\nloads", "", ""),
    ("A: l_OA}}", "A: l_OA}, centre: A, inertia: 2}", "1:", "link 1 has inertia but no mass"),
    ("loads", "friction: {x-x: 1.5}\nloads", "friction", "friction of x-x is 1.5"),
    ("A: l_OA}}", "A: l_OA}, mass: 2}", "", ""),
    ("phi_1: 40", "phi_1: 180/pi*0.7", "", ""),
    ("phi_1: 40", "phi_1: 1", "", ""),
    ("phi_1: 40", "phi_1: 22.5", "", ""),
]


@pytest.mark.parametrize(("old", "new", "at", "words"), DOUBTS)
def test_doubtful_input_is_told_with_its_line(old, new, at, words) -> None:
    text = PLAIN.replace('"3000*sin(phi_1)"', "3000").replace(old, new, 1)
    found = [d for d in loads(text, "s.yaml").doubts if d.phrase.key != "doubt_unused"]  # as phi_1 may be by then
    assert len(found) == bool(words)
    for doubt in found:
        line = next(n for n, row in enumerate(text.splitlines(), 1) if row.strip().startswith(at))
        assert doubt.told("en").startswith(f"s.yaml:{line}: ") and words in doubt.told("en")
        assert re.search("[а-я]", doubt.told("ru"))


def test_no_omega_and_no_crank_are_told_where_nothing_else_is_asked() -> None:
    text = (
        PLAIN[: PLAIN.index("loads")].replace(", omega: 10", "").replace("A: l_OA", "A: 0").replace("l_OA: 0.08, ", "")
    )
    assert [d.phrase.key for d in loads(text).doubts] == ["doubt_no_crank", "doubt_at_rest"]
    assert not loads(text.replace("A: 0}}", "A: 0.1}}").replace("phi: phi_1", "phi: phi_1, omega: 0")).doubts


def test_doubts_go_to_stderr_and_into_json(capsys, tmp_path) -> None:
    scene = tmp_path / "s.yaml"
    scene.write_text(PLAIN.replace("l_OA: 0.08, l_AB: 0.3", "l_OA: 80, l_AB: 300"), encoding="utf-8")
    assert main(["solve", str(scene), "--json", "--lang", "ru"]) == 0
    told = capsys.readouterr()
    assert told.err.count("миллиметры") == 2
    assert json.loads(told.out)["positions"][0]["warnings"][:2] == [
        line.removeprefix("предупреждение: ") for line in told.err.splitlines()
    ]


@pytest.mark.parametrize("refused", [False, True])
@pytest.mark.parametrize(
    ("lang", "word"),
    [("en", "warning: "), ("ru", "предупреждение: "), ("uk", "попередження: "), ("be", "папярэджанне: ")],
)
def test_what_is_only_doubted_is_marked_so(lang, word, refused, capsys, tmp_path) -> None:
    """Nobody takes it for the refusal that may follow."""
    scene = tmp_path / "s.yaml"
    text = PLAIN.replace("l_OA: 0.08, l_AB: 0.3", "l_OA: 80, l_AB: 300")
    scene.write_text(text + "find: [Z_9]\n" * refused, encoding="utf-8")
    assert main(["solve", str(scene), "--lang", lang]) == 2 * refused
    lines = capsys.readouterr().err.splitlines()
    assert [line.startswith(word) for line in lines] == [True, True, *[False] * refused]


@pytest.mark.slow
def test_no_sample_is_doubtful() -> None:
    for path in SAMPLES.rglob("*.yaml"):
        if "planes: 1" in (text := path.read_text(encoding="utf-8")) and "\ndrive" in text:
            for variant in (None, *load(path).variants):
                scene = load(path, variant)
                assert not scene.doubts and scene.mechanism and not scene.mechanism.laws, path


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("links:", "звенья:", "did you mean links?"),
        ("phi_1: 40", "φ_1: 40", "did you mean φ_1?"),
        ("drive:", "note:", "the key drive is missing; for example: drive: {link: 1, phi: 30, omega: 10}"),
        ("l_AB}}", "l_AB}, масса: 3}", "did you mean mass?"),
    ],
)
def test_hints_say_what_was_meant(old, new, words) -> None:
    with pytest.raises(SceneError, match=re.escape(words)):
        loads(LAW.replace(old, new, 1))


def test_what_the_system_says_is_told_in_russian() -> None:
    why = os.strerror(errno.ENOSPC)
    assert say("cannot_write", "ru", file="f", reason=why).endswith("на диске нет места")
    assert say("cannot_write", "en", file="f", reason=why).endswith(why)


@pytest.mark.parametrize("text", ["1e17", "-4e8", "0:4e8:90"])
def test_an_angle_beyond_a_million_turns_is_refused(text, capsys) -> None:
    """Of 1e17 degrees no digit says where in its turn it is."""
    for command, more in (("solve", []), ("cycle", ["-o", "t.csv"])):
        assert main([command, str(SAMPLES / "six-link.yaml"), f"--phi={text}", *more, "--lang", "en"]) == 2
        assert "beyond 1000000 whole turns" in capsys.readouterr().err
    with pytest.raises(PlanesError, match=r"phi of drive 1e.12 is beyond 1000000 whole turns"):
        loads(PLAIN.replace("phi_1: 40", "phi_1: 1e12"), "s.yaml")


@pytest.mark.parametrize(
    ("mu", "more", "said"),
    [
        ("25 N/mm", "", "μ = 25 N/mm"),
        ("0.04 mm/N", "", "μ = 0.04 mm/N"),
        ("25 N/mm", "sheet: {mu_convention: mm_per_unit}\n", "μ = 0.04 mm/N"),
    ],
)
def test_a_scale_is_told_as_it_is_written(mu, more, said, capsys, tmp_path) -> None:
    scene = tmp_path / "s.yaml"
    rows = "  P_1: {value: 400, direction: 0}\n  P_2: {direction: 60}\n  P_3: {direction: 130}\n"
    text = f"planes: 1\nvectors:\n{rows}equations: ['P_1 + P_2 + P_3 = 0']\nmu: {mu}\n{more}"
    scene.write_text(text, encoding="utf-8")
    assert main(["solve", str(scene), "--lang", "en"]) == 0
    assert said in capsys.readouterr().out
    scene.write_text(f"{PLAIN}plans: {{velocity: {{mu: 0.04 (m/s)/mm}}}}\n", encoding="utf-8")
    assert main(["solve", str(scene), "--lang", "en"]) == 0
    assert "μ = 0.04 (m/s)/mm" in capsys.readouterr().out
