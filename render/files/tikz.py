"""Lines of TikZ as a complete document, and names in LaTeX."""

import re
from collections.abc import Iterable

LATEX_GREEK = {
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
LATEX_MATH_SIGNS = {"′": "'", "·": r"\cdot ", "−": "-", "°": r"^{\circ}", "⊥": r"\perp ", "∥": r"\parallel "}
LATEX_ESCAPES = {c: f"\\{c}" for c in "&%$#_{}"} | {"\\": r"\textbackslash{}", "~": r"\textasciitilde{}", "^": r"\^{}"}
LATEX_ESCAPES |= {
    "²": r"\textsuperscript{2}",
    "¹": r"\textsuperscript{1}",
    "⁻": r"\textsuperscript{--}",
    "·": r"$\cdot$",
}
LATEX_ESCAPES |= {"−": "$-$", "°": r"\textdegree{}"}
INDEXED_NAME_PATTERN = re.compile(r"(\w+)_\{([^{}]*)\}")
NON_ASCII_PATTERN = re.compile(r"[^\x00-\x7f]+")
DOCUMENT_HEAD = r"""\documentclass[tikz, border=5mm]{standalone}
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


def tikz_document(lines: Iterable[str], title: str, lang: str) -> str:
    """The whole file."""
    said = f"% !TeX encoding = UTF-8\n% {' '.join(title.split())} ({lang})\n"
    return said + DOCUMENT_HEAD + "\n".join((*lines, r"\end{tikzpicture}", r"\end{document}", ""))


def latex_math(text: str) -> str:
    """A name with its indices, for math mode: letters unknown there become text."""

    def one(match: re.Match[str]) -> str:
        said = ""
        other = ""
        for c in match[0]:
            known = f"\\{LATEX_GREEK[c]} " if c in LATEX_GREEK else LATEX_MATH_SIGNS.get(c, "")
            said, other = (said + _latex_math_text(other) + known, "") if known else (said, other + c)
        return said + _latex_math_text(other)

    plain = text.replace("%", r"\%").replace("#", r"\#").replace("&", r"\&")
    return NON_ASCII_PATTERN.sub(one, plain).replace(" _", "_").replace(" ^", "^").strip()


def _latex_math_text(letters: str) -> str:
    return rf"\text{{{letters}}}" if letters else ""


def latex_text(text: str) -> str:
    """Words with names among them, μ_{v} = 50 mm/(m/s), as text with mathematics."""
    said = ""
    end = 0
    for name in INDEXED_NAME_PATTERN.finditer(text):
        said += _escape_latex(text[end : name.start()]) + f"${latex_math(name[0])}$"
        end = name.end()
    return said + _escape_latex(text[end:])


def _escape_latex(text: str) -> str:
    return "".join(f"${latex_math(c)}$" if c in LATEX_GREEK else LATEX_ESCAPES.get(c, c) for c in text)
