"""Words of the lesson and the note: what each kind of step does, in Russian and in English.

Names in ⟨…⟩ are marks, vectors or values; who shows the sentence letters them (v_CB with its index lowered).
Numbers come through the slots of :mod:`planes.lesson.formulas`.
"""

from __future__ import annotations

LESSON: dict[str, tuple[str, str]] = {
    "lesson_fixed": (
        "Наносим неподвижное: {names}. Масштаб {mu}: отрезок на чертеже равен длине, умноженной на μ.",
        "Put what is fixed: {names}. The scale is {mu}: a segment on paper is the length times μ.",
    ),
    "lesson_pole": ("Выбираем полюс ⟨{end}⟩ и масштаб {mu}.", "Choose the pole ⟨{end}⟩ and the scale {mu}."),
    "lesson_driver": (
        "Ведущее звено: от ⟨{start}⟩ под его углом откладываем ⟨{length}⟩ = {value} {unit}, на чертеже {mm} мм, и "
        "получаем ⟨{end}⟩.",
        "The driver: from ⟨{start}⟩ at its angle lay off ⟨{length}⟩ = {value} {unit}, {mm} mm on paper, to ⟨{end}⟩.",
    ),
    "lesson_along": (
        "От ⟨{start}⟩ {way} откладываем ⟨{length}⟩ = {value} {unit}, это {mm} мм: точка ⟨{end}⟩.",
        "From ⟨{start}⟩ {way} lay off ⟨{length}⟩ = {value} {unit}, that is {mm} mm: the point ⟨{end}⟩.",
    ),
    "lesson_lay_off": (
        "{formula}. Откладываем {mm} мм от ⟨{start}⟩ {way}; конец вектора — ⟨{end}⟩.",
        "{formula}. Lay off {mm} mm from ⟨{start}⟩, {way}; the vector ends at ⟨{end}⟩.",
    ),
    "lesson_load": (
        "Заданная сила ⟨{name}⟩ = {value} {unit}: откладываем {mm} мм от ⟨{start}⟩ {way}, до ⟨{end}⟩.",
        "The given force ⟨{name}⟩ = {value} {unit}: lay off {mm} mm from ⟨{start}⟩, {way}, to ⟨{end}⟩.",
    ),
    "lesson_given": (
        "Дано ⟨{name}⟩ = {value} {unit}: откладываем {mm} мм от ⟨{start}⟩ {way}, до ⟨{end}⟩.",
        "Given ⟨{name}⟩ = {value} {unit}: lay off {mm} mm from ⟨{start}⟩, {way}, to ⟨{end}⟩.",
    ),
    "lesson_point": (
        "⟨{end}⟩ — точка того же звена: строим её на ⟨{first}⟩⟨{second}⟩ по размерам звена.",
        "⟨{end}⟩ is a point of the same link: draw it on ⟨{first}⟩⟨{second}⟩ by the link's own dimensions.",
    ),
    "lesson_found": (
        "Из уравнения моментов ⟨{name}⟩ = {value} {unit}: откладываем {mm} мм от ⟨{start}⟩ {way}, до ⟨{end}⟩.",
        "From the moment equation ⟨{name}⟩ = {value} {unit}: lay off {mm} mm from ⟨{start}⟩, {way}, to ⟨{end}⟩.",
    ),
    "lesson_carried": (
        "⟨{name}⟩ = {value} {unit} — реакция, найденная раньше: откладываем {mm} мм от ⟨{start}⟩ до ⟨{end}⟩.",
        "⟨{name}⟩ = {value} {unit} is the reaction found before: lay off {mm} mm from ⟨{start}⟩ to ⟨{end}⟩.",
    ),
    "lesson_arcs": (
        "Засечки: из ⟨{centre}⟩ радиусом {radius_mm} мм и из ⟨{other}⟩ радиусом {other_mm} мм; из двух точек "
        "пересечения берём заданную сборкой ⟨{end}⟩.",
        "Two arcs: {radius_mm} mm about ⟨{centre}⟩ and {other_mm} mm about ⟨{other}⟩; of their two crossings the "
        "assembly names ⟨{end}⟩.",
    ),
    "lesson_arc": (
        "Из ⟨{centre}⟩ радиусом {radius_mm} мм делаем засечку на прямой {action} через ⟨{start}⟩: точка ⟨{end}⟩.",
        "An arc of {radius_mm} mm about ⟨{centre}⟩ cuts the line {action} through ⟨{start}⟩ at ⟨{end}⟩.",
    ),
    "lesson_touch": (
        "Направление {action}: прямая через ⟨{start}⟩ и ⟨{end}⟩ с заданным смещением.",
        "The direction {action}: the line through ⟨{start}⟩ that passes ⟨{end}⟩ at the given offset.",
    ),
    "lesson_cross": (
        "Через ⟨{start}⟩ проводим прямую {action}, через ⟨{other}⟩ — прямую {across}; они пересекаются в ⟨{end}⟩.",
        "Through ⟨{start}⟩ draw a line {action}, through ⟨{other}⟩ a line {across}; they cross at ⟨{end}⟩.",
    ),
    "lesson_similar": (
        "По подобию: ⟨{first}⟩⟨{end}⟩ = {ratio} · ⟨{first}⟩⟨{second}⟩, как на самом звене.",
        "By similarity: ⟨{first}⟩⟨{end}⟩ = {ratio} · ⟨{first}⟩⟨{second}⟩, as on the link itself.",
    ),
    "lesson_image": (
        "По подобию: на ⟨{first}⟩⟨{second}⟩ строим фигуру, подобную ⟨{one}⟩⟨{two}⟩⟨{own}⟩ на схеме; её вершина, "
        "отвечающая ⟨{own}⟩, — ⟨{end}⟩.",
        "By similarity: the figure on ⟨{first}⟩⟨{second}⟩ is similar to ⟨{one}⟩⟨{two}⟩⟨{own}⟩ of the scheme; its "
        "vertex for ⟨{own}⟩ is ⟨{end}⟩.",
    ),
    "lesson_carried_image": (
        "По подобию: от ⟨{start}⟩ откладываем ⟨{start}⟩⟨{end}⟩; он относится к ⟨{first}⟩⟨{second}⟩ и повёрнут от него, "
        "как на схеме ⟨{from}⟩⟨{own}⟩ от ⟨{one}⟩⟨{two}⟩.",
        "By similarity: from ⟨{start}⟩ lay off ⟨{start}⟩⟨{end}⟩, which is to ⟨{first}⟩⟨{second}⟩ in length and in turn "
        "as ⟨{from}⟩⟨{own}⟩ is to ⟨{one}⟩⟨{two}⟩ on the scheme.",
    ),
    "lesson_same": (
        "Звено не поворачивается относительно стойки: ⟨{end}⟩ совпадает с ⟨{start}⟩.",
        "The link does not turn: ⟨{end}⟩ coincides with ⟨{start}⟩.",
    ),
    "lesson_carry": (
        "Поворачиваем отрезок ⟨{first}⟩⟨{second}⟩ плана скоростей на 90° и получаем ⟨{end}⟩ рычага.",
        "Turn the segment ⟨{first}⟩⟨{second}⟩ of the velocity plan by 90° to ⟨{end}⟩ of the lever.",
    ),
    "lesson_choose": (
        "Трение отклоняет реакции от нормалей; прямые пересекаются в ⟨{end}⟩.",
        "Friction leans the reactions from the normals; the lines cross at ⟨{end}⟩.",
    ),
    "lesson_measured": ("Измеряем: {readings}.", "Measure: {readings}."),
    "lesson_closing": (
        "Многоугольник замкнут. Измеряем реакции: {readings}.",
        "The polygon is closed. Measure the reactions: {readings}.",
    ),
    "lesson_reading": ("⟨{name}⟩ = {mm} мм / {mu} = {value} {unit}", "⟨{name}⟩ = {mm} mm / {mu} = {value} {unit}"),
    "lesson_moments": (
        "Моменты относительно ⟨{about}⟩ ({links}): {head} = {letters} = {numbers}{result}.",
        "Moments about ⟨{about}⟩ ({links}): {head} = {letters} = {numbers}{result}.",
    ),
    "lesson_moments_none": (
        "Моменты относительно ⟨{about}⟩ ({links}): все силы проходят через ⟨{about}⟩, поэтому и реакция ⟨{force}⟩ "
        "проходит через неё.",
        "Moments about ⟨{about}⟩ ({links}): every force passes through ⟨{about}⟩, so the reaction ⟨{force}⟩ passes "
        "through it too.",
    ),
    "lesson_link": ("звено {links}", "link {links}"),
    "lesson_links": ("звенья {links}", "links {links}"),
    "lesson_lever_of": ("рычаг Жуковского", "Zhukovsky's lever"),
    "lesson_ccw": ("против часовой стрелки", "counter-clockwise"),
    "lesson_cw": ("по часовой стрелке", "clockwise"),
    "lesson_still": ("звено не вращается", "the link does not turn"),
    "lesson_zone_bad": (
        "Здесь механизм не собирается: план не построить.",
        "Here the mechanism cannot be assembled: there is no plan to draw.",
    ),
    "lesson_zone_blunt": (
        "Здесь прямые, дающие ⟨{mark}⟩ ({plan}), сходятся под углом до {angle}°: погрешность построения растёт как "
        "1/sin этого угла, у особого положения — без предела.",
        "Here the lines that give ⟨{mark}⟩ ({plan}) meet at an angle down to {angle}°: the error of drawing grows as 1 "
        "over the sine of it, at a dead point without limit.",
    ),
    # practice
    "lesson_value_for_mm": (
        "{mark}: отложена сама величина; миллиметры — это величина, умноженная на масштаб",
        "{mark}: this is the quantity itself; its millimetres are the quantity times the scale",
    ),
    "lesson_value_over_mu": (
        "{mark}: величина разделена на масштаб; миллиметры — это величина, умноженная на него",
        "{mark}: the quantity was divided by the scale; its millimetres are the quantity times it",
    ),
    # ways a length is laid off
    "lesson_way_across": ("перпендикулярно {line}", "perpendicular to {line}"),
    "lesson_way_along": ("вдоль {line}", "along {line}"),
    "lesson_way_towards": ("в направлении от ⟨{one}⟩ к ⟨{other}⟩", "from ⟨{one}⟩ to ⟨{other}⟩"),
    "lesson_way_down": ("вниз", "downwards"),
    "lesson_way_against": ("против ⟨{vector}⟩", "against ⟨{vector}⟩"),
    "lesson_way_with": ("в сторону ⟨{vector}⟩", "the way of ⟨{vector}⟩"),
    "lesson_way_given": ("под заданным углом", "at its given angle"),
    "lesson_way_own": ("в её направлении", "in its direction"),
}
