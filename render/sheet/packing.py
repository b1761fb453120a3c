"""Whether views find room on a paper: blocks of them in columns on its module."""

from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache

from render.sheet.columns import OVER, Columns, Item
from render.sheet.frame import Paper
from render.sheet.module import GAP_MM, Module
from render.sheet.stacking import Stacking
from render.views import View, plumbed


def blocks(views: Sequence[View]) -> list[list[View]]:
    """Views put beneath each other in any case: those of one block."""
    stacks = list[list[View]]()
    for v in views:
        if v.block and stacks and stacks[-1][-1].block == v.block:
            stacks[-1].append(v)
        else:
            stacks.append([v])
    return [plumbed(block) for block in stacks]


def stacking_of(views: Sequence[View], paper: Paper) -> Stacking:
    """How views may fill the module, with the results for earlier columns."""
    wide, usual = max((v.width for b in blocks(views) for v in b), default=0.0), Module(paper.field, paper.taken)
    return stacking_on(usual if usual.span(wide) <= usual.widest else replace(usual, wide=wide))


@lru_cache(maxsize=8)
def stacking_on(module: Module) -> Stacking:
    """The results for columns on a module; they are dropped when a new sheet is begun."""
    return Stacking(module)


def columns_of(views: Sequence[View], stacking: Stacking) -> Columns:
    """The views in columns, in the order given."""
    items = []
    for block in blocks(views):
        high = sum(v.height + GAP_MM for v in block) - GAP_MM
        items.append(Item(max(v.width for v in block), high, block[0].step, not block[0].figure))
    return Columns(items, stacking)


def packed(views: Sequence[View], paper: Paper) -> bool:
    """Whether there is room for all views on the paper."""
    return columns_of(views, stacking_of(views, paper)).arranged(enough=OVER)[1].cost < OVER
