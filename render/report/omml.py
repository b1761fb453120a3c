"""A formula as Word's own equation (Office MathML, ECMA-376-1 §22.1), which can be edited there."""

import re
from typing import Any

import mathml2omml
from docx.oxml import parse_xml
from docx.oxml.ns import nsdecls
from latex2mathml.converter import convert

FOR_WORD = {
    r"\\dfrac": r"\\frac",
    r"\\quad": r"\\quad ",
    r"(\d+)\{,\}(\d+)": r"\\text{\1,\2}",  # a number is one token
    r"\\mathrm\{": r"\\text{",
    r"\|([^|]*)\|": r"\\left|\1\\right|",  # and so is a bracketed expression
    r"(?<!\\left)[(\[]": r"\\left\g<0>",
    r"(?<!\\right)[)\]]": r"\\right\g<0>",
}
"""Patterns of our mathtext and their replacements before conversion, in this order."""
ROOT = "<m:radPr><m:degHide m:val='1'/></m:radPr><m:deg/>"  # a square root has no visible degree


def equation(tex: str) -> Any:
    """The equation, as an element of a paragraph."""
    for ours, other in FOR_WORD.items():
        tex = re.sub(ours, other, tex)
    made = mathml2omml.convert(convert(tex)).replace("<m:rad>", f"<m:rad>{ROOT}")
    return parse_xml(made.replace("<m:oMath>", f"<m:oMath {nsdecls('m')}>", 1))
