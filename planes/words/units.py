"""The scale μ of a plan in both conventions, the standard series, and printing quantities for people.

Inside the program μ is always millimetres on paper per SI unit: m, m/s, m/s², N. On paper it is written either so ("30
mm/(m/s)") or inverted ("0.0333 (m/s)/mm"), in Latin or in Russian letters.
"""

import math
import re
from collections import Counter
from decimal import Decimal
from typing import Literal

from planes.words import Lang, Phrase, say, with_decimal_sign
from planes.words.errors import PlanesError
from planes.words.names import UNIT_OF_PLAN, letter_of, split_value_name

Convention = Literal["mm_per_unit", "unit_per_mm"]

PLANS_WITH_MU = ("position", "velocity", "acceleration", "force")
"""The plans that have a μ; ``read_mu`` also takes "vectors", which is any of them."""

STANDARD_MU_SERIES = (1.0, 2.0, 2.5, 4.0, 5.0)

PLAN_WITH_SAME_UNIT = {"contour": "position", "cremona": "force"}
"""Plans that have the unit of another."""
UNITS_OF_PLACE_AND_RATES = {False: ("rad", "rad/s", "rad/s²"), True: ("m", "m/s", "m/s²")}
"""Units of a link's place and its rates: of one that turns, and of one that slides."""
UNIT_OF_RATE_LETTER = {"v": "m/s", "a": "m/s²", "omega": "rad/s", "epsilon": "rad/s²"}
_UNIT_SIZES_IN_SI = {"m": 1.0, "mm": 0.001, "cm": 0.01, "km": 1000.0, "N": 1.0, "kN": 1000.0, "MN": 1e6}
_LENGTH_UNITS = ("m", "mm", "cm", "km")
_REDUCTIONS_TEXT = "1 2 2.5 4 5 10 15 20 25 40 50 75 100 200 400 500 800 1e3 2e3 5e3 1e4 2e4 2.5e4 5e4"
_STANDARD_REDUCTIONS = tuple(map(float, _REDUCTIONS_TEXT.split()))
_STANDARD_ENLARGEMENTS = (2.0, 2.5, 4.0, 5.0, 10.0, 20.0, 40.0, 50.0)

_UNIT_LETTER_TRANSLATION = str.maketrans("мсНкМ⋅∙*−⁻¹²", "msNkM···--12", "^")
_NUMBER_PATTERN = re.compile(
    r"\s*([-+−]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][-+]?\d+)?|[-+−]?\.?(?:nan|inf)\b)\s*", re.ASCII | re.IGNORECASE
)
_RATIO_PATTERN = re.compile(r"\s*(\d+(?:\.\d*)?)\s*:\s*(\d+(?:\.\d*)?)\s*", re.ASCII)
_UNIT_TOKEN_PATTERN = re.compile(r"(mm|cm|km|kN|MN|m|s|N)(-?\d)?|([·/()])")


_PREFIX_THRESHOLDS = ((1e7, 1e6, "M"), (1e4, 1e3, "k"), (0.1, 1.0, ""), (1e-4, 1e-3, "m"), (1e-300, 1e-6, "µ"))
"""From which largest value on, ISO 80000-1: the factor and its prefix."""


class UnitError(PlanesError, ValueError):
    """A scale or a unit that makes no sense."""


def read_mu(text: str, plan: str) -> float:
    """Read μ of a plan as mm per SI unit, in either convention; ``plan`` "vectors" accepts any unit."""
    return _read_mu_fully(text, plan)[0]


def plan_and_convention_of_mu(text: str) -> tuple[str, Convention]:
    """The plan whose unit μ has, and the convention: "velocity", mm per unit for "30 mm/(m/s)"."""
    return _read_mu_fully(text, "vectors")[1:]


def suitable_unit_multiple(unit: str, most: float) -> tuple[float, str]:
    """The multiple of a unit of force, moment or power for values up to ``most``, and its key: 1000, "kN"."""
    own = (x for x in _PREFIX_THRESHOLDS if most >= x[0] and unit in ("N", "N·m", "W"))
    _, factor, prefix = next(own, (0.0, 1.0, ""))
    return factor, prefix + unit


def allowed_mu_units(plan: str) -> tuple[Phrase, ...]:
    """Words for the units that μ of the plan may have: "mm/m or m/mm"."""
    return tuple(Phrase(f"units_{p}") for p in (PLANS_WITH_MU if plan == "vectors" else (plan,)))


def _read_mu_fully(text: str, plan: str) -> tuple[float, str, Convention]:
    plan = PLAN_WITH_SAME_UNIT.get(plan, plan)
    if plan not in (*PLANS_WITH_MU, "vectors"):
        raise UnitError(Phrase("mu_no_plan", plan=plan, names=PLANS_WITH_MU))
    brief = text if len(text) <= 60 else text[:59] + "…"
    if len(text) <= 60 and plan in ("position", "vectors") and (scale := _RATIO_PATTERN.fullmatch(text)):
        return _checked_mu(1000.0, float(scale[1]), float(scale[2]), brief), "position", "mm_per_unit"
    if len(text) <= 60 and _RATIO_PATTERN.fullmatch(text):
        raise UnitError(Phrase("mu_scale", mu=brief, plan=Phrase(f"scale_{plan}"), units=allowed_mu_units(plan)))
    if len(text) > 60 or not (match := _NUMBER_PATTERN.match(text)):
        raise UnitError(Phrase("mu_not_number", mu=brief, units=allowed_mu_units(plan)))
    number = _read_positive_number(match[1], brief)
    unit = text[match.end() :]
    plan_read, size, inverse = _meaning_of_unit(unit, plan, brief)
    mu = _checked_mu(1.0, 1.0, number * size, brief) if inverse else _checked_mu(1.0, number, size, brief)
    return mu, plan_read, "unit_per_mm" if inverse else "mm_per_unit"


def _read_positive_number(text: str, brief: str) -> float:
    if "," in text:
        raise UnitError(Phrase("mu_comma", mu=brief, number=brief.replace(",", ".")))
    number = float(text.replace("−", "-").lstrip("-+.") if "n" in text.lower() else text.replace("−", "-"))
    if not (math.isfinite(number) and number > 0.0):
        raise UnitError(Phrase("mu_not_positive", mu=brief))
    return number


def _checked_mu(unit: float, above: float, below: float, brief: str) -> float:
    mu = unit * above / below if below else math.inf
    if not (math.isfinite(mu) and mu > 0.0):
        raise UnitError(Phrase("mu_not_positive", mu=brief))
    return mu


def _meaning_of_unit(unit: str, plan: str, brief: str) -> tuple[str, float, bool]:
    if not unit.strip():
        raise UnitError(Phrase("mu_no_unit", mu=brief, units=allowed_mu_units(plan)))
    powers = _base_unit_powers(unit)
    meanings = _meanings_of_units() if powers is not None else {}
    key = frozenset((powers or {}).items())
    wanted = PLANS_WITH_MU if plan == "vectors" else (plan,)
    fits = [(p, *meanings[p, key]) for p in PLANS_WITH_MU if (p, key) in meanings]
    for fit in fits:
        if fit[0] in wanted:
            return fit
    other = Phrase("mu_other", plan=Phrase(f"scale_{fits[0][0]}")) if fits else ""
    raise UnitError(Phrase("mu_unit", mu=brief, unit=unit.strip(), other=other, units=allowed_mu_units(plan)))


_Meanings = dict[tuple[str, frozenset[tuple[str, int]]], tuple[float, bool]]


def _meanings_of_units() -> _Meanings:
    table = _Meanings()
    for plan, time in (("position", 0), ("velocity", 1), ("acceleration", 2), ("force", 0)):
        for name in ("N", "kN", "MN") if plan == "force" else _LENGTH_UNITS:
            direct = Counter({"mm": 1, "s": time})
            direct[name] -= 1
            for inverse, sign in ((False, 1), (True, -1)):
                key = frozenset((k, v * sign) for k, v in direct.items() if v)
                table.setdefault((plan, key), (_UNIT_SIZES_IN_SI[name], inverse))
    return table


def _base_unit_powers(unit: str) -> dict[str, int] | None:
    """Exponents of the base units in a product such as "mm/(m·s-2)"; None if the text is not such a product."""
    text = unit.replace("см", "cm").translate(_UNIT_LETTER_TRANSLATION)
    text = re.sub(r"\s+", "", re.sub(r"(?<=\w)\s+(?=\w)", "·", text.strip()))
    tokens = list(_UNIT_TOKEN_PATTERN.finditer(text))
    if "".join(t[0] for t in tokens) != text:
        return None
    total: Counter[str] = Counter()
    signs = [1]
    sign = 1
    ready = True
    for token in tokens:
        if token[1]:
            if not ready:
                return None
            total[token[1]] += sign * int(token[2] or 1)
            ready = False
        elif token[0] in "·/":
            if ready:
                return None
            sign = -signs[-1] if token[0] == "/" else signs[-1]
            ready = True
        elif token[0] == "(" and ready:
            signs.append(sign)
        elif token[0] == ")" and not ready and len(signs) > 1:
            signs.pop()
        else:
            return None
    if ready or len(signs) > 1:
        return None
    return {k: v for k, v in total.items() if v}


def mu_text(mu: float, plan: str, lang: str = "en", convention: Convention = "mm_per_unit") -> str:
    """μ as written on a sheet: "30 mm/(m/s)", exact; "0.0333 (m/s)/mm", to three digits if necessary."""
    unit = say("one_unit" if plan == "vectors" else UNIT_OF_PLAN[plan], lang)
    return f"{mu_number(mu, convention)} {mu_unit_text(unit, lang, convention != 'mm_per_unit')}"


def mu_number(mu: float, convention: Convention = "mm_per_unit") -> str:
    """The number of such a text."""
    if convention == "mm_per_unit":
        return _exact_number_text(mu)
    value = 1.0 / mu
    short = float(f"{value:.4g}")
    return _exact_number_text(short if math.isclose(short, value, rel_tol=1e-12) else float(f"{value:.3g}"))


def mu_unit_text(unit: str, lang: str, inverse: bool = False) -> str:
    """Millimetres for a unit, or the inverse: mm/(m/s); in Russian with one stroke (ГОСТ 8.417): мм·с/м, м/(с·мм)."""
    mm = say("mm", lang)
    above, _, below = unit.partition("/")
    if below and say("one_stroke", lang):
        if inverse:
            return f"{above}/({below}·{mm})"
        return f"{mm}·{below}/{above}"
    unit = f"({unit})" if below or "·" in unit else unit
    return f"{unit}/{mm}" if inverse else f"{mm}/{unit}"


def _exact_number_text(number: float) -> str:
    text = repr(float(number))
    if 1e-6 <= abs(number) < 1e12:
        text = format(Decimal(text), "f")
    return text.removesuffix(".0")


def standard_mu(largest_si: float, fit_mm: float) -> float:
    """The largest μ of the series 1; 2; 2.5; 4; 5 ·10ⁿ with ``largest_si`` not longer than ``fit_mm``."""
    limit = _largest_fitting_scale(largest_si, fit_mm)
    if limit is None:
        return 1.0
    power = math.floor(math.log10(limit))
    fits = (float(f"{m}e{n}") for n in (power - 1, power, power + 1) for m in STANDARD_MU_SERIES)
    return max(mu for mu in fits if mu <= limit * (1.0 + 1e-12))


def standard_scale(largest_m: float, fit_mm: float) -> float:
    """The largest scale of ГОСТ 2.302 (1:1, 1:2, 2.5:1 ...) that is a round number of mm per m and fits ``fit_mm``."""
    limit = _largest_fitting_scale(largest_m, fit_mm)
    if limit is None:
        return 1000.0
    scales = [1000.0 / n for n in _STANDARD_REDUCTIONS if 10000 % n == 0] + [1000.0 * n for n in _STANDARD_ENLARGEMENTS]
    hundreds = math.floor(limit * (1.0 + 1e-12) / 1e5)
    if hundreds:
        scales.append(1e5 * hundreds)
    fits = [scale for scale in scales if scale <= limit * (1.0 + 1e-12)]
    return max(fits) if fits else standard_mu(largest_m, fit_mm)


def _largest_fitting_scale(largest: float, fit_mm: float) -> float | None:
    if not math.isfinite(largest) or largest == 0.0 or not (math.isfinite(fit_mm) and fit_mm > 0.0):
        return None
    limit = fit_mm / abs(largest)
    return limit if 1e-300 < limit < 1e300 else None


def number_text(value: float | None, lang: Lang, digits: int = 4) -> str:
    """A number as a language writes it, with a true minus; a dash for none."""
    if value is None:
        return "—"
    return with_decimal_sign(significant_digits_text(value, digits).replace("-", "−"), lang)


_UNIT_OF_LETTER = {"m": "kg", "v": "m/s", "omega": "rad/s", "epsilon": "rad/s²", "g": "m/s²"}
_UNIT_OF_LETTER |= dict.fromkeys(("angle", "phi", "alpha", "beta", "gamma", "delta", "psi", "theta"), "°")
_UNIT_OF_LETTER |= dict.fromkeys("JI", "kgm2") | dict.fromkeys("FPQG", "N") | dict.fromkeys("MT", "N·m") | {"q": "N/m"}
_UNIT_OF_LETTER |= dict.fromkeys("lxyrRabcdehHsLDzS", "m")


def unit_of_parameter(name: str) -> str:
    """The key of the unit of a parameter with that name; "" where the name does not show it."""
    letter, index, _ = split_value_name(name)
    if letter == "a" and index[:1].isupper():
        return "m/s²"  # angle of a point; a_1 is a size
    return _UNIT_OF_LETTER.get(letter_of(name), "")


RAISED_DIGITS = "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"
_POWER_OF_TEN_PATTERN = re.compile(f"·10([{RAISED_DIGITS}]+)")


def number_in_tex(number: str) -> str:
    """A number as a language writes it, for a formula (mathtext): "2,5·10⁻³" has a comma without a space, a power."""
    powers = str.maketrans(RAISED_DIGITS, "-0123456789")
    return _POWER_OF_TEN_PATTERN.sub(lambda m: rf"\cdot10^{{{m[1].translate(powers)}}}", number).replace(",", "{,}")


def significant_digits_text(value: float, digits: int = 4) -> str:
    """A number for people: ``digits`` significant ones, no exponent for ordinary magnitudes."""
    if not math.isfinite(value):
        if math.isnan(value):
            return "—"
        if value > 0:
            return "∞"
        return "-∞"
    mantissa, exponent = f"{value:.{max(digits, 1) - 1}e}".split("e")
    power = int(exponent)
    if value == 0.0:
        return "0"
    if -5 < power < 7:
        text = f"{value:.{max(digits - 1 - power, 0)}f}"
        return text.rstrip("0").rstrip(".") if "." in text else text
    raised = str(power).translate(str.maketrans("-0123456789", RAISED_DIGITS))
    mantissa = mantissa.rstrip("0").rstrip(".") if "." in mantissa else mantissa
    return f"{mantissa}·10{raised}"
