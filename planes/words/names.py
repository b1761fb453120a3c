"""How things of a program are named: a mark by its plan and its label there, the scale of a plan, the pole."""

from __future__ import annotations

POLE = "p"
AGAIN = "~"
"""Ends the name of a direction that is drawn a second time, from other marks: to people it is the same line."""


def at(plan: str, label: str) -> str:
    """Full name of a mark: the plan it is on and its label there."""
    return f"{plan}:{label}"


def label_of(mark: str) -> str:
    """The label of a mark without its plan."""
    return mark.rpartition(":")[2]


def plan_of(mark: str) -> str:
    """The plan a mark is on; "" for a value, which is on none."""
    return mark.rpartition(":")[0]


def written(direction: str) -> str:
    """A direction as people write it."""
    return direction.rstrip(AGAIN).replace("⊥∥", "⊥")


def mu_of(plan: str) -> str:
    """Name of the scale of a plan: every plan has its own (mm per SI unit)."""
    return f"mu_{plan}"
