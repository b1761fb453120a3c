"""The studio's server: who may ask it, what it answers, what it makes, and what hostile messages come to."""

from __future__ import annotations

import base64
import http.client
import json
import random
import subprocess
import sys
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import pytest

from tests.helpers import ROOT
from tests.helpers.counting import PATIENCE_S

pytest.importorskip("uvicorn")
pytest.importorskip("starlette")
SIX = (ROOT / "samples" / "six-link.yaml").read_text("utf-8")
CLIENTS, EACH = 50, 1


class Door:
    """The server as a program sees it: its port and its token."""

    def __init__(self, address: str) -> None:
        self.port, self.token = int(address.split(":")[2].split("/")[0]), address.split("token=")[1]

    def ask(self, way: str, path: str, body: Any = None, **headers: str) -> tuple[int, dict[str, str], bytes]:
        """Status, headers and contents; with the token in the cookie unless a header says another."""
        line = http.client.HTTPConnection("127.0.0.1", self.port, timeout=PATIENCE_S)
        sent = body if isinstance(body, bytes | None) else json.dumps(body).encode()
        told = {"Cookie": f"planes={self.token}", "Content-Type": "application/json"} | headers
        line.request(way, path, sent, {name.replace("_", "-"): value for name, value in told.items() if value})
        found = line.getresponse()
        try:
            return found.status, dict(found.getheaders()), found.read()
        finally:
            line.close()


@pytest.fixture(scope="module")
def door() -> Iterator[Door]:
    command = [sys.executable, "-m", "planes", "studio", "--no-browser", "--lang", "en"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, cwd=ROOT) as started:
        assert started.stdout
        yield Door(started.stdout.readline().split(" at ")[1].split(";")[0])
        started.terminate()


def test_a_browser_comes_in_by_its_token_and_keeps_it_in_a_cookie(door: Door) -> None:
    status, headers, _ = door.ask("GET", f"/?token={door.token}", Cookie="")
    assert status == 303 and headers["location"] == "/"
    cookie = headers["set-cookie"].lower()
    assert "httponly" in cookie and "samesite=strict" in cookie and door.token in headers["set-cookie"]
    status, headers, page = door.ask("GET", "/")
    assert status == 200 and b"Content-Security-Policy" in page and headers["x-content-type-options"] == "nosniff"


@pytest.mark.parametrize("path", ["/", "/ask", "/file", "/check", "/gallery.json", "/reports/x", "/lesson.html"])
def test_nobody_else_is_answered(door: Door, path: str) -> None:
    """Without the token, by another name of the machine, from another page."""
    way = "POST" if path in ("/ask", "/file", "/check") else "GET"
    assert door.ask(way, path, {}, Cookie="")[0] == 403
    assert door.ask(way, path, {}, Cookie="planes=guess")[0] == 403
    assert door.ask(way, path, {}, Host="evil.example")[0] == 421
    assert door.ask(way, path, {}, Origin="https://evil.example")[0] == 421


def test_it_listens_to_this_machine_alone(door: Door) -> None:
    import socket

    others = {a[4][0] for a in socket.getaddrinfo(socket.gethostname(), None, socket.AF_INET)} - {"127.0.0.1"}
    for address in others:
        with socket.socket() as tried:
            assert tried.connect_ex((address, door.port)) != 0


def test_a_message_is_answered_with_a_lesson(door: Door) -> None:
    _, _, found = door.ask("POST", "/ask", {"id": 3, "ask": "lesson", "text": SIX, "lang": "en"})
    answer = json.loads(found)
    assert answer["id"] == 3 and answer["data"]["frames"] and answer["letters"]["en"]


FILES = {
    "sheet.svg": b"<?xml",
    "sheet.pdf": b"%PDF",
    "note.docx": b"PK",
    "lesson.html": b"<!doctype",
    "cycle.csv": b"",
    "plan.ggb": b"PK",
    "plan.tex": b"% !TeX",
    "turn.svg": b"<?xml",
}


@pytest.mark.few(1, slow=7)
@pytest.mark.parametrize("file", FILES)
def test_files_are_those_of_the_command_line(door: Door, file: str) -> None:
    status, _, data = door.ask("POST", "/file", {"text": SIX, "lang": "en", "file": file})
    assert status == 200 and data[:20].lower().startswith(FILES[file].lower()) and (file != "cycle.csv" or b"," in data)


def test_a_scene_that_is_wrong_makes_no_file_and_says_where(door: Door) -> None:
    status, _, said = door.ask("POST", "/file", {"text": SIX.replace("slides: CL", "slides: XX"), "file": "sheet.pdf"})
    assert status == 422 and b"scene.yaml:" in said and b"Traceback" not in said


@pytest.mark.slow
def test_a_drawing_is_checked_and_the_report_is_shown(door: Door) -> None:
    status, _, sheet = door.ask("POST", "/file", {"text": SIX, "lang": "en", "file": "sheet.svg"})
    assert status == 200
    drawing = {"name": "mine.svg", "drawing": base64.b64encode(sheet).decode(), "plan": "velocity"}
    status, _, where = door.ask("POST", "/check", {"text": SIX, "lang": "en", **drawing})
    assert status == 200, where
    status, _, report = door.ask("GET", f"/{where.decode()}")
    assert status == 200 and b"<!doctype html" in report[:30].lower()
    spoiled = {"name": "x.png", "drawing": base64.b64encode(b"no picture").decode(), "plan": "velocity"}
    status, _, said = door.ask("POST", "/check", {"text": SIX, "lang": "en", **spoiled})
    assert status in (200, 422) and b"Traceback" not in said


@pytest.mark.parametrize(
    "body",
    [
        b"",
        b"{",
        b"[]",
        b"null",
        b"\xff\xfe",
        b"[" * 100_000,
        b'{"text": 1, "ask": []}',
        b"x" * 400_000,
        b'{"file": "../../etc.pdf"}',
    ],
    ids=["nothing", "open", "list", "null", "no text", "deep", "kinds", "long", "path"],
)
@pytest.mark.parametrize("path", ["/ask", "/file", "/check"])
def test_a_hostile_message_is_refused_in_words(door: Door, path: str, body: bytes) -> None:
    status, _, said = door.ask("POST", path, body)
    assert status in (200, 400, 413, 422) and said and b"Traceback" not in said and b"Internal" not in said


def test_messages_of_any_shape_are_answered(door: Door) -> None:
    """Three hundred messages with parts of the wrong kind: each has an answer, and none ends the server."""
    draw = random.Random(5)
    kinds = [None, 1, -1.5, "", "x", [], {}, [1, 2], {"a": {}}, True, "ё" * 50, SIX]
    asks = ["lesson", "sketch", "drawn", "numbers", "put", "append", "leave out", "?", 3, None]
    for _ in range(300):
        names = draw.sample(["text", "lang", "sketch", "numbers", "path", "value", "id"], draw.randint(0, 7))
        message = {"ask": draw.choice(asks), **{n: draw.choice(kinds) for n in names}}
        status, _, said = door.ask("POST", "/ask", message)
        assert status == 200 and "problems" in json.loads(said), message


@pytest.mark.slow
def test_fifty_clients_are_answered_without_an_error(door: Door) -> None:
    def client(k: int) -> bool:
        for n in range(EACH):
            message = {"id": n, "ask": "lesson", "text": SIX.replace("l_BC: 0.3", f"l_BC: 0.3{k}"), "lang": "en"}
            status, _, said = door.ask("POST", "/ask", message)
            if status != 200 or json.loads(said)["id"] != n:
                return False
        return True

    with ThreadPoolExecutor(CLIENTS) as crowd:
        assert all(crowd.map(client, range(CLIENTS)))


ANY = {"type": ["string", "number", "boolean", "null", "object", "array"]}
NAME = {"type": "string", "enum": ["A", "B", "K", "1", "2", "y-y", "", "п. 7", "x" * 30]}
PLACE = {"type": "array", "items": {"type": "number"}, "minItems": 2, "maxItems": 2}
LINK = {"type": "object", "properties": {"points": {"type": "array", "items": NAME}, "slides": ANY, "centre": ANY}}
SKETCH = {
    "type": "object",
    "required": ["points", "fixed", "guides", "links"],
    "properties": {
        "points": {"type": "object", "properties": {"A": PLACE, "B": PLACE, "K": PLACE}, "additionalProperties": False},
        "fixed": {"type": "array", "items": NAME, "maxItems": 3},
        "guides": {"type": "object", "maxProperties": 2},
        "links": {"type": "object", "properties": {"1": LINK, "2": LINK}, "additionalProperties": False},
        "drive": ANY,
    },
}
TEXT = {"anyOf": [{"type": "string"}, {"enum": [SIX, "", "planes: 1\nlinks: {1: {points: {A: 0, B: 1}}}\n", "0"]}]}
MESSAGE = {
    "type": "object",
    "required": ["ask", "text"],
    "properties": {
        "ask": {
            "enum": ["lesson", "practice", "sketch", "drawn", "numbers", "rename", "put", "append", "leave out", "?"]
        },
        "text": TEXT,
        "lang": {"enum": ["en", "ru", "be", "xx"]},
        "sketch": SKETCH,
        "was": {"anyOf": [SKETCH, {"type": "null"}]},
        "numbers": {"type": "object", "properties": {"l_AB": {"type": "number"}, "g": ANY}},
        "said": {"type": "object", "additionalProperties": {"type": "string"}},
        "path": {"type": "array", "items": {"enum": ["point", "link", "links", "loads", "0", "1", "C", "title", ""]}},
        "value": {"type": "string"},
    },
}
FILE_ASKED = {"type": "object", "properties": {"text": {"type": "string"}, "file": {"enum": ["plan.tex", "../x", 3]}}}
DRAWING = {"type": "object", "properties": {"drawing": {"enum": ["AAAA", "a", "é", 1]}, "name": ANY, "plan": ANY}}
BODIES = {"/ask": MESSAGE, "/file": FILE_ASKED, "/check": DRAWING}
MOST_ANSWERED = 2_000_000  # bytes: three times the lesson of the six-link


def routes() -> dict[str, Any]:
    """The server's routes as an OpenAPI document."""
    done = {"default": {"description": "an answer"}}
    named = {"name": "name", "in": "path", "required": True, "schema": {"type": "string"}}
    posts = {
        path: {"post": {"requestBody": {"content": {"application/json": {"schema": body}}}, "responses": done}}
        for path, body in BODIES.items()
    }
    gets = {path: {"get": {"responses": done}} for path in ("/", "/gallery.json", "/lesson.html")}
    others = {path: {"get": {"parameters": [named], "responses": done}} for path in ("/reports/{name}", "/{name}")}
    return {"openapi": "3.1.0", "info": {"title": "studio", "version": "1"}, "paths": {**posts, **gets, **others}}


@pytest.mark.needs("schemathesis")
@pytest.mark.parametrize("wrong", [False, True], ids=["fitting", "not fitting"])
@pytest.mark.parametrize(("path", "count"), [("/ask", 250), ("/file", 6), ("/check", 6), ("", 15)])
def test_no_request_of_the_schema_breaks_the_server(door: Door, path: str, count: int, wrong: bool) -> None:
    """Requests that fit the routes' schema, and such that do not: none ends in an error of the server or a traceback,
    and every answer has its bound."""
    import schemathesis
    from hypothesis import HealthCheck, given, seed, settings

    mode = schemathesis.GenerationMode.NEGATIVE if wrong else schemathesis.GenerationMode.POSITIVE
    cookie = {"Cookie": f"planes={door.token}"}
    operations = [o.ok() for o in schemathesis.openapi.from_dict(routes()).get_all_operations()]
    some = [o for o in operations if (o.path == path if path else o.path not in BODIES)]
    for operation in some:
        if wrong and not path:
            continue  # any name is a name

        @seed(7)
        @settings(max_examples=count, deadline=None, database=None, suppress_health_check=[*HealthCheck])
        @given(case=operation.as_strategy(generation_mode=mode))
        def asked(case: Any) -> None:
            answer = case.call(base_url=f"http://127.0.0.1:{door.port}", headers=cookie, timeout=PATIENCE_S)
            assert answer.status_code < 500, (answer.status_code, case.body)
            assert b"Traceback" not in answer.content and len(answer.content) <= MOST_ANSWERED

        asked()


@pytest.mark.parametrize("token", ["%C3%A9", "%00", "a%ff"])
def test_a_strange_token_is_a_wrong_one(door: Door, token: str) -> None:
    assert door.ask("GET", f"/?token={token}", Cookie="")[0] == 403


@pytest.mark.parametrize("path", ["/ask", "/file", "/check"])
def test_half_a_letter_is_refused_in_words(door: Door, path: str) -> None:
    """A surrogate without its other half is JSON, but no text."""
    body = rb'{"ask": "lesson", "text": "title: \ud800", "file": "plan.tex", "drawing": "AAAA", "name": "\ud800.svg", '
    body += rb'"plan": "a\u0000"}'
    status, _, said = door.ask("POST", path, body)
    assert status in (200, 400, 422) and said and b"Traceback" not in said and b"Internal" not in said
