"""Words for what the integrated calculation of a crank-slider cannot take: key to Russian and English."""

CRANK_SLIDER: dict[str, tuple[str, str]] = {
    "cs_missing": (
        "в сцене нет ключа crank_slider: в нём диаметр поршня, индикаторная диаграмма и размеры деталей",
        "the scene has no key crank_slider, which gives the bore, the indicator diagram and the sizes of the parts",
    ),
    "cs_not_one": (
        "это не кривошипно-ползунный механизм: нужны кривошип на стойке, шатун и ползун на направляющей стойки, а "
        "строение здесь {formula}",
        "this is no crank-slider: it needs a crank on the frame, a rod and a slider on a guide of the frame, but the "
        "structure is {formula}",
    ),
    "cs_guide": (
        "направляющая {name} должна быть горизонтальной и проходить через опору кривошипа {pivot}, как на схеме "
        "расчёта; поверните или сдвиньте оси",
        "the guide {name} must be horizontal and pass through the crank's pivot {pivot}, as in the calculation's "
        "scheme; turn or shift the axes",
    ),
    "cs_slide": (
        "ползун {name} должен нести шарнир {point} в своей первой точке, на направляющей, без поворота и смещения",
        "slider {name} must carry the hinge {point} in its first point, on the guide, with no angle and no offset",
    ),
    "cs_behind": (
        "ползун должен стоять справа от опоры кривошипа (assembly: {{{point}: ahead}})",
        "the slider must stand to the right of the crank's pivot (assembly: {{{point}: ahead}})",
    ),
    "cs_crank_axis": (
        "кривошип {name}: точка {point} должна лежать на его оси x, справа от опоры",
        "crank {name}: the point {point} must lie on its x axis, to the right of the pivot",
    ),
    "cs_rod_centre": (
        "шатун {name}: центр масс {point} должен лежать на отрезке AB; масса заменяется точками на этой прямой",
        "rod {name}: the mass centre {point} must lie between its hinges; its mass is replaced by points of that line",
    ),
    "cs_slider_centre": (
        "ползун {name}: центр масс должен быть в шарнире {point}",
        "slider {name}: the mass centre must be in the hinge {point}",
    ),
    "cs_short_rod": (
        "шатун ({rod:g} м) должен быть длиннее кривошипа ({crank:g} м), иначе кривошип не провернётся",
        "the rod ({rod:g} m) must be longer than the crank ({crank:g} m), or the crank cannot turn",
    ),
    "cs_no_mass": (
        "звено {name}: нужен ключ {key}; без него силы инерции не найти",
        "link {name} needs the key {key}; without it there are no inertia forces",
    ),
    "cs_loads": (
        "в комплексном расчёте нагрузка на поршень берётся из индикаторной диаграммы; уберите loads",
        "the integrated calculation takes the piston's load from the indicator diagram; remove loads",
    ),
    "cs_omega": (
        "omega кривошипа должна быть положительной (против часовой стрелки), а задано {value:g}",
        "omega of the crank must be positive (counter-clockwise), but is {value:g}",
    ),
    "cs_epsilon": (
        "расчёт идёт по циклу, epsilon = {value:g} на нём не удержать; задайте закон вращения в crank_slider.speed",
        "the calculation goes over a cycle, which epsilon = {value:g} cannot last; give the law of rotation in "
        "crank_slider.speed",
    ),
    "cs_positive": ("{what}: нужно число больше нуля, а дано {value:g}", "{what} must be above zero, but is {value:g}"),
    "cs_range": (
        "{what}: нужно число от {low:g} до {high:g}, а дано {value:g}",
        "{what} must lie between {low:g} and {high:g}, but is {value:g}",
    ),
    "cs_step": (
        "{what}: шаг должен целое число раз укладываться в 15°, а дано {value:g}",
        "{what} must go a whole number of times into 15°, but is {value:g}",
    ),
    "cs_stages": (
        "indicator: нет хода {stage}; четырёхтактная диаграмма состоит из intake, compression, expansion, exhaust, "
        "двухтактная из compression, expansion",
        "indicator: the stage {stage} is missing; a four-stroke diagram has intake, compression, expansion, exhaust, "
        "a two-stroke one compression, expansion",
    ),
    "cs_two_points": (
        "{what}: нужны хотя бы две точки [{variable}, p]",
        "{what} needs at least two points [{variable}, p]",
    ),
    "cs_point": ("{what}: точка — это два числа [{variable}, p]", "{what}: a point is two numbers [{variable}, p]"),
    "cs_order": (
        "{what}: {variable} должны идти подряд от {start:g} до {end:g}, а после {one:g} стоит {two:g}",
        "{what}: {variable} must run from {start:g} to {end:g}, but {two:g} follows {one:g}",
    ),
    "cs_ends": (
        "{what}: ход начинается при {variable} = {start:g} и кончается при {end:g}, а таблица идёт от {one:g} до "
        "{two:g}",
        "{what}: the stage begins at {variable} = {start:g} and ends at {end:g}, but the table goes from {one:g} to "
        "{two:g}",
    ),
    "cs_joint": (
        "indicator: ход {one} кончается давлением {first:g}, а ход {two} начинается с {second:g}; концы должны "
        "совпадать",
        "indicator: the stage {one} ends with the pressure {first:g}, but {two} begins with {second:g}; they must meet",
    ),
    "cs_pressure": (
        "{what}: абсолютное давление не бывает отрицательным, а дано {value:g}",
        "{what}: an absolute pressure cannot be negative, but is {value:g}",
    ),
    "cs_no_steel": ("{what}: такой стали нет в таблице{valid}", "{what}: that steel is not in the table{valid}"),
    "cs_yield": (
        "{what}: предел текучести {one:g} МПа не может быть выше предела прочности {two:g} МПа",
        "{what}: the yield point {one:g} MPa cannot be above the strength {two:g} MPa",
    ),
    "cs_span": (
        "shaft: щёки в {webs:g} м от опор не умещаются по сторонам шатунной шейки (она в {left:g} м от опоры A и в "
        "{right:g} м от опоры B)",
        "shaft: the webs, {webs:g} m from the bearings, find no place beside the crank pin ({left:g} m from bearing "
        "A, {right:g} m from bearing B)",
    ),
    "cs_thin": (
        "{what}: сечение слишком тонкое: {inner:g} м не меньше {outer:g} м, материала не остаётся",
        "{what}: the section is too thin: {inner:g} m is not below {outer:g} m, so no material is left",
    ),
    "cs_thin_stress": (
        "{part}: сечение слишком тонкое, напряжение {stress:.4g} МПа выше предела прочности {strength:g} МПа; "
        "увеличьте сечение или возьмите другую сталь",
        "{part}: the section is too thin, its stress {stress:.4g} MPa is above the strength {strength:g} MPa; take a "
        "larger section or another steel",
    ),
    "cs_journal_A": ("коренная шейка A", "journal A"),
    "cs_journal_B": ("коренная шейка B", "journal B"),
    "cs_web_A": ("щека A", "web A"),
    "cs_web_B": ("щека B", "web B"),
    "cs_crankpin": ("шатунная шейка", "crank pin"),
    "cs_rod": ("стержень шатуна", "the rod's shank"),
    "cs_piston_pin": ("поршневой палец", "piston pin"),
    "cs_crank_mass": (
        "статический момент кривошипа по links ({link:.4g} кг·м) расходится с shaft.masses ({shaft:.4g} кг·м); "
        "исправьте массу и центр масс звена {name} или массы вала",
        "the crank's static moment by links ({link:.4g} kg·m) differs from shaft.masses ({shaft:.4g} kg·m); correct "
        "the mass and centre of link {name} or the masses of the shaft",
    ),
    "cs_needs": ("{what} нужен для {other}; добавьте его", "{what} is needed for {other}; add it"),
    "cs_pin_length": (
        "piston_pin: между бобышками {gap:g} м, а втулка шатуна {bush:g} м и палец {length:g} м; нужно втулка ≤ "
        "зазор < палец",
        "piston_pin: the bosses are {gap:g} m apart, the bush is {bush:g} m and the pin {length:g} m; it must be "
        "bush ≤ gap < pin",
    ),
    "cs_locked": (
        "при φ = {phi:g}° поршень с трением f = {f:g} заклинивает: условие f·tg β < 1 не выполнено",
        "at φ = {phi:g}° the piston locks with friction f = {f:g}: f·tan β < 1 does not hold",
    ),
    "cs_engine": (
        "при φ = {phi:g}° общий расчёт планов не дал чисел",
        "at φ = {phi:g}° the general plans give no numbers",
    ),
    "help_crank_slider": (
        "комплексный расчёт кривошипно-ползунного механизма: кинематика, силы, уравновешивание, прочность",
        "the integrated calculation of a crank-slider: kinematics, forces, balancing, strength",
    ),
    "help_report": ("файл отчёта: .html, .pdf или .json", "the report's file: .html, .pdf or .json"),
    "help_force_sheet": (
        "ещё и чертёжный лист с планами одного положения: .svg, .pdf, .png или .dxf",
        "also a drawing sheet with the plans of one position: .svg, .pdf, .png or .dxf",
    ),
    "help_sheet_phi": (
        "положение для листа, градусы (без него — самое нагруженное из positions)",
        "the sheet's position, degrees (without it the most loaded of positions)",
    ),
    "cs_phi": (
        "--phi {value:g}: цикл идёт от {low:g}° до {high:g}°",
        "--phi {value:g}: the cycle goes from {low:g}° to {high:g}°",
    ),
    "cs_suffix": (
        "{file}: отчёт пишется в .html, .pdf, .docx или .json",
        "{file}: the report is written as .html, .pdf, .docx or .json",
    ),
}
