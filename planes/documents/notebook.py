"""Notebook views of a scene, a position, a table and a check as HTML; and a crank to turn."""

from __future__ import annotations

import html
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from planes.batch.table import Table
from planes.check.outcome import Outcome
from planes.check.report import mark_table_rows, result_table_rows, table_headings
from planes.documents.drawn import picture, shown
from planes.plans import structure_of
from planes.scene import Scene
from planes.solving import Position, drive_position_in_words, plans_and_requested_results, solve_position
from planes.solving.of_scene import AnyScene, scene_from
from planes.words import Lang, Phrase, home_lang, say, with_decimal_sign
from planes.words.errors import PlanesError, SceneError
from planes.words.units import number_text, significant_digits_text

if TYPE_CHECKING:
    from anywidget import AnyWidget

ROWS_SHOWN_AT_ENDS = 4  # rows of a table shown from its start, and from its end
_NARROW_TABLE_STYLE = (
    "<style>.planes svg{max-width:28em;height:auto;background:#fff}.planes td,.planes th{text-align:left}</style>"
)


def in_notebook(thing: Scene | Position | Table | Outcome) -> str:
    """An object as HTML in the system language: a title, its picture, its numbers."""
    lang = home_lang()
    match thing:
        case Scene():
            parts = _scene_html(thing, lang)
        case Position():
            parts = _position_html(thing, lang)
        case Table():
            parts = _table_html(thing, lang)
        case _:
            parts = _check_html(thing, lang)
    return f'{_NARROW_TABLE_STYLE}<div class="planes">{"".join(parts)}</div>'


def _scene_html(scene: Scene, lang: Lang) -> Iterable[str]:
    yield f"<b>{html.escape(scene.title.get(lang, '') or scene.file)}</b>"
    if scene.mechanism:
        links = structure_of(scene.mechanism, scene.file)
        formula = links.formula_with_frame_number(scene.frame_number).replace("->", "→")
        yield f"<br>W = {links.W}, {html.escape(formula)}"
    yield shown(scene) or ""
    yield rows_as_html([], [(name, number_text(value, lang)) for name, value in scene.parameters.items()])


def _position_html(here: Position, lang: Lang) -> Iterable[str]:
    drive = here.plans.drive
    if here.plans.has_mechanism:
        position = with_decimal_sign(drive_position_in_words(here.at, drive.kind, lang), lang)
        yield f"<b>{'φ' if drive.rotates else 's'} = {position}</b>"
    yield shown(here) or ""
    rates = [(f"v_{p}", abs(v), "m/s") for p, v in here.v.items()] + [
        (f"a_{p}", abs(a), "m/s²") for p, a in here.a.items()
    ]
    rates += [(n, abs(f.vector), f.unit) for n, f in here.of("vectors").items()]
    rates += [(f"omega_{n}", w, "rad/s") for n, w in here.omega.items()]
    rates += [(f"epsilon_{n}", e, "rad/s²") for n, e in here.epsilon.items()]
    rates += [(f"|{n}|", abs(f.vector), "N") for n, f in here.of("reactions").items()]
    yield rows_as_html([], [(name, number_text(value, lang), say(unit, lang)) for name, value, unit in rates])


def _table_html(results: Table, lang: Lang) -> Iterable[str]:
    head = [f"{name}, {results.units[name]}" for name in results]
    count = len(results.failed)
    columns = [results.columns[name] for name in results]
    rows = [
        [_cell_text(c[k], lang) for c in columns]
        for k in range(count)
        if k < ROWS_SHOWN_AT_ENDS or k >= count - ROWS_SHOWN_AT_ENDS
    ]
    if count > 2 * ROWS_SHOWN_AT_ENDS:
        rows.insert(ROWS_SHOWN_AT_ENDS, ["…"] * len(head))
    yield rows_as_html(head, rows)
    yield f"{count} × {len(head)}"


def _cell_text(value: Any, lang: Lang) -> str:
    if np.isnan(value):
        return "—"
    return with_decimal_sign(significant_digits_text(float(value)), lang)


def _check_html(outcome: Outcome, lang: Lang) -> Iterable[str]:
    marks, numbers = table_headings(lang)
    yield f"<p>{html.escape(outcome.sentence.told(lang))}</p>"
    for head, rows in ((marks, mark_table_rows(outcome, lang)), (numbers, result_table_rows(outcome, lang))):
        yield rows_as_html(head, [row[1:] for row in rows])


def rows_as_html(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Rows as an HTML table, empty without rows."""
    body = [f"<tr>{''.join(f'<td>{html.escape(cell)}</td>' for cell in row)}</tr>" for row in rows]
    top = f"<tr>{''.join(f'<th>{html.escape(cell)}</th>' for cell in head)}</tr>" if head else ""
    return f"<table>{top}{''.join(body)}</table>" if body else ""


WIDGET_SCRIPT = """
export default { render({ model, el }) {
  const crank = Object.assign(document.createElement("input"), { type: "range", step: model.get("step") });
  const said = document.createElement("output"), views = document.createElement("div");
  crank.min = model.get("least"); crank.max = model.get("most"); crank.style.width = "24em";
  crank.setAttribute("aria-label", model.get("symbol"));
  views.style.cssText = "display:flex;flex-wrap:wrap;gap:1em;background:#fff";
  const show = () => {
    crank.value = model.get("value"); said.value = `${model.get("symbol")} = ${model.get("value")}${model.get("unit")}`;
    views.innerHTML = model.get("svg"); if (model.get("failure")) views.textContent = model.get("failure");
  };
  crank.oninput = () => { model.set("value", Number(crank.value)); model.save_changes(); };
  model.on("change:svg change:failure change:value", show);
  el.append(crank, " ", said, views); show();
} };
"""


def crank(scene: AnyScene, views: Sequence[str] = ("position", "velocity-plan"), lang: Lang | None = None) -> AnyWidget:
    """A crank to turn in a notebook: a slider for the drive; the named views are redrawn at each of its positions.

    ``value`` of the returned object is the drive's position (degrees; m for a sliding driver) and may be set or
    observed; ``position`` is the :class:`Position` there, None where it cannot be drawn. Needs anywidget.
    """
    own = scene_from(scene)
    try:
        import anywidget
        import traitlets
    except ImportError:
        raise PlanesError(Phrase("needs_anywidget")) from None
    plans, wanted = plans_and_requested_results(own)
    if own.mechanism is None:
        raise SceneError(Phrase("vectors_alone"), own.file, own.where.get(("vectors",), 1))
    drive = plans.drive
    said = lang or home_lang()
    turns = drive.rotates
    reach = (0.0, 360.0, 1.0) if turns else (drive.position - 1.0, drive.position + 1.0, 0.01)

    class Crank(anywidget.AnyWidget):
        """The slider and its views."""

        _esm = WIDGET_SCRIPT
        value = traitlets.Float(drive.position % 360.0 if turns else drive.position).tag(sync=True)
        least, most, step = (traitlets.Float(number).tag(sync=True) for number in reach)
        symbol = traitlets.Unicode(f"{'φ' if turns else 's'}_{drive.link}").tag(sync=True)
        unit = traitlets.Unicode("°" if turns else f" {say('m', said)}").tag(sync=True)
        svg, failure = (traitlets.Unicode().tag(sync=True) for _ in range(2))
        position: Position | None = None

        def __init__(self) -> None:
            super().__init__()
            self.observe(lambda _: self.draw(), "value")
            self.draw()

        def draw(self) -> None:
            """The views at the drive's position, or why there are none."""
            try:
                self.position = solve_position(own, plans, wanted, self.value, None, said)
                pages = [picture(self.position, view, said) for view in views]
                self.svg = "".join(page._repr_svg_() for page in pages)
                self.failure = ""
            except PlanesError as failure:
                self.position, self.failure = None, failure.told(said)

    return Crank()
