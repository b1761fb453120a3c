"""Faults put into the engine by hand: which of them no fast test finds. Run by hand, not by CI.

    python -m tests.mutants --count 200 --minutes 60 --jobs 2

Each mutant changes one place of ``planes/plans`` or ``planes/drafting`` by its syntax tree: a sign, the order of two
arguments, a bound, a term that is dropped. The same seed makes the same mutants. First the fast tests of the rooms that
need no browser are run once, to know which of them pass through each line and how long they take (it needs
``coverage``, which the extra ``ci`` has). Then a mutant is put into a copy of the project, and the tests that pass
through its line are run until one fails, the quickest first, in a process forked from this one, which has the libraries
imported. Where no test passes, it survives untried. What survives is printed, with its line, and in the end how many of
all; it ends with 1 where more than a twentieth did.
"""

from __future__ import annotations

import argparse
import ast
import compileall
import functools
import gc
import importlib
import json
import multiprocessing
import os
import random
import shutil
import sys
import tempfile
import time
from collections import Counter, defaultdict
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from queue import Queue

import pytest

from tests.helpers import ROOT

ROOMS = ("drafting", "plans")
NEAR = (
    "plans",
    "drafting",
    "geometry",
    "solving",
    "batch",
    "scene",
    "lesson",
    "render",
    "accuracy",
    "diagrams",
    "course",
    "cli",
    "check",
    "words",
)
LIBRARIES = ("numpy", "shapely", "hypothesis", "yaml", "fontTools.ttLib", "flint", "mpmath", "matplotlib.font_manager")
FIRST = 40  # tests that are tried before the files of all others are read
LONGER, LEAST_S = 3.0, 30.0  # who takes so many times as long as the tests did, and this beside it, never ends
MOST_SURVIVE = 0.05
SIGNS: dict[type[ast.operator], type[ast.operator]] = {ast.Add: ast.Sub, ast.Sub: ast.Add}
BOUNDS: dict[type[ast.cmpop], type[ast.cmpop]] = {
    ast.Eq: ast.GtE,
    ast.NotEq: ast.Gt,
    ast.Lt: ast.Gt,
    ast.Gt: ast.Lt,
    ast.LtE: ast.Lt,
    ast.GtE: ast.Gt,
}
OTHERS: dict[type[ast.cmpop], type[ast.cmpop]] = {ast.Eq: ast.NotEq, ast.NotEq: ast.Eq}  # of words, which have no order
UNORDERED = ("values", "marks", "directions")  # what a step reads is a set


@dataclass(frozen=True)
class Mutant:
    """One changed place: the text of it before and after, with its place in bytes, and the lines of its statement."""

    path: str
    line: int
    lines: tuple[int, ...]
    kind: str
    start: int
    end: int
    before: str
    after: str

    def __str__(self) -> str:
        return f"{self.path}:{self.line}: {self.kind}: {self.before}  ->  {self.after}"


def changes(node: ast.AST) -> Iterator[tuple[str, ast.expr]]:
    """What can be done to a node that may change a number or a structure."""
    if isinstance(node, ast.BinOp):
        if swapped := SIGNS.get(type(node.op)):
            yield "sign", ast.BinOp(node.left, swapped(), node.right)
        if isinstance(node.op, (ast.Add, ast.Sub, ast.Mult)) and not isinstance(
            node.left, (ast.Constant, ast.JoinedStr)
        ):
            yield "dropped", node.left
    elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        yield "sign", node.operand
    elif isinstance(node, ast.Compare) and len(node.ops) == 1:
        words = any(
            isinstance(one, ast.Constant) and isinstance(one.value, str) for one in (node.left, *node.comparators)
        )
        if other := (OTHERS if words else BOUNDS).get(type(node.ops[0])):
            yield "bound", ast.Compare(node.left, [other()], node.comparators)
    elif isinstance(node, ast.Constant) and isinstance(node.value, float) and 0 < abs(node.value) < 1e-3:
        yield "bound", ast.Constant(node.value * 1e7)
    elif isinstance(node, ast.BoolOp):
        yield "dropped", node.values[0] if len(node.values) == 2 else ast.BoolOp(node.op, node.values[:-1])
    elif isinstance(node, ast.Call) and len(node.args) > 1:
        one, two, *more = node.args
        plain = all(isinstance(a, (ast.Name, ast.Attribute, ast.Subscript)) for a in (one, two))
        if plain and ast.dump(one) != ast.dump(two) and ast.unparse(node.func) not in UNORDERED:
            yield "order", ast.Call(node.func, [two, one, *more], node.keywords)


def mutants(path: Path) -> Iterator[Mutant]:
    """All of a file."""
    text = path.read_bytes()
    starts = [0]
    for line in text.splitlines(keepends=True):
        starts.append(starts[-1] + len(line))
    tree = ast.parse(text)
    lines = lines_of(tree)
    for node in filter(lines.__contains__, ast.walk(tree)):
        for kind, made in changes(node):
            assert isinstance(node, ast.expr) and node.end_lineno and node.end_col_offset is not None
            start, end = starts[node.lineno - 1] + node.col_offset, starts[node.end_lineno - 1] + node.end_col_offset
            after = f"({ast.unparse(ast.fix_missing_locations(made))})"
            before = text[start:end].decode()
            where = str(path.relative_to(ROOT))
            yield Mutant(where, node.lineno, tuple(lines[node]), kind, start, end, before, after)


def lines_of(tree: ast.Module) -> dict[ast.AST, range]:
    """The lines of the statement, or of the head of the block, each node stands in; but what counts from the end, or
    only makes a name."""
    found: dict[ast.AST, range] = {}

    def look(node: ast.AST, lines: range) -> None:
        if isinstance(node, ast.stmt):
            body = getattr(node, "body", None)
            last = body[0].lineno - 1 if body else node.end_lineno
            lines = range(node.lineno, max(last or 0, node.lineno) + 1)
        found[node] = lines
        last = isinstance(node, ast.Subscript) and isinstance(node.slice, ast.UnaryOp)
        inside = [node.value] if last else ast.iter_child_nodes(node)
        for inner in () if isinstance(node, ast.JoinedStr) else inside:
            look(inner, lines)

    look(tree, range(0))
    return found


class Passing:
    """A plugin of pytest that notes which tests pass through each line, and how long each takes.

    What is kept from call to call is forgotten before each test, or only the first would pass.
    """

    def __init__(self) -> None:
        from coverage import Coverage

        self.traced = Coverage(data_file=None, include=[f"planes/{room}/*" for room in ROOMS])
        self.seconds: dict[str, float] = {}
        self.kept: list[functools._lru_cache_wrapper[object]] = []

    def pytest_collection_finish(self) -> None:
        """What is kept by functions of the project."""
        every = [thing for thing in gc.get_objects() if isinstance(thing, functools._lru_cache_wrapper)]
        self.kept = [one for one in every if one.__module__.startswith(("planes.", "tests."))]

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_protocol(self, item: pytest.Item) -> Iterator[None]:
        """One test."""
        for one in self.kept:
            one.cache_clear()
        self.traced.switch_context(item.nodeid)
        begun = time.monotonic()
        result = yield
        self.seconds[item.nodeid] = time.monotonic() - begun
        return result

    def lines(self) -> dict[str, dict[int, list[str]]]:
        """The tests by file and line; "" is what is done when a module is imported."""
        data = self.traced.get_data()
        return {str(Path(f).relative_to(Path.cwd())): data.contexts_by_lineno(f) for f in data.measured_files()}


class Chosen:
    """A plugin of pytest that runs these tests alone, in this order."""

    def __init__(self, tests: Iterable[str]) -> None:
        self.place = {test: k for k, test in enumerate(tests)}

    @pytest.hookimpl(trylast=True)
    def pytest_collection_modifyitems(self, items: list[pytest.Item]) -> None:
        """Those alone."""
        items[:] = sorted((one for one in items if one.nodeid in self.place), key=lambda one: self.place[one.nodeid])


def tested(where: Iterable[str], *plugins: object) -> int:
    """The fast tests in files or folders of the copy one stands in."""
    how = ["-x", "-q", "--tb=no", "-o", "addopts=", "-p", "no:cacheprovider"]
    marks = [
        "-m",
        "not slow and not long and not needs",
        "-W",
        "ignore:Module already imported",
    ]  # hypothesis is a plugin too
    return int(pytest.main([*how, *marks, *where], [*plugins]))


def alone(copy: Path, act: Callable[[], int], longest: float) -> int:
    """What becomes of an act in a process forked from this one that stands in a copy; 1 if it never ends."""

    def begun() -> None:
        os.chdir(copy)
        os.environ["PYTHONPATH"] = sys.path[0] = str(copy)
        for name in [n for n in sys.modules if n.partition(".")[0] in ("planes", "render", "tests")]:
            del sys.modules[name]
        nothing = os.open(os.devnull, os.O_WRONLY)
        for stream in (1, 2):
            os.dup2(nothing, stream)
        os._exit(act())

    child = multiprocessing.get_context("fork").Process(target=begun)
    child.start()
    child.join(longest)
    if child.exitcode is None:
        child.kill()
        child.join()
    return child.exitcode or 0


class Tests:
    """The fast tests of the rooms near by: which pass through each line, the quickest first."""

    def __init__(self, copy: Path) -> None:
        kept = copy / "passing.json"

        def noted() -> int:
            sys.dont_write_bytecode = False  # read by all that come after
            passing = Passing()
            passing.traced.start()
            status = tested([f"tests/{room}" for room in NEAR], passing)
            passing.traced.stop()
            kept.write_text(json.dumps([passing.lines(), passing.seconds]))
            return status

        if alone(copy, noted, 3600):
            raise SystemExit("the tests fail without any mutant")
        lines, self.seconds = json.loads(kept.read_text())
        self.lines = {file: {int(k): tests for k, tests in of.items()} for file, of in lines.items()}

    def through(self, one: Mutant) -> list[str]:
        """The tests that pass through a mutant's lines; through its file, where they are run when it is imported."""
        file = self.lines.get(one.path, {})
        found = {test for line in one.lines for test in file.get(line, ())}
        found = {test for tests in file.values() for test in tests} if "" in found else found
        return sorted(found - {""}, key=lambda test: self.seconds[test])

    def survives(self, one: Mutant, copy: Path) -> bool:
        """Whether no test that passes through it fails."""
        target, kept = copy / one.path, copy / "kept.py"
        shutil.copy2(target, kept)
        text = target.read_bytes()
        target.write_bytes(text[: one.start] + one.after.encode() + text[one.end :])
        every = self.through(one)
        try:
            for some in filter(None, (every[:FIRST], every[FIRST:])):
                files = dict.fromkeys(test.partition("::")[0] for test in some)
                longest = LEAST_S + LONGER * sum(self.seconds[test] for test in some)
                if alone(copy, lambda some=some, files=files: tested(files, Chosen(some)), longest):
                    return False
            return True
        finally:
            shutil.copy2(kept, target)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--minutes", type=float, default=60.0)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--seed", type=int, default=1)
    asked = parser.parse_args()
    every = [m for room in ROOMS for path in sorted((ROOT / "planes" / room).rglob("*.py")) for m in mutants(path)]
    chosen = random.Random(asked.seed).sample(every, min(asked.count, len(every)))
    counts = defaultdict[str, Counter[bool]](Counter)
    for library in LIBRARIES:
        importlib.import_module(library)
    with tempfile.TemporaryDirectory() as folder:
        free: Queue[Path] = Queue()
        for k in range(asked.jobs):
            copy = Path(folder) / str(k)
            shutil.copytree(ROOT, copy, ignore=shutil.ignore_patterns(".*", "__pycache__"))
            compileall.compile_dir(copy, quiet=2)
            free.put(copy)
        sys.dont_write_bytecode = True
        tests = Tests(copy)
        end = time.monotonic() + 60 * asked.minutes

        def tried(one: Mutant) -> bool | None:
            if time.monotonic() > end:
                return None
            copy = free.get()
            try:
                return tests.survives(one, copy)
            finally:
                free.put(copy)

        with ThreadPoolExecutor(asked.jobs) as pool:
            for one, lives in zip(chosen, pool.map(tried, chosen), strict=True):
                if lives is not None:
                    counts[one.kind][lives] += 1
                    print(*["survives:" if lives else "found:", one], flush=True)
    told = [f"{kind} {of[True]} of {of.total()}" for kind, of in sorted(counts.items())]
    run, survived = sum(of.total() for of in counts.values()), sum(of[True] for of in counts.values())
    print(f"mutants: {run} of {len(chosen)} tried ({len(every)} possible), seed {asked.seed}")
    print(f"survived: {survived}, {survived / max(run, 1):.1%}: {', '.join(told)}")
    return int(survived > MOST_SURVIVE * run)


if __name__ == "__main__":
    sys.exit(main())
