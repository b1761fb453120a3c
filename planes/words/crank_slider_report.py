"""Words of the report: given data and kinematics. Key to Russian and English."""

GENERAL: dict[str, tuple[str, str]] = {
    "kW": ("кВт", "kW"),
    "MPa": ("МПа", "MPa"),
    "J": ("Дж", "J"),
    "table": ("Таблица", "Table"),
    "figure": ("Рисунок", "Figure"),
    "lead": (
        "Расчёт идёт в порядке «кинематика — силы — уравновешивание — прочность». Движение и силы найдены двумя "
        "путями: по формулам и общим расчётом планов механизма; расхождения показаны. В скобках справа — номера "
        "формул исходного текста (Невенчанная, Павловский, Пономарева). Каждая формула перед применением выведена "
        "заново; места, где текст ошибочен, выделены рамкой.",
        "The calculation goes from kinematics to forces, balancing and strength. Motion and forces are found in two "
        "ways: by formulas and by the general plans of the mechanism; the differences are shown. Numbers in brackets "
        "on the right are those of the formulas in the source text (Nevenchannaya, Pavlovsky, Ponomareva). Every "
        "formula was derived anew before use; a frame marks the places where the text is wrong.",
    ),
    "h_given": ("1 Исходные данные", "1 Given"),
    "t_given": ("Исходные данные", "What is given"),
    "c_what": ("Величина", "Quantity"),
    "c_sign": ("Знак", "Sign"),
    "c_value": ("Значение", "Value"),
    "g_r": ("радиус кривошипа OA", "crank OA"),
    "g_l": ("длина шатуна AB", "rod AB"),
    "g_c": ("от A до центра масс шатуна", "from A to the rod's mass centre"),
    "g_lambda": ("отношение r/l", "ratio r/l"),
    "g_omega": ("угловая скорость кривошипа", "angular velocity of the crank"),
    "g_uneven": ("изменение ω за оборот (δ; волн)", "change of ω in a turn (δ; waves)"),
    "g_m1": ("масса кривошипа", "mass of the crank"),
    "g_m2": ("масса шатуна", "mass of the rod"),
    "g_m3": ("масса поршня", "mass of the piston"),
    "g_j2": ("момент инерции шатуна относительно C", "rod's moment of inertia about C"),
    "g_f": ("коэффициент трения поршня", "friction of the piston"),
    "g_d": ("диаметр поршня", "bore"),
    "g_p0": ("давление под поршнем", "pressure behind the piston"),
    "g_strokes": ("тактов в цикле", "strokes in a cycle"),
    "f_scheme": ("Схема механизма при φ = {phi}°", "Scheme of the mechanism at φ = {phi}°"),
}

KINEMATICS: dict[str, tuple[str, str]] = {
    "h_kin": ("2 Кинематика", "2 Kinematics"),
    "h_points": ("2.1 Кинематика точки", "2.1 Motion of points"),
    "k_points": (
        "Оси: O — опора кривошипа, x — по оси цилиндра, φ — от оси x против часовой стрелки. Координаты точек A, B и "
        "центра масс C; k = AC/AB = {k}, β = arcsin(r·sin φ / l):",
        "Axes: O is the crank's pivot, x runs along the cylinder, φ from x counter-clockwise. Coordinates of A, B "
        "and the mass centre C; k = AC/AB = {k}, β = arcsin(r·sin φ / l):",
    ),
    "k_derive": (
        "Скорости — первые производные по времени, dφ/dt = ω; проекции ускорений — вторые, с dω/dt = ε. Обозначим s "
        "= √(l² − r²·sin²φ) = l·cos β:",
        "Velocities are the first derivatives in time, dφ/dt = ω, accelerations the second ones, dω/dt = ε. With s = "
        "√(l² − r²·sin²φ) = l·cos β:",
    ),
    "k_at": (
        "При φ = {phi}°, ω = {omega} рад/с, ε = {eps} рад/с²:",
        "At φ = {phi}°, ω = {omega} rad/s, ε = {eps} rad/s²:",
    ),
    "m_3": (
        "Формула (3) текста верна только при ω = const, хотя закон φ = ∫ω dt объявлен общим: пропущены слагаемые с "
        "ε. Здесь они добавлены. {size}",
        "Formula (3) of the text holds for ω = const only, though the general law φ = ∫ω dt is announced: the terms "
        "with ε are missing. Here they are added. {size}",
    ),
    "m_3_none": ("В этом расчёте ε = 0, поэтому числа не меняются.", "Here ε = 0, so the numbers do not change."),
    "m_3_size": (
        "В этом расчёте без них a_{B} ошибочно до {percent} % от ω²r.",
        "Here a_{B} without them is wrong by up to {percent} % of ω²r.",
    ),
    "h_plane": ("2.2 Плоское движение шатуна", "2.2 Plane motion of the rod"),
    "k_plane": (
        "Мгновенный центр скоростей P шатуна — на пересечении прямой OA с перпендикуляром к оси в точке B; AP и BP:",
        "The instant centre P of the rod lies where the line OA meets the perpendicular to the axis in B; AP and BP:",
    ),
    "m_5": (
        "Над (5) величина ω_{AB} названа угловым ускорением; это угловая скорость. В (5) и (7) у AP, BP и скоростей "
        "пропущены знаки модуля, а при φ = 90° и 270° формулы дают 0·∞; (5*) свободна от этого, предел v_{C} = ωr.",
        "Above (5) the text calls ω_{AB} an angular acceleration; it is the angular velocity. In (5) and (7) the "
        "signs of modulus are missing, and at φ = 90° and 270° they give 0·∞; (5*) is free of this, the limit is "
        "v_{C} = ωr.",
    ),
    "k_accel": (
        "Теорема об ускорениях с полюсом A: a_{B} = a_{A}^{n} + a_{A}^{τ} + a_{BA}^{n} + a_{BA}^{τ}. В проекциях "
        "(a_{B} положительно влево, a_{BA}^{τ} — при ε_{AB} против часовой стрелки):",
        "Accelerations about the pole A: a_{B} = a_{A}^{n} + a_{A}^{τ} + a_{BA}^{n} + a_{BA}^{τ}. In projections "
        "(a_{B} positive to the left, a_{BA}^{τ} with ε_{AB} counter-clockwise):",
    ),
    "h_plans": ("2.3 Планы скоростей и ускорений", "2.3 Velocity and acceleration plans"),
    "f_kinplans": ("Планы при φ = {phi}°", "Plans at φ = {phi}°"),
    "h_kintable": ("2.4 Результаты за оборот", "2.4 Results over a turn"),
    "k_agree": (
        "Наибольшие расхождения путей по всем положениям цикла (через {step}°): скорости — в долях ωr, ускорения — в "
        "долях ω²r, ω_{AB} и ε_{AB} — в долях ω и ω². Это ошибки округления, пути совпадают.",
        "The largest differences of the ways over all positions of the cycle (every {step}°): velocities in parts of "
        "ωr, accelerations of ω²r, ω_{AB} and ε_{AB} of ω and ω². These are rounding errors: the ways agree.",
    ),
    "t_agree": ("Расхождения трёх путей", "Differences of the three ways"),
    "points_plane": ("точка — плоское движение", "points – plane motion"),
    "points_plans": ("точка — планы", "points – plans"),
    "plane_plans": ("плоское движение — планы", "plane motion – plans"),
    "c_ways": ("Пути", "Ways"),
    "t_kin": (
        "Кинематика за оборот; м, м/с, м/с², рад/с, рад/с²; v_{B} и a_{B} — проекции на ось x",
        "Kinematics over a turn; m, m/s, m/s², rad/s, rad/s²; v_{B} and a_{B} are projections on x",
    ),
    "f_7a": ("Безразмерные скорости точек A, B, C", "Dimensionless velocities of A, B, C"),
    "f_7b": ("Безразмерные ускорения точек A, B, C", "Dimensionless accelerations of A, B, C"),
    "f_omega": ("Угловая скорость и угловое ускорение шатуна", "Angular velocity and acceleration of the rod"),
    "x_phi": ("угол поворота кривошипа φ, °", "crank angle φ, °"),
    "y_v": ("v/(ωr)", "v/(ωr)"),
    "y_a": ("a/(ω²r)", "a/(ω²r)"),
    "y_w": (
        "$\\omega_{AB}/\\omega$;  $\\varepsilon_{AB}/\\omega^2$",
        "$\\omega_{AB}/\\omega$;  $\\varepsilon_{AB}/\\omega^2$",
    ),
}
