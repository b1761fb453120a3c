"""The English of docstrings, comments and messages has none of the phrases of a word-by-word translation."""

from __future__ import annotations

import ast
import inspect
import io
import re
import tokenize
from collections.abc import Iterator
from pathlib import Path

import pytest

from planes.words import sentence_table
from tests.helpers import ROOT
from tests.house.test_rooms import MODULES, tree

BANNED = {
    "told": r"(?:is|are) told",
    "own": r"of (?:its|their) own",
    "what stands": r"what (?:stands|there is)",
    "said": r"(?:is|are) said",
    "it is that": r"which \w+ it is that",
    "things": r"(?<!`)things?(?!`)",
    "as it has": r"as (?!soon)\w+ as it has",
    "what it is": r"what it is",
}


def prose(path: Path) -> Iterator[str]:
    """Docstrings, texts below attributes, and comments of a file, each on one line."""
    for node in ast.walk(tree(path)):
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str):
            yield " ".join(inspect.cleandoc(node.value.value).split())
    for token in tokenize.generate_tokens(io.StringIO(path.read_text("utf-8")).readline):
        if token.type == tokenize.COMMENT:
            yield token.string


def found(pattern: str, texts: dict[str, list[str]]) -> list[str]:
    """The places of a phrase."""
    phrase = re.compile(rf"\b{pattern}\b", re.I)
    return [f"{where}: {text}" for where, some in texts.items() for text in some if phrase.search(text)]


@pytest.fixture(scope="module")
def docstrings() -> dict[str, list[str]]:
    """The prose of every module by its name."""
    return {name: list(prose(path)) for name, path in MODULES.items()}


@pytest.mark.parametrize("phrase", BANNED)
def test_no_docstring_or_comment_is_translated_word_by_word(phrase: str, docstrings: dict[str, list[str]]) -> None:
    assert not found(BANNED[phrase], docstrings)


@pytest.mark.parametrize("phrase", BANNED)
def test_no_message_is_translated_word_by_word(phrase: str) -> None:
    files = {
        f.stem: list(sentence_table("en", f.stem).values()) for f in (ROOT / "planes" / "words" / "en").glob("*.json")
    }
    assert len(files) > 25 and not found(BANNED[phrase], files)


def test_the_phrases_are_found_where_they_are() -> None:
    assert found(BANNED["things"], {"here": ["Nothing, and then a thing."]})
    assert not found(BANNED["things"], {"here": ["Nothing, something, anything; the ``things`` of a name."]})
    assert found(BANNED["own"], {"here": ["A scale of\n its own".replace("\n", "")]})
