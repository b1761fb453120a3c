"""Cycles and scenes at the edge: links that turn all round, values without bound, lengths of zero, long chains; what
they cost is counted."""

from __future__ import annotations

import json
import re
import tracemalloc
from collections.abc import Iterator
from pathlib import Path

import pytest

from planes.cli import main
from planes.diagrams.summary import summarise_cycle
from planes.diagrams.text import summary_json, summary_report
from planes.plans import plans_of
from planes.plans.assur.analysis import analyse_structure
from planes.scene import loads
from planes.words.errors import SceneError
from tests.helpers import ROOT
from tests.helpers.counting import at_most

SAMPLES = ROOT / "samples"
DRAG_LINK = """\
planes: 1
frame: {points: {A: [0, 0], D: [0.1, 0]}}
links:
  1: {points: {A: 0, B: 0.3}}
  2: {points: {B: 0, C: 0.32}}
  3: {points: {D: 0, C: 0.28}}
assembly: {C: left}
drive: {link: 1, phi: 60, omega: 5}
"""
GUIDED = """\
planes: 1
frame: {points: {O: [0, 0]}, guides: {z-z: {through: [0.5, 0.1], angle: 43.999}}}
links:
  1: {points: {O: 0, B: 0.1}, guides: {OC: {through: O, angle: 0}}}
  2: {points: {H: 0}, slides: OC}
  3: {points: {H: 0}, slides: z-z}
drive: {link: 1, phi: 10, omega: 1, epsilon: 2}
"""


def chain(dyads: int, backwards: bool = False) -> str:
    """A crank and so many dyads, each on the rocker before."""
    pivots = ", ".join(f"D{k}: [{0.4 * k:.6g}, 0]" for k in range(1, dyads + 1))
    made = ["  1: {points: {A: 0, B0: 0.08}, mass: 1, inertia: 0.01}\n"]
    for k in range(1, dyads + 1):
        made.append(
            f"  {2 * k}: {{points: {{B{k - 1}: 0, B{k}: 0.4}}, mass: 1, inertia: 0.01}}\n"
            f"  {2 * k + 1}: {{points: {{D{k}: 0, B{k}: 0.25}}, mass: 1, inertia: 0.01}}\n"
        )
    sides = ", ".join(f"B{k}: left" for k in range(1, dyads + 1))
    links = "".join(reversed(made) if backwards else made)
    return (
        f"planes: 1\nframe:\n  points: {{A: [0, 0], {pivots}}}\nlinks:\n{links}assembly: {{{sides}}}\n"
        "drive: {link: 1, phi: 60, omega: 10, epsilon: 2}\ngravity: 9.81\n"
        f"loads: [{{link: {2 * dyads + 1}, point: B{dyads}, force: 100, direction: 0}}]\n"
    )


def summed(text: str):  # type: ignore[no-untyped-def]
    scene = loads(text)
    assert scene.mechanism
    return summarise_cycle(scene, plans_of(scene.mechanism))


# what turns, and what grows


def test_a_link_that_turns_all_round_is_said_to() -> None:
    found = summed(DRAG_LINK)
    told = summary_json(found)["curves"]
    assert told["phi_3"] == {"unit": "°", "group": "place", "extremes": [], "rotates": True}
    assert [round(e["value"], 4) for e in told["omega_3"]["extremes"]] == [7.7952, 3.1425]
    assert re.search(r"phi_3 +° +all the way round +— +— +—", summary_report(found, "en"))
    assert re.search(r"phi_3 +° +полный оборот +— +— +—", summary_report(found, "ru"))


@pytest.mark.slow
def test_what_grows_without_bound_is_told_with_its_place() -> None:
    found = summed(GUIDED)
    told = summary_json(found)
    json.dumps(told, allow_nan=False)
    assert told["driven"]["stroke"] is None and told["paths"]["H"]["length"] is None
    ends = [(round(e["at"], 6), e["kind"]) for e in told["curves"]["s_3"]["extremes"] if e["unbounded"]]
    assert ends == [(43.999, "greatest"), (43.999, "least"), (223.999, "greatest"), (223.999, "least")]
    assert "moves without bound" in summary_report(found, "en") and "уходит в бесконечность" in summary_report(
        found, "ru"
    )


@pytest.mark.slow
def test_rounding_has_no_extremes() -> None:
    """Rods 0.4 long between pivots 0.4 apart only shift: what their angles vary by is rounding."""
    told = summary_json(summed(chain(3)))["curves"]
    assert all(told[name]["extremes"] == [] for name in ("phi_4", "u_41", "omega_4", "epsilon_4"))
    assert len(told["omega_3"]["extremes"]) == 2
    assert max(len(c["extremes"]) for c in told.values()) < 20


# lengths of zero


@pytest.mark.parametrize("link", ["2: {points: {B: 0, C: 0, E: 0.2}}", "3: {points: {D: 0, C: 0}}"])
def test_two_hinges_in_one_place_are_refused_in_a_sentence(link: str) -> None:
    text = re.sub(rf"  {link[0]}: .*\n", f"  {link}\n", DRAG_LINK)
    mechanism = loads(text, "x.yaml").mechanism
    assert mechanism
    with pytest.raises(SceneError, match=rf"x\.yaml:{3 + int(link[0])}: hinges . and C of link {link[0]} coincide"):
        plans_of(mechanism, "x.yaml")


def zeroed(names: tuple[str, ...]) -> Iterator[tuple[str, str, str]]:
    """Every sample with each of its lengths in turn set to zero."""
    for name in names:
        text = (SAMPLES / f"{name}.yaml").read_text(encoding="utf-8")
        for m in re.finditer(r"(?<![\w{])((?:l_|[A-Z]|[a-z]_?\d?)\w*): (-?[\d.]+)(?=[,}])", text):
            if not m[1].startswith(("phi", "omega", "epsilon", "alpha", "mass", "inertia", "force", "planes")):
                yield name, m[1], text[: m.start(2)] + "0" + text[m.end(2) :]


CASES = list(zeroed(("kind-1-rrr", "kind-3-rpr", "kind-5-rpp", "sliding-driver")))


@pytest.mark.few(1, slow=7)
@pytest.mark.parametrize(("name", "length", "text"), CASES, ids=[f"{n} {x}" for n, x, _ in CASES])
def test_a_length_of_zero_gives_numbers_or_one_sentence(
    name: str, length: str, text: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file, out = tmp_path / "x.yaml", tmp_path / "out"
    file.write_text(text, encoding="utf-8")
    commands = [["solve", "--json"], ["structure"], ["cycle", "--json"]]
    if length.startswith("l_"):  # of a link, not of where a point or a mass centre lies on it
        commands += [["sheet", "-o", f"{out}.svg"], ["lesson", "-o", f"{out}.html"]]
    for command, *options in commands:
        status = main([command, str(file), "--lang", "en", *options])
        told = capsys.readouterr()
        assert status in (0, 2) and "Traceback" not in told.err
        assert "NaN" not in told.out and "Infinity" not in told.out
        assert status == 0 or told.err.count("\n") == 1


def test_one_such_scene_does_not_stop_the_others(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "a.yaml").write_text(DRAG_LINK.replace("C: 0.32", "C: 0"), encoding="utf-8")
    (tmp_path / "b.yaml").write_text(DRAG_LINK, encoding="utf-8")
    assert main(["solve", str(tmp_path), "--lang", "en"]) == 1
    told = capsys.readouterr()
    assert "hinges B and C of link 2 coincide" in told.out + told.err and re.search("b +φ = 60° +yes", told.out)


# cost


@pytest.mark.slow
def test_a_cycle_of_many_links_holds_little_memory() -> None:
    sizes = []
    for dyads in (4, 8):
        tracemalloc.start()
        summary_json(summed(chain(dyads)))
        sizes.append(tracemalloc.get_traced_memory()[1])
        tracemalloc.stop()
    assert sizes[1] < 4.5 * sizes[0] and sizes[1] < 60e6


def test_structure_takes_work_as_links_squared() -> None:
    counts = []
    for dyads in (20, 40):
        mechanism = loads(chain(dyads, backwards=True)).mechanism
        assert mechanism
        with at_most(3_000_000) as made:
            assert len(analyse_structure(mechanism).groups) == dyads
        counts.append(made[0])
    assert counts[1] < 4.5 * counts[0]


@pytest.mark.slow
def test_a_sheet_of_many_links_ends(tmp_path: Path) -> None:
    file = tmp_path / "chain.yaml"
    file.write_text(chain(7), encoding="utf-8")
    with at_most(60_000_000):
        assert main(["sheet", str(file), "-o", str(tmp_path / "x.svg")]) == 0
