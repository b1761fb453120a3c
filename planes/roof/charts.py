"""The command ``planes chart``: measures the methods on a scene and has the charts drawn, with their table."""

from __future__ import annotations

from pathlib import Path

from planes.cycle.methods import Method, front, measure
from planes.cycle.stability import Approach, approach
from planes.plans import state
from planes.scene import Scene
from planes.wording import PlanesError
from planes.words import Lang, Phrase, say
from render.method_charts import METADATA, Spot, Ways, draw


def draw_chart(scene: Scene, output: str, table: str | None, lang: Lang) -> None:
    """Draw speed against accuracy, and stability, into a file."""
    path = Path(output)
    if path.suffix.lower() not in METADATA:
        raise PlanesError(Phrase("chart_suffix", file=output, suffixes=", ".join(METADATA)))
    if scene.mechanism is None:
        raise PlanesError(Phrase("cycle_no_mechanism", file=scene.file))
    plans = state(scene.mechanism, scene.file)
    methods, way = measure(plans), approach(plans)
    ways = None if way is None else Ways(way.limit_deg, way.distances, way.sharpness, way.claim, way.errors)
    try:
        draw(path, scene.title.get(lang, ""), _spots(methods), _spots(front(methods)), ways, lang)
        if table:
            Path(table).write_text(text(methods, way, lang), encoding="utf-8")
    except OSError as error:
        raise PlanesError(Phrase("cannot_write", file=error.filename or output, reason=error.strerror or "")) from None


def _spots(methods: list[Method]) -> list[Spot]:
    return [Spot(m.key, m.number, m.seconds, m.error) for m in methods]


def text(methods: list[Method], way: Approach | None, lang: Lang) -> str:
    """The numbers of both charts as CSV."""
    best = front(methods)
    lines = [f"{say('chart_method', lang)},s,{say('chart_error_short', lang)},{say('chart_front', lang)}"]
    for m in methods:
        name = say(m.key, lang, number=m.number)
        lines.append(f'"{name}",{m.seconds:.4g},{m.error:.4g},{int(m in best)}')
    if way is not None:
        names = [say(key, lang, number="30") for key in way.errors]
        heads = ["rad", say("chart_sharpness", lang), say("chart_claim", lang), *names]
        lines += ["", ",".join(f'"{h}"' for h in heads)]
        for k, distance in enumerate(way.distances):
            numbers = [distance, way.sharpness[k], way.claim[k], *(e[k] for e in way.errors.values())]
            lines.append(",".join("" if x != x else f"{x:.4g}" for x in numbers))
    return "\n".join(lines) + "\n"
