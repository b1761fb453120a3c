"""How each kind of failure is come to: `python -m tests.benchmarks.failures` writes a chart of four panels, the
errors of every method on the way to a dead point, stretched or folded, to parallel guides, to three leads that meet in
a point; and their errors at one distance as a table, into the pages on accuracy."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parent))

from charts_beside import by_hand
from matplotlib import rc_context
from matplotlib.figure import Figure

from planes.accuracy.methods import method_in_words
from planes.accuracy.stability import Approach, approach_nearest_limit
from planes.documents.charts import LIMIT_POSITION_COUNT, distance_axis_title
from planes.plans import plans_of
from planes.scene import load
from planes.words import Lang
from render.charts import FILE_CHART_STYLE, save_figure
from render.charts.method_charts import draw_approach
from tests.benchmarks.pages import put
from tests.helpers import ROOT
from tests.helpers.other_programs import installed

KINDS = {  # of failure: the scene that comes to it, and what it is called
    "stretched": ("docs/scenes/limit-stretched.yaml", "dead point, stretched", "мёртвая точка, вытянуты"),
    "folded": ("docs/scenes/limit-folded.yaml", "dead point, folded", "мёртвая точка, сложены"),
    "parallel": ("samples/kind-4-prp.yaml", "parallel guides", "направляющие параллельны"),
    "three": ("samples/class-three/mixtures/rr-pr-rp.yaml", "three leads in a point", "три поводка в одной точке"),
}
LEAST = 1e-17
AT = 1e-7  # of the distance the table is of, relative or in radians


def approached() -> dict[str, Approach]:
    """The way to each failure, with whoever can go it."""
    found = {}
    for key, (scene, *_) in KINDS.items():
        others = [*by_hand(scene), *installed()] if key != "three" else []  # none of them goes as far
        way = approach_nearest_limit(plans_of(load(str(ROOT / scene)).mechanism), others)
        assert way is not None, scene
        found[key] = way
    return found


def called(method: str, lang: Lang) -> str:
    """A method's name; other programs have one in every language."""
    by_hand_in_russian = lang == "ru" and method == "numba by hand"
    return "формулы вручную (numba)" if by_hand_in_russian else method_in_words(method, LIMIT_POSITION_COUNT, lang)


def chart(ways: dict[str, Approach], path: Path, lang: Lang) -> None:
    """Four panels."""
    with rc_context(FILE_CHART_STYLE):
        figure, lines = Figure(figsize=(12.6, 11.6), dpi=80, layout="constrained"), dict[str, Any]()
        for plot, (key, way) in zip(figure.subplots(2, 2).flat, ways.items(), strict=True):
            names = {method: called(method, lang) for method in way.errors}
            draw_approach(plot, way, distance_axis_title(way.limit, lang), names, lang)
            plot.set_title(KINDS[key][1 if lang == "en" else 2], fontsize=10)
            handles, labels = plot.get_legend_handles_labels()
            lines = dict(zip(labels, handles, strict=True)) | lines
            figure.legends[-1].remove()
        figure.legend(lines.values(), lines, loc="outside lower center", ncols=5, fontsize=8.5)
        save_figure(figure, path)


def table(ways: dict[str, Approach], lang: Lang) -> str:
    """The errors at one distance as Markdown."""
    heads = [KINDS[key][1 if lang == "en" else 2] for key in ways]
    lines = [f"| {'at 10⁻⁷' if lang == 'en' else 'на 10⁻⁷'} | {' | '.join(heads)} |", "|---|" + "---|" * len(heads)]
    rows = {"claim": "claimed error" if lang == "en" else "заявленная погрешность"}
    rows |= {m: called(m, lang) for way in ways.values() for m in way.errors}
    for method, name in rows.items():
        cells = []
        for way in ways.values():
            k = min(range(len(way.distances)), key=lambda k: abs(way.distances[k] / AT - 1))
            errors = way.claim if method == "claim" else way.errors.get(method)
            cells.append(
                "–"
                if errors is None or not errors[k] < 1
                else f"{max(errors[k], 1e-17):.0e}".replace("1e-17", "< 1e-17")
            )
        lines.append(f"| {name} | {' | '.join(cells)} |")
    return "\n".join(lines)


if __name__ == "__main__":
    ways = approached()
    for lang in ("en", "ru"):
        put(f"docs/site/{lang}/accuracy.md", "failures", table(ways, lang))
        chart(ways, ROOT / "docs" / "site" / lang / "failures.png", lang)
