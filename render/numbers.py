"""Numbers as each language writes them."""

from __future__ import annotations

from planes.units import quantity
from planes.words import Lang


def decimal(text: str, lang: Lang) -> str:
    """A printed number with a true minus and the decimal sign of the language."""
    text = text.replace("-", "−")
    return text.replace(".", ",") if lang == "ru" else text


def number(value: float | None, lang: Lang, digits: int = 4) -> str:
    """A number for people, a dash for none."""
    return "—" if value is None else decimal(quantity(0.0 if value == 0 else value, "", digits), lang)
