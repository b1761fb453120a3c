"""The commands for beginners: ``planes new``, ``equations``, ``studio``, ``schema``, ``completion``."""

import json
import os
import re
import sys
from argparse import Namespace
from pathlib import Path

from planes.cli.options import requested_drive_position
from planes.scene.files import is_standard_output, save_file_or_refuse, writing_errors_in_words
from planes.words import Lang, Phrase, fallback_languages, say
from planes.words.errors import PlanesError, list_valid_choices

TEMPLATE_FOLDER = Path(__file__).parents[1] / "templates"
TEMPLATES_BY_GROUP_KIND = {
    "rrr": "four-bar",
    "rrp": "crank-slider",
    "rpr": "slotted-lever",
    "prp": "tangent",
    "rpp": "scotch-yoke",
}
"""The template for each kind of group."""
ISO_SHEET_LINE = "sheet: {frame: iso}                        # or gost: frame and title block of GOST 2.104\n"
_TITLE_PATTERN = re.compile(r"^title: \{ru: (.*), en: (.*)\}$", re.MULTILINE)
_CYRILLIC_PATTERN = re.compile("[а-яё]", re.IGNORECASE)


def template_names() -> list[str]:
    """The names of all templates, those of the kinds of groups first."""
    return [*TEMPLATES_BY_GROUP_KIND, *sorted(file.stem for file in TEMPLATE_FOLDER.glob("*.yaml"))]


def new(args: Namespace) -> int:
    """A template in a file or on the terminal; without a name the list of templates."""
    if args.kind is None:
        print("\n".join(_template_list(args.lang)))
        return 0
    name = TEMPLATES_BY_GROUP_KIND.get(args.kind, args.kind)
    if name not in template_names():
        raise PlanesError(
            Phrase("new_unknown", name=args.kind[:60], valid=list_valid_choices(args.kind, template_names()))
        )
    text = template_in_language((TEMPLATE_FOLDER / f"{name}.yaml").read_text("utf-8"), args.lang)
    if args.output and (args.output.endswith(("/", os.sep)) or Path(args.output).is_dir()):
        args.output = str(Path(args.output) / ("course.yaml" if name == "course" else "scene.yaml"))
    if args.output:
        file = Path(args.output)
        kept = not is_standard_output(file)
        if kept and file.exists():
            raise PlanesError(Phrase("new_there", file=args.output))
        with writing_errors_in_words(args.output):
            file.parent.mkdir(parents=True, exist_ok=True)
        if beside := kept and _write_schema_beside(file, name, args.lang):
            text = f"# yaml-language-server: $schema={beside}\n{text}"
    _write_or_print(text, args.output)
    return 0


def equations(args: Namespace) -> int:
    """A scene of the user's own equations of a mechanism, in a file or on the terminal."""
    from planes.cli.commands import scene_of
    from planes.solving import plans_and_requested_results, solve_position
    from planes.solving.by_equations import scene_text_by_equations

    scene = scene_of(args)
    plans, wanted = plans_and_requested_results(scene)
    value = requested_drive_position(args, scene)
    at = solve_position(scene, plans, wanted, plans.drive.position if value is None else value, None, args.lang)
    _write_or_print(scene_text_by_equations(scene, at), args.output)
    return 0


def template_in_language(template: str, lang: Lang) -> str:
    """A template, whose title and comments are in Russian and English, in the requested language."""
    first = "ru" in fallback_languages(lang)
    others = TEMPLATE_FOLDER / f"{lang}.json"
    lines = []
    own = json.loads(others.read_text("utf-8")) if others.exists() else {}
    for line in _TITLE_PATTERN.sub(lambda m: f"title: {own.get(m[1], m[1]) if first else m[2]}", template).splitlines():
        body, mark, remark = line.rpartition("# ")
        both = remark.split(" / ")
        if body or len(both) == 2 or bool(_CYRILLIC_PATTERN.search(remark)) == first or not mark:
            lines.append(body + mark + (own.get(both[0], both[0]) if first and mark else both[-1]))
    text = "\n".join(lines) + "\n"
    if first:
        return text
    return text.replace("\nsheet: {", "\nsheet: {frame: iso, ") + ISO_SHEET_LINE * ("\nsheet:" not in text)


def _write_schema_beside(file: Path, name: str, lang: Lang) -> str:
    """The name of the schema in the folder of a file, for the help of an editor; it is written if it is missing."""
    kind = "course" if name == "course" else "scene"
    beside = file.with_name(f"{kind}.schema.json")
    if not beside.exists():
        save_file_or_refuse(_schema_text(kind, lang).encode(), beside)
    return beside.name


def _schema_text(kind: str, lang: Lang) -> str:
    from planes.documents.schema import json_schema as schema_of

    return json.dumps(schema_of(kind, lang), ensure_ascii=False, indent=1) + "\n"


def _template_list(lang: Lang) -> list[str]:
    """A line for each template: its name, the kind of its group, its title."""
    kinds = {name: kind for kind, name in TEMPLATES_BY_GROUP_KIND.items()}
    rows = []
    for file in sorted(TEMPLATE_FOLDER.glob("*.yaml")):
        title = template_in_language(file.read_text("utf-8"), lang).splitlines()[1].removeprefix("title: ")
        title = say("course_work", lang) if file.stem == "course" else title
        rows.append(f"{file.stem:15} {kinds.get(file.stem, ''):5} {title}")
    return rows


def studio(args: Namespace) -> int:
    """The studio, in a browser or as files."""
    from planes.scene.source import read_file_text

    first = read_file_text(args.scene) if args.scene else ""
    if args.output:
        from planes.documents.studio import write_studio

        write_studio(args.output, args.lang, args.pyodide or "", args.scenes, first)
        return 0
    try:
        from planes.documents.studio_server import serve
    except ImportError:
        raise PlanesError(Phrase("studio_needs_server")) from None
    serve(args.lang, first, tuple(args.scenes), args.port or 0, not args.no_browser)
    return 0


def schema(args: Namespace) -> int:
    """A JSON Schema in a file or on the terminal."""
    _write_or_print(_schema_text(args.kind, args.lang), args.output)
    return 0


def completion(args: Namespace) -> int:
    """A script that completes commands and options in a shell."""
    from planes.cli import command_line_parser

    try:
        import shtab
    except ImportError:
        raise PlanesError(Phrase("needs_shtab")) from None
    print(shtab.complete(command_line_parser(args.lang), args.shell))
    return 0


def _write_or_print(text: str, output: str | None) -> None:
    if output is None:
        sys.stdout.write(text)
    else:
        save_file_or_refuse(text.encode(), output)
