"""Modules of the pages in one script: in what order, under which names, and what is refused."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from render.page import packer

ALONE = ("lesson", "essay", "check", "trace", "class", "studio", "worker")
PAGES = (*((name,) for name in ALONE), ("lesson", "scorm"), ("lesson", "centres"))
WIDEST = 120


def pack(monkeypatch: pytest.MonkeyPatch, **modules: str) -> str:
    """The script of modules that are given, from the one called main on."""
    packer._declared_names.cache_clear()
    monkeypatch.setattr(packer, "_module_text", modules.__getitem__)
    try:
        return packer.pack_modules("main")
    finally:
        packer._declared_names.cache_clear()


def test_a_module_stands_once_after_those_it_imports(monkeypatch: pytest.MonkeyPatch) -> None:
    """Neither indents nor remarks, imports nor exports are left."""
    found = pack(
        monkeypatch,
        main='import { a } from "./one.js";\nimport {\n  b, c,\n} from "./two.js";\n/** told */\nb(a, c); // so\n',
        one="export const a = [1, 2], z = {\n  y: 3,\n};\n",
        two='// told\nimport { a } from "./one.js";\n'
        "export let c = 1; // so\n/** @type {any} */\n"
        "export function b(x,\n  /** @type {any} */ y) {\n  return x + a;\n}\n",
    )
    assert found == "const a = [1, 2], z = {\ny: 3,\n};\nlet c = 1;\nfunction b(x,\ny) {\nreturn x + a;\n}\nb(a, c);\n"


@pytest.mark.parametrize(
    ("modules", "said"),
    [
        (
            {"main": 'import { a } from "./one.js";\n', "one": 'import { b } from "./main.js";\nexport let a = 1;\n'},
            "modules go round: main → one → main; move what both need to a third",
        ),
        (
            {
                "main": 'import { a } from "./one.js";\nfunction b() {}\n',
                "one": "export let a = 1;\nconst c = [2], b = 3;\n",
            },
            "one.js and main.js both call something b: give one another name",
        ),
        (
            {"main": 'import { a } from "./one.js";\n', "one": "let a = 1;\n"},
            "main.js imports a from one.js, which exports no a",
        ),
    ],
)
def test_what_cannot_be_packed_is_refused_in_a_sentence(
    monkeypatch: pytest.MonkeyPatch, modules: dict[str, str], said: str
) -> None:
    with pytest.raises(ValueError, match=f"^{re.escape(said)}$"):
        pack(monkeypatch, **modules)


def test_every_page_is_packed_and_every_module_is_of_a_page() -> None:
    room = Path(packer.__file__).parent
    texts = {file.stem: file.read_text("utf-8") for file in room.glob("*.js")}
    reached: dict[str, str] = {}
    for entries in PAGES:
        assert not re.search(r"^(import|export) |\btypeof \w+ !== .undefined", packer.pack_modules(*entries), re.M)
        for entry in entries:
            packer._add_module(entry, (), reached)
    assert set(reached) == set(texts)
    assert not [f"{name}.js: {line}" for name, text in texts.items() for line in text.split("\n") if len(line) > WIDEST]
