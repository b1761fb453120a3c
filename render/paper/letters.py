"""Names in running text: ⟨a_CB^t⟩ as pieces of plain, lowered and raised letters."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from html import escape
from typing import get_args

from planes.words import Lang
from planes.words.lettering import Naming
from planes.words.records import Json

NAME = re.compile(r"⟨([^⟩]*)⟩")
_PIECE = re.compile(r"([_^])\{([^}]*)\}")


@dataclass(frozen=True)
class Piece:
    """A run of text: ``shift`` "sub", "sup" or "" on the line; ``name`` where it is a letter of a quantity."""

    text: str
    shift: str = ""
    name: bool = False


def pieces(text: str, naming: Naming, plan: str = "") -> Iterator[Piece]:
    """The runs of a sentence; _{…} and ^{…} in it are indices too."""
    for k, part in enumerate(NAME.split(text)):
        yield from _split(naming.named(part, plan) if k % 2 else part, bool(k % 2))


def tagged(text: str, naming: Naming, plan: str = "") -> str:
    """The sentence in tags, as HTML and reportlab know them: names in italics, indices lowered and raised."""
    found = ""
    for piece in pieces(text, naming, plan):
        inner = escape(piece.text)
        inner = f"<{piece.shift}>{inner}</{piece.shift}>" if piece.shift else inner
        found += f"<i>{inner}</i>" if piece.name else inner
    return found


def written(names: Iterable[str], lettering: Json) -> dict[str, dict[str, list[tuple[str, str]]]]:
    """Names for a page's script, in both languages: pieces of text, each lowered ("sub"), raised or neither."""
    namings, names = [Naming(lang, **lettering) for lang in get_args(Lang)], dict.fromkeys(names)
    pole = {"acceleration:p": [("π", "")]}
    return {
        n.lang: pole | {name: [(p.text, p.shift) for p in _split(n.named(name), True)] for name in names}
        for n in namings
    }


def _split(text: str, name: bool) -> Iterator[Piece]:
    end = 0
    for match in _PIECE.finditer(text):
        if match.start() > end:
            yield Piece(text[end : match.start()], "", name)
        yield Piece(match[2], "sub" if match[1] == "_" else "sup", name)
        end = match.end()
    if end < len(text):
        yield Piece(text[end:], "", name)
