"""Practice with ruler and compass in a browser: by hand, by keys alone, wrongly and rightly, with fresh numbers."""

from __future__ import annotations

import base64
import json
from pathlib import Path
from typing import Any

import pytest

from planes import cli
from planes.lesson.handed_practice import PracticeJudge
from planes.lesson.told import SceneLesson
from planes.scene import load
from tests.helpers import ROOT
from tests.helpers.lessons import lesson_opened, lesson_written

WIDE = {"width": 1280, "height": 900}
HERE = ROOT / "samples"
KINDS = ("*.yaml", "vectors/*.yaml", "class-three/*.yaml", "class-four/*.yaml")
SCENES = [file for kind in KINDS for file in sorted(HERE.glob(kind))]
TAKE = "n => { practice.said = null; practice.take(data.practice.findIndex(t => t.what === n)); }"
UPTO = """n => { for (let k = 0; k < 300 && practice.item.what !== n; k++) give(); }"""
SOLVE = """() => {
    const wrong = [];
    for (let k = 0; k < 400 && !practice.over; k++) {
        const { kind, what } = practice.item;
        give();
        if (practice.said[0] !== "yes") wrong.push([kind, what, practice.said[1]]);
    }
    return [practice.over, practice.good === practice.items.length, wrong];
}"""
GIVE = """window.give = () => { const true_ = practice.truth(practice.item);
    if (practice.item.kind === "mark") practice.place(true_); else practice.answer(true_, ""); }"""

OTHERWISE = """window.give = () => { const t = practice.item; // the smallest scale that will do
    const mu = t.kind === "mu" && t.offered.find(o => practice.right(t, o.value)).value;
    const true_ = mu || practice.truth(t);
    if (t.kind === "mark") practice.place(true_); else practice.answer(true_, ""); }"""


@pytest.fixture
def desk(page: Any) -> Any:
    """Practice begun."""
    page.click("#practise")
    page.evaluate(GIVE)
    return page


def said(page: Any) -> str:
    return str(page.inner_text("#task .said"))


def test_a_vector_by_keys_alone(desk: Any) -> None:
    desk.evaluate(UPTO, "velocity:b")
    desk.select_option("#along", "AB|1")
    right = desk.evaluate("() => { const [x, y] = practice.truth(practice.item); return [Math.hypot(x, y), "
                          "Math.cos(desk.heading() - Math.atan2(y, x)) < 0 ? 1 : 0]; }")  # fmt: skip
    for way, mm, expected in ((1 - right[1], right[0], "против вращения"), (right[1], 2, "сама величина")):
        desk.select_option("#way", index=way)
        desk.fill("#mm", str(mm).replace(".", ","))
        desk.keyboard.press("Enter")
        assert "✗" in said(desk) and expected in said(desk)
        assert desk.evaluate("document.activeElement.id") == "mm"
    desk.fill("#mm", f"{right[0]:.1f}")
    desk.keyboard.press("Enter")
    assert "✓" in said(desk) and desk.evaluate("practice.seen().has('velocity:b')")
    assert desk.evaluate("practice.good === practice.asked - 1")


@pytest.mark.slow
def test_two_lines_and_their_crossing(desk: Any) -> None:
    desk.evaluate(UPTO, "velocity:c")
    desk.click("#tool-line")
    desk.select_option("#from", "velocity:b")
    desk.select_option("#along", "BC|0")
    desk.click("#do-draw")
    assert "вдоль звена" in said(desk)
    desk.click("#do-erase")
    for start, line in (("p", "DC|1"), ("b", "BC|1")):
        desk.click("#tool-line")
        desk.select_option("#from", f"velocity:{start}")
        desk.select_option("#along", line)
        desk.click("#do-draw")
        assert "✓" in said(desk)
    assert desk.evaluate("desk.tool") == "point"
    desk.click("#do-draw")
    assert "✓" in said(desk) and desk.evaluate("practice.seen().has('velocity:c')")


def test_lines_drawn_by_hand(desk: Any) -> None:
    desk.evaluate(UPTO, "velocity:c")
    desk.click("#tool-line")
    box = desk.locator("#plan").bounding_box()
    for start, line in (("p", "DC|1"), ("b", "BC|1")):
        desk.click("#tool-line")
        desk.select_option("#along", line)
        x, y = desk.evaluate(f"plan.px(plan.at('velocity:{start}'))")
        a = desk.evaluate("desk.heading()")
        desk.mouse.move(box["x"] + x, box["y"] + y)
        desk.mouse.down()
        turn = desk.evaluate(f"[Math.cos({a}), -Math.sin({a})]")
        desk.mouse.move(box["x"] + x + 60 * turn[0], box["y"] + y + 60 * turn[1], steps=3)
        desk.mouse.up()
        assert "✓" in said(desk)
    x, y = desk.evaluate("plan.px(plan.at('velocity:c'))")
    desk.mouse.click(box["x"] + x + 4, box["y"] + y)
    assert "✓" in said(desk) and desk.evaluate("practice.seen().has('velocity:c')")


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["pen", "touch"])
def test_a_vector_drawn_with_a_pen_or_a_finger(desk: Any, kind: str) -> None:
    desk.evaluate(UPTO, "velocity:b")
    desk.ask("Emulation.setTouchEmulationEnabled", enabled=kind == "touch")
    desk.click("#tool-vector")
    desk.select_option("#along", "AB|1")
    box = desk.locator("#plan").bounding_box()
    points = desk.evaluate("['velocity:p', 'velocity:b'].map(m => plan.px(live.at(m)))")
    (x, y), (far_x, far_y) = ((box["x"] + p[0], box["y"] + p[1]) for p in points)
    path = [(x + k / 5 * (far_x - x), y + k / 5 * (far_y - y)) for k in range(6)]
    for k, (px, py) in enumerate([*path, path[-1]]):
        at = "start" if k == 0 else "end" if k == 6 else "move"
        if kind == "touch":
            points = [] if at == "end" else [{"x": px, "y": py}]
            desk.ask("Input.dispatchTouchEvent", type=f"touch{at.title()}", touchPoints=points)
        else:
            told = {"start": "mousePressed", "end": "mouseReleased", "move": "mouseMoved"}[at]
            more = {"button": "left", "buttons": 1, "clickCount": 1, "pointerType": "pen"}
            desk.ask("Input.dispatchMouseEvent", type=told, x=px, y=py, **more)
    drawn = float(desk.input_value("#mm").replace(",", "."))
    assert drawn == pytest.approx(desk.evaluate("Math.hypot(...practice.truth(practice.item))"), abs=1)
    desk.click("#do-draw")
    assert "✓" in said(desk)


@pytest.mark.slow
def test_the_compass_meets_the_other_crossing(desk: Any) -> None:
    desk.evaluate(UPTO, "position:C")
    for centre, other in (("B", "C"), ("D", "C")):
        desk.click("#tool-arc")
        desk.select_option("#from", f"position:{centre}")
        one, two = (f"live.at('position:{n}')" for n in (centre, other))
        desk.fill("#mm", str(desk.evaluate(f"Math.hypot({one}[0] - {two}[0], {one}[1] - {two}[1])")))
        desk.click("#do-draw")
        assert "✓" in said(desk)
    spots = desk.evaluate(
        "(c => desk.crossings().map(p => Math.hypot(p[0] - c[0], p[1] - c[1])))(live.at('position:C'))"
    )
    assert len(spots) == 2 and min(spots) < 1e-9
    desk.select_option("#spot", index=spots.index(max(spots)))
    desk.click("#do-draw")
    assert "другая сборка" in said(desk)
    desk.select_option("#spot", index=spots.index(min(spots)))
    desk.click("#do-draw")
    assert "✓" in said(desk)


def test_the_other_crossing_of_two_arcs_is_a_ghost(page: Any) -> None:
    page.evaluate("go(data.frames.findIndex(f => f.makes[0] === 'position:C'))")
    node = "document.querySelector('#scheme circle.trace')"
    ghost = f"(q => scheme.mm([+q.getAttribute('cx'), +q.getAttribute('cy')]))({node})"
    other = "live.pair(data.slips.find(s => s.m === 'other_assembly').place)"
    assert page.evaluate(ghost) == pytest.approx(page.evaluate(other), abs=0.1)


def test_numbers_scales_and_senses_have_their_slips(desk: Any) -> None:
    ask = """([what, by]) => { practice.take(data.practice.findIndex(t => t.what === what)); practice.said = null;
        practice.number(String(practice.truth(practice.item) * by)); return practice.said[1]; }"""
    assert "примените масштаб" in desk.evaluate(ask, ["‖v_C‖", 30])
    assert "на длину звена" in desk.evaluate(ask, ["omega_2", 1 / 250])
    assert desk.evaluate(ask, ["h_G_2_C", 1.001]).startswith("Верно")
    both = desk.evaluate(ask, ["a_HL^k", 0.5])  # at μ = 2 the half is the quantity divided by μ² · 2 too
    assert "вдвое меньше" in both
    desk.evaluate(TAKE, "omega_2")
    desk.evaluate("practice.take(data.practice.findIndex(t => t.kind === 'sense'))")
    wrong = desk.evaluate("practice.truth(practice.item) > 0 ? 'cw' : 'ccw'")
    desk.click(f"#do-{wrong}")
    assert "направление вращения" in said(desk)


def test_moments_and_reactions_have_a_sense(desk: Any) -> None:
    ask = """([what, by]) => { practice.take(data.practice.findIndex(t => t.what === what)); practice.said = null;
        practice.number(String(practice.truth(practice.item) * by)); return practice.said; }"""
    assert desk.evaluate(ask, ["M_1", -1])[0] == "no" and "знак" in desk.evaluate("practice.said[1]")
    assert desk.evaluate(ask, ["M_1", 1])[0] == "yes"
    assert desk.evaluate(ask, ["h_G_2_C", -1])[0] == "yes"  # which way an arm is counted is one's own
    desk.evaluate(TAKE, "↺F_21^t")
    assert "F21t" in desk.inner_text("#h").replace("\n", "") and "C" in desk.inner_text("#h")
    moment = """(() => { const [b, c] = ['B', 'C'].map(n => live.at('position:' + n));
        const a = live.angle('⊥BC') * Math.PI / 180, f = live.value('F_21^t');
        return (b[0] - c[0]) * Math.sin(a) * f - (b[1] - c[1]) * Math.cos(a) * f; })()"""
    way = "ccw" if desk.evaluate(moment) > 0 else "cw"
    desk.click(f"#do-{'cw' if way == 'ccw' else 'ccw'}")
    assert "✗" in said(desk)
    desk.click(f"#do-{way}")
    assert "✓" in said(desk)


def test_a_mark_must_be_nearer_to_its_place_than_to_a_mistake(desk: Any) -> None:
    found = desk.evaluate("""() => data.practice.filter(t => t.kind === 'mark').map(t => {
        const p = live.at(t.what);
        const off = practice.slips(t.what).map(s => Math.hypot(s.place[0] - p[0], s.place[1] - p[1]));
        return [practice.fits(t.what), practice.allowed(t.what), Math.min(...off, Number.MAX_VALUE)]; })""")
    assert all(fits <= wide and (fits <= off / 2 + 1e-12 or fits == 0.5) for fits, wide, off in found)
    assert any(fits < wide for fits, wide, _ in found) and any(fits == wide for fits, wide, _ in found)


@pytest.mark.slow
def test_what_cannot_be_told_apart_is_named_with_the_other(desk: Any) -> None:
    desk.evaluate(UPTO, "acceleration:k_HL")
    told = desk.evaluate("""() => { const [x, y] = live.at('acceleration:k_HL'), s = live.at(desk.from);
        const a = Math.atan2(y - s[1], x - s[0]), mm = Math.hypot(x - s[0], y - s[1]) / 2;
        practice.place([s[0] + mm * Math.cos(a), s[1] + mm * Math.sin(a)], { at: s, a, mm, end: [0, 0] });
        return practice.said[1]; }""")
    assert "вдвое меньше" in told and "; или " in told and "сама величина" in told


@pytest.mark.slow
def test_fresh_numbers_come_from_the_address(browser: Any, lesson: str) -> None:
    told = []
    for seed in (7, 7, 8):
        one = browser.new_page()
        one.goto(f"{lesson}#seed={seed}")
        told.append(one.evaluate("[practice.on, practice.seed, live.given]"))
        one.close()
    assert told[0] == told[1] and told[0][:2] == [True, 7] and told[2][2] != told[0][2]


def test_practice_stays_with_its_drawing(page: Any, lesson: str) -> None:
    page.click("#spin")
    page.click("#play")
    page.click("#practise")
    assert page.evaluate("[state.spin, state.timer, live.at_home]") == [0, 0, True]
    for control in ("spin", "play", "progress", "crank", "exact", "home"):
        assert page.is_disabled(f"#{control}"), control
    page.evaluate("practice.over = true; draw()")
    page.click("#practise")
    assert page.is_enabled("#spin") and page.is_enabled("#crank") and page.is_visible("#told")
    page.click("#practise")
    assert page.inner_text("#number").startswith("0 /") and "закончено" not in page.inner_text("#task")
    page.evaluate("location.hash = '#step=3&at=170.5'")
    page.wait_for_function("!practice.on")
    assert page.inner_text("#number").startswith("3 /") and page.is_visible("#told") and page.is_enabled("#crank")


def chosen(page: Any, kind: str, value: str) -> str:
    """What is said when the first question of a kind is answered by a choice, as a reader makes it."""
    page.evaluate("k => { practice.said = null; practice.take(data.practice.findIndex(t => t.kind === k)); }", kind)
    page.click(f"#do-choose-{page.evaluate(f'practice.item.offered.findIndex(o => {value})')}")
    return str(page.evaluate("plainly(practice.said[1])"))


def test_a_scale_is_chosen_by_how_large_the_plan_is(desk: Any) -> None:
    desk.evaluate("window.plainly = t => t.replace(/[⟨⟩]/g, '')")
    assert "μ = ?" in desk.inner_text("#scheme-title")
    assert "больше места на листе" in chosen(desk, "mu", "o.value === 2500")
    assert "займёт 11 мм: такой не измерить" in chosen(desk, "mu", "o.value === 25")
    assert chosen(desk, "mu", "o.value === 100") == "Верно: план займёт 42 мм."
    assert "μ = 100 мм/м" in desk.inner_text("#scheme-title")
    assert desk.evaluate("live.given.mu_position") == 100 and desk.evaluate("handed().length") > 0
    assert desk.evaluate(SOLVE) == [True, False, []]  # the first answer counts


@pytest.mark.slow
def test_no_question_tells_its_scale(desk: Any) -> None:
    """While a scale is to be chosen, it is read nowhere, nor is the plan drawn on."""
    told = desk.evaluate("""() => {
        const leaks = [];
        for (let k = 0; k < 300 && !practice.over; k++) {
            for (const t of practice.items.filter((t, i) => t.kind === "mu" && !practice.done.has(i))) {
                const p = data.plans.find(p => p.key === t.what), mu = "μ = " + filled(p.mu.ru);
                const titled = [...document.querySelectorAll("figcaption")].map(e => e.innerText).filter(
                    e => e.includes(t.what === "position" ? "Схема" : p.title.ru));
                const asked = [...document.querySelectorAll("#task h2, #task .answers span, #large")];
                const own = practice.frame.chapter === t.what ? asked.map(e => e.innerText) : [];
                if ([...titled, ...own].some(e => e.includes(mu))) leaks.push([k, t.what]);
            }
            give();
        }
        return leaks;
    }""")
    assert told == []
    assert desk.evaluate("[...document.querySelectorAll('.scale')].every(e => !e.checkVisibility())")
    desk.emulate_media(media="print")  # nor is the whole lesson printed beside its questions
    shown = "['handout', 'task', 'scheme'].map(id => $(id).checkVisibility())"
    assert desk.evaluate(f"practice.begin(0); handout(); {shown}") == [False, True, True]


@pytest.mark.slow
def test_the_next_links_and_the_first_equation_are_chosen_with_a_reason(desk: Any) -> None:
    desk.evaluate("window.plainly = t => plain(t)")
    assert not desk.evaluate("$('chapter').checkVisibility()")  # it lists the plans of forces in their order
    assert "F12" in chosen(desk, "order", "o.value === 'force:1'")
    assert chosen(desk, "order", "o.value === 'force:4-5'") == "Верно."
    assert "самой далёкой" in chosen(desk, "reason", "o.value === 'driver'")
    assert chosen(desk, "reason", "o.value === 'last'") == "Верно."
    desk.evaluate("practice.begin(0)")
    hidden = "!document.getElementById('equations').textContent.includes('vCB')"
    assert "разных звеньев" in chosen(desk, "first", "o.value.includes('v_CA')") and desk.evaluate(hidden)
    assert "vL" in chosen(desk, "first", "o.value.includes('v_HL')")
    assert chosen(desk, "first", "o.value.includes('v_CD')") == "Верно."
    desk.evaluate("practice.take(data.practice.findIndex(t => t.kind === 'known'))")
    assert not desk.evaluate(hidden)


def test_a_code_is_verified_and_an_altered_one_refused(desk: Any, tmp_path: Path, capsys: Any) -> None:
    """The scene is drawn anew with the numbers of the seed; the answers, not the score that is told, count."""
    codes = tmp_path / "codes"
    codes.mkdir()
    for seed in (0, 5):
        desk.evaluate(f"practice.begin({seed}); practice.name = 'Анна'; practice.answer(null, '', true)")
        desk.evaluate(OTHERWISE if seed else GIVE)
        desk.evaluate(SOLVE)
        desk.evaluate("draw()")
        (codes / f"{seed}.practice").write_text(desk.input_value("#code"), "utf-8")
    assert cli.main(["check", str(HERE / "six-link.yaml"), str(codes), "--json"]) == 0
    rows = json.loads(capsys.readouterr().out)
    assert [(row["name"], row["seed"], row["right"], row["count"]) for row in rows] == [
        ("Анна", seed, 103, 104) for seed in (0, 5)
    ]
    told = desk.evaluate("""() => { Object.defineProperty(practice, 'good', { get: () => 104 }); return handed(); }""")
    (codes / "altered.practice").write_text(told, "utf-8")
    (codes / "cut.practice").write_text(told[:-9], "utf-8")
    assert cli.main(["check", str(HERE / "six-link.yaml"), str(codes), "--lang", "en"]) == 2
    out = capsys.readouterr().out
    assert "altered" in out and "104 of 104" in out and "give 103" in out and "the code is damaged" in out
    assert cli.main(["check", str(HERE / "kind-1-rrr.yaml"), str(codes / "0.practice"), "--lang", "en"]) == 2
    assert "does not belong to" in capsys.readouterr().out


def test_the_first_click_saves_under_the_name_just_typed(desk: Any) -> None:
    """Leaving the field takes nothing from under the finger that is on the link; initials end with one full stop."""
    assert desk.evaluate(SOLVE)[0]
    desk.focus("#student")
    desk.ask("Input.insertText", text="Жданович Е. В.")
    box = desk.locator("#save").bounding_box()
    desk.evaluate("() => { window.link = document.getElementById('save'); }")
    with desk.expect_download():
        desk.mouse.click(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    assert desk.evaluate("() => window.link.isConnected && window.link.download") == "Жданович Е. В.practice"
    code = desk.input_value("#code").split(".")[1]
    assert "Жданович Е. В." in base64.urlsafe_b64decode(code + "=" * (-len(code) % 4)).decode()


def test_scales_stand_as_they_are_written_and_nothing_twice(desk: Any) -> None:
    """Beside a question: no name of the program's for a scale, each with its unit."""
    told = desk.evaluate("""() => { const every = []; for (let k = 0; k < 400 && !practice.over; k++) {
        if (practice.item.kind === "number") every.push(document.querySelector("#task .answers span").innerText);
        give(); } return every; }""")
    assert told and not [text for text in told if "mu_" in text]
    for parts in (text.split("; ") for text in told):
        assert len(set(parts)) == len(parts)
        assert all("/" in part for part in parts if part.startswith("μ"))


MARKED: dict[str, list[pytest.MarkDecorator]] = {"bntu-4": [], "excavator": [pytest.mark.slow]}
"""One lays off no length first, of one a link stands still."""


@pytest.mark.slow
@pytest.mark.parametrize(
    "path",
    [pytest.param(p, marks=MARKED.get(p.stem, [pytest.mark.long])) for p in SCENES],
    ids=[p.stem for p in SCENES],
)
def test_scales_of_ones_own_are_judged_alike_by_page_and_python(browser: Any, tmp_path: Path, path: Path) -> None:
    judge, code = PracticeJudge(SceneLesson.of(load(str(path)))), tmp_path / "one.practice"
    with lesson_opened(browser, lesson_written(tmp_path, path, "en")) as page:
        page.click("#practise")
        page.evaluate(OTHERWISE)
        for seed in (0, 3):
            page.evaluate(f"practice.begin({seed})")
            assert page.evaluate(SOLVE) == [True, True, []]
            code.write_text(page.evaluate("handed()"), "utf-8")
            told = judge.judge_file(str(code))
            assert told.right == told.count


@pytest.mark.few(0, slow=8)
@pytest.mark.parametrize("path", SCENES, ids=[p.stem for p in SCENES])
def test_every_scene_is_practised_to_the_end_whatever_its_numbers(browser: Any, tmp_path: Path, path: Path) -> None:
    with lesson_opened(browser, lesson_written(tmp_path, path, "en")) as page:
        page.click("#practise")
        page.evaluate(GIVE)
        for seed in (0, 1, 2):
            page.evaluate(f"practice.begin({seed})")
            assert page.evaluate(SOLVE) == [True, True, []]
        assert page.input_value("#code").startswith("planes-practice.")
