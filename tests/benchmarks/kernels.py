"""What a person would write by hand for one mechanism and compile with numba: the limit the general program is
measured against. Each kernel writes the columns named in its ``…_NAMES``, in SI.
"""

from __future__ import annotations

import math

from numba import njit

FOUR_BAR_NAMES = ["r_B", "v_B", "a_B", "r_C", "v_C", "a_C", "omega_2", "omega_3", "epsilon_2", "epsilon_3"]
SIX_LINK_NAMES = [
    *(f"{letter}_{p}" for p in ("B", "C", "S2", "H") for letter in "rva"),
    "omega_2",
    "omega_3",
    "epsilon_2",
    "epsilon_3",
    "v_slide_4",
    "a_slide_4",
    "coriolis_4",
    "F_21",
    "F_30",
    "F_32",
    "F_42",
    "F_54",
    "F_50",
    "F_10",
    "M_1",
    "MZ_1",
]


@njit(error_model="numpy")
def four_bar(phis, out, r, l2, l3, dx, dy, side, omega, epsilon):
    for i in range(phis.shape[0]):
        angle = phis[i] * (math.pi / 180)
        bx, by = r * math.cos(angle), r * math.sin(angle)
        ex, ey = dx - bx, dy - by
        apart2 = ex * ex + ey * ey
        along = (apart2 + l2 * l2 - l3 * l3) / (2 * apart2)
        high = side * math.sqrt(l2 * l2 / apart2 - along * along)
        px, py = ex * along - ey * high, ey * along + ex * high
        qx, qy = px - ex, py - ey
        vx, vy = -omega * by, omega * bx
        ax, ay = -epsilon * by - omega * omega * bx, epsilon * bx - omega * omega * by
        over = 1 / (px * qy - py * qx)
        w2, w3 = -(vx * qx + vy * qy) * over, -(vx * px + vy * py) * over
        sx = ax - w2 * w2 * px + w3 * w3 * qx
        sy = ay - w2 * w2 * py + w3 * w3 * qy
        e2, e3 = -(sx * qx + sy * qy) * over, -(sx * px + sy * py) * over
        out[0, i], out[1, i], out[2, i], out[3, i], out[4, i], out[5, i] = bx, by, vx, vy, ax, ay
        out[6, i], out[7, i] = bx + px, by + py
        out[8, i], out[9, i] = -w3 * qy, w3 * qx
        out[10, i], out[11, i] = -e3 * qy - w3 * w3 * qx, e3 * qx - w3 * w3 * qy
        out[12, i], out[13, i], out[14, i], out[15, i] = w2, w3, e2, e3


SLIDER_CRANK_NAMES = ["r_B", "v_B", "a_B", "r_C", "v_C", "a_C", "omega_2", "epsilon_2"]
SLOTTED_NAMES = ["omega_3", "epsilon_3", "v_slide_2", "a_slide_2"]


@njit(error_model="numpy")
def slider_crank(phis, out, r, l2, gx, gy, ux, uy, side, omega, epsilon):
    """The slider's hinge on the guide through (gx, gy) along the unit (ux, uy)."""
    for i in range(phis.shape[0]):
        angle = phis[i] * (math.pi / 180)
        bx, by = r * math.cos(angle), r * math.sin(angle)
        dx, dy = bx - gx, by - gy
        foot, off = dx * ux + dy * uy, ux * dy - uy * dx
        reach = side * math.sqrt((l2 - off) * (l2 + off))
        cx, cy = gx + (foot + reach) * ux, gy + (foot + reach) * uy
        px, py = cx - bx, cy - by
        vx, vy = -omega * by, omega * bx
        ax, ay = -epsilon * by - omega * omega * bx, epsilon * bx - omega * omega * by
        over = 1 / (px * ux + py * uy)
        w2 = -(ux * vy - uy * vx) * over
        vc = (vx - w2 * py) * ux + (vy + w2 * px) * uy
        sx, sy = ax - w2 * w2 * px, ay - w2 * w2 * py
        e2 = -(ux * sy - uy * sx) * over
        ac = (sx - e2 * py) * ux + (sy + e2 * px) * uy
        out[0, i], out[1, i], out[2, i], out[3, i], out[4, i], out[5, i] = bx, by, vx, vy, ax, ay
        out[6, i], out[7, i], out[8, i], out[9, i] = cx, cy, vc * ux, vc * uy
        out[10, i], out[11, i], out[12, i], out[13, i] = ac * ux, ac * uy, w2, e2


@njit(error_model="numpy")
def slotted_lever(phis, out, r, dx, dy, omega, epsilon):
    """A slot through the hinge (dx, dy), the crank's pin in it; the slot's sense is from the hinge to the pin."""
    for i in range(phis.shape[0]):
        angle = phis[i] * (math.pi / 180)
        bx, by = r * math.cos(angle), r * math.sin(angle)
        px, py = bx - dx, by - dy
        over = 1 / math.sqrt(px * px + py * py)
        ux, uy = px * over, py * over
        vx, vy = -omega * by, omega * bx
        ax, ay = -epsilon * by - omega * omega * bx, epsilon * bx - omega * omega * by
        w = (ux * vy - uy * vx) * over
        vr = vx * ux + vy * uy
        ar = ax * ux + ay * uy + w * w / over
        e = ((ux * ay - uy * ax) - 2 * w * vr) * over
        out[0, i], out[1, i], out[2, i], out[3, i] = w, e, vr, ar


TANGENT_NAMES = ["r_K", "v_K", "a_K", "r_B", "v_B", "a_B"]


@njit(error_model="numpy")
def tangent(phis, out, r, bent, gx, gy, ux, uy, omega, epsilon):
    """A lever's rod through K, ``bent`` from the lever, crosses the guide through (gx, gy) along the unit (ux, uy)."""
    for i in range(phis.shape[0]):
        angle, rod = phis[i] * (math.pi / 180), (phis[i] + bent) * (math.pi / 180)
        kx, ky, wx, wy = r * math.cos(angle), r * math.sin(angle), math.cos(rod), math.sin(rod)
        vx, vy = -omega * ky, omega * kx
        ax, ay = -epsilon * ky - omega * omega * kx, epsilon * kx - omega * omega * ky
        over = 1 / (wx * uy - wy * ux)
        along = ((gx - kx) * uy - (gy - ky) * ux) * over
        v = (wx * vy - wy * vx + along * omega) * over
        slide = (v * ux - vx) * wx + (v * uy - vy) * wy
        a = (wx * ay - wy * ax + 2 * slide * omega + along * epsilon) * over
        out[0, i], out[1, i], out[2, i], out[3, i], out[4, i], out[5, i] = kx, ky, vx, vy, ax, ay
        out[6, i], out[7, i] = kx + along * wx, ky + along * wy
        out[8, i], out[9, i], out[10, i], out[11, i] = v * ux, v * uy, a * ux, a * uy


@njit(error_model="numpy")
def six_link(phis, out, r, l2, l3, dx, dy, side, s2, x5, omega, epsilon, m1, j1, m2, j2, m3, j3, m5, load, g):
    for i in range(phis.shape[0]):
        angle = phis[i] * (math.pi / 180)
        b = complex(r * math.cos(angle), r * math.sin(angle))
        e = complex(dx, dy) - b
        apart2 = e.real * e.real + e.imag * e.imag
        along = (apart2 + l2 * l2 - l3 * l3) / (2 * apart2)
        high = side * math.sqrt(l2 * l2 / apart2 - along * along)
        p = complex(e.real * along - e.imag * high, e.imag * along + e.real * high)
        q = p - e
        v = complex(-omega * b.imag, omega * b.real)
        a = complex(-epsilon * b.imag - omega * omega * b.real, epsilon * b.real - omega * omega * b.imag)
        over = 1 / (p.real * q.imag - p.imag * q.real)
        w2, w3 = -(v.real * q.real + v.imag * q.imag) * over, -(v.real * p.real + v.imag * p.imag) * over
        s = a - w2 * w2 * p + w3 * w3 * q
        e2, e3 = -(s.real * q.real + s.imag * q.imag) * over, -(s.real * p.real + s.imag * p.imag) * over
        c, u2, u3 = b + p, p / l2, q / l3
        vc = complex(-w3 * q.imag, w3 * q.real)
        ac = complex(-e3 * q.imag, e3 * q.real) - w3 * w3 * q
        gx, gy = u2.imag, -u2.real
        t = (x5 - c.real) / gx
        h = complex(x5, c.imag + t * gy)
        arm = h - c
        vl = vc + complex(-w2 * arm.imag, w2 * arm.real)
        al = ac + complex(-e2 * arm.imag, e2 * arm.real) - w2 * w2 * arm
        vr = -vl.real / gx
        vh = vl.imag + vr * gy
        cor = complex(-2 * w2 * vr * gy, 2 * w2 * vr * gx)
        ar = -(al.real + cor.real) / gx
        ah = al.imag + cor.imag + ar * gy
        k = s2 / l2
        rs, vs, as2 = b + k * p, v + k * (vc - v), a + k * (ac - a)
        y5 = -m5 * g - m5 * ah - math.copysign(load, vh)
        f42 = -y5 / u2.imag
        f50 = -f42 * u2.real
        lever = rs - c
        wx, wy = -m2 * as2.real, -m2 * as2.imag - m2 * g
        turn2 = lever.real * wy - lever.imag * wx - j2 * e2
        turn2 += -f42 * (arm.real * u2.imag - arm.imag * u2.real)
        t2, t3 = turn2 / l2, (-q.real * -m3 * g - j3 * e3) / l3
        sx = wx - f42 * u2.real - t2 * u2.imag - t3 * u3.imag
        sy = wy - f42 * u2.imag - m3 * g + t2 * u2.real + t3 * u3.real
        cut = 1 / (u2.real * u3.imag - u2.imag * u3.real)
        n2, n3 = -(sx * u3.imag - sy * u3.real) * cut, -(u2.real * sy - u2.imag * sx) * cut
        f21 = complex(-t2 * u2.imag + n2 * u2.real, t2 * u2.real + n2 * u2.imag)
        f30 = complex(-t3 * u3.imag + n3 * u3.real, t3 * u3.real + n3 * u3.imag)
        moment = b.real * f21.imag - b.imag * f21.real + j1 * epsilon
        power = wx * vs.real + wy * vs.imag - j2 * e2 * w2 - j3 * e3 * w3 + y5 * vh - j1 * epsilon * omega
        out[0, i], out[1, i], out[2, i], out[3, i] = b.real, b.imag, v.real, v.imag
        out[4, i], out[5, i] = a.real, a.imag
        out[6, i], out[7, i], out[8, i], out[9, i] = c.real, c.imag, vc.real, vc.imag
        out[10, i], out[11, i], out[12, i], out[13, i] = ac.real, ac.imag, rs.real, rs.imag
        out[14, i], out[15, i], out[16, i], out[17, i] = vs.real, vs.imag, as2.real, as2.imag
        out[18, i], out[19, i], out[20, i], out[21, i], out[22, i], out[23, i] = h.real, h.imag, 0.0, vh, 0.0, ah
        out[24, i], out[25, i], out[26, i], out[27, i], out[28, i], out[29, i] = w2, w3, e2, e3, vr, ar
        out[30, i], out[31, i], out[32, i], out[33, i] = cor.real, cor.imag, f21.real, f21.imag
        out[34, i], out[35, i], out[36, i], out[37, i] = f30.real, f30.imag, -f30.real, -(f30.imag - m3 * g)
        out[38, i], out[39, i], out[40, i], out[41, i] = f42 * u2.real, f42 * u2.imag, 0.0, 0.0
        out[42, i], out[43, i], out[44, i], out[45, i] = f42 * u2.real, f42 * u2.imag, f50, 0.0
        out[46, i], out[47, i], out[48, i], out[49, i] = 0.0, 0.0, f21.real, f21.imag + m1 * g
        out[50, i], out[51, i] = moment, -power / omega
