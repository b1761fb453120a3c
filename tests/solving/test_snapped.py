"""Scenes with one exact coincidence: a right number or one sentence, of one position, of a run, in every document."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.helpers.snapped import DOCUMENTS, FAMILIES, document_faults, faults, snapped

SOME, ALL = 2, 120  # of each family in the fast suite; of all in the slow one


@pytest.mark.parametrize("family", range(len(FAMILIES)), ids=[f.__name__.strip("_") for f in FAMILIES])
def test_a_coincidence_has_a_right_number_or_a_sentence(family: int) -> None:
    for seed in range(family, SOME * len(FAMILIES), len(FAMILIES)):
        one = snapped(seed)
        assert not [*faults(one)], f"scene {seed} ({one.family}):\n{one.text}"


@pytest.mark.few(0, slow=5)
@pytest.mark.parametrize("part", range(10))
def test_so_has_every_document_of_it(part: int, tmp_path: Path) -> None:
    for seed in range(part, ALL, 10):
        one, folder = snapped(seed), tmp_path / str(seed)
        folder.mkdir()
        wrong = [*faults(one), *document_faults(one, DOCUMENTS[seed // len(FAMILIES) % len(DOCUMENTS)], folder)]
        assert not wrong, f"scene {seed} ({one.family}):\n{one.text}"
