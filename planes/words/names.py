"""How a program names its objects and what a name means: a mark by its plan and label, a plan by its kind and links,
the scale of a plan, the pole. Whoever makes a name can say what it means; no other code takes a name apart. Names that
people type are converted to these by :mod:`planes.words.naming`."""

import re
import unicodedata
from collections.abc import Mapping
from functools import lru_cache
from typing import Literal, NoReturn

from planes.words.frozen import frozen, refuse_assignment

POLE_LABEL = "p"
REPEATED_DIRECTION_SUFFIX = "~"
"""Ends the name of a direction that is drawn a second time, from other marks: to people it is the same line."""
MarkKind = Literal["guide", "moved", "foot", "trial", "special", "false", "centre", "normal", "coriolis", "relative"]
Loading = Literal["weight", "inertia", "load", "couple", "tangential", "reaction", "arm"]
UNIT_OF_LOADING: Mapping[str, str] = {"load": "N", "couple": "N·m"}
"""The units of given loads, by what their numbers mean."""
UNIT_OF_PLAN = {
    "position": "m",
    "velocity": "m/s",
    "acceleration": "m/s²",
    "force": "N",
    "contour": "m",
    "vectors": "units",
    "cremona": "N",
}
"""The units of what plans show, by their kinds."""
Size = Literal["length", "offset", "place", "angle", "rate", "circle"]
Line = Literal["along", "across", "towards", "with", "against", "leaning", "down", "given", "own"]
Quantity = Literal[MarkKind, Loading, Size, Line]
NameTuple = tuple[str, ...]
NamePair = tuple[str, str]
"""The ends of a vector, a point and its link, two links: which two, the name of the value says."""
NameTriple = tuple[str, str, str]
MarkTuple = tuple["Mark", ...]
MarkPair = tuple["Mark", "Mark"]
PlanTuple = tuple["PlanId", ...]
NumbersByName = Mapping[str, float]
NamesByName = dict[str, str]

# drawn but never a question to the student
HELPER_MARK_KINDS = ("guide", "moved", "foot", "trial", "special", "false", "centre")
_PRIME_TRANSLATION = str.maketrans(dict.fromkeys("’‘′ʹ`´", "'"))
_LOOK_ALIKE_TRANSLATION = str.maketrans("АВЕКМНОРСТХУЈІаеорсхуі", "ABEKMHOPCTXYJIaeopcxyi")


class PlanId(str):
    """A plan: its kind, and the links in equilibrium on it.

    It is the text by which files, pages and commands name it, "velocity" or "force:2-3", so that it sorts, hashes and
    is written as this text. What it knows is asked of it; nobody takes the text apart.
    """

    kind: str
    """What it shows: "position", "velocity", "acceleration", "force", …"""
    links: NameTuple
    """The links in equilibrium on a force plan: 2 and 3 of "force:2-3"."""
    mu_name: str
    """The name of its scale; every plan has one (mm per SI unit)."""
    unit: str
    """The unit of what it shows; "" for plans that are not measured."""
    is_force: bool
    """Whether its vectors are forces."""

    def __new__(cls, kind: str, *links: str) -> "PlanId":
        plan = super().__new__(cls, f"{kind}:{'-'.join(links)}" if links else kind)
        own = {"kind": kind, "links": links, "mu_name": f"mu_{plan}", "unit": UNIT_OF_PLAN.get(kind, "")}
        vars(plan).update(own, is_force=kind == "force")
        return plan

    @classmethod
    def read(cls, text: str) -> "PlanId":
        """The plan that a text from outside names."""
        kind, _, links = text.partition(":")
        return cls(kind, *links.split("-")) if links else cls(text)

    def __setattr__(self, name: str, *value: object) -> NoReturn:
        refuse_assignment(self, name)

    @lru_cache(8192)  # noqa: B019  plans are few, and a program asks for each mark many times
    def mark(self, label: str) -> "Mark":
        """Its mark with that label."""
        return Mark(self, label)

    def marks(self, one: str, other: str) -> MarkPair:
        """Two of its marks, the ends of a segment."""
        return self.mark(one), self.mark(other)

    @property
    def pole(self) -> "Mark":
        """Its pole."""
        return self.mark(POLE_LABEL)


class Mark(str):
    """A mark: its plan, and its label there.

    It is the text by which files and pages name it, "velocity:c" or "force:2-3:F_21t". On no plan it is its label
    alone.

    On the scheme a label is the name of a point, "B"; a guide without a point has one with a sign, "°x-x". The end of
    a velocity has the small letter of its point, "b", that of an acceleration a primed one, "b'"; between them end the
    components: "n_CB" of a normal one, "k_CB" of Coriolis. On a force plan a vector ends at the mark of its name,
    "F_21t". Every plan has its pole, "p".
    """

    plan: PlanId
    """The plan it is on."""
    label: str
    """Its name there."""

    def __new__(cls, plan: PlanId, label: str) -> "Mark":
        mark = super().__new__(cls, f"{plan}:{label}" if plan else label)
        vars(mark).update(plan=plan, label=label)
        return mark

    def __getnewargs__(self) -> tuple[PlanId, str]:  # type: ignore[override]
        return self.plan, self.label

    def __setattr__(self, name: str, *value: object) -> NoReturn:
        refuse_assignment(self, name)


SCHEME_PLAN = PlanId("position")
"""The position plan."""
VELOCITY_PLAN = PlanId("velocity")
ACCELERATION_PLAN = PlanId("acceleration")
RATE_PLANS = (VELOCITY_PLAN, ACCELERATION_PLAN)
MOTION_PLAN = PlanId("motion")
"""Velocities of a unit drive, drawn where the given one is at rest."""
LEVER_PLAN = PlanId("lever")
"""The velocity plan turned by a right angle, with the forces at its marks (Zhukovsky)."""
CREMONA_PLAN = PlanId("cremona")
"""The plan of a truss, whose marks are the regions between forces."""
NO_PLAN = PlanId("")
"""The plan of a name that is no mark."""
NO_MARK = Mark(NO_PLAN, "")
"""Where there is no mark."""
scheme_mark = SCHEME_PLAN.mark
"""A mark of the scheme by its label."""


@frozen
class Meaning:
    """What a name stands for: a quantity ``of`` an object, ``about`` another, that belongs to a ``link``.

    Marks: "guide" is the position of a guide or a parallel to it, "moved" a shifted pivot, "foot" the foot of a
    perpendicular to a guide, "trial" an assumption, "special" the intersection of two leads, "false" a mark of a plan
    drawn from an assumption, "centre" that of two links; at a "normal", a "coriolis" or a "relative" (of a drive
    between moving links) that component of a vector ends.

    Directions: "along" is a guide or the line of two points, "across" perpendicular to it and "leaning" inclined from
    the perpendicular by friction, "towards" from a point to another, "with" and "against" a vector, "given" at an angle
    stated in the scene.
    """

    quantity: Quantity
    of: str = ""
    about: str = ""
    link: str = ""

    @property
    def line_name(self) -> str:
        """The line that a direction is along or across: BC, y-y, or a vector."""
        return self.of + self.about

    @property
    def written_action(self) -> str:
        """A direction as written beneath a vector: ⊥BC, ∥y-y, C→B, -a_S2; "" where there is no line to name."""
        if self.quantity == "towards":
            return f"{self.of}→{self.about}"
        sign = _DIRECTION_SIGNS.get(self.quantity)
        return "" if sign is None else sign + self.line_name


_DIRECTION_SIGNS = {"along": "∥", "across": "⊥", "leaning": "∠ρ ⊥", "with": "+", "against": "-", "down": "↓"}


def split_value_name(name: str) -> NameTriple:
    """The name of a value taken apart: its letter, its subject and its component: a, CB and n of a_CB^n."""
    base, _, part = name.strip("|‖").partition("^")
    letter, _, index = base.partition("_")
    return letter, index, part


def plan_of(name: str) -> PlanId:
    """The plan of a name, if it is a mark."""
    return name.plan if isinstance(name, Mark) else NO_PLAN


def label_of(name: str) -> str:
    """A name without its plan: the label of a mark, any other as it is."""
    return name.label if isinstance(name, Mark) else name


def name_without_plan(name: str) -> str:
    """A mark, a guide or its direction by the name people use, without its plan."""
    return label_of(name).lstrip("°∥")


def with_analogue_in_index(name: str) -> str:
    """An analogue as its letter is written, with q in the index: v_qC of vq_C; any other name unchanged."""
    letter, _, index = name.partition("_")
    return f"{letter[:-1]}_q{index}" if letter[1:].endswith("q") else name


def letter_of(value: str) -> str:
    """The letter of a value: omega of omega_2, v of v_CB, m of m_3."""
    return value.partition("_")[0]


def guide_of(direction: str) -> str | None:
    """The guide a direction is drawn along; None of any other direction."""
    if direction.startswith("∥"):
        return direction.removeprefix("∥")
    return None


def written_direction(direction: str) -> str:
    """A direction as people write it."""
    return direction.rstrip(REPEATED_DIRECTION_SUFFIX).replace("⊥∥", "⊥")


def parallel_vector_name(action: str) -> str:
    """The vector that a line of action is parallel to: a_C of "-a_C", v_C of "+v_C"; "" of any other line."""
    return action[1:] if re.match(r"-a_|[-+]v_", action) else ""


def written_line_of_action(action: str) -> str:
    """A line of action as written: ↓, ⊥BC, ∥x–x, C→B, ∥CL of the guide CL; "" for none."""
    text = written_direction(action).replace("-", "–")
    if re.match(r"[↓⊥∥]|[A-Z]\w*→[A-Z]\w*$", text):
        return text
    return f"∥{text}" if re.fullmatch(r"[A-Z]\w*", text) else ""


def name_index(name: str) -> str:
    """The index of an indexed name: AB of l_AB."""
    return name.partition("_")[2]


def guide_end_letters(guide: str) -> NamePair:
    """The letters at the ends of a guide: x and x of "x-x"; for a single name, that name and ""."""
    first, _, second = guide.partition("-")
    return first, second


def vector_end_label(name: str) -> str:
    """The label of the mark at the end of a vector, where the vector is named by it: F_21t of F_21^t."""
    return name.replace("^", "")


def component_ending_at(label: str) -> str:
    """A mark of a force plan as the vector component that ends there: F_21t, F_21^t."""
    return re.sub(r"^([FR]_[^^]*)([tn])$", r"\1^\2", label)


def is_scale(name: str) -> bool:
    """Whether a value is the scale of a plan."""
    return name.startswith("mu_")


def plan_of_scale(name: str) -> str:
    """The plan whose scale a value is."""
    return name.removeprefix("mu_")


def given_name_without_suffix(name: str) -> str:
    """The name of a given number without the program's suffix: P_5 of P_5_given."""
    return name.removesuffix("_given")


def split_reversal_sign(name: str) -> tuple[str, bool]:
    """A vector, and whether it is reversed: r_BC of -r_BC."""
    name = name.strip().replace("−", "-")
    return name.removeprefix("-").strip(), name.startswith("-")


def component_axis(name: str) -> str:
    """The axis of a component: x of aq_S2_x; "" of a whole vector."""
    last = name.rpartition("_")[2]
    return last if last in ("x", "y") and name.count("_") > 1 else ""


def direction_of_given_angle(given: str) -> str:
    """The direction set by the given angle of a stated vector, "∠v_B" of angle_∠v_B; "" of any other number."""
    return given.removeprefix("angle_") if given.startswith("angle_∠") else ""


def given_name_of_number(name: str) -> str:
    """The given that a number belongs to; that of a place is written with .x and .y."""
    return name.removesuffix(".x").removesuffix(".y")


def with_latin_letters(name: str) -> str:
    """The name with look-alike Cyrillic letters replaced by Latin ones."""
    return name.translate(_LOOK_ALIKE_TRANSLATION)


@lru_cache(4096)
def without_markup(name: str) -> str:
    """A name without markup: Latin letters, straight primes, no signs of indices."""
    text = unicodedata.normalize("NFKC", name).strip().translate(_PRIME_TRANSLATION).replace("″", "''")
    text = text if text == "полюс" else with_latin_letters(text)
    for old, new in (("Φ", "I"), ("ω", "omega"), ("ε", "epsilon"), ("φ", "phi"), ("τ", "t"), ("μ", "mu")):
        text = text.replace(old, new)
    return "".join(c for c in text if c not in "_^{} .·*")
