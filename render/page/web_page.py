"""A page for a browser, of whatever kind: one shell, one way to fill a template, one way to bring data along.

A page asks nothing of the network, and runs only the script that is written into it: the browser is told so by the
hash of the script, and refuses any other, whatever stands in a title or in the name of a file.
"""

import base64
import hashlib
import html
import json
import re
from collections.abc import Mapping
from importlib.resources import files

from planes.studio.links import deflated

NONE: Mapping[str, object] = {}
LETTERS = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz!#$()*+,-./:;=?@[]^_{|}"
"""Of what is packed: 85 that mean nothing to HTML or JSON; five of them are four bytes, the highest place first."""
UNPACK = f"""const letters = "{LETTERS}";
const text = JSON.parse(document.getElementById("code").textContent), count = text.length;
const four = k => [0, 1, 2, 3, 4].reduce((v, n) => 85 * v + letters.indexOf(text[k + n] ?? letters[84]), 0);
const bytes = new DataView(new ArrayBuffer(count + 4));
for (let k = 0; k < count; k += 5) bytes.setUint32(0.8 * k, four(k));
const packed = new Blob([bytes.buffer.slice(0, Math.floor(0.8 * count))]).stream();
const whole = await new Response(packed.pipeThrough(new DecompressionStream("deflate-raw"))).json();
for (const [id, type, textContent] of whole)
  document.head.append(Object.assign(document.createElement("script"), {{ id, type, textContent }}));"""
OURS = str.maketrans("!#$%&()*+-;<=>?@^_`{|}~", LETTERS[62:])  # for the signs of Python's base 85
_PLACE = re.compile(r"\{(\w+)\}")
_ACTIVE = re.compile("[<>&\u2028\u2029]")


def page(
    title: str,
    lang: str,
    style: str,
    body: str,
    *,
    code: str = "",
    data: Mapping[str, object] = NONE,
    kind: str = "",
    allowed: str = "",
    small: bool = False,
) -> str:
    """The whole page: ``title`` is plain text, ``body`` HTML; ``data`` by the ids under which ``code`` finds them;
    ``allowed`` is what a browser may do besides (a part of the page's policy). A ``small`` page carries both
    packed: a short script unpacks them."""
    begun = code
    if small:
        texts = [(key, "application/json", compact_json(one)) for key, one in data.items()]
        begun, data = UNPACK, {"code": pressed(compact_json([*texts, ("", "module", code)]))}
    held = (f'<script type="application/json" id="{key}">{embedded(one)}</script>\n' for key, one in data.items())
    parts = {
        "lang": lang,
        "policy": policy(allowed, *dict.fromkeys((begun, code))),
        "title": html.escape(title),
        "style": style,
        "body": body,
    }
    parts["kind"] = f' class="{html.escape(kind)}"' if kind else ""
    parts["scripts"] = "".join(held) + (f'<script type="module">{begun}</script>\n' if code else "")
    return filled(part("shell.html"), parts)


def policy(more: str = "", *scripts: str) -> str:
    """What a browser may do with a page: styles and pictures in it, a picture a person opens, these scripts."""
    hashes = (base64.b64encode(hashlib.sha256(one.encode()).digest()).decode() for one in scripts if one)
    listed = "".join(f" 'sha256-{one}'" for one in hashes)
    script = f"script-src{listed}; " if listed else ""
    allowed = "default-src 'none'; style-src 'unsafe-inline'; img-src data: blob:; "
    return f"{allowed}{script}{more}base-uri 'none'; form-action 'none'"


def pressed(text: str) -> str:
    """A text packed, in :data:`LETTERS`."""
    return base64.b85encode(deflated(text)).decode().translate(OURS)


def filled(template: str, parts: Mapping[str, str]) -> str:
    """The template with its places filled in one pass: what was put in is never looked at again."""
    return _PLACE.sub(lambda place: parts[place[1]], template)


def embedded(thing: object) -> str:
    """JSON with no letter in it that means something to HTML or ends a line of a script."""
    return _ACTIVE.sub(lambda match: f"\\u{ord(match[0]):04x}", compact_json(thing))


def compact_json(thing: object) -> str:
    """JSON without spaces."""
    return json.dumps(thing, ensure_ascii=False, separators=(",", ":"), allow_nan=False)


def part(*names: str) -> str:
    """Files of the pages' own folder, one after another."""
    return "".join((files("render") / "page" / name).read_text("utf-8") for name in names)
