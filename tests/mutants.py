"""Faults put into the engine by hand: which of them no fast test finds. Run by hand, not by CI.

    python -m tests.mutants --count 200 --minutes 60 --jobs 2

Each mutant changes one place of ``planes/plans`` or ``planes/drafting`` by its syntax tree: a sign, the order of two
arguments, a bound, a term that is dropped. It is put into a copy of the project, and the fast tests of the rooms near
it are run until one fails. The same seed makes the same mutants. What survives is printed, with its line; it ends
with 1 where more than a twentieth did.
"""

from __future__ import annotations

import argparse
import ast
import random
import shutil
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from queue import Queue

from tests.helpers import ROOT

ROOMS = ("drafting", "plans")
NEAREST = {
    "drafting": ("drafting", "plans", "geometry", "batch", "solving"),
    "plans": ("plans", "drafting", "solving", "batch", "geometry"),
}
LONGEST = 600  # s of the tests of one mutant: who never ends is found out
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


@dataclass(frozen=True)
class Mutant:
    """One changed place: the text of it before and after, with its place in bytes."""

    path: str
    line: int
    kind: str
    start: int
    end: int
    before: str
    after: str

    def __str__(self) -> str:
        return f"{self.path}:{self.line}: {self.kind}: {self.before}  ->  {self.after}"


def changes(node: ast.AST) -> Iterator[tuple[str, ast.expr]]:
    """What can be done to a node."""
    if isinstance(node, ast.BinOp):
        if swapped := SIGNS.get(type(node.op)):
            yield "sign", ast.BinOp(node.left, swapped(), node.right)
        if isinstance(node.op, (ast.Add, ast.Sub, ast.Mult)) and not isinstance(
            node.left, (ast.Constant, ast.JoinedStr)
        ):
            yield "dropped", node.left
    elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        yield "sign", node.operand
    elif isinstance(node, ast.Compare) and len(node.ops) == 1 and (other := BOUNDS.get(type(node.ops[0]))):
        yield "bound", ast.Compare(node.left, [other()], node.comparators)
    elif isinstance(node, ast.Constant) and isinstance(node.value, float) and 0 < abs(node.value) < 1e-3:
        yield "bound", ast.Constant(node.value * 1e7)
    elif isinstance(node, ast.BoolOp):
        yield "dropped", node.values[0] if len(node.values) == 2 else ast.BoolOp(node.op, node.values[:-1])
    elif isinstance(node, ast.Call) and len(node.args) > 1:
        one, two, *more = node.args
        plain = all(isinstance(a, (ast.Name, ast.Attribute, ast.Subscript)) for a in (one, two))
        if plain and ast.dump(one) != ast.dump(two):
            yield "order", ast.Call(node.func, [two, one, *more], node.keywords)


def mutants(path: Path) -> Iterator[Mutant]:
    """All of a file."""
    text = path.read_bytes()
    starts = [0]
    for line in text.splitlines(keepends=True):
        starts.append(starts[-1] + len(line))
    for node in ast.walk(ast.parse(text)):
        for kind, made in changes(node):
            assert isinstance(node, ast.expr) and node.end_lineno and node.end_col_offset is not None
            start, end = starts[node.lineno - 1] + node.col_offset, starts[node.end_lineno - 1] + node.end_col_offset
            after = f"({ast.unparse(ast.fix_missing_locations(made))})"
            before = text[start:end].decode()
            yield Mutant(str(path.relative_to(ROOT)), node.lineno, kind, start, end, before, after)


def survives(one: Mutant, copy: Path) -> bool:
    """Whether no fast test of the rooms near it fails."""
    target, original = copy / one.path, (ROOT / one.path).read_bytes()
    target.write_bytes(original[: one.start] + one.after.encode() + original[one.end :])
    rooms = [f"tests/{room}" for room in NEAREST[Path(one.path).parts[1]]]
    command = [sys.executable, "-m", "pytest", "-x", "-q", "-n", "0", "-p", "no:cacheprovider", *rooms]
    try:
        done = subprocess.run(command, cwd=copy, capture_output=True, timeout=LONGEST, check=False)
    except subprocess.TimeoutExpired:
        return False
    finally:
        target.write_bytes(original)
    return done.returncode == 0


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--minutes", type=float, default=60.0)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--seed", type=int, default=1)
    asked = parser.parse_args()
    every = [m for room in ROOMS for path in sorted((ROOT / "planes" / room).rglob("*.py")) for m in mutants(path)]
    chosen = random.Random(asked.seed).sample(every, min(asked.count, len(every)))
    end, counts = time.monotonic() + 60 * asked.minutes, Counter[str]()
    with tempfile.TemporaryDirectory() as folder:
        free: Queue[Path] = Queue()
        for k in range(asked.jobs):
            copy = Path(folder) / str(k)
            shutil.copytree(ROOT, copy, ignore=shutil.ignore_patterns(".*", "__pycache__"))
            free.put(copy)

        def tried(one: Mutant) -> bool | None:
            if time.monotonic() > end:
                return None
            copy = free.get()
            try:
                return survives(one, copy)
            finally:
                free.put(copy)

        with ThreadPoolExecutor(asked.jobs) as pool:
            for one, lives in zip(chosen, pool.map(tried, chosen), strict=True):
                if lives is not None:
                    counts[one.kind] += 1
                    counts["survived"] += lives
                    print(*["survives:" if lives else "found:", one], flush=True)
    run = sum(counts.values()) - counts["survived"]
    print(
        f"mutants: {run} of {len(chosen)} ({len(every)} possible) tried, {counts['survived']} survived; {dict(counts)}"
    )
    return int(counts["survived"] > MOST_SURVIVE * run)


if __name__ == "__main__":
    sys.exit(main())
