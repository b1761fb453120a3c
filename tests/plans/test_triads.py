"""Groups of class III: every number against the independent solver, every assembly against an independent count."""

from __future__ import annotations

import random
from itertools import combinations_with_replacement

import pytest

from tests.helpers.mechanisms import KINDS, make
from tests.plans.test_against_oracle import examine

LEADS = ("RR", "PR", "RP")
MIXTURES = ["-".join(m) for m in combinations_with_replacement(LEADS, 3)]


@pytest.mark.parametrize("leads", MIXTURES)
def test_every_mixture_of_leads_with_loads_on_every_link(leads: str) -> None:
    for seed in range(4):
        rng = random.Random(f"{leads} {seed}")
        examine(make(rng, ["-".join(rng.sample(leads.split("-"), 3))]))


def test_after_and_before_dyads() -> None:
    for seed in range(12):
        rng = random.Random(f"chain {seed}")
        kinds = [rng.choice(KINDS), rng.choice(MIXTURES), rng.choice(KINDS)]
        examine(make(rng, kinds[seed % 3 == 0 :]))


@pytest.mark.parametrize(("kind", "seed"), [("RPP", 52), ("RRP", 0)])
def test_a_special_point_is_not_taken_for_a_point_of_a_guide_under_a_slider(kind: str, seed: int) -> None:
    """Both would be called by the letter of a hinge, S, and the name of the basic link."""
    examine(make(random.Random(f"after {kind} {seed}"), ["RR-RR-PR", kind]))
