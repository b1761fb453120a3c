"""Tables as text: aligned columns, and the cells of numbers, vectors and their ±."""

import cmath
import math
import re
from collections.abc import Iterable, Sequence

from planes.plans.measuring import plan_name_in_words
from planes.solving import Position
from planes.words import Lang
from planes.words.names import PlanId
from planes.words.naming import Naming
from planes.words.records import Json
from planes.words.units import mu_text, significant_digits_text

ZERO_RESULT_RATIO = 1e-12  # of the largest number of its kind: below this it is zero


_NUMBER_PATTERN = re.compile(r"[-−]?(\d+)(?:([.,])(\d+))?")
RESULT_DIGITS = 4  # significant digits of results


def rows_with_equal_decimals(rows: Iterable[Sequence[str]]) -> list[list[str]]:
    """The rows of a table of results, with equal decimals in each column, as far as the digits are known; 0 and the
    first column are unchanged."""
    columns = [list(column) for column in zip(*rows, strict=True)]
    for column in columns[1:]:
        numbers = {k: m for k, cell in enumerate(column) if (m := _NUMBER_PATTERN.fullmatch(cell))}
        longest = max(numbers.values(), key=lambda m: len(m[3] or ""), default=None)
        for k, m in numbers.items():
            digits = f"{m[1]}{m[3] or ''}".lstrip("0")
            if longest and longest[3] and digits:
                more = min(len(longest[3]) - len(m[3] or ""), RESULT_DIGITS - len(digits))
                column[k] += (longest[2] if more > 0 and not m[3] else "") + "0" * more
    return [list(row) for row in zip(*columns, strict=True)]


def aligned_table(title: str, head: Iterable[str], rows: Iterable[Sequence[str]], even: bool = True) -> list[str]:
    """Aligned columns under a title; empty without rows. ``even`` does not apply to numbers typed by a user."""
    lines = [list(head), *(rows_with_equal_decimals(rows) if even else map(list, rows))]
    if len(lines) == 1:
        return []
    widths = [max(len(row[i]) for row in lines) for i in range(len(lines[0]))]
    text = [
        "  ".join(c.ljust(w) if i == 0 else c.rjust(w) for i, (c, w) in enumerate(zip(row, widths, strict=True)))
        for row in lines
    ]
    return ["", title, *(f"  {line.rstrip()}" for line in text)]


def largest_equilibrium_result(position: Position) -> float:
    """The largest result for bodies in equilibrium, N or N·m, relative to which rounding is zero; 0 for all other
    scenes."""
    measured = [*position.of("values").values(), *position.of("vectors").values()] if position.plans.figure else []
    return max((abs(x) for f in measured for x in f.numbers if x), default=0.0)


def number_cell(value: float | None, beside: float = 0.0) -> str:
    """A number for people; 0 if it vanishes ``beside`` the largest of its kind."""
    if value is None:
        return "—"
    return significant_digits_text(0.0 if abs(value) <= 1e-12 * beside else value)


def magnitude_and_direction_cells(z: complex, beside: float) -> tuple[str, str]:
    if abs(z) <= 1e-12 * beside:
        return "0", "—"
    angle = round(math.degrees(cmath.phase(z)), 2)
    return number_cell(abs(z)), f"{180.0 if angle == -180 else angle + 0.0:.2f}"


def error_cell(errors: Json | None, *path: str) -> list[str]:
    """The cell with a result's ± (of a vector: of its end), or no cell when none was requested."""
    if errors is None:
        return []
    error: object = errors
    for key in path:
        error = error.get(key, {}) if isinstance(error, dict) else {}
    numbers = error if isinstance(error, list) else [error]
    if error == {} or None in numbers:
        return ["" if error == {} else "—"]
    size = math.hypot(*numbers)
    return [f"{size:.1e}" if size else "0"]


def error_column_head(errors: Json | None) -> list[str]:
    """The head of a column of ±, if present."""
    return [] if errors is None else ["±"]


def plan_title_with_scale(p: Position, plan: PlanId, lang: Lang, naming: Naming) -> str:
    """The title of a plan with its μ."""
    mu = mu_text(p.scales[plan.mu_name], plan.kind, lang, naming.convention)
    return f"{plan_name_in_words(plan, lang)}, μ = {mu}"
