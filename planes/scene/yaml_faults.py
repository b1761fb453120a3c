"""The fault in a file that is not YAML, in one short sentence instead of the reader's own message."""

import re

from planes.words import Phrase

_PROBLEM_TABLE_TEXT = """
could not find expected ':' = colon_missing
mapping values are not allowed = colon_second
expected ',' or ']' = list_open
expected ',' or '}' = table_open
expected key = indentation
expected <block end> = indentation
expected '-' indicator = indentation
block sequence entries are not allowed = list_item
expected <document start> = after_end
unexpected end of stream = quote_open
document indicator = quote_open
unknown escape character = escape
did not find expected node content = value_absent
unexpected ':' = colon_here
"""

_RARE_PROBLEM_KEYS = {
    "": "unreadable",
    "found a tab character that violates indentation": "tab_in_indentation",
    "found incompatible YAML document": "other_yaml",
}

_GLUED_KEY_PATTERN = re.compile(r"\s*(?:- )?\{?\s*([\w-]+):[^\s:/]")  # a key whose colon is not followed by a space

_COLON_PROBLEM_KEYS = ("colon_missing", "colon_second")
# the line where it began tells more
_PROBLEMS_TOLD_AT_START = ("colon_missing", "list_open", "table_open", "quote_open")


def explain_yaml_error(error: Exception, text: str) -> tuple[Phrase, int | None]:
    """A sentence for the reader's error, and the line to look at."""
    problem = str(getattr(error, "problem", None) or getattr(error, "reason", None) or "")
    context = getattr(error, "context_mark", None)
    mark = getattr(error, "problem_mark", None) or context
    if mark is None:
        return _other_problem(problem), None
    rows = text.split("\n")
    if "cannot start any token" in problem:
        char = rows[mark.line][mark.column : mark.column + 1] if mark.line < len(rows) else ""
        if char == "\t":
            return Phrase("tab"), mark.line + 1
        return Phrase("value_begins", char=char), mark.line + 1
    for piece, _, key in (line.partition(" = ") for line in _PROBLEM_TABLE_TEXT.split("\n")[1:-1]):
        if piece in problem:
            start = context if context is not None and key in _PROBLEMS_TOLD_AT_START else mark
            for line in (start.line, start.line - 1) if key in _COLON_PROBLEM_KEYS else ():
                if 0 <= line < len(rows) and (glued := _GLUED_KEY_PATTERN.match(rows[line])):
                    return Phrase("colon_space", key=glued[1]), line + 1
            return Phrase(key), start.line + 1
    return _other_problem(problem), mark.line + 1


def _other_problem(problem: str) -> Phrase:
    key = _RARE_PROBLEM_KEYS.get(problem)
    return Phrase("not_yaml", problem=Phrase(key) if key else problem)
