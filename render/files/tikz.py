"""Lines of TikZ as a complete document, and names in LaTeX."""

import re
from collections.abc import Iterable

GREEK = {
    "α": "alpha",
    "β": "beta",
    "ε": "varepsilon",
    "λ": "lambda",
    "μ": "mu",
    "π": "pi",
    "ρ": "rho",
    "τ": "tau",
    "φ": "varphi",
    "ψ": "psi",
    "ω": "omega",
    "Φ": "Phi",
    "Ω": "Omega",
}
SIGNS = {"′": "'", "·": r"\cdot ", "−": "-", "°": r"^{\circ}", "⊥": r"\perp ", "∥": r"\parallel "}
SPECIAL = {c: f"\\{c}" for c in "&%$#_{}"} | {"\\": r"\textbackslash{}", "~": r"\textasciitilde{}", "^": r"\^{}"}
SPECIAL |= {"²": r"\textsuperscript{2}", "¹": r"\textsuperscript{1}", "⁻": r"\textsuperscript{--}", "·": r"$\cdot$"}
SPECIAL |= {"−": "$-$", "°": r"\textdegree{}"}
LOWERED = re.compile(r"(\w+)_\{([^{}]*)\}")
OTHER = re.compile(r"[^\x00-\x7f]+")
HEAD = r"""\documentclass[tikz, border=5mm]{standalone}
\usepackage{amsmath, iftex}
\ifPDFTeX
  \usepackage[T2A]{fontenc}
  \usepackage[utf8]{inputenc}
\else
  \usepackage{fontspec}
  \IfFontExistsTF{CMU Serif}{\setmainfont{CMU Serif}}{}
\fi
\usetikzlibrary{arrows.meta}
\begin{document}
\begin{tikzpicture}[x=1mm, y=1mm, >={Stealth[length=2.5mm]},
  link/.style={line width=0.6mm}, action/.style={gray, thin, dashed, shorten >=-6mm, shorten <=-3mm},
  whole/.style={->, line width=0.4mm, red!70!black}, part/.style={->, line width=0.3mm, blue!60!black},
  hinge/.style={circle, draw, fill=white, inner sep=0.7mm}, dot/.style={circle, fill, inner sep=0.3mm}]
"""


def document(lines: Iterable[str], title: str, lang: str) -> str:
    """The whole file."""
    said = f"% !TeX encoding = UTF-8\n% {' '.join(title.split())} ({lang})\n"
    return said + HEAD + "\n".join((*lines, r"\end{tikzpicture}", r"\end{document}", ""))


def in_math(text: str) -> str:
    """A name with its indices, for math mode: letters unknown there become text."""

    def one(match: re.Match[str]) -> str:
        said, other = "", ""
        for c in match[0]:
            known = f"\\{GREEK[c]} " if c in GREEK else SIGNS.get(c, "")
            said, other = (said + _text(other) + known, "") if known else (said, other + c)
        return said + _text(other)

    plain = text.replace("%", r"\%").replace("#", r"\#").replace("&", r"\&")
    return OTHER.sub(one, plain).replace(" _", "_").replace(" ^", "^").strip()


def _text(letters: str) -> str:
    return rf"\text{{{letters}}}" if letters else ""


def in_text(text: str) -> str:
    """Words with names among them, μ_{v} = 50 mm/(m/s), as text with mathematics."""
    said, end = "", 0
    for name in LOWERED.finditer(text):
        said += _escaped(text[end : name.start()]) + f"${in_math(name[0])}$"
        end = name.end()
    return said + _escaped(text[end:])


def _escaped(text: str) -> str:
    return "".join(f"${in_math(c)}$" if c in GREEK else SPECIAL.get(c, c) for c in text)
