"""The crank, the rod and the slider of a scene, with their dimensions and masses."""

import math

from planes.plans.assur.analysis import analyse_structure
from planes.plans.assur.structure import Structure
from planes.scene import Scene
from planes.scene.mechanism import FRAME, Link, Mechanism
from planes.words import Phrase
from planes.words.errors import SceneError
from planes.words.frozen import frozen


@frozen
class CrankSliderShape:
    """Names and numbers of a crank-slider: r = OA, l = AB, c = AC; s is OS of the crank; SI."""

    crank: str
    rod: str
    slider: str
    pivot: str
    pin: str
    hinge: str
    centre: str
    r: float
    l: float  # noqa: E741 - the rod's length in every formula
    c: float
    s: float
    m1: float
    m2: float
    m3: float
    j1: float
    j2: float
    g: float
    f: float
    omega: float

    @property
    def ratio(self) -> float:
        """λ = r/l."""
        return self.r / self.l


def shape_of(scene: Scene) -> CrankSliderShape:
    """The crank-slider of a scene, or a sentence why it is not one."""
    if scene.mechanism is None or "crank_slider" not in scene.parts:
        raise SceneError(Phrase("cs_missing"), scene.file, 1)
    return _Recogniser(scene, scene.mechanism, analyse_structure(scene.mechanism, scene.file)).shape()


class _Recogniser:
    def __init__(self, scene: Scene, mechanism: Mechanism, structure: Structure) -> None:
        self.scene = scene
        self.m = mechanism
        self.structure = structure
        g = structure.class_two_groups[0] if structure.class_two_groups else None
        fits = len(structure.groups) == 1 and mechanism.drive.rotates
        if not (
            fits
            and g
            and g.pair_letters == "RRP"
            and g.last_outer.other_link_of_pair(g.last) == FRAME
            and g.last_outer.link == g.last
        ):
            raise self.fault("cs_not_one", "links", formula=structure.structural_formula)
        self.crank, self.rod, self.slider = (mechanism.links[n] for n in (mechanism.drive.link, g.first, g.last))
        self.guide = g.last_outer.guide
        self.pivot = structure.drive_pair.point
        self.pin = g.first_outer.point
        self.hinge = g.inner.point

    def fault(self, words: str, /, *path: str, **parts: object) -> SceneError:
        """An error at a key of the file."""
        where = self.m.where
        line = next((where[path[:n]] for n in range(len(path), 0, -1) if path[:n] in where), None)
        return SceneError(Phrase(words, **parts), self.scene.file, line)

    def shape(self) -> CrankSliderShape:
        """All data of the mechanism, checked."""
        self.check_guide()
        self.check_motion()
        r = self.check_crank()
        c = self.check_rod()
        crank = self.crank
        rod = self.rod
        slider = self.slider
        length = abs(rod.points[self.hinge] - rod.points[self.pin])
        if length <= r:
            raise self.fault("cs_short_rod", "links", rod.name, "points", rod=length, crank=r)
        return CrankSliderShape(
            crank=crank.name,
            rod=rod.name,
            slider=slider.name,
            pivot=self.pivot,
            pin=self.pin,
            hinge=self.hinge,
            centre=rod.mass_centre,
            r=r,
            l=length,
            c=c,
            s=(crank.points[crank.mass_centre] - crank.points[self.pivot]).real,
            m1=crank.mass or 0.0,
            m2=self.number(rod, "mass"),
            m3=self.number(slider, "mass"),
            j1=crank.inertia or 0.0,
            j2=self.number(rod, "inertia"),
            g=self.m.gravity or 0.0,
            f=self.m.friction.get(self.guide, 0.0),
            omega=self.m.drive.velocity,
        )

    def number(self, link: Link, key: str) -> float:
        """A mass or inertia that must be given and above zero."""
        value: float | None = getattr(link, key)
        if not value:
            raise self.fault("cs_no_mass", "links", link.name, name=link.name, key=key)
        return value

    def check_guide(self) -> None:
        """Horizontal, through the pivot; the slider carries the hinge on it."""
        guide = self.m.guide(self.guide)
        pivot = self.m.frame.points[self.pivot]
        level = math.isclose(guide.angle_deg % 360.0, 0.0, abs_tol=1e-12)
        if not level or not math.isclose(guide.through.imag, pivot.imag, abs_tol=1e-12):
            raise self.fault("cs_guide", "frame", "guides", self.guide, name=self.guide, pivot=self.pivot)
        slides = self.slider.slides
        shifted = slides is None or bool(slides.angle_deg) or bool(slides.offset)
        if shifted or self.slider.first_point != self.hinge:
            raise self.fault("cs_slide", "links", self.slider.name, name=self.slider.name, point=self.hinge)
        if self.slider.mass_centre != self.hinge:
            raise self.fault(
                "cs_slider_centre", "links", self.slider.name, "centre", name=self.slider.name, point=self.hinge
            )

    def check_crank(self) -> float:
        """The crank's radius; its pin and mass centre lie on its x axis."""
        points = self.crank.points
        pivot = points[self.pivot]
        for name in (self.pin, self.crank.mass_centre):
            way = points[name] - pivot
            if abs(way.imag) > 1e-12 or (name == self.pin and way.real <= 0.0):
                raise self.fault("cs_crank_axis", "links", self.crank.name, name=self.crank.name, point=name)
        return (points[self.pin] - pivot).real

    def check_rod(self) -> float:
        """AC: the rod's mass centre lies between its hinges."""
        points = self.rod.points
        a, b, c = (points[n] for n in (self.pin, self.hinge, self.rod.mass_centre))
        share = (c - a) / (b - a)
        if abs(share.imag) > 1e-9 or not -1e-12 <= share.real <= 1.0 + 1e-12:
            raise self.fault(
                "cs_rod_centre", "links", self.rod.name, "centre", name=self.rod.name, point=self.rod.mass_centre
            )
        return share.real * abs(b - a)

    def check_motion(self) -> None:
        """A crank that turns counter-clockwise and steadily, loaded by the diagram alone."""
        drive = self.m.drive
        if drive.velocity <= 0.0:
            raise self.fault("cs_omega", "drive", "omega", value=drive.velocity)
        if drive.acceleration:
            raise self.fault("cs_epsilon", "drive", "epsilon", value=drive.acceleration)
        if self.m.loads:
            raise self.fault("cs_loads", "loads")
