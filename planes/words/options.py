"""The home language: the one the system speaks."""

from __future__ import annotations

import locale
import os

from planes.words import Lang

RUSSIAN = ("ru", "be", "uk", "kk")


def home_lang() -> Lang:
    """Russian where the system speaks Russian, Belarusian, Ukrainian or Kazakh; else English."""
    said = next((os.environ[k] for k in ("LC_ALL", "LC_MESSAGES", "LANG") if os.environ.get(k)), "")
    return "ru" if (said or locale.getlocale()[0] or "").lower().startswith(RUSSIAN) else "en"
