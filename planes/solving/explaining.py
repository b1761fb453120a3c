"""What ``planes solve --explain`` prints: the steps of a program that lead to what is asked, and those dropped."""

from collections.abc import Callable, Iterable, Iterator

from planes.drafting.steps import Step
from planes.drafting.steps.tracks import CutTrack
from planes.plans.measuring import lettering
from planes.plans.statements.of_scene import scene_plans
from planes.scene import Scene
from planes.solving import plans_of
from planes.words import Lang, say
from planes.words.lettering import spelt
from planes.words.names import is_scale, letter_of
from planes.words.naming import Naming


def explain(scene: Scene, lang: Lang = "en") -> str:
    """The kept and the dropped steps of a scene, one on a line, in the order they would be drawn."""
    plans = scene_plans(scene)
    full, kept = plans.program, plans_of(scene)[0].program
    named = _named(Naming(lang, **lettering(scene, plans)))
    dropped = [s for s in full.steps if s.makes not in kept.made]
    lines = [say("explain_kept", lang, kept=len(kept.steps), all=len(full.steps)), *_listed(kept.steps, named, lang)]
    if dropped:
        lines += ["", say("explain_dropped", lang, dropped=len(dropped)), *_listed(dropped, named, lang)]
    return "\n".join(lines) + "\n"


def _named(naming: Naming) -> Callable[[str], str]:
    """How vectors are called in other answers: a_3 for a_slide_3, v_B for v_BB0, the same on a fixed guide."""
    return lambda name: spelt(naming.vector(naming.own(name))) if letter_of(name) in ("v", "a", "F", "I") else name


def _listed(steps: Iterable[Step], named: Callable[[str], str], lang: Lang) -> Iterator[str]:
    for step in steps:
        verb = say(f"step_{type(step).__name__}", lang)
        names = ", ".join([*map(named, _read(step)), *_followed(step, lang)])
        yield f"  {named(step.makes)}: {verb}" + (f" ({say('explain_reads', lang, reads=names)})" if names else "")


def _series(step: Step) -> set[str]:
    """The names of an assembly that is followed: numbers that no person gives."""
    return {name for name, _ in step.guess.reads()} - {step.guess.drive} if isinstance(step, CutTrack) else set()


def _read(step: Step) -> Iterator[str]:
    names = dict.fromkeys(name for name, _ in step.reads() if not is_scale(name))
    return (name for name in names if name not in _series(step))


def _followed(step: Step, lang: Lang) -> Iterator[str]:
    if series := _series(step):
        yield say("explain_followed", lang, count=len(series))
