"""A count that can be interrupted: pictures and their findings are kept in a folder, and not made or read twice.

`pictures/` holds each picture with the data from its maker; a line of `counted.jsonl` is a picture that was read: its
part of the table, the drawing, the findings, and the error of each mark. Without that file all are read again.
"""

from __future__ import annotations

import hashlib
import json
from dataclasses import asdict
from pathlib import Path
from typing import Any

from tests.physical.counting import Tally


class Kept:
    """The folder of a count."""

    def __init__(self, folder: Path) -> None:
        self.pictures, self._file = folder / "pictures", folder / "counted.jsonl"
        self.pictures.mkdir(parents=True, exist_ok=True)
        lines = self._file.read_text("utf-8").splitlines() if self._file.is_file() else []
        self.counted: dict[str, dict[str, Any]] = {row["picture"]: row for row in map(json.loads, lines)}

    def file(self, drawn: str) -> Path:
        """The file of a picture."""
        return self.pictures / f"{hashlib.sha256(drawn.encode()).hexdigest()[:16]}.jpg"

    def told(self, drawn: str) -> dict[str, Any] | None:
        """The data of a picture made before; None if it was not."""
        file = self.file(drawn).with_suffix(".json")
        found: dict[str, Any] | None = json.loads(file.read_text("utf-8")) if file.is_file() else None
        return found

    def tell(self, drawn: str, told: dict[str, Any]) -> None:
        """Saves the data of a picture."""
        self.file(drawn).with_suffix(".json").write_text(json.dumps(told, ensure_ascii=False), "utf-8")

    def tally(self, drawn: str) -> Tally | None:
        """The result for a picture read before."""
        row = self.counted.get(drawn)
        return Tally(**row["tally"]) if row else None

    def add(self, drawn: str, tally: Tally, what: dict[str, Any]) -> None:
        """Records the result for a picture."""
        row = {"picture": drawn, **what, "tally": asdict(tally)}
        self.counted[drawn] = row
        with self._file.open("a", encoding="utf-8") as out:
            out.write(json.dumps(row, ensure_ascii=False) + "\n")
