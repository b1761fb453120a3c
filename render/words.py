"""Words of the sheets, in Russian and in English, and numbers as each language writes them."""

from __future__ import annotations

from planes.units import quantity
from planes.words import Lang

WORDS: dict[str, tuple[str, str]] = {
    "scheme": ("Схема механизма", "Scheme of the mechanism"),
    "velocity": ("План скоростей", "Velocity plan"),
    "acceleration": ("План ускорений", "Acceleration plan"),
    "force_group": ("План сил группы {links}", "Force plan of group {links}"),
    "force_driver": ("План сил ведущего звена {links}", "Force plan of driver {links}"),
    "lever": ("Рычаг Жуковского", "Zhukovsky's lever"),
    "vectors": ("Векторный многоугольник", "Vector polygon"),
    "equations": ("Векторные уравнения", "Vector equations"),
    "balance_equations": ("Уравнения равновесия", "Equations of balance"),
    "moments": ("Уравнения моментов", "Moment equations"),
    "by_velocity": ("Измерено на плане скоростей", "Measured on the velocity plan"),
    "by_acceleration": ("Измерено на плане ускорений", "Measured on the acceleration plan"),
    "measured": ("Измерено на плане", "Measured on the plan"),
    "shifted": ("векторы одной прямой раздвинуты", "vectors of one line are drawn side by side"),
    "given": ("Исходные данные", "Given"),
    "found": ("Результаты кинематики", "Results of kinematics"),
    "points_table": ("Скорости и ускорения точек", "Velocities and accelerations of points"),
    "links_table": ("Угловые скорости и ускорения звеньев", "Angular velocities and accelerations of links"),
    "slides_table": ("Движение ползунов по направляющим", "Sliders along their guides"),
    "reactions_table": ("Реакции", "Reactions"),
    "check_table": ("Уравновешивание и проверка", "Balancing and check"),
    "structure": ("Структура механизма", "Structure of the mechanism"),
    "primary": ("первичный механизм: I класс", "primary mechanism: class I"),
    "loaded": ("Схема нагружения", "Loads on the mechanism"),
    "loaded_group": ("Группа {links} с силами", "Group {links} with its forces"),
    "loaded_driver": ("Первичный механизм {links} с силами", "Primary mechanism {links} with its forces"),
    "links_apart": ("Звенья {links} порознь", "Links {links} apart"),
    "diagrams_slider": ("Диаграммы движения ползуна {link}", "Motion diagrams of slider {link}"),
    "diagrams_asked": ("Диаграммы за цикл", "Diagrams over the cycle"),
    "diagrams_link": ("Диаграммы движения звена {link}", "Motion diagrams of link {link}"),
    "differentiation": (
        "Графическое дифференцирование методом хорд, звено {link}",
        "Graphical differentiation by chords, link {link}",
    ),
    "integration": ("Графическое интегрирование, звено {link}", "Graphical integration, link {link}"),
    "graphical_drawn": ("построено", "drawn"),
    "graphical_exact": ("точно", "exact"),
    "s": ("с", "s"),
    "rad": ("рад", "rad"),
    "self_aligning": ("Самоустанавливающийся вариант механизма", "Self-aligning variant of the mechanism"),
    "short_R": ("1в", "1R"),
    "short_P": ("1п", "1P"),
    "short_C": ("2ц", "2C"),
    "short_S": ("3с", "3S"),
    "pair_R": ("вращательная 1в, {cls} класс", "revolute 1R, class {cls}"),
    "pair_P": ("поступательная 1п, {cls} класс", "prismatic 1P, class {cls}"),
    "pair_C": ("цилиндрическая 2ц, {cls} класс", "cylindrical 2C, class {cls}"),
    "pair_S": ("сферическая 3с, {cls} класс", "spherical 3S, class {cls}"),
    "hodograph": ("Годограф {name}", "Hodograph of {name}"),
    "sheet_1": ("Структурный и кинематический анализ", "Structure and kinematics"),
    "sheet_2": ("Силовой расчёт", "Force analysis"),
    "point": ("Точка", "Point"),
    "link": ("Звено", "Link"),
    "slider": ("Ползун", "Slider"),
    "quantity": ("Величина", "Quantity"),
    "value": ("Значение", "Value"),
    "unit": ("Ед.", "Unit"),
    "pair": ("Пара", "Pair"),
    "angle": ("Угол, °", "Angle, °"),
    "arm": ("Плечо, м", "Arm, m"),
    "balancing_moment": ("Из плана сил", "From the force plan"),
    "balancing_force": ("Из плана сил", "From the force plan"),
    "zhukovsky": ("По рычагу Жуковского", "By Zhukovsky's lever"),
    "difference": ("Расхождение, %", "Difference, %"),
    "balance": ("ур", "b"),
    "chebyshev": ("Степень подвижности по Чебышёву", "Degree of freedom (Chebyshev)"),
    "reshetov": ("Избыточные связи по Решетову", "Redundant constraints (Reshetov)"),
    "formula": ("Формула строения", "Formula of structure"),
    "group": ("группа {links}: II класс, {kind}-й вид", "group {links}: class II, kind {kind}"),
    "on_from": ("F_{ij}: сила на звено i со стороны звена j", "F_{ij}: the force on link i from link j"),
    "from_on": ("F_{ij}: сила со стороны звена i на звено j", "F_{ij}: the force from link i on link j"),
    "ccw": ("против ч. с.", "counter-clockwise"),
    "cw": ("по ч. с.", "clockwise"),
    "m": ("м", "m"),
    "mm": ("мм", "mm"),
    "kg": ("кг", "kg"),
    "kgm2": ("кг·м²", "kg·m²"),
    "m/s": ("м/с", "m/s"),
    "m/s²": ("м/с²", "m/s²"),
    "rad/s": ("рад/с", "rad/s"),
    "rad/s²": ("рад/с²", "rad/s²"),
    "N": ("Н", "N"),
    "W": ("Вт", "W"),
    "N·m": ("Н·м", "N·m"),
    "1/m": ("1/м", "1/m"),
    "1/m²": ("1/м²", "1/m²"),
    "line_axis": ("штрихпунктирная тонкая ГОСТ 2.303", "thin chain line, GOST 2.303"),
    "line_phantom": ("штрихпунктирная с двумя точками ГОСТ 2.303", "chain line with two dots, GOST 2.303"),
    "line_dash": ("штриховая ГОСТ 2.303", "dashed line, GOST 2.303"),
    "layer_construction": ("Построения", "Construction lines"),
    "layer_axis": ("Осевые линии", "Axes"),
    "layer_hatch": ("Штриховка", "Hatching"),
    "layer_table": ("Таблицы", "Tables"),
    "layer_dimension": ("Размеры", "Dimensions"),
    "layer_frame": ("Рамка и основная надпись", "Frame and title block"),
    "layer_scheme": ("Схема механизма", "Scheme of the mechanism"),
    "layer_plan": ("Планы: векторы", "Plans: vectors"),
    "layer_force": ("Силы", "Forces"),
    "layer_result": ("Планы: результаты", "Plans: results"),
    "layer_text": ("Надписи", "Lettering"),
    "no_room": (
        "лист {format}: вид «{view}» ({width} × {height} мм) не помещается; поместится на формате {larger} или при "
        "меньшем масштабе",
        "sheet {format}: the view “{view}” ({width} × {height} mm) does not fit; it would on {larger} or at a smaller "
        "scale",
    ),
    "no_room_at_all": (
        "лист: вид «{view}» ({width} × {height} мм) не помещается даже на А1; уменьшите μ этого вида",
        "sheet: the view “{view}” ({width} × {height} mm) does not fit even on A1; lower the μ of this view",
    ),
    "left_out_larger": (
        "лист {format}: не поместились и опущены {views}; поместятся на формате {larger}",
        "sheet {format}: {views} found no room and were left out; {larger} would hold them",
    ),
    "left_out_sheet": (
        "лист {format}: не поместились и опущены {views}; они есть на листе 2 проекта (--sheet 2)",
        "sheet {format}: {views} found no room and were left out; sheet 2 of the project has them (--sheet 2)",
    ),
    "left_out": (
        "лист {format}: не поместились и опущены {views}; поместятся при меньшем μ",
        "sheet {format}: {views} found no room and were left out; a smaller μ would make room",
    ),
    "bad_suffix": (
        "{file}: файл листа должен оканчиваться на {known}",
        "{file}: the file of a sheet must end in {known}",
    ),
    "unwritable": ("{file}: не записать: {reason}", "{file}: cannot be written: {reason}"),
    "needs_ezdxf": (
        "для файла .dxf нужна библиотека ezdxf: pip install ezdxf",
        "a .dxf file needs the library ezdxf: pip install ezdxf",
    ),
    "bad_format": (
        "sheet: формат {format} неизвестен; допустимы {known}",
        "sheet: there is no format {format}; valid: {known}",
    ),
    "bad_view": ("вида {view} у этой сцены нет; есть {known}", "this scene has no view {view}; it has {known}"),
    "empty_view": ("в виде {view} этой сцены нечего чертить", "the view {view} of this scene has nothing to draw"),
    "one_position": (
        "лист чертится для одного положения, а задано {count}; укажите одно значение",
        "a sheet is drawn for one position, but {count} were asked for; give one value",
    ),
}


def say(key: str, lang: Lang, **names: object) -> str:
    """The words of a key in a language; braces of indices are kept where nothing is to be filled in."""
    text = WORDS[key][0 if lang == "ru" else 1]
    return text.format(**names) if names else text


def decimal(text: str, lang: Lang) -> str:
    """A printed number with a true minus and the decimal sign of the language."""
    text = text.replace("-", "−")
    return text.replace(".", ",") if lang == "ru" else text


def number(value: float | None, lang: Lang, digits: int = 4) -> str:
    """A number for people, a dash for none."""
    return "—" if value is None else decimal(quantity(0.0 if value == 0 else value, "", digits), lang)
