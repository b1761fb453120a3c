"""Nobody takes a name of a program apart but ``planes/words``: whoever makes a name says what it means."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator

import pytest

from tests.house.test_rooms import MODULES, room_of, tree

APART = ("startswith", "endswith", "removeprefix", "removesuffix", "partition", "rpartition")
NAMED = re.compile(r"(\w+_|[\^_:][tn]?|[-+]|_given|slide|h|°|[°∥⊥~∠→|‖]+|(?:position|velocity|motion|force):?|[xyt]|q)")
"""What a name of a program begins or ends with; "." of a file, "#" of a comment and the like are nobody's name."""


def named(node: ast.expr) -> bool:
    """Whether a text in an expression begins or ends a name."""
    texts = (n.value for n in ast.walk(node) if isinstance(n, ast.Constant) and isinstance(n.value, str))
    return any(NAMED.fullmatch(t) for t in texts)


def parsers(module: str) -> Iterator[int]:
    """Lines where a text that may be a name is taken apart."""
    for node in ast.walk(tree(MODULES[module])):
        match node:
            case ast.Call(func=ast.Attribute(attr=verb), args=[text, *_]) if verb in APART and named(text):
                yield node.lineno
            case ast.Compare(left=ast.Subscript(), ops=[ast.In() | ast.NotIn()], comparators=[text]) if named(text):
                yield node.lineno


@pytest.mark.slow
def test_names_are_taken_apart_where_they_are_made() -> None:
    rooms = [m for m in MODULES if m.count(".") and room_of(m) != "words"]
    assert not [f"{module}:{line}" for module in rooms for line in parsers(module)]


@pytest.mark.slow
def test_no_key_of_a_word_is_taken_for_a_name() -> None:
    """A key of the tables of words is read whole; what keys share is asked of the tables themselves (``under``)."""
    takers = ("name_index", "letter_of", "split_value_name", "component_axis")
    calls = ((module, node) for module in MODULES for node in ast.walk(tree(MODULES[module])))
    given = {
        f"{module}:{node.lineno}"
        for module, node in calls
        if isinstance(node, ast.Call) and getattr(node.func, "id", "") in takers
        for argument in node.args
        if getattr(argument, "id", "") == "key"
    }
    assert not given


def test_pages_know_no_grammar_of_names() -> None:
    """What the lesson's scripts draw by is told them: letters, helping marks, corners of vectors."""
    from render.page.web_page import page_files_text

    assert not re.search(r"\^\[nk\]_|\[[⊥°]{2}\]|_given|MZ|omega", page_files_text("figure.js", "plan.js", "scheme.js"))
