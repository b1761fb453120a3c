"""Words of the lesson and the note: one sentence for each kind of step, in Russian and in English.

Names in ⟨…⟩ are marks, vectors or values; who shows the sentence letters them (v_CB with its index lowered).
"""

from __future__ import annotations

LESSON: dict[str, tuple[str, str]] = {
    "fixed": (
        "Наносим неподвижные точки и направляющие: {names}. Масштаб {mu}: отрезок на чертеже = длина · μ.",
        "Put the fixed points and guides: {names}. The scale is {mu}: a segment on paper is the length times μ.",
    ),
    "pole": ("Выбираем полюс ⟨{end}⟩ и масштаб {mu}.", "Choose the pole ⟨{end}⟩ and the scale {mu}."),
    "driver": (
        "Ведущее звено в заданном положении: от ⟨{start}⟩ откладываем ⟨{length}⟩ = {value} {unit}, это {mm} мм, и "
        "получаем ⟨{end}⟩.",
        "The driver in its given position: from ⟨{start}⟩ lay off ⟨{length}⟩ = {value} {unit}, that is {mm} mm, to "
        "⟨{end}⟩.",
    ),
    "along": (
        "Вдоль звена от ⟨{start}⟩ откладываем ⟨{length}⟩ = {value} {unit}, это {mm} мм: точка ⟨{end}⟩.",
        "Along the link lay off ⟨{length}⟩ = {value} {unit} from ⟨{start}⟩, that is {mm} mm: the point ⟨{end}⟩.",
    ),
    "lay_off": (
        "{formula}: откладываем {mm} мм от ⟨{start}⟩ ({action}), конец вектора — ⟨{end}⟩.",
        "{formula}: lay off {mm} mm from ⟨{start}⟩ ({action}); the vector ends at ⟨{end}⟩.",
    ),
    "carried": (
        "Найденную раньше силу ⟨{name}⟩ = {value} {unit} (обратную найденной реакции) откладываем от ⟨{start}⟩: "
        "{mm} мм, конец — ⟨{end}⟩.",
        "The force ⟨{name}⟩ = {value} {unit}, opposite to the reaction found before, is laid off from ⟨{start}⟩: "
        "{mm} mm, to ⟨{end}⟩.",
    ),
    "arcs": (
        "Засечки: из ⟨{centre}⟩ радиусом {radius_mm} мм и из ⟨{other}⟩ радиусом {other_mm} мм; из двух точек "
        "пересечения дуг берём заданную сборкой ⟨{end}⟩.",
        "Two arcs: {radius_mm} mm about ⟨{centre}⟩ and {other_mm} mm about ⟨{other}⟩; of their two crossings the "
        "assembly names ⟨{end}⟩.",
    ),
    "arc": (
        "Из ⟨{centre}⟩ радиусом {radius_mm} мм делаем засечку на прямой {action} через ⟨{start}⟩: точка ⟨{end}⟩.",
        "An arc of {radius_mm} mm about ⟨{centre}⟩ cuts the line {action} through ⟨{start}⟩ at ⟨{end}⟩.",
    ),
    "touch": (
        "Направление {action}: прямая через ⟨{start}⟩, от которой ⟨{end}⟩ отстоит на заданное смещение.",
        "The direction {action}: the line through ⟨{start}⟩ that passes ⟨{end}⟩ at the given offset.",
    ),
    "cross": (
        "Через ⟨{start}⟩ проводим прямую {action}, через ⟨{other}⟩ — прямую {across}; они пересекаются в ⟨{end}⟩.",
        "Through ⟨{start}⟩ draw a line {action}, through ⟨{other}⟩ a line {across}; they cross at ⟨{end}⟩.",
    ),
    "similar": (
        "По подобию: ⟨{end}⟩ делит ⟨{first}⟩⟨{second}⟩ так же, как точка на звене делит своё звено "
        "(отношение {ratio}).",
        "By similarity: ⟨{end}⟩ stands to ⟨{first}⟩⟨{second}⟩ as the point stands on its link (ratio {ratio}).",
    ),
    "image": (
        "По подобию со схемой: фигура на ⟨{first}⟩⟨{second}⟩ подобна фигуре звена и читается в ту же сторону; её "
        "вершина — ⟨{end}⟩.",
        "By similarity with the scheme: the figure on ⟨{first}⟩⟨{second}⟩ is similar to the link and reads the same "
        "way round; its vertex is ⟨{end}⟩.",
    ),
    "same": (
        "Звено не вращается: ⟨{end}⟩ совпадает с ⟨{start}⟩.",
        "The link does not turn: ⟨{end}⟩ coincides with ⟨{start}⟩.",
    ),
    "carry": (
        "Поворачиваем отрезок ⟨{first}⟩⟨{second}⟩ на 90° и получаем ⟨{end}⟩ рычага.",
        "Turn the segment ⟨{first}⟩⟨{second}⟩ by 90° to ⟨{end}⟩ of the lever.",
    ),
    "choose": (
        "Трение: реакция отклонена от нормали на arctg f против скольжения; из двух построений верно то, где "
        "направляющая действительно прижата с предположенной стороны: ⟨{end}⟩.",
        "Friction: the reaction leans from the normal by arctan f against the sliding; of the two drawings the one "
        "whose supposed side really bears is right: ⟨{end}⟩.",
    ),
    "measured": ("Измеряем: {readings}.", "Measure: {readings}."),
    "reading": ("⟨{name}⟩ = {mm} мм : μ = {value} {unit}", "⟨{name}⟩ = {mm} mm : μ = {value} {unit}"),
    "moments": (
        "Сумма моментов относительно ⟨{about}⟩ (звенья {links}), кроме искомого: {terms}; отсюда ⟨{unknown}⟩ = {value} {unit}.",
        "The moments about ⟨{about}⟩ (links {links}) but for the one sought: {terms}; hence ⟨{unknown}⟩ = {value} {unit}.",
    ),
    "sense_ccw": ("против часовой стрелки", "counter-clockwise"),
    "sense_cw": ("по часовой стрелке", "clockwise"),
    "towards": ("от ⟨{one}⟩ к ⟨{other}⟩", "from ⟨{one}⟩ to ⟨{other}⟩"),
}
