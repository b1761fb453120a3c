"""What README and the tour tell a reader to type, typed by a stranger on a machine with only Python; by hand, for it
asks a package index:

    python -m tests.clean_machine FOLDER [--lang ru]

The files of the repository are copied into the folder as a clone would bring them; every command runs in a shell with
nothing set but PATH, an empty HOME and LANG, one after another, README's first. Each is a line of FOLDER/typed-LANG.csv
as soon as it has ended: seconds, exit status, command. Ends with 1 where one did not end with 0.
"""

from __future__ import annotations

import argparse
import csv
import re
import subprocess
import sys
import tarfile
import time
from collections.abc import Iterator
from io import BytesIO
from pathlib import Path

from tests.helpers import ROOT

LANGS = {"en": ("README.md", "en_GB.UTF-8"), "ru": ("README.ru.md", "ru_RU.UTF-8")}
PLACEHOLDER = re.compile(r"\b[A-Z]{4,}\b")  # FOLDER, SCENE: a word for a reader to fill in
DRAWN = "drawing.svg"  # as the site names what a figure's command draws
EXTRAS = ".venv/bin/pip install -q -e '.[all]'"  # the tour begins with it


def of_readme(text: str) -> Iterator[str]:
    """Its first command, that of the extras, and all it says in code thereafter."""
    first = re.search(r"<!-- draw -->\n```sh\n(.*?)\n```", text)
    assert first
    yield from (first[1], EXTRAS)
    for said in re.findall(r"`([^`\n]+)`", re.sub(r"```.*?```", "", text, flags=re.S)):
        if re.match(r"(\.venv/bin/)?planes |\.venv/bin/pip .*&&", said) and not PLACEHOLDER.search(said):
            yield said


def of_tour(text: str) -> Iterator[str]:
    """Its blocks and what it says in code, in the order of the page."""
    for kind, body, said in re.findall(r"^```(\w+).*?\n(.*?)^```|`(planes [^`\n…]+)`", text, re.M | re.S):
        if said:
            yield said
        elif kind == "run":
            yield body.strip()
        elif kind == "figure":
            yield f"planes {body.strip()} -o {DRAWN}"


def commands(lang: str) -> list[str]:
    """All there is to type, each once; a figure again where it is told again, since others of its name came between."""
    readme = (ROOT / LANGS[lang][0]).read_text("utf-8")
    tour = (ROOT / "docs/site" / lang / "tour.md").read_text("utf-8")
    told = [*of_readme(readme), *of_tour(tour)]
    return [one for k, one in enumerate(told) if one not in told[:k] or f"-o {DRAWN}" in one]


def cloned(folder: Path) -> Path:
    """The repository as its last commit has it."""
    packed = subprocess.run(["git", "archive", "HEAD"], cwd=ROOT, capture_output=True, check=True).stdout
    with tarfile.open(fileobj=BytesIO(packed)) as archive:
        archive.extractall(folder / "planes", filter="data")
    (folder / "home").mkdir()
    return folder / "planes"


def typed(command: str, clone: Path, locale: str) -> subprocess.CompletedProcess[str]:
    """A command in a shell of its own; ``planes`` alone is found as one who put the folder into PATH finds it."""
    told = {"PATH": f"{clone}/.venv/bin:/usr/bin:/bin", "HOME": str(clone.parent / "home"), "LANG": locale}
    return subprocess.run(["bash", "-c", command], cwd=clone, env=told, capture_output=True, text=True, check=False)


def run() -> int:
    """Type them all."""
    asked = argparse.ArgumentParser(description=__doc__)
    asked.add_argument("folder", type=Path)
    asked.add_argument("--lang", choices=LANGS, default="en")
    args = asked.parse_args()
    clone, failed = cloned(args.folder.resolve()), 0
    with (args.folder / f"typed-{args.lang}.csv").open("w", encoding="utf-8") as file:
        table = csv.writer(file)
        for command in commands(args.lang):
            begun = time.monotonic()
            done = typed(command, clone, LANGS[args.lang][1])
            table.writerow([f"{time.monotonic() - begun:.1f}", done.returncode, command])
            file.flush()
            if done.returncode:
                failed += 1
                print(f"{command}: {done.returncode}\n{done.stderr[-2000:]}", file=sys.stderr)
    print(f"{failed} of {len(commands(args.lang))} failed")
    return bool(failed)


if __name__ == "__main__":
    sys.exit(run())
