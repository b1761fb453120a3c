"""The table of transfer functions: its relations, worked out with the millimetres of the plan, are its values."""

from __future__ import annotations

from itertools import permutations

import pytest

from planes.lesson.transfers import TransferFunctions
from planes.plans.measuring import scene_lettering
from planes.scene import load
from planes.solving import Position, solve
from planes.words.lettering import parameter_lettering
from planes.words.names import label_of, plan_of
from planes.words.naming import Naming
from tests.helpers import ROOT

SCENES = sorted(p for f in ("", "assignments") for p in (ROOT / "samples" / f).glob("*.yaml") if p.stem != "vectors")


def sizes(position: Position, naming: Naming) -> dict[str, float]:
    """Millimetres of all segments of the velocity plan, metres of all lengths, as they are lettered."""
    drawn = {n: z for n, z in position.drawing.things.items() if plan_of(n) == "velocity"}
    marks = {naming.mark(label_of(n), "velocity"): z for n, z in drawn.items()}
    found = {a + b: abs(z - w) for (a, z), (b, w) in permutations(marks.items(), 2)}
    return found | {parameter_lettering(n): abs(v) for n, v in position.drawing.things.items() if n.startswith("l_")}


@pytest.mark.few(6)
@pytest.mark.parametrize("path", SCENES, ids=lambda p: p.stem)
def test_relations_of_segments_are_the_values(path):
    scene = load(path)
    position = solve(scene).positions[0]
    naming = Naming("en", **scene_lettering(scene, position.plans))
    known, rows = sizes(position, naming), list(TransferFunctions(position, naming).transfer_rows())
    assert bool(rows) == bool(scene.mechanism.drive.velocity)
    for name, relation, value, unit in rows:
        over, _, under = relation.partition("/")
        worked = 1.0
        for names, power in ((over, 1), (under.strip("()"), -1)):
            for one in names.split("·"):
                worked *= known[one] ** power
        assert worked == pytest.approx(abs(float(value.replace("−", "-"))), rel=6e-3, abs=1e-9), (name, relation)
        assert (unit == "m") == (name.startswith("v") and scene.mechanism.drive.kind == "phi")


def test_links_that_turn_alike_share_a_row_and_signs_tell_the_sense():
    position = solve(load(ROOT / "samples" / "six-link.yaml")).positions[0]
    rows = {
        name: (relation, value)
        for name, relation, value, _ in TransferFunctions(position, Naming("en")).transfer_rows()
    }
    assert rows["u_{21} = u_{41}"] == ("bc·l_{AB}/(pb·l_{BC})", "−0.406")
    assert rows["v_{qC}"] == ("pc·l_{AB}/pb", "0.120")
    with pytest.raises(KeyError):
        rows["v_{qB}"]
