"""What the pages of the site are made of beside their text: figures drawn by planes, commands run, tables of keys.

In a page stand, each as a fenced block:

- ``figure CAPTION`` with a command that draws: its picture, lettered in the language of the page, and the command;
- ``run`` with a command: the command and what it prints;
- ``gallery`` with a folder of scenes: a picture of each, with its file, its lesson and its sheet (``gallery bare``:
  with its file alone);
- ``include`` with a file of the repository (``include below``: under the page's own title);
- ``tables`` with a file and, a line each, ``its words = ours``: its tables alone, so that numbers stand in one place;
- ``studio CAPTION`` with a folder of scenes: the studio with its gallery and those scenes, within the page;
- ``essay`` with a command that writes live pages into a folder: a list of them;
- ``api`` with a package: its public names, each with its signature and docstring.

Above a gallery, an include, tables, an essay, a studio or an api stands a line, ``*In the repository: …*``, that leads
to the same in the repository. The site leaves it out.

Tables of keys stand in the pages themselves, between ``<!-- keys NAMES -->`` and ``<!-- /keys -->``; ``python
docs/site_hooks.py`` writes them from the schema. Figures are drawn before the pages are read, into ``figures/`` beside
them; they are never kept in the repository.
"""

from __future__ import annotations

import contextlib
import hashlib
import inspect
import io
import os
import re
import shlex
import shutil
from collections.abc import Callable, Iterator
from importlib import import_module
from pathlib import Path
from typing import Any

from planes.cli import main
from planes.documents.schema import json_schema
from planes.documents.studio import write_studio
from planes.plans.statements.of_scene import scene_plans
from planes.scene import Scene, load
from render.sheet.single import plan_view_name

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent
PAGES = HERE / "site"
BLOCK = re.compile(
    r"^```(figure|run|gallery|include|tables|essay|studio|api)\b[ ]*(.*?)\n(.*?)^```$", re.MULTILINE | re.DOTALL
)
PLAIN = re.compile(r"^\*(?:In the repository|В репозитории): .*\*\n\n(?=```)", re.MULTILINE)
"""The line above a block for those who read a page where no block is made; the site has the block instead."""
KEYS = re.compile(r"<!-- keys ([^>]*?) -->\n.*?<!-- /keys -->", re.DOTALL)
OUTSIDE = re.compile(r"\[([^\]]*)\]\((?!https?:|#)([^)]*)\)")
DRAWN = "drawing.svg"  # what a reader would name a figure
MADE = "made"  # the folder of lessons, sheets and scenes of the gallery
SAID_OF = {
    "en": {"scene": "scene", "lesson": "lesson", "sheet": "sheet"},
    "ru": {"scene": "сцена", "lesson": "урок", "sheet": "лист"},
}
SAID = {"en": ("key", "meaning"), "ru": ("ключ", "что это")}


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
    command = command.removeprefix("planes ")  # which stands in a page, so that it can be typed as it is read
    file = PAGES / lang / "figures" / named(command)
    file.parent.mkdir(exist_ok=True)
    if not file.exists():
        run(command, lang, "-o", str(file))
    return f"figures/{file.name}"


def gallery(folder: str) -> list[tuple[str, Path]]:
    """The scenes of a folder: what draws each, and its file."""
    files = sorted(f for f in (ROOT / folder).glob("*.yaml") if f.stem != "crank-slider")
    views = {f: first_view(load(f)) for f in files}
    return [(f"sheet {f.relative_to(ROOT).as_posix()} --view {view}", f) for f, view in views.items()]


def first_view(scene: Scene) -> str:
    """The view by which a scene is known: its scheme, or the first plan of stated vectors."""
    return "position" if scene.mechanism else plan_view_name(scene_plans(scene).plan_names[0])


def figure(caption: str, body: str, lang: str) -> str:
    """A picture with its caption and the command that draws it."""
    below = f"<figcaption>{caption}<br><code>{body.strip()} -o {DRAWN}</code></figcaption>"
    return f"<figure markdown>\n![{caption}]({draw(body.strip(), lang)})\n{below}\n</figure>"


def shown(_: str, body: str, lang: str) -> str:
    """A command and what it prints."""
    command = body.strip().removeprefix("planes ")
    return f"```sh\nplanes {command}\n```\n\n```text\n{run(command, lang).rstrip()}\n```"


def with_keys(text: str, lang: str) -> str:
    """A page with its tables of keys as the schema has them; they stand in the page, so that it is read anywhere."""
    told = found(json_schema("scene", lang), json_schema("course", lang))

    def table(match: re.Match[str]) -> str:
        rows = [f"| `{key}` | {said} |" for name in match[1].split() for key, said in told[name].items()]
        head = [f"| {SAID[lang][0]} | {SAID[lang][1]} |", "|---|---|"]
        return "\n".join([f"<!-- keys {match[1]} -->", "", *head, *rows, "", "<!-- /keys -->"])

    return KEYS.sub(table, text)


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


def pictures(how: str, body: str, lang: str) -> str:
    """A picture of every scene of a folder, with what can be opened of it."""
    cards = []
    for command, file in gallery(body.strip()):
        title = load(file).title[lang]
        links = " · ".join(
            f'<a href="{place}">{SAID_OF[lang][key]}</a>' for key, place in made_of(file, lang, how).items()
        )
        below = f"<figcaption>{title}<br>{links}</figcaption>"
        cards.append(f"<figure markdown>\n![{title}]({draw(command, lang)})\n{below}\n</figure>")
    return '<div class="gallery" markdown>\n' + "\n".join(cards) + "\n</div>"


def made_of(file: Path, lang: str, how: str) -> dict[str, str]:
    """What can be opened of a scene, and where it lies from a page: the file, its lesson, its sheet; made once for all
    languages, for a lesson speaks them all."""
    folder = PAGES / "en" / MADE
    folder.mkdir(exist_ok=True)
    name = file.relative_to(ROOT / "samples").with_suffix("").as_posix().replace("/", "-")
    shutil.copy(file, folder / f"{name}.yaml")
    made = {"scene": folder / f"{name}.yaml"}
    if how != "bare":
        made |= {"lesson": folder / f"{name}.html", "sheet": folder / f"{name}.pdf"}
    for command, target in made.items():
        if not target.exists():
            run(f"{command} {file.relative_to(ROOT).as_posix()}", "en", "-o", str(target))
    above = "" if lang == "en" else "../"
    return {key: f"{above}{MADE}/{target.name}" for key, target in made.items()}


def include(how: str, body: str, lang: str) -> str:
    """A file of the repository, ``below`` the title of a page one level lower; links out of the site stay names."""
    text = OUTSIDE.sub(r"\1 (`\2`)", (ROOT / body.strip()).read_text("utf-8")).replace("`../", "`")
    return re.sub(r"^(?=#+ )", "#", text, flags=re.MULTILINE) if how == "below" else text


def api(_: str, body: str, lang: str) -> str:
    """The public names of a package."""
    package = import_module(body.strip())
    return "\n".join(section for name in package.__all__ for section in named_in(name, getattr(package, name), "##"))


def named_in(name: str, thing: Any, level: str) -> Iterator[str]:
    """A public name with its docstring; of a class its public members too."""
    act = getattr(thing, "__wrapped__", thing)
    if isinstance(thing, property):
        yield f"{level} `{name}`\n\n{told_by(thing.fget)}\n"
        return
    try:
        signature = re.sub(r"\bplanes\.[\w.]+\.|collections\.abc\.|pathlib\.|typing\.", "", str(inspect.signature(act)))
    except ValueError:  # an exception's
        signature = ""
    shown = re.sub(r"\bself(, )?|(?<=: )'|(?<=> )'|(?<=\w|\])'(?=[,)\s]|$)", "", f"{name}{signature}")
    yield f"{level} `{name}`\n\n```python\n{shown}\n```\n\n{told_by(act)}\n"
    if inspect.isclass(act):
        for key, member in vars(act).items():
            if (
                not key.startswith("_")
                and (inspect.isfunction(member) or isinstance(member, property))
                and member.__doc__
            ):
                yield from named_in(key, member, level + "#")


def told_by(thing: Any) -> str:
    """A docstring as Markdown: roles and code as code, examples as blocks."""
    text = inspect.getdoc(thing) or ""
    text = re.sub(r":\w+:`~?(?:[\w.]+\.)?(\w+)`", r"`\1`", text).replace("``", "`")
    return re.sub(
        r"(?:^>>> .*\n?(?:^(?!>>>|$).*\n?)*)+", lambda m: f"```pycon\n{m[0].rstrip()}\n```\n", text, flags=re.MULTILINE
    )


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


def studio(caption: str, _: str, lang: str) -> str:
    """The studio in a frame of its own; it stands beside the languages of the site."""
    where = f"{'' if lang == 'en' else '../'}studio/index.html#lang={lang}"
    frame = f'<iframe src="{where}" title="{caption}" style="width:100%;height:44rem;border:0"></iframe>'
    return f"<figure>\n{frame}\n<figcaption>{caption}</figcaption>\n</figure>"


MAKERS: dict[str, Callable[[str, str, str], str]] = {
    "figure": figure,
    "run": shown,
    "gallery": pictures,
    "include": include,
    "tables": tables,
    "essay": essay,
    "studio": studio,
    "api": api,
}


def filled(text: str, lang: str) -> str:
    """A page with its blocks made."""
    return BLOCK.sub(lambda block: MAKERS[block[1]](block[2].strip(), block[3], lang), PLAIN.sub("", text))


def on_pre_build(config: Any) -> None:
    """Draw every figure, so that the pages find them."""
    os.environ.setdefault("MPLBACKEND", "Agg")
    for page in pages():
        for kind, how, body in BLOCK.findall(page.read_text("utf-8")):
            if kind == "figure":
                draw(body.strip(), language(page))
            elif kind == "essay":
                write(body.strip(), language(page))
            elif kind == "gallery":
                for command, file in gallery(body.strip()):
                    draw(command, language(page))
                    made_of(file, language(page), how)


def on_post_build(config: Any) -> None:
    """The studio beside the pages, with the scenes they name; with the engine where PYODIDE says where it is."""
    blocks = (block for page in pages() for block in BLOCK.findall(page.read_text("utf-8")))
    own = [str(ROOT / folder) for folder in sorted({body.strip() for kind, _, body in blocks if kind == "studio"})]
    write_studio(str(Path(config["site_dir"]) / "studio"), "en", os.environ.get("PYODIDE", ""), own)


def on_page_markdown(markdown: str, page: Any, **_: Any) -> str:
    """The blocks of a page."""
    source = Path(page.file.abs_src_path)
    return filled(markdown, language(source))


if __name__ == "__main__":
    for page in pages():
        page.write_text(with_keys(page.read_text("utf-8"), language(page)), "utf-8")
