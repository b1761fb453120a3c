"""Sheets submitted by a class: a printed page, a plan drawn on it by a steady hand, scanned slightly askew."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pypdfium2

from planes.check.blank import blank_pole
from planes.check.fiducials import SHEET_MM
from planes.check.grading.prepared_plan import Asked, prepare
from planes.check.report.shown import vector_end_labels
from planes.scene import Scene
from planes.words.names import POLE_LABEL, PlanId

DPI = 200
PX = DPI / 25.4
PENCIL, WIDE_MM, HEAD_MM = 70, 0.45, 3.6
SHIFT = 4  # fractional bits of a coordinate
Marks = Mapping[str, complex]


def printed(pdf: Path, page: int = 0) -> Any:
    """A page of a PDF in grey."""
    with pypdfium2.PdfDocument(pdf) as document:
        shown = document[page].render(scale=DPI / 72).to_numpy()
    return cv2.cvtColor(shown[..., :3], cv2.COLOR_BGR2GRAY)


def drawn(
    sheet: Any, scene: Scene, plan: PlanId, wrong: Callable[[dict[str, complex]], Marks] = lambda right: right
) -> Any:
    """The plan on its blank, its marks changed by ``wrong`` if given."""
    bench = prepare(Asked(scene, plan))
    places, pole, out = {POLE_LABEL: 0j, **wrong(dict(bench.true_marks))}, blank_pole(bench), sheet.copy()
    for a, b in vector_end_labels(bench):
        if abs(places[b] - places[a]) > 1:
            _arrow(out, places[a] + pole, places[b] + pole)
    return out


def _arrow(out: Any, a: complex, b: complex) -> None:
    """A vector with its head, mm of the sheet."""
    along = (b - a) / abs(b - a)
    corners = [b, b - HEAD_MM * along * complex(1, 0.18), b - HEAD_MM * along * complex(1, -0.18)]
    cv2.line(out, _px(out, a), _px(out, b), PENCIL, round(WIDE_MM * PX), cv2.LINE_AA, SHIFT)
    cv2.fillPoly(out, [np.array([_px(out, z) for z in corners], np.int32)], PENCIL, cv2.LINE_AA, SHIFT)


def _px(out: Any, z: complex) -> tuple[int, int]:
    scale = out.shape[1] / SHEET_MM[0] * (1 << SHIFT)
    return round(z.real * scale), round((SHEET_MM[1] - z.imag) * scale)


def scanned(sheet: Any, askew_deg: float = 0.6, seed: int = 1) -> Any:
    """As scanned: slightly askew, soft, with grain."""
    h, w = sheet.shape
    turn = cv2.getRotationMatrix2D((w / 2, h / 2), askew_deg, 0.985)
    seen = cv2.warpAffine(sheet, turn, (w, h), flags=cv2.INTER_CUBIC, borderValue=245)
    grain = np.random.default_rng(seed).normal(0, 3, seen.shape)
    return np.clip(cv2.GaussianBlur(seen, (0, 0), 0.7) * 0.97 + grain, 0, 255).astype(np.uint8)
