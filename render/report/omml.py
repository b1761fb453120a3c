"""A formula as Word's own equation (Office MathML, ECMA-376-1 §22.1), which can be edited there."""

from typing import Any

import mathml2omml
from docx.oxml import parse_xml
from docx.oxml.ns import nsdecls

from render.report.mathml import formula_as_mathml

HIDDEN_ROOT_DEGREE = "<m:radPr><m:degHide m:val='1'/></m:radPr><m:deg/>"  # a square root shows no degree


def word_equation(tex: str) -> Any:
    """The equation, an element for a paragraph."""
    made = mathml2omml.convert(formula_as_mathml(tex)).replace("<m:rad>", f"<m:rad>{HIDDEN_ROOT_DEGREE}")
    return parse_xml(made.replace("<m:oMath>", f"<m:oMath {nsdecls('m')}>", 1))
