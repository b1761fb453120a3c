"""Pages of the documentation that hold what benchmarks measured."""

from tests.helpers import ROOT


def put(page: str, name: str, text: str, apart: str = "\n\n") -> None:
    """A text into a page, between its marks, ``apart`` from them."""
    path = ROOT / page
    begin, end = f"<!-- {name} -->", f"<!-- end of {name} -->"
    before, rest = path.read_text("utf-8").split(begin)
    path.write_text(f"{before}{begin}{apart}{text}{apart}{end}{rest.split(end)[1]}", "utf-8")
