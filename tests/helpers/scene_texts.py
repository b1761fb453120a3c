"""Basic scene files of the tests of floor 2."""

SIX_LINK = """\
planes: 1
title: Шестизвенный рычажный механизм        # or {ru: ..., en: ...}
parameters: {l_AB: 0.1, l_BC: 0.3, phi_1: 150} # SI; angles in degrees
variants:                                     # each overrides parameters
  А: {phi_1: 160}
frame:
  points: {A: [0, 0], D: [-0.35, -0.27]}
  guides: {y-y: {x: -0.42}}                   # or {y: ...}, or {through: [x, y] | POINT, angle: 30}
links:
  1: {points: {A: 0, B: l_AB}, mass: 60, inertia: 5}       # centre: defaults to the first point
  2: {points: {B: 0, C: l_BC, S2: 0.2, N: [0.1, 0.05], Q: {r: 0.2, angle: 30}},
      guides: {CL: {through: C, angle: -90}}, centre: S2, mass: 40, inertia: 2}
  3: {points: {D: 0, C: 0.15}, mass: 70, inertia: 0.5}
  4: {points: {H: 0}, slides: CL}
  5: {points: {H: 0}, slides: y-y, mass: 50}
assembly: {C: right}                          # or {C: {near: [x, y]}}
drive: {link: 1, phi: phi_1, omega: -20, epsilon: 80}
loads:
  - {link: 5, point: H, force: 6000, against: motion}   # or along: motion, or direction: 90
  - {link: 3, moment: 45, against: motion}              # or a signed value, + counter-clockwise
gravity: 9.81                                 # downwards; 0 if left out
friction: {y-y: 0.15}                         # coefficient in a sliding pair
plans:                                        # all optional; "auto" picks a standard μ
  position: {mu: 250 mm/m}
  velocity: {mu: 30 mm/(m/s)}
  acceleration: {mu: 2 mm/(m/s²)}
  force: {mu: 0.01 mm/N}
find: [v_C, a_H, omega_2, F_21, M_1]          # optional: only what leads to these is built
"""

VECTORS = """\
planes: 1
vectors:
  v_B:  {value: 2, direction: 120}
  v_CB: {direction: 35}
  v_C:  {direction: 80}
equations: ["v_C = v_B + v_CB"]
mu: 30 mm/(m/s)
"""


def changed(old: str, new: str, text: str = SIX_LINK) -> str:
    assert old in text
    return text.replace(old, new, 1)
