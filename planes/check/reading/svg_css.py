"""What an SVG file says in the way of CSS: lengths, transforms, how its elements are to look. tinycss2 takes the text
apart, cssselect2 knows whom a rule of a style sheet is meant for."""

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

from planes.check.reading.opened import too_many

Looks = Mapping[str, str]
LOOKS = ("stroke", "fill", "display", "visibility", "marker", "marker-start", "marker-end", "font-size", "text-anchor")
OWN = "transform"  # of an element alone: nothing in it takes it over
MM = 25.4 / 96  # of a unit of a picture that says no other
_UNITS = {"mm": 1 / MM, "cm": 10 / MM, "in": 96.0, "pt": 96 / 72, "pc": 16.0, "px": 1.0}
_TURNS = {"rad": math.degrees(1), "turn": 360.0, "grad": 0.9}
LONGEST = 200_000  # letters of a style sheet
MOST_ASKED = 10_000_000  # elements, for each the selectors
WITHIN = 20  # selectors that take as long as one that asks what stands around


@lru_cache(4096)
def numbers(text: str | None) -> tuple[float, ...]:
    """All numbers of a text; a length is in units of the picture, an angle in degrees."""
    return tuple(_numbers(parse_component_value_list(text or "")))


def _numbers(tokens: list[Any]) -> Iterator[float]:
    for one in tokens:
        if one.type == "dimension":
            yield one.value * (_UNITS | _TURNS).get(one.lower_unit, 1.0)
        elif one.type in ("number", "percentage"):
            yield one.value


def number(e: Element, key: str) -> float:
    """A coordinate; none is zero."""
    text = e.get(key, "")
    with suppress(ValueError):
        return float(text)
    return next(iter(numbers(text)), 0.0)


def length(text: str | None) -> float:
    """A side of a picture, in mm; 0 where it is a part of what is around it, or none."""
    return 0.0 if not text or "%" in text else next(iter(numbers(text)), 0.0) * MM


@lru_cache(4096)
def transform_of(text: str) -> Transform:
    """What a list of transforms does, the last one first."""
    transform = Transform()
    for part in parse_component_value_list(text.replace(" (", "(")):
        if part.type == "function":
            transform = _turned(transform, part.lower_name, list(_numbers(part.arguments)))
    return transform


def _turned(transform: Transform, name: str, said: list[float]) -> Transform:
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


def _declared(said: str | list[Any]) -> Looks:
    """What declarations say of looks."""
    every = (one for one in parse_blocks_contents(said) if one.type == "declaration")
    values = {one.lower_name: one.value for one in every if one.lower_name in (*LOOKS, OWN)}
    with suppress(RecursionError):  # brackets within brackets that no looks have
        return {name: serialize(value).strip() for name, value in values.items()}
    return {}


_of_itself = lru_cache(4096)(_declared)  # many elements say the same


def ruled(root: Element, file: str) -> dict[Element, Looks]:
    """What the file's style sheets say of each element. :class:`PlanesError` where they ask too much."""
    matcher, said, asked = Matcher(), list[Looks](), 0
    for rule in _rules(root):
        looks = _declared(rule.content)
        for selector in _selectors(rule.prelude) if looks else ():
            asked += WITHIN if isinstance(selector.parsed_tree, CombinedSelector) else 1
            matcher.add_selector(CompiledSelector(selector), len(said))
            said.append(looks)
    if asked * sum(1 for _ in root.iter()) > MOST_ASKED:
        raise too_many(file, "rules", MOST_ASKED)
    looks_by_element: dict[Element, Looks] = {}
    for e in ElementWrapper.from_xml_root(root).iter_subtree() if said else ():
        for *_, which in matcher.match(e):
            looks_by_element[e.etree_element] = {**looks_by_element.get(e.etree_element, {}), **said[which]}
    return looks_by_element


def _rules(root: Element) -> Iterator[Any]:
    for e in root.iter("style"):
        for rule in parse_stylesheet("".join(e.itertext())[:LONGEST]):
            if rule.type == "qualified-rule":
                yield rule


def _selectors(prelude: list[Any]) -> list[Any]:
    """Those a drawing can be asked in bounded time: no states, no neighbours, at most one element around."""
    if any(one == sign for one in prelude for sign in ":~+"):
        return []
    with suppress(SelectorError, RecursionError):  # it is none, or one of thousands of elements around one another
        known = list(selectors(prelude))
        return [s for s in known if not isinstance(getattr(s.parsed_tree, "left", None), CombinedSelector)]
    return []


def looks_of(e: Element, rules: Mapping[Element, Looks]) -> dict[str, str]:
    """How an element is to look, as far as it says itself."""
    looks = {k: v for k in (*LOOKS, OWN) if (v := e.get(k))}
    return {**looks, **rules.get(e, {}), **_of_itself(e.get("style") or "")}
