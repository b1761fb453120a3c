"""Plans as vector drawings in the style of drawing programs: SVG with nested transforms, DXF with blocks."""

from __future__ import annotations

import io
import math
import random
from collections.abc import Mapping, Sequence

from tests.helpers.drawings import Motion

Stroke = tuple[complex, complex]


def motion_strokes(m: Motion, marks: Mapping[str, complex], quick: bool) -> list[Stroke]:
    """The vectors of a velocity or acceleration plan: absolute ones from the pole, relative ones between marks."""
    found: dict[Stroke, None] = {}

    def draw(a: complex, b: complex) -> None:
        if abs(b - a) > 0.3:
            found.setdefault((a, b))

    middles = set()
    for task in m.tasks:
        new = marks[m.label(task.new, quick)]
        for leg in task.legs:
            start = marks.get(m.label(leg.known, quick), 0j) if leg.known else 0j
            for letter in "nk":
                name = f"{letter}_{task.new}{leg.known}"
                if name in marks:
                    middles.add(name)
                    draw(start, marks[name])
                    start = marks[name]
            draw(start, new)
    for name, z in marks.items():
        if name.startswith("n_") and name not in middles:  # of the driver
            draw(0j, z)
            draw(z, marks[name[2:].lower() + "'"])
        elif name not in middles:
            draw(0j, z)
    return list(found)


def labels(marks: Mapping[str, complex], rng: random.Random, height: float = 3.5) -> list[tuple[str, complex]]:
    """Names slightly off their marks, outwards, without overlap: (text, lower left corner)."""
    out: list[tuple[str, complex]] = []
    for name, z in marks.items():
        width = 0.7 * height * len(name)
        out_ = z / abs(z) if abs(z) > 1 else -1 - 1j
        best, worst = z, math.inf
        for k in range(12):
            u = out_ / abs(out_) * complex(math.cos(k * math.pi / 6), math.sin(k * math.pi / 6))
            corner = z + u * (1.5 + height / 2) + complex(u.real, 0) * width / 2 - complex(width, height) / 2
            near = float(sum(abs(corner - c) < height + 2 for _, c in out))
            middle = corner + complex(width, height) / 2
            near += sum(abs(middle - w) < height for n, w in marks.items() if n != name) + 0.05 * k
            if near < worst:
                best, worst = corner, near
        out.append((name, best))
    rng.random()
    return out


def vector_labels(
    vectors: list[tuple[str, complex]], height: float = 3.5, starts: Sequence[complex] = ()
) -> list[tuple[str, complex]]:
    """Names beside the vectors of a polygon that starts at 0 (or each elsewhere).

    Of two coincident vectors, each has its name at its own tip.
    """
    out, z = [("p", -complex(height, height))], 0j
    for k, (name, v) in enumerate(vectors):
        z = starts[k] if starts else z
        side = v / abs(v) * 1j * (1.2 + height / 2)
        width = 0.7 * height * len(name)
        upon = any(abs(v + w) < 0.1 * abs(v) for n, w in vectors if n != name)
        out.append((name, z + v * (0.75 if upon else 0.5) + side - complex(width, height) / 2))
        z += v
    return out


def beside_lines(
    words: list[tuple[str, complex]], strokes: list[Stroke], height: float = 3.5
) -> list[tuple[str, complex]]:
    """The words moved as little as needed to overlap no stroke and no other word, as a person writes them."""
    out: list[tuple[str, complex]] = []
    for text, corner in words:
        width, taken = 0.7 * height * len(text), [(z, 0.7 * height * len(t)) for t, z in out]
        ways = [complex(math.cos(k * math.pi / 12), math.sin(k * math.pi / 12)) for k in range(24)]
        places = [corner, *(corner + far * u for far in range(1, 25) for u in ways)]
        out.append((text, next((z for z in places if _free(z, width, height, strokes, taken)), corner)))
    return out


def _free(
    corner: complex, width: float, height: float, strokes: list[Stroke], taken: list[tuple[complex, float]]
) -> bool:
    """Whether a word's box, with a millimetre around it, touches no stroke and no other word."""
    low, high = corner - (1 + 1.5j), corner + complex(width + 1, height + 1)
    for other, wide in taken:
        gap = other - corner
        if -wide - 1 < gap.real < width + 1 and abs(gap.imag) < height + 1:
            return False
    for a, b in strokes:
        for k in range(count := int(abs(b - a) / 0.5) + 2):
            z = a + (b - a) * k / (count - 1)
            if low.real < z.real < high.real and low.imag < z.imag < high.imag:
                return False
    return True


def head(a: complex, b: complex) -> list[complex]:
    """A filled arrowhead: tip and two corners, smaller on a short vector."""
    size = min(3.0, 0.7 * abs(b - a))
    u = (b - a) / abs(b - a)
    return [b, b - size * u * (1 + 0.16j), b - size * u * (1 - 0.16j)]


def inkscape(strokes: list[Stroke], words: list[tuple[str, complex]], origin: complex) -> str:
    """In Inkscape's style: mm, a layer with a transform, paths with relative moves, markers, tspans."""
    size = 297.0
    out = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        '<svg xmlns="http://www.w3.org/2000/svg" width="420mm" height="297mm" viewBox="0 0 420 297">',
        '<defs><marker id="TriangleOutL"><path d="M0,0 L5,2 L0,4 z"/></marker></defs>',
        f'<g transform="translate({origin.real},{size - origin.imag})"><g transform="scale(1,-1) rotate(0)">',
    ]
    for a, b in strokes:
        d = b - a
        out.append(
            '<path style="fill:none;stroke:#000000;stroke-width:0.6;marker-end:url(#TriangleOutL)" '
            f'd="m {a.real:.3f},{a.imag:.3f} {d.real:.3f},{d.imag:.3f}"/>'
        )
    out.append("</g>")
    for text, z in words:
        out.append(
            f'<text style="font-size:4.8px" x="{z.real:.2f}" y="{-z.imag:.2f}"><tspan x="{z.real:.2f}" '
            f'y="{-z.imag:.2f}">{text}</tspan></text>'
        )
    return "\n".join([*out, "</g></svg>"])


def illustrator(strokes: list[Stroke], words: list[tuple[str, complex]], origin: complex) -> str:
    """Points at 72 dpi, polylines, symbols with use, heads as separate shapes, styles by class, matrices."""
    k = 72 / 25.4
    high = 297 * k
    out = [
        f'<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" '
        f'width="{420 * k:.2f}pt" height="{high:.2f}pt" viewBox="0 0 {420 * k:.2f} {high:.2f}">',
        "<style>.h{fill:#231f20;} .l{fill:none;stroke:#000;}</style><defs>",
    ]
    for i, (a, b) in enumerate(strokes):
        out.append(
            f'<polyline id="s{i}" class="l" points="{a.real * k:.3f},{-a.imag * k:.3f} '
            f'{b.real * k:.3f},{-b.imag * k:.3f}"/>'
        )
    out.append("</defs>")
    for i in range(len(strokes)):
        out.append(f'<use xlink:href="#s{i}" x="{origin.real * k:.3f}" y="{high - origin.imag * k:.3f}"/>')
    for a, b in strokes:
        corners = " ".join(f"{(z + origin).real * k:.3f},{high - (z + origin).imag * k:.3f}" for z in head(a, b))
        out.append(f'<polygon class="h" points="{corners}"/>')
    for text, z in words:
        at = z + origin
        out.append(
            f'<text transform="matrix(1 0 0 1 {at.real * k:.2f} {high - at.imag * k:.2f})" '
            f'font-size="13.6">{text}</text>'
        )
    return "\n".join([*out, "</svg>"])


def dxf(strokes: list[Stroke], words: list[tuple[str, complex]], origin: complex, blocks: bool = True) -> str:
    """Half of the lines in nested blocks, the rest as polylines; texts as TEXT and MTEXT.

    Heads are solid or a tapered end of the line.
    """
    from ezdxf.filemanagement import new

    document = new("R2010")
    document.units = 4
    space = document.modelspace()
    inner = document.blocks.new("INNER")
    outer = document.blocks.new("OUTER")
    for i, (a, b) in enumerate(strokes):
        if blocks and i % 2:
            inner.add_line((a.real / 2, a.imag / 2), (b.real / 2, b.imag / 2))
            tip, one, two = ((z + origin) for z in head(a, b))
            space.add_solid([(z.real, z.imag) for z in (one, two, tip, tip)])
        else:
            a, b = a + origin, b + origin
            neck = b - min(3.0, 0.7 * abs(b - a)) * (b - a) / abs(b - a)
            rows = [(a.real, a.imag, 0, 0), (neck.real, neck.imag, 1, 0), (b.real, b.imag, 0, 0)]
            space.add_lwpolyline(rows, format="xyse")
    outer.add_blockref("INNER", (0, 0), dxfattribs={"xscale": 2, "yscale": 2})
    space.add_blockref("OUTER", (origin.real, origin.imag))
    for i, (text, z) in enumerate(words):
        at = z + origin
        if i % 3 == 2:
            space.add_mtext(text, dxfattribs={"char_height": 3.5, "insert": (at.real, at.imag + 3.5)})
        else:
            space.add_text(text, height=3.5, dxfattribs={"insert": (at.real, at.imag)})
    out = io.StringIO()
    document.write(out)
    return out.getvalue()
