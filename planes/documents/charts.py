"""The command ``planes chart``: measures the methods on a scene and draws the charts, with their table."""

import math
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from planes.accuracy.comparison import OtherProgram
from planes.accuracy.limits import Limit
from planes.accuracy.methods import Method, measure_methods, method_in_words, processor_and_core_count
from planes.accuracy.stability import Approach, approach_nearest_limit
from planes.accuracy.turning import Turning, length_turning_curves, turning_of_nearest_length
from planes.accuracy.variation import alterable_given_names
from planes.plans import Plans, plans_of
from planes.scene import Scene
from planes.scene.files import save_file_or_refuse, writing_errors_in_words
from planes.scene.mechanism import Mechanism
from planes.solving import drive_position_in_words
from planes.words import Lang, Phrase, say
from planes.words.errors import PlanesError, list_valid_choices
from render.charts import METADATA_OF_SUFFIX
from render.charts.method_charts import draw_method_charts

LIMIT_POSITION_COUNT = "30"  # positions on the way to a limit


def draw_chart(
    scene: Scene,
    output: str,
    table: str | None,
    lang: Lang,
    others: Sequence[OtherProgram] = (),
    length: str | None = None,
) -> None:
    """Draw speed against accuracy, stability, and turning curves as a ``length`` varies (None: the one that needs the
    least change until something turns) into a file, with programs by ``others``."""
    path = Path(output)
    if path.suffix.lower() not in METADATA_OF_SUFFIX:
        raise PlanesError(Phrase("chart_suffix", file=output, suffixes=", ".join(METADATA_OF_SUFFIX)))
    if scene.mechanism is None:
        raise PlanesError(Phrase("cycle_no_mechanism", file=scene.file))
    plans = plans_of(with_moving_driver(scene.mechanism), scene.file)
    turn = turning_curves_of_length(plans, length)
    methods = measure_methods(plans, others)
    way = approach_nearest_limit(plans, others)
    beneath, names = (
        (
            distance_axis_title(way.limit, lang),
            {key: method_in_words(key, LIMIT_POSITION_COUNT, lang) for key in way.errors},
        )
        if way
        else ("", {})
    )
    name, cores = processor_and_core_count()
    seconds = f"{say('chart_seconds', lang)}\n{say('chart_machine', lang, name=name, cores=cores)}"
    with writing_errors_in_words(output):
        beside = (turn, say(f"chart_drive_{plans.drive.kind}", lang)) if turn else None
        draw_method_charts(path, scene.title.get(lang, ""), methods, seconds, way, beneath, names, lang, beside)
    if table:
        save_file_or_refuse(
            (methods_csv(methods, way, lang) + turning_csv(turn, plans.drive.kind, lang)).encode(), table
        )


def turning_curves_of_length(plans: Plans, length: str | None) -> Turning | None:
    """The turning curves of a length, or of the one closest to a turning point."""
    names = alterable_given_names(plans, [n for n in plans.program.given_names if n in plans.link_lengths])
    if length is None:
        return turning_of_nearest_length(plans, names)
    if length not in names:
        raise PlanesError(Phrase("chart_no_length", name=length, valid=list_valid_choices(length, names)))
    return length_turning_curves(plans, length)


def turning_csv(turn: Turning | None, kind: str, lang: Lang) -> str:
    """The turning curves as CSV: a number for each curve, the drive's position and the length."""
    if turn is None:
        return ""
    lines = ["", f'"{say("chart_curve", lang)}","{say(f"chart_drive_{kind}", lang)}","{turn.name}, m"']
    for k, curve in enumerate(turn.curves, 1):
        lines += [f"{k},{x:.10g},{y:.10g}" for x, y in zip(curve.values, curve.lengths, strict=True)]
    return "\n".join(lines) + "\n"


def with_moving_driver(mechanism: Mechanism) -> Mechanism:
    """The mechanism, with a stationary driver set to 1 rad/s or 1 m/s: zero velocities show nothing."""
    drive = mechanism.drive
    if drive.velocity:
        return mechanism
    return replace(mechanism, drive=replace(drive, velocity=1.0))


def distance_axis_title(limit: Limit, lang: Lang) -> str:
    """The kind of distance to a limit, in words."""
    way = limit.way
    value = f"{round(float(limit.value), 12):.7g}".replace("-", "−")
    kind = way.bench.plans.drive.kind
    if way.held is None:
        return say(f"chart_distance_{kind}", lang, value=value)
    letter, held = ("φ", math.remainder(way.held, 360)) if kind == "phi" else ("s", way.held)
    drive = f"{letter} = {drive_position_in_words(held, kind, lang)}".replace("-", "−")
    key, name = ("length", way.name) if way.unit_of_distances == "1" else ("angle", way.bench.plans.means[way.name].of)
    return say(f"chart_distance_{key}", lang, name=name, value=value, here=f"{way.value_in_scene:.6g}", drive=drive)


def methods_csv(methods: list[Method], way: Approach | None, lang: Lang) -> str:
    """The numbers of both charts as CSV."""
    lines = [f"{say('chart_method', lang)},s,{say('chart_error_short', lang)}"]
    lines += [f'"{m.name_in_language(lang)}",{m.seconds:.4g},{m.error:.4g}' for m in methods]
    if way is not None:
        names = [method_in_words(key, LIMIT_POSITION_COUNT, lang) for key in way.errors]
        heads = [distance_axis_title(way.limit, lang), say("chart_sharpness", lang), say("chart_claim", lang), *names]
        lines += ["", ",".join(f'"{h}"' for h in heads)]
        for k, distance in enumerate(way.distances):
            numbers = [distance, way.sharpness[k], way.claim[k], *(e[k] for e in way.errors.values())]
            lines.append(",".join("" if x != x else f"{x:.4g}" for x in numbers))
    return "\n".join(lines) + "\n"
