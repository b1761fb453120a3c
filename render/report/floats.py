"""Figures of a paged report float: one without room on its page moves to the head of the next, and the text after it
fills the page before."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from reportlab.platypus import Flowable

from planes.words.frozen import frozen


@frozen
class PagePiece:
    """Elements kept together: a figure with its caption, a heading with the first block after it."""

    parts: Sequence[Flowable]
    floats: bool = False


@dataclass
class Filled:
    """A page filled in the manner of reportlab: the height used, and the space after the last element."""

    width: float
    height: float
    used: float = 0.0
    after: float = 0.0

    def has_room_for(self, piece: PagePiece) -> bool:
        """Whether a piece has room."""
        return self.heights_with(piece.parts)[0] <= self.height

    def heights_with(self, parts: Sequence[Flowable]) -> tuple[float, float]:
        """The height used, and the space after it, with these elements added."""
        used = self.used
        after = self.after
        for part in parts:
            used += (max(after, part.getSpaceBefore()) if used else 0.0) + part.wrap(self.width, self.height)[1]
            after = part.getSpaceAfter()
        return used, after

    def add_piece(self, piece: PagePiece) -> None:
        """Add an element; one without room begins the next page, a paragraph with its remainder."""
        if not self.has_room_for(piece):
            parts = piece.parts
            room = self.height - self.used - max(self.after, piece.parts[0].getSpaceBefore())
            rest = parts[0].split(self.width, room)[1:] if len(parts) == 1 else []
            self.used = self.after = 0.0
            piece = PagePiece(rest or parts)
        self.used, self.after = self.heights_with(piece.parts)
        self.used = min(self.used, self.height)


def join_kept_together(blocks: Iterable[PagePiece]) -> list[PagePiece]:
    """Elements joined to those they must precede; a figure right after its heading stays there."""
    groups = []
    held = list[Flowable]()
    for piece in blocks:
        if piece.parts and piece.parts[-1].getKeepWithNext():
            held += piece.parts
        elif piece.parts:
            groups.append(PagePiece([*held, *piece.parts], piece.floats and not held))
            held = []
    return [*groups, PagePiece(held)] if held else groups


def float_figures(pieces: Iterable[PagePiece], page: Filled) -> list[Flowable]:
    """All elements, in the order in which pages are full; figures keep their order."""
    set_pieces, waiting = list[PagePiece](), list[PagePiece]()

    def put(*those: PagePiece) -> None:
        for one in those:
            page.add_piece(one)
            set_pieces.append(one)

    for piece in pieces:
        full = not page.has_room_for(piece)
        if piece.floats and (full or waiting):
            waiting.append(piece)
            continue
        if waiting and full:
            put(*waiting)
            waiting.clear()
        put(piece)
    return [part for piece in (*set_pieces, *waiting) for part in piece.parts]
