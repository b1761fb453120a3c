"""Where lines of an SVG lie and which are seen, by transforms, units and rules of style sheets, as a browser has it."""

from __future__ import annotations

import random
import re
from pathlib import Path

import pytest

from planes.check.reading.svg import read_svg
from tests.helpers.browser import chromium

PAGE = '<svg xmlns="http://www.w3.org/2000/svg" width="200mm" height="200mm" viewBox="-100 -100 200 200">'
UNITS = ["", "", "px", "mm", "cm", "in", "pt", "pc"]
TRANSFORMS = ["translate(N N)", "translate(N,N)", "scale(.D)", "rotate(N)", "rotate(N , N N)", "skewX(N) skewY(N)"]
TRANSFORMS += ["matrix(1.D .D -.D 1.D N,N)"]
STYLES = ["rotate(Ndeg)", "rotate(.Drad)", "translate(Nmm, Npx)", "scale(1.D)", "skewX(.0Dturn)"]
RULES = [
    ".a{display:none}",
    "g.pen .b{display:none}",
    "#L3, #L4{visibility:hidden}",
    "line.c{display:inline}",
    ".a.c{display:inline}",
    "g > .d{display:none}",
    '[data-x="1"]{display:none}',
    "/* x */ .e, .zz{display:none}",
    "@media print{.g{display:none}} .f{display:none}",
    "g{visibility:hidden}",
    "g.pen > line.g{visibility:visible}",
]
SEEN = """() => [...document.querySelectorAll('line')].filter(l => {
  for (let e = l; e; e = e.parentElement) if (getComputedStyle(e).display == 'none') return false
  return getComputedStyle(l).visibility == 'visible'
}).map(l => {
  const m = l.getCTM(), at = (x, y) => [m.a * x + m.c * y + m.e, m.b * x + m.d * y + m.f].map(v => v * 25.4 / 96)
  return [...at(l.x1.baseVal.value, l.y1.baseVal.value), ...at(l.x2.baseVal.value, l.y2.baseVal.value)]
})"""


def group(dice: random.Random, depth: int, lines: list[str]) -> str:
    """Lines and groups of a group."""

    def filled(form: str) -> str:
        form = re.sub("N", lambda _: f"{dice.uniform(-30, 30):.3g}", form)
        return re.sub("D", lambda _: str(dice.randint(1, 9)), form)

    text = ""
    for _ in range(dice.randint(1, 3)):
        if depth < 3 and dice.random() < 0.5:
            turned = " ".join(filled(dice.choice(TRANSFORMS)) for _ in range(dice.randint(0, 3)))
            style = f'style="transform:{filled(dice.choice(STYLES))}"' * (dice.random() < 0.3)
            inside = group(dice, depth + 1, lines)
            text += f'<g class="{dice.choice(["pen", "x"])}" transform="{turned}" {style}>{inside}</g>'
            continue
        places = (f'{k}="{dice.uniform(-40, 40):.2f}{dice.choice(UNITS)}"' for k in ("x1", "y1", "x2", "y2"))
        looks = dice.choice(["", "display:inline", "visibility:visible; stroke : red", "stroke:black;display:none"])
        own = f'class="{" ".join(dice.sample("abcdefg", dice.randint(0, 2)))}" data-x="{dice.randint(0, 4)}"'
        lines.append("")
        text += f'<line id="L{len(lines)}" {own} stroke="black" style="{looks}" {" ".join(places)}/>'
    return text


@pytest.mark.slow
def test_lines_lie_where_a_browser_has_them(tmp_path: Path) -> None:
    file, looked_at, hidden = tmp_path / "t.svg", 0, 0
    with chromium() as browser:
        page = browser.new_page()
        for seed in range(60):
            dice, lines = random.Random(seed), list[str]()
            rules = " ".join(dice.sample(RULES, dice.randint(0, 7)))
            text = f"{PAGE}<style>{rules}</style>{group(dice, 0, lines)}</svg>"
            page.set_content(text)
            theirs = [tuple(map(float, line)) for line in page.evaluate(SEEN)]
            file.write_text(text, encoding="utf-8")
            own = [(a.real, -a.imag, b.real, -b.imag) for a, b in read_svg(file).strokes]
            assert len(own) == len(theirs), text
            for line in theirs:
                near = 0.02 + 2e-4 * max(map(abs, line))  # a browser reckons with single precision
                both = (line, line[2:] + line[:2])
                assert any(t == pytest.approx(o, rel=0, abs=near) for o in own for t in both), text
            looked_at, hidden = looked_at + len(own), hidden + len(lines) - len(own)
    assert looked_at > 100 and hidden > 50
