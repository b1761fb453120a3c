"""Results for pictures as one table: the drawing against the findings, and the errors of marks."""

from __future__ import annotations

from dataclasses import dataclass, field, fields

HEAD = ("right", "found", "step", "named", "unread", "false", "misled", "s", "mm 50 %", "mm 95 %", "in 2σ", "as seen")


@dataclass(frozen=True)
class Truth:
    """The content of a drawing: right or wrong; (mistake, mark) pairs that identify its mistake."""

    verdict: str
    causes: frozenset[tuple[str | None, str | None]] = frozenset()


@dataclass
class Tally:
    """The results for pictures."""

    right: int = 0
    accepted: int = 0
    as_seen: int = 0  # of all: no mistake found, but not every mark seen
    wrong: int = 0
    found: int = 0
    step: int = 0
    named: int = 0
    unread: int = 0
    false: int = 0  # right called wrong, wrong accepted
    seconds: float = 0.0
    errors: list[float] = field(default_factory=list)
    inside: int = 0  # marks within 2σ, by the stated σ of each

    @staticmethod
    def of(
        truth: Truth,
        verdict: str,
        first: str | None,
        mistake: str | None,
        errors: list[float],
        seconds: float,
        inside: int = 0,
    ) -> Tally:
        """The result for one picture."""
        out = Tally(seconds=seconds, errors=errors, unread=int(verdict == "unreadable"), inside=inside)
        out.as_seen = int(verdict == "right_as_seen")
        out.false = int(verdict in ("right", "wrong") and verdict != truth.verdict)
        if truth.verdict == "right":
            out.right, out.accepted = 1, int(verdict == "right")
            return out
        out.wrong, out.found = 1, int(verdict == "wrong")
        out.step = int(verdict == "wrong" and first in {mark for _, mark in truth.causes})
        out.named = int(out.step and (mistake, first) in truth.causes)
        return out

    def add(self, other: Tally) -> None:
        for one in fields(self):
            setattr(self, one.name, getattr(self, one.name) + getattr(other, one.name))

    def row(self) -> list[str]:
        """Cells of the table."""
        count, errors = self.right + self.wrong, sorted(self.errors)
        off = [f"{errors[int(share * (len(errors) - 1))]:.2f}" if errors else "–" for share in (0.5, 0.95)]
        shares = [f"{self.accepted}/{self.right}", *(f"{n}/{self.wrong}" for n in (self.found, self.step, self.named))]
        told = [f"{self.unread}/{count}", str(self.false), str(self.found - self.step)]
        seen = [f"{self.inside}/{len(errors)}", str(self.as_seen)]
        return [*shares, *told, f"{self.seconds / max(count, 1):.1f}", *off, *seen]


def line(name: str, cells: list[str] | tuple[str, ...]) -> str:
    """A row as text."""
    return f"{name:22}" + "".join(f"{c:>9}" for c in cells)
