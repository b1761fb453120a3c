"""Words of the explanatory note, in Russian and in English."""

from __future__ import annotations

NOTE: dict[str, tuple[str, str]] = {
    "note": ("Пояснительная записка", "Explanatory note"),
    "note_given": ("Исходные данные", "Given"),
    "note_structure": ("Структурный анализ", "Structure"),
    "note_position": ("План положения", "Position plan"),
    "note_velocity": ("План скоростей", "Velocity plan"),
    "note_acceleration": ("План ускорений", "Acceleration plan"),
    "note_group": ("Силовой расчёт группы {links}", "Forces of the group {links}"),
    "note_driver": ("Силовой расчёт ведущего звена {links}", "Forces of the driver {links}"),
    "note_lever": ("Проверка рычагом Жуковского", "Check by Zhukovsky's lever"),
    "note_results": ("Результаты", "Results"),
    "note_task": (
        "Задан механизм «{title}». Требуется методом планов найти скорости и ускорения точек, угловые скорости и "
        "ускорения звеньев, реакции в кинематических парах и уравновешивающую нагрузку в положении {drive}.",
        "For the mechanism “{title}” find, by the method of plans, velocities and accelerations of points, angular "
        "velocities and accelerations of links, reactions in the pairs and the balancing load at {drive}.",
    ),
    "note_freedom": (
        "Подвижных звеньев n = {n}, низших пар p₅ = {p}, высших пар нет. Степень подвижности по Чебышёву "
        "W = 3n − 2p₅ = 3 · {n} − 2 · {p} = {W}; избыточных связей по Решетову q = {q}.",
        "Moving links n = {n}, lower pairs p₅ = {p}, no higher pairs. By Chebyshev W = 3n − 2p₅ = 3 · {n} − 2 · {p} = "
        "{W}; redundant constraints by Reshetov q = {q}.",
    ),
    "note_formula": ("Формула строения: {formula}.", "Formula of structure: {formula}."),
    "note_group_kind": (
        "Группа звеньев {links}: II класс, {kind}-й вид ({name}).",
        "Group of links {links}: class II, kind {kind} ({name}).",
    ),
    "note_difference": (
        "Уравновешивающая нагрузка из плана сил {found} {unit}, по рычагу Жуковского {check} {unit}; расхождение "
        "{percent} %.",
        "The balancing load is {found} {unit} by the force plan and {check} {unit} by Zhukovsky's lever; they differ "
        "by {percent} %.",
    ),
    "note_figure": ("Рисунок {number} — {title}", "Figure {number}. {title}"),
    "note_table": ("Таблица {number} — {title}", "Table {number}. {title}"),
    "note_warning": ("Замечание: {text}.", "Remark: {text}."),
    "note_no_forces": (
        "Масс и нагрузок в задании нет, поэтому силовой расчёт не выполняется.",
        "The assignment gives neither masses nor loads, so there is no calculation of forces.",
    ),
    "note_given_table": ("Размеры, движение, массы и нагрузки", "Dimensions, motion, masses and loads"),
    "note_points_table": ("Скорости и ускорения точек", "Velocities and accelerations of points"),
    "note_links_table": ("Угловые скорости и ускорения звеньев", "Angular velocities and accelerations of links"),
    "note_reactions_table": ("Реакции в кинематических парах", "Reactions in the pairs"),
    "note_scheme": ("схема механизма, μ = {mu}", "the scheme of the mechanism, μ = {mu}"),
    "note_plan": ("{plan}, μ = {mu}", "{plan}, μ = {mu}"),
    "note_unit": ("Единица", "Unit"),
    "note_point": ("Точка", "Point"),
    "note_link": ("Звено", "Link"),
    "note_angle": ("угол, °", "angle, °"),
    "reaction": ("Реакция", "Reaction"),
    "note_suffix": (
        "{file}: записка пишется в .html, .pdf или .docx",
        "{file}: a note is written as .html, .pdf or .docx",
    ),
    "note_one": (
        "записка пишется для одного положения, а задано {count}; укажите одно значение",
        "a note is written for one position, but {count} were asked for; give one value",
    ),
    "lesson_suffix": ("{file}: урок пишется в .html", "{file}: a lesson is written as .html"),
    "no_docx": (
        "для .docx нужен пакет python-docx: pip install python-docx; или укажите .html или .pdf",
        ".docx needs the package python-docx: pip install python-docx; or ask for .html or .pdf",
    ),
}
