"""Sentences that ask for corrections of marks: each names the method available to its reader."""

from typing import Literal

from planes.words import Phrase

Reader = Literal["here", "sheet", "table"]
"""The reader of a method: at the drawing itself, at a row of a class, or without a picture for moving marks."""


def phrase_with_remedy(key: str, way: str = "report", /, **parts: object) -> Phrase:
    """A sentence with a method of correcting marks, for a user of the command line."""
    return Phrase(key, **parts, way=Phrase(f"check_way_{way}", **parts))


def phrase_for_reader(reader: Reader, phrase: Phrase) -> Phrase:
    """The same sentence with the method available to another reader; any other sentence unchanged."""
    way = phrase.parts.get("way")
    if not isinstance(way, Phrase):
        return phrase
    return Phrase(phrase.key, **{**phrase.parts, "way": Phrase(f"{way.key}_{reader}", **way.parts)})
