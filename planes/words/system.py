"""What the operating system says of a failure, in Russian; and the language it speaks."""

import errno
import json
import locale
import os
from functools import cache
from pathlib import Path
from typing import Literal

RUSSIAN = ("ru", "be", "uk", "kk")


@cache
def _told() -> dict[str, str]:
    """The Russian of each sentence of the system; ``system.json`` has it by the name of the failure."""
    named = json.loads(Path(__file__).with_name("system.json").read_text("utf-8"))
    return {os.strerror(getattr(errno, name)): words for name, words in named.items() if hasattr(errno, name)}


def in_russian(text: str) -> str:
    """The Russian of what the system says; anything else as it is."""
    return _told().get(text, text)


def home_lang() -> Literal["ru", "en"]:
    """Russian where the system speaks Russian, Belarusian, Ukrainian or Kazakh; else English."""
    said = next((os.environ[k] for k in ("LC_ALL", "LC_MESSAGES", "LANG") if os.environ.get(k)), "")
    return "ru" if (said or locale.getlocale()[0] or "").lower().startswith(RUSSIAN) else "en"
