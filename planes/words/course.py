"""Words of courses and of tables over many scenes, in Russian and in English."""

COURSE: dict[str, tuple[str, str]] = {
    # the command line
    "help_course": (
        "сделать индивидуальные задания всему списку студентов: варианты, бланки, ответы, листы, уроки",
        "make individual work for a whole list of students: variants, blanks, answers, sheets, lessons",
    ),
    "help_course_folder": (
        "папка: students.txt или students.csv, сцены заданий и, если нужно, course.yaml (course: 1, title, lang, "
        "sheet, students, assignments, each, variants, draw, sharpness, documents, formats, plans, seed)",
        "the folder: students.txt or students.csv, scenes of the assignments and, if needed, course.yaml (course: 1, "
        "title, lang, sheet, students, assignments, each, variants, draw, sharpness, documents, formats, plans, seed)",
    ),
    "help_course_output": (
        "в какую папку записать (обычно out в той же папке)",
        "the folder to write (usually out within the same folder)",
    ),
    "help_jobs": (
        "сколько процессов считают сразу (обычно по числу ядер)",
        "how many processes work at once (usually one a core)",
    ),
    "help_scheduler": (
        "считать на кластере: адрес планировщика Dask, например tcp://host:8786",
        "work on a cluster: the address of a Dask scheduler, for example tcp://host:8786",
    ),
    "course_done": (
        "{folder}: студентов {students}, файлов сделано {made}, проверено и оставлено {kept}, ошибок {faults}",
        "{folder}: {students} students, {made} files made, {kept} verified and kept, {faults} faults",
    ),
    # what cannot be meant
    "the_course": ("описание курса", "the course"),
    "course_no_folder": ("такой папки нет", "there is no such folder"),
    "course_format": (
        "описание курса формата {version} этой версии неизвестно; напишите course: 1",
        "this version does not know a course of format {version}; write course: 1",
    ),
    "course_no_students": (
        "в папке {folder} нет списка студентов; положите в неё {files: или } или назовите students в course.yaml",
        "the folder {folder} has no list of students; put {files: or } into it or name students in course.yaml",
    ),
    "course_nobody": (
        "в списке нет ни одного студента; напишите имена по одному в строке",
        "nobody is on the list; write one name a line",
    ),
    "course_no_name": ("в строке нет имени студента; впишите его", "the row has no student's name; write it"),
    "course_head": (
        "первая строка {found} не шапка таблицы; напишите в ней {names: или }, нужно хотя бы первое",
        "the first line {found} is not the head of a table; write {names: or } there, the first at least",
    ),
    "course_long_name": (
        "имя {name} длиннее {most} знаков; сократите его",
        "the name {name} is longer than {most} characters; shorten it",
    ),
    "course_odd_name": (
        "в имени {name} есть знаки, которых не напечатать; уберите их",
        "the name {name} holds characters that cannot be printed; remove them",
    ),
    "course_twice": (
        "студент {name} уже есть в строке {first}; однофамильцев различайте именем или группой",
        "the student {name} already stands in line {first}; tell namesakes apart by name or group",
    ),
    "course_no_assignment": ("задания {name} в курсе нет{valid}", "the course has no assignment {name}{valid}"),
    "course_variant_of": (
        "вариант {name} назван, а задание нет; заданий несколько, назовите и задание",
        "the variant {name} is named without its assignment; there are several, name the assignment too",
    ),
    "course_no_scenes": (
        "здесь нет ни одной сцены (.yaml); положите задание в папку или назовите assignments в course.yaml",
        "there is no scene (.yaml) here; put an assignment into the folder or name assignments in course.yaml",
    ),
    "course_scene_twice": (
        "два задания называются {name}; переименуйте файл одного из них",
        "two assignments are named {name}; rename the file of one",
    ),
    "course_draw_name": (
        "ни у одного задания нет параметра {name}{valid}",
        "no assignment has a parameter {name}{valid}",
    ),
    "course_range": (
        "{what}: шаг должен быть больше нуля, from не больше to, значений не больше {most}",
        "{what}: the step must be above zero, from no more than to, and the values no more than {most}",
    ),
    "course_choice": (
        "{what}: {text} не годится; напишите 10 %, список [1, 2] или {{from: 0, to: 345, step: 15}}",
        "{what}: {text} will not do; write 10 %, a list [1, 2] or {{from: 0, to: 345, step: 15}}",
    ),
    "course_sharpness": (
        "sharpness: {value} не угол от 0 до 90°; напишите, например, 15",
        "sharpness: {value} is no angle from 0 to 90°; write 15, for example",
    ),
    "course_whole": (
        "{key}: {value} не годится; нужно целое число не больше {most}",
        "{key}: {value} will not do; it must be a whole number of at most {most}",
    ),
    "course_jobs": (
        "--jobs {count}: процессов должно быть не меньше одного",
        "--jobs {count}: there must be at least one process",
    ),
    # what does not come out
    "course_not_plain": (
        "параметр {name} задан выражением, процентов от него взять нельзя; назовите значения списком",
        "the parameter {name} is an expression, so it has no per cent around it; list the values",
    ),
    "course_nothing_drawn": (
        "в сцене нечего менять: нет параметров, у которых можно взять другие числа; назовите их в draw",
        "nothing in the scene can be drawn at random: it has no such parameters; name some under draw",
    ),
    "course_none": (
        "из {count} наборов чисел не подошёл ни один: {apart} не собираются по всему циклу, у {blunt} линии "
        "встречаются под углом меньше {limit}°; расширьте draw или уменьшите sharpness",
        "none of {count} sets of numbers will do: {apart} do not assemble all the way round, with {blunt} lines meet "
        "at less than {limit}°; widen draw or lower sharpness",
    ),
    "course_too_few": (
        "разных наборов чисел не хватает; расширьте draw",
        "there are not enough different sets of numbers; widen draw",
    ),
    "course_slip": (
        "ошибка программы ({kind}: {text}, {place}); сообщите о ней, приложив scene.yaml",
        "a slip of the program ({kind}: {text}, {place}); please report it with scene.yaml",
    ),
    "course_locked": (
        "в папку {folder} уже пишет другой запуск; дождитесь его или укажите -o",
        "another run is writing into the folder {folder}; wait for it or give -o",
    ),
    "course_outside": (
        "{file}: такое имя ведёт за пределы папки {folder}; уберите ссылки и .. на этом пути",
        "{file}: the name leads out of the folder {folder}; remove links and .. on the way",
    ),
    "course_worker_lost": (
        "один из процессов остановлен системой, возможно, не хватило памяти; запустите снова с меньшим --jobs, готовое "
        "сохранено",
        "the system stopped one of the processes, perhaps memory ran out; run again with fewer --jobs, what is done "
        "is kept",
    ),
    "course_no_dask": (
        "для --scheduler нужен пакет distributed: pip install 'planes[dask]'",
        "--scheduler needs the package distributed: pip install 'planes[dask]'",
    ),
    "course_no_scheduler": (
        "планировщик Dask по адресу {address} не отвечает: {reason}; проверьте адрес",
        "no Dask scheduler answers at {address}: {reason}; check the address",
    ),
    "course_cluster": (
        "кластер не справился ({kind}: {reason}); готовое сохранено: проверьте, что на узлах стоит та же planes[dask], "
        "и запустите снова",
        "the cluster failed ({kind}: {reason}); what is done is kept: see that its workers have the same planes[dask] "
        "and run again",
    ),
    "course_other_program": (
        "на рабочем узле кластера другая версия программы; поставьте туда ту же",
        "a worker of the cluster has another version of the program; install the same one there",
    ),
    # all scenes of a folder
    "survey_empty": ("в папке {folder} нет ни одной сцены (.yaml)", "the folder {folder} has no scene (.yaml)"),
    "survey_title": ("Все сцены и варианты", "All scenes and variants"),
    "survey_scene": ("сцена", "scene"),
    "survey_variant": ("вариант", "variant"),
    "survey_drive": ("положение", "position"),
    "survey_solved": ("решено", "solved"),
    "survey_yes": ("да", "yes"),
    "survey_no": ("нет", "no"),
    "survey_balancing": ("уравновешивающий момент", "balancing moment"),
    "survey_lever": ("по рычагу", "by the lever"),
    "survey_difference": ("расхождение", "difference"),
    "survey_exceptions": ("Исключения:", "Exceptions:"),
    "survey_gap": ("от {low} до {high}", "from {low} to {high}"),
    "survey_no_turn": (
        "ведущее звено {link} не делает полного оборота: механизм не собрать {ranges}",
        "the driver {link} makes no full turn: the mechanism does not assemble {ranges}",
    ),
    "survey_apart": (
        "уравновешивающие нагрузки {balancing} и {lever} расходятся больше чем на {most}",
        "the balancing loads {balancing} and {lever} differ by more than {most}",
    ),
    "survey_count": (
        "Положений {count}: решено {solved}, с силами {forces}; наибольшее относительное расхождение {worst}; "
        "исключений {said}.",
        "{count} positions: {solved} solved, {forces} with forces; largest relative difference {worst}; {said} "
        "exceptions.",
    ),
    # tasks
    "task_student": ("Студент: {name}", "Student: {name}"),
    "task_group": (", группа {group}", ", group {group}"),
    "task_variant": ("Вариант {variant}", "Variant {variant}"),
    "task_drawn": ("Вариант индивидуальный", "Individual variant"),
    "task_scheme": (
        "Схема механизма (не в расчётном положении)",
        "The scheme of the mechanism (not in the position asked for)",
    ),
    "task_given": ("Исходные данные", "Given"),
    "task_quantity": ("Величина", "Quantity"),
    "task_value": ("Значение", "Value"),
    "task_unit": ("Ед.", "Unit"),
    "task_conditions": ("Условия", "Conditions"),
    "task_force_against": (
        "На звено {link} в точке {point} действует сила {value} Н, направленная против движения этой точки.",
        "A force of {value} N acts on link {link} at {point}, against the motion of that point.",
    ),
    "task_force_along": (
        "На звено {link} в точке {point} действует сила {value} Н, направленная по движению этой точки.",
        "A force of {value} N acts on link {link} at {point}, along the motion of that point.",
    ),
    "task_force": (
        "На звено {link} в точке {point} действует сила {value} Н под углом {angle}° к оси x.",
        "A force of {value} N acts on link {link} at {point}, at {angle}° to the x axis.",
    ),
    "task_force_link": (
        "На звено {link} в точке {point} действует сила {value} Н под углом {angle}° к оси x звена {other}.",
        "A force of {value} N acts on link {link} at {point}, at {angle}° to the x axis of link {other}.",
    ),
    "task_moment_against": (
        "На звено {link} действует момент {value} Н·м, направленный против его вращения.",
        "A moment of {value} N·m acts on link {link}, against its rotation.",
    ),
    "task_moment_along": (
        "На звено {link} действует момент {value} Н·м, направленный по его вращению.",
        "A moment of {value} N·m acts on link {link}, along its rotation.",
    ),
    "task_moment": (
        "На звено {link} действует момент {value} Н·м (знак плюс: против часовой стрелки).",
        "A moment of {value} N·m acts on link {link} (plus: counter-clockwise).",
    ),
    "task_axes": (
        "Начало координат в точке {point}, ось x вправо, ось y вверх, углы против часовой стрелки.",
        "The origin is {point}, the x axis runs to the right, y up, angles are counter-clockwise.",
    ),
    "task_weight": ("Вес звеньев учитывается, g = {g} м/с².", "The weight of the links counts, g = {g} m/s²."),
    "task_no_weight": ("Вес звеньев не учитывается.", "The weight of the links does not count."),
    "task_friction": ("Коэффициент трения в направляющей {guide}: {f}.", "Friction in the guide {guide}: {f}."),
    "task_todo": ("Требуется", "To do"),
    "task_structure": (
        "Строение: W, q, группы Ассура, формула строения.",
        "Structure: W, q, Assur groups, formula of structure.",
    ),
    "task_position": ("План положения при {drive}.", "Position plan at {drive}."),
    "task_velocity": (
        "План скоростей: скорости точек, угловые скорости звеньев.",
        "Velocity plan: velocities of points, angular velocities of links.",
    ),
    "task_acceleration": (
        "План ускорений: ускорения точек, угловые ускорения звеньев.",
        "Acceleration plan: accelerations of points, angular accelerations of links.",
    ),
    "task_force_plan": (
        "Планы сил групп и ведущего звена: реакции и уравновешивающая нагрузка.",
        "Force plans of the groups and the driver: reactions and the balancing load.",
    ),
    "task_lever": (
        "Рычаг Жуковского: проверка уравновешивающей нагрузки.",
        "Zhukovsky's lever: the balancing load checked.",
    ),
    "task_find": ("В ответе привести {names}.", "Give {names} as the answer."),
    # answers
    "key_title": ("Ответы. {title}", "Answers. {title}"),
    "key_plans": ("Измерено на планах", "Measured on the plans"),
    "key_vector": ("вектор", "vector"),
    "key_sharpness": (
        "Наименьший угол, под которым на планах встречаются линии: {angle}°.",
        "The least angle at which lines of the plans meet: {angle}°.",
    ),
}
