"""A formula as Word's own equation (Office MathML, ECMA-376-1 §22.1), which a person can go on editing there."""

from collections.abc import Iterable, Sequence
from html import unescape
from typing import Any
from xml.etree.ElementTree import Element

from docx.oxml import OxmlElement
from latex2mathml.converter import convert_to_element

PARTS = {
    "mfrac": ("f", "num", "den"),
    "msub": ("sSub", "e", "sub"),
    "msup": ("sSup", "e", "sup"),
    "msubsup": ("sSubSup", "e", "sub", "sup"),
}
"""What an element of MathML is called here, and its children in their order."""
BRACKETS = {"(": ")", "[": "]", "|": "|"}


def equation(tex: str) -> Any:
    """The equation, an element for a paragraph."""
    spaced = r"\quad ".join(tex.replace(r"\dfrac", r"\frac").split(r"\quad"))
    return _row([convert_to_element(spaced)], _made("oMath"))


def _row(nodes: Sequence[Element], into: Any) -> Any:
    """Elements of MathML one after another; what stands in brackets is one thing, with a power where it has one."""
    nodes = _joined(part for node in nodes for part in _opened(node))
    while nodes:
        node, *nodes = nodes
        closing = BRACKETS.get(_text(node))
        end = next((k for k, one in enumerate(nodes) if _text(_base(one)) == closing), None) if closing else None
        if closing is None or end is None:
            _put(node, into)
            continue
        last, inside = nodes[end], into
        if last is not _base(last):
            made = _made("sSup", into)
            inside = _made("e", made)
            _row([last[1]], _made("sup", made))
        group = _made("d", inside)
        ends = _made("dPr", group)
        _made("begChr", ends, val=_text(node))
        _made("endChr", ends, val=closing)
        _row(nodes[:end], _made("e", group))
        nodes = nodes[end + 1 :]
    return into


def _opened(node: Element) -> list[Element]:
    """What a row holds."""
    plain = _kind(node) in ("math", "mrow", "mstyle")
    return [part for child in node for part in _opened(child)] if plain else [node]


def _put(node: Element, into: Any) -> None:
    """One element with all it holds."""
    if parts := PARTS.get(_kind(node)):
        made = _made(parts[0], into)
        for place, child in zip(parts[1:], node, strict=True):
            _row([child], _made(place, made))
    elif _kind(node) == "msqrt":
        root = _made("rad", into)
        _made("degHide", _made("radPr", root), val="1")
        _made("deg", root)
        _row([*node], _made("e", root))
    else:
        run = _made("r", into)
        style = _made("rPr", run)
        if _kind(node) == "mtext":
            _made("nor", style)
        else:
            _made("sty", style, val="i" if _kind(node) == "mi" else "p")
        _made("t", run).text = _text(node) or " "


def _joined(nodes: Iterable[Element]) -> list[Element]:
    """The same with the digits of a number together, and the letters of a word."""
    made = list[Element]()
    for node in nodes:
        upright = _kind(node) == "mi" and (node.get("mathvariant") == "normal" or len(_text(node)) > 1)
        kind = "mtext" if upright else _kind(node)
        last = _kind(made[-1]) if made else ""
        if (last == "mn" and (kind == "mn" or _text(node) == ",")) or last == kind == "mtext":
            made[-1].text = _text(made[-1]) + _text(node)
        elif kind == "msup" and last == _kind(node[0]) == "mn":  # of 0,21² the power is of all
            node[0].text = _text(made.pop()) + _text(node[0])
            made.append(node)
        elif len(node):
            made.append(node)
        else:
            made.append(Element(kind))
            made[-1].text = _text(node)
    return made


def _base(node: Element) -> Element:
    """What a power is of."""
    return node[0] if _kind(node) == "msup" and _kind(node[0]) == "mo" else node


def _kind(node: Element) -> str:
    return str(node.tag)


def _text(node: Element) -> str:
    return unescape(node.text or "")


def _made(name: str, into: Any = None, **values: str) -> Any:
    made = OxmlElement(f"m:{name}")
    for key, value in values.items():
        made.set(f"{{{made.nsmap['m']}}}{key}", value)
    if into is not None:
        into.append(made)
    return made
