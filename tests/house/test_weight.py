"""What the code weighs, in nodes of its syntax trees: these ceilings only ever come down.

Where they are to come: 60 nodes in the median function, 200 in nine of ten, 11 to a line of code, 620 000 in all.
"""

from __future__ import annotations

import ast
import io
import statistics
import tokenize
from functools import cache

from tests.house.test_rooms import MODULES, tree

MOST, MEDIAN, NINE_IN_TEN, LONGEST, TO_A_LINE = 682_055, 87, 258, 722, 10.98
_BLANK = {tokenize.COMMENT, tokenize.NL, tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT, tokenize.ENDMARKER}


def nodes(part: ast.AST, functions: list[int]) -> int:
    """Nodes of a part of a tree; those of each function in it are added to a list."""
    count = 1 + sum(nodes(inner, functions) for inner in ast.iter_child_nodes(part))
    if isinstance(part, ast.FunctionDef | ast.AsyncFunctionDef):
        functions.append(count)
    return count


def code_lines(text: str) -> int:
    """Lines that hold code, or a part of a text."""
    tokens = (t for t in tokenize.generate_tokens(io.StringIO(text).readline) if t.type not in _BLANK)
    return len({line for t in tokens for line in range(t.start[0], t.end[0] + 1)})


@cache
def counted() -> tuple[int, int, list[int]]:
    """Nodes and lines of all files, and the nodes of each function."""
    every = lines = 0
    functions: list[int] = []
    for path in MODULES.values():
        every += nodes(tree(path), functions)
        lines += code_lines(path.read_text("utf-8"))
    return every, lines, functions


def test_the_whole_weighs_no_more() -> None:
    assert counted()[0] <= MOST


def test_functions_are_no_denser() -> None:
    every, lines, functions = counted()
    assert statistics.median(functions) <= MEDIAN
    assert statistics.quantiles(functions, n=10)[8] <= NINE_IN_TEN
    assert max(functions) <= LONGEST
    assert every / lines <= TO_A_LINE


FUNCTIONS = ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda
SILENT = {"found", "told", "whole", "of"}
"""Names that say nothing of what they hold."""


def test_no_local_is_called_by_a_name_that_says_nothing() -> None:
    silent = set()
    for module, path in MODULES.items():
        for inner in (n for f in ast.walk(tree(path)) if isinstance(f, FUNCTIONS) for n in ast.walk(f)):
            stored = isinstance(inner, ast.Name) and isinstance(inner.ctx, ast.Store) and inner.id in SILENT
            if stored or (isinstance(inner, ast.arg) and inner.arg in SILENT):
                silent.add(f"{module}:{inner.lineno}")
    assert not silent
