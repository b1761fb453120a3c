"""Why each step of a lesson is done as it is: the theorem in a sentence, in Russian and in English."""

from __future__ import annotations

WHY: dict[str, tuple[str, str]] = {
    "why_fixed": (
        "Стойка неподвижна; от неё строится всё остальное.",
        "The frame stands still; everything else is drawn from it.",
    ),
    "why_pole": ("В полюсе концы векторов всех неподвижных точек.", "The vectors of all fixed points end at the pole."),
    "why_pole_force": (
        "Группа в равновесии вместе с силами инерции (принцип Даламбера): сумма всех сил равна нулю.",
        "With its forces of inertia the group is in balance (d'Alembert's principle): all forces add up to nothing.",
    ),
    "why_pole_lever": (
        "Теорема Жуковского: план скоростей, повёрнутый на 90° и нагруженный силами, находится в равновесии как рычаг.",
        "Zhukovsky's theorem: the velocity plan turned by 90° and loaded with the forces is in balance as a lever.",
    ),
    "why_driver": ("Положение ведущего звена задано.", "The position of the driver is given."),
    "why_along": ("Расстояние на звене не меняется.", "A distance on a link does not change."),
    "why_arcs": (
        "Каждая точка звена движется по окружности около своего шарнира; обе длины известны, не известны направления.",
        "Each end runs on a circle about its pivot: both lengths are known, both directions are sought.",
    ),
    "why_arc": (
        "Длина звена известна, а вдоль направляющей не известно расстояние.",
        "The length of the link is known, the distance along the guide is sought.",
    ),
    "why_touch": ("Ползун держится направления направляющей.", "The slider keeps the direction of its guide."),
    "why_driver_v": (
        "Точка вращается вокруг неподвижного центра: скорость перпендикулярна радиусу, в сторону вращения.",
        "The point turns about a fixed centre: its velocity is perpendicular to the radius, the way it turns.",
    ),
    "why_slide_v": ("Ведущее звено движется вдоль направляющей.", "The driver moves along its guide."),
    "why_normal": (
        "Нормальное ускорение v²/l направлено к центру вращения.",
        "The normal acceleration v²/l points to the centre of rotation.",
    ),
    "why_normal_w": (
        "Нормальное ускорение ω²l направлено к центру вращения.",
        "The normal acceleration ω²l points to the centre of rotation.",
    ),
    "why_tangential": (
        "Касательное ускорение εl перпендикулярно радиусу; знак минус меняет направление.",
        "The tangential acceleration εl is perpendicular to the radius; a minus reverses it.",
    ),
    "why_coriolis": (
        "Направляющая поворачивается: кориолисово ускорение 2ωv — относительная скорость, повёрнутая на 90° "
        "в сторону ω.",
        "The guide turns: Coriolis's acceleration 2ωv is the relative velocity turned by 90° in the sense of ω.",
    ),
    "why_weight": ("Сила тяжести mg направлена вниз.", "The weight mg points down."),
    "why_inertia": (
        "Сила инерции m·a противоположна ускорению центра масс.",
        "The force of inertia m·a is opposite to the acceleration of the mass centre.",
    ),
    "why_load": ("Сила задана.", "The force is given."),
    "why_found": (
        "Касательная часть реакции найдена моментами; знак минус меняет направление.",
        "The tangential part of a reaction comes from moments; a minus reverses it.",
    ),
    "why_carried": (
        "Действие равно противодействию и противоположно ему.",
        "Action and reaction are equal and opposite.",
    ),
    "why_cross_position": ("Точка лежит на обеих прямых.", "The point lies on both lines."),
    "why_across_velocity": (
        "⟨{name}⟩ ⊥ {line}: относительная скорость перпендикулярна звену",
        "⟨{name}⟩ ⊥ {line}: the relative velocity is perpendicular to the link",
    ),
    "why_along_velocity": (
        "⟨{name}⟩ ∥ {line}: относительное движение идёт вдоль направляющей",
        "⟨{name}⟩ ∥ {line}: the relative motion runs along the guide",
    ),
    "why_across_acceleration": (
        "⟨{name}⟩ ⊥ {line}: касательное ускорение перпендикулярно звену",
        "⟨{name}⟩ ⊥ {line}: the tangential acceleration is perpendicular to the link",
    ),
    "why_along_acceleration": (
        "⟨{name}⟩ ∥ {line}: относительное ускорение идёт вдоль направляющей",
        "⟨{name}⟩ ∥ {line}: the relative acceleration runs along the guide",
    ),
    "why_across_force": (
        "⟨{name}⟩ ⊥ {line}: реакция направляющей без трения нормальна к ней",
        "⟨{name}⟩ ⊥ {line}: without friction a guide pushes along its normal",
    ),
    "why_along_force": (
        "⟨{name}⟩ ∥ {line}: направление известно, длина — из замыкания",
        "⟨{name}⟩ ∥ {line}: its direction is known, closing gives its length",
    ),
    "why_similar": (
        "Теорема подобия: фигура концов векторов подобна звену и обходится в ту же сторону.",
        "The theorem of similarity: the ends of the vectors form a figure similar to the link, read the same way "
        "round.",
    ),
    "why_carried_image": (
        "Звено поворачивается вместе со звеном, на котором ⟨{one}⟩⟨{two}⟩; разность векторов двух его точек "
        "относится к их отрезку одинаково.",
        "The link turns with the link of ⟨{one}⟩⟨{two}⟩: the difference of the vectors of two of its points stands to "
        "their segment alike.",
    ),
    "why_same": (
        "При поступательном движении у всех точек один вектор.",
        "In translation all points share one vector.",
    ),
    "why_carry": (
        "Плечо силы на таком рычаге пропорционально её мощности.",
        "The arm of a force on this lever is in proportion to its power.",
    ),
    "why_choose": (
        "Реакция отклонена от нормали на arctg f против скольжения; из пробных построений верно то, где направляющая "
        "прижата с предположенной стороны.",
        "The reaction leans from the normal by arctan f against the sliding; of the trials the one whose supposed side "
        "of the guide really bears is right.",
    ),
    "why_measured": (
        "Длина отрезка, делённая на μ, — сама величина; угловая величина — линейная, делённая на длину звена.",
        "A segment over μ is the quantity itself; an angular one is the linear one over the length of the link.",
    ),
    "why_closing": (
        "Силы, отложенные друг за другом, вернулись в начало: их сумма равна нулю.",
        "Laid end to end the forces came back to the start: they add up to nothing.",
    ),
    "why_moments": (
        "Относительно шарнира его собственная реакция плеча не имеет: в уравнении одна неизвестная.",
        "About a hinge its own reaction has no arm: one unknown is left.",
    ),
    "why_moments_lever": (
        "Плечи сил измерены на рычаге; пары умножены на угловые скорости. Это уравнение мощностей.",
        "Arms are measured on the lever, couples are multiplied by angular velocities: an equation of power.",
    ),
}
