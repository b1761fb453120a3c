"""The command ``planes chart``: measures the methods on a scene and draws the charts, with their table."""

import math
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from planes.accuracy.comparison import OtherProgram
from planes.accuracy.limits import Limit
from planes.accuracy.methods import Method, machine, measure, method_name
from planes.accuracy.stability import Approach, approach
from planes.accuracy.turning import Turning, turned, turning
from planes.accuracy.variation import alterable
from planes.plans import Plans, plans_of
from planes.scene import Scene
from planes.scene.files import keep, sayable
from planes.scene.mechanism import Mechanism
from planes.solving import told
from planes.words import Lang, Phrase, say
from planes.words.errors import PlanesError, choices
from render.charts import METADATA
from render.charts.method_charts import draw

DIGITS = "30"  # positions on the way to a limit


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
    if path.suffix.lower() not in METADATA:
        raise PlanesError(Phrase("chart_suffix", file=output, suffixes=", ".join(METADATA)))
    if scene.mechanism is None:
        raise PlanesError(Phrase("cycle_no_mechanism", file=scene.file))
    plans = plans_of(moving(scene.mechanism), scene.file)
    turn = turning_of(plans, length)
    methods, way = measure(plans, others), approach(plans, others)
    beneath, names = (
        (axis(way.limit, lang), {key: method_name(key, DIGITS, lang) for key in way.errors}) if way else ("", {})
    )
    name, cores = machine()
    seconds = f"{say('chart_seconds', lang)}\n{say('chart_machine', lang, name=name, cores=cores)}"
    with sayable(output):
        beside = (turn, say(f"chart_drive_{plans.drive.kind}", lang)) if turn else None
        draw(path, scene.title.get(lang, ""), methods, seconds, way, beneath, names, lang, beside)
    if table:
        keep((text(methods, way, lang) + turning_text(turn, plans.drive.kind, lang)).encode(), table)


def turning_of(plans: Plans, length: str | None) -> Turning | None:
    """The turning curves of a length, or of the one closest to a turning point."""
    names = alterable(plans, [n for n in plans.program.givens if n in plans.lengths])
    if length is None:
        return turned(plans, names)
    if length not in names:
        raise PlanesError(Phrase("chart_no_length", name=length, valid=choices(length, names)))
    return turning(plans, length)


def turning_text(turn: Turning | None, kind: str, lang: Lang) -> str:
    """The turning curves as CSV: a number for each curve, the drive's position and the length."""
    if turn is None:
        return ""
    lines = ["", f'"{say("chart_curve", lang)}","{say(f"chart_drive_{kind}", lang)}","{turn.name}, m"']
    for k, curve in enumerate(turn.curves, 1):
        lines += [f"{k},{x:.10g},{y:.10g}" for x, y in zip(curve.values, curve.lengths, strict=True)]
    return "\n".join(lines) + "\n"


def moving(mechanism: Mechanism) -> Mechanism:
    """The mechanism, with a stationary driver set to 1 rad/s or 1 m/s: zero velocities show nothing."""
    drive = mechanism.drive
    return mechanism if drive.velocity else replace(mechanism, drive=replace(drive, velocity=1.0))


def axis(limit: Limit, lang: Lang) -> str:
    """The kind of distance to a limit, in words."""
    way, value = limit.way, f"{round(float(limit.value), 12):.7g}".replace("-", "−")
    kind = way.bench.plans.drive.kind
    if way.held is None:
        return say(f"chart_distance_{kind}", lang, value=value)
    letter, held = ("φ", math.remainder(way.held, 360)) if kind == "phi" else ("s", way.held)
    drive = f"{letter} = {told(held, kind, lang)}".replace("-", "−")
    key, name = ("length", way.name) if way.unit == "1" else ("angle", way.bench.plans.means[way.name].of)
    return say(f"chart_distance_{key}", lang, name=name, value=value, here=f"{way.here:.6g}", drive=drive)


def text(methods: list[Method], way: Approach | None, lang: Lang) -> str:
    """The numbers of both charts as CSV."""
    lines = [f"{say('chart_method', lang)},s,{say('chart_error_short', lang)}"]
    lines += [f'"{m.name(lang)}",{m.seconds:.4g},{m.error:.4g}' for m in methods]
    if way is not None:
        names = [method_name(key, DIGITS, lang) for key in way.errors]
        heads = [axis(way.limit, lang), say("chart_sharpness", lang), say("chart_claim", lang), *names]
        lines += ["", ",".join(f'"{h}"' for h in heads)]
        for k, distance in enumerate(way.distances):
            numbers = [distance, way.sharpness[k], way.claim[k], *(e[k] for e in way.errors.values())]
            lines.append(",".join("" if x != x else f"{x:.4g}" for x in numbers))
    return "\n".join(lines) + "\n"
