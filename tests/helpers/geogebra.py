"""Reads a .ggb like GeoGebra: evaluates its commands and formulas in order. Shares no code with the engine."""

import ast
import io
import math
import re
import zipfile
from collections.abc import Callable
from typing import Any
from xml.etree import ElementTree as xml

LABEL = re.compile(r"[^\W\d]\w*(?:\{\w+\})?")
WORDS = {"pi", "cos", "sin", "sqrt", "abs", "atan2", "sgn", "If", "UnitVector", "Distance", "Rotate", "and"}
Line = tuple[complex, complex]


def cross(a: complex, b: complex) -> float:
    return (a.conjugate() * b).imag


def dot(a: complex, b: complex) -> float:
    return (a.conjugate() * b).real


def rotate(z: complex, turn: float, about: complex = 0j) -> complex:
    return about + (z - about) * complex(math.cos(turn), math.sin(turn))


def intersect(one: Any, two: Any, index: int = 0) -> complex:
    """Lines are (point, direction), circles (centre, radius); of two intersections the second if the index is 2."""
    (p, u), (q, w) = one, two
    if isinstance(w, complex):
        return complex(p + u * cross(q - p, w) / cross(u, w))
    if isinstance(u, complex):
        u /= abs(u)
        foot = p + u * dot(u, q - p)
        return complex(foot + (3 - 2 * index) * u * math.sqrt(max(w * w - abs(q - foot) ** 2, 0)))
    far = abs(q - p)
    along = (far * far + u * u - w * w) / (2 * far)
    up = math.sqrt(max(u * u - along * along, 0))
    return complex(p + (q - p) / far * complex(along, (2 * index - 3) * up))


COMMANDS: dict[str, Callable[..., Any]] = {
    "Rotate": rotate,
    "Translate": lambda z, way: z + way,
    "Dilate": lambda z, times, about: about + (z - about) * times,
    "Line": lambda p, way: (p, way),
    "Circle": lambda centre, radius: (centre, radius),
    "Vector": lambda start, end: end - start,
    "Segment": lambda start, end: (start, end),
    "UnitVector": lambda v: v / abs(v),
    "Intersect": intersect,
    "Max": max,
    "Distance": lambda a, b: abs(b - a),
    "cos": math.cos,
    "sin": math.sin,
    "sqrt": math.sqrt,
    "abs": abs,
    "atan2": math.atan2,
    "sgn": lambda x: (x > 0) - (x < 0),
}


class Page:
    """The construction of a file; ``number`` sets a slider, ``points`` evaluates again."""

    def __init__(self, data: bytes) -> None:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            self.body = xml.fromstring(archive.read("geogebra.xml")).find("construction")
        assert self.body is not None
        self.set: dict[str, float] = {}

    def points(self) -> dict[str, Any]:
        """All elements by label."""
        self.made: dict[str, Any] = {}
        assert self.body is not None
        for element in self.body:
            label = element.get("label", "")
            if element.tag == "expression" and not element.get("exp", "").startswith('"'):
                self.made[label] = self.value(element.get("exp", ""))
            elif element.tag == "command":
                self.command(element)
            elif element.tag == "element" and element.get("type") == "numeric" and label not in self.made:
                value = element.find("value")
                assert value is not None
                self.made[label] = self.set.get(label, float(value.get("val", "")))
        return self.made

    def command(self, element: xml.Element) -> None:
        inputs, outputs = element.find("input"), element.find("output")
        assert inputs is not None and outputs is not None
        texts, label = list(inputs.attrib.values()), outputs.get("a0", "")
        name = element.get("name", "")
        self.made[label] = self.value(f"{name}[{', '.join(texts)}]")

    def value(self, text: str) -> Any:
        names: list[str] = []

        def named(match: re.Match[str]) -> str:
            if match[0] in WORDS or match[0] in COMMANDS:
                return match[0]
            assert match[0] in self.made, f"{match[0]} is used before it is made"
            names.append(match[0])
            return f"_{len(names) - 1}"

        text = re.sub(r"(?<![\w.])\d[\d.]*E[-+]?\d+", lambda m: repr(float(m[0])).replace("e", "§"), text)
        text = LABEL.sub(named, text.replace("&&", " and "))
        text = re.sub(r"§", "e", text).replace("^", "**").replace("⊗", "@")
        return self.of(ast.parse(re.sub(r"(\b[A-Z]\w+)\[", r"\1[", text).strip(), mode="eval").body, names)

    def of(self, node: ast.expr, names: list[str]) -> Any:
        match node:
            case ast.Constant():
                return node.value
            case ast.Name(id="pi"):
                return math.pi
            case ast.Name():
                return self.made[names[int(node.id[1:])]]
            case ast.Tuple():
                return complex(*(self.of(x, names) for x in node.elts))
            case ast.UnaryOp():
                return -self.of(node.operand, names)
            case ast.Subscript(value=ast.Name(id="If"), slice=ast.Tuple(elts=[test, yes, *no])):
                return self.of(yes, names) if self.of(test, names) else self.of(no[0], names)
            case ast.Subscript(value=ast.Name(id=name), slice=inner):
                args = inner.elts if isinstance(inner, ast.Tuple) else [inner]
                return COMMANDS[name](*(self.of(x, names) for x in args))
            case ast.Call(func=ast.Name(id=name)):
                return COMMANDS[name](*(self.of(x, names) for x in node.args))
            case ast.BoolOp():
                return all(self.of(x, names) for x in node.values)
            case ast.Compare():
                a, b = self.of(node.left, names), self.of(node.comparators[0], names)
                return a >= b if isinstance(node.ops[0], ast.GtE) else a > b
            case ast.BinOp():
                return self.binary(node.op, self.of(node.left, names), self.of(node.right, names))
        raise AssertionError(ast.dump(node))

    @staticmethod
    def binary(op: ast.operator, a: Any, b: Any) -> Any:
        match op:
            case ast.Add():
                return a + b
            case ast.Sub():
                return a - b
            case ast.Mult():
                return dot(a, b) if isinstance(a, complex) and isinstance(b, complex) else a * b
            case ast.Div():
                return a / b
            case ast.Pow():
                return a**b
            case ast.MatMult():
                return cross(a, b)
        raise AssertionError(op)
