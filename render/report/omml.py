"""A formula as Word's own equation (Office MathML, ECMA-376-1 §22.1), which can be edited there."""

from typing import Any

import mathml2omml
from docx.oxml import parse_xml
from docx.oxml.ns import nsdecls

from render.report.mathml import mathml

ROOT = "<m:radPr><m:degHide m:val='1'/></m:radPr><m:deg/>"  # a square root shows no degree


def equation(tex: str) -> Any:
    """The equation, an element for a paragraph."""
    made = mathml2omml.convert(mathml(tex)).replace("<m:rad>", f"<m:rad>{ROOT}")
    return parse_xml(made.replace("<m:oMath>", f"<m:oMath {nsdecls('m')}>", 1))
