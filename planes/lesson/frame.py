"""One frame of a lesson, told in every language of lessons."""

import re
from collections.abc import Callable, Iterable, Mapping
from functools import cached_property
from itertools import zip_longest

from planes.lesson.formulas import SIGNS, own
from planes.lesson.rows import Row
from planes.words import Lang
from planes.words.frozen import frozen, replace

CENTRES = "centres"
"""The chapter of instantaneous centres, which is no plan."""
ROW = re.compile(r"⟪(\d+)⟫")


@frozen
class Frame:
    """One frame of a lesson. ``makes`` are the marks it adds, ``uses`` those it stands on (full names); ``equation``
    is the index of the vector equation being solved, ``terms`` the vectors in hand; ``marked`` and ``why`` its words by
    language; ``moments`` the index of the moment equation it states, or leads to; ``turns`` the vector carried to a
    point of the scheme to see which way it turns about another, and the rate found so. ``rows`` are its lines of
    reckoning, each ⟪k⟫ where it stands in the words; ``numbers`` are all that it tells: how (see
    :mod:`planes.lesson.formulas`) and of which value. ``chapter`` is the plan it serves: of moments, that of their
    group. ``still`` is what is said where its mark lies at the pole.
    """

    key: str
    plan: str
    makes: tuple[str, ...]
    uses: tuple[str, ...]
    equation: int | None
    terms: tuple[str, ...]
    marked: Mapping[Lang, str]
    why: Mapping[Lang, str]
    moments: int | None = None
    turns: Mapping[str, str] | None = None
    rows: tuple[Row, ...] = ()
    numbers: tuple[tuple[str, str], ...] = ()
    chapter: str = ""
    still: Mapping[str, str] | None = None

    @cached_property
    def said(self) -> dict[Lang, str]:
        """Its words by language, with its lines in them."""
        return {lang: ROW.sub(lambda k: self.rows[int(k[1])].text(lang), text) for lang, text in self.marked.items()}  # noqa: B023

    @property
    def used(self) -> list[str]:
        """The values it gives as numbers, not by their sense alone."""
        return [name for how, name in self.numbers if how not in SIGNS]

    @property
    def values(self) -> list[str]:
        """The values its numbers are read off."""
        return [part for how, name in self.numbers if how != "n" for part in own(name)]


Make = Callable[..., Frame]  # a frame with its words in every language


def in_chapters(frames: list[Frame]) -> list[Frame]:
    """The frames, each with the plan it serves; a chapter of its own takes in what is found for it."""
    frames_with_chapters, here = list[Frame](), "position"
    for f, after in zip_longest(frames, frames[1:]):
        own = after.chapter if f.key == "found_values" and after else f.chapter
        here = here if own or (f.moments is not None and f.plan == "position") else f.plan
        frames_with_chapters.append(replace(f, chapter=own or here))
    return frames_with_chapters


def needed(frames: Iterable[Frame]) -> list[str]:
    """Names of all values the frames need, in order."""
    return list(dict.fromkeys(name for f in frames for name in f.values))
