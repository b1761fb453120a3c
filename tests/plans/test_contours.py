"""Groups of class IV: every number against the independent solver."""

from __future__ import annotations

import random

from tests.helpers.mechanisms import KINDS, make
from tests.plans.test_against_oracle import examine


def test_alone_with_loads_on_every_link() -> None:
    for seed in range(6):
        examine(make(random.Random(f"contour {seed}"), ["IV"]))


def test_after_and_before_other_groups() -> None:
    for seed in range(9):
        rng = random.Random(f"contour in a chain {seed}")
        kinds = [rng.choice([*KINDS, "RR-PR-RP", "IV"]), "IV", rng.choice(KINDS)]
        examine(make(rng, kinds[seed % 3 == 0 :]))
