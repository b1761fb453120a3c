"""Under which conditions a mechanism is calculated, in words: axes, loads, weight, friction."""

from collections.abc import Iterator

from planes.plans.force.loads import load_names
from planes.plans.law_words import law_said
from planes.scene.mechanism import Drive, Load, LoadLaw, Mechanism
from planes.words import Lang, say
from planes.words.units import number


def conditions(mechanism: Mechanism, lang: Lang, forces: bool = True) -> Iterator[str]:
    """Axes; if there are ``forces``, loads, weight and friction in words."""
    if origin := next((name for name, place in mechanism.frame.points.items() if place == 0), None):
        yield say("task_axes", lang, point=f"⟨{origin}⟩")
    if not forces:
        return
    for name, load in zip(load_names(mechanism), mechanism.loads, strict=True):
        yield _load(load, name, mechanism.drive, lang)
    masses = any(link.mass for link in mechanism.links.values())
    if masses and mechanism.gravity:
        yield say("task_weight", lang, g=number(mechanism.gravity, lang))
    elif masses:
        yield say("task_no_weight", lang)
    for guide, f in mechanism.friction.items():
        yield say("task_friction", lang, guide=guide, f=number(f, lang))
    for name, journal in mechanism.journals.items():
        sizes = {"f": journal.coefficient, "radius": journal.radius, "circle": journal.circle}
        said = {size: number(value, lang) for size, value in sizes.items()}
        yield say(f"task_friction_{'round' if journal.round else 'pin'}", lang, name=name, rho=f"rho_{name}", **said)


def _load(load: Load, name: str, drive: Drive, lang: Lang) -> str:
    """One force or moment: its size, and which way it acts; its law, if it is one, after that."""
    size, angle = (law_said(x or 0.0, drive, "⟨{}⟩".format, lang) for x in (load.value, load.direction_deg))
    if isinstance(load.direction_deg, LoadLaw):
        angle = f"({angle})"
    if isinstance(load.value, float | int):
        return _acting(load, size, angle, lang)
    return _acting(load, f"⟨{name}⟩", angle, lang) + " " + say("task_law", lang, name=name, law=size)


def _acting(load: Load, size: str, angle: str, lang: Lang) -> str:
    what = {"link": load.link, "point": f"⟨{load.point}⟩", "value": size}
    if load.kind == "moment":
        return say(f"task_moment_{load.sense}" if load.sense else "task_moment", lang, **what)
    if load.sense:
        return say(f"task_force_{load.sense}", lang, **what)
    if load.direction_link:
        return say("task_force_link", lang, **what, angle=angle, other=load.direction_link)
    return say("task_force", lang, **what, angle=angle)
