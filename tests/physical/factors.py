"""The factors of the rows: each as the fields of a setting that it changes."""

from __future__ import annotations

from tests.physical.setting import Spread

PHONE: Spread = {"camera": "phone", "noise": 3.0, "quality": 80, "turn_deg": (-4.0, 4.0), "tilt_deg": (2.0, 8.0)}
HARD: Spread = {
    **PHONE,
    "tilt_deg": (8.0, 18.0),
    "lens": (-0.04, 0.04),
    "lamp": (0.2, 0.5),
    "shadow": [0.0, 0.35],
    "motion_px": (0.0, 3.0),
    "width_px": [1280, 2000],
    "quality": 60,
}
ASIDE: Spread = {**PHONE, "tilt_deg": (3.0, 14.0)}  # a careless photograph at an angle
PAPERS = [(244, 247, 248), (214, 234, 241), (222, 224, 222)]  # white, cream, grey
FRAME: Spread = {"sheet": "frame", "pole_told": True}
POINTS: Spread = {"sheet": "paper", "pole_told": True}
PEOPLE: Spread = {
    "tool": ["pencil", "pencil", "pencil", "pen"],
    "press": (0.65, 1.1),
    "wander": (0.05, 0.18),
    "fade_mm": (2.0, 10.0),
    "fade_to": (0.5, 0.9),
    "tremor_mm": (0.03, 0.12),
    "bow_mm": (0.0, 0.2),
    "over_mm": (5.0, 25.0),
    "over_share": [0.0, 0.4, 0.7, 1.0],
    "twice": [0.0, 0.0, 0.3],
    "heads": ["filled", "barbs", "barbs"],
    "rubbed": [0, 1, 2],
    "smudges": [0, 0, 2],
    "letters": ["neat", "wild"],
    "tint": PAPERS,
    "turn_deg": (-1.5, 1.5),
}
EXTRAS: Spread = {"title_block": [False, True], "table": [False, True], "name": True, "second_plan": [False, True]}

FACTORS: dict[str, Spread] = {
    "base": {},
    "pen": {"tool": "pen"},
    "light .6": {"press": 0.6},
    "light .45": {"press": 0.45},
    "uneven pressure": {"wander": 0.22},
    "fade 8 mm": {"fade_mm": 8.0, "fade_to": 0.5},
    "fade 15 mm": {"fade_mm": 15.0, "fade_to": 0.35},
    "rough paper": {"tooth": 1.4},
    "tinted paper": {"tint": PAPERS[1:]},
    "tremor": {"tremor_mm": 0.15},
    "bow": {"bow_mm": 0.35},
    "overshoot 12 mm": {"over_mm": 12.0, "over_share": 1.0},
    "overshoot 25 mm": {"over_mm": 25.0, "over_share": 1.0},
    "drawn twice": {"twice": 1.0},
    "barbs": {"heads": "barbs"},
    "no heads": {"heads": "none"},
    "dots": {"dots": True},
    "rubbed out": {"rubbed": 4},
    "smudges": {"smudges": 6},
    "wild letters": {"letters": "wild"},
    "names with indices": {"letters": "indices"},
    "printed at 98.5 %": {"print_scale": 0.985},
    "printed at 97 %": {"print_scale": 0.97},
    "table, names": {"table": True, "name": True},
    "second plan": {"second_plan": True},
    "stamp": {"stamp": True},
    "scan 150": {"dpi": 150.0},
    "scan 300": {"dpi": 300.0},
    "scan askew 2°": {"turn_deg": 2.0},
    "quarter turns": {"quarter": [1, 2, 3]},
    "phone": PHONE,
    "phone, tilt 17°": {**PHONE, "tilt_deg": 17.0},
    "phone, lens": {**PHONE, "lens": [-0.06, 0.06]},
    "phone, lamp": {**PHONE, "lamp": 0.5},
    "phone, shadow": {**PHONE, "shadow": 0.4},
    "phone, motion": {**PHONE, "motion_px": 4.0},
    "phone, 1280 px": {**PHONE, "width_px": 1280},
    "phone, JPEG 40": {**PHONE, "quality": 40},
    "frame": FRAME,
    "frame, pole guessed": {"sheet": "frame"},
    "frame, title block": {**FRAME, "title_block": True},
    "points": POINTS,
    "points, askew 1°": {**POINTS, "turn_deg": 1.0},
    "points, askew 2°": {**POINTS, "turn_deg": 2.0},
    "points, squared": {**POINTS, "grid": "squared"},
    "points, millimetre": {**POINTS, "grid": "millimetre"},
    "points, ruled": {**POINTS, "grid": "ruled"},
    "points, phone": {**POINTS, **PHONE},
    "together: scan": {**PEOPLE, "dpi": [150.0, 200.0, 300.0], "name": [False, True]},
    "together: phone": {**PEOPLE, **HARD, "name": [False, True]},
    "together: frame": {**PEOPLE, **EXTRAS, **FRAME},
    "together: paper": {**PEOPLE, **EXTRAS, **POINTS, "grid": ["", "squared", "millimetre", "ruled"]},
    "points, phone, squared": {**POINTS, **ASIDE, "grid": "squared"},
    "points, phone, ruled": {**POINTS, **ASIDE, "grid": "ruled"},
    "points, phone, edges": {**POINTS, **ASIDE},
    "points, phone, no edges": {**POINTS, **ASIDE, "close": True},
    "points, phone, text": {**POINTS, **ASIDE, "close": True, "text": ["printed", "written", "form"]},
}
HELD: dict[str, Spread] = {  # never used for tuning: counted once, at the end, by the word "held"
    "folded": {"crease": 0.25},
    "curled, phone": {**PHONE, "curl_mm": 5.0},
    "cup's ring": {"cup": True},
    "photocopy": {"copied": True},
    "pen that skips": {"tool": "pen", "skipping": 0.12},
    "coloured pencil": {"ink": [(60, 60, 200), (190, 90, 50), (70, 140, 60)]},
    "script letters": {"letters": "script"},
    "hard pencil": {"width_mm": 0.25, "press": 0.75},
    "green lamp, tinted": {**PHONE, "tint": (214, 240, 226), "lamp": 0.35},
    "held together": {**PEOPLE, **HARD, "letters": "script", "crease": 0.15, "table": True, "print_scale": (0.96, 1.0)},
}


HELD_NEXT: dict[str, Spread] = {  # invented after the last correction, counted once, by the words "held next"
    "blunt pencil": {"width_mm": 0.8, "press": 0.8},
    "dim light, phone": {**PHONE, "noise": 11.0, "blur_px": 1.3},
    "thumb on a corner": {**PHONE, "thumb": True},
    "teacher's ticks": {"ticked": True},
    "flickering lamp": {**PHONE, "banding": 0.12},
}
