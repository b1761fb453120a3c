"""`python -m tests.physical [COUNT] [seed=K] [into=DIR] [FACTOR … | held | FOLDER]`: results for pictures by factor.

COUNT drawings of each factor (8), half of them with a mistake; factors are chosen by words in their names; "held" are
the factors reserved for one count, "held next" those for the count after it. A FOLDER of photographs with their marks
is counted as a separate row. ``into=DIR`` keeps pictures and findings there: the same count, restarted, continues.
"""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

from tests.physical.corpus import of_factor, works
from tests.physical.counting import HEAD, Tally, line
from tests.physical.factors import FACTORS, HELD, HELD_NEXT
from tests.physical.folder import of_folder
from tests.physical.kept import Kept
from tests.physical.setting import Spread


def main(words: list[str]) -> None:
    """Draws, checks, counts and prints, row by row."""
    numbers = [int(w) for w in words if w.isdigit()]
    told = dict(w.split("=", 1) for w in words if w.startswith(("seed=", "into=")))
    names = [w for w in words if not w.isdigit() and not w.startswith(("seed=", "into="))]
    folders = [Path(w) for w in names if Path(w).is_dir()]
    print(line("", HEAD))
    for folder in folders:
        print(line(folder.name, of_folder(folder).row()), flush=True)
    if len(names) > len(folders) or not names:
        chosen = chosen_by([w for w in names if not Path(w).is_dir()])
        with tempfile.TemporaryDirectory() as folder_:
            kept = Kept(Path(told.get("into", folder_)))
            print_factors(chosen, numbers[0] if numbers else 8, int(told.get("seed", "1")), kept)


def print_factors(chosen: Mapping[str, Spread], count: int, seed: int, kept: Kept) -> None:
    """Prints a row for each factor, and one for all; if stopped early (Ctrl+C), for those counted so far."""
    whole, every = Tally(), [*FACTORS, *HELD, *HELD_NEXT]
    with suppress(KeyboardInterrupt):
        for name, spread in chosen.items():
            made = list(works(count, f"{seed} {name}", count * every.index(name)))
            found = of_factor(name, spread, made, seed, kept)
            print(line(name, found.row()), flush=True)
            whole.add(found)
    print(line("all", whole.row()))


def chosen_by(names: list[str]) -> dict[str, Spread]:
    """The factors whose names contain one of the words; without words all except the held ones."""
    if names[:1] == ["held"]:
        return HELD_NEXT if names[1:] == ["next"] else HELD
    return {n: s for n, s in FACTORS.items() if not names or any(w in n for w in names)}


if __name__ == "__main__":
    main(sys.argv[1:])
