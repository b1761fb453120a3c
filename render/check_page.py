"""The report of a checked drawing as one page: layers to switch, a table of steps, marks to drag; needs no server."""

from __future__ import annotations

import html
import json
from collections.abc import Mapping, Sequence
from typing import Any

STYLE = """body{font:16px/1.45 system-ui,sans-serif;margin:0 auto;max-width:1080px;padding:1rem;color:#1b1b1b}
h1{font-size:1.25rem}p.say{font-size:1.1rem;border-left:4px solid var(--c);padding:.2rem .8rem}
svg{width:100%;height:auto;border:1px solid #bbb;background:#fff;touch-action:none}
table{border-collapse:collapse;margin:1rem 0}td,th{padding:.25rem .8rem;border-bottom:1px solid #ddd;text-align:right}
td:first-child,th:first-child,td:last-child{text-align:left}
tr.wrong td{background:#fde8e6}tr.follows td{background:#fff6dd}
label{margin-right:1.2rem}.true{stroke:#1f7a3d;stroke-width:.5;stroke-dasharray:3 1.4;fill:none}
.own{stroke:#163a70;stroke-width:.7;fill:none}.next{stroke:#b26b00;stroke-width:.4;stroke-dasharray:1 1;fill:none}
circle.mark{fill:#163a7055;stroke:#163a70;stroke-width:.3;cursor:grab}circle.wrong{fill:#c0392b66;stroke:#c0392b}
text{font:4px system-ui,sans-serif}button{font:inherit;padding:.3rem .8rem}
@media (prefers-color-scheme:dark){body{background:#161616;color:#eee}td,th{border-color:#444}
tr.wrong td{background:#4a1f1b}tr.follows td{background:#453a16}}"""

SCRIPT = """const d=JSON.parse(document.getElementById('data').textContent),s=document.querySelector('svg');
const at=m=>[d.pole[0]+m[0],d.height-(d.pole[1]+m[1])];let held=null;
function place(n){const[x,y]=at(d.marks[n]);document.querySelectorAll('[data-m="'+CSS.escape(n)+'"]').forEach(e=>{
if(e.tagName=='circle'){e.setAttribute('cx',x);e.setAttribute('cy',y)}else{e.setAttribute('x',x+2);e.setAttribute('y',y-2)}});
document.querySelectorAll('[data-a="'+CSS.escape(n)+'"]').forEach(e=>{e.setAttribute('x1',x);e.setAttribute('y1',y)});
document.querySelectorAll('[data-b="'+CSS.escape(n)+'"]').forEach(e=>{e.setAttribute('x2',x);e.setAttribute('y2',y)})}
s.addEventListener('pointerdown',e=>{held=e.target.dataset&&e.target.tagName=='circle'?e.target.dataset.m:null;
if(held)s.setPointerCapture(e.pointerId)});
s.addEventListener('pointermove',e=>{if(!held)return;const p=new DOMPoint(e.clientX,e.clientY)
.matrixTransform(s.getScreenCTM().inverse());d.marks[held]=[p.x-d.pole[0],d.height-p.y-d.pole[1]];place(held)});
s.addEventListener('pointerup',()=>{held=null});
document.querySelectorAll('input[data-layer]').forEach(i=>i.addEventListener('change',()=>{
document.getElementById(i.dataset.layer).style.display=i.checked?'':'none'}));
document.getElementById('save').addEventListener('click',()=>{const t='mark,x_mm,y_mm\\np,0.00,0.00\\n'+
Object.entries(d.marks).map(([n,z])=>n+','+z[0].toFixed(2)+','+z[1].toFixed(2)).join('\\n')+'\\n';
const a=document.createElement('a');a.href=URL.createObjectURL(new Blob([t],{type:'text/csv'}));a.download='marks.csv';
a.click()});"""


def page(data: Mapping[str, Any], words: Mapping[str, str], lang: str) -> str:
    """The page. ``data`` has size, pole, marks, vectors, verdicts, rows and perhaps a picture (a data URL)."""
    colour = {"right": "#1f7a3d", "wrong": "#c0392b"}.get(str(data["verdict"]), "#777")
    e = html.escape
    return f"""<!doctype html>
<html lang="{lang}"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width,initial-scale=1">
<title>{e(words["title"])}</title><style>{STYLE}</style></head><body style="--c:{colour}">
<h1>{e(words["title"])}</h1><p class="say">{e(words["sentence"])}</p>
<p>{_switches(words, "picture" in data)}</p>
{_drawing(data)}
<p><button id="save">{e(words["save"])}</button> {e(words["drag"])}</p>
{_table(data["head"], data["rows"])}{_table(data["number_head"], data["numbers"])}
{"".join(f"<p>{e(n)}</p>" for n in data["notes"])}
<script type="application/json" id="data">{_json(data)}</script><script>{SCRIPT}</script></body></html>
"""


def _json(data: Mapping[str, Any]) -> str:
    kept = {"pole": data["pole"], "height": data["size"][1], "marks": data["marks"]}
    return json.dumps(kept, ensure_ascii=False).replace("<", "\\u003c")


def _switches(words: Mapping[str, str], picture: bool) -> str:
    layers = [("own", True), ("next", True), ("true", True)] + ([("picture", True)] if picture else [])
    return "".join(f'<label><input type="checkbox" data-layer="{n}" checked>{html.escape(words[n])}</label>'
                   for n, _ in layers)  # fmt: skip


def _drawing(data: Mapping[str, Any]) -> str:
    """The drawing with its layers."""
    w, h = data["size"]
    out = [f'<svg viewBox="0 0 {w} {h}" role="img">']
    if "picture" in data:
        out.append(f'<image id="picture" href="{data["picture"]}" x="0" y="0" width="{w}" height="{h}" '
                   'preserveAspectRatio="none" opacity=".8"/>')  # fmt: skip
    for layer in ("true", "next"):
        lines = "".join(_line(data, a, b, layer) for a, b in data[layer])
        out.append(f'<g id="{layer}">{lines}</g>')
    own = "".join(_between(data, a, b) for a, b in data["vectors"])
    for name, z in data["marks"].items():
        x, y = _xy(data, z)
        kind = "mark wrong" if data["verdicts"].get(name) == "wrong" else "mark"
        safe = html.escape(name, quote=True)
        own += f'<circle class="{kind}" r="2" cx="{x:.2f}" cy="{y:.2f}" data-m="{safe}"/>'
        own += f'<text x="{x + 2:.2f}" y="{y - 2:.2f}" data-m="{safe}">{safe}</text>'
    out.append(f'<g id="own">{own}</g></svg>')
    return "".join(out)


def _xy(data: Mapping[str, Any], z: Sequence[float]) -> tuple[float, float]:
    return data["pole"][0] + z[0], data["size"][1] - (data["pole"][1] + z[1])


def _line(data: Mapping[str, Any], a: Sequence[float], b: Sequence[float], kind: str) -> str:
    (x1, y1), (x2, y2) = _xy(data, a), _xy(data, b)
    return f'<line class="{kind}" x1="{x1:.2f}" y1="{y1:.2f}" x2="{x2:.2f}" y2="{y2:.2f}"/>'


def _between(data: Mapping[str, Any], one: str, two: str) -> str:
    """A vector between two named marks, which moves with them."""
    marks = {"p": [0.0, 0.0], **data["marks"]}
    line = _line(data, marks[one], marks[two], "own")
    names = f' data-a="{html.escape(one, quote=True)}" data-b="{html.escape(two, quote=True)}"/>'
    return line.replace("/>", names)


def _table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A table whose last column but one says the verdict's class."""
    if not rows:
        return ""
    cells = "".join(f"<th>{html.escape(h)}</th>" for h in head)
    body = ""
    for verdict, *row in rows:
        body += f'<tr class="{html.escape(verdict)}">' + "".join(f"<td>{html.escape(c)}</td>" for c in row) + "</tr>"
    return f"<table><tr>{cells}</tr>{body}</table>"
