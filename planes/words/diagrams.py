"""Words of diagrams over the cycle, graphical differentiation and the self-aligning variant: Russian and English."""

DIAGRAMS: dict[str, tuple[str, str]] = {
    "no_curve": (
        "{file}: величины {name} у этого механизма нет{valid}",
        "{file}: this mechanism has no quantity {name}{valid}",
    ),
    "help_cycle_show": (
        "какие величины писать в таблицу или чертить, через запятую: s_5,vq_C,u_31,F_21,M_1 или all; знак + ставит "
        "кривые на одни оси: v_C+v_D",
        "which quantities to tabulate or to draw, with commas: s_5,vq_C,u_31,F_21,M_1 or all; a plus sign puts curves "
        "on the same axes: v_C+v_D",
    ),
    "help_hodograph": ("начертить годографы векторов: F_21,v_C", "draw hodographs of vectors: F_21,v_C"),
    "help_path": ("начертить траектории точек: C,S2", "draw the paths of points: C,S2"),
    "help_graphical": (
        "графическое дифференцирование хордами и интегрирование полюсом движения ведомого звена на N участках "
        "(без числа 12), рядом с точными значениями",
        "graphical differentiation by chords and integration by a pole of the driven link's motion over N sections (12 "
        "without a number), beside the exact values",
    ),
    "help_pole_distance": ("полюсное расстояние H, мм", "the pole distance H, mm"),
    "help_listing": (
        "все величины в каждом положении: функции положения, аналоги, скорости, ускорения, силы",
        "every quantity in each position: places, analogues, velocities, accelerations, forces",
    ),
    "help_omega": ("другая скорость ведущего звена, рад/с или м/с", "another speed of the driver, rad/s or m/s"),
    "help_epsilon": (
        "другое ускорение ведущего звена, рад/с² или м/с²",
        "another acceleration of the driver, rad/s² or m/s²",
    ),
    "help_cycle_json": ("напечатать ответ как объект JSON", "print the answer as a JSON object"),
    "cycle_range": (
        "{name} = {first}…{last}, {velocity} = {v}, {acceleration} = {a}",
        "{name} = {first}…{last}, {velocity} = {v}, {acceleration} = {a}",
    ),
    "cycle_assembles": ("Собирается при {name} = {ranges}", "Assembles for {name} = {ranges}"),
    "drive_not_finite": (
        "скорость и ускорение ведущего звена должны быть конечными числами",
        "the speed and acceleration of the driver must be finite numbers",
    ),
    "cycle_flips": (
        "При {name} = {place} звенья {links} перебрасываются: ползун проходит через свой шарнир, и сборка меняется",
        "At {name} = {place} links {links} turn over: a slider passes through its hinge, and the assembly changes",
    ),
    "graphical_flips": (
        "звено {link} при φ1 = {place}° перебрасывается: его диаграмму хордами не продифференцировать",
        "link {link} turns over at φ1 = {place}°: its diagram cannot be differentiated by chords",
    ),
    "cycle_never": (
        "механизм не собирается ни в одном положении от {first} до {last}",
        "the mechanism assembles in no position from {first} to {last}",
    ),
    "stroke_slides": (
        "Ведомое звено {link}: ход {swing} м; крайние (мёртвые) положения: {dead}",
        "Driven link {link}: stroke {swing} m; extreme positions (dead points): {dead}",
    ),
    "stroke_turns": (
        "Ведомое звено {link}: угол размаха {swing}°; крайние (мёртвые) положения: {dead}",
        "Driven link {link}: angle of swing {swing}°; extreme positions (dead points): {dead}",
    ),
    "stroke_rounds": (
        "Ведомое звено {link} делает полный оборот: крайних положений у него нет",
        "Driven link {link} turns all the way round: it has no extreme positions",
    ),
    "stroke_unbounded": (
        "Ведомое звено {link} уходит в бесконечность: {dead}; хода у него нет",
        "Driven link {link} goes off without bound: {dead}; it has no stroke",
    ),
    "all_round": ("полный оборот", "all the way round"),
    "stroke_place": ("{name} = {place} ({curve} = {value})", "{name} = {place} ({curve} = {value})"),
    "stroke_limit": (
        "{name} = {place} ({curve} = {value}, предел сборки)",
        "{name} = {place} ({curve} = {value}, limit of assembly)",
    ),
    "stroke_end": (
        "{name} = {place} ({curve} = {value}, конец хода)",
        "{name} = {place} ({curve} = {value}, end of the range)",
    ),
    "time_ratio": (
        "Коэффициент изменения средней скорости K = {ratio}: туда {forth}°, обратно {back}° оборота ведущего звена",
        "Time ratio K = {ratio}: there in {forth}°, back in {back}° of the driver's turn",
    ),
    "stroke_more": ("Между ними ещё остановок: {count}", "It also comes to rest between them, times: {count}"),
    "group_place": ("Функции положения", "Position functions"),
    "group_analogue": (
        "Аналоги скоростей и ускорений (передаточные функции)",
        "Analogues of velocity and acceleration (transfer functions)",
    ),
    "group_analogue_v": ("Аналоги скоростей", "Analogues of velocity"),
    "group_analogue_a": ("Аналоги ускорений", "Analogues of acceleration"),
    "group_rate": ("Скорости и ускорения", "Velocities and accelerations"),
    "group_rate_v": ("Скорости", "Velocities"),
    "group_rate_a": ("Ускорения", "Accelerations"),
    "group_force": ("Реакции и уравновешивание", "Reactions and balancing"),
    "paths": ("Траектории точек", "Paths of points"),
    "path_length": ("длина, м", "length, m"),
    "chart_path": ("Траектория точки {name}", "Path of point {name}"),
    "chart_hodograph": ("Годограф {name}", "Hodograph of {name}"),
    "graphical_no_turn": (
        "{file}: графическое дифференцирование ведётся по времени равномерного оборота; ведущее звено должно вращаться "
        "с omega, не равной нулю",
        "{file}: graphical differentiation is done over the time of a uniform turn; the driver must turn, with omega "
        "not zero",
    ),
    "graphical_sections": (
        "число участков {count} не годится: возьмите от {least} до {most}",
        "{count} sections will not do: take from {least} to {most}",
    ),
    "graphical_pole": (
        "полюсное расстояние {pole} мм не годится: возьмите от 1 до 500 мм",
        "a pole distance of {pole} mm will not do: take from 1 to 500 mm",
    ),
    "graphical_differentiation": (
        "Графическое дифференцирование методом хорд: звено {link}, участков {count}, ω1 = const",
        "Graphical differentiation by chords: link {link}, {count} sections, ω1 = const",
    ),
    "graphical_integration": (
        "Графическое интегрирование: звено {link}, участков {count}, ω1 = const",
        "Graphical integration: link {link}, {count} sections, ω1 = const",
    ),
    "graphical_point": ("точка", "point"),
    "graphical_found": ("построено", "drawn"),
    "graphical_exact": ("точно", "exact"),
    "graphical_pencil": ("карандаш ±, %", "pencil ±, %"),
    "graphical_worst": (
        "наибольшая погрешность метода {error} % наибольшего значения",
        "largest error of the method {error} % of the largest value",
    ),
    "s": ("с", "s"),
    "rad": ("рад", "rad"),
    "no_alignment": (
        "у группы {links} нет варианта с q = 0 из цилиндрических и сферических пар в этом положении",
        "the group {links} has no variant with q = 0 of cylindrical and spherical pairs in this position",
    ),
    "alignment": (
        "Самоустанавливающийся вариант: n = {n}, p5 = {p5}, p4 = {p4}, p3 = {p3}",
        "Self-aligning variant: n = {n}, p5 = {p5}, p4 = {p4}, p3 = {p3}",
    ),
    "alignment_W": (
        "W = 6n − 5p5 − 4p4 − 3p3 = {a} − {b} − {c} − {d} = {W}, q = {q}",
        "W = 6n − 5p5 − 4p4 − 3p3 = {a} − {b} − {c} − {d} = {W}, q = {q}",
    ),
    "alignment_pair": ("{name} ({links}): {sign}", "{name} ({links}): {sign}"),
    "sign_R": ("вращательная 1в", "revolute 1R"),
    "sign_P": ("поступательная 1п", "prismatic 1P"),
    "sign_C": ("цилиндрическая 2ц", "cylindrical 2C"),
    "sign_S": ("сферическая 3с", "spherical 3S"),
    "column_unit": ("ед.", "unit"),
    "column_least": ("наименьшее", "least"),
    "column_greatest": ("наибольшее", "greatest"),
    "column_at": ("при {name}", "at {name}"),
    "1": ("1", "1"),
    "1/m": ("1/м", "1/m"),
    "1/m²": ("1/м²", "1/m²"),
    "°": ("°", "°"),
}
