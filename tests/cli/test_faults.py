"""What a disk, a signal or a pipe does to a command: the file is whole or as it was, and nothing lies beside it."""

from __future__ import annotations

import os
import signal
import stat
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from planes.batch.cycle import Cycle
from planes.batch.streams import TableHead, open_block_writer
from planes.cli import main
from planes.plans import plans_of
from planes.scene import load
from planes.scene.files import save_bytes, save_file_or_refuse
from planes.scene.ranges import Span
from planes.words.errors import PlanesError
from tests.helpers import ROOT

SAMPLES = ROOT / "samples"
RRR, ENGINE = str(SAMPLES / "kind-1-rrr.yaml"), str(SAMPLES / "crank-slider.yaml")
PLANES = [sys.executable, "-m", "planes"]
MINUTES = 600  # s; a machine may be busy
OLD = b"what was there before"
BIG = [  # commands whose file is larger than what is left on the disk
    (["cycle", RRR, "--phi", "0:360:0.1"], "t.csv"),
    (["cycle", RRR, "--phi", "0:360:0.1"], "t.npy"),
    (["cycle", RRR, "--phi", "0:360:0.1"], "t.npz"),
    (["cycle", RRR], "p.png"),
    (["sheet", RRR], "s.dxf"),
    (["lesson", RRR], "l.html"),
    (["note", RRR], "n.html"),
    (["crank-slider", ENGINE], "r.html"),
]
POSIX = pytest.mark.skipif(os.name != "posix", reason="signals, limits and devices of POSIX")


def run(*argv: str, **how: Any) -> subprocess.CompletedProcess[str]:
    return subprocess.run([*PLANES, *argv], text=True, timeout=MINUTES, check=False, stderr=subprocess.PIPE, **how)


@pytest.fixture(scope="module")
def small_disk(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """A disk of its own with a few kilobytes left."""
    at = tmp_path_factory.mktemp("disk")
    mount = ["mount", "-t", "tmpfs", "-o", "size=300k", "tmpfs", str(at)]
    if os.name != "posix" or os.geteuid() or subprocess.run(mount, capture_output=True, check=False).returncode:
        pytest.skip("a small disk is mounted by root alone")
    try:
        (at / "filler").write_bytes(bytes(280_000))
        yield at
    finally:
        subprocess.run(["umount", str(at)], check=True)


@pytest.mark.few(0, slow=4)
@pytest.mark.parametrize(("argv", "name"), BIG, ids=[name for _, name in BIG])
def test_a_full_disk_is_a_sentence_and_leaves_what_was_there(small_disk: Path, argv: list[str], name: str) -> None:
    target = small_disk / name
    target.write_bytes(OLD)
    done = run(*argv, "-o", str(target), "--lang", "en")
    assert done.returncode == 2 and done.stderr == f"{target} cannot be written: No space left on device\n"
    assert target.read_bytes() == OLD and sorted(p.name for p in small_disk.iterdir()) == ["filler", name]
    target.unlink()


@pytest.mark.few(1)
@POSIX
@pytest.mark.parametrize(("argv", "name"), BIG[:4], ids=[name for _, name in BIG[:4]])
def test_a_limit_of_a_files_size_is_a_sentence(tmp_path: Path, argv: list[str], name: str) -> None:
    target = tmp_path / name
    target.write_bytes(OLD)
    limited = ["sh", "-c", 'ulimit -f 20; exec "$@"', "sh", *PLANES, *argv, "-o", str(target), "--lang", "en"]
    whole = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1"}  # else Python itself leaves half of a compiled module
    done = subprocess.run(limited, capture_output=True, text=True, timeout=MINUTES, check=False, env=whole)
    assert done.returncode == 2 and done.stderr == f"{target} cannot be written: File too large\n"
    assert target.read_bytes() == OLD and [p.name for p in tmp_path.iterdir()] == [name]


def heard() -> None:
    """A run in a shell's background, or under nohup, hears no Ctrl-C and no hang-up, nor do programs it starts."""
    for number in (signal.SIGINT, signal.SIGHUP):
        signal.signal(number, signal.SIG_DFL)


@pytest.mark.few(2)
@POSIX
@pytest.mark.parametrize("name", ["SIGINT", "SIGTERM", "SIGHUP"])
@pytest.mark.parametrize("suffix", ["csv", "npz"])
def test_a_signal_leaves_what_was_there(tmp_path: Path, suffix: str, name: str) -> None:
    target, number = tmp_path / f"t.{suffix}", getattr(signal, name)
    target.write_bytes(OLD)
    argv = [*PLANES, "cycle", RRR, "-o", str(target), "--phi", "0:3600000:0.01"]
    with subprocess.Popen(argv, stderr=subprocess.PIPE, text=True, preexec_fn=heard) as process:
        until(lambda: len(list(tmp_path.iterdir())) > 1)
        process.send_signal(number)
        said = process.communicate(timeout=MINUTES)[1]
    ends = {128 + number, -signal.SIGINT if number == signal.SIGINT else 128 + number}
    assert (
        process.returncode in ends and said == ""
    )  # caught within exec("…"), Python ends by Ctrl-C itself: 130 in a shell
    assert target.read_bytes() == OLD and [p.name for p in tmp_path.iterdir()] == [target.name]


@pytest.mark.slow
@POSIX
def test_a_signal_in_a_course_leaves_whole_files(tmp_path: Path) -> None:
    course, out = tmp_path / "course", tmp_path / "out"
    course.mkdir()
    (course / "scene.yaml").write_bytes((SAMPLES / "assignments/12.yaml").read_bytes())
    (course / "students.txt").write_text("".join(f"Student {k}\n" for k in range(20)), "utf-8")
    (course / "course.yaml").write_text("course: 1\ndocuments: [task]\n", "utf-8")
    argv = [*PLANES, "course", str(course), "-o", str(out), "--jobs", "2"]
    with subprocess.Popen(argv, stderr=subprocess.PIPE, text=True) as process:
        until(lambda: any(out.rglob("task.pdf")))
        process.terminate()
        said = process.communicate(timeout=MINUTES)[1]
    assert (process.returncode, said) == (128 + signal.SIGTERM, "")
    assert {p.name for p in out.iterdir()} == {"students", "teacher", ".journal"}
    assert {p.name for p in out.rglob("*") if p.is_file()} == {"task.pdf", "scene.yaml", "key.json", ".journal"}


@POSIX
def test_nobody_waits_for_a_worker_whose_work_is_not_wanted_any_more() -> None:
    program = (
        "import sys, time\n"
        "from planes.course.workers import start_workers\n"
        "if __name__ == '__main__':\n"
        "    with start_workers(2) as each:\n"
        "        for _ in each(time.sleep, [0.0, 1e5, 1e5]): sys.exit(3)\n"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=MINUTES, check=False)
    assert (done.returncode, done.stdout, done.stderr) == (3, "", "")


def until(true: Any) -> None:
    """Wait for it, for minutes if need be."""
    last = time.monotonic() + MINUTES
    while not true():
        assert time.monotonic() < last
        time.sleep(0.02)


@POSIX
def test_an_interruption_of_the_very_imports_says_nothing() -> None:
    program = (
        "import sys\n"
        "class Pressed:\n"
        "    def find_spec(self, name, *more):\n"
        "        if name == 'planes.cli': raise KeyboardInterrupt\n"
        "sys.meta_path.insert(0, Pressed())\n"
        "from planes.__main__ import run\n"
        "sys.exit(run())\n"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout, done.stderr) == (130, "", "")


@pytest.mark.few(1)
@POSIX
@pytest.mark.parametrize("argv", [["solve", RRR], ["solve", RRR, "--json", "--phi", "0:360:1"], ["structure", RRR]])
def test_an_output_that_takes_nothing_is_a_sentence(argv: list[str]) -> None:
    with open("/dev/full", "w") as full:
        done = run(*argv, "--lang", "en", stdout=full)
    assert done.returncode == 2 and done.stderr == "the output: the system refuses: No space left on device\n"


@pytest.mark.few(1)
@POSIX
@pytest.mark.parametrize("argv", [["solve", RRR], ["solve", RRR, "--json", "--phi", "0:360:1"], ["--help"]])
def test_a_reader_that_has_gone_is_no_fault(argv: list[str]) -> None:
    reading, writing = os.pipe()
    os.close(reading)
    done = run(*argv, stdout=writing)
    os.close(writing)
    assert (done.returncode, done.stderr) == (0, "")


def test_two_tables_of_one_name_are_each_whole(tmp_path: Path) -> None:
    target, cycle = tmp_path / "x.csv", Cycle(plans_of(load(RRR).mechanism, RRR))
    heading = TableHead(("phi", "°"), [(c.name, c.unit) for c in cycle.columns], cycle.reasons)
    with open_block_writer(target, heading, 90) as first:
        with open_block_writer(target, heading, 30) as second:
            for writer, count in ((first, 90), (second, 30)):
                for block in cycle.blocks(Span(0.0, 1.0, count)):
                    writer.write_block(block)
        assert target.read_text("utf-8").count("\n") == 31
    assert target.read_text("utf-8").count("\n") == 91 and list(tmp_path.iterdir()) == [target]


@pytest.mark.slow
def test_the_binary_tables_hold_what_the_text_holds(tmp_path: Path) -> None:
    files = {s: tmp_path / f"t.{s}" for s in ("csv", "npy", "npz")}
    for file in files.values():
        assert main(["cycle", str(SAMPLES / "kind-3-rpr.yaml"), "-o", str(file), "--phi", "0:360:0.05"]) == 0
    records = np.load(files["npy"])
    with np.load(files["npz"]) as held:
        columns = dict(held)
    text = np.genfromtxt(files["csv"], delimiter=",", skip_header=1)
    assert records.shape == (7201,) and [*records.dtype.names, "units", "reasons"] == list(columns)
    for number, name in enumerate(records.dtype.names[:-1]):
        assert np.array_equal(records[name], columns[name], equal_nan=True)
        assert np.array_equal(records[name], text[:, number], equal_nan=True)


def test_a_link_gives_way_to_the_file_and_rights_stay(tmp_path: Path) -> None:
    other, link, own = tmp_path / "other", tmp_path / "link.html", tmp_path / "own.html"
    other.write_bytes(OLD)
    link.symlink_to(other)
    own.write_bytes(OLD)
    own.chmod(0o600)
    for file in (link, own):
        save_bytes(b"new", file)
        assert file.read_bytes() == b"new" and not file.is_symlink()
    assert other.read_bytes() == OLD and stat.S_IMODE(own.stat().st_mode) == 0o600


@pytest.mark.parametrize("name", ["n" * 300, "nowhere/x.csv", ".", "file/x.csv"])
def test_a_name_no_file_can_have_is_refused_before_any_work(tmp_path: Path, name: str) -> None:
    (tmp_path / "file").write_bytes(OLD)
    with pytest.raises(PlanesError, match="cannot be written"):
        save_file_or_refuse(b"", tmp_path / name)
    assert [p.name for p in tmp_path.iterdir()] == ["file"]


@pytest.mark.parametrize(
    "argv",
    [["course", "/dev/null"], ["course", "n" * 300], ["solve", "n" * 300], ["solve", RRR, "--phi", "0:1e300:1e-300"]],
)
def test_a_path_the_system_refuses_is_a_sentence(capsys: pytest.CaptureFixture[str], argv: list[str]) -> None:
    assert main([*argv, "--lang", "en"]) == 2
    out, said = capsys.readouterr()
    assert out == "" and said.count("\n") == 1


@pytest.mark.parametrize("suffix", ["csv", "npy", "npz"])
def test_a_table_of_endless_length_is_refused_with_the_count(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], suffix: str
) -> None:
    target = tmp_path / f"x.{suffix}"
    assert main(["cycle", RRR, "-o", str(target), "--phi", "0:1e9:1e-9", "--lang", "en"]) == 2
    assert "is 1e+18 positions; the most is 1000000000" in capsys.readouterr().err and not list(tmp_path.iterdir())
