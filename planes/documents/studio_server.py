"""The local studio: a server for one user's browser, with the engine behind it.

It listens on this machine only, and answers only a browser that has its token and its own page: so no other open page
can send it a request. Long work, or work on a foreign file, runs in a separate process.
"""

import asyncio
import base64
import json
import re
import secrets
import sys
import tempfile
import webbrowser
from collections.abc import Awaitable, Callable
from functools import partial
from pathlib import Path

from starlette.applications import Starlette
from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import PlainTextResponse, RedirectResponse, Response
from starlette.routing import Route

from planes.scene.files import save_file_or_refuse
from planes.studio.gallery import gallery_entries
from planes.words import Lang, available_languages, say
from planes.words.formats import DRAWING_FORMATS
from planes.words.names import NameTuple
from render.page.studio_page import COMMAND_OF_DOWNLOAD, answer_as_json, studio_files

HOST = "127.0.0.1"
COOKIE_NAME = "planes"
MOST_MESSAGE_BYTES = 300_000
MOST_DRAWING_BYTES = 40_000_000
MOST_MAKING_SECONDS = 90  # seconds for making a file
MOST_FILES_MADE_AT_ONCE = 2  # files made at once
MADE_FILE_TYPES = {suffix[1:]: made.media_type for suffix, made in DRAWING_FORMATS.items()} | {
    "html": "text/html",
    "docx": "application/vnd.openxmlformats-officedocument.wordprocessingml.document",
    "csv": "text/csv",
    "ggb": "application/vnd.geogebra.file",
    "tex": "application/x-tex",
}
PLAN_NAME_PATTERN = re.compile(r"[\w:-]{1,40}")
OWN_FILE_TYPES = {"html": "text/html", "js": "text/javascript", "json": "application/json"}
SAFETY_HEADERS = {
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Cache-Control": "no-store",
}
"""Headers of every answer."""


class StudioServer:
    """The routes, and their common data: the token, the pages, the folders where files are made."""

    def __init__(self, lang: Lang, first: str = "", scenes: NameTuple = ()) -> None:
        self.lang = lang
        self.token = secrets.token_urlsafe(24)
        way = {"kind": "server", "address": "", "native": True}
        self.pages = studio_files(lang, way, first)
        self.scenes = scenes
        self.shelf = b""
        self.busy = asyncio.Semaphore(MOST_FILES_MADE_AT_ONCE)
        self.reports: dict[str, bytes] = {}

    def application(self) -> Starlette:
        """The application."""
        return Starlette(
            routes=[
                Route("/", self.guarded_route(self.serve_own_file)),
                Route("/ask", self.guarded_route(self.answer_message), methods=["POST"]),
                Route("/file", self.guarded_route(self.serve_made_file), methods=["POST"]),
                Route("/check", self.guarded_route(self.check_drawing), methods=["POST"]),
                Route("/gallery.json", self.guarded_route(self.serve_gallery)),
                Route("/reports/{name}", self.guarded_route(self.serve_report)),
                Route("/{name}", self.guarded_route(self.serve_own_file)),
            ]
        )

    def is_own_token(self, token: str) -> bool:
        """Whether it is the server's token; a comparison takes letters of ASCII only."""
        return token.isascii() and secrets.compare_digest(token, self.token)

    def guarded_route(self, act: Callable[[Request], Awaitable[Response]]) -> Callable[[Request], Awaitable[Response]]:
        """A route for the browser with the token, addressed by this name of the machine and from this page."""

        async def answered(request: Request) -> Response:
            here = {f"{name}:{request.url.port}" for name in (HOST, "localhost")}
            origin = request.headers.get("origin")
            if request.headers.get("host") not in here or origin not in (None, *(f"http://{one}" for one in here)):
                return self.error_response("studio_not_here", 421)
            if self.is_own_token(request.query_params.get("token", "")):
                response: Response = RedirectResponse("/", 303)
                response.set_cookie(COOKIE_NAME, self.token, httponly=True, samesite="strict")
            elif self.is_own_token(request.cookies.get(COOKIE_NAME, "")):
                response = await act(request)
            else:
                response = self.error_response("studio_no_token", 403)
            response.headers.update(SAFETY_HEADERS)
            return response

        return answered

    def error_response(self, key: str, status: int, **parts: object) -> Response:
        """An error sentence in the studio's language."""
        return PlainTextResponse(say(key, self.lang, **parts), status)

    async def serve_own_file(self, request: Request) -> Response:
        """One of the studio's own files."""
        name = request.path_params.get("name", "index.html")
        if name not in self.pages:
            return self.error_response("studio_no_page", 404)
        return Response(self.pages[name], media_type=OWN_FILE_TYPES[name.rpartition(".")[2]])

    async def serve_gallery(self, _: Request) -> Response:
        """The scenes of the gallery, made on first request."""
        if not self.shelf:
            scenes = await run_in_threadpool(gallery_entries, self.scenes)
            self.shelf = json.dumps(scenes, ensure_ascii=False).encode()
        return Response(self.shelf, media_type=OWN_FILE_TYPES["json"])

    async def request_message(self, request: Request, most: int) -> dict[str, object] | None:
        """The message of a request, of at most ``most`` bytes; None for any other input."""
        data = b""
        async for chunk in request.stream():
            data += chunk
            if len(data) > most:
                return None
        try:
            message = json.loads(data)
        except (ValueError, RecursionError):
            return None
        return message if isinstance(message, dict) else None

    async def answer_message(self, request: Request) -> Response:
        """A message and its answer."""
        if (message := await self.request_message(request, MOST_MESSAGE_BYTES)) is None:
            return self.error_response("studio_bad_message", 400)
        return Response(await run_in_threadpool(answer_as_json, message), media_type=OWN_FILE_TYPES["json"])

    async def serve_made_file(self, request: Request) -> Response:
        """A file as the command line would write it."""
        message = await self.request_message(request, MOST_MESSAGE_BYTES)
        file = str((message or {}).get("file", ""))
        if message is None or file not in COMMAND_OF_DOWNLOAD:
            return self.error_response("studio_bad_message", 400)
        verb, *extra = COMMAND_OF_DOWNLOAD[file]
        made = await self.command_output(message, [verb, "scene.yaml", *extra, "-o", file], file)
        if isinstance(made, Response):
            return made
        return Response(made, media_type=MADE_FILE_TYPES[Path(file).suffix[1:]])

    async def check_drawing(self, request: Request) -> Response:
        """The address of the report on a drawing."""
        message = await self.request_message(request, MOST_DRAWING_BYTES)
        try:
            drawing = base64.b64decode(str((message or {})["drawing"]), validate=True)
        except (KeyError, ValueError):
            return self.error_response("studio_bad_message", 400)
        assert message is not None
        suffix = re.sub(r"[^\w.]", "", Path(str(message.get("name", ""))).suffix)[:6]
        plan = ("--plan", asked) if PLAN_NAME_PATTERN.fullmatch(asked := str(message.get("plan", ""))) else ()
        line = ["check", "scene.yaml", f"drawing{suffix}", *plan, "-o", "report.html"]
        made = await self.command_output(message, line, "report.html", {f"drawing{suffix}": drawing})
        if isinstance(made, Response):
            return made
        name = secrets.token_urlsafe(8)
        self.reports = {**dict(list(self.reports.items())[-7:]), name: made}
        return PlainTextResponse(f"reports/{name}")

    async def serve_report(self, request: Request) -> Response:
        """A stored report."""
        page = self.reports.get(request.path_params["name"])
        if page:
            return Response(page, media_type=OWN_FILE_TYPES["html"])
        return self.error_response("studio_no_page", 404)

    async def command_output(
        self, message: dict[str, object], line: list[str], output: str, beside: dict[str, bytes] | None = None
    ) -> bytes | Response:
        """The output of a command for the message's scene, in a separate process; or why it failed."""
        lang = str(message.get("lang", ""))
        with tempfile.TemporaryDirectory() as folder:
            for name, data in {
                "scene.yaml": str(message.get("text", "")).encode(errors="replace"),
                **(beside or {}),
            }.items():
                save_file_or_refuse(data, Path(folder) / name)
            argv = [
                sys.executable,
                "-m",
                "planes",
                *line,
                "--lang",
                lang if lang in available_languages() else self.lang,
            ]
            async with self.busy:
                pipe = asyncio.subprocess.PIPE
                child = await asyncio.create_subprocess_exec(*argv, cwd=folder, stdout=pipe, stderr=pipe)
                try:
                    _, said = await asyncio.wait_for(child.communicate(), MOST_MAKING_SECONDS)
                except TimeoutError:
                    child.kill()
                    await child.wait()
                    return self.error_response("studio_too_long", 504, seconds=MOST_MAKING_SECONDS)
            file = Path(folder) / output
            if file.is_file():
                return file.read_bytes()
            return PlainTextResponse(said.decode("utf-8", "replace")[-2000:].strip() or str(child.returncode), 422)


def serve(lang: Lang, first: str = "", scenes: NameTuple = (), port: int = 0, browse: bool = True) -> None:
    """The server, until it is stopped; ``port`` 0 means any free one."""
    import socket

    import uvicorn

    studio = StudioServer(lang, first, scenes)
    with socket.socket() as door:
        door.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        door.bind((HOST, port))
        door.listen(128)  # when the address is printed, it is already open
        address = f"http://{HOST}:{door.getsockname()[1]}/?token={studio.token}"
        print(say("studio_opened", lang, address=address), flush=True)
        if browse:
            from threading import Timer

            Timer(0.5, partial(webbrowser.open, address)).start()
        config = uvicorn.Config(studio.application(), log_level="warning", timeout_keep_alive=30)
        uvicorn.Server(config).run([door])
