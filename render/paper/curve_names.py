"""Curves over the cycle as they are lettered: vq_C -> v_{qC}, u_31 -> u_{31}, F_21_x -> F_{21x}, r_C_y -> y_{C}."""

from __future__ import annotations

from render.paper.names import Naming, rate_of


def lettered_curve(name: str, naming: Naming) -> str:
    """A curve's name with its index lowered: a letter, then _{…}."""
    head, _, index = name.partition("_")
    index, _, axis = index.partition("_")
    if head == "r":
        return f"{axis or 'r'}_{{{index}}}"
    if head == "u":
        return f"u_{{{index}{',' + axis if axis else ''}}}"
    if head in ("M", "MZ", "Fb", "FbZ"):
        return naming.balancing(head.startswith("M")) + ("^{Ж}" if head.endswith("Z") else "")
    if head == "F":
        return _reaction(name, naming)
    if head == "coriolis":
        return f"a^{{k}}_{{{index}{axis}}}"
    if index == "slide":
        index, _, axis = axis.partition("_")
    letter, analogue = rate_of(head)
    return f"{letter}_{{{analogue}{index}{axis}}}"


def _reaction(name: str, naming: Naming) -> str:
    """F_21, F_11_10, F_21_x, F_50_arm, F_50_moment."""
    *links, last = name.split("_")[1:]
    if last not in ("x", "y", "arm", "moment"):
        links, last = [*links, last], ""
    shown = naming.reaction("_".join(links))
    letter = {"arm": "h", "moment": "M"}.get(last, "F")
    return f"{letter}_{{{shown}{last if last in ('x', 'y') else ''}}}"
