"""A scene without a mechanism: vectors with partly known data, values computed from them, and the equations between
them."""

import re
from collections.abc import Mapping
from types import MappingProxyType

from planes.scene.expressions import evaluate_expression, is_parameter_name
from planes.scene.load_laws import LawReader
from planes.scene.mechanism import Drive, LoadLaw, nothing
from planes.scene.reader import LARGEST_SCENE_NUMBER, MAX_NAME_LENGTH, Fields, Reader, part_in_words
from planes.scene.source import Items, Node, SourceScalar, SourceTable
from planes.scene.vector_amounts import VectorAmount, read_amount
from planes.scene.vector_equations import VECTOR_NAME_PATTERN, VectorEquation, VectorEquations, read_equation
from planes.words import Phrase, Told
from planes.words.errors import EquationError, ExpressionError, SceneError, list_valid_choices, quoted_excerpt
from planes.words.frozen import field, frozen, replace
from planes.words.names import NamePair, NumbersByName, PlanId, split_reversal_sign

VECTOR_KEYS = ("value", "direction", "perpendicular_to", "near", "similar", "ratio", "angle", "as")
_VECTOR_NAME_REGEX = re.compile(VECTOR_NAME_PATTERN)
_FACTOR_PATTERN = re.compile(r"\s*[*(·]")  # a coefficient, or a function in one
_FORCE_PLAN_PATTERN = re.compile(r"force:\w+(?:-\w+)*")
Amount = float | VectorAmount | LoadLaw
MOST_VECTORS_AND_VALUES = 300  # with the values


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
    shape: NamePair | None = None


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
    ``quantity`` is the plan whose unit its ``mu`` has. The ``subject`` of a pack states the vectors itself."""

    vectors: Mapping[str, VectorGiven] = field(default_factory=nothing)
    equations: VectorEquations = ()
    values: Mapping[str, Amount] = field(default_factory=nothing)
    parameters: NumbersByName = field(default_factory=nothing)
    quantity: str | None = None
    subject: object | None = None
    drive: Drive | None = None  # the variable of the laws among them


def read_own_equations(reader: Reader, node: Node) -> VectorEquations:
    """The user's equations beside a mechanism, whether they hold or not."""
    equations = []
    for n, entry in enumerate(reader.read_list(node, "equations") if isinstance(node, Items) else [node], 1):
        text = reader.read_text(entry, Phrase("equation", number=n)).strip()
        try:
            own = read_equation(
                text, lambda times: evaluate_expression(times, reader.parameters), entry.line, chained=False
            )
        except (EquationError, ExpressionError) as error:
            raise SceneError(
                Phrase("about", what=quoted_excerpt(text), why=error.phrase), reader.file, entry.line
            ) from None
        equations.append(own)
    return tuple(equations)


class StatementReader:
    """Reads a scene of vectors: names first, so that they may be used anywhere."""

    def __init__(self, scene: Fields, laws: LawReader | None) -> None:
        self.scene = scene.table
        self.laws = laws
        self.reader = reader = scene.reader
        self.vectors = reader.read_table(scene.table.entries["vectors"], "vectors")
        values = scene.optional_node("values")
        self.values = reader.read_table(values, "values") if values else SourceTable({}, 0, {})
        if not self.vectors.entries:
            raise reader.error_by_key("vectors_empty", self.vectors)
        self._check_count()
        self._check_names()
        self.names = (*self.vectors.entries, *self.values.entries)

    def _check_count(self) -> None:
        count = len(self.vectors.entries) + len(self.values.entries)
        if count > MOST_VECTORS_AND_VALUES:
            raise self.reader.error_by_key("vectors_many", self.vectors, count=count, most=MOST_VECTORS_AND_VALUES)

    def _check_names(self) -> None:
        taken = {n: Phrase("a_parameter") for n in self.reader.parameters}
        for table, key, kind in ((self.vectors, "bad_vector", "a_vector"), (self.values, "bad_value_name", "a_value")):
            for name, line in table.lines.items():
                fits = _VECTOR_NAME_REGEX.fullmatch(name) if table is self.vectors else is_parameter_name(name)
                if len(name) > MAX_NAME_LENGTH or not fits:
                    raise self.reader.error_by_key(key, line, name=quoted_excerpt(name), most=MAX_NAME_LENGTH)
                if name in taken:
                    raise self.reader.error_by_key("name_taken", line, name=name, one=taken[name], other=Phrase(kind))
                taken[name] = Phrase(kind)

    def read_statement(self, quantity: str | None) -> Statement:
        vectors = {name: self.read_vector(name, node) for name, node in self.vectors.entries.items()}
        values = {
            name: self.read_vector_amount(node, part_in_words(name, Phrase("section", name="values")))
            for name, node in self.values.entries.items()
        }
        equations = self.read_equations(self.scene.entries["equations"])
        return Statement(
            MappingProxyType(vectors),
            equations,
            MappingProxyType(values),
            self.reader.parameters,
            quantity,
            drive=self.laws.drive if self.laws else None,
        )

    def read_vector_amount(self, node: Node, what: Phrase) -> Amount:
        """A number, an expression of vectors, values and parameters, or a law of the drive."""
        if self.laws and self.laws.changes_with_drive(node):
            return self.laws.read_amount_or_law(node, what)
        if not isinstance(node, SourceScalar) or node.is_blank:
            return self.reader.read_number(node, what)
        try:
            amount = read_amount(node.text, self.reader.parameters, self.names)
        except ExpressionError as error:
            raise self.reader.error_by_key("about", node, what=what, why=error.phrase) from None
        if isinstance(amount, VectorAmount):
            return amount
        if abs(amount) > LARGEST_SCENE_NUMBER:
            raise self.reader.error_by_key("out_of_range", node, what=what, value=amount, most=LARGEST_SCENE_NUMBER)
        return amount

    def read_vector(self, name: str, node: Node) -> VectorGiven:
        what = Phrase("vector", name=name)
        if isinstance(node, SourceScalar) and node.is_blank:
            return VectorGiven()
        vector = Fields(self.reader, node, what, VECTOR_KEYS)
        if {"similar", "ratio", "angle", "as"} & {*vector.table.entries}:
            return VectorGiven(like=self.read_similarity(vector))
        if "direction" in vector and "perpendicular_to" in vector:
            vector.require_one_key("direction", "perpendicular_to")
        value = vector.optional_node("value")
        size = None if value is None else self.read_vector_amount(value, vector.phrase_of_key("value"))
        direction = self.read_vector_direction(vector, "direction", 0)
        if direction is None:
            direction = self.read_vector_direction(vector, "perpendicular_to", 1)
        return VectorGiven(size, direction, vector.number_if_given("near"))

    def read_vector_direction(self, vector: Fields, key: str, quarter: int) -> float | AlongVector | LoadLaw | None:
        """Degrees, the direction of another vector (r_BC, or -r_BC reversed), or a law of the drive."""
        node = vector.optional_node(key)
        if node is not None and quarter == 0 and self.laws and self.laws.changes_with_drive(node):
            law = self.laws.read_amount_or_law(node, vector.phrase_of_key(key))
            return law if isinstance(law, LoadLaw) else float(law)
        name, back = split_reversal_sign(node.text if isinstance(node, SourceScalar) else "")
        if name in self.vectors.entries:
            return AlongVector(name, quarter + 2 * back)
        if (
            node is not None
            and _VECTOR_NAME_REGEX.fullmatch(name)
            and name not in self.reader.parameters
            and name != "pi"
        ):
            self.read_vector_name(node, name, vector.phrase_of_key(key))
        degrees = vector.number_if_given(key)
        return None if degrees is None else degrees + 90.0 * quarter

    def read_vector_name(self, node: Node, name: str, what: Told) -> str:
        """The name of a vector of the scene."""
        if name not in self.vectors.entries:
            valid = list_valid_choices(name, self.vectors.entries)
            name_shown = name if len(name) <= MAX_NAME_LENGTH else quoted_excerpt(name)
            raise self.reader.error_by_key("no_vector", node, text=what, name=name_shown, valid=valid)
        return name

    def read_similarity(self, vector: Fields) -> Similarity:
        """{similar: v_CB, ratio: 0.4, angle: 30} or {similar: v_CB, as: [r_BS, r_BC]}."""
        for key in ("value", "direction", "perpendicular_to", "near"):
            if key in vector:
                raise vector.error_by_key("both_keys", key, what=vector.what, one="similar", two=key)
        pattern = self.read_vector_name(
            vector.required_node("similar"), vector.read_text("similar"), vector.phrase_of_key("similar")
        )
        if vector.require_one_key("ratio", "as") == "ratio":
            ratio = vector.read_number("ratio")
            turn = vector.number_if_given("angle") or 0.0
            return Similarity(
                pattern,
                ratio * complex(evaluate_expression(f"cos({turn!r})", {}), evaluate_expression(f"sin({turn!r})", {})),
            )
        shape = vector.required_node("as")
        label = vector.phrase_of_key("as")
        if "angle" in vector:
            raise vector.error_by_key("both_keys", "angle", what=vector.what, one="as", two="angle")
        items = self.reader.read_list(shape, label)
        if len(items) != 2:
            raise self.reader.error_by_key("similar_pair", shape, what=label, count=len(items))
        one, two = (self.read_vector_name(item, self.reader.read_text(item, label), label) for item in items)
        return Similarity(pattern, shape=(one, two))

    def read_equations(self, node: Node) -> VectorEquations:
        """The equations with their lines."""
        nodes = self.reader.read_list(node, "equations") if isinstance(node, Items | SourceTable) else [node]
        if not nodes:
            raise self.reader.error_by_key("equations_empty", node)
        return tuple(self.read_one_equation(entry, Phrase("equation", number=n)) for n, entry in enumerate(nodes, 1))

    def read_one_equation(self, node: Node, what: Told) -> VectorEquation:
        if isinstance(node, SourceTable):  # under the name of its plan
            (plan, own), *more = node.entries.items() or [("", node)]
            if more or not _FORCE_PLAN_PATTERN.fullmatch(plan):
                raise self.reader.error_by_key("no_such_plan", node, plan=quoted_excerpt(plan))
            return replace(self.read_one_equation(own, what), plan=PlanId.read(plan))
        text = self.reader.read_text(node, what).strip()
        if "=" not in text:
            raise self.reader.error_by_key("not_equation", node, text=quoted_excerpt(text))
        for match in _VECTOR_NAME_REGEX.finditer(text):
            if not _FACTOR_PATTERN.match(text, match.end()) and match[0] not in self.reader.parameters:
                self.read_vector_name(node, match[0], text)
        try:
            equation = read_equation(text, lambda times: evaluate_expression(times, self.reader.parameters), node.line)
        except (EquationError, ExpressionError) as error:
            phrase = error.phrase
            sentence = phrase if isinstance(error, EquationError) else Phrase("about", what=text, why=phrase)
            raise SceneError(sentence, self.reader.file, node.line) from None
        for name in equation.vector_names:  # a parameter in place of a vector
            self.read_vector_name(node, name, text)
        return equation
