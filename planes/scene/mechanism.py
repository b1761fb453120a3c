"""Links, points, guides, pairs, the drive, masses and loads: the contents of a scene, as frozen records.

All numbers are SI; angles are degrees, counter-clockwise positive, and end in ``_deg``. A place is a complex number (x
to the right, y up) in the axes of the link that owns it; the frame is the link named ``"0"``.
"""

import math
from collections.abc import Mapping
from functools import cached_property, partial
from types import MappingProxyType
from typing import Literal

from planes.scene.written_numbers import WrittenNumbers
from planes.words.frozen import field, frozen
from planes.words.names import NamePair, NameTriple, NameTuple, NumbersByName

FRAME = "0"
DRIVE_RATE_KEYS = {"phi": ("omega", "epsilon"), "s": ("velocity", "acceleration")}
"""The keys of a drive's rates in a scene, by its kind."""
Sense = Literal["along", "against"]
DriveKind = Literal["phi", "s"]
Order = Literal["left", "right", "ahead", "behind"]
Where = Mapping[NameTuple, int]
"""Where each part was written: path of keys -> line of the scene file, for errors."""

nothing = partial(MappingProxyType, {})  # an empty table that cannot be changed


PlacesByName = Mapping[str, complex]


@frozen
class Guide:
    """A straight guide in the axes of its link: the line through ``through`` towards ``angle_deg``."""

    name: str
    through: complex
    angle_deg: float
    through_point: str | None = None  # the named point of the link on the guide, if any
    mark: str | None = None  # letter of the coincident point on the plans, if the scene gives one
    origin_given: bool = True  # False for {x: c} and {y: c}


@frozen
class RoundGuide:
    """A circular guide about a point of its link: the slider on it turns about that point."""

    name: str
    centre: str
    radius: float


@frozen
class Journal:
    """Friction in a hinge: its coefficient and the radius of the pin, m; or, ``round``, of a circular guide, with the
    coefficient of a plane contact."""

    coefficient: float
    radius: float
    round: bool = False

    @property
    def friction_circle_radius(self) -> float:
        """The radius of the friction circle, to which the reaction is tangent."""
        return self.radius * self.coefficient / (math.hypot(1.0, self.coefficient) if self.round else 1.0)


@frozen
class Slide:
    """A sliding pair: the x axis is turned by ``angle_deg`` from ``guide``, the first point lies ``offset`` m to its
    left; None: not given."""

    guide: str
    angle_deg: float | None = None
    offset: float | None = None
    length: float | None = None  # length of its face, half on either side of the foot of its first point


@frozen
class Link:
    """A rigid link: points and guides in its own axes. A ``mass`` or ``inertia`` of ``None`` was not given."""

    name: str
    points: PlacesByName
    guides: Mapping[str, Guide] = field(default_factory=nothing)
    slides: Slide | None = None
    mass: float | None = None
    inertia: float | None = None
    centre: str | None = None
    round_guides: Mapping[str, RoundGuide] = field(default_factory=nothing)
    slides_round: Slide | None = None  # on a circular guide, whose centre is then one of its points
    bearings: complex | None = None  # along its axis on the frame, m from the plane of motion: the first + i the second

    @property
    def first_point(self) -> str:
        """Name of the point that places a slider."""
        return next(iter(self.points))

    @property
    def mass_centre(self) -> str:
        """Name of the mass centre: the first point unless the scene names another."""
        return self.centre or self.first_point


@frozen
class Drive:
    """The driver and its motion: ``kind`` "phi" (rad/s, rad/s², position in degrees) or "s" (m, m/s, m/s²). A turning
    driver turns ``on`` the frame or, by a motor in their hinge, on another link."""

    link: str
    kind: DriveKind
    position: float
    velocity: float = 0.0
    acceleration: float = 0.0
    on: str = FRAME
    balance: tuple[str, float] | None = None  # where a balancing force acts, and its angle in the link's axes

    @property
    def rotates(self) -> bool:
        """Whether it turns, and does not slide."""
        return self.kind == "phi"

    @property
    def turning(self) -> str:
        """The index of its angle: its link, "2_1" where it turns on another."""
        return self.link if self.on == FRAME else f"{self.link}_{self.on}"

    @property
    def coordinate_name(self) -> str:
        """The name of its coordinate: the angle of its link's axis, absolute or relative to another link; or s."""
        turned = f"angle_x_{self.link}" if self.on == FRAME else f"angle_{self.turning}"
        return turned if self.rotates else "s"

    @property
    def motion_names(self) -> NameTriple:
        """Names of its position, velocity and acceleration: phi_1, omega_1, epsilon_1; of a slider s_1, v_1, a_1; where
        it moves no link, phi or s."""
        if self.link == FRAME:
            return self.kind, "", ""
        if self.rotates:
            return f"phi_{self.turning}", *self.rate_names
        return f"s_{self.link}", f"v_{self.link}", f"a_{self.link}"

    @property
    def rate_names(self) -> NamePair:
        """The names of its given velocity and acceleration."""
        turning = f"omega_{self.turning}", f"epsilon_{self.turning}"
        return turning if self.rotates else ("v_drive", "a_drive")


Pairs = tuple[tuple[float, float], ...]  # of a table: a place, and the value there


@frozen
class LoadLaw:
    """A load number evaluated in every position: ``text``, an expression of numbers and of quantities known before the
    forces (``phi``, ``s_5``, ``v_H``; SI, degrees), or the value of a ``table`` of pairs, linear between them. A table
    over ``phi`` of 360° repeats itself."""

    text: str
    table: Pairs = ()

    @property
    def turning(self) -> bool:
        """Whether the table covers a whole turn of the driver."""
        return self.text == "phi" and bool(self.table) and abs(self.table[-1][0] - self.table[0][0] - 360.0) < 1e-9


Amount = float | LoadLaw


@frozen
class StrokeLoad:
    """A load that differs by stroke: in the working stroke of a ``slider`` it goes ``ahead`` or ``behind`` along its
    guide."""

    working: Amount
    idle: Amount
    slider: str
    stroke: Literal["ahead", "behind"] = "ahead"


LOAD_KINDS = {"force": "P", "moment": "M"}
"""The kinds of loads by the key of their size, with the letter of their names. ``planes/scene/motion.py`` reads each,
``planes/plans/force/loads.py`` draws it."""
LOAD_POINT_KEYS = ("point",)
LOAD_NUMBER_KEYS = (*LOAD_KINDS, "direction", "angle", "working", "idle", "over")  # beside tables
LOAD_KEYS = ("link", *LOAD_POINT_KEYS, *LOAD_KINDS, "direction", "along", "against")


@frozen
class Load:
    """One force (``kind`` "force", N, at ``point``) or couple (``kind`` "moment", N·m) on ``link``.

    A force has the direction ``direction_deg`` (in the axes of ``direction_link`` if given, else the frame's) or is
    directed ``sense`` the motion of its point; a moment without ``sense`` is signed, counter-clockwise positive.
    """

    link: str
    kind: Literal["force", "moment"]
    value: Amount | StrokeLoad
    point: str | None = None
    direction_deg: Amount | None = None
    direction_link: str | None = None
    sense: Sense | None = None


@frozen
class Assembly:
    """Which of two assemblies is meant: a word, or the one nearer to ``near`` at the drive's given position."""

    order: Order | None = None
    near: complex | None = None


@frozen
class Law:
    """A number of the file, by its path, that shares ``parameter`` with the drive's position and so is valid there
    alone."""

    path: NameTuple
    parameter: str
    line: int


Links = Mapping[str, Link]


@frozen
class Mechanism:
    """A planar lever mechanism with one drive. ``links`` holds the moving links in the order of the file."""

    frame: Link
    links: Links
    drive: Drive
    loads: tuple[Load, ...] = ()
    gravity: float | None = None
    friction: NumbersByName = field(default_factory=nothing)
    journals: Mapping[str, Journal] = field(default_factory=nothing)  # by point or circular guide
    assembly: Mapping[str, Assembly] = field(default_factory=nothing)
    where: Where = field(default_factory=nothing, compare=False)
    laws: Mapping[NameTuple, Law] = field(default_factory=nothing)
    frame_number: str = FRAME  # on sheets
    written: WrittenNumbers = field(default_factory=WrittenNumbers, compare=False)

    def link(self, name: str) -> Link:
        """The link of that name, the frame included."""
        return self.frame if name == FRAME else self.links[name]

    @property
    def bodies(self) -> tuple[Link, ...]:
        """The frame and the moving links."""
        return (self.frame, *self.links.values())

    @property
    def loaded(self) -> bool:
        """Whether any load, mass or moment of inertia is given."""
        return bool(self.loads) or any(link.mass or link.inertia for link in self.links.values())

    @cached_property
    def owners(self) -> dict[str, Link]:
        """The link that carries each guide, the frame's guides first."""
        return {guide: link for link in self.bodies for guide in link.guides}

    def owner_of_guide(self, guide: str) -> str:
        """Name of the link that carries the guide."""
        return self.owners[guide].name

    def guide(self, name: str) -> Guide:
        """The guide of that name, on any link."""
        return self.owners[name].guides[name]

    def slider_rank(self, link: Link) -> tuple[bool, int]:
        """Of two sliders in one place the one of higher rank holds the other: the frame's, or the later one."""
        return bool(link.slides and self.owner_of_guide(link.slides.guide) == FRAME), [*self.links].index(link.name)

    def round_guide_of_link(self, link: Link) -> tuple[RoundGuide, str] | None:
        """The circular guide that a link slides on, and the link that carries it."""
        name = link.slides_round.guide if link.slides_round else ""
        return next(((x.round_guides[name], x.name) for x in self.bodies if name in x.round_guides), None)

    def points_without_guide_centre(self, link: Link) -> list[str]:
        """The points of a link, without the centre of the circle it slides on."""
        guides = self.round_guide_of_link(link)
        return [p for p in link.points if not guides or p != guides[0].centre]

    def journal_key_of_hinge(self, point: str, *links: str) -> str | None:
        """The key of ``journals`` for the hinge of two links at a point, or for the circular guide of one of them."""
        round_guides = (self.round_guide_of_link(self.link(x)) for x in links)
        name = next((g[0].name for g in round_guides if g and g[0].centre == point), point)
        return name if name in self.journals else None

    @cached_property
    def point_names(self) -> NameTuple:
        """Names of all points, each once, those of the frame first."""
        return tuple(dict.fromkeys(p for link in self.bodies for p in link.points))
