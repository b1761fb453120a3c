"""One frame of a lesson, in every language of lessons."""

import re
from collections.abc import Callable, Iterable, Mapping
from functools import cached_property
from itertools import zip_longest

from planes.lesson.formulas import SIGN_SLOT_KINDS, factors_of_slot
from planes.lesson.rows import Row
from planes.words import Lang
from planes.words.frozen import frozen, replace
from planes.words.names import MarkTuple, NamePair, NamesByName, NameTuple, PlanId

CENTRES_CHAPTER = "centres"
"""The chapter of instantaneous centres, which is not a plan."""
ROW_PATTERN = re.compile(r"⟪(\d+)⟫")


@frozen
class Frame:
    """One frame of a lesson. ``makes`` are the marks it adds, ``uses`` those it starts from (full names); ``equation``
    is the index of the vector equation being solved, ``terms`` the current vectors; ``marked`` and ``why`` its words by
    language; ``moments`` the index of the moment equation it states, or leads to; ``turns`` the vector carried to a
    point of the scheme to show the sense of its rotation about another, and the angular velocity from it. ``rows`` are
    its lines of calculation, each marked ⟪k⟫ in the words; ``numbers`` are all its numbers: how (see
    :mod:`planes.lesson.formulas`) and of which value. ``chapter`` is its plan; for moments that of their group.
    ``still`` is the sentence for a mark at the pole."""

    key: str
    plan: PlanId
    makes: MarkTuple
    uses: NameTuple
    equation: int | None
    terms: NameTuple
    marked: Mapping[Lang, str]
    why: Mapping[Lang, str]
    moments: int | None = None
    turns: NamesByName | None = None
    rows: tuple[Row, ...] = ()
    numbers: tuple[NamePair, ...] = ()
    chapter: str = ""
    still: NamesByName | None = None

    @cached_property
    def words_with_rows(self) -> dict[Lang, str]:
        """Its words by language, with its lines filled in."""
        return {
            lang: ROW_PATTERN.sub(lambda k, lang=lang: self.rows[int(k[1])].text_in_words(lang), text)  # type: ignore[misc]
            for lang, text in self.marked.items()
        }

    @property
    def shown_values(self) -> list[str]:
        """The values whose numbers it shows, not only their sense."""
        return [name for how, name in self.numbers if how not in SIGN_SLOT_KINDS]

    @property
    def needed_values(self) -> list[str]:
        """The values that its numbers depend on."""
        return [part for how, name in self.numbers if how != "n" for part in factors_of_slot(name)]


Frames = list[Frame]
Make = Callable[..., Frame]  # a frame with its words in every language


def with_chapters(frames: Frames) -> Frames:
    """The frames, each with its plan; a separate chapter includes the frames that find its values."""
    frames_with_chapters = []
    here = "position"
    for f, after in zip_longest(frames, frames[1:]):
        own = after.chapter if f.key == "found_values" and after else f.chapter
        here = here if own or (f.moments is not None and f.plan == "position") else f.plan
        frames_with_chapters.append(replace(f, chapter=own or here))
    return frames_with_chapters


def values_of_frames(frames: Iterable[Frame]) -> list[str]:
    """Names of all values in the frames, in order."""
    return list(dict.fromkeys(name for f in frames for name in f.needed_values))
