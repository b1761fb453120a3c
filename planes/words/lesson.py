"""Words of the lesson and the note: what each kind of step does, in Russian and in English.

Names in ⟨…⟩ are marks, vectors or values; who shows the sentence letters them (v_CB with its index lowered).
Numbers come through the slots of :mod:`planes.lesson.formulas`.
"""

from __future__ import annotations

from planes.words.why import WHY

LESSON: dict[str, tuple[str, str]] = {
    "fixed": (
        "Наносим неподвижное: {names}. Масштаб {mu}: отрезок на чертеже равен длине, умноженной на μ.",
        "Put what is fixed: {names}. The scale is {mu}: a segment on paper is the length times μ.",
    ),
    "pole": ("Выбираем полюс ⟨{end}⟩ и масштаб {mu}.", "Choose the pole ⟨{end}⟩ and the scale {mu}."),
    "driver": (
        "Ведущее звено: от ⟨{start}⟩ под его углом откладываем ⟨{length}⟩ = {value} {unit}, на чертеже {mm} мм, и "
        "получаем ⟨{end}⟩.",
        "The driver: from ⟨{start}⟩ at its angle lay off ⟨{length}⟩ = {value} {unit}, {mm} mm on paper, to ⟨{end}⟩.",
    ),
    "along": (
        "От ⟨{start}⟩ {way} откладываем ⟨{length}⟩ = {value} {unit}, это {mm} мм: точка ⟨{end}⟩.",
        "From ⟨{start}⟩ {way} lay off ⟨{length}⟩ = {value} {unit}, that is {mm} mm: the point ⟨{end}⟩.",
    ),
    "lay_off": (
        "{formula}. Откладываем {mm} мм от ⟨{start}⟩ {way}; конец вектора — ⟨{end}⟩.",
        "{formula}. Lay off {mm} mm from ⟨{start}⟩, {way}; the vector ends at ⟨{end}⟩.",
    ),
    "load": (
        "Заданная сила ⟨{name}⟩ = {value} {unit}: откладываем {mm} мм от ⟨{start}⟩ {way}, до ⟨{end}⟩.",
        "The given force ⟨{name}⟩ = {value} {unit}: lay off {mm} mm from ⟨{start}⟩, {way}, to ⟨{end}⟩.",
    ),
    "given": (
        "Дано ⟨{name}⟩ = {value} {unit}: откладываем {mm} мм от ⟨{start}⟩ {way}, до ⟨{end}⟩.",
        "Given ⟨{name}⟩ = {value} {unit}: lay off {mm} mm from ⟨{start}⟩, {way}, to ⟨{end}⟩.",
    ),
    "point": (
        "⟨{end}⟩ — точка того же звена: строим её на ⟨{first}⟩⟨{second}⟩ по размерам звена.",
        "⟨{end}⟩ is a point of the same link: draw it on ⟨{first}⟩⟨{second}⟩ by the link's own dimensions.",
    ),
    "found": (
        "Из уравнения моментов ⟨{name}⟩ = {value} {unit}: откладываем {mm} мм от ⟨{start}⟩ {way}, до ⟨{end}⟩.",
        "From the moment equation ⟨{name}⟩ = {value} {unit}: lay off {mm} mm from ⟨{start}⟩, {way}, to ⟨{end}⟩.",
    ),
    "carried": (
        "⟨{name}⟩ = {value} {unit} — реакция, найденная раньше: откладываем {mm} мм от ⟨{start}⟩ до ⟨{end}⟩.",
        "⟨{name}⟩ = {value} {unit} is the reaction found before: lay off {mm} mm from ⟨{start}⟩ to ⟨{end}⟩.",
    ),
    "arcs": (
        "Засечки: из ⟨{centre}⟩ радиусом {radius_mm} мм и из ⟨{other}⟩ радиусом {other_mm} мм; из двух точек "
        "пересечения берём заданную сборкой ⟨{end}⟩.",
        "Two arcs: {radius_mm} mm about ⟨{centre}⟩ and {other_mm} mm about ⟨{other}⟩; of their two crossings the "
        "assembly names ⟨{end}⟩.",
    ),
    "arc": (
        "Из ⟨{centre}⟩ радиусом {radius_mm} мм делаем засечку на прямой {action} через ⟨{start}⟩: точка ⟨{end}⟩.",
        "An arc of {radius_mm} mm about ⟨{centre}⟩ cuts the line {action} through ⟨{start}⟩ at ⟨{end}⟩.",
    ),
    "touch": (
        "Направление {action}: прямая через ⟨{start}⟩ и ⟨{end}⟩ с заданным смещением.",
        "The direction {action}: the line through ⟨{start}⟩ that passes ⟨{end}⟩ at the given offset.",
    ),
    "cross": (
        "Через ⟨{start}⟩ проводим прямую {action}, через ⟨{other}⟩ — прямую {across}; они пересекаются в ⟨{end}⟩.",
        "Through ⟨{start}⟩ draw a line {action}, through ⟨{other}⟩ a line {across}; they cross at ⟨{end}⟩.",
    ),
    "similar": (
        "По подобию: ⟨{first}⟩⟨{end}⟩ = {ratio} · ⟨{first}⟩⟨{second}⟩, как на самом звене.",
        "By similarity: ⟨{first}⟩⟨{end}⟩ = {ratio} · ⟨{first}⟩⟨{second}⟩, as on the link itself.",
    ),
    "image": (
        "По подобию: на ⟨{first}⟩⟨{second}⟩ строим фигуру, подобную ⟨{one}⟩⟨{two}⟩⟨{own}⟩ на схеме; её вершина, "
        "отвечающая ⟨{own}⟩, — ⟨{end}⟩.",
        "By similarity: the figure on ⟨{first}⟩⟨{second}⟩ is similar to ⟨{one}⟩⟨{two}⟩⟨{own}⟩ of the scheme; its "
        "vertex for ⟨{own}⟩ is ⟨{end}⟩.",
    ),
    "carried_image": (
        "По подобию: от ⟨{start}⟩ откладываем ⟨{start}⟩⟨{end}⟩; он относится к ⟨{first}⟩⟨{second}⟩ и повёрнут от него, "
        "как на схеме ⟨{from}⟩⟨{own}⟩ от ⟨{one}⟩⟨{two}⟩.",
        "By similarity: from ⟨{start}⟩ lay off ⟨{start}⟩⟨{end}⟩, which is to ⟨{first}⟩⟨{second}⟩ in length and in turn "
        "as ⟨{from}⟩⟨{own}⟩ is to ⟨{one}⟩⟨{two}⟩ on the scheme.",
    ),
    "same": (
        "Звено не поворачивается относительно стойки: ⟨{end}⟩ совпадает с ⟨{start}⟩.",
        "The link does not turn: ⟨{end}⟩ coincides with ⟨{start}⟩.",
    ),
    "carry": (
        "Поворачиваем отрезок ⟨{first}⟩⟨{second}⟩ плана скоростей на 90° и получаем ⟨{end}⟩ рычага.",
        "Turn the segment ⟨{first}⟩⟨{second}⟩ of the velocity plan by 90° to ⟨{end}⟩ of the lever.",
    ),
    "choose": (
        "Трение отклоняет реакции от нормалей; прямые пересекаются в ⟨{end}⟩.",
        "Friction leans the reactions from the normals; the lines cross at ⟨{end}⟩.",
    ),
    "measured": ("Измеряем: {readings}.", "Measure: {readings}."),
    "closing": (
        "Многоугольник замкнут. Измеряем реакции: {readings}.",
        "The polygon is closed. Measure the reactions: {readings}.",
    ),
    "reading": ("⟨{name}⟩ = {mm} мм / {mu} = {value} {unit}", "⟨{name}⟩ = {mm} mm / {mu} = {value} {unit}"),
    "moments": (
        "Моменты относительно ⟨{about}⟩ ({links}): {head} = {letters} = {numbers}{result}.",
        "Moments about ⟨{about}⟩ ({links}): {head} = {letters} = {numbers}{result}.",
    ),
    "moments_none": (
        "Моменты относительно ⟨{about}⟩ ({links}): все силы проходят через ⟨{about}⟩, поэтому и реакция ⟨{force}⟩ "
        "проходит через неё.",
        "Moments about ⟨{about}⟩ ({links}): every force passes through ⟨{about}⟩, so the reaction ⟨{force}⟩ passes "
        "through it too.",
    ),
    "link": ("звено {links}", "link {links}"),
    "links": ("звенья {links}", "links {links}"),
    "lever_of": ("рычаг Жуковского", "Zhukovsky's lever"),
    "ccw": ("против часовой стрелки", "counter-clockwise"),
    "cw": ("по часовой стрелке", "clockwise"),
    "still": ("звено не вращается", "the link does not turn"),
    "zone_bad": (
        "Здесь механизм не собирается: план не построить.",
        "Here the mechanism cannot be assembled: there is no plan to draw.",
    ),
    "zone_blunt": (
        "Здесь прямые, дающие ⟨{mark}⟩ ({plan}), сходятся под углом до {angle}°: погрешность построения растёт как "
        "1/sin этого угла, у особого положения — без предела.",
        "Here the lines that give ⟨{mark}⟩ ({plan}) meet at an angle down to {angle}°: the error of drawing grows as 1 "
        "over the sine of it, at a dead point without limit.",
    ),
    # practice
    "value_for_mm": (
        "{mark}: отложена сама величина; миллиметры — это величина, умноженная на масштаб",
        "{mark}: this is the quantity itself; its millimetres are the quantity times the scale",
    ),
    "value_over_mu": (
        "{mark}: величина разделена на масштаб; миллиметры — это величина, умноженная на него",
        "{mark}: the quantity was divided by the scale; its millimetres are the quantity times it",
    ),
    # ways a length is laid off
    "way_across": ("перпендикулярно {line}", "perpendicular to {line}"),
    "way_along": ("вдоль {line}", "along {line}"),
    "way_towards": ("в направлении от ⟨{one}⟩ к ⟨{other}⟩", "from ⟨{one}⟩ to ⟨{other}⟩"),
    "way_down": ("вниз", "downwards"),
    "way_against": ("против ⟨{vector}⟩", "against ⟨{vector}⟩"),
    "way_with": ("в сторону ⟨{vector}⟩", "the way of ⟨{vector}⟩"),
    "way_given": ("под заданным углом", "at its given angle"),
    "way_own": ("в её направлении", "in its direction"),
}


def tell(key: str, lang: str, **names: object) -> str:
    """A sentence of the lesson with its names."""
    return _said(LESSON, key, lang, names)


def why(key: str, lang: str, **names: object) -> str:
    """Why a step is done so."""
    return _said(WHY, key, lang, names)


def _said(table: dict[str, tuple[str, str]], key: str, lang: str, names: dict[str, object]) -> str:
    text = table[key][0 if lang == "ru" else 1]
    return text.format(**names) if names else text
