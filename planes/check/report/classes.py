"""The drawings of a class: what was found in each, or why it could not be read."""

from __future__ import annotations

from dataclasses import dataclass, field

from planes.check import STATUS, Outcome
from planes.check.report.rows import as_json
from planes.words import Lang, say
from planes.words.errors import PlanesError
from planes.words.records import Json


def heads(lang: Lang) -> list[str]:
    """Names of the columns of a table of drawings."""
    return [say(k, lang) for k in ("check_file", "check_verdict", "check_mark", "check_first")]


@dataclass
class Checked:
    """One drawing of the folder: what was found in it, or why nothing could be."""

    file: str
    found: Outcome | None = None
    refused: PlanesError | None = None
    report: str = ""

    @property
    def verdict(self) -> str:
        """right, wrong or unreadable."""
        return self.found.verdict if self.found else "unreadable"

    @property
    def first(self) -> str:
        """Where it goes wrong."""
        return (self.found.first_wrong or "") if self.found and self.verdict == "wrong" else ""

    def said(self, lang: Lang) -> str:
        """Which mistake it is, why it cannot be read, or what was not seen of it; nothing of a right one."""
        if self.found is None:
            return self.refused.told(lang) if self.refused else ""
        return "" if self.verdict == "right" and not self.found.unseen else self.found.sentence.told(lang)

    def row(self, lang: Lang) -> list[str]:
        """File, verdict, mark, sentence."""
        return [self.file, say(f"verdict_{self.verdict}", lang), self.first, self.said(lang)]

    def as_json(self, lang: Lang) -> Json:
        """The object of the drawing, with its file."""
        if self.found:
            return {"file": self.file, **as_json(self.found, lang)}
        return {"file": self.file, "verdict": self.verdict, "sentence": {one: self.said(one) for one in ("ru", "en")}}


@dataclass
class ClassWork:
    """All drawings of a folder."""

    title: str
    all: list[Checked] = field(default_factory=list)

    @property
    def status(self) -> int:
        """The worst exit status of all."""
        return max((STATUS[one.verdict] for one in self.all), default=2)
