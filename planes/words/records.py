"""The outer form of answers: what JSON holds."""

from __future__ import annotations

from typing import Any

Json = dict[str, Any]
"""An object of JSON: names to numbers, texts, lists and objects again."""
