"""A wrong place of a drawing in two windows side by side: as it was drawn, and with the right construction upon it."""

import html
from collections.abc import Sequence

from planes.words.records import Json

GAP, RING_MM = 0.04, 2.2  # between the windows, of their width; about the wrong place
HEAD_MM, HALF_MM = 2.6, 0.65  # of an arrowhead


def place_picture(place: Json, name: str) -> str:
    """The windows of one place; ``name`` tells it from all others of the page."""
    x0, y0, x1, y1 = (float(v) for v in place["box"])
    w, h = x1 - x0, y1 - y0
    e, under = html.escape, _lines(place, "strokes", "stroke")
    picture = f'<image id="w{name}" href="{e(place["picture"])}" width="{w:.2f}" height="{h:.2f}"/>'
    again = f'<use href="#w{name}" opacity=".4"/>'
    x, y = float(place["at"][0]) - x0, y1 - float(place["at"][1])
    ring = f'<circle cx="{x:.2f}" cy="{y:.2f}" r="{RING_MM}"/>'
    drawn = picture if place["picture"] else under + _plan(place, "own")
    right = again if place["picture"] else under
    plans = _plan(place, "own") + _plan(place, "true") + _lines(place, "next", "next")
    box = f'y="0" width="{w:.2f}" height="{h:.2f}" viewBox="0 0 {w:.2f} {h:.2f}"'
    whole, beside = w * (2 + GAP), w * (1 + GAP)
    return (
        f'<span class="place"><svg viewBox="0 0 {whole:.2f} {h:.2f}" role="img" aria-label="{e(place["name"])}">'
        f'<svg x="0" {box}>{drawn}{ring}</svg><svg x="{beside:.2f}" {box}>{right}{plans}{ring}</svg></svg></span>'
    )


def _plan(place: Json, key: str) -> str:
    """Vectors with their heads, of a scheme lines."""
    heads = "" if place["lines"] else "".join(_head(place, v) for v in place[key])
    return f'<g class="{key}">{_lines(place, key, key)}{heads}</g>'


def _lines(place: Json, key: str, kind: str) -> str:
    ends = ((a.real, a.imag, b.real, b.imag) for a, b in (_ends(place, v) for v in place[key]))
    line = '<line class="{}" x1="{:.2f}" y1="{:.2f}" x2="{:.2f}" y2="{:.2f}"/>'
    return "".join(line.format(kind, *four) for four in ends)


def _ends(place: Json, vector: Sequence[float]) -> tuple[complex, complex]:
    """The ends of a vector in its window, y down."""
    x0, _, _, y1 = place["box"]
    ax, ay, bx, by = vector
    return complex(ax - x0, y1 - ay), complex(bx - x0, y1 - by)


def _head(place: Json, vector: Sequence[float]) -> str:
    a, b = _ends(place, vector)
    if abs(b - a) < HEAD_MM:
        return ""
    along = (b - a) / abs(b - a)
    corners = (b, b - along * complex(HEAD_MM, HALF_MM), b - along * complex(HEAD_MM, -HALF_MM))
    return f'<polygon points="{" ".join(f"{z.real:.2f},{z.imag:.2f}" for z in corners)}"/>'
