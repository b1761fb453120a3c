"""What a step of a drawing is: one named thing made from things made before, as a frozen record.

A step makes a mark in mm on a plan, a direction, or a value in SI; marks are named "plan:label" ("velocity:c"). It is
drawn by an instrument (``tool``), which owns the arithmetic, the errors of hand and ruler, and what a failure does;
so the same step serves one position or an array of many.
"""

from dataclasses import dataclass, field
from functools import partial
from typing import ClassVar, Literal, get_args

from planes.drafting.tools import Env, Thing, Tool
from planes.words.names import HELPERS, Meaning

Kind = Literal["mark", "direction", "value", "place"]
KINDS: tuple[Kind, ...] = get_args(Kind)
Read = tuple[str, Kind]


@dataclass(frozen=True)
class Step:
    """One step; ``makes`` is the name of what it draws or reckons, ``means`` what that name means, where it is said."""

    makes: str
    means: Meaning | None = field(default=None, kw_only=True, compare=False, repr=False)
    kind: ClassVar[Kind] = "mark"
    needs: ClassVar[tuple[Read, ...]] = ()  # the fields that name what the step needs, each with the kind of that

    @property
    def quantity(self) -> str:
        """What kind of thing the name stands for, "" where its maker does not say."""
        return self.means.quantity if self.means else ""

    @property
    def helper(self) -> bool:
        """Whether it draws a mark that nobody is asked for."""
        return self.quantity in HELPERS

    @property
    def loose(self) -> bool:
        """Whether it draws a mark that may lie anywhere, a guide's place or a trial: no part of what a plan shows."""
        return self.quantity in ("guide", "trial")

    def reads(self) -> tuple[Read, ...]:
        """Names of what the step needs, each with its kind."""
        return tuple([(name, kind) for field, kind in self.needs if (name := getattr(self, field))])

    def draw(self, env: Env, tool: Tool) -> Thing:
        """The thing itself, from the things in ``env``."""
        raise NotImplementedError


def _of(kind: Kind, *names: str | None) -> tuple[Read, ...]:
    return tuple((n, kind) for n in names if n)


marks, directions, values = (partial(_of, kind) for kind in KINDS[:3])
