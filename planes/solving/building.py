"""A mechanism built in Python, part by part; it is read as a scene file is, and written as one."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Mapping, Sequence
from difflib import get_close_matches
from typing import Any, Self

from planes.plans.statements.of_scene import scene_plans
from planes.scene import Scene, loads
from planes.scene.doubts import UNIT_DOUBT_KEYS
from planes.scene.writing import scene_file_text
from planes.words import Phrase, home_lang
from planes.words.errors import PlanesError, list_valid_choices, quoted_excerpt

Place = float | str | complex | Sequence[float | str] | Mapping[str, float | str]
"""A place in a link's axes: x alone (m), [x, y] or x + iy, or ``{"r": …, "angle": …}``; texts are expressions."""
Number = float | str
"""A number, or an expression of parameters: ``"l_AB / 3"``."""


class Linkage:
    """A mechanism built part by part: fixed points and guides, links, assembly, drive, loads.

    Each method adds a part and returns the linkage, so that calls can be chained.

    Lengths are in m, masses in kg, moments of inertia in kg·m² about the mass centre, angles in degrees
    counter-clockwise from x, forces in N, couples in N·m. :meth:`scene` returns the scene, or raises an error of one
    sentence.

    >>> import planes
    >>> engine = planes.Linkage("Slider-crank", gravity=9.81)
    >>> engine.fix(O=(0, 0)).guide("x-x", y=0)
    <Linkage 'Slider-crank': no links>
    >>> engine.link(1, O=0, A=0.1).link(2, A=0, B=0.35).link(3, B=0, slides="x-x", mass=3)
    <Linkage 'Slider-crank': links 1, 2, 3>
    >>> scene = engine.assemble(B="ahead").drive(1, phi=60, omega=20).scene()
    >>> round(abs(planes.solve(scene).v["B"]), 4)  # m/s
    1.9874
    """

    def __init__(self, title: str = "", *, gravity: float = 0.0, **parameters: Number) -> None:
        """``gravity`` in m/s², downwards; ``parameters`` are numbers that expressions may use and calls may change."""
        self.parts: dict[str, Any] = {
            "planes": 1,
            "title": title,
            "parameters": parameters,
            "frame": {"points": {}, "guides": {}},
            "links": {},
            "assembly": {},
            "drive": {},
            "loads": [],
            "gravity": gravity,
            "friction": {},
            "plans": {},
        }

    def fix(self, **places: Place) -> Self:
        """Add points of the frame by name, in m: ``fix(O=(0, 0), C=(0.3, -0.1))``; one number alone is x."""
        self.parts["frame"]["points"] |= places
        return self

    def guide(
        self,
        name: str,
        *,
        link: int | str | None = None,
        x: Number | None = None,
        y: Number | None = None,
        through: Place | None = None,
        angle: Number | None = None,
        centre: Place | None = None,
        radius: Number | None = None,
        **more: object,
    ) -> Self:
        """Add a guide of the frame, or of a ``link`` added before, in the axes of that link.

        ``x`` is a vertical guide through (x, 0), directed to +y, ``y`` a horizontal one, directed to +x; ``through`` is
        a point or its name, with an ``angle`` in degrees; ``centre`` and ``radius`` give an arc.
        """
        _refuse_unknown_keywords(self.guide, more)
        links = self.parts["links"]
        if link is not None and str(link) not in links:
            words = {
                "what": Phrase("guide_named", name=name),
                "of": Phrase("links_all"),
                "name": quoted_excerpt(str(link)),
            }
            raise PlanesError(Phrase("unknown_name", **words, valid=list_valid_choices(str(link), links)))
        owner = self.parts["frame"] if link is None else links[str(link)]
        line = _drop_missing_values(x=x, y=y, through=through, angle=angle, centre=centre, radius=radius)
        owner.setdefault("guides", {})[name] = line
        return self

    def link(
        self,
        name: int | str,
        *,
        slides: str | Mapping[str, Any] | None = None,
        centre: str | None = None,
        mass: Number | None = None,
        inertia: Number | None = None,
        **places: Place,
    ) -> Self:
        """Add a link, its points in its own axes: ``link(2, A=0, B=0.35, S2=0.1, centre="S2", mass=2, inertia=0.03)``.

        A point named in two links is a hinge. ``slides`` names the guide on which the link's first point slides, or
        ``{"guide": …, "angle": …, "offset": …}``. ``centre`` is the mass centre, by default the first point.
        """
        own = _drop_missing_values(slides=slides, centre=centre, mass=mass, inertia=inertia)
        for point in places:
            if near := get_close_matches(point, ("slides", "centre", "center", "mass", "inertia"), 1, 0.75):
                raise PlanesError(Phrase("link_keyword", word=point, near="centre" if near[0] == "center" else near[0]))
        if str(name) in self.parts["links"]:
            raise PlanesError(Phrase("link_twice", link=name))
        self.parts["links"][str(name)] = {"points": places, **own}
        return self

    def assemble(self, sides: Mapping[str, Any] | None = None, **more: Any) -> Self:
        """Choose one of two positions of a group: ``assemble(C="right")``, ``assemble({"y-y": "ahead"})`` or
        ``assemble(C={"near": [0.1, 0.2]})``; left and right between hinges, ahead and behind along a guide."""
        self.parts["assembly"] |= {**(sides or {}), **more}
        return self

    def drive(
        self,
        link: int | str,
        *,
        phi: Number | None = None,
        omega: Number | None = None,
        epsilon: Number | None = None,
        s: Number | None = None,
        velocity: Number | None = None,
        acceleration: Number | None = None,
        on: int | str | None = None,
        **more: object,
    ) -> Self:
        """Set the driver: a crank at ``phi`` degrees, ``omega`` rad/s, ``epsilon`` rad/s², or a slider at ``s`` m,
        ``velocity`` m/s, ``acceleration`` m/s²; ``on`` a moving link, if it does not hang on the frame."""
        _refuse_unknown_keywords(self.drive, more)
        turning = _drop_missing_values(phi=phi, omega=omega, epsilon=epsilon, on=on)
        sliding = _drop_missing_values(s=s, velocity=velocity, acceleration=acceleration)
        self.parts["drive"] = {"link": str(link), **turning, **sliding}
        return self

    def load(
        self,
        link: int | str,
        point: str | None = None,
        *,
        force: Any = None,
        moment: Any = None,
        against: str | None = None,
        along: str | None = None,
        direction: Any = None,
        **more: object,
    ) -> Self:
        """Add a ``force`` (N) at a point of a link, or a ``moment`` (N·m, counter-clockwise positive).

        Its direction is ``against="motion"``, ``along="motion"``, or a ``direction``: degrees, or
        ``{"link": 3, "angle": 90}`` to turn with a link.
        A magnitude may be a law of the motion: ``"3000*sin(phi)"``, ``{"working": 6000, "idle": 200}``.
        """
        _refuse_unknown_keywords(self.load, more)
        said = _drop_missing_values(
            point=point, force=force, moment=moment, against=against, along=along, direction=direction
        )
        self.parts["loads"].append({"link": str(link), **said})
        return self

    def friction(self, coefficients: Mapping[str, Any] | None = None, **more: Any) -> Self:
        """Add friction in guides or hinges: ``friction({"y-y": 0.15}, B={"coefficient": 0.1, "radius": 0.02})``."""
        self.parts["friction"] |= {**(coefficients or {}), **more}
        return self

    def scales(self, **mus: str) -> Self:
        """Set the μ of plans: ``scales(velocity="30 mm/(m/s)")``; by default, the largest standard one that fits."""
        self.parts["plans"] |= {plan: {"mu": mu} for plan, mu in mus.items()}
        return self

    def to_yaml(self) -> str:
        """The text of a scene file of this mechanism."""
        frame = {key: value for key, value in self.parts["frame"].items() if value}
        return scene_file_text({key: value for key, value in (self.parts | {"frame": frame}).items() if value})

    def scene(self, **parameters: float) -> Scene:
        """The scene, with other numbers for its ``parameters`` (SI, degrees).

        Raises :class:`planes.PlanesError`, which names the part, where a value is invalid, the links and pairs form no
        mechanism, or the assembly is not settled; warns (``UserWarning``) of numbers that seem to be in other units.
        """
        scene = loads(self.to_yaml(), f"<{self.parts['title'] or 'Linkage'}>", None, **parameters)
        scene_plans(scene)
        return scene_with_doubts_warned(scene)

    def __repr__(self) -> str:
        links = ", ".join(self.parts["links"])
        return f"<Linkage {self.parts['title']!r}: {f'links {links}' if links else 'no links'}>"


def scene_with_doubts_warned(scene: Scene) -> Scene:
    """The scene; the caller is warned of numbers that seem to be in other units."""
    for doubt in scene.doubts:
        if doubt.phrase.key in UNIT_DOUBT_KEYS:
            warnings.warn(doubt.told(home_lang()), stacklevel=3)
    return scene


def _drop_missing_values(**parts: Any) -> dict[str, Any]:
    """The given values of a part."""
    return {key: value for key, value in parts.items() if value is not None}


def _refuse_unknown_keywords(call: Callable[..., object], more: Mapping[str, object]) -> None:
    """Refuse keywords that a call does not have."""
    for word in more:
        known = [*call.__annotations__][:-2]  # but "more" and "return"
        raise PlanesError(Phrase("call_keyword", call=call.__name__, word=word, valid=list_valid_choices(word, known)))
