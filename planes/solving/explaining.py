"""The output of ``planes solve --explain``: the steps that the requested results need, and the steps dropped."""

import re
from collections.abc import Iterable, Iterator

from planes.drafting.steps import Step
from planes.drafting.steps.tracks import TrackStep
from planes.plans.measuring import scene_lettering
from planes.plans.statements.of_scene import scene_plans
from planes.scene import Scene
from planes.solving import plans_and_requested_results
from planes.words import Lang, say
from planes.words.lettering import terminal_spelling
from planes.words.names import is_scale
from planes.words.naming import Naming

_VECTOR_NAME_PATTERN = re.compile(r"(?<![\w:])[vaFI]_\w+(\^\w)?")  # no mark, which has its plan before it


def explain_steps(scene: Scene, lang: Lang = "en") -> str:
    """The kept and the dropped steps of a scene, one on a line, in the order they would be drawn."""
    plans = scene_plans(scene)
    full = plans.program
    kept = plans_and_requested_results(scene)[0].program
    naming = Naming(lang, **scene_lettering(scene, plans))
    dropped = [s for s in full.steps if s.makes not in kept.result_names]
    lines = [say("explain_kept", lang, kept=len(kept.steps), all=len(full.steps)), *_step_lines(kept.steps, lang)]
    if dropped:
        lines += ["", say("explain_dropped", lang, dropped=len(dropped)), *_step_lines(dropped, lang)]
    return (
        _VECTOR_NAME_PATTERN.sub(
            lambda m: terminal_spelling(naming.lettered_vector(naming.own_vector_name(m[0]))), "\n".join(lines)
        )
        + "\n"
    )


def _step_lines(steps: Iterable[Step], lang: Lang) -> Iterator[str]:
    for step in steps:
        verb = say(f"step_{type(step).__name__}", lang)
        names = ", ".join([*_names_read_by_step(step), *_followed_branch_words(step, lang)])
        yield f"  {step.makes}: {verb}" + (f" ({say('explain_reads', lang, reads=names)})" if names else "")


def _branch_series_names(step: Step) -> set[str]:
    """The names of the series of an assembly: numbers that the user never gives."""
    if isinstance(step, TrackStep):
        return {name for name, _ in step.guess.input_names()} - {step.guess.drive}
    return set()


def _names_read_by_step(step: Step) -> Iterator[str]:
    names = dict.fromkeys(name for name, _ in step.input_names() if not is_scale(name))
    return (name for name in names if name not in _branch_series_names(step))


def _followed_branch_words(step: Step, lang: Lang) -> Iterator[str]:
    if series := _branch_series_names(step):
        yield say("explain_followed", lang, count=len(series))
