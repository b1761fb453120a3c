"""The output of ``planes solve --explain``: the steps that the requested results need, and the steps dropped."""

import re
from collections.abc import Iterable, Iterator

from planes.drafting.steps import Step
from planes.drafting.steps.tracks import CutTrack
from planes.plans.measuring import lettering
from planes.plans.statements.of_scene import scene_plans
from planes.scene import Scene
from planes.solving import plans_of
from planes.words import Lang, say
from planes.words.lettering import spelt
from planes.words.names import is_scale
from planes.words.naming import Naming

_VECTOR = re.compile(r"(?<![\w:])[vaFI]_\w+(\^\w)?")  # no mark, which has its plan before it


def explain(scene: Scene, lang: Lang = "en") -> str:
    """The kept and the dropped steps of a scene, one on a line, in the order they would be drawn."""
    plans = scene_plans(scene)
    full, kept, naming = plans.program, plans_of(scene)[0].program, Naming(lang, **lettering(scene, plans))
    dropped = [s for s in full.steps if s.makes not in kept.made]
    lines = [say("explain_kept", lang, kept=len(kept.steps), all=len(full.steps)), *_listed(kept.steps, lang)]
    if dropped:
        lines += ["", say("explain_dropped", lang, dropped=len(dropped)), *_listed(dropped, lang)]
    return _VECTOR.sub(lambda m: spelt(naming.vector(naming.own(m[0]))), "\n".join(lines)) + "\n"


def _listed(steps: Iterable[Step], lang: Lang) -> Iterator[str]:
    for step in steps:
        verb = say(f"step_{type(step).__name__}", lang)
        names = ", ".join([*_read(step), *_followed(step, lang)])
        yield f"  {step.makes}: {verb}" + (f" ({say('explain_reads', lang, reads=names)})" if names else "")


def _series(step: Step) -> set[str]:
    """The names of the series of an assembly: numbers that the user never gives."""
    return {name for name, _ in step.guess.reads()} - {step.guess.drive} if isinstance(step, CutTrack) else set()


def _read(step: Step) -> Iterator[str]:
    names = dict.fromkeys(name for name, _ in step.reads() if not is_scale(name))
    return (name for name in names if name not in _series(step))


def _followed(step: Step, lang: Lang) -> Iterator[str]:
    if series := _series(step):
        yield say("explain_followed", lang, count=len(series))
