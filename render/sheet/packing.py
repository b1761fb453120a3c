"""Whether views find room on a paper: blocks of them in columns on its module."""

from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache

from render.sheet.columns import OVERFULL_COLUMN_COST, Columns, Item
from render.sheet.frame import Paper
from render.sheet.module import VIEW_GAP_MM, Module
from render.sheet.stacking import Stacking
from render.views import View, align_plumb_lines


def group_into_blocks(views: Sequence[View]) -> list[list[View]]:
    """Views put beneath each other in any case: those of one block."""
    stacks = list[list[View]]()
    for v in views:
        if v.block and stacks and stacks[-1][-1].block == v.block:
            stacks[-1].append(v)
        else:
            stacks.append([v])
    return [align_plumb_lines(block) for block in stacks]


def stacking_for_paper(views: Sequence[View], paper: Paper) -> Stacking:
    """How views may fill the module, with the results for earlier columns."""
    wide = max((v.width for b in group_into_blocks(views) for v in b), default=0.0)
    usual = Module(paper.field, paper.occupied_areas)
    return stacking_for_module(usual if usual.span_of_width(wide) <= usual.most_span else replace(usual, wide=wide))


@lru_cache(maxsize=8)
def stacking_for_module(module: Module) -> Stacking:
    """The results for columns on a module; they are dropped when a new sheet is begun."""
    return Stacking(module)


def make_columns(views: Sequence[View], stacking: Stacking) -> Columns:
    """The views in columns, in the order given."""
    items = []
    for block in group_into_blocks(views):
        high = sum(v.height + VIEW_GAP_MM for v in block) - VIEW_GAP_MM
        items.append(Item(max(v.width for v in block), high, block[0].step, not block[0].figure))
    return Columns(items, stacking)


def has_room_for_all(views: Sequence[View], paper: Paper) -> bool:
    """Whether there is room for all views on the paper."""
    return (
        make_columns(views, stacking_for_paper(views, paper))
        .best_arrangement(enough=OVERFULL_COLUMN_COST)[1]
        .total_cost
        < OVERFULL_COLUMN_COST
    )
