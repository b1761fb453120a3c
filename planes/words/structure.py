"""Words for what the method or the program cannot do, and of the command line: key to Russian and English."""

METHOD: dict[str, tuple[str, str]] = {
    # structure
    "wrong_freedom": (
        "у механизма W = 3·{links} - 2·{pairs} = {freedom}, а при одном ведущем звене нужно W = 1; {hint} (пары: "
        "{listed:; })",
        "the mechanism has W = 3·{links} - 2·{pairs} = {freedom}, one drive needs W = 1; {hint} (pairs: {listed:; })",
    ),
    "freedom_more": (
        "в замкнутых контурах не хватает звена или пары",
        "a link or a pair is missing from the closed loops",
    ),
    "freedom_less": (
        "лишних связей {count}: проверьте имена, ведь точки с одним именем в двух звеньях образуют шарнир",
        "it has {count} constraint(s) too many: check the names, for points of one name in two links make a hinge",
    ),
    "hinge_pair": ("{point} звеньев {links}", "{point} of links {links}"),
    "slide_pair": ("{link} скользит по {guide} звена {owner}", "{link} slides on {guide} of {owner}"),
    "driver_pair": (
        "ведущему звену {link}, заданному через {kind}, {need}, а со стойкой его соединяют: {have}",
        "the driver {link} given by {kind} needs exactly {need}, but what joins it to the frame is: {have}",
    ),
    "a_hinge": ("шарнир {name}", "hinge {name}"),
    "a_slide": ("направляющая {name} (поступательная пара)", "guide {name} (a sliding pair)"),
    "need_hinge": ("нужен ровно один шарнир на стойке", "one hinge on the frame"),
    "need_guide": ("нужна ровно одна направляющая стойки", "one guide of the frame to slide on"),
    "three_slides": (
        "звенья {one} и {two} соединены между собой и с остальными тремя поступательными парами: поворачиваться они не "
        "могут, и W для них неверна; замените одну из пар вращательной",
        "links {one} and {two} meet each other and the rest in three sliding pairs: they cannot turn, so W is wrong "
        "there; make one of the pairs a hinge",
    ),
    "hinges_coincide": (
        "шарниры {one} и {two} звена {link} совпадают: длина {one}{two} равна нулю, и направление звена не определено; "
        "задайте её",
        "hinges {one} and {two} of link {link} coincide: the length {one}{two} is zero, and the link has no direction; "
        "give it a length",
    ),
    "locked_slides": (
        "звенья {one} и {two} скользят по направляющим одного и того же звена {owner}, поэтому относительно него "
        "неподвижны; проверьте их slides",
        "links {one} and {two} both slide on guides of link {owner} and cannot move against it; check their slides",
    ),
    "overconstrained": (
        "звенья {names}: лишних пар {count} (W = {freedom}), а другие звенья не закреплены; проверьте, какие точки у "
        "них общие",
        "links {names} are held by {count} pair(s) too many (W = {freedom}) while others hang loose: check which "
        "points they share",
    ),
    "higher_class": (
        "звенья {names} образуют группу Ассура III класса или выше, а планами групп II класса её не построить; "
        "возьмите ведущим другое звено или измените механизм",
        "links {names} form an Assur group of class III or higher, which plans of class II groups cannot draw: take "
        "another link as the driver or change the mechanism",
    ),
    "loose_links": (
        "звенья {names} не присоединяются к ведущему звену и уже найденным группам; проверьте их общие точки",
        "links {names} do not attach to the driven part: check their shared points",
    ),
    # assembly
    "order_misfit": (
        "assembly {key}: {order} не подходит к группе {name} (звенья {links}); допустимо: {one}, {two} или {{near: [x, "
        "y]}}",
        "assembly {key}: {order} does not fit a group {name} (links {links}); valid: {one}, {two} or {{near: [x, y]}}",
    ),
    "near_not_drawn": (
        "assembly {key}: ближайшую сборку не найти, потому что в заданном положении ведущего звена {failure}",
        "assembly {key}: the nearer place cannot be found, because at the drive's value {failure}",
    ),
    "near_same": (
        "assembly {key}: точка {point} в обеих сборках на одном месте, near их не различает; назовите другую точку "
        "группы",
        "assembly {key}: point {point} is at the same place in both assemblies, so near cannot tell them apart; name "
        "another point of the group",
    ),
    "two_assemblies": (
        "группу звеньев {links} ({name}) можно собрать двумя способами, а каким, в сцене не сказано; добавьте "
        "{offers: или }",
        "links {links} ({name}) can be assembled in two ways and the scene does not say which; add {offers: or }",
    ),
    "two_more_assemblies": (
        "группу звеньев {links} ({name}) можно собрать двумя способами, а каким, в сцене не сказано; допишите в "
        "assembly: {offers: или }",
        "links {links} ({name}) can be assembled in two ways and the scene does not say which; add to assembly: "
        "{offers: or }",
    ),
    "assembly_more": ("{key}: {word}", "{key}: {word}"),
    "assembly_more_at": (
        "{key}: {word} (тогда {key} в ({x:.5g}, {y:.5g}))",
        "{key}: {word} for {key} at ({x:.5g}, {y:.5g})",
    ),
    "assembly_offer": ("assembly: {{{key}: {word}}}", "assembly: {{{key}: {word}}}"),
    "assembly_offer_at": (
        "assembly: {{{key}: {word}}} (тогда {key} в ({x:.5g}, {y:.5g}))",
        "assembly: {{{key}: {word}}} for {key} at ({x:.5g}, {y:.5g})",
    ),
    # things of a drawing
    "line_through": ("{along} через {start}", "{along} through {start}"),
    "line_guide": ("направляющей {name}", "of guide {name}"),
    "line_beside": ("точки {point} вдоль направляющей {name}", "of {point} along guide {name}"),
    "beside_guide": ("линия точки {point} вдоль направляющей {guide}", "the line of {point} along guide {guide}"),
    "foot_on_guide": ("проекция {point} на {guide}", "the foot of {point} on {guide}"),
    "start_of_stroke": ("начало отсчёта s точки {point}", "the place s of {point} is counted from"),
    # programs of steps
    "not_drawn": ("на чертеже нет {name}{valid}", "the drawing has no {name}{valid}"),
    "give_first": ("чтобы это начертить, задайте {names}", "to draw this, give {names}"),
    "named_twice": (
        "две вещи на чертеже получили бы одно имя {name}; переименуйте одну из точек",
        "two things of the drawing would both be named {name}; rename one of the points",
    ),
    "mark_of_plan": ("{mark} ({plan})", "{mark} ({plan})"),
    "step_needs": (
        "{step} для {makes}: нужна величина {name} ({kind}), но построение до неё не дошло{valid}",
        "{step} of {makes} needs the {kind} {name}, but the drawing has not reached it{valid}",
    ),
    "step_kind": (
        "{step} для {makes}: {name} берётся как {kind}, а это {have}",
        "{step} of {makes} takes {name} for a {kind}, it is a {have}",
    ),
    "made_twice": (
        "{makes} строится дважды; назовите вторую метку иначе",
        "{makes} is made twice; name the second mark differently",
    ),
    "kind_mark": ("точка", "mark"),
    "kind_direction": ("направление", "direction"),
    "kind_value": ("число", "value"),
    "kind_place": ("место", "place"),
    # scenes of vectors where a mechanism is needed
    "vectors_alone": ("в сцене одни векторы без механизма", "this scene states vectors and has no mechanism"),
    "lesson_fails": (
        "положение, с которого начинается урок, не построить: {failure}; задайте в drive другое",
        "the position the lesson starts from cannot be drawn: {failure}; give another under drive",
    ),
    # what is asked
    "range_not_number": (
        "{option} {text}: это не число и не начало:конец:шаг, например 0:360:30{hint}",
        "{option} {text} is not a number or start:end:step, for example 0:360:30{hint}",
    ),
    "range_parts": (
        "{option} {text}: нужно одно число или начало:конец:шаг, например 0:360:30",
        "{option} {text} must be one number or start:end:step, for example 0:360:30",
    ),
    "range_endless": (
        "{option} {text}: с шагом {step:g} от {start:g} до {end:g} не дойти",
        "{option} {text}: with a step of {step:g} the range never goes from {start:g} to {end:g}",
    ),
    "range_long": (
        "{option} {text}: положений {count}, а за раз можно не больше {most}; увеличьте шаг",
        "{option} {text} is {count} positions; {most} at most can be worked through; take a larger step",
    ),
    "no_quantity": ("find: нет величины {name}{valid}", "find: there is no quantity {name}{valid}"),
    # the command line
    "option_misfit": ("--{option} не подходит к {file}: {why}", "--{option} does not fit {file}: {why}"),
    "option_idle": (
        "--{option} ничего не меняет {where:of}; этот ключ для другого: {places:; }",
        "--{option} changes nothing in {where}; it is for {places: or }",
    ),
    "option_needs": (
        "--{option} ничего не меняет без --{other}; добавьте --{other} или уберите --{option}",
        "--{option} changes nothing without --{other}; add --{other} or leave --{option} out",
    ),
    "option_names": (
        "{option}: не названо ни одной величины; имена пишут через запятую: {option} v_C,phi_3",
        "{option}: nothing is named; write names with commas between them: {option} v_C,phi_3",
    ),
    "seed_negative": ("--seed {seed}: нужно целое число, не меньше 0", "--seed {seed}: give a whole number, 0 or more"),
    "text_dxf": (
        "--text меняет только надписи DXF; назовите файл .dxf или уберите --text",
        "--text changes the letters of a DXF alone; name a .dxf file or leave --text out",
    ),
    "one_value": (
        "нужно одно положение, а задано {count}; укажите одно значение",
        "one position is needed, but {count} were asked for; give one value",
    ),
    "answer_positions": ("положения механизма|в положениях механизма", "positions of a mechanism"),
    "answer_vectors": ("сцена одних векторов|в сцене одних векторов", "a scene of vectors alone"),
    "answer_steps": ("список шагов (--explain)|в списке шагов (--explain)", "the list of steps (--explain)"),
    "answer_folder": ("обзор папки|в обзоре папки", "the survey of a folder"),
    "answer_summary": ("сводка|в сводке", "a summary"),
    "answer_listing": ("перечень положений (--listing)|в перечне положений", "a listing (--listing)"),
    "answer_table": (
        "таблица всех величин (-o ФАЙЛ.csv без --show)|в таблице всех величин",
        "a table of all results (-o FILE.csv without --show)",
    ),
    "answer_curves": (
        "таблица кривых (--show с -o ФАЙЛ.csv)|в таблице кривых (--show)",
        "a table of curves (--show with -o FILE.csv)",
    ),
    "answer_picture": ("рисунок (-o ФАЙЛ.png, .svg или .pdf)|на рисунке", "a picture (-o FILE.png, .svg or .pdf)"),
    "answer_graphical": (
        "графическое построение (--graphical)|в графическом построении (--graphical)",
        "a graphical construction (--graphical)",
    ),
    "answer_graphical_picture": (
        "рисунок графического построения (--graphical -o ФАЙЛ.png)|на рисунке графического построения",
        "the picture of a graphical construction (--graphical -o FILE.png)",
    ),
    "answer_trace": ("калька (--trace)|в кальке (--trace)", "the tracing paper (--trace)"),
    "answer_numbers": ("таблица чисел (.csv, .json)|в таблице чисел", "a table of numbers (.csv, .json)"),
    "answer_lines": ("чертёж .svg или .dxf|в чертеже .svg или .dxf", "a drawing .svg or .dxf"),
    "answer_photograph": ("снимок или скан (.png, .jpg, .pdf)|в снимке", "a picture (.png, .jpg, .pdf)"),
    "driver_by": ("ведущее звено там задано через --{kind}", "its driver is given by --{kind}"),
    "no_driver": ("ведущего звена там нет", "it has no driver"),
    "no_structure": (
        "{file}: в сцене одни векторы без механизма, поэтому строения у неё нет",
        "{file}: states vectors and has no mechanism, so it has no structure",
    ),
    "help_planes": ("Планы механизмов, построенные и измеренные.", "Plans of mechanisms, drawn and measured."),
    "help_solve": (
        "построить планы сцены и напечатать измеренное; для папки: таблица всех её сцен и вариантов",
        "draw the plans of a scene and print what they measure; for a folder, a table of all its scenes and variants",
    ),
    "help_structure": (
        "напечатать W, q, группы Ассура и формулу строения",
        "print W, q, Assur groups and the formula of structure",
    ),
    "help_sheet": (
        "начертить лист сцены: SVG, PDF, PNG или DXF по окончанию имени файла",
        "draw the sheet of a scene: SVG, PDF, PNG or DXF by the file's suffix",
    ),
    "help_lesson": (
        "сделать урок: страницу, где планы строятся шаг за шагом",
        "make a lesson: a page that draws the plans step by step",
    ),
    "help_lesson_output": ("какую страницу записать (.html)", "the page to write (.html)"),
    "help_note": (
        "написать пояснительную записку: формулы, числа, таблицы, рисунки",
        "write the explanatory note: formulas, numbers, tables, figures",
    ),
    "help_note_output": ("какой файл записать (.html, .pdf, .docx)", "the file to write (.html, .pdf, .docx)"),
    "help_json": ("печатать объект для программ вместо таблиц", "print an object for programs instead of tables"),
    "help_object": ("печатать объект для программ", "print an object for programs"),
    "help_pencil": ("чертить с погрешностями карандаша, а не точно", "draw with a pencil's errors instead of exactly"),
    "help_seed": ("какие именно погрешности у карандаша", "which errors the pencil makes"),
    "help_dxf_text": (
        "буквы в файле DXF: текст, который можно править (text), или линии (strokes)",
        "letters in a DXF: texts that can be edited (text), or lines (strokes)",
    ),
    "help_sheet_number": (
        "лист проекта: 1 (структура и кинематика) или 2 (силовой расчёт); без него всё на одном листе",
        "a sheet of a project: 1 (structure and kinematics) or 2 (forces); without it all stands on one page",
    ),
    "help_view": (
        "один вид без рамки: position, velocity-plan, acceleration-plan, force-2-3, lever, equations…; неизвестное "
        "имя назовёт все виды",
        "one view without a frame: position, velocity-plan, acceleration-plan, force-2-3, lever, equations…; an "
        "unknown name lists all",
    ),
    "help_output": ("какой файл записать (.svg, .pdf, .png, .dxf)", "the file to write (.svg, .pdf, .png, .dxf)"),
    "help_scene": ("файл сцены (YAML)", "the scene file (YAML)"),
    "help_variant": ("какой вариант чисел сцены взять", "which variant of the scene's numbers"),
    "help_lang": ("язык слов", "language of the words"),
    "help_phi": (
        "угол (углы) ведущего звена в градусах вместо заданного в сцене",
        "angle(s) of the driver, degrees, instead of the scene's",
    ),
    "help_s": ("место (места) поступательно движущегося ведущего звена, м", "place(s) of a sliding driver, m"),
    # what the reader of the command line says by itself, and is replaced piece by piece
}
