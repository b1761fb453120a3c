"""Words for what a scene cannot mean: key to Russian and English.

A Russian noun has two forms, "звено 2|звена 2": the second is taken where a sentence asks for {what:of}.
"""

SCENE: dict[str, tuple[str, str]] = {
    # what a sentence is about
    "about": ("{what}: {why}", "{what}: {why}"),
    "section": ("{name}|в {name}", "{name}"),
    "part": ("{key} {what:of}|в {key} {what:of}", "{key} of {what}"),
    "entry": ("элемент {number} {what:of}", "entry {number} of {what}"),
    "the_scene": ("сцена|сцены", "the scene"),
    "the_frame": ("стойка|стойки", "the frame"),
    "link": ("звено {name}|звена {name}", "link {name}"),
    "point": ("точка {name} {owner:of}|точки {name} {owner:of}", "point {name} of {owner}"),
    "guide_named": ("направляющая {name}|направляющей {name}", "guide {name}"),
    "guide_of_slider": ("направляющая, по которой скользит {what}", "guide {what} slides on"),
    "load": ("нагрузка {number}|нагрузки {number}", "load {number}"),
    "vector": ("вектор {name}|вектора {name}", "vector {name}"),
    "variant": ("вариант {name}|варианта {name}", "variant {name}"),
    "parameter": ("параметр {name}|параметра {name}", "parameter {name}"),
    "equation": ("уравнение {number}", "equation {number}"),
    "the_plan": ("{plan}|{plan:of}", "the {plan}"),
    "plan_key": ("план {name}|плана {name}", "plan {name}"),
    "assembly_of": ("assembly для {name}|в assembly для {name}", "assembly of {name}"),
    "friction_of": ("friction для {name}", "friction of {name}"),
    "gravity": ("gravity (направлено вниз)", "gravity (it acts downwards)"),
    # of what a name is; the second form after "имя"
    "a_point": ("точка|точки", "a point"),
    "a_link": ("звено|звена", "a link"),
    "a_guide": ("направляющая|направляющей", "a guide"),
    "a_mark": ("метка|метки", "a mark"),
    "a_variant": ("вариант|варианта", "a variant"),
    # among what a name is looked for; the second form after "среди"
    "points_all": ("точки|точек", "point"),
    "points_of": ("точки {owner:of}|точек {owner:of}", "point of {owner}"),
    "links_all": ("звенья|звеньев", "link"),
    "guides_all": ("направляющие|направляющих", "guide"),
    "parameters_all": ("параметры|параметров", "parameter"),
    "sliding_pairs": ("поступательные пары|поступательных пар", "sliding pair"),
    # what a value is
    "a_table": ("таблица", "a table"),
    "a_list": ("список", "a list"),
    "empty": ("пустое место", "empty"),
    # what would have been valid
    "valid": ("; допустимо: {names}{near}", "; valid: {names}{near}"),
    "valid_some": ("; допустимо (часть): {names}{near}", "; valid (some of them): {names}{near}"),
    "valid_drawn": ("; уже построено: {names}{near}", "; drawn so far: {names}{near}"),
    "near_name": ("; имелось в виду {name}?", "; did you mean {name}?"),
    "near_alike": (
        "; {name} выглядит так же, но написано другими буквами (латиница и кириллица)",
        "; {name} looks the same but is written in other letters (Latin and Cyrillic)",
    ),
    "none_defined": ("; {of:of} там не задано", "; no {of} is defined there"),
    # any value
    "table_needed": (
        "{what}: нужна таблица «ключ: значение», а не {kind}",
        "{what} must be a table of 'key: value', not {kind}",
    ),
    "list_needed": ("{what}: нужен список, а не {kind}", "{what} must be a list, not {kind}"),
    "list_long": (
        "{what}: {count} — больше, чем есть места; не больше {most}",
        "{what} has {count} entries, more than there is room for; at most {most}",
    ),
    "word_needed": ("{what}: нужно слово, а не {kind}", "{what} must be a word, not {kind}"),
    "number_needed": ("{what}: нужно число, а не {kind}{hint}", "{what} must be a number, not {kind}{hint}"),
    "only_number": ("{what}: нужно число", "{what} must be a number"),
    "decimal_fraction": ("; десятичную дробь пишут через точку", "; a decimal fraction is written with a point"),
    "decimal_no_comma": (
        "; десятичную дробь пишут через точку, а не через запятую",
        "; a decimal fraction is written with a point, not a comma",
    ),
    "no_key": ("{what}: неизвестный ключ {key}{valid}", "{what} has no key {key}{valid}"),
    "no_value": ("{what}: нет значения", "{what} has no value"),
    "long_name": (
        "имя {of:of} {name} длиннее {most} знаков",
        "the name {name} of {of} is longer than {most} characters",
    ),
    "bad_name": (
        "{name} не может быть именем {of:of}; допустимы буквы любого алфавита, цифры, _ - и ' без пробелов",
        "{name} cannot be the name of {of}; valid are letters of any alphabet, digits, _ - and ' without spaces",
    ),
    "bad_word": ("{what}: {word} не подходит{valid}", "{what} cannot be {word}{valid}"),
    "unknown_name": ("{what}: среди {of:of} нет {name}{valid}", "{what}: there is no {of} {name}{valid}"),
    "negative": (
        "{what}: значение не может быть отрицательным, а дано {value:g}",
        "{what} cannot be negative, but is {value:g}",
    ),
    "out_of_range": (
        "{what}: {value:g} вне пределов, в которых можно считать; наибольшее допустимое число {most:g}",
        "{what} is {value:g}, beyond what can be calculated with; the largest number that may be given is {most:g}",
    ),
    "needs_key": ("{what}: нужен ключ {key}", "{what} needs the key {key}"),
    "needs_one_key": ("{what}: нужен один из ключей {keys}", "{what} needs one of the keys {keys}"),
    "both_keys": (
        "{what}: заданы и {one}, и {two}; оставьте что-нибудь одно",
        "{what} has both {one} and {two}; write one of them",
    ),
    "place_needed": (
        "{what}: нужно [x, y] или {{r: ..., angle: ...}}, а не {given}",
        "{what} must be [x, y] or {{r: ..., angle: ...}}, not {given}",
    ),
    "pair_needed": (
        "{what}: нужны два числа [x, y], а здесь их {count}{hint}",
        "{what} must be [x, y], two numbers, not {count}{hint}",
    ),
    # the scene as a whole
    "no_format": (
        'нет строки "planes: 1"; она есть в каждом файле сцены',
        'the line "planes: 1" is missing; every scene file has it',
    ),
    "other_format": (
        "формат {version} файлов сцены неизвестен; эта программа читает planes: 1",
        "format {version} of scene files is not known; this program reads planes: 1",
    ),
    "mu_place": (
        "mu механизма записывают в plans: {{velocity: {{mu: ...}}}}",
        "mu of a mechanism is written under plans: {{velocity: {{mu: ...}}}}",
    ),
    "two_scenes": (
        "сцена задаёт либо механизм ({mechanism}), либо только {vectors}, но не то и другое",
        "a scene states either a mechanism ({mechanism}) or {vectors} alone, not both",
    ),
    "part_missing": ("нет ключа {key}; например: {example}", "the key {key} is missing; for example: {example}"),
    "part_empty": ("{what}: здесь пусто", "{what} is empty"),
    "no_variant": ("нет варианта {name}{valid}", "there is no variant {name}{valid}"),
    "no_variants": ("; вариантов в сцене нет", "; the scene has no variants"),
    # what can be meant, but hardly is
    "doubt_empty": (
        "{key}: значения нет, и ключ не действует; впишите значение или уберите ключ",
        "{key} has no value and so no effect; write one or remove the key",
    ),
    "doubt_radians": (
        "{key} = {text}: углы задают в градусах, а это похоже на радианы; в градусах пишут, например, 60",
        "{key} = {text}: angles are in degrees, and this looks like radians; in degrees write 60, for instance",
    ),
    "doubt_ratio": (
        "{key} = {text}: здесь нужен угол в градусах, а это отношение сторон; угол даёт, например, asin",
        "{key} = {text}: this should be an angle in degrees but is a ratio of sides; asin gives an angle",
    ),
    "doubt_friction": (
        "friction направляющей {guide} равен {value:g}; коэффициент трения обычно меньше 1",
        "friction of {guide} is {value:g}; a coefficient of friction is usually less than 1",
    ),
    "doubt_point": (
        "{key} звена {link} стоит в points и считается точкой; если это свойство звена, вынесите {key} из points",
        "{key} of link {link} stands under points and is taken for a point; if a property of the link is meant, move "
        "{key} out of points",
    ),
    "doubt_massless": (
        "у звена {link} задан inertia, но нет mass: сила инерции и вес приняты равными нулю",
        "link {link} has inertia but no mass, so its force of inertia and its weight are taken as zero",
    ),
    "doubt_long": (
        "звено {link} длиной {size} м: длины задают в метрах; если это миллиметры, пишите {less}",
        "link {link} is {size} m long: lengths are in metres; if millimetres are meant, write {less}",
    ),
    "doubt_at_rest": (
        "в drive нет {key}: ведущее звено стоит, и все скорости равны нулю",
        "drive has no {key}: the driver stands still, and all velocities are zero",
    ),
    "doubt_no_crank": (
        "ведущее звено {link} длиной 0: его точки совпадают и неподвижны",
        "the driver {link} has length 0: its points coincide and do not move",
    ),
    # parameters, variants, results
    "reserved_parameter": (
        "параметр нельзя назвать {name}: в выражениях это имя уже занято",
        "a parameter cannot be named {name}, which has a meaning in expressions already",
    ),
    "bad_parameter": (
        "{name} не может быть именем параметра; допустимы буквы, цифры и _, первой буква, не больше {most} знаков",
        "{name} cannot be the name of a parameter; valid are letters, digits and _, a letter first, at most {most} of "
        "them",
    ),
    "no_parameter": (
        "вариант {name} меняет {key}, но такого параметра нет{valid}",
        "variant {name} overrides {key}, which is no parameter{valid}",
    ),
    "parameter_unknown": ("параметра {name} в сцене нет{valid}", "{name} is no parameter of the scene{valid}"),
    "no_font": (
        "sheet.font: шрифт {name} не установлен{valid}; назовите установленный или файл .ttf, .otf",
        "sheet.font: no font {name} is installed{valid}; name an installed one or a file .ttf, .otf",
    ),
    "no_font_file": (
        "sheet.font: файла {file} нет; путь считается от папки сцены",
        "sheet.font: there is no file {file}; its path is taken from the scene's folder",
    ),
    "bad_font": (
        "sheet.font: {name} не читается как шрифт TrueType или OpenType ({why}); возьмите другой файл",
        "sheet.font: {name} cannot be read as a TrueType or OpenType font ({why}); take another file",
    ),
    "find_empty": (
        "find: здесь пусто; уберите find, чтобы получить все величины",
        "find is empty; leave it out to get every result",
    ),
    "bad_result": (
        "find: {name} не может быть именем величины; имена выглядят так: v_C, omega_2, F_21",
        "find: {name} cannot be the name of a result; names look like v_C, omega_2, F_21",
    ),
}
