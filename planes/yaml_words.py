"""What is wrong with a file that is not YAML, in one short sentence instead of the reader's own message."""

from __future__ import annotations

from typing import Any

_PROBLEMS = (
    ("could not find expected ':'", "a ':' is missing after a key"),
    ("mapping values are not allowed", "a second ':' in one value, or wrong indentation; put such a text in quotes"),
    ("expected ',' or ']'", "a list [ ] is not closed, or a comma between its items is missing"),
    ("expected ',' or '}'", "a table { } is not closed, or a comma between its items is missing"),
    ("expected key", "the indentation is wrong here"),
    ("expected <block end>", "the indentation is wrong here"),
    ("expected '-' indicator", "the indentation is wrong here"),
    ("block sequence entries are not allowed", "a list item '-' cannot stand here"),
    ("expected <document start>", "there is something after the end of the scene"),
    ("unexpected end of stream", "a quote is not closed"),
    ("document indicator", "a quote is not closed"),
    ("unknown escape character", "an unknown escape \\ in double quotes; use single quotes"),
    ("did not find expected node content", "a value is missing here"),
    ("unexpected ':'", "a ':' cannot stand here; put such a text in quotes"),
)

_AT_START = ("a ':' is missing", "a list [ ]", "a table { }", "a quote")  # the line where it began tells more


def explained(error: Any, text: str) -> tuple[str, int | None]:
    """A sentence for the reader's error, and the line to look at."""
    problem = str(getattr(error, "problem", None) or getattr(error, "reason", None) or "unreadable")
    context = getattr(error, "context_mark", None)
    mark = getattr(error, "problem_mark", None) or context
    if mark is None:
        return f"not valid YAML: {problem}", None
    if "cannot start any token" in problem:
        rows = text.split("\n")
        char = rows[mark.line][mark.column : mark.column + 1] if mark.line < len(rows) else ""
        if char == "\t":
            return "a tab stands here; use spaces", mark.line + 1
        return f"a value cannot begin with {char}; put it in quotes", mark.line + 1
    for piece, words in _PROBLEMS:
        if piece in problem:
            start = context if context is not None and words.startswith(_AT_START) else mark
            return words, start.line + 1
    return f"not valid YAML: {problem}", mark.line + 1
