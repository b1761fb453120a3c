"""Names and titles that mean something to a browser: in every page they are letters, and the page does its work."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest

from planes.check.grading.paper import read_table
from planes.check.grading.prepared_plan import Asked
from planes.check.outcome import check
from planes.check.report import page_data
from planes.check.report.class_rows import WRONG_RANK, ClassRow
from planes.check.report.shown import tracing_data
from planes.cli import main
from planes.lesson.data import lesson_data
from planes.scene import load
from planes.solving import document
from planes.words.naming import Naming
from render.page import check_pages, lesson_page, web_page
from render.report import render_document
from tests.helpers import ROOT

SAMPLES = ROOT / "samples"
SIX = SAMPLES / "six-link.yaml"
RUN = "window.XSS=1"
NAMES = [
    f"{{data}}<img src=x onerror={RUN}>",
    "{title}{words}{css}{js}{nobody}{0}{",
    "<!--<script>",
    "--><!-->",
    f"</script><script>{RUN}</script>",
    f"</title></style><script>{RUN}</script>",
    f"]]><script>{RUN}</script>",
    f'"><svg onload={RUN}>',
    f"' onmouseover='{RUN}",
    f'" autofocus onfocus="{RUN}',
    f"<svg/onload={RUN}><style>",
    "<base href=//localhost/><link rel=stylesheet href=//localhost/x>",
    "<meta http-equiv=refresh content=0;url=x>",
    f"<iframe srcdoc='<script>parent.XSS=1</script>'><object data=x><embed src=x>{RUN}",
    "<style>*{display:none}",
    f"&lt;script&gt;{RUN}&lt;/script&gt;",
    f"\\u003cscript>{RUN}\\u003c/script>",
    "a\u2028b\u2029c",
    "$& $1 $` $' \\1",
    f"javascript:{RUN}",
    "%s %(x)s {!r} ${x} `x`",
    "<plaintext>",
    "<textarea><noscript><template>",
    "⟨<b>⟩_{<b>}^{<i>}",
]
ALIVE = {  # what the page's own script has made
    "lesson": "document.querySelectorAll('#scheme *, #plan *').length > 9 && !!$('number').textContent",
    "trace": "document.querySelectorAll('#sheet *').length > 9",
    "report": "document.querySelectorAll('#sheet *').length > 9 && document.querySelectorAll('#marks tr').length > 2",
    "class": "document.querySelector('thead button').click(), !!document.querySelector('th[aria-sort]')",
}


def handed_in(folder: Path, result: str) -> Path:
    """A drawing told as a table; one of its results has a name of somebody's own."""
    file = folder / "drawing.csv"
    quoted = result.replace('"', '""')
    file.write_text(f'mark,x_mm,y_mm\np,0,0\nb,30,51.96\nc,20,8\n\nresult,value,unit\n"{quoted}",1,m/s\n', "utf-8")
    return file


@pytest.fixture(scope="module")
def told(tmp_path_factory: pytest.TempPathFactory) -> dict[str, dict[str, Any]]:
    """What the pages with a script show, once for all names."""
    asked = Asked(load(SIX), "velocity")
    found = check(asked, read_table(handed_in(tmp_path_factory.mktemp("told"), "v_C")))
    return {"lesson": lesson_data(asked.scene), "trace": tracing_data(asked, "en"), "report": page_data(found, "en")}


def pages(told: dict[str, dict[str, Any]], name: str) -> dict[str, str]:
    """Every kind of page, the name in every place that takes any text."""
    checked = {
        **told["report"],
        "title": name,
        "sentence": name,
        "notes": [name],
        "command": name,
        "numbers": [["right", name, name, name, name]],
    }
    table = document.DocumentTable(name, ((name,), (name,)))
    vectors = {key: [[0, 0, 5, 5]] for key in ("own", "true", "next", "strokes")}
    place = {"name": name, "box": [0, 0, 9, 9], "at": [1, 1], "picture": "", "lines": False, **vectors}
    blocks = [
        document.Heading(name, 0),
        *(document.Heading(name, k) for k in (1, 2)),
        table,
        document.Paragraph(name, name),
        document.Paragraph(name, mistake=True),
        document.Formula(("x",), name),
        document.Figure(document.Chart("x", "y", (document.PlottedLine([0, 1], [0, 1]),)), name),
    ]
    return {
        "lesson": lesson_page.whole_lesson_page({**told["lesson"], "title": {"ru": name, "en": name}}, "en"),
        "trace": check_pages.tracing_page({**told["trace"], "title": name, "command": name}, "en"),
        "report": check_pages.report_page(checked, "en"),
        "class": check_pages.class_page(
            name,
            [(name, 1)],
            [(name, [(name, name)])],
            name,
            [name, name],
            [(ClassRow(name, "wrong", WRONG_RANK, link=name, places=[place]), [name, name])],
            "en",
        ),
        "note": render_document(blocks, ".html", Naming("en")).decode(),
    }


def visit(browser: Any, file: Path, kind: str) -> tuple[list[str], str]:
    """What is wrong with a page, and its title within it."""
    page, wrong = browser.new_page(), list[str]()
    page.on("console", lambda m: wrong.append(m.text) if m.type in ("error", "warning") else None)
    page.on("pageerror", lambda e: wrong.append(str(e)))
    page.on("request", lambda r: wrong.append(r.url) if r.url.startswith(("http", "file")) else None)
    page.goto(file.as_uri())
    page.mouse.move(60, 40)
    wrong.remove(file.as_uri())
    if page.evaluate("window.XSS !== undefined"):
        wrong.append("a script of the name has run")
    if not page.evaluate(ALIVE.get(kind, "true")):
        wrong.append("the page's own script has not done its work")
    if len(page.inner_text("body")) < 3:
        wrong.append("the page is blank")
    title = page.evaluate("document.querySelector('h1').textContent")
    page.close()
    return wrong, title


@pytest.mark.few(0, slow=4)
@pytest.mark.parametrize("name", NAMES)
def test_a_hostile_name_is_letters_in_every_page(
    browser: Any, told: dict[str, dict[str, Any]], tmp_path: Path, name: str
) -> None:
    for kind, text in pages(told, name).items():
        file = tmp_path / f"{kind}.html"
        file.write_text(text, encoding="utf-8")
        wrong, title = visit(browser, file, kind)
        assert (wrong, title) == ([], name), kind


def test_every_page_says_what_a_browser_may_do_with_it(told: dict[str, dict[str, Any]]) -> None:
    """One shell for all: no other file writes a page's head, and no data holds a letter that HTML reads."""
    room = Path(web_page.__file__).parent
    writers = [f.name for f in room.rglob("*.*") if f.suffix in (".py", ".html") and "<html" in f.read_text("utf-8")]
    assert writers == ["shell.html"]
    for text in pages(told, "<!--<script>\u2028").values():
        head = text.partition("<style>")[0]
        assert "default-src 'none'" in head and "'unsafe-eval'" not in text and "script-src 'unsafe" not in text
        for held in re.findall(r'<script type="application/json" id="\w+">(.*?)</script>', text, re.S):
            assert not set(held) & set("<>&\u2028\u2029")


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """Pages as the commands write them, of a scene, drawings, students and a course with hostile names."""
    at = tmp_path_factory.mktemp("written")
    name = "{data}<img src=x onerror=window.XSS=1><!--<script>"
    texts = {"scene": SIX, "engine": SAMPLES / "crank-slider.yaml", "task": SAMPLES / "assignments/12.yaml"}
    scenes = {k: at / f"{k}{name}.yaml" for k in texts}
    for key, path in texts.items():
        text = re.sub(r"(?m)^title:.*\n(  .*\n)*", f"title: '{name}'\n", path.read_text("utf-8"), count=1)
        assert name in text
        scenes[key].write_text(text, "utf-8")
    scene, engine = str(scenes["scene"]), str(scenes["engine"])
    drawings, course = at / "drawings", at / "course"
    drawings.mkdir()
    handed_in(drawings, name).rename(drawings / f"{name}.csv")
    course.mkdir()
    scenes["task"].rename(course / "scene.yaml")
    (course / "students.csv").write_text(f"name,group\n{name},{name}\n=1+1,@SUM(1)\n", "utf-8")
    (course / "course.yaml").write_text(f"course: 1\ntitle: '{name}'\ndocuments: [lesson]\nlang: en\n", "utf-8")
    plan, lang = ["--plan", "velocity"], ["--lang", "en"]
    out = {k: at / f"{k}.html" for k in ("lesson", "note", "trace", "report", "class", "crank-slider")}
    marks = str(drawings / f"{name}.csv")
    assert main(["lesson", scene, "-o", str(out["lesson"]), *lang]) == 0
    assert main(["note", scene, "-o", str(out["note"]), *lang]) == 0
    assert main(["check", scene, *plan, "--trace", "-o", str(out["trace"]), *lang]) == 0
    assert main(["check", scene, marks, *plan, "-o", str(out["report"]), *lang]) == 1
    assert main(["check", scene, str(drawings), *plan, "-o", str(out["class"]), *lang]) == 1
    assert main(["crank-slider", engine, "-o", str(out["crank-slider"]), *lang]) == 0
    assert main(["course", str(course), "--jobs", "1", *lang]) == 0
    place = next(p for p in (course / "out/teacher").iterdir() if p.name.startswith("data"))
    return {**out, "course lesson": place / "lesson.html", "summary": course / "out/teacher/summary.html"}


@pytest.mark.slow
def test_pages_of_the_commands_with_hostile_names(browser: Any, written: dict[str, Path]) -> None:
    for kind, file in written.items():
        wrong, title = visit(browser, file, kind.removeprefix("course "))
        assert wrong == [] and ("{data}<img src=x" in title or kind in ("class", "crank-slider")), kind
