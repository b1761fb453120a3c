"""The CSS of an SVG file: lengths, transforms, styles of elements.

tinycss2 parses the text, cssselect2 matches the rules of a style sheet to elements.
"""

import math
from collections.abc import Iterator, Mapping
from contextlib import suppress
from functools import lru_cache
from typing import Any
from xml.etree.ElementTree import Element

from cssselect2 import ElementWrapper, Matcher, SelectorError
from cssselect2.compiler import CompiledSelector
from cssselect2.parser import CombinedSelector
from cssselect2.parser import parse as selectors
from fontTools.misc.transform import Transform
from tinycss2 import parse_blocks_contents, parse_component_value_list, parse_stylesheet, serialize

from planes.check.reading.opened import too_many_error

Looks = Mapping[str, str]
STYLE_PROPERTIES = (
    "stroke",
    "fill",
    "display",
    "visibility",
    "marker",
    "marker-start",
    "marker-end",
    "font-size",
    "text-anchor",
)
TRANSFORM_PROPERTY = "transform"  # not inherited by child elements
MM_PER_PX = 25.4 / 96  # of the default unit of a picture
_PX_PER_UNIT = {"mm": 1 / MM_PER_PX, "cm": 10 / MM_PER_PX, "in": 96.0, "pt": 96 / 72, "pc": 16.0, "px": 1.0}
_DEG_PER_UNIT = {"rad": math.degrees(1), "turn": 360.0, "grad": 0.9}
LONGEST_STYLE_SHEET = 200_000  # letters of a style sheet
MOST_SELECTOR_TESTS = 10_000_000  # elements times selectors
ANCESTOR_SELECTOR_COST = 20  # selectors that take as long as one with an ancestor


@lru_cache(4096)
def parse_numbers(text: str | None) -> tuple[float, ...]:
    """All numbers of a text; lengths are in units of the picture, angles in degrees."""
    return tuple(_numbers_of_tokens(parse_component_value_list(text or "")))


def _numbers_of_tokens(tokens: list[Any]) -> Iterator[float]:
    for one in tokens:
        if one.type == "dimension":
            yield one.value * (_PX_PER_UNIT | _DEG_PER_UNIT).get(one.lower_unit, 1.0)
        elif one.type in ("number", "percentage"):
            yield one.value


def number_attribute(e: Element, key: str) -> float:
    """A coordinate; zero if missing."""
    text = e.get(key, "")
    with suppress(ValueError):
        return float(text)
    return next(iter(parse_numbers(text)), 0.0)


def side_length_mm(text: str | None) -> float:
    """A side of a picture, in mm; 0 if it is relative to the surroundings or missing."""
    if not text or "%" in text:
        return 0.0
    return next(iter(parse_numbers(text)), 0.0) * MM_PER_PX


@lru_cache(4096)
def parse_transform(text: str) -> Transform:
    """The transform of a list of transforms, the last one applied first."""
    transform = Transform()
    for part in parse_component_value_list(text.replace(" (", "(")):
        if part.type == "function":
            transform = _apply_transform(transform, part.lower_name, list(_numbers_of_tokens(part.arguments)))
    return transform


def _apply_transform(transform: Transform, name: str, said: list[float]) -> Transform:
    match name, said:
        case "matrix", [_, _, _, _, _, _]:
            return transform.transform(said)
        case "translate", [_, *_]:
            return transform.translate(*said[:2])
        case "scale", [_, *_]:
            return transform.scale(*said[:2])
        case "rotate", [turn, *about]:
            x, y = about[:2] if len(about) > 1 else (0.0, 0.0)
            return transform.translate(x, y).rotate(math.radians(turn)).translate(-x, -y)
        case "skewx", [turn, *_]:
            return transform.skew(math.radians(turn))
        case "skewy", [turn, *_]:
            return transform.skew(0.0, math.radians(turn))
    return transform


def _parse_declarations(said: str | list[Any]) -> Looks:
    """The style in declarations."""
    every = (one for one in parse_blocks_contents(said) if one.type == "declaration")
    values = {one.lower_name: one.value for one in every if one.lower_name in (*STYLE_PROPERTIES, TRANSFORM_PROPERTY)}
    with suppress(RecursionError):  # nested brackets that occur in no style
        return {name: serialize(value).strip() for name, value in values.items()}
    return {}


_of_itself = lru_cache(4096)(_parse_declarations)  # many elements have equal declarations


def styles_by_element(root: Element, file: str) -> dict[Element, Looks]:
    """The style of each element in the file's style sheets. :class:`PlanesError` if they are too complex."""
    matcher = Matcher()
    said = list[Looks]()
    asked = 0
    for rule in _style_rules(root):
        looks = _parse_declarations(rule.content)
        for selector in _bounded_selectors(rule.prelude) if looks else ():
            asked += ANCESTOR_SELECTOR_COST if isinstance(selector.parsed_tree, CombinedSelector) else 1
            matcher.add_selector(CompiledSelector(selector), len(said))
            said.append(looks)
    if asked * sum(1 for _ in root.iter()) > MOST_SELECTOR_TESTS:
        raise too_many_error(file, "rules", MOST_SELECTOR_TESTS)
    looks_by_element: dict[Element, Looks] = {}
    for e in ElementWrapper.from_xml_root(root).iter_subtree() if said else ():
        for *_, which in matcher.match(e):
            looks_by_element[e.etree_element] = {**looks_by_element.get(e.etree_element, {}), **said[which]}
    return looks_by_element


def _style_rules(root: Element) -> Iterator[Any]:
    for e in root.iter("style"):
        for rule in parse_stylesheet("".join(e.itertext())[:LONGEST_STYLE_SHEET]):
            if rule.type == "qualified-rule":
                yield rule


def _bounded_selectors(prelude: list[Any]) -> list[Any]:
    """Selectors that match in bounded time: no states, no siblings, at most one ancestor."""
    if any(one == sign for one in prelude for sign in ":~+"):
        return []
    with suppress(SelectorError, RecursionError):  # invalid, or with thousands of nested elements
        known = list(selectors(prelude))
        return [s for s in known if not isinstance(getattr(s.parsed_tree, "left", None), CombinedSelector)]
    return []


def style_of_element(e: Element, rules: Mapping[Element, Looks]) -> dict[str, str]:
    """The style of an element, as far as it is given for the element itself."""
    looks = {k: v for k in (*STYLE_PROPERTIES, TRANSFORM_PROPERTY) if (v := e.get(k))}
    return {**looks, **rules.get(e, {}), **_of_itself(e.get("style") or "")}
