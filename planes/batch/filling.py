"""All columns of many positions in one table, by one call of machine code where every position holds; several threads
share the positions."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from typing import Protocol

import numpy as np

from planes.batch.compiled import CompiledLoop
from planes.batch.table import Block
from planes.geometry.arrays import Array, Indices


class Fillable(Protocol):
    """A program ready for many positions, its loop compiled."""

    @property
    def compiled(self) -> CompiledLoop:
        """The loop."""

    @property
    def straight(self) -> bool:
        """Whether only the drive moves, and positions are clear of rounding."""

    def blocks(self, values: Array, *, fast: bool, bare: bool, out: Array) -> Iterator[Block]:
        """Blocks of positions, their tables in ``out``."""


def filled(cycle: Fillable, values: Array, fast: bool, bare: bool, out: Array, threads: int) -> Indices:
    """The codes; every column is in its row of ``out``. Threads only run in parallel in machine code."""
    codes: Indices = np.zeros(len(values), np.intp)
    if threads == 1:
        _fill(cycle, values, fast, bare, out, codes)
        return codes
    from concurrent.futures import ThreadPoolExecutor

    _fill(cycle, values[:1], fast, bare, out[:, :1], codes[:1])  # shared by threads, so made before they begin
    cuts = [round(k * len(values) / threads) for k in range(threads + 1)]
    with ThreadPoolExecutor(threads) as pool:
        work = [pool.submit(_fill, cycle, values[a:b], fast, bare, out[:, a:b], codes[a:b]) for a, b in pairwise(cuts)]
    for one in work:
        one.result()
    return codes


def _fill(cycle: Fillable, values: Array, fast: bool, bare: bool, out: Array, codes: Indices) -> None:
    straight = fast and cycle.straight and out.strides[1] == values.itemsize
    if straight and len(values) and cycle.compiled.fill(values, out):
        return
    start = 0
    for block in cycle.blocks(values, fast=fast, bare=bare, out=out):
        codes[start : start + len(block.codes)] = block.codes
        start += len(block.codes)
