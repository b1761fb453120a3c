"""Plans and marks are records whose text is that of files."""

from __future__ import annotations

import copy
import json
import pickle
from collections.abc import Callable
from dataclasses import FrozenInstanceError

import pytest

from planes.words.names import NO_MARK, SCHEME_PLAN, Mark, PlanId, label_of, plan_of

FORCE = PlanId("force", "2", "3")


def test_the_text_is_that_of_files() -> None:
    mark = FORCE.mark("F_21t")
    assert (FORCE, mark, FORCE.pole, SCHEME_PLAN.mark("B")) == (
        "force:2-3",
        "force:2-3:F_21t",
        "force:2-3:p",
        "position:B",
    )
    assert hash(mark) == hash("force:2-3:F_21t") and json.dumps({FORCE: mark}) == '{"force:2-3": "force:2-3:F_21t"}'
    assert not NO_MARK and Mark(PlanId(""), "omega_2") == "omega_2"


def test_the_parts_are_asked_of_the_record() -> None:
    assert (FORCE.kind, FORCE.links, FORCE.mu_name, FORCE.unit, FORCE.is_force) == (
        "force",
        ("2", "3"),
        "mu_force:2-3",
        "N",
        True,
    )
    assert (FORCE.mark("F_21t").plan, FORCE.mark("F_21t").label) == (FORCE, "F_21t")
    assert (plan_of("omega_2"), label_of("omega_2")) == ("", "omega_2") and not PlanId("force").links


@pytest.mark.parametrize("text", ["velocity", "force:2-3", "force:1", "", "force:", "a:b:c", "x-y"])
def test_what_is_read_has_the_same_text(text: str) -> None:
    assert PlanId.read(text) == text
    assert PlanId.read("force:2-3").links == ("2", "3")


@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy, lambda one: pickle.loads(pickle.dumps(one))])
def test_copies_know_their_parts(copied: Callable[[Mark], Mark]) -> None:
    mark = copied(FORCE.mark("F_21t"))
    assert type(mark) is Mark and mark == "force:2-3:F_21t" and mark.label == "F_21t"
    assert type(mark.plan) is PlanId and (mark.plan.kind, mark.plan.links) == ("force", ("2", "3"))


def test_the_parts_stay() -> None:
    with pytest.raises(FrozenInstanceError):
        FORCE.kind = "velocity"
    with pytest.raises(FrozenInstanceError):
        FORCE.pole.label = "q"
