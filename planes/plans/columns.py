"""One number of a quantity, and how it is taken from the drawing."""

from typing import NamedTuple

from planes.drafting.tools import Things
from planes.geometry import plane
from planes.geometry.arithmetic import Arithmetic, Real, Truth
from planes.words.names import NO_MARK, Mark, NameTuple, plan_of


class DriverVector(NamedTuple):
    """The driver's vector on the velocity plan: its ends, its line, and the radius of its rotation ("": it slides)."""

    start: Mark
    end: Mark
    along: str
    length: str

    def driver_speed(self, things: Things) -> Real:
        """The driver's speed as drawn: rad/s, or m/s where it slides."""
        drawn = things[self.end] - things[self.start]
        mu = things[self.start.plan.mu_name]
        speed = plane.dot(things[self.along], drawn) / mu
        return speed / things[self.length] if self.length else speed


class Column(NamedTuple):
    """One number: a value by its name, or the ``part`` ("x", "y", "size") of the segment from ``start`` to ``end``. A
    value with ``beside`` (a normal force, then the marks of its plan) is empty where that force vanishes; one ``per``
    the driver's vector is divided by the driver's speed, a segment by its length."""

    name: str
    unit: str
    value: str = ""
    start: Mark = NO_MARK
    end: Mark = NO_MARK
    part: str = ""
    beside: NameTuple = ()
    per: DriverVector | None = None

    @property
    def comparison_class(self) -> str:
        """The class of numbers it is compared with: those of its unit; an arm only with others like it."""
        return "arm" if self.beside else self.unit

    @property
    def needed_names(self) -> NameTuple:
        """The names of the program it needs."""
        return tuple(n for n in (self.value, self.start, self.end, *self.beside, *(self.per or ())) if n)

    def read_from_drawing(self, things: Things, ar: Arithmetic) -> Real:
        """The column's number (or numbers) from the drawing."""
        if self.per is None:
            return self.undivided_number(things, ar)
        rate = self.per.driver_speed(things)
        rate = ar.where(rate == 0, float("nan"), rate)  # for a speed that underflows
        return self.undivided_number(things, ar) / (abs(rate) if self.part else rate)

    def undivided_number(self, things: Things, ar: Arithmetic) -> Real:
        """The number itself, not divided by the driver's speed."""
        if self.part:
            segment = things[self.end] - things[self.start]
            size = {"x": lambda: segment.real, "y": lambda: segment.imag, "size": lambda: abs(segment)}[self.part]()
            return size / things[self.start.plan.mu_name]
        if not self.value:
            return 0.0
        if self.beside:
            return ar.where(self.has_no_normal_force(things, ar), float("nan"), things[self.value])
        return things[self.value]

    def has_no_normal_force(self, things: Things, ar: Arithmetic) -> Truth:
        """Where the normal force vanishes beside the largest drawn mark of its plan."""
        normal, *marks = (n for n in self.beside if n in things)
        largest: Real = 0.0
        for mark in marks:
            largest = ar.maximum(largest, abs(things[mark]))
        return abs(things[normal]) <= 1e-12 * largest / things[plan_of(marks[0]).mu_name]
