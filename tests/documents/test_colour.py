"""Colour with meaning: a link and its vectors alike in both figures, by choice, legible, on the screen alone."""

from __future__ import annotations

from typing import Any

import pytest

STROKE = """window.stroke = name => { const e = document.querySelector(`figure [data-name~='${name}']`);
    return getComputedStyle(e.querySelector('line') || e).stroke; };
window.light = colour => { const c = document.createElement('canvas').getContext('2d'); c.fillStyle = colour;
    c.fillRect(0, 0, 1, 1);
    const [r, g, b] = [...c.getImageData(0, 0, 1, 1).data].map(v => v / 255).map(
        v => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
    return 0.2126 * r + 0.7152 * g + 0.0722 * b; };
window.contrast = colour => { const own = [colour, getComputedStyle(document.querySelector('figure')).backgroundColor];
    const [low, high] = own.map(light).sort((a, b) => a - b); return (high + 0.05) / (low + 0.05); }"""
VECTORS = (("link:1", "v_B"), ("link:2", "v_CB"), ("link:3", "v_C"), ("link:2", "v_L"), ("link:4", "v_HL"))


def test_a_link_and_its_vectors_have_one_colour_by_choice(page: Any) -> None:
    page.evaluate(STROKE)
    page.evaluate("go(data.frames.findIndex(f => f.makes[0] === 'velocity:h'))")
    plain = page.evaluate("['link:2', 'v_CB', 'v_C'].map(stroke)")
    assert len({*plain}) == 1 and page.get_attribute("#colour", "aria-pressed") == "false"
    page.click("#colour")
    for link, vector in VECTORS:
        assert page.evaluate(f"stroke({link!r})") == page.evaluate(f"stroke({vector!r})"), vector
    assert len({page.evaluate(f"stroke('link:{k}')") for k in range(1, 6)}) == 5
    for scheme in ("light", "dark"):
        page.emulate_media(color_scheme=scheme)
        assert all(page.evaluate(f"contrast(stroke('link:{k}'))") >= 3 for k in range(1, 6)), scheme
        fixed = [f"<i data-own={k}></i>" for k in range(7)]
        page.evaluate(f"document.querySelector('#follow').innerHTML = {''.join(fixed)!r}")
        page.evaluate("document.querySelectorAll('#follow i').forEach(e => e.style.color = 'var(--own)')")
        own = "[...document.querySelectorAll('#follow i')].map(e => contrast(getComputedStyle(e).color))"
        assert min(page.evaluate(own)) >= 3, page.evaluate(own)
    page.emulate_media(media="print", color_scheme="light")
    assert len({*page.evaluate("['link:2', 'link:3'].map(stroke)")}) == 1


@pytest.mark.slow
def test_the_choice_is_kept_in_the_address(browser: Any, lesson: str) -> None:
    one = browser.new_page()
    one.goto(f"{lesson}#step=9&lang=ru&colour=1")
    assert one.evaluate("document.body.classList.contains('coloured')")
    one.click("#colour")
    one.wait_for_function("!location.hash.includes('colour')")
    one.close()
