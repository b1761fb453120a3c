"""The reactions of both edges of a slider's face: their sum and their moment are those of the whole reaction."""

from __future__ import annotations

import pytest

from planes.scene import loads
from planes.solving import solve
from planes.words.errors import SceneError

SCENE = """planes: 1
frame: {points: {O: [0, 0]}, guides: {x-x: {y: 0}}}
links:
  1: {points: {O: 0, A: 0.1}}
  2: {points: {A: 0, B: 0.35}, mass: 4, inertia: 0.05}
  3: {points: {B: 0, Q: [0.05, 0.2]}, slides: {guide: x-x%s}, mass: 2}
assembly: {B: ahead}
drive: {link: 1, phi: 60, omega: 20}
loads: [{link: 3, point: Q, force: 500, direction: 200}]
"""


@pytest.mark.parametrize("length", [0.02, 0.12, 3.0])
def test_both_edges_make_the_whole_reaction(length: float) -> None:
    (p,) = solve(loads(SCENE % f", length: {length}")).positions
    ahead, behind = (p.of("edges")[f"N_30^{k}"].number for k in (1, 2))
    whole = p.of("reactions")["F_30"]
    assert ahead + behind == pytest.approx(whole.vector.imag, rel=1e-12)
    assert (ahead - behind) * length / 2 == pytest.approx(whole.moment, rel=1e-12)
    assert whole.arm is not None and (ahead * behind < 0) == (abs(whole.arm) > length / 2)
    assert p.value("N_30^1") == ahead


def test_without_a_length_there_are_none() -> None:
    (p,) = solve(loads(SCENE % "")).positions
    assert not p.of("edges") and "edges" not in p.results


@pytest.mark.parametrize("length", ["0", "-0.1"])
def test_a_face_has_a_length(length: str) -> None:
    with pytest.raises(SceneError) as refusal:
        loads(SCENE % f", length: {length}")
    assert "must be greater than zero" in refusal.value.told("en")


def test_a_scene_keeps_the_length_when_it_is_written_again() -> None:
    scene = loads(SCENE % ", length: 0.12")
    again = loads(scene.to_yaml())
    assert again.mechanism and again.mechanism.links["3"].slides == scene.mechanism.links["3"].slides  # type: ignore[union-attr]
