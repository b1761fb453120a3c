"""A formula as MathML, which browsers show by themselves and Word's own equations are made of."""

import re

from latex2mathml.converter import convert

CONVERTER_SPELLINGS = {
    r"\\dfrac": r"\\frac",
    r"\\quad": r"\\quad ",
    r"(\d+)\{,\}(\d+)": r"\\text{\1,\2}",  # a number is one token
    r"\|([^|]*)\|": r"\\left|\1\\right|",  # and so is a bracketed expression
    r"(?<!\\left)[(\[]": r"\\left\g<0>",
    r"(?<!\\right)[)\]]": r"\\right\g<0>",
    r"^(?=[-=+])": "{}",  # a sign that begins a piece stands between two
}
"""Patterns of our mathtext and their form for the converter, in this order."""
UPRIGHT_TEXT_PATTERN = re.compile(r"\\mathrm\{([^{}]*)\}")


def formula_as_mathml(tex: str) -> str:
    """The formula, its fractions at full size."""
    for ours, other in CONVERTER_SPELLINGS.items():
        tex = re.sub(ours, other, tex)
    tex = UPRIGHT_TEXT_PATTERN.sub(
        lambda words: rf"\text{{{words[1].replace(chr(92), '')}}}", tex
    )  # its spaces need no mark
    numbers = re.sub(r"<mtext>([\d,]+)</mtext>", r"<mn>\1</mn>", convert(tex))
    return numbers.replace("<math ", '<math displaystyle="true" ', 1)
