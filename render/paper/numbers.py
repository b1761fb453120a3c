"""Numbers, and the units beside them, as each language writes them."""

from __future__ import annotations

from planes import words
from planes.words import Lang, say
from planes.words.units import quantity


def decimal(text: str, lang: Lang) -> str:
    """A printed number with a true minus and the decimal sign of the language."""
    return words.decimal(text.replace("-", "−"), lang)


def number(value: float | None, lang: Lang, digits: int = 4) -> str:
    """A number for people, a dash for none."""
    return "—" if value is None else decimal(quantity(0.0 if value == 0 else value, "", digits), lang)


def unit(key: str, lang: Lang) -> str:
    """A unit as it stands beside a number; a plain number ("1") has none."""
    return "" if key in ("", "1") else say(key, lang)


def with_unit(name: str, key: str, lang: Lang) -> str:
    """A quantity and its unit, as they stand at the end of an axis."""
    return ", ".join(filter(None, (name, unit(key, lang))))


def scale(mu: float, key: str, lang: Lang) -> str:
    """μ with its unit: 20 mm/(m/s); that of plain numbers in mm."""
    per = unit(key, lang)
    per = f"({per})" if "/" in per else per
    return f"{number(mu, lang)} {say('mm', lang)}{per and f'/{per}'}"
