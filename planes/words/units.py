"""The scale μ of a plan in both conventions, the standard series, and printing quantities for people.

Inside the program μ is always millimetres on paper per SI unit: m, m/s, m/s², N. On paper it is written either so ("30
mm/(m/s)") or inverted ("0.0333 (m/s)/mm"), in Latin or in Russian letters.
"""

import math
import re
from collections import Counter
from decimal import Decimal
from typing import Literal

from planes.words import Lang, Phrase, decimal, say
from planes.words.errors import PlanesError
from planes.words.names import letter_of, parts_of

Convention = Literal["mm_per_unit", "unit_per_mm"]

PLANS = ("position", "velocity", "acceleration", "force")
"""The plans that have a μ; ``read_mu`` also takes "vectors", which is any of them."""

SERIES = (1.0, 2.0, 2.5, 4.0, 5.0)

UNIT = {"position": "m", "velocity": "m/s", "acceleration": "m/s²", "force": "N"}
UNIT |= {"contour": "m", "vectors": "units", "cremona": "N"}
ALIKE = {"contour": "position", "cremona": "force"}
"""Plans that have the unit of another."""
RATES = {False: ("rad", "rad/s", "rad/s²"), True: ("m", "m/s", "m/s²")}
"""Units of a link's place and its rates: of one that turns, and of one that slides."""
RATE_UNITS = {"v": "m/s", "a": "m/s²", "omega": "rad/s", "epsilon": "rad/s²"}
_SIZES = {"m": 1.0, "mm": 0.001, "cm": 0.01, "km": 1000.0, "N": 1.0, "kN": 1000.0, "MN": 1e6}
_LENGTHS = ("m", "mm", "cm", "km")
_ALLOWED = "1 2 2.5 4 5 10 15 20 25 40 50 75 100 200 400 500 800 1e3 2e3 5e3 1e4 2e4 2.5e4 5e4"
_REDUCED = tuple(map(float, _ALLOWED.split()))
_ENLARGED = (2.0, 2.5, 4.0, 5.0, 10.0, 20.0, 40.0, 50.0)

_LETTERS = str.maketrans("мсНкМ⋅∙*−⁻¹²", "msNkM···--12", "^")
_NUMBER = re.compile(
    r"\s*([-+−]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][-+]?\d+)?|[-+−]?\.?(?:nan|inf)\b)\s*", re.ASCII | re.IGNORECASE
)
_SCALE = re.compile(r"\s*(\d+(?:\.\d*)?)\s*:\s*(\d+(?:\.\d*)?)\s*", re.ASCII)
_TOKEN = re.compile(r"(mm|cm|km|kN|MN|m|s|N)(-?\d)?|([·/()])")


_PREFIXES = ((1e7, 1e6, "M"), (1e4, 1e3, "k"), (0.1, 1.0, ""), (1e-4, 1e-3, "m"), (1e-300, 1e-6, "µ"))
"""From which largest value on, ISO 80000-1: the factor and its prefix."""


class UnitError(PlanesError, ValueError):
    """A scale or a unit that makes no sense."""


def read_mu(text: str, plan: str) -> float:
    """Read μ of a plan as mm per SI unit, in either convention; ``plan`` "vectors" accepts any unit."""
    return _read(text, plan)[0]


def written_in(text: str) -> tuple[str, Convention]:
    """The plan whose unit μ has, and the convention: "velocity", mm per unit for "30 mm/(m/s)"."""
    return _read(text, "vectors")[1:]


def prefixed(unit: str, most: float) -> tuple[float, str]:
    """The multiple of a unit of force, moment or power for values up to ``most``, and its key: 1000, "kN"."""
    own = (x for x in _PREFIXES if most >= x[0] and unit in ("N", "N·m", "W"))
    _, factor, prefix = next(own, (0.0, 1.0, ""))
    return factor, prefix + unit


def fitting_units(plan: str) -> tuple[Phrase, ...]:
    """Words for the units that μ of the plan may have: "mm/m or m/mm"."""
    return tuple(Phrase(f"units_{p}") for p in (PLANS if plan == "vectors" else (plan,)))


def _read(text: str, plan: str) -> tuple[float, str, Convention]:
    plan = ALIKE.get(plan, plan)
    if plan not in (*PLANS, "vectors"):
        raise UnitError(Phrase("mu_no_plan", plan=plan, names=PLANS))
    brief = text if len(text) <= 60 else text[:59] + "…"
    if len(text) <= 60 and plan in ("position", "vectors") and (scale := _SCALE.fullmatch(text)):
        return _checked(1000.0, float(scale[1]), float(scale[2]), brief), "position", "mm_per_unit"
    if len(text) <= 60 and _SCALE.fullmatch(text):
        raise UnitError(Phrase("mu_scale", mu=brief, plan=Phrase(f"scale_{plan}"), units=fitting_units(plan)))
    if len(text) > 60 or not (match := _NUMBER.match(text)):
        raise UnitError(Phrase("mu_not_number", mu=brief, units=fitting_units(plan)))
    number, unit = _number(match[1], brief), text[match.end() :]
    plan_read, size, inverse = _meaning(unit, plan, brief)
    mu = _checked(1.0, 1.0, number * size, brief) if inverse else _checked(1.0, number, size, brief)
    return mu, plan_read, "unit_per_mm" if inverse else "mm_per_unit"


def _number(text: str, brief: str) -> float:
    if "," in text:
        raise UnitError(Phrase("mu_comma", mu=brief, number=brief.replace(",", ".")))
    number = float(text.replace("−", "-").lstrip("-+.") if "n" in text.lower() else text.replace("−", "-"))
    if not (math.isfinite(number) and number > 0.0):
        raise UnitError(Phrase("mu_not_positive", mu=brief))
    return number


def _checked(unit: float, above: float, below: float, brief: str) -> float:
    mu = unit * above / below if below else math.inf
    if not (math.isfinite(mu) and mu > 0.0):
        raise UnitError(Phrase("mu_not_positive", mu=brief))
    return mu


def _meaning(unit: str, plan: str, brief: str) -> tuple[str, float, bool]:
    if not unit.strip():
        raise UnitError(Phrase("mu_no_unit", mu=brief, units=fitting_units(plan)))
    powers = _powers(unit)
    meanings = _meanings() if powers is not None else {}
    key = frozenset((powers or {}).items())
    wanted = PLANS if plan == "vectors" else (plan,)
    fits = [(p, *meanings[p, key]) for p in PLANS if (p, key) in meanings]
    for fit in fits:
        if fit[0] in wanted:
            return fit
    other = Phrase("mu_other", plan=Phrase(f"scale_{fits[0][0]}")) if fits else ""
    raise UnitError(Phrase("mu_unit", mu=brief, unit=unit.strip(), other=other, units=fitting_units(plan)))


_Meanings = dict[tuple[str, frozenset[tuple[str, int]]], tuple[float, bool]]


def _meanings() -> _Meanings:
    table = _Meanings()
    for plan, time in (("position", 0), ("velocity", 1), ("acceleration", 2), ("force", 0)):
        for name in ("N", "kN", "MN") if plan == "force" else _LENGTHS:
            direct = Counter({"mm": 1, "s": time})
            direct[name] -= 1
            for inverse, sign in ((False, 1), (True, -1)):
                key = frozenset((k, v * sign) for k, v in direct.items() if v)
                table.setdefault((plan, key), (_SIZES[name], inverse))
    return table


def _powers(unit: str) -> dict[str, int] | None:
    """Exponents of the base units in a product such as "mm/(m·s-2)"; None if the text is not such a product."""
    text = unit.replace("см", "cm").translate(_LETTERS)
    text = re.sub(r"\s+", "", re.sub(r"(?<=\w)\s+(?=\w)", "·", text.strip()))
    tokens = list(_TOKEN.finditer(text))
    if "".join(t[0] for t in tokens) != text:
        return None
    total: Counter[str] = Counter()
    signs, sign, ready = [1], 1, True
    for token in tokens:
        if token[1]:
            if not ready:
                return None
            total[token[1]] += sign * int(token[2] or 1)
            ready = False
        elif token[0] in "·/":
            if ready:
                return None
            sign, ready = (-signs[-1] if token[0] == "/" else signs[-1]), True
        elif token[0] == "(" and ready:
            signs.append(sign)
        elif token[0] == ")" and not ready and len(signs) > 1:
            signs.pop()
        else:
            return None
    return None if ready or len(signs) > 1 else {k: v for k, v in total.items() if v}


def mu_text(mu: float, plan: str, lang: str = "en", convention: Convention = "mm_per_unit") -> str:
    """μ as written on a sheet: "30 mm/(m/s)", exact; "0.0333 (m/s)/mm", to three digits if necessary."""
    unit = say("one_unit" if plan == "vectors" else UNIT[plan], lang)
    return f"{mu_number(mu, convention)} {mm_per(unit, lang, convention != 'mm_per_unit')}"


def mu_number(mu: float, convention: Convention = "mm_per_unit") -> str:
    """The number of such a text."""
    if convention == "mm_per_unit":
        return _exact(mu)
    value = 1.0 / mu
    short = float(f"{value:.4g}")
    return _exact(short if math.isclose(short, value, rel_tol=1e-12) else float(f"{value:.3g}"))


def mm_per(unit: str, lang: str, inverse: bool = False) -> str:
    """Millimetres for a unit, or the inverse: mm/(m/s); in Russian with one stroke (ГОСТ 8.417): мм·с/м, м/(с·мм)."""
    mm, (above, _, below) = say("mm", lang), unit.partition("/")
    if below and say("one_stroke", lang):
        return f"{above}/({below}·{mm})" if inverse else f"{mm}·{below}/{above}"
    unit = f"({unit})" if below or "·" in unit else unit
    return f"{unit}/{mm}" if inverse else f"{mm}/{unit}"


def _exact(number: float) -> str:
    text = repr(float(number))
    if 1e-6 <= abs(number) < 1e12:
        text = format(Decimal(text), "f")
    return text.removesuffix(".0")


def standard_mu(largest_si: float, fit_mm: float) -> float:
    """The largest μ of the series 1; 2; 2.5; 4; 5 ·10ⁿ with ``largest_si`` not longer than ``fit_mm``."""
    limit = _limit(largest_si, fit_mm)
    if limit is None:
        return 1.0
    power = math.floor(math.log10(limit))
    fits = (float(f"{m}e{n}") for n in (power - 1, power, power + 1) for m in SERIES)
    return max(mu for mu in fits if mu <= limit * (1.0 + 1e-12))


def standard_scale(largest_m: float, fit_mm: float) -> float:
    """The largest scale of ГОСТ 2.302 (1:1, 1:2, 2.5:1 ...) that is a round number of mm per m and fits ``fit_mm``."""
    limit = _limit(largest_m, fit_mm)
    if limit is None:
        return 1000.0
    scales = [1000.0 / n for n in _REDUCED if 10000 % n == 0] + [1000.0 * n for n in _ENLARGED]
    hundreds = math.floor(limit * (1.0 + 1e-12) / 1e5)
    scales += [1e5 * hundreds] if hundreds else []
    fits = [scale for scale in scales if scale <= limit * (1.0 + 1e-12)]
    return max(fits) if fits else standard_mu(largest_m, fit_mm)


def _limit(largest: float, fit_mm: float) -> float | None:
    if not math.isfinite(largest) or largest == 0.0 or not (math.isfinite(fit_mm) and fit_mm > 0.0):
        return None
    limit = fit_mm / abs(largest)
    return limit if 1e-300 < limit < 1e300 else None


def number(value: float | None, lang: Lang, digits: int = 4) -> str:
    """A number as a language writes it, with a true minus; a dash for none."""
    return "—" if value is None else decimal(quantity(value, digits).replace("-", "−"), lang)


_OF_LETTERS = {"m": "kg", "v": "m/s", "omega": "rad/s", "epsilon": "rad/s²", "g": "m/s²"}
_OF_LETTERS |= dict.fromkeys(("angle", "phi", "alpha", "beta", "gamma", "delta", "psi", "theta"), "°")
_OF_LETTERS |= dict.fromkeys("JI", "kgm2") | dict.fromkeys("FPQG", "N") | dict.fromkeys("MT", "N·m") | {"q": "N/m"}
_OF_LETTERS |= dict.fromkeys("lxyrRabcdehHsLDzS", "m")


def unit_of_parameter(name: str) -> str:
    """The key of the unit of a parameter with that name; "" where the name does not show it."""
    letter, index, _ = parts_of(name)
    if letter == "a" and index[:1].isupper():
        return "m/s²"  # angle of a point; a_1 is a size
    return _OF_LETTERS.get(letter_of(name), "")


RAISED = "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"
_POWER = re.compile(f"·10([{RAISED}]+)")


def in_tex(number: str) -> str:
    """A number as a language writes it, for a formula (mathtext): "2,5·10⁻³" has a comma without a space, a power."""
    powers = str.maketrans(RAISED, "-0123456789")
    return _POWER.sub(lambda m: rf"\cdot10^{{{m[1].translate(powers)}}}", number).replace(",", "{,}")


def quantity(value: float, digits: int = 4) -> str:
    """A number for people: ``digits`` significant ones, no exponent for ordinary magnitudes."""
    if not math.isfinite(value):
        return "—" if math.isnan(value) else ("∞" if value > 0 else "-∞")
    mantissa, exponent = f"{value:.{max(digits, 1) - 1}e}".split("e")
    power = int(exponent)
    if value == 0.0:
        return "0"
    if -5 < power < 7:
        text = f"{value:.{max(digits - 1 - power, 0)}f}"
        return text.rstrip("0").rstrip(".") if "." in text else text
    raised = str(power).translate(str.maketrans("-0123456789", RAISED))
    mantissa = mantissa.rstrip("0").rstrip(".") if "." in mantissa else mantissa
    return f"{mantissa}·10{raised}"
