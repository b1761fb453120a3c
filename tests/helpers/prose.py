"""Sentences of a page for people, and their lengths."""

import re


def sentences(text: str) -> list[str]:
    """The sentences of a page, and the cells of its tables; code counts as a word."""
    text = re.sub(r"```.*?```|<!--.*?-->", "", text, flags=re.S)
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", re.sub(r"`[^`]*`", "Code", text))
    blocks = [block for block in re.split(r"\n\s*\n|\n(?=[-*|#\d])", text) if block.strip()]
    parts = [cell for b in blocks for cell in (b.split("|") if b.lstrip().startswith("|") else [b])]
    return [s for part in parts for s in re.split(r"(?<=[.!?:])\s+(?=[A-ZА-Я*«])", part.replace("\n", " ").strip())]


def words_of(sentence: str) -> int:
    """The number of words."""
    return len(re.findall(r"[\w'’-]+", sentence))
