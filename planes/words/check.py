"""Words of checking a person's drawing, in Russian and in English."""

from __future__ import annotations

from planes.words.files import FILES
from planes.words.mistakes import MISTAKES

CHECK: dict[str, tuple[str, str]] = {
    **MISTAKES,
    **FILES,
    # the whole
    "check_right": ("Чертёж верен: {plan}.", "The drawing is right: {plan}."),
    "check_right_as_seen": (
        "Прочитанное верно: {plan}; не увидено: {names}, проверьте их глазами.",
        "What was read is right: {plan}; not seen: {names}, look at them yourself.",
    ),
    "check_unclear": (
        "{mark} на {off} мм не там, куда ведёт построение из ваших же точек; причина не ясна",
        "{mark} is {off} mm from where the construction from your own marks leads; the cause is unclear",
    ),
    "check_undrawable": (
        "{mark}: по вашим же точкам построение не провести: линии не пересекаются; проверьте точки и длины до неё",
        "{mark}: the construction cannot be drawn from your own marks, its lines do not meet; check the marks and "
        "lengths before it",
    ),
    "check_number_unclear": (
        "{mark} = {given}, а верно {true}; причина не ясна",
        "{mark} = {given}, but {true} is right; the cause is unclear",
    ),
    "check_nothing_read": (
        "Прочитать нечего: ни одна из отметок плана ({names}) не найдена.",
        "There is nothing to read: none of the plan's marks ({names}) is found.",
    ),
    "check_too_little": (
        "Прочитано слишком мало: {found} из {count} отметок; не хватает {names}.",
        "Too little could be read: {found} of {count} marks; missing are {names}.",
    ),
    "check_other_drawing": (
        "Это похоже на другой чертёж: из {count} прочитанных отметок не на месте {wrong}.",
        "This looks like another drawing: of {count} marks read {wrong} are out of place.",
    ),
    "check_nothing_drawn": (
        "Чертежа плана не видно: всё прочитанное лежит не дальше {size} мм от полюса.",
        "No drawing of the plan is seen: all that was read lies within {size} mm of the pole.",
    ),
    "check_by_chance": (
        "Судить не по чему: прочитано {count}, до дальней отметки (или в длиннейшем отрезке) {size} мм; "
        "в пределах ошибки карандаша так лягут и случайные точки. "
        "Начертите крупнее, покажите больше отметок или назовите масштаб (--mu).",
        "There is too little to judge by: {count} read, the farthest or longest {size} mm; within a pencil's error any "
        "points would do as well. Draw larger, show more marks, or tell the scale (--mu).",
    ),
    "check_no_pole": ("В таблице нет полюса p; добавьте его строку.", "The table has no pole p; add its row."),
    "check_no_fixed": (
        "В таблице нет ни полюса p, ни неподвижной точки ({names}); добавьте одну из них.",
        "The table has neither the pole p nor a fixed point ({names}); add one of them.",
    ),
    # warnings
    "check_mu": (
        "Масштаб чертежа принят {mu} (в схеме {said}).",
        "The drawing's scale is taken as {mu} (the scene says {said}).",
    ),
    "check_mu_found": ("Масштаб чертежа принят {mu}.", "The drawing's scale is taken as {mu}."),
    "check_nameless": (
        "Линий, которые не удалось отнести ни к одному вектору плана: {count}; они пропущены.",
        "Lines that could not be taken for any vector of the plan: {count}; they are left out.",
    ),
    "check_unknown": (
        "Нет таких отметок в плане: {names}; они пропущены.",
        "The plan has no such marks: {names}; they are left out.",
    ),
    "check_unseen": ("Не увидены и не проверены: {names}.", "Not seen and not judged: {names}."),
    "check_close": ("между 2σ и 3σ", "between 2σ and 3σ"),
    "check_scale_vector": (
        "Масштаб взят по вектору {mark}, поэтому его длина не проверялась.",
        "The scale is taken from the vector {mark}, so its length could not be judged.",
    ),
    # refusals
    "check_no_plan": ("у механизма нет плана {plan}{names}", "the mechanism has no plan {plan}{names}"),
    "check_vectors": (
        "{file}: в этой сцене нет механизма, проверять можно только планы механизмов",
        "{file}: this scene has no mechanism; only plans of a mechanism can be checked",
    ),
    "check_option": ("{option} {text}: ожидается {form}{hint}", "{option} {text}: expected {form}{hint}"),
    "check_crowd": (
        "На чертеже слишком много линий ({count} концов), чтобы узнать в них план.",
        "The drawing has too many lines ({count} ends) to tell the plan among them.",
    ),
    "check_three_marks": (
        "Видны только три угловые метки бланка из четырёх.",
        "Only three of the blank's four corner marks are seen.",
    ),
    "check_force_unsure": (
        "Векторы многоугольника сил на снимке не удаётся уверенно назвать; запишите их концы в таблицу mark,x_mm,y_mm.",
        "The vectors of the force polygon cannot be told apart surely; write their ends into a table mark,x_mm,y_mm.",
    ),
    "check_hidden": (
        "Концы векторов {names} закрыты другими линиями или слишком малы; взяты там, где должны быть, и не проверены.",
        "The ends of {names} are hidden by other lines or too small; they are taken where they should be, unchecked.",
    ),
    "check_no_plan_seen": (
        "Линии на снимке не складываются в этот план: его векторам отвечают лишь {share} % их длины.",
        "The lines of the picture do not make up this plan: its vectors account for only {share} % of their length.",
    ),
    "check_points": (
        "По этим --pole и --mark масштаб не найти: точки слишком близко или не на картинке.",
        "These --pole and --mark give no scale: they are too near or not on the picture.",
    ),
    "check_no_marks": (
        "На картинке нет ни угловых меток бланка, ни рамки; укажите --pole x,y и --mark имя=x,y "
        "(пиксели от левого верхнего угла).",
        "The picture has neither a blank's corner marks nor a frame; name --pole x,y and --mark name=x,y "
        "(pixels from the top left).",
    ),
    "check_no_lines": ("На чертеже нет линий.", "The drawing has no lines."),
    # help of the command line
    "help_check": ("проверить чертёж человека", "check a person's drawing"),
    "help_drawing": (
        "чертёж: таблица, SVG, DXF, картинка или папка",
        "the drawing: a table, SVG, DXF, a picture, or a folder",
    ),
    "help_plan": ("что на чертеже: velocity, force:2-3…", "which plan it is: velocity, force:2-3…"),
    "help_mu": ("масштаб чертежа", "scale of the drawing"),
    "help_with": ("чертёж более раннего плана того же человека", "the same person's drawing of an earlier plan"),
    "help_pole": ("место полюса на картинке", "where the pole is on the picture"),
    "help_picture_format": (
        "формат листа на снимке, если у него рамка, но нет угловых меток бланка",
        "the format of the sheet on the picture, if it has a frame but no corner marks of a blank",
    ),
    "help_mark": ("место отметки на картинке", "where a mark is on the picture"),
    "help_work": ("допуски: от руки или на компьютере", "tolerances: by hand or on a computer"),
    "help_check_output": (
        "отчёт: .html, .pdf, .svg, .png, .json; о целой папке: .html, .csv, .json или папка",
        "the report: .html, .pdf, .svg, .png, .json; of a whole folder: .html, .csv, .json or a folder",
    ),
    "help_blank": ("бланк, на котором чертят план", "a blank to draw a plan on"),
    "help_blank_output": ("файл бланка: .pdf, .svg, .png", "the file of the blank: .pdf, .svg, .png"),
    "check_output": (
        "{file}: отчёт пишется в .html, .pdf, .svg, .png или .json",
        "{file}: write to .html, .pdf, .svg, .png or .json",
    ),
    "help_trace": (
        "вместо проверки: страница-калька, верный план поверх своего снимка (-o калька.html, без чертежа)",
        "instead of checking: tracing paper, the right plan over a picture of your own (-o trace.html, no drawing)",
    ),
    "check_no_drawing": (
        "нет чертежа: planes check СЦЕНА ЧЕРТЁЖ --plan ПЛАН",
        "no drawing: planes check SCENE DRAWING --plan PLAN",
    ),
    "check_trace": (
        "калька пишется без чертежа: planes check СЦЕНА --plan ПЛАН --trace -o калька.html",
        "tracing paper takes no drawing: planes check SCENE --plan PLAN --trace -o trace.html",
    ),
    "trace_open": ("Открыть снимок", "Open a picture"),
    "trace_plan": ("План", "Plan"),
    "trace_by": ("Тянуть за", "Handle"),
    "trace_layer_plan": ("план", "the plan"),
    "trace_layer_names": ("буквы", "letters"),
    "trace_picture": ("снимок", "the picture"),
    "trace_paper": ("калька", "tracing paper"),
    "trace_zoom": ("увеличение", "zoom"),
    "trace_pole": ("полюс", "the pole"),
    "trace_turned": ("повёрнут на", "turned by"),
    "trace_scale": ("пикселей в миллиметре", "pixels to a millimetre"),
    "trace_hint": (
        "Откройте снимок чертежа: он остаётся в этом окне и никуда не отправляется. Тяните план за полюс — он едет, за "
        "отметку — поворачивается и растёт. Стрелки двигают ручку на 1 пиксель, с Shift — на 10.",
        "Open a picture of a drawing: it stays in this window, sent nowhere. Drag the plan by its pole to move it, "
        "by its mark to turn and resize it. Arrow keys move a handle by 1 pixel, with Shift by 10.",
    ),
    "trace_check": (
        "Проверить сам снимок с этими двумя точками:",
        "To check the picture itself with these two points:",
    ),
    "trace_not_picture": ("Этот файл не открывается как картинка.", "This file does not open as a picture."),
    "check_page_own": ("чертёж", "the drawing"),
    "check_page_next": ("куда ведёт построение из своих точек", "where its own marks lead"),
    "check_page_truth": ("верный план", "the right plan"),
    "check_page_picture": ("снимок или линии", "the picture or lines"),
    "check_reduced": ("изображено 1 : {n}", "drawn at 1 : {n}"),
    "check_page_save": ("Сохранить отметки", "Save the marks"),
    "check_page_reset": ("Вернуть как прочитано", "As it was read"),
    "check_page_moved": ("Отметки передвинуты, вывод обновлён.", "Marks have been moved; the verdict is up to date."),
    "check_page_steps": ("Шаги", "Steps"),
    "check_page_numbers": ("Результаты", "Results"),
    "check_page_drag": (
        "Отметку, прочитанную не там, перетащите мышью, пальцем или стрелками (Shift — по 5 мм, Alt — по 0,1 мм); "
        "непрочитанные ждут у правого края. Каждый шаг тут же проверяется заново. Сохранённая таблица проверяется так:",
        "Drag a mark that was read in a wrong place with the mouse, a finger or the arrow keys (Shift: 5 mm, Alt: "
        "0.1 mm); those not read wait at the right edge. Every step is judged anew at once. The saved table is checked "
        "so:",
    ),
    "check_page_noscript": (
        "Страница чертит сама: включите JavaScript; вывод и таблица верны и без него.",
        "The page draws by itself: please enable JavaScript; the verdict and the table stand without it.",
    ),
    "check_class": ("Работы", "Papers"),
    "check_common": ("Частые ошибки", "Common mistakes"),
    "check_class_output": (
        "{file}: таблица класса пишется в .html, .csv, .json или в папку",
        "{file}: a class is written to .html, .csv, .json or into a folder",
    ),
    "check_file": ("файл", "file"),
    "check_first": ("первая ошибка", "first mistake"),
    "check_empty_folder": ("{file}: в папке нет чертежей", "{file}: there are no drawings in the folder"),
    # the table of a report
    "check_marks": ("Отметки", "Marks"),
    "check_numbers": ("Результаты", "Results"),
    "check_mark": ("отметка", "mark"),
    "check_off_own": ("от своего построения, мм", "off its own construction, mm"),
    "check_off_true": ("от верного плана, мм", "off the right plan, mm"),
    "check_deviation": ("отклонение, мм", "deviation, mm"),
    "check_tolerance": ("допуск, мм", "tolerance, mm"),
    "check_verdict": ("вывод", "verdict"),
    "check_result": ("результат", "result"),
    "check_given": ("записано", "given"),
    "check_true": ("верно", "true"),
    "verdict_right": ("верно", "right"),
    "verdict_wrong": ("неверно", "wrong"),
    "verdict_follows": ("следствие", "follows"),
    "verdict_unread": ("не прочитано", "unread"),
    "verdict_unreadable": ("прочитать нельзя", "unreadable"),
}
