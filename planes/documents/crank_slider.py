"""The integrated calculation as documents: a scene in, a report, an object or a summary out."""

import json
import sys
from argparse import Namespace
from pathlib import Path

from planes.crank_slider.calculation import Calculation, calculate
from planes.crank_slider.pages_mechanics import scene_at_angle, worked_force_angle_deg
from planes.crank_slider.report import as_json, report_document, summary_lines
from planes.scene import Scene
from planes.scene.files import save_file_or_refuse
from planes.words import Lang, Phrase, say
from planes.words.errors import PlanesError
from render import report
from render.sheet.composer import Composer


def run(scene: Scene, args: Namespace, lang: Lang) -> int:
    """Calculate; write the report and the sheet if files are named; print the object or the summary."""
    if args.output and Path(args.output).suffix.lower() not in (*report.MODULE_OF_SUFFIX, ".json"):
        raise PlanesError(Phrase("cs_suffix", file=args.output))
    calculation = calculate(scene)
    if args.output:
        _write_calculation(calculation, Path(args.output), lang)
    if args.sheet:
        _draw_position_sheet(calculation, args.sheet, args.phi, lang)
    if args.json:
        print(json.dumps(as_json(calculation), allow_nan=False))
    elif not args.output and not args.sheet:
        print(summary_lines(calculation, lang), end="")
    return 0


def _draw_position_sheet(calculation: Calculation, path: str, phi: float | None, lang: Lang) -> None:
    """The drawing sheet of one position, with the gas force on the piston."""
    from planes.documents.drawn import draw_sheet

    low = float(calculation.motion.phi_deg[0])
    high = float(calculation.motion.phi_deg[-1])
    if phi is not None and not low <= phi <= high:
        raise PlanesError(Phrase("cs_phi", value=f"{phi:g}", low=low, high=high))
    asked = worked_force_angle_deg(calculation) if phi is None else calculation.angle(phi)
    for sentence in draw_sheet(scene_at_angle(calculation, asked), [asked], path, lang).said:
        print(say("warning", lang, of=sentence), file=sys.stderr)


def _write_calculation(calculation: Calculation, path: Path, lang: Lang) -> None:
    if path.suffix.lower() == ".json":
        save_file_or_refuse(
            (json.dumps(as_json(calculation), ensure_ascii=False, allow_nan=False) + "\n").encode(), path
        )
    else:
        save_file_or_refuse(
            report.render_document(
                report_document(calculation, lang), path.suffix.lower(), Composer(calculation.scene, lang).naming
            ),
            path,
        )
