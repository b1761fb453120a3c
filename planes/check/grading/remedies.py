"""Sentences that ask for marks to be put right: each says the way that is open where it is read."""

from typing import Literal

from planes.words import Phrase

Reader = Literal["here", "sheet", "table"]
"""Who reads of a way: one before the drawing itself, or a row of a class, or one without a picture to move marks on."""


def asking(key: str, way: str = "report", /, **parts: object) -> Phrase:
    """A sentence with a way of putting marks right, told to a person at the command line."""
    return Phrase(key, **parts, way=Phrase(f"check_way_{way}", **parts))


def told_to(reader: Reader, phrase: Phrase) -> Phrase:
    """The same sentence with the way that is open to another reader; any other as it is."""
    way = phrase.parts.get("way")
    if not isinstance(way, Phrase):
        return phrase
    return Phrase(phrase.key, **{**phrase.parts, "way": Phrase(f"{way.key}_{reader}", **way.parts)})
