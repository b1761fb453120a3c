"""Forces are taught a group at a time: what is unknown, what is split, moments, equation, scale, polygon, each link."""

from __future__ import annotations

import random
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from planes.lesson.told import SceneLesson
from planes.scene import load, loads
from planes.words import available_languages, sentence_table
from planes.words.errors import PlanesError
from tests.helpers import ROOT
from tests.helpers.mechanisms import KINDS, make, to_yaml

SAMPLES = ROOT / "samples"
SCENES = [
    p for p in sorted(SAMPLES.rglob("*.yaml")) if re.search("^links:", p.read_text(encoding="utf-8"), re.MULTILINE)
]


def forces(told: SceneLesson) -> Iterator[tuple[str, list[int]]]:
    """Every force polygon, with the numbers of its frames."""
    for plan in (p for p in told.plans.plan_names if p.is_force):
        yield plan, [k for k, f in enumerate(told.frames) if f.plan == plan]


def in_order(told: SceneLesson) -> int:
    """Checks the frames of every force polygon; how many there are."""
    polygons = 0
    sought = [told.plans.moments[f.moments].unknown if f.moments is not None else "" for f in told.frames]
    for plan, own in forces(told):
        keys = [told.frames[k].key for k in own]
        links, reactions = plan.links, told.plans.reactions.values()
        stated = {t.name.partition("^")[0] for e in told.plans.equations if e.plan == plan for t in e.all_terms}
        closed = {r.key for r in reactions if r.plan == plan and {r.pair.link, r.pair.other} <= {*links}}
        inside = closed - stated  # of class IV some are in the equation itself
        assert keys[0] == "free_body" and keys.count("free_body") == keys.count("pole") == 1
        assert "equation" not in keys or keys.index("equation") < keys.index("pole")
        drawn = next((j for j, k in enumerate(own) if told.frames[k].makes and keys[j] != "pole"), len(keys))
        assert "split" not in keys[drawn:] and ("equation" not in keys or "equation" in keys[:drawn])
        known: set[str] = set()
        for k in own:
            f = told.frames[k]
            if f.key == "equation":  # what moments give has been found by now
                terms = {t["name"] for side in told.equations[f.equation]["sides"] for t in side}
                assert terms.isdisjoint(sought[k:]), (plan, terms & {*sought[k:]})
            measured = {r.name for r in f.rows}
            assert f.key == "apart" or not measured & inside, (plan, f.key, measured & inside)
            known |= measured
        assert {r for r in closed if told.teller.segment_ends(r, plan)} <= known, plan
        polygons += 1
    return polygons


@pytest.mark.few(10)
@pytest.mark.parametrize("path", SCENES, ids=lambda p: str(p.relative_to(SAMPLES))[:-5])
def test_each_group_is_told_from_its_free_body_to_its_links(path: Path) -> None:
    told = SceneLesson.of(load(path))
    assert in_order(told) >= bool(told.plans.reactions)


@pytest.mark.slow
def test_random_mechanisms_are_told_in_the_same_order() -> None:
    polygons = 0
    for seed in range(100):
        try:
            rng = random.Random(seed)
            told = SceneLesson.of(loads(to_yaml(make(rng, rng.choices(KINDS, k=2), friction=seed % 3 == 0).scene)))
        except PlanesError:
            continue
        polygons += in_order(told)
    assert polygons > 100


@pytest.mark.parametrize("name", ["six-link", "kind-2-rrp", "bntu-2", "class-three/press"])
def test_other_words_change_no_frame(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """With every sentence of a lesson reworded in every language, all but the words is as before."""
    whole = lambda told: [(f.key, f.plan, f.makes, f.terms, f.rows, f.numbers) for f in told.frames]  # noqa: E731
    before = SceneLesson.of(load(SAMPLES / f"{name}.yaml"))
    for lang in available_languages():
        words = sentence_table(lang)
        for key in [k for k in words if k.startswith(("lesson_", "why_"))]:
            names = re.findall(r"{\w+}", words[key])
            monkeypatch.setitem(words, key, "§ " + " ~ ".join(reversed(names)))  # type: ignore[arg-type]
    after = SceneLesson.of(load(SAMPLES / f"{name}.yaml"))
    assert whole(after) == whole(before) and after.frames != before.frames
    assert after.practice.practice_items() == before.practice.practice_items()
