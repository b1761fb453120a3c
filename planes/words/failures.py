"""Why a construction cannot be drawn, or contradicts itself, in Russian and in English.

Names: {makes} {start} {end} {along} {across} {other} and numbers.
"""

from __future__ import annotations

FAILURES: dict[str, tuple[str, str]] = {
    "parallel": (
        "прямые {line} и {other_line} параллельны и отстоят на {gap_mm} мм: {makes} "
        "бесконечно далеко, механизм в особом положении; измените положение ведущего звена",
        "the lines {line} and {other_line} are parallel, {gap_mm} mm apart: {makes} is infinitely far, the mechanism "
        "is at a dead point; take another position of the driver",
    ),
    "coincident": (
        "прямые {line} и {other_line} совпадают: {makes} на них не определена (0/0), механизм в точке "
        "разветвления; возьмите соседнее положение",
        "the lines {line} and {other_line} coincide: any point of them could be {makes} (0/0), the mechanism is at a "
        "change point; take a neighbouring position",
    ),
    "arc_short": (
        "дуга радиуса {radius} из {centre} не достаёт до прямой {line} на {miss_mm} мм: {makes} не построить; механизм "
        "в этом положении не собирается",
        "the arc {radius} about {centre} misses the line {line} by {miss_mm} mm: {makes} cannot be drawn; the "
        "mechanism does not assemble in this position",
    ),
    "arcs_apart": (
        "дуги {radius} из {centre} и {other_radius} из {other} не встречаются, не хватает {miss_mm} мм: {makes} не "
        "построить; механизм в этом положении не собирается",
        "the arcs {radius} about {centre} and {other_radius} about {other} are {miss_mm} mm apart: {makes} cannot be "
        "drawn; the mechanism does not assemble in this position",
    ),
    "arcs_inside": (
        "дуга {radius} из {centre} и дуга {other_radius} из {other} лежат одна внутри другой на {miss_mm} мм: "
        "{makes} не построить; механизм в этом положении не собирается",
        "of the arcs {radius} about {centre} and {other_radius} about {other} one lies inside the other by {miss_mm} "
        "mm: {makes} cannot be drawn; the mechanism does not assemble in this position",
    ),
    "arcs_coincide": (
        "дуги {radius} из {centre} и {other_radius} из {other} совпадают: {makes} на них не определена, механизм в "
        "точке разветвления; возьмите соседнее положение",
        "the arcs {radius} about {centre} and {other_radius} about {other} coincide: any point of them could be "
        "{makes}, the mechanism is at a change point; take a neighbouring position",
    ),
    "no_length": (
        "длина {radius} равна нулю: дугой из {centre} точку {makes} не построить; задайте длину звена",
        "the length {radius} is zero, so no arc about {centre} gives {makes}; give the link a length",
    ),
    "no_lengths": (
        "одна из длин {radius}, {other_radius} равна нулю: дугами точку {makes} не построить; задайте длину звена",
        "one of the lengths {radius}, {other_radius} is zero, so no arcs give {makes}; give the link a length",
    ),
    "circle_large": (
        "точка {end} ближе к {start}, чем смещение направляющей, на {miss_mm} мм: касательной для {makes:of} не "
        "провести; механизм в этом положении не собирается",
        "{end} is closer to {start} than the guide's offset, by {miss_mm} mm: no tangent for {makes} can be "
        "drawn; the mechanism does not assemble in this position",
    ),
    "points_meet": (
        "точки {start} и {end} совпали: направление {makes:of} не определено; возьмите соседнее положение",
        "{start} and {end} coincide: the direction of {makes} is not determined; take a neighbouring position",
    ),
    "self_locking": (
        "силы в {makes} с трением не уравновесить ({solutions} решений вместо одного): самоторможение; уменьшите "
        "коэффициент трения или измените положение",
        "the forces at {makes} cannot balance with friction ({solutions} solutions instead of one): self-locking; "
        "lower the coefficient of friction or take another position",
    ),
    "balance_apart": (
        "{about} по плану сил ({plan}) равно {found}, а по рычагу Жуковского {check}: расчёт себе противоречит, "
        "результаты не выданы; это ошибка программы, сообщите о ней вместе с файлом схемы",
        "{about} is {found} by the plans of forces ({plan}) and {check} by Zhukovsky's lever: the calculation "
        "contradicts itself and gives no result; this is a fault of the program, report it with the scene file",
    ),
    "polygon_open": (
        "{plan}: многоугольник {about} не замыкается на {gap} при векторах до {size} (СИ); это ошибка программы, "
        "результаты не выданы: сообщите о ней вместе с файлом схемы",
        "{plan}: the polygon {about} is open by {gap} with vectors of {size} (SI); this is a fault of the program, "
        "which gives no result: report it with the scene file",
    ),
    "link_bent": (
        "{plan}: точки звена {about} не движутся как одно тело, расхождение {gap} при величинах до {size} (СИ); это "
        "ошибка программы, результаты не выданы: сообщите о ней вместе с файлом схемы",
        "{plan}: the points of link {about} do not move as one body, by {gap} beside {size} (SI); this is a fault of "
        "the program, which gives no result: report it with the scene file",
    ),
    "slider_off": (
        "{plan}: ползун {about} сходит с направляющей, расхождение {gap} при величинах до {size} (СИ); это ошибка "
        "программы, результаты не выданы: сообщите о ней вместе с файлом схемы",
        "{plan}: slider {about} leaves its guide, by {gap} beside {size} (SI); this is a fault of the program, which "
        "gives no result: report it with the scene file",
    ),
    "link_unbalanced": (
        "{plan}: силы на звене {about} не уравновешены, остаток {gap} при силах до {size} (СИ); это ошибка программы, "
        "результаты не выданы: сообщите о ней вместе с файлом схемы",
        "{plan}: the forces on link {about} leave {gap} unbalanced beside {size} (SI); this is a fault of the program, "
        "which gives no result: report it with the scene file",
    ),
    "no_digits": ("в {makes} не осталось верных цифр", "no correct digit is left in {makes}"),
}
