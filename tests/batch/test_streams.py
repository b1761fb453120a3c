"""Long tables as text: the same numbers, whichever way they are written."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

from planes.batch.cycle import Block, Reason
from planes.batch.streams import TableHead, open_block_writer


@pytest.mark.needs("orjson")
def test_csv_gives_the_same_numbers_with_orjson_and_without(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    rng, count = np.random.default_rng(3), 500
    table = rng.normal(size=(4, count)) * 10.0 ** rng.integers(-20, 20, (4, count))
    codes = rng.integers(0, 3, count)
    table[2, codes == 1] = np.nan
    head = TableHead(("phi", "°"), [(f"x{k}", "m") for k in range(4)], (Reason("arcs_apart", "C"), Reason("flat", "")))
    files = tmp_path / "one.csv", tmp_path / "two.csv"
    for file in files:
        with open_block_writer(file, head, count) as writer:
            writer.write_block(Block(np.arange(float(count)), table, codes))
        monkeypatch.setitem(sys.modules, "orjson", None)
    rows = [[line.split(",") for line in file.read_text("utf-8").splitlines()] for file in files]
    assert rows[0][0] == rows[1][0] and len(rows[0]) == count + 1
    for one, two in zip(rows[0][1:], rows[1][1:], strict=True):
        assert one[-1] == two[-1] and [float(x or "nan") for x in one[:-1]] == pytest.approx(
            [float(x or "nan") for x in two[:-1]], rel=0, abs=0, nan_ok=True
        )
