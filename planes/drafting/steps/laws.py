"""Steps for numbers that a scene gives as laws: evaluated in every position from known quantities."""

from planes.drafting.steps import Reads, Step, values
from planes.drafting.tools import Env, Thing, Tool
from planes.geometry.arithmetic import Real, Truth
from planes.scene.law_expressions import LawParser, fold_angle_into_turn, interpolate_table, is_within_table
from planes.scene.mechanism import LoadLaw
from planes.scene.reader import LARGEST_SCENE_NUMBER
from planes.words.errors import PlanFailure
from planes.words.frozen import field, frozen
from planes.words.lettering import name_in_words
from planes.words.names import NamePair

TABLE_END_SLACK = 1e-9  # of a table's length: dead points are at its ends
TABLE_END_SLACK_BY_HAND = 0.05  # the same in drawings by hand


@frozen
class Follow(Step):
    """The value of a law: ``of`` are the names in its text, each with the value it stands for.

    For a law of one stroke only, the value ``stroke`` times ``sense`` is positive in that stroke; elsewhere the law is
    not evaluated.
    """

    law: LoadLaw
    of: tuple[NamePair, ...]
    stroke: str = ""
    sense: int = 1
    line: str = field(default="", compare=False)  # line of the scene, for whoever has to change the law
    kind = "value"

    def input_names(self) -> Reads:
        return values(*dict.fromkeys([value for _, value in self.of] + [self.stroke]))

    def draw(self, env: Env, tool: Tool) -> Thing:
        idle: Truth = env[self.stroke] * self.sense <= 0 if self.stroke else False
        parser = LawParser(self.law.text, {name: env[value] for name, value in self.of}, tool.ar)
        result = parser.parse_expression()
        table = self.law.table
        ok = parser.ok
        tool.fail_unless(ok | idle, self, "law_no_value")
        if table:
            result = fold_angle_into_turn(table, result, tool.ar) if self.law.turning else result
            inside = is_within_table(table, result, TABLE_END_SLACK_BY_HAND if tool.doubt_mm else TABLE_END_SLACK)
            self._refuse_beyond_table(inside | idle, result, tool)
            result = interpolate_table(table, result, tool.ar)
            ok = ok & inside
        small = abs(result) <= LARGEST_SCENE_NUMBER
        tool.fail_unless(small | idle, self, "law_no_value")
        return tool.ar.where(ok & small, result, 0.0)

    def _refuse_beyond_table(self, inside: Truth, result: Real, tool: Tool) -> None:
        """Fail beyond the table; for one position with the numbers and their signs."""
        if tool.many or inside:
            tool.fail_unless(inside, self, "law_beyond", value=result)
            return
        raise PlanFailure(
            "law_beyond", makes=name_in_words(self.makes), line=self.line, value=float(result), **self.ends
        )

    @property
    def ends(self) -> dict[str, object]:
        """The variable of the table, and its range."""
        table = self.law.table
        if table:
            return {"over": self.law.text, "first": table[0][0], "last": table[-1][0]}
        return {}


@frozen
class ByStroke(Step):
    """One value while a slider goes one way, another while it comes back, zero at rest; ``sense`` is the sign of
    ``stroke`` in the first."""

    stroke: str
    sense: int
    working: str
    idle: str
    kind = "value"
    needs = values("stroke", "working", "idle")

    def draw(self, env: Env, tool: Tool) -> Thing:
        way: Real = env[self.stroke] * self.sense
        return (env[self.working] * (abs(way) + way) + env[self.idle] * (abs(way) - way)) * 0.5
