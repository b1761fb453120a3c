"""Names in running text: ⟨a_CB^t⟩ as pieces of plain, lowered and raised letters."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from html import escape

from render.paper.names import Naming, lettered

_NAME = re.compile(r"⟨([^⟩]*)⟩")
_PIECE = re.compile(r"([_^])\{([^}]*)\}")
_PARTS = re.compile(r"^(F_.*\d)([tn])$")


@dataclass(frozen=True)
class Piece:
    """A run of text: ``shift`` "sub", "sup" or "" on the line; ``name`` where it is a letter of a quantity."""

    text: str
    shift: str = ""
    name: bool = False


def pieces(text: str, naming: Naming, plan: str = "") -> Iterator[Piece]:
    """The runs of a sentence; _{…} and ^{…} in it are indices too."""
    for k, part in enumerate(_NAME.split(text)):
        yield from _split(_named(part, naming, plan) if k % 2 else part, bool(k % 2))


def tagged(text: str, naming: Naming, plan: str = "") -> str:
    """The sentence in tags, as HTML and reportlab know them: names in italics, indices lowered and raised."""
    found = ""
    for piece in pieces(text, naming, plan):
        inner = escape(piece.text)
        inner = f"<{piece.shift}>{inner}</{piece.shift}>" if piece.shift else inner
        found += f"<i>{inner}</i>" if piece.name else inner
    return found


def _named(name: str, naming: Naming, plan: str) -> str:
    """A name with its indices marked up."""
    plain = name.strip("|‖°").removesuffix("_given")
    letter, _, index = plain.partition("_")
    if letter in ("h", "H") and index:
        return naming.arm(index.partition("^")[0].rpartition("_")[0] if letter == "h" else index, plain)
    if letter in ("MZ", "FZ"):
        return f"{letter[0]}_{{{index}}}^{{{'Ж' if naming.lang == 'ru' else 'Z'}}}"
    if letter == "MR":
        return f"M({naming.vector(index)})"
    if "'" in plain or plain == "p" or (letter in ("n", "k") and index):
        return naming.mark(plain, plan)
    if not index:
        return lettered(plain)
    return naming.vector(_PARTS.sub(r"\1^\2", plain))


def _split(text: str, name: bool) -> Iterator[Piece]:
    end = 0
    for match in _PIECE.finditer(text):
        if match.start() > end:
            yield Piece(text[end : match.start()], "", name)
        yield Piece(match[2], "sub" if match[1] == "_" else "sup", name)
        end = match.end()
    if end < len(text):
        yield Piece(text[end:], "", name)
