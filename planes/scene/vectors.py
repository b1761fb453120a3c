"""A scene without a mechanism: vectors with partly known data, values computed from them, and the equations between
them."""

import re
from collections.abc import Mapping
from types import MappingProxyType

from planes.scene.expressions import evaluate, is_name
from planes.scene.load_laws import LawReader
from planes.scene.mechanism import Drive, LoadLaw, nothing
from planes.scene.reader import MAX_NAME, MOST, Fields, Reader, part
from planes.scene.source import Items, Node, SourceScalar, SourceTable
from planes.scene.structures import Framework
from planes.scene.vector_amounts import VectorAmount, read_amount
from planes.scene.vector_equations import VECTOR, VectorEquation, read_equation
from planes.words import Phrase, Told
from planes.words.errors import EquationError, ExpressionError, SceneError, choices, shown
from planes.words.frozen import field, frozen, replace
from planes.words.names import turned_back

VECTOR_KEYS = ("value", "direction", "perpendicular_to", "near", "similar", "ratio", "angle", "as")
_NAME = re.compile(VECTOR)
_FACTOR = re.compile(r"\s*[*(·]")  # a coefficient, or a function in one
_FORCES = re.compile(r"force:\w+(?:-\w+)*")
Amount = float | VectorAmount | LoadLaw
MOST_VECTORS = 300  # with the values


@frozen
class AlongVector:
    """The direction of another vector, turned by ``quarter`` right angles."""

    vector: str
    quarter: int = 0


@frozen
class Similarity:
    """A vector in the ratio of a complex number to the vector ``of``, or as the first of ``shape`` to the second."""

    of: str
    ratio: complex = 1 + 0j
    shape: tuple[str, str] | None = None


@frozen
class VectorGiven:
    """The data of a vector in a scene; ``near_deg`` selects one of two solutions."""

    value: Amount | None = None
    direction: float | AlongVector | LoadLaw | None = None
    near_deg: float | None = None
    like: Similarity | None = None


@frozen
class Statement:
    """The contents of a scene of vectors; ``values`` are numbers computed from its vectors and ``parameters``,
    ``quantity`` is the plan whose unit its ``mu`` has. For a scene of ``statics``, which states the vectors."""

    vectors: Mapping[str, VectorGiven] = field(default_factory=nothing)
    equations: tuple[VectorEquation, ...] = ()
    values: Mapping[str, Amount] = field(default_factory=nothing)
    parameters: Mapping[str, float] = field(default_factory=nothing)
    quantity: str | None = None
    statics: Framework | None = None
    drive: Drive | None = None  # the variable of the laws among them


def read_own(reader: Reader, node: Node) -> tuple[VectorEquation, ...]:
    """The user's equations beside a mechanism, whether they hold or not."""
    equations = []
    for n, entry in enumerate(reader.items(node, "equations") if isinstance(node, Items) else [node], 1):
        text = reader.text(entry, Phrase("equation", number=n)).strip()
        try:
            own = read_equation(text, lambda times: evaluate(times, reader.parameters), entry.line, chained=False)
        except (EquationError, ExpressionError) as error:
            raise SceneError(Phrase("about", what=shown(text), why=error.phrase), reader.file, entry.line) from None
        equations.append(own)
    return tuple(equations)


class StatementReader:
    """Reads a scene of vectors: names first, so that they may be used anywhere."""

    def __init__(self, scene: Fields, laws: LawReader | None) -> None:
        self.scene, self.laws = scene.table, laws
        self.reader = reader = scene.reader
        self.vectors = reader.table(scene.table.entries["vectors"], "vectors")
        values = scene.optional("values")
        self.values = reader.table(values, "values") if values else SourceTable({}, 0, {})
        if not self.vectors.entries:
            raise reader.fault("vectors_empty", self.vectors)
        self._check_count()
        self._check_names()
        self.names = (*self.vectors.entries, *self.values.entries)

    def _check_count(self) -> None:
        count = len(self.vectors.entries) + len(self.values.entries)
        if count > MOST_VECTORS:
            raise self.reader.fault("vectors_many", self.vectors, count=count, most=MOST_VECTORS)

    def _check_names(self) -> None:
        taken = {n: Phrase("a_parameter") for n in self.reader.parameters}
        for table, key, kind in ((self.vectors, "bad_vector", "a_vector"), (self.values, "bad_value_name", "a_value")):
            for name, line in table.lines.items():
                fits = _NAME.fullmatch(name) if table is self.vectors else is_name(name)
                if len(name) > MAX_NAME or not fits:
                    raise self.reader.fault(key, line, name=shown(name), most=MAX_NAME)
                if name in taken:
                    raise self.reader.fault("name_taken", line, name=name, one=taken[name], other=Phrase(kind))
                taken[name] = Phrase(kind)

    def read(self, quantity: str | None) -> Statement:
        vectors = {name: self.vector(name, node) for name, node in self.vectors.entries.items()}
        values = {
            name: self.amount(node, part(name, Phrase("section", name="values")))
            for name, node in self.values.entries.items()
        }
        equations = self.equations(self.scene.entries["equations"])
        return Statement(
            MappingProxyType(vectors),
            equations,
            MappingProxyType(values),
            self.reader.parameters,
            quantity,
            drive=self.laws.drive if self.laws else None,
        )

    def amount(self, node: Node, what: Phrase) -> Amount:
        """A number, an expression of vectors, values and parameters, or a law of the drive."""
        if self.laws and self.laws.follows(node):
            return self.laws.amount(node, what)
        if not isinstance(node, SourceScalar) or node.absent:
            return self.reader.number(node, what)
        try:
            amount = read_amount(node.text, self.reader.parameters, self.names)
        except ExpressionError as error:
            raise self.reader.fault("about", node, what=what, why=error.phrase) from None
        if isinstance(amount, VectorAmount):
            return amount
        if abs(amount) > MOST:
            raise self.reader.fault("out_of_range", node, what=what, value=amount, most=MOST)
        return amount

    def vector(self, name: str, node: Node) -> VectorGiven:
        what = Phrase("vector", name=name)
        if isinstance(node, SourceScalar) and node.absent:
            return VectorGiven()
        vector = Fields(self.reader, node, what, VECTOR_KEYS)
        if {"similar", "ratio", "angle", "as"} & {*vector.table.entries}:
            return VectorGiven(like=self.similarity(vector))
        if "direction" in vector and "perpendicular_to" in vector:
            vector.one_of("direction", "perpendicular_to")
        value = vector.optional("value")
        size = None if value is None else self.amount(value, vector.named("value"))
        direction = self.direction(vector, "direction", 0)
        if direction is None:
            direction = self.direction(vector, "perpendicular_to", 1)
        return VectorGiven(size, direction, vector.said("near"))

    def direction(self, vector: Fields, key: str, quarter: int) -> float | AlongVector | LoadLaw | None:
        """Degrees, the direction of another vector (r_BC, or -r_BC reversed), or a law of the drive."""
        node = vector.optional(key)
        if node is not None and quarter == 0 and self.laws and self.laws.follows(node):
            law = self.laws.amount(node, vector.named(key))
            return law if isinstance(law, LoadLaw) else float(law)
        name, back = turned_back(node.text if isinstance(node, SourceScalar) else "")
        if name in self.vectors.entries:
            return AlongVector(name, quarter + 2 * back)
        if node is not None and _NAME.fullmatch(name) and name not in self.reader.parameters and name != "pi":
            self.named(node, name, vector.named(key))
        degrees = vector.said(key)
        return None if degrees is None else degrees + 90.0 * quarter

    def named(self, node: Node, name: str, what: Told) -> str:
        """The name of a vector of the scene."""
        if name not in self.vectors.entries:
            valid, name_shown = choices(name, self.vectors.entries), name if len(name) <= MAX_NAME else shown(name)
            raise self.reader.fault("no_vector", node, text=what, name=name_shown, valid=valid)
        return name

    def similarity(self, vector: Fields) -> Similarity:
        """{similar: v_CB, ratio: 0.4, angle: 30} or {similar: v_CB, as: [r_BS, r_BC]}."""
        for key in ("value", "direction", "perpendicular_to", "near"):
            if key in vector:
                raise vector.fault("both_keys", key, what=vector.what, one="similar", two=key)
        pattern = self.named(vector.required("similar"), vector.text("similar"), vector.named("similar"))
        if vector.one_of("ratio", "as") == "ratio":
            ratio, turn = vector.number("ratio"), vector.said("angle") or 0.0
            return Similarity(pattern, ratio * complex(evaluate(f"cos({turn!r})", {}), evaluate(f"sin({turn!r})", {})))
        shape, label = vector.required("as"), vector.named("as")
        if "angle" in vector:
            raise vector.fault("both_keys", "angle", what=vector.what, one="as", two="angle")
        items = self.reader.items(shape, label)
        if len(items) != 2:
            raise self.reader.fault("similar_pair", shape, what=label, count=len(items))
        one, two = (self.named(item, self.reader.text(item, label), label) for item in items)
        return Similarity(pattern, shape=(one, two))

    def equations(self, node: Node) -> tuple[VectorEquation, ...]:
        """The equations with their lines."""
        nodes = self.reader.items(node, "equations") if isinstance(node, Items | SourceTable) else [node]
        if not nodes:
            raise self.reader.fault("equations_empty", node)
        return tuple(self.equation(entry, Phrase("equation", number=n)) for n, entry in enumerate(nodes, 1))

    def equation(self, node: Node, what: Told) -> VectorEquation:
        if isinstance(node, SourceTable):  # under the name of its plan
            (plan, own), *more = node.entries.items() or [("", node)]
            if more or not _FORCES.fullmatch(plan):
                raise self.reader.fault("no_such_plan", node, plan=shown(plan))
            return replace(self.equation(own, what), plan=plan)
        text = self.reader.text(node, what).strip()
        if "=" not in text:
            raise self.reader.fault("not_equation", node, text=shown(text))
        for match in _NAME.finditer(text):
            if not _FACTOR.match(text, match.end()) and match[0] not in self.reader.parameters:
                self.named(node, match[0], text)
        try:
            equation = read_equation(text, lambda times: evaluate(times, self.reader.parameters), node.line)
        except (EquationError, ExpressionError) as error:
            phrase = error.phrase
            sentence = phrase if isinstance(error, EquationError) else Phrase("about", what=text, why=phrase)
            raise SceneError(sentence, self.reader.file, node.line) from None
        for name in equation.names:  # a parameter in place of a vector
            self.named(node, name, text)
        return equation
