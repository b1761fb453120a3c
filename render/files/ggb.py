"""A construction -> a .ggb file of GeoGebra: a zip with geogebra.xml, where every object is a command or a formula."""

import io
import zipfile
from collections.abc import Sequence
from typing import Literal
from xml.etree import ElementTree as xml

from planes.words.frozen import frozen

Kind = Literal["numeric", "point", "vector", "line", "conic", "segment", "text"]
ZIP_TIMESTAMP = (1980, 1, 1, 0, 0, 0)
WINDOW_SIZE_PX = (1400, 800)
PX_PER_MM = 3.0
GEOGEBRA_XML_FRAME = (
    '<geogebra format="5.0" version="5.2.850.0" app="classic" platform="w"><euclidianView>'
    '<size width="{wide}" height="{high}"/>'
    '<coordSystem xZero="{x:.0f}" yZero="{y:.0f}" scale="{scale}" yscale="{scale}"/>'
    '<evSettings axes="false" grid="false" gridIsBold="false" pointCapturing="0"/></euclidianView><kernel>'
    '<continuous val="false"/><decimals val="4"/><angleUnit val="degree"/><coordStyle val="0"/></kernel></geogebra>'
)
INK_COLOUR = (0, 0, 0)
PALE_COLOUR = (150, 150, 150)
BLUE_COLOUR = (20, 60, 160)
RED_COLOUR = (180, 30, 30)


@frozen
class Aspect:
    """The appearance of an object: its caption, colour and thickness; without a colour it is hidden."""

    colour: tuple[int, int, int] | None = None
    caption: str = ""
    thick: int = 3
    dashed: bool = False


HIDDEN_ASPECT = Aspect()


class GeogebraFile:
    """A construction being written, in the order of its steps."""

    def __init__(self, title: str, corner: complex) -> None:
        x = -corner.real * PX_PER_MM
        y = corner.imag * PX_PER_MM
        self.root = xml.fromstring(
            GEOGEBRA_XML_FRAME.format(wide=WINDOW_SIZE_PX[0], high=WINDOW_SIZE_PX[1], x=x, y=y, scale=PX_PER_MM)
        )
        self.body = xml.SubElement(self.root, "construction", title=title, author="", date="")

    def add_number(self, label: str, value: float, slider: tuple[float, float] | None = None, at: complex = 0j) -> None:
        """A number; on a slider between two limits, shown ``at`` a place of the screen unless that is 0."""
        element = self._add_element("numeric", label, HIDDEN_ASPECT)
        element.insert(
            0, xml.Element("value", val=geogebra_number(value))
        )  # before it is shown, which would limit it to ±5
        if slider:
            low, high = sorted(slider)
            drawn = xml.SubElement(element, "slider", min=geogebra_number(low), max=geogebra_number(high), width="240")
            drawn.attrib |= {"absoluteScreenLocation": "true", "fixed": "true", "horizontal": "true"}
            drawn.attrib |= {"showAlgebra": "true", "x": f"{at.real:.0f}", "y": f"{at.imag:.0f}"}
            element.find("show").attrib["object"] = "true" if at else "false"  # type: ignore[union-attr]
            element.find("show").attrib["label"] = "true"  # type: ignore[union-attr]
            xml.SubElement(
                element, "animation", step=geogebra_number((high - low) / 360), speed="1", type="0", playing="false"
            )

    def add_formula(self, kind: Kind, label: str, text: str, look: Aspect = HIDDEN_ASPECT) -> None:
        """An object given by a formula."""
        typed = {} if kind == "numeric" else {"type": kind}
        xml.SubElement(self.body, "expression", {"label": label, "exp": text, **typed})
        self._add_element(kind, label, look)

    def add_command(
        self, kind: Kind, labels: Sequence[str], name: str, inputs: Sequence[str], look: Aspect = HIDDEN_ASPECT
    ) -> None:
        """The output of a GeoGebra command for its inputs."""
        made = xml.SubElement(self.body, "command", name=name)
        for tag, texts in (("input", inputs), ("output", labels)):
            xml.SubElement(made, tag, {f"a{k}": text for k, text in enumerate(texts)})
        for label in labels:
            self._add_element(kind, label, look)

    def add_caption(self, label: str, text: str, at: complex) -> None:
        """A text that starts at a place."""
        plain = text.replace('"', "")
        xml.SubElement(self.body, "expression", label=label, exp=f'"{plain}"')
        element = self._add_element("text", label, Aspect(INK_COLOUR))
        xml.SubElement(element, "startPoint", x=geogebra_number(at.real), y=geogebra_number(at.imag), z="1.0")

    def _add_element(self, kind: Kind, label: str, look: Aspect) -> xml.Element:
        element = xml.SubElement(self.body, "element", type=kind, label=label)
        shown = "true" if look.colour else "false"
        xml.SubElement(element, "show", object=shown, label="true" if look.colour and look.caption else "false")
        r, g, b = map(str, look.colour or INK_COLOUR)
        xml.SubElement(element, "objColor", r=r, g=g, b=b, alpha="0")
        xml.SubElement(element, "layer", val="0")
        if look.caption:
            xml.SubElement(element, "labelMode", val="3")  # the caption
            xml.SubElement(element, "caption", val=f"${look.caption}$")
        if kind == "point":
            xml.SubElement(element, "pointSize", val=str(look.thick))
        else:
            xml.SubElement(element, "lineStyle", thickness=str(look.thick), type="10" if look.dashed else "0")
        return element

    def zip_bytes(self) -> bytes:
        """The file as bytes; the same construction gives the same bytes."""
        data = xml.tostring(self.root, encoding="utf-8", xml_declaration=True)
        out = io.BytesIO()
        with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr(zipfile.ZipInfo("geogebra.xml", ZIP_TIMESTAMP), data, zipfile.ZIP_DEFLATED)
        return out.getvalue()


def geogebra_number(value: float) -> str:
    """A number in GeoGebra's syntax."""
    return repr(float(value)).replace("e", "E")
