"""Pages for checking, which need no network: a report, a class, tracing paper.

A report has layers, a table of steps, marks to move and judge again. A class page counts the right drawings, lists
mistakes with their authors, and has a row for each drawing, sortable. Tracing paper lies over a picture opened in the
page and sent nowhere.
"""

import html
import re
from collections.abc import Callable, Iterator, Mapping, Sequence

from planes.check.report.class_rows import UNSURE_RANK, ClassRow
from planes.drafting.pens import THICK_PEN_HEAD
from planes.words import Lang, say, sentences_with_prefix
from planes.words.names import NamePair
from planes.words.naming import Naming
from planes.words.records import Json
from render.page import packer, web_page
from render.paper.letters import name_search_pattern, names_for_script, sentence_html, tagged_sentence
from render.paper.style import arrowhead_corners

DRAWING_LAYERS = ("own", "next", "truth", "picture")


def report_page(data: Json, lang: Lang) -> str:
    """The report page, from the data of :func:`planes.check.report.page_data`."""
    words = sentences_with_prefix("check_page_", lang, "check")
    drawn = "page" in data
    e = html.escape
    naming = Naming(lang, **data["lettering"])
    names = _mentioned_names(data)

    def lettered(text: str) -> str:
        return sentence_html(text, names, naming, data["kind"])

    parts = {
        "title": e(data["title"]),
        "file": f'<p class="file">{e(data["of_class"])}</p>' if "of_class" in data else "",
        "sentence": lettered(data["sentence"]),
        "printed": f'<p class="printed">{lettered(data["printed"])}</p>' if data["printed"] != data["sentence"] else "",
        "chance": e(data["chance"]),
        "asked": f'<p id="as-read"><button type="button">{e(words["as_read"])}</button></p>' if data["asked"] else "",
        "places": _wrong_places_html(data["places"], "", naming, data["kind"], words["places"]),
        "drawing": _figure_html(data, words) if drawn else "",
        "tables": _table_html("marks", words["steps"], data["head"], data["rows"], lettered)
        + _table_html("numbers", words["numbers"], data["number_head"], data["numbers"], lettered),
        "notes": "".join(f"<p>{lettered(n)}</p>" for n in data["notes"]),
        "noscript": f"<noscript><p>{e(words['noscript'])}</p></noscript>" if drawn else "",
    }
    body = web_page.fill_template("check.html", parts)
    code = packer.pack_modules("check") if drawn else ""
    held = (
        {"data": {**data["page"], "sought": name_search_pattern(names)}, "letters": _lettered_names(data, names)}
        if drawn
        else {}
    )
    return web_page.fill_web_page(data["title"], lang, ("check.css",), body, code=code, data=held, kind=data["verdict"])


def _mentioned_names(data: Json) -> list[str]:
    """The names of marks and vectors that a page shows or mentions."""
    page = data.get("page", {"rows": [], "order": [], "truth": [], "marks": []})
    rows = (row[1] for row in (*data["rows"], *data["numbers"]))
    sides = (name for key in ("rows", "order") for name, *_ in page[key])
    return [*dict.fromkeys((*rows, *sides, *page["truth"], *(m["name"] for m in page["marks"])))]


def _lettered_names(data: Json, names: Sequence[str]) -> Mapping[str, object]:
    """The names as lettered on a sheet, with those in sentences that may appear on the page."""
    texts = " ".join(
        (*(v["said"] for v in data["page"]["variants"]), (data["page"]["otherwise"] or {}).get("said", ""))
    )
    return names_for_script(
        (*names, *filter(None, (m[2] for m in re.finditer(name_search_pattern(names), texts)))), data["lettering"]
    )


def _figure_html(data: Json, words: Mapping[str, str]) -> str:
    """The figure, its layers and its controls."""
    e = html.escape
    under = data["page"]["picture"] or data["page"]["strokes"]
    shown = {**words, **data, "how": words["drag_class" if data.get("of_class") else "drag"]}
    parts = {k: e(str(shown[k])) for k in ("title", "moved", "reset", "how", "command", "saved", "look", "save")}
    parts["layers"] = "".join(
        f'<label><input type="checkbox" data-layer="{n}" checked><i class="{n}"></i>{e(words[n])}</label>'
        for n in DRAWING_LAYERS
        if n != "picture" or under
    )
    return web_page.fill_template("check_drawing.html", parts).rstrip()


def _table_html(
    key: str, caption: str, head: Sequence[str], rows: Sequence[Sequence[str]], letter: Callable[[str], str]
) -> str:
    """A table whose rows begin with their verdict and their name."""
    if not rows:
        return ""
    e = html.escape
    body = ""
    cells = "".join(f'<th scope="col">{e(h)}</th>' for h in head)
    for verdict, name, *row in rows:
        columns = "".join(f"<td>{e(c)}</td>" for c in row)
        body += f'<tr class="{e(verdict)}" data-mark="{e(name)}"><th scope="row">{letter(name)}</th>{columns}</tr>\n'
    parts = f"<caption>{e(caption)}</caption><thead><tr>{cells}</tr></thead><tbody>{body}</tbody>"
    return f'<table id="{key}">{parts}</table>'


Whose = Sequence[NamePair]


def class_page(
    title: str,
    counts: Sequence[tuple[str, int]],
    common: Sequence[tuple[str, Whose]],
    absent: str,
    head: Sequence[str],
    rows: Sequence[tuple[ClassRow, Sequence[str]]],
    lang: Lang,
) -> str:
    """The class page. ``rows`` are the outcomes with their cells in words; ``common`` are sentences with their authors:
    name, link; ``absent`` lists the students without any drawing."""
    e = html.escape
    links = {row.file: row.link for row, _ in rows if row.link}
    cells = "".join(f'<th scope="col" data-name="{e(h)}"><button type="button">{e(h)}</button></th>' for h in head)
    often = ""
    for said, names in common:
        whose = ", ".join(_link_html(e(name), link) for name, link in names)
        often += f"<li>{sentence_html(said, (), Naming(lang))} — <b>{len(names)}</b>: {whose}</li>"
    parts = {
        "title": e(title),
        "counts": "".join(f"<span>{e(name)} <b>{count}</b></span>" for name, count in counts),
        **{key: e(text) for key, text in sentences_with_prefix("class_", lang, "check").items()},
        "absent": f"<p>{e(absent)}</p>" if absent else "",
        "common": f"<h2>{e(say('check_common', lang))}</h2><ol>{often}</ol>" if often else "",
        "head": cells,
        "sort": _sort_menu_html(head, lang),
        "rows": "".join(_drawing_row_html(number, row, texts, lang, links) for number, (row, texts) in enumerate(rows)),
    }
    body = web_page.fill_template("class.html", parts)
    style = ("check.css", "class.css")
    return web_page.fill_web_page(title, lang, style, body, code=packer.pack_modules("class"))


def _sort_menu_html(head: Sequence[str], lang: Lang) -> str:
    """A menu of the columns to sort by, for a screen so narrow that the table has no head."""
    columns = "".join(f'<option value="{k}">{html.escape(h)}</option>' for k, h in enumerate(head))
    caption = html.escape(say("check_sort", lang))
    return f'<p class="sort"><label>{caption}: <select><option value="">—</option>{columns}</select></label></p>'


def _drawing_row_html(number: int, row: ClassRow, cells: Sequence[str], lang: Lang, links: Mapping[str, str]) -> str:
    """A drawing: its name with a small picture, its cells, and windows about its wrong places."""
    naming = Naming(lang, **row.lettering)
    name, *rest, said = cells
    rest = [tagged_sentence(f"⟨{c}⟩", naming, row.plan_kind) if c and c == row.first else html.escape(c) for c in rest]
    name = html.escape(name)
    rest = [*rest, sentence_html(said, row.text_names, naming, row.plan_kind, links)]
    rest[-1] += _wrong_places_html(row.places, f"{number}-", naming, row.plan_kind) + _decision_buttons_html(lang)
    columns = "".join(f"<td>{c}</td>" for c in rest)
    small = f'<img alt="" src="{html.escape(row.picture)}">' if row.picture else ""
    kind = f"{row.verdict} unsure" if row.rank == UNSURE_RANK else row.verdict
    return f'<tr class="{kind}"><th scope="row">{_link_html(name + small, row.link)}</th>{columns}</tr>\n'


def _decision_buttons_html(lang: Lang) -> str:
    """The buttons by which a teacher decides about a drawing."""
    shown = ((key, html.escape(say(f"class_{key}", lang))) for key in ("accepted", "rejected"))
    buttons = "".join(f'<button type="button" value="{key}">{text}</button>' for key, text in shown)
    return f'<span class="decide">{buttons}</span>'


def _link_html(name: str, link: str) -> str:
    if link:
        return f'<a href="{html.escape(link, quote=True)}">{name}</a>'
    return name


def _wrong_places_html(places: Sequence[Json], page: str, naming: Naming, kind: str, caption: str = "") -> str:
    """Windows about wrong places; each names its marks if there are several. ``page`` distinguishes a drawing's from
    others on the page."""
    shown = "".join(
        wrong_place_html(
            place, f"{page}{k}", tagged_sentence(f"⟨{place['name']}⟩", naming, kind) if len(places) > 1 else ""
        )
        for k, place in enumerate(places)
    )
    said = f"<p>{html.escape(caption)}</p>" if caption else ""
    return f'<div class="places">{said}{shown}</div>' if places else ""


# of a window: the gap to the next, the area about the wrong place, an arrowhead
WINDOW_GAP_RATIO = 0.04
RING_RADIUS_RATIO = 0.06
HEAD_LENGTH_RATIO = 0.06


def wrong_place_html(place: Json, name: str, caption: str = "") -> str:
    """A wrong place of a drawing in two windows side by side: as drawn, and with the correct construction over it;
    ``name`` is unique on the page; ``caption``, HTML, is above it."""
    x0, y0, x1, y1 = place["box"]
    x, y = place["at"]
    w = x1 - x0
    h = y1 - y0
    e = html.escape
    under = _lines_svg(place, "strokes", "stroke")
    picture = f'<image id="w{name}" href="{e(place["picture"])}" width="{w:.2f}" height="{h:.2f}"/>'
    ring = f'<circle cx="{x - x0:.2f}" cy="{y1 - y:.2f}" r="{RING_RADIUS_RATIO * w:.2f}"/>'
    drawn = picture if place["picture"] else under + _plan_svg(place, "own")
    right = f'<use href="#w{name}" opacity=".4"/>' if place["picture"] else under
    plans = _plan_svg(place, "own") + _plan_svg(place, "true") + _lines_svg(place, "next", "next")
    box = f'y="0" width="{w:.2f}" height="{h:.2f}" viewBox="0 0 {w:.2f} {h:.2f}"'
    return (
        f'<span class="place">{caption}'
        f'<svg viewBox="0 0 {w * (2 + WINDOW_GAP_RATIO):.2f} {h:.2f}" role="img" aria-label="{e(place["name"])}">'
        f'<svg x="0" {box}>{drawn}{ring}</svg>'
        f'<svg x="{w * (1 + WINDOW_GAP_RATIO):.2f}" {box}>{right}{plans}{ring}</svg></svg></span>'
    )


def _plan_svg(place: Json, key: str) -> str:
    """Vectors with their heads, or the lines of a scheme."""
    return f'<g class="{key}">{_lines_svg(place, key, key)}{"" if place["lines"] else _heads_svg(place, key)}</g>'


def _lines_svg(place: Json, key: str, kind: str) -> str:
    line = f'<line class="{kind}" x1="{{0.real:.2f}}" y1="{{0.imag:.2f}}" x2="{{1.real:.2f}}" y2="{{1.imag:.2f}}"/>'
    return "".join(line.format(*ends) for ends in _vector_ends(place, key))


def _heads_svg(place: Json, key: str) -> str:
    long = HEAD_LENGTH_RATIO * (place["box"][2] - place["box"][0])
    heads = (
        arrowhead_corners(b, b - a, long, long * THICK_PEN_HEAD.wide / THICK_PEN_HEAD.long)
        for a, b in _vector_ends(place, key)
        if abs(b - a) >= long
    )
    listed = (" ".join(f"{z.real:.2f},{z.imag:.2f}" for z in corners) for corners in heads)
    return "".join(f'<polygon points="{points}"/>' for points in listed)


def _vector_ends(place: Json, key: str) -> Iterator[tuple[complex, complex]]:
    """The ends of vectors in their window, y down."""
    corner = complex(place["box"][0], place["box"][3])
    for ax, ay, bx, by in place[key]:
        yield (complex(ax, ay) - corner).conjugate(), (complex(bx, by) - corner).conjugate()


TRACING_WORD_KEYS = ("pole", "turned", "scale", "not_picture")


def tracing_page(data: Json, lang: Lang) -> str:
    """The tracing paper, from the data of :func:`planes.check.report.shown.tracing_data`."""
    words = sentences_with_prefix("trace_", lang, "check")
    parts = {k: html.escape(text) for k, text in {**words, "title": data["title"]}.items()}
    body = web_page.fill_template("trace.html", parts)
    style = ("check.css", "trace.css")
    names = (name for plan in data["plans"] for name in (*plan["marks"], *(name for name, *_ in plan["names"])))
    held = {
        "data": {**data, "words": {k: words[k] for k in TRACING_WORD_KEYS}},
        "letters": names_for_script(names, data["lettering"]),
    }
    return web_page.fill_web_page(data["title"], lang, style, body, code=packer.pack_modules("trace"), data=held)
