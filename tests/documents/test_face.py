"""The public face: what a person types in a notebook, and that it costs nothing until it is used."""

from __future__ import annotations

import copy
import doctest
import importlib
import json
import pickle
import pydoc
import re
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from types import MappingProxyType

import numpy as np
import pytest

import planes
from planes.cli import main
from planes.scene.mechanism import Assembly, Drive, Link, Mechanism
from planes.solving import Solved, solve
from planes.words.units import PLANS_WITH_MU
from tests.helpers import ROOT

SAMPLES = sorted([*(ROOT / "samples").glob("*.yaml"), *(ROOT / "samples" / "assignments").glob("0*.yaml")])
FOUR_BAR = ROOT / "samples" / "kind-1-rrr.yaml"


@pytest.mark.parametrize("module", ["planes", "planes.documents.face"])
def test_examples_of_the_docstrings(module: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    done = doctest.testmod(importlib.import_module(module), optionflags=doctest.ELLIPSIS)
    assert done.attempted and not done.failed


def test_every_public_name_is_there_and_has_its_words() -> None:
    for name in planes.__all__:
        assert getattr(planes, name).__doc__, name
    assert set(planes.__all__) <= set(dir(planes))


def test_nothing_is_imported_before_it_is_used() -> None:
    program = (
        "import sys, planes\n"
        "before = [m for m in sys.modules if m.startswith(('planes.', 'render', 'numpy', 'yaml'))]\n"
        "import planes.check.reading.svg\n"
        "print(before, planes.check.__module__, planes.lesson.__module__)"
    )
    done = subprocess.run([sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True, check=True)
    assert done.stdout.split("\n")[0] == "[] planes.documents.face planes.documents.face"


def test_a_position_is_read_by_name() -> None:
    here = planes.solve(planes.load(FOUR_BAR), phi=150)
    assert here.v["B"] == pytest.approx(complex(*here.results["points"]["B"]["v"]))
    assert here.value("omega_2") == here.omega["2"] == here.results["links"]["2"]["omega"]
    assert here.value("v_C") == here.v["C"] and here.value("a_C") == here.a["C"]
    assert here.value("v_CB") == pytest.approx(abs(here.v["C"] - here.v["B"]))
    with pytest.raises(planes.PlanesError, match="v_X"):
        here.value("v_X")


def test_parameters_by_keyword_and_again() -> None:
    scene = planes.load(FOUR_BAR, l_CD=0.4).with_parameters(l_AB=0.11)
    assert (scene.parameters["l_CD"], scene.parameters["l_AB"]) == (0.4, 0.11)
    with pytest.raises(planes.PlanesError, match=r"kind-1-rrr\.yaml:\d+: \"l_DC\" is not a parameter.*l_CD"):
        planes.load(FOUR_BAR, l_DC=0.4)
    with pytest.raises(planes.PlanesError, match="l_DC"):
        planes.cycle(scene, ["v_C"], l_DC=[1.0])


def test_a_sweep_agrees_with_single_positions() -> None:
    scene = planes.load(FOUR_BAR)
    table = planes.cycle(scene, ["v_C", "M_1"], phi=[20, 140, 260], l_BC=[0.36, 0.37])
    for row in range(6):
        one = planes.solve(scene.with_parameters(l_BC=table["l_BC"][row]), phi=float(table["phi"][row]))
        assert table["v_C"][row] == pytest.approx(one.v["C"], rel=1e-12)
        assert table["M_1"][row] == pytest.approx(one.value("M_1"), rel=1e-11)
    with pytest.raises(planes.PlanesError, match="v_C"):
        table["v_X"]


@pytest.mark.needs("pandas")
def test_a_table_goes_to_pandas() -> None:
    import pandas

    frame = planes.cycle(planes.load(FOUR_BAR), ["omega_2"], phi=[0, 90]).to_pandas()
    assert isinstance(frame, pandas.DataFrame) and list(frame) == ["phi", "omega_2", "failed"]


@pytest.mark.parametrize("phi", [np.zeros((2, 2)), [[1.0]], ["a"], "x", [], float("nan"), [0.0, np.inf], {}])
def test_a_place_of_the_drive_that_is_no_number_is_one_sentence(phi: object) -> None:
    scene = planes.load(FOUR_BAR)
    for asked in (planes.solve, planes.cycle):
        with pytest.raises(planes.PlanesError, match=r"^phi must be a finite number or a flat list of them, not "):
            asked(scene, phi=phi)
    with pytest.raises(planes.PlanesError, match=r"^phi must be one finite number, not "):
        planes.sheet(scene, phi=[phi])  # type: ignore[arg-type]
    with pytest.raises(planes.PlanesError, match=r"^l_CD must be a finite number"):
        planes.cycle(scene, ["v_C"], phi=0, l_CD=phi)


def test_a_kind_of_results_that_is_nothing_is_answered_by_those_there_are() -> None:
    here = planes.solve(planes.load(FOUR_BAR))
    for kind in (("reaction",), ("points",), ("points", "w")):
        with pytest.raises(KeyError, match=r"there is no .*; valid: points\.r, .*reactions"):
            here.of(*kind)
    with pytest.raises(KeyError, match="there is no speed here; valid: position, velocity"):
        list(here.measured_on("speed"))
    assert not here.of("vectors")  # may be there, and is not
    assert repr(here.of("links", "omega")["2"]).startswith("<omega_2 = ")


def test_what_fails_says_so() -> None:
    scene = planes.load(ROOT / "samples" / "six-link.yaml")
    table = planes.cycle(scene, ["v_C"], phi=[90, 150])
    assert table.failed[0] == "C: arcs apart" and np.isnan(table["v_C_x"][0]) and not table.failed[1]
    with pytest.raises(planes.PlanesError):
        planes.solve(scene, phi=90)
    assert len(planes.solve(scene, [90, 150]).failed) == 1
    with pytest.raises(planes.PlanesError, match=r"^s does not fit .*: its driver is given by phi$"):
        planes.solve(scene, s=0.1)


def test_a_mechanism_built_in_python() -> None:
    points = {"A": 0j, "D": 0.3 + 0j}
    shapes = {"1": {"A": 0j, "B": 0.1}, "2": {"B": 0j, "C": 0.3}, "3": {"D": 0j, "C": 0.25}}
    links = {name: Link(name, shape) for name, shape in shapes.items()}
    built = Mechanism(
        Link("0", points), MappingProxyType(links), Drive("1", "phi", 60.0, 10.0), assembly={"C": Assembly("left")}
    )
    scene = planes.Scene("four-bar", mechanism=built, mu=dict.fromkeys(PLANS_WITH_MU))
    assert abs(planes.solve(scene).v["B"]) == pytest.approx(1.0)
    assert planes.picture(scene) and planes.cycle(scene, "v_C", phi=[60, 70])["v_C"].shape == (2,)
    with pytest.raises(planes.PlanesError, match="two ways"):
        planes.solve(replace(scene, mechanism=replace(built, assembly={})))


OF_SCENE = ("mechanism", "statement", "mu", "find", "title", "note", "missing", "sheet", "frame_number", "parameters")


@pytest.mark.parametrize("path", SAMPLES, ids=lambda p: p.stem)
def test_a_scene_written_as_yaml_is_the_same_scene_and_its_parameters_can_be_changed(path: Path) -> None:
    scene = planes.load(path, *planes.load(path).variants[-1:])
    own = {name: value for name, value in scene.used.items() if value}
    for name, value in list(own.items())[:1]:  # scales too stay what they were
        changed = {name: 1.001 * value}
        other, again = scene.with_parameters(**changed), planes.loads(scene.to_yaml()).with_parameters(**changed)
        for one in (again, planes.loads(other.to_yaml())):
            assert [getattr(one, of) for of in OF_SCENE] == [getattr(other, of) for of in OF_SCENE]
    again = planes.loads(scene.to_yaml())
    assert [getattr(again, of) for of in OF_SCENE] == [getattr(scene, of) for of in OF_SCENE]


def _kept(thing: object) -> object:
    """What is to be the same in a copy: of a scene all of it."""
    if isinstance(thing, planes.Scene):
        return thing, hash(thing)
    return str(thing), getattr(thing, "results", None), thing.json() if isinstance(thing, Solved) else None


@pytest.mark.parametrize("path", [p for p in SAMPLES if p.parent.name == "samples"], ids=lambda p: p.stem)
def test_results_go_to_other_processes_and_are_copied(path: Path) -> None:
    scene = planes.load(path)
    assert scene == planes.load(path) and hash(scene) == hash(planes.load(path))
    things: list[object] = [scene, planes.solve(scene), solve(scene)]
    things += [planes.extremes(scene)] if path == FOUR_BAR else []
    for thing in things:
        for again in (copy.deepcopy(thing), pickle.loads(pickle.dumps(thing))):
            assert _kept(again) == _kept(thing)


def test_things_show_themselves_shortly() -> None:
    scene = planes.load(FOUR_BAR)
    here = planes.solve(scene)
    things = [scene, here, planes.solve(scene, [0, 1]), planes.cycle(scene, phi=[0]), planes.picture(here)]
    assert all(len(repr(thing)) < 200 for thing in things)
    for thing in (scene, here, here.drawing, planes.picture(scene, "velocity-plan")):
        assert (thing._repr_svg_() or "").startswith("<svg")


def test_the_language_is_the_locales(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = planes.load(FOUR_BAR)
    for locale, lang in (("ru_RU.UTF-8", "ru"), ("C", "en")):
        monkeypatch.setenv("LC_ALL", locale)
        assert planes.picture(scene).lang == lang
        assert planes.lesson(scene).lang == lang


def test_a_drawing_is_checked(tmp_path: Path) -> None:
    scene = planes.load(FOUR_BAR)
    planes.sheet(scene, tmp_path / "v.svg", view="velocity-plan", lang="en")
    found = planes.check(scene, tmp_path / "v.svg", "velocity")
    assert (found.verdict, found.first_wrong) == ("right", None) and "right" in repr(found)
    assert planes.check(scene, tmp_path / "v.svg", "acceleration").verdict != "right"
    with pytest.raises(planes.PlanesError, match="velocity"):
        planes.check(scene, tmp_path / "v.svg", "speed")


def test_a_sheet_is_written(tmp_path: Path) -> None:
    scene = planes.load(FOUR_BAR)
    drawn = planes.sheet(scene, tmp_path / "v.svg", view="velocity-plan", lang="en")
    assert (tmp_path / "v.svg").read_text("utf-8").startswith("<?xml") and len(repr(drawn)) < 200
    planes.lesson(scene, tmp_path / "lesson.html")
    assert "<html" in (tmp_path / "lesson.html").read_text("utf-8")


def test_a_table_is_plotted_a_panel_for_each_unit() -> None:
    table = planes.cycle(planes.load(FOUR_BAR), ["v_C", "omega_2", "omega_3"], phi=range(0, 360, 30))
    figure = table.plot()
    assert [panel.get_ylabel() for panel in figure.axes] == ["m/s", "rad/s"]
    assert figure.axes[-1].get_xlabel() == "phi, °"
    (speed,) = table.plot("v_C").axes[0].lines
    assert list(speed.get_ydata()) == pytest.approx(abs(table["v_C"]).tolist())  # type: ignore[arg-type]
    with pytest.raises(planes.PlanesError, match="v_X"):
        table.plot("v_X")


def test_a_position_prints_its_tables(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("LC_ALL", "C")
    text = str(planes.solve(planes.load(ROOT / "samples" / "six-link.yaml"), phi=150))
    assert text.startswith("— φ = 150° —\n") and "F_36" in text and "8.122" in text
    assert "v_CB" in str(planes.solve(planes.load(ROOT / "samples" / "vectors.yaml")))


def test_a_parameter_from_which_nothing_is_made_cannot_be_changed() -> None:
    text = planes.load(FOUR_BAR).to_yaml().replace("A: 0, B: l_AB", "A: 0, B: 0.1")
    with pytest.raises(planes.PlanesError, match=r"nothing in this scene depends on the parameter l_AB"):
        planes.loads(text, l_AB=0.2)


def test_a_reaction_named_from_the_other_link_is_opposite() -> None:
    scene = planes.load(FOUR_BAR)
    here, table = planes.solve(scene), planes.cycle(scene, ["F_12", "F_30"], phi=[0.0, 310.0])
    for one, other in (("F_21", "F_12"), ("F_30", "F_03"), ("F_32", "F_23")):
        assert here.value(other) == -here.value(one) != 0
    assert table["F_12"][1] == pytest.approx(-here.value("F_21"), rel=1e-12)
    assert "F_12" in table and table.get("nope", 0) == 0 and "nope" not in table


@pytest.mark.few(2)
@pytest.mark.parametrize("path", [p for p in SAMPLES if p.parent.name == "samples"], ids=lambda p: p.stem)
def test_every_name_that_is_printed_can_be_asked_for(path: Path) -> None:
    scene = planes.load(path)
    here, printed = planes.solve(scene), list[str]()
    if scene.mechanism and scene.drive:
        everything = planes.cycle(scene, phi=here.at) if scene.drive.kind == "phi" else planes.cycle(scene, s=here.at)
        printed = [*everything, *planes.extremes(scene)["curves"]]
    names = list(dict.fromkeys((*here.names, *printed)))
    for name in names[:: 1 + len(names) // 40]:
        assert np.isfinite(here.value(name)) or name.endswith("_arm"), name
    if printed:
        table = planes.cycle(scene, names, **{scene.drive.kind: here.at})  # type: ignore[union-attr]
        for name in names[:: 1 + len(names) // 40]:
            assert np.isnan(table[name][0]) or table[name][0] == pytest.approx(here.value(name), rel=1e-6, abs=1e-6)


def test_a_name_that_is_none_is_refused_with_what_is_meant_and_where_all_names_are() -> None:
    scene = planes.load(FOUR_BAR)
    here = planes.solve(scene)
    for name, near in (("alpha_2", "epsilon_2"), ("theta_2", "phi_2"), ("w_2", "omega_2"), ("v_C'", "v_C"), (2, "")):
        for ask in (here.value, lambda one: planes.cycle(scene, [one])):
            with pytest.raises(planes.PlanesError, match=rf"no quantity {name};.*{near}.*\.names\)$"):
                ask(name)  # type: ignore[arg-type]
    assert here.value("phi") == pytest.approx(here.at) and len(here.names) == len(set(here.names)) > 40
    only = planes.solve(planes.loads(FOUR_BAR.read_text("utf-8") + "\nfind: [omega_2]\n"))
    with pytest.raises(planes.PlanesError, match=r"^find: of the scene does not ask for M_1; add it there"):
        only.value("M_1")


VERBS = ("animate", "check", "crank", "cycle", "extremes", "lesson", "picture", "sheet", "solve")


@pytest.mark.parametrize("verb", VERBS)
def test_a_path_is_a_scene_and_what_is_none_is_refused(verb: str, tmp_path: Path) -> None:
    more = {"animate": (tmp_path / "x.svg",), "check": (tmp_path / "x.svg", "velocity")}.get(verb, ())
    for wrong in (3, None, planes.solve(planes.load(FOUR_BAR)) if verb != "picture" else []):
        with pytest.raises(
            planes.PlanesError, match=r'a scene is needed, not .*: planes.load\("scene.yaml"\) gives one'
        ):
            getattr(planes, verb)(wrong, *more)
    if verb == "crank":
        pytest.importorskip("anywidget")
    if verb not in ("animate", "check"):
        assert getattr(planes, verb)(str(FOUR_BAR))
    with pytest.raises(planes.PlanesError, match="no such file"):
        getattr(planes, verb)(tmp_path / "none.yaml", *more)


def test_a_parameter_that_is_no_number_and_a_file_that_is_none_are_sentences() -> None:
    for wrong in ("abc", None, float("nan"), [0.1]):
        for ask in (planes.load(FOUR_BAR).with_parameters, lambda **given: planes.load(FOUR_BAR, **given)):
            with pytest.raises(planes.PlanesError, match=r"^l_AB must be one finite number, not "):
                ask(l_AB=wrong)  # type: ignore[arg-type]
    for none in (3, None, 0.5):
        with pytest.raises(planes.PlanesError, match=r"the file cannot be read|no such file"):
            planes.load(none)  # type: ignore[arg-type]


def test_the_face_takes_what_one_types() -> None:
    scene = planes.load(FOUR_BAR)
    assert planes.cycle(scene, "v_C", phi=60)["v_C"].shape == (1,)
    assert planes.cycle(scene, ["v_C"], phi=(float(x) for x in (0, 90)))["v_C"].shape == (2,)
    here = planes.solve(scene)
    assert 2 in here.omega and here.omega.get(2) == here.omega["2"] and here.omega.get("7") is None
    runs = planes.cycle(scene, ["omega_2"], phi=range(0, 360, 90), l_CD=[0.3, 0.35]).plot().axes[0].lines
    assert [len(run.get_xdata()) for run in runs] == [4, 4]  # type: ignore[arg-type]
    assert [run.get_label() for run in runs] == ["omega_2, l_CD = 0.3", "omega_2, l_CD = 0.35"]


def test_a_mechanism_built_in_python_needs_no_scene_of_its_own() -> None:
    bar = planes.Linkage().fix(P=(0, 0), S=(0.2, 0)).link(1, P=0, Q=0.0625).link(2, Q=0, R=0.175).link(3, S=0, R=0.1125)
    bar.assemble(R="left").drive(1, phi=60, omega=-10)
    assert planes.solve(bar).omega[2] == planes.solve(bar.scene()).omega[2]
    assert planes.cycle(bar, "omega_3", phi=[60])["omega_3"][0] == pytest.approx(-3.787, abs=1e-3)


def test_extremes_print_as_the_tables_of_a_cycle_and_tell_their_shape(capsys: pytest.CaptureFixture[str]) -> None:
    found = planes.extremes(planes.load(FOUR_BAR))
    assert main(["cycle", str(FOUR_BAR), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["curves"] == json.loads(json.dumps(found))["curves"]
    assert not re.search(r"[0-9][.,][0-9]{7}", f"{found} {found!r}")
    told = str(type(planes.extremes).__doc__) + str(planes.extremes.__doc__)
    for key in (*list(found)[4:], *found["driven"], "unit", "group", "extremes", "at", "value", "kind"):
        assert re.search(rf'[`"]{key}[`"]', told), key


def test_help_shows_what_a_person_can_read() -> None:
    for name in planes.__all__:
        told = pydoc.render_doc(getattr(planes, name), renderer=pydoc.plaintext)
        assert not re.search(r" at 0x|_Verb|_none", told), name
        assert name in told.splitlines()[0]


def test_a_group_of_loads_that_is_nothing_is_answered_by_those_there_are() -> None:
    here = planes.solve(planes.load(FOUR_BAR))
    assert here.number("balancing_moment") == here.value("M_1") and here.number("balancing_force") is None
    with pytest.raises(KeyError, match=r"there is no moment here; valid: balancing_moment, .*zhukovsky_force"):
        here.number("moment")
    table = planes.cycle(planes.load(FOUR_BAR), "v_C", phi=[0, 10])
    assert repr(table).startswith(f"<Table of {len(table)} columns, 2 positions: ")
