"""What the pages of the site are made of beside their text: figures drawn by planes, commands run, tables of keys.

In a page stand, each as a fenced block:

- ``figure CAPTION`` with a command that draws: its picture, lettered in the language of the page, and the command;
- ``run`` with a command: the command and what it prints;
- ``keys`` with names of tables of the scene's schema: their keys and what each means;
- ``gallery`` with a folder of scenes: a picture of each; ``include`` with a file of the repository; ``tables`` with
  a file and, a line each, ``its words = ours``: its tables alone, so that numbers stand in one place;
- ``essay`` with a command that writes live pages into a folder: a list of them.

Figures are drawn before the pages are read, into ``figures/`` beside them; they are never kept in the repository.
"""

from __future__ import annotations

import contextlib
import hashlib
import io
import os
import re
import shlex
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from planes.cli import main
from planes.documents.schema import schema
from planes.scene import load

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent
PAGES = HERE / "site"
BLOCK = re.compile(
    r"^```(figure|run|keys|gallery|include|tables|essay)\b[ ]*(.*?)\n(.*?)^```$", re.MULTILINE | re.DOTALL
)
OUTSIDE = re.compile(r"\[([^\]]*)\]\((?!https?:|#)([^)]*)\)")
DRAWN = "drawing.svg"  # what a reader would name a figure
SAID = {"en": ("key", "what it is"), "ru": ("ключ", "что это")}


def language(page: Path) -> str:
    """The language of a page: its folder."""
    return page.relative_to(PAGES).parts[0]


def pages() -> Iterator[Path]:
    """Every page."""
    yield from sorted(PAGES.glob("*/*.md"))


def named(command: str) -> str:
    """The file of a figure."""
    return f"{hashlib.sha256(command.encode()).hexdigest()[:12]}.svg"


def run(command: str, lang: str, *more: str) -> str:
    """What a command prints; a command that fails stops the build."""
    said = io.StringIO()
    words = [*shlex.split(command), *more, "--lang", lang]
    with contextlib.chdir(ROOT), contextlib.redirect_stdout(said):
        status = main(words)
    if status not in (0, 1):
        raise RuntimeError(f"planes {command}: exit status {status}")
    return said.getvalue()


def draw(command: str, lang: str) -> str:
    """A figure, drawn if it is not there yet; where it lies from a page."""
    file = PAGES / lang / "figures" / named(command)
    file.parent.mkdir(exist_ok=True)
    if not file.exists():
        run(command, lang, "-o", str(file))
    return f"figures/{file.name}"


def gallery(folder: str) -> list[tuple[str, Path]]:
    """The scenes of a folder: what draws each, and its file."""
    files = sorted(f for f in (ROOT / folder).glob("*.yaml") if f.stem != "crank-slider")
    views = {f: "position" if load(f).mechanism else "velocity-plan" for f in files}
    return [(f"sheet {f.relative_to(ROOT).as_posix()} --view {view}", f) for f, view in views.items()]


def figure(caption: str, body: str, lang: str) -> str:
    """A picture with its caption and the command that draws it."""
    below = f"<figcaption>{caption}<br><code>planes {body.strip()} -o {DRAWN}</code></figcaption>"
    return f"<figure markdown>\n![{caption}]({draw(body.strip(), lang)})\n{below}\n</figure>"


def shown(_: str, body: str, lang: str) -> str:
    """A command and what it prints."""
    command = body.strip().removeprefix("planes ")
    return f"```sh\nplanes {command}\n```\n\n```text\n{run(command, lang).rstrip()}\n```"


def keys(_: str, body: str, lang: str) -> str:
    """Keys of a table of the scene, with what each means."""
    told = found(schema("scene", lang), schema("course", lang))
    rows = [f"| `{key}` | {said} |" for name in body.split() for key, said in told[name].items()]
    return "\n".join([f"| {SAID[lang][0]} | {SAID[lang][1]} |", "|---|---|", *rows])


def found(*schemas: dict[str, Any]) -> dict[str, dict[str, str]]:
    """What every key means, by the name of its table: that of the key it stands under, or of who names it."""
    tables: dict[str, dict[str, str]] = {}

    def look(part: Any, name: str) -> None:
        if isinstance(part, list):
            for one in part:
                look(one, name)
        elif isinstance(part, dict):
            own = {k: v for k, v in part.get("properties", {}).items() if "description" in v}
            if own:
                told = {k: v["description"] for k, v in own.items()}
                tables.setdefault(name if name not in tables else f"{name}_{next(iter(own))}", told)
            for key, inner in part.items():
                for inner_name, one in inner.items() if key == "properties" else [(name, inner)]:
                    look(one, inner_name)

    for one in schemas:
        look(one, "course" if "course" in one["required"] else "scene")
    return tables


def pictures(_: str, body: str, lang: str) -> str:
    """A picture of every scene of a folder."""
    cards = []
    for command, file in gallery(body.strip()):
        title = load(file).title[lang]
        below = f"<figcaption>{title}<br><code>{file.name}</code></figcaption>"
        cards.append(f"<figure markdown>\n![{title}]({draw(command, lang)})\n{below}\n</figure>")
    return '<div class="gallery" markdown>\n' + "\n".join(cards) + "\n</div>"


def include(_: str, body: str, lang: str) -> str:
    """A file of the repository; what it links to outside the site stays a name."""
    return OUTSIDE.sub(r"\1 (`\2`)", (ROOT / body.strip()).read_text("utf-8")).replace("`../", "`")


def tables(_: str, body: str, lang: str) -> str:
    """The tables of a file, one after another, in the words of a page."""
    file, *words = body.strip().splitlines()
    found = "\n\n".join(t.strip() for t in re.findall(r"(?:^\|.*\n)+", (ROOT / file).read_text("utf-8"), re.MULTILINE))
    for theirs, own in (line.split(" = ") for line in words):
        if theirs not in found:
            raise RuntimeError(f"{file}: its tables do not say {theirs}")
        found = found.replace(theirs, own)
    return found


def essay(_: str, body: str, lang: str) -> str:
    """A list of the pages of the essay, each by its title."""
    files = sorted(write(body.strip(), lang).glob("*.html"), key=lambda file: int(file.stem))
    titles = (re.findall(r"<title>(.*?)</title>", file.read_text("utf-8"))[0] for file in files)
    return "\n".join(f"1. [{title}](essay/{file.name})" for title, file in zip(titles, files, strict=True))


def write(command: str, lang: str) -> Path:
    """The folder of the essay, written if it is not there yet."""
    folder = PAGES / lang / "essay"
    if not folder.exists():
        run(command, lang, "-o", str(folder))
    return folder


MAKERS: dict[str, Callable[[str, str, str], str]] = {
    "figure": figure,
    "run": shown,
    "keys": keys,
    "gallery": pictures,
    "include": include,
    "tables": tables,
    "essay": essay,
}


def filled(text: str, lang: str) -> str:
    """A page with its blocks made."""
    return BLOCK.sub(lambda block: MAKERS[block[1]](block[2].strip(), block[3], lang), text)


def on_pre_build(config: Any) -> None:
    """Draw every figure, so that the pages find them."""
    os.environ.setdefault("MPLBACKEND", "Agg")
    for page in pages():
        for kind, _, body in BLOCK.findall(page.read_text("utf-8")):
            if kind == "figure":
                draw(body.strip(), language(page))
            elif kind == "essay":
                write(body.strip(), language(page))
            elif kind == "gallery":
                for command, _ in gallery(body.strip()):
                    draw(command, language(page))


def on_page_markdown(markdown: str, page: Any, **_: Any) -> str:
    """The blocks of a page."""
    source = Path(page.file.abs_src_path)
    return filled(markdown, language(source))
