"""The command ``planes studio``: the studio as files for any web server, with or without the engine for a browser."""

import io
import shutil
import zipfile
from collections.abc import Iterable
from importlib.resources import files
from pathlib import Path

from planes.scene.files import save_file_or_refuse, writing_errors_in_words
from planes.studio.gallery import gallery_entries
from planes.studio.links import text_in_link_letters
from planes.words import Lang, Phrase
from planes.words.errors import PlanesError
from planes.words.records import Json
from render.page.studio_page import answer_message, studio_files
from render.page.web_page import compact_json

RUNTIME_FILES = ("pyodide.mjs", "pyodide.asm.mjs", "pyodide.asm.wasm", "python_stdlib.zip", "pyodide-lock.json")
"""The files of the npm package that a browser requests."""
ENGINE_ROOMS = ("words", "geometry", "scene", "drafting", "plans", "solving", "batch", "lesson", "studio")
"""The rooms that a browser's worker runs, with the grading's catalogue of mistakes."""
ENGINE_EXTRA_PATHS = ("planes/__init__.py", "planes/check/__init__.py", "planes/check/grading", "planes/check/reading")
PAGE_MODULE_FILES = ("__init__.py", "packer.py", "signs.py", "web_page.py", "lesson_page.py", "studio_page.py")
PAPER_MODULE_FILES = ("__init__.py", "letters.py", "marks.py", "style.py", "symbols.py")


def write_studio(folder: str, lang: Lang, runtime: str = "", scenes: Iterable[str] = (), first: str = "") -> None:
    """The studio in a folder: pages, gallery, the lessons of its scenes; with a ``runtime`` (the folder of the npm
    package pyodide, or an address) the engine too."""
    own = Path(runtime)
    local = bool(runtime) and "://" not in runtime
    if local and not (own / RUNTIME_FILES[0]).is_file():
        raise PlanesError(Phrase("studio_no_runtime", folder=runtime))
    address = runtime.rstrip("/") + "/" if runtime and not local else "runtime/"
    way: Json = {"kind": "worker" if runtime else "none", "address": address, "native": False}
    gallery = gallery_entries(scenes)
    parts = studio_files(lang, way, first) | {"gallery.json": _json_bytes(gallery)}
    for one in gallery:
        answer = answer_message({"ask": "lesson", "all": True, "text": one["text"], "lang": lang})
        if "data" in answer:
            parts[f"lessons/{one['name']}.txt"] = text_in_link_letters(compact_json(answer)).encode()
    if runtime:
        parts["planes.zip"] = engine_archive()
    with writing_errors_in_words(folder):
        (Path(folder) / "lessons").mkdir(parents=True, exist_ok=True)
        if local:
            (Path(folder) / "runtime").mkdir(exist_ok=True)
            for name in RUNTIME_FILES:
                shutil.copyfile(own / name, Path(folder) / "runtime" / name)
    for name, data in parts.items():
        save_file_or_refuse(data, Path(folder) / name)


def engine_archive() -> bytes:
    """The packages for a worker, unchanged, in one archive; the only foreign one is PyYAML in pure Python."""
    planes, render, own = (Path(str(files(name))) for name in ("planes", "render", "yaml"))
    parts = (
        [planes / room for room in ENGINE_ROOMS]
        + [planes.parent / name for name in ENGINE_EXTRA_PATHS]
        + [render / "__init__.py"]
    )
    parts += [render / "page" / name for name in PAGE_MODULE_FILES] + [
        render / "paper" / name for name in PAPER_MODULE_FILES
    ]
    held = io.BytesIO()
    with zipfile.ZipFile(held, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for part in (*parts, own):
            for path in sorted(part.rglob("*")) if part.is_dir() else [part]:
                if path.suffix in (".py", ".json") and "__pycache__" not in path.parts:
                    root = own.parent if part == own else planes.parent
                    entry = zipfile.ZipInfo(path.relative_to(root).as_posix(), (2000, 1, 1, 0, 0, 0))
                    entry.compress_type = zipfile.ZIP_DEFLATED
                    archive.writestr(entry, path.read_bytes())
    return held.getvalue()


def _json_bytes(thing: object) -> bytes:
    return compact_json(thing).encode()
