"""The floors of the building: who may import whom, read off the files; and files and functions of readable length."""

from __future__ import annotations

import ast
import subprocess
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest
from counting import PATIENCE_S

ROOT = Path(__file__).parent.parent
LONGEST_FILE = 260
LONGEST_BODY = 25  # lines, of nine functions in ten

STOREYS = (  # a module imports only from the storeys above its own in this list
    "check.fiducials check.sight check.sight.bend check.sight.colours check.sight.rows_across check.strokes "
    "check.svg_shapes cli.options course.fingerprint crank_slider crank_slider.indicator crank_slider.materials "
    "crank_slider.sections crank_slider.words_balance crank_slider.words_forces crank_slider.words_report "
    "crank_slider.words_rod crank_slider.words_strength cycle.tape degrees diagrams diagrams.stages lossless "
    "mechanism naming spreadsheet words.course words.crank_slider words.cycle words.diagrams words.links words.method "
    "words.mistakes words.note words.scene words.sheets words.text words.why working",
    "arithmetic check.arrowheads cycle.fused_functions cycle.reading cycle.slopes cycle.symbols mark_names "
    "words.check words.lesson",
    "cycle.fused_text cycle.twofold plane tools words",
    "cycle.rounding home scene.yaml_faults steps.base thing_names wording",
    "angles check.paper check.read_dxf check.read_svg check.sight.picture course.crowd equations "
    "files instruments scene.expressions scene.source statement steps.crossings steps.reckoning structure units",
    "check.sight.frame check.sight.ink course course.ledger course.scenes cycle.digits lesson.formulas program "
    "scene.reader self_aligning steps",
    "check.nudging check.sight.line_fitting check.sight.symbols_seen course.students crank_slider.reading_table "
    "cycle.tracing drafting drawing scene.links scene.motion scene.settings scene.vectors",
    "check.handwork check.sight.heads check.sight.left_over course.giving cycle.fused diagrams.graphical "
    "lesson.moments plans.assembly plans.bodies scene",
    "check.jointly check.sight.arrow_tips check.sight.prices course.reading crank_slider.shape plans.positions "
    "vectors",
    "check.judging check.sight.drawn_lines crank_slider.given plans.legs",
    "check.sight.places crank_slider.reading_parts plans.kinematics",
    "check.sight.pencil_lines check.sight.ways_of_ink crank_slider.reading plans.loads",
    "plans.friction plans.reactions",
    "plans.lever plans.primary",
    "plans.statics",
    "plans",
    "check.polygons check.slips check.ways cycle.altering cycle.contrast lesson.scheme plans.driven scales",
    "alignment check.mistakes check.mistakes_force check.mistakes_position course.showing crank_slider.engine "
    "cycle.peers diagrams.curves lesson.steps measuring nearest",
    "check.accounts check.bench crank_slider.kinematics cycle.columns lesson solving",
    "check.chains check.scaling check.sight.poles course.numbers crank_slider.forces crank_slider.pages cycle "
    "cycle.explaining lesson.note lesson.practice lesson.zones remedies tables",
    "check check.sight.motion_seen check.sizing course.papers course.settling crank_slider.balance "
    "crank_slider.misprints cycle.bench cycle.claims cycle.spread cycle.streams diagrams.graphical_text "
    "diagrams.turn lesson.data",
    "check.matching check.regrading check.sight.force_ways check.sight.scheme_seen check.verdict course.summary "
    "crank_slider.shaft cycle.limits cycle.long_run cycle.methods diagrams.extremes erring roof.lesson",
    "check.shown check.sight.force_seen check.verdict_rows cli.solve crank_slider.fatigue cycle.stability "
    "diagrams.motion diagrams.summary",
    "check.sight.photograph check.tracing_paper crank_slider.rod diagrams.runs diagrams.text roof.charts survey",
    "check.report cli.survey crank_slider.calculation roof.cycle roof.graphs",
    "cli.cycle crank_slider.pages_balance crank_slider.pages_kinematics crank_slider.pages_rod "
    "crank_slider.pages_shaft roof.check roof.turning",
    "cli.classes crank_slider.numbers crank_slider.pages_forces roof.sheets",
    "cli.check crank_slider.report roof",
    "roof.course roof.crank_slider roof.notebook",
    "roof.conducting",
    "cli.course",
    "cli",
    "__main__",
    "cli.__main__",
)
FLOORS = {f"planes.{name}": floor for floor, names in enumerate(STOREYS) for name in names.split()}
# alone may hand drawings to the renderer
ROOFS = {"planes.cli", *(m for m in FLOORS if m.startswith("planes.documents"))}
READ_BY_RENDER = {  # what drawings are made of, and words: nothing that states or solves mechanics
    f"planes.{name}" for name in (
        "crank_slider.pages", "diagrams.graphical", "diagrams.stages", "drafting", "drawing", "equations", "files",
        "lesson", "lesson.note", "measuring", "mechanism", "naming", "plans", "plans.bodies", "plans.driven", "scales",
        "scene", "self_aligning", "solving", "steps", "steps.reckoning", "structure", "units", "vectors", "wording",
        "words")
}  # fmt: skip


def files(package: str) -> dict[str, Path]:
    """Modules of a package by name."""
    found = sorted(f for f in (ROOT / package).rglob("*.py") if f != ROOT / package / "__init__.py")
    return {".".join(f.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__"): f for f in found}


MODULES = {**files("planes"), **files("render")}


@cache
def tree(path: Path) -> ast.Module:
    return ast.parse(path.read_text(encoding="utf-8"))


@cache
def imports(module: str) -> frozenset[str]:
    """The modules of both packages a module imports anywhere in its file."""
    found: set[str] = set()
    for node in ast.walk(tree(MODULES[module])):
        if isinstance(node, ast.Import):
            found |= {a.name for a in node.names}
        elif isinstance(node, ast.ImportFrom):
            assert not node.level, f"{module}: relative import in line {node.lineno}"
            whole = [f"{node.module}.{a.name}" for a in node.names]
            found |= {name if name in MODULES else node.module or "" for name in whole}
    return frozenset(found & set(MODULES)) - {module}


def functions(path: Path) -> Iterator[tuple[str, int]]:
    """Every function with the number of lines of its body, its docstring aside."""
    for node in ast.walk(tree(path)):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            body = node.body[1:] if ast.get_docstring(node) else node.body
            yield node.name, (body[-1].end_lineno or 0) - body[0].lineno + 1 if body else 0


@pytest.mark.parametrize("module", [m for m in MODULES if m.startswith("planes.")])
def test_a_module_imports_only_from_lower_floors(module: str) -> None:
    below = {m for m in imports(module) if m.startswith("planes.")}
    need = max([FLOORS.get(m, 0) for m in below], default=-1) + 1
    assert module in FLOORS, f"write {module} into STOREYS, in line {need} or below"
    for other in below:
        floor = FLOORS.get(other, len(STOREYS))
        assert floor < FLOORS[module], f"{module} (floor {FLOORS[module]}) imports {other} ({floor})"


def test_no_module_is_listed_that_is_gone() -> None:
    assert set(FLOORS) <= set(MODULES)
    assert len(FLOORS) == sum(len(names.split()) for names in STOREYS)


@pytest.mark.parametrize("module", [m for m in MODULES if m.startswith("planes.") and m not in ROOFS])
def test_planes_never_imports_the_renderer(module: str) -> None:
    assert not [m for m in imports(module) if m.startswith("render.")]
    source = MODULES[module].read_text(encoding="utf-8")
    assert "import render" not in source and "from render" not in source


@pytest.mark.parametrize("module", [m for m in MODULES if m.startswith("render.")])
def test_the_renderer_computes_no_mechanics(module: str) -> None:
    assert {m for m in imports(module) if m.startswith("planes.")} <= READ_BY_RENDER


def test_the_renderer_has_no_circles_of_imports() -> None:
    done: set[str] = set()

    def visit(module: str, way: tuple[str, ...]) -> None:
        assert module not in way, " -> ".join((*way, module))
        if module not in done:
            for other in imports(module):
                visit(other, (*way, module))
            done.add(module)

    for module in MODULES:
        visit(module, ())


def test_the_engine_draws_without_heavy_libraries() -> None:
    """One position needs neither numpy nor shapely nor matplotlib to be imported."""
    program = (
        "import sys\nfrom planes.scene import load\nfrom planes.solving import solve\n"
        "solve(load('samples/six-link.yaml'))\n"
        "print([m for m in ('numpy', 'shapely', 'matplotlib', 'reportlab') if m in sys.modules])\n"
    )
    found = subprocess.run(
        [sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True, timeout=PATIENCE_S, check=True
    )
    assert found.stdout == "[]\n"


@pytest.mark.parametrize("module", MODULES)
def test_a_file_can_be_read_in_one_sitting(module: str) -> None:
    lines = MODULES[module].read_text(encoding="utf-8").count("\n")
    assert lines <= LONGEST_FILE, f"{module} has {lines} lines"


def test_nine_functions_in_ten_are_short() -> None:
    lengths = sorted((n, f"{m}.{name}") for m, path in MODULES.items() for name, n in functions(path))
    assert lengths[int(0.9 * len(lengths))][0] <= LONGEST_BODY
    assert lengths[-1][0] <= 4 * LONGEST_BODY, lengths[-1]


def test_every_module_says_what_it_is() -> None:
    for module, path in MODULES.items():
        assert ast.get_docstring(tree(path)), module


def storeys() -> list[list[str]]:
    """The lowest floor each module could stand on today: ``python tests/test_9_floors.py`` prints STOREYS anew."""
    floor: dict[str, int] = {}

    def stand(module: str) -> int:
        if module not in floor:
            below = [m for m in imports(module) if m.startswith("planes.")]
            floor[module] = 1 + max(map(stand, below), default=-1)
        return floor[module]

    for module in files("planes"):
        stand(module)
    return [sorted(m.removeprefix("planes.") for m in floor if floor[m] == n) for n in range(max(floor.values()) + 1)]


if __name__ == "__main__":
    for names in storeys():
        print(f'    "{" ".join(names)}",')
