"""The conditions of a calculation, in words alone: axes, the parts of the layout that the dimensions leave open, loads,
weight, friction. Numbers are in the table of given data, by their names."""

from collections.abc import Iterator

from planes.plans import Plans
from planes.plans.assur.groups import Group
from planes.plans.force.loads import names_of_loads
from planes.plans.law_words import LAW_NUMBER_DIGITS, law_in_words
from planes.scene.mechanism import FRAME, Assembly, Guide, Link, Load, Mechanism
from planes.words import Lang, say
from planes.words.units import number_text


def condition_sentences(plans: Plans, lang: Lang) -> Iterator[str]:
    """Axes and layout; if forces are drawn, loads, centres of mass, weight and friction; empty for stated vectors."""
    mechanism = plans.mechanism
    if not plans.has_mechanism:
        return
    origin = next((name for name, place in mechanism.frame.points.items() if place == 0), None)
    yield say("task_axes" if origin else "task_axes_alone", lang, point=f"⟨{origin}⟩")
    yield from Layout(plans, lang).layout_sentences()
    if not plans.force_plans:
        return
    for name, load in zip(names_of_loads(mechanism), mechanism.loads, strict=True):
        yield _load_sentence(load, name, mechanism, lang)
    masses = {name: link.mass_centre for name, link in mechanism.links.items() if link.mass}
    if any(not point.startswith("S") for point in masses.values()):
        yield say("task_centres", lang, centres=", ".join(f"{name} — ⟨{point}⟩" for name, point in masses.items()))
    if masses:
        yield say("task_weight" if mechanism.gravity else "task_no_weight", lang)
    for guide in mechanism.friction:
        yield say("task_friction", lang, guide=guide, f=f"⟨f_{guide}⟩")
    for name, journal in mechanism.journals.items():
        names = {letter: f"⟨{letter}_{name}⟩" for letter in ("f", "r", "rho")}
        yield say(f"task_friction_{'round' if journal.round else 'pin'}", lang, name=name, **names)


def _load_sentence(load: Load, name: str, mechanism: Mechanism, lang: Lang) -> str:
    """One force or moment, and its direction; then its law, if it has one."""
    angle = f"∠⟨{name}^({load.direction_link})⟩"
    what = {**vars(load), "point": f"⟨{load.point}⟩", "name": name, "other": load.direction_link, "angle": angle}
    way = load.sense or ("link" if load.direction_link else "")
    acting = [say("_".join(filter(None, ("task", load.kind, way))), lang, **what)]
    for sign, law in ((f"⟨{name}⟩", load.value), (f"∠⟨{name}⟩", load.direction_deg)):
        if law is not None and not isinstance(law, float | int):
            acting.append(say("task_law", lang, name=sign, law=law_in_words(law, mechanism.drive, "⟨{}⟩".format, lang)))
    return " ".join(acting)


class Layout:
    """Words the parts of a layout that the dimensions leave open: which assembly is meant, the directions of guides,
    the axes of links, to which angles and coordinates refer, and the origin of the drive's coordinate."""

    def __init__(self, plans: Plans, lang: Lang) -> None:
        self.plans = plans
        self.mechanism = plans.mechanism
        self.lang = lang

    def layout_sentences(self) -> Iterator[str]:
        """All sentences."""
        m = self.mechanism
        for name, assembly in m.assembly.items():
            yield self.assembly_sentence(name, assembly)
        for name, link in m.owners.items():
            if point := link.guides[name].through_point:
                yield self.say("through", guide=name, point=point)
        for link in m.links.values():
            if way := self.link_axis_words(link):
                yield self.say("axis", link=link.name, way=way)
            if link.slides and link.slides.offset:
                yield self.say("offset", offset=f"⟨e_{link.name}⟩", point=link.first_point, guide=link.slides.guide)
        yield from self.drive_origin_words()

    def say(self, key: str, **parts: object) -> str:
        """A sentence, or a part of one."""
        return say(f"task_{key}", self.lang, **parts)

    def assembly_sentence(self, name: str, said: Assembly) -> str:
        """The position in which a group is assembled."""
        if said.near is not None:
            x, y = (number_text(v, self.lang, LAW_NUMBER_DIGITS) for v in (said.near.real, said.near.imag))
            return self.say("near", name=f"⟨{name}⟩", x=x, y=y)
        group = next((g for g in self.plans.structure.class_two_groups if name in (g.inner.point, g.inner.guide)), None)
        if group is None or said.order is None:
            return self.say("assembled", name=f"⟨{name}⟩")
        return self.dyad(group, said.order)

    def dyad(self, group: Group, order: str) -> str:
        """Which of its two positions a group of class II takes."""
        one = group.first_outer
        two = group.last_outer
        name = group.inner.point
        if order in ("left", "right"):
            return self.say(order, name=name, one=one.point, two=two.point)
        if not name:
            ends = (two.point, one.point) if order == "ahead" else (one.point, two.point)
            return self.say("pointing", guide=group.inner.guide, one=ends[0], two=ends[1])
        guide = self.mechanism.guide(one.guide or two.guide)
        return self.say(order, name=name, guide=guide.name, way=self.guide_direction_words(guide))

    def guide_direction_words(self, guide: Guide) -> str:
        """The direction of a guide."""
        owner = self.mechanism.owner_of_guide(guide.name)
        if owner != FRAME:
            return self.say("way_link", guide=guide.name, link=owner)
        upright = {0.0: "way_right", 90.0: "way_up"}.get(guide.angle_deg, "way_angle")
        return self.say(upright, guide=guide.name)

    def link_axis_words(self, link: Link) -> str:
        """The direction of a link's x axis, if any of its data refer to its axes."""
        drive = self.mechanism.drive
        first = link.points[link.first_point]
        slide = link.slides
        places = {name: z - first for name, z in link.points.items()}
        aimed = [load.direction_link for load in self.mechanism.loads if self.plans.force_plans]
        turned = drive.rotates and drive.on != FRAME and link.name in (drive.link, drive.on)
        uses_axes = any(z.imag for z in places.values()) or link.guides or link.name in aimed or turned
        if slide and (uses_axes or len(places) > 1 or slide.angle_deg):
            key = "way_turned" if slide.angle_deg else "way_guide"
            return self.say(key, link=link.name, guide=slide.guide)
        if not uses_axes or slide:
            return ""
        level = {name: z.real for name, z in places.items() if z.real and not z.imag}
        if level:
            name = next((name for name, x in level.items() if x > 0), next(iter(level)))
            one, two = (link.first_point, name) if level[name] > 0 else (name, link.first_point)
            return self.say("way_points", one=one, two=two)
        guide = next((g.name for g in link.guides.values() if not g.angle_deg), "")
        return self.say("way_guide", guide=guide) if guide else ""

    def drive_origin_words(self) -> Iterator[str]:
        """The origin of the drive's coordinate, unless it is the angle from the driver to the x axis."""
        m = self.mechanism
        drive = self.mechanism.drive
        name = f"⟨{drive.motion_names[0]}⟩"
        if drive.rotates:
            if drive.on != FRAME:
                yield self.say("turned_on", name=name, link=drive.link, on=drive.on)
            return
        link = m.links[drive.link]
        assert link.slides
        guide = m.guide(link.slides.guide)
        yield self.say(
            "stroke", name=name, guide=guide.name, start=self.guide_point_words(guide), point=link.first_point
        )

    def guide_point_words(self, guide: Guide) -> str:
        """The point that defines a guide."""
        if guide.through_point:
            return f"⟨{guide.through_point}⟩"
        if not guide.origin_given:
            return f"{'y' if guide.angle_deg else 'x'} = 0"
        return f"(⟨x_{guide.name}⟩; ⟨y_{guide.name}⟩)"
