"""Results of a scene that states vectors, as text."""

from planes.solving import Position
from planes.solving.text_tables import directed, error_of, number_cell, pm, spelt, table, titled
from planes.words import Lang, say
from planes.words.lettering import Naming
from planes.words.names import kind_of, label_of, plan_of
from planes.words.units import UNIT


def stated_tables(p: Position, lang: Lang, naming: Naming) -> list[str]:
    """The vectors of a scene that states them, plan by plan, and the values reckoned from them."""
    lines, e = list[str](), p.results.get("errors")
    found = p.of("vectors")
    for plan in p.plans.drawn:
        own = [f for f in found.values() if plan_of(f.quantity.columns[0].start) == plan]
        most, rows = max((abs(f.vector) for f in own), default=0.0), []
        for f in own:
            name, (start, end) = f.quantity.name, (label_of(m) for m in f.quantity.columns[0].needs)
            read = (
                p.results.get("plans", {}).get(plan, {}).get("segments", {}).get(start + end, {"mm": 0.0, "value": 0.0})
            )
            mm = error_of(e, "plans", plan, "segments", start + end, "mm")
            size, angle = number_cell(read["value"], most), directed(f.vector, most)[1]
            rows.append(
                [spelt(naming.vector(name)), size, angle, *error_of(e, "vectors", name), f"{read['mm']:.2f}", *mm]
            )
        lines += table(
            titled(p, plan, lang, naming),
            ["", say(UNIT[kind_of(plan)], lang), "∠°", *pm(e), say("mm", lang), *pm(e)],
            rows,
        )
    rows = []
    for f in p.of("values").values():
        unit = f.quantity.columns[0].unit
        error = error_of(e, "values", f.quantity.name)
        rows.append(
            [spelt(naming.vector(f.quantity.name)), number_cell(f.number), *error, say(unit, lang) if unit else ""]
        )
    lines += table(say("values_found", lang), ["", say("value", lang), *pm(e), ""], rows)
    return lines + [f"! {w}" for w in p.results["warnings"]]
