"""The site: the same pages in both languages, examples that run, a build without warnings, pages that open anywhere."""

from __future__ import annotations

import importlib.util
import os
import re
import shlex
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

import pytest

from planes.cli import main
from tests.helpers import ROOT
from tests.helpers.browser import chromium

SITE = ROOT / "docs" / "site"
PAGES = {lang: {f.name: f.read_text("utf-8") for f in (SITE / lang).glob("*.md")} for lang in ("en", "ru")}
COUNTS = {"measurements.md", "pictures.md"}  # numbers, told once
WHOLE_IN_ENGLISH = {"checking.md", "contributing.md", "json.md"}  # pages that hold a file of the repository


@pytest.fixture(scope="module")
def hooks() -> ModuleType:
    spec = importlib.util.spec_from_file_location("site_hooks", ROOT / "docs" / "site_hooks.py")
    assert spec and spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def commands(text: str) -> Iterator[list[str]]:
    """Commands a page tells a reader to type: in its text and in its blocks."""
    for found in re.findall(r"`planes ([^`]+)`", text):
        yield shlex.split(found.replace("…", ""))
    for kind, body in re.findall(r"^```(figure|run)\b.*?\n(.*?)^```", text, re.M | re.S):
        yield [*shlex.split(body.strip().removeprefix("planes ")), *(["-o", "x.svg"] if kind == "figure" else [])]


def test_both_languages_have_the_same_pages_and_blocks(hooks: ModuleType) -> None:
    assert PAGES["en"].keys() == PAGES["ru"].keys() and len(PAGES["en"]) >= 12
    for name in PAGES["en"].keys() - WHOLE_IN_ENGLISH - COUNTS:
        blocks = [[(kind, body) for kind, _, body in hooks.BLOCK.findall(PAGES[lang][name])] for lang in PAGES]
        assert blocks[0] == blocks[1], name
        heads = [
            len(re.findall(r"^#+ ", re.sub(r"```.*?```", "", PAGES[lang][name], flags=re.S), re.M)) for lang in PAGES
        ]
        assert heads[0] == heads[1], name


@pytest.mark.parametrize("name", sorted(WHOLE_IN_ENGLISH))
def test_a_page_of_its_own_in_russian_is_as_whole(name: str, hooks: ModuleType) -> None:
    """Every name in code, key and option of what the English page takes from the repository is said there too."""
    theirs, own = (hooks.filled(PAGES[lang][name], "en") for lang in ("en", "ru"))
    words = [
        set(
            re.findall(
                r"--?[a-z]+|[\w.]*_[\w.]+|(?:planes|render|tests)/(?!words)[\w/.]+|\w+\.json",
                "".join(re.findall(r"`[^`\n]+`", t)),
            )
        )
        for t in (theirs, own)
    ]
    left = words[0] - words[1]
    assert len(left) < 0.1 * len(words[0]), left
    assert len(own) > 0.7 * len(theirs)


@pytest.mark.parametrize("lang", PAGES)
def test_every_command_can_be_typed(lang: str) -> None:
    every = [words for text in PAGES[lang].values() for words in commands(text)]
    assert len(every) > 25
    for words in every:
        with pytest.raises(SystemExit) as stop:
            main([*words[:1], "--help"])
        assert stop.value.code == 0, words
        assert all((ROOT / word).exists() for word in words if re.match(r"(samples|docs)/", word)), words


@pytest.mark.parametrize("lang", PAGES)
def test_the_python_of_a_page_runs(lang: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    for name, text in PAGES[lang].items():
        blocks = re.findall(r"^```python\n(.*?)^```", text, re.M | re.S)
        assert bool(blocks) == (name == "python.md"), name
        space: dict[str, object] = {}
        for block in blocks:
            exec(block, space)


def test_the_scenes_of_a_page_are_read() -> None:
    from planes import loads

    whole = [
        b for t in PAGES["en"].values() for b in re.findall(r"^```yaml\n(.*?)^```", t, re.M | re.S) if "planes: 1" in b
    ]
    assert whole and all(loads(block) for block in whole)


def test_every_key_of_a_scene_stands_on_its_page(hooks: ModuleType) -> None:
    told = set(re.findall("<!-- keys (.*?) -->", PAGES["en"]["scene.md"]))
    assert all(hooks.with_keys(text, lang) == text for lang, every in PAGES.items() for text in every.values())
    named = {name for block in told for name in block.split()}
    tables = hooks.found(hooks.json_schema("scene", "en"))
    again = {n for n in tables if "_" in n and n.split("_")[0] in tables} - {"crank_slider", "piston_pin"}
    left = tables.keys() - named - again - {"points", "through", "centre", "near", "working", "idle", "moment", "angle"}
    assert left <= {
        "direction",
        "value",
        "force",
        "velocity",
        "acceleration",
        "assembly",
        "crankpin",
        "piston_pin_name",
        "rod_name",
    }, left


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The site, built with warnings as errors, and with no way to the network."""
    out = tmp_path_factory.mktemp("site")
    nowhere = {"http_proxy": "http://127.0.0.1:9", "https_proxy": "http://127.0.0.1:9", "NO_MKDOCS_2_WARNING": "1"}
    words = ["mkdocs", "build", "--quiet", "--strict", "-f", "docs/mkdocs.yml", "-d", str(out)]
    done = subprocess.run(
        [sys.executable, "-m", *words],
        cwd=ROOT,
        env={**os.environ, **nowhere},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr[-3000:]
    return out


@pytest.mark.slow
def test_it_opens_on_a_desk_and_on_a_telephone(built: Path) -> None:
    """No page is wider than its window, every picture is there, nothing is asked of any other place."""
    pages = [f for part in ("", "essay", "ru", "ru/essay") for f in sorted((built / part).glob("*.html"))]
    assert len(pages) >= 44
    with chromium() as browser:
        for size in ({"width": 1280, "height": 900}, {"width": 390, "height": 844}):
            page = browser.new_page(viewport=size)
            asked: list[str] = []
            page.on("request", lambda r, asked=asked: asked.append(r.url))
            for file in pages:
                if file.stem == "404":
                    continue
                page.goto(file.as_uri())
                assert page.evaluate("document.documentElement.scrollWidth <= innerWidth"), file
                lost = "[...document.images].filter(i => i.complete && !i.naturalWidth).length"
                assert page.evaluate(lost) == 0, file
            assert all(url.startswith(("file:", "data:", "blob:")) for url in asked)


@pytest.mark.slow
def test_every_link_of_it_leads_somewhere(built: Path) -> None:
    for file in (f for f in built.rglob("*.html") if f.stem != "404"):
        told = re.sub(
            r"<script\b.*?</script>", "", file.read_text("utf-8"), flags=re.S
        )  # pages of the essay make links
        for address in re.findall(r'(?:href|src)="([^"#]+)(?:#[^"]*)?"', told):
            if not re.match(r"[a-z]+:|//", address):
                assert (file.parent / address.partition("?")[0]).exists(), (file.name, address)


@pytest.mark.parametrize("lang", ["en", "ru"])
def test_a_block_made_by_the_site_has_a_line_for_those_who_read_without_it(lang: str, hooks: ModuleType) -> None:
    for name, text in PAGES[lang].items():
        blocks = re.findall(r"(.*)\n\n```(gallery|include|tables|essay|studio|api)\b", f"\n\n{text}")
        assert len(blocks) == len(re.findall(r"^```(?:gallery|include|tables|essay|studio|api)\b", text, re.M)), name
        for line, kind in blocks:
            assert hooks.PLAIN.match(f"{line}\n\n```"), (name, kind, line)
            for target in re.findall(r"\]\(([^)]*)\)", line):
                assert (hooks.PAGES / lang / target).resolve().exists(), (name, target)
        assert not hooks.PLAIN.search(hooks.PLAIN.sub("", text))
