"""The common frame of all browser pages: one shell, one way to fill a template, one way to embed data.

A page needs no network, and runs only its own script: the browser knows the script's hash and refuses any other,
whatever a title or a file name contains.
"""

import base64
import hashlib
import html
import json
import re
from collections.abc import Iterable, Mapping
from importlib.resources import files

from planes.studio.links import deflated_text
from render.page.signs import page_signs, pen_widths_css

NO_DATA: Mapping[str, object] = {}
PACKED_ALPHABET = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz!#$()*+,-./:;=?@[]^_{|}"
"""Alphabet of packed text: 85 letters without meaning in HTML or JSON; five of them are four bytes, most significant
first."""
UNPACK_SCRIPT = f"""const letters = "{PACKED_ALPHABET}";
const text = JSON.parse(document.getElementById("code").textContent), count = text.length;
const four = k => [0, 1, 2, 3, 4].reduce((v, n) => 85 * v + letters.indexOf(text[k + n] ?? letters[84]), 0);
const bytes = new DataView(new ArrayBuffer(count + 4));
for (let k = 0; k < count; k += 5) bytes.setUint32(0.8 * k, four(k));
const packed = new Blob([bytes.buffer.slice(0, Math.floor(0.8 * count))]).stream();
const whole = await new Response(packed.pipeThrough(new DecompressionStream("deflate-raw"))).json();
for (const [id, type, textContent] of whole)
  document.head.append(Object.assign(document.createElement("script"), {{ id, type, textContent }}));"""
BASE85_TRANSLATION = str.maketrans(
    "!#$%&()*+-;<=>?@^_`{|}~", PACKED_ALPHABET[62:]
)  # replaces the characters of Python's base 85
_PLACEHOLDER_PATTERN = re.compile(r"\{(\w+)\}")
_ACTIVE_CHARACTER_PATTERN = re.compile("[<>&\u2028\u2029]")


def fill_web_page(
    title: str,
    lang: str,
    sheets: Iterable[str],
    body: str,
    *,
    code: str = "",
    data: Mapping[str, object] = NO_DATA,
    kind: str = "",
    allowed: str = "",
    small: bool = False,
) -> str:
    """The whole page: ``title`` is plain text, ``sheets`` are files of its style, ``body`` is HTML; ``data`` by the ids
    under which ``code`` finds them; ``allowed`` are further permissions (a part of the page's policy). A ``small`` page
    has both packed, with a short script to unpack them."""
    begun = code
    data = {**data, "signs": page_signs()} if data else data
    if small:
        texts = [(key, "application/json", compact_json(one)) for key, one in data.items()]
        begun = UNPACK_SCRIPT
        data = {"code": pack_text(compact_json([*texts, ("", "module", code)]))}
    held = (f'<script type="application/json" id="{key}">{json_for_html(one)}</script>\n' for key, one in data.items())
    parts = {
        "lang": lang,
        "policy": content_policy(allowed, *dict.fromkeys((begun, code))),
        "title": html.escape(title),
        "style": f"svg {{ {pen_widths_css()}}}\n{page_files_text(*sheets)}",
        "body": body,
    }
    parts["kind"] = f' class="{html.escape(kind)}"' if kind else ""
    parts["scripts"] = "".join(held) + (f'<script type="module">{begun}</script>\n' if code else "")
    return fill_template("shell.html", parts)


def content_policy(more: str = "", *scripts: str) -> str:
    """The permissions of a page: its own styles and pictures, a picture the user opens, these scripts."""
    hashes = (base64.b64encode(hashlib.sha256(one.encode()).digest()).decode() for one in scripts if one)
    listed = "".join(f" 'sha256-{one}'" for one in hashes)
    script = f"script-src{listed}; " if listed else ""
    allowed = "default-src 'none'; style-src 'unsafe-inline'; img-src data: blob:; "
    return f"{allowed}{script}{more}base-uri 'none'; form-action 'none'"


def pack_text(text: str) -> str:
    """A text packed, in :data:`LETTERS`."""
    return base64.b85encode(deflated_text(text)).decode().translate(BASE85_TRANSLATION)


def fill_template(template: str, parts: Mapping[str, str]) -> str:
    """A template of the pages' folder with its placeholders filled in one pass: inserted text is never scanned
    again."""
    return _PLACEHOLDER_PATTERN.sub(lambda place: parts[place[1]], page_files_text(template))


def json_for_html(thing: object) -> str:
    """JSON without characters that have a meaning in HTML or end a line of a script."""
    return _ACTIVE_CHARACTER_PATTERN.sub(lambda match: f"\\u{ord(match[0]):04x}", compact_json(thing))


def compact_json(thing: object) -> str:
    """JSON without spaces."""
    return json.dumps(thing, ensure_ascii=False, separators=(",", ":"), allow_nan=False)


def page_files_text(*names: str) -> str:
    """Files of the pages' folder, one after another."""
    return "".join((files("render") / "page" / name).read_text("utf-8") for name in names)
