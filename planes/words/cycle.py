"""Words of long runs, slicing, claims and charts: key to Russian and English."""

CYCLE: dict[str, tuple[str, str]] = {
    "help_cycle": (
        "пройти весь цикл: ход, мёртвые положения, экстремумы; таблица многих положений, диаграммы, годографы",
        "go through the whole cycle: stroke, dead points, extremes; a table of many positions, diagrams, hodographs",
    ),
    "help_cycle_output": (
        "файл таблицы: .csv, .npy, .npz или .parquet — или диаграмм: .png, .svg или .pdf; без него сводка",
        "the file of a table: .csv, .npy, .npz or .parquet - or of diagrams: .png, .svg or .pdf; without it a summary",
    ),
    "help_slow": ("не компилировать программу в один цикл", "do not compile the program into one loop"),
    "help_explain": (
        "показать, какие шаги программы нужны для искомого, а какие отброшены",
        "list the steps of the program that lead to what is asked, and those dropped",
    ),
    "help_errors": (
        "± к каждому результату: граница погрешности, а с --pencil среднее квадратическое отклонение",
        "give every result its ±: a bound of its error, or with --pencil one standard deviation",
    ),
    "help_remedy": (
        "у мёртвого положения поступить как чертёжник: взять меньший масштаб или интерполировать между ±5°",
        "near a dead point do what a draughtsman would: a smaller scale, or interpolation from ±5°",
    ),
    "errors_bound": (
        "± — граница погрешности: дальше от точного значения результат не бывает",
        "± is a bound: no result is further than this from the exact value",
    ),
    "errors_pencil": (
        "± — среднее квадратическое отклонение у многих чертёжников с таким карандашом",
        "± is one standard deviation over many draughtsmen with such a pencil",
    ),
    "remedy_scale": (
        "{marks}: линии встречаются под углом {angle_deg}°, и при μ = {said} {plan} был бы {size_mm} мм; начерчен "
        "при μ = {mu}",
        "{marks}: the lines meet at {angle_deg}°, and at μ = {said} the {plan} would be {size_mm} mm across; it is "
        "drawn at μ = {mu}",
    ),
    "remedy_between": (
        "{why}; значения взяты посередине между {low} и {high}, от соседних (±0,01°) разнятся не более чем на {apart}",
        "{why}; the values are halfway between those at {low} and {high}, within {apart} of the nearest ones (±0.01°)",
    ),
    "remedy_carried": (
        "{why}; за этим положением движение может пойти двояко: значения продолжены с {low} и {high} по ходу, "
        "расходятся с соседними (0,01°) не более чем на {apart}",
        "{why}; past it the motion may go either way: the values are carried on from {low} and {high} as the driver "
        "comes, within {apart} of the nearest ones (0.01°)",
    ),
    "remedy_no_forces": (
        "; силы здесь не продолжаются и опущены",
        "; forces do not go on smoothly here and are left out",
    ),
    "remedy_beside": (
        "{why}; начерчено соседнее положение {there}",
        "{why}; the neighbouring position {there} is drawn instead",
    ),
    "help_chart": (
        "начертить скорость против точности и устойчивость вблизи особых положений",
        "chart speed against accuracy, and stability near dead points",
    ),
    "help_chart_output": ("файл рисунка: .png, .svg или .pdf", "the figure's file: .png, .svg or .pdf"),
    "help_table": ("записать те же числа таблицей CSV", "write the same numbers as a CSV table"),
    "help_cycle_errors": (
        "± в таблице рядом с результатами: граница погрешности каждого",
        "beside the results of a table their ±: a bound of the error of each",
    ),
    "no_given": (
        "известных заранее величин {name} у этой программы нет{valid}",
        "nothing called {name} is given to this program{valid}",
    ),
    "no_column": ("в таблице нет столбца {name}{valid}", "the table has no column {name}{valid}"),
    "cycle_suffix": (
        "{file}: такую таблицу записать нельзя; подходят {suffixes}",
        "{file}: no table can be written with this suffix; valid: {suffixes}",
    ),
    "listing_long": (
        "список пишется для немногих положений, а задано {count}; возьмите не больше {most} или файл: -o таблица.csv",
        "a listing is for a few positions, but {count} were asked for; take {most} at most, or a file: -o table.csv",
    ),
    "cycle_no_parquet": (
        "для таблиц Parquet нужен pyarrow: pip install planes[parquet], или возьмите .npz либо .csv",
        "Parquet tables need pyarrow: pip install planes[parquet], or take .npz or .csv",
    ),
    "system_refuses": ("{file}: система отказала: {reason}", "{file}: the system refuses: {reason}"),
    "standard_output": ("вывод", "the output"),
    "cannot_write": ("{file}: записать не удалось: {reason}", "{file} cannot be written: {reason}"),
    "cycle_no_mechanism": (
        "{file}: сцена задаёт векторы без механизма, положений у неё нет",
        "{file}: states vectors and has no mechanism, so it has no positions",
    ),
    "cycle_one_place": (
        "{file}: для диаграмм нужен диапазон положений: --phi 0:360:1",
        "{file}: diagrams need a range of positions: --phi 0:360:1",
    ),
    "cycle_failed": (
        "{name} = {first}…{last} ({count} положений): {why}",
        "{name} = {first}…{last} ({count} positions): {why}",
    ),
    "cycle_more": ("… и ещё {count} таких участков", "… and {count} more such ranges"),
    "cycle_done": (
        "{file}: положений {count}, не построено {failed}",
        "{file}: {count} positions, {failed} of them failed",
    ),
    "positions": ("положений", "positions"),
    "explain_kept": ("Нужные шаги: {kept} из {all}", "Steps kept: {kept} of {all}"),
    "explain_dropped": ("Отброшенные шаги: {dropped}", "Steps dropped: {dropped}"),
    "explain_reads": ("из {reads}", "from {reads}"),
    # one step in words, for --explain
    "step_Put": ("поставить точку или полюс", "put a point or the pole"),
    "step_Aim": ("направление под углом", "aim a direction by its angle"),
    "step_Through": ("направление через две точки", "direction through two marks"),
    "step_Turn": ("повернуть направление", "turn a direction"),
    "step_LayOff": ("отложить отрезок", "lay off a segment"),
    "step_Carry": ("перенести отрезок", "carry a segment"),
    "step_Same": ("та же точка плана", "the same end on the plan"),
    "step_Cross": ("пересечь две прямые", "cross two lines"),
    "step_CrossArc": ("засечка: прямая и дуга", "cross a line and an arc"),
    "step_CrossArcs": ("засечка: две дуги", "cross two arcs"),
    "step_Touch": ("провести касательную", "draw a tangent"),
    "step_Similar": ("по подобию", "by similarity"),
    "step_Image": ("по подобию со схемой", "by similarity with the scheme"),
    "step_Measure": ("измерить отрезок", "measure a segment"),
    "step_Drop": ("измерить плечо", "measure an arm"),
    "step_Protractor": ("измерить угол", "measure an angle"),
    "step_Calculate": ("вычислить", "calculate"),
    "step_Sense": ("определить сторону движения", "tell the sense of motion"),
    "step_SenseOf": ("определить знак", "tell the sign"),
    "step_Lean": ("наклонить реакцию на угол трения", "lean a reaction by friction"),
    "step_Choose": ("выбрать верное предположение", "keep the supposition that came true"),
    "digits_no_mpmath": (
        "для длинных чисел нужен mpmath: pip install mpmath",
        "long numbers need mpmath: pip install mpmath",
    ),
    "digits_one": (
        "длинными числами чертится одно положение за раз; передавайте положения по одному",
        "long numbers draw one position at a time; give the positions one by one",
    ),
    # charts
    "method_scalar": ("точно, по одному", "exact, one by one"),
    "method_batch": ("точно, массивом", "exact, by arrays"),
    "method_compiled": ("точно, одним циклом", "exact, one compiled loop"),
    "method_single": ("24-битные числа", "24-bit numbers"),
    "method_digits": ("{number} знаков", "{number} digits"),
    "method_differences": ("разности положений", "differences of places"),
    "method_newton": ("итерации Ньютона", "Newton's iteration"),
    "method_pylinkage": ("pylinkage {number}", "pylinkage {number}"),
    "method_kinepy": ("kinepy {number} (разности)", "kinepy {number} (differences)"),
    "method_pencil": ("карандаш, {number} мм", "pencil, {number} mm"),
    "chart_pencils": (
        "карандаш: от {worst} мм\nдо {best} мм (лист, линейка)",
        "pencil: from {worst} mm\nto {best} mm (sheet, ruler)",
    ),
    "chart_method": ("способ", "method"),
    "chart_seconds": ("время на одно положение, с", "time per position, s"),
    "chart_machine": ("({name}, ядер: {cores})", "({name}, {cores} cores)"),
    "chart_error": ("наибольшая относительная погрешность за цикл", "largest relative error over the cycle"),
    "chart_error_short": ("погрешность", "error"),
    "chart_speed": ("Скорость и точность", "Speed and accuracy"),
    "chart_front": ("граница Парето", "Pareto front"),
    "chart_end": ("Устойчивость у предела сборки", "Stability at the limit of assembly"),
    "chart_change": ("Устойчивость у особого положения", "Stability at the change point"),
    "chart_infinite": (
        "Устойчивость у параллельных направляющих: встреча уходит в ∞",
        "Stability at parallel guides: the crossing runs to ∞",
    ),
    "chart_distance_phi": ("расстояние до φ = {value}°, рад", "distance to φ = {value}°, rad"),
    "chart_distance_s": ("расстояние до s = {value} м, м", "distance to s = {value} m, m"),
    "chart_distance_length": (
        "длина {name}: относительное расстояние до {value} м (в сцене {here} м), при {drive}",
        "length {name}: relative distance to {value} m ({here} m in the scene), at {drive}",
    ),
    "chart_distance_angle": (
        "угол направляющей {name}: расстояние до {value}° (в сцене {here}°), рад, при {drive}",
        "angle of the guide {name}: distance to {value}° ({here}° in the scene), rad, at {drive}",
    ),
    "chart_at": ("относительная погрешность в положении", "relative error at the position"),
    "chart_sharpness": ("синус угла встречи", "sine of the meeting angle"),
    "chart_claim": ("заявленная погрешность", "claimed error"),
    "chart_no_limit": (
        "Скорость и точность (особых положений нет: ни привод, ни длины вшестеро больше и меньше,\n"
        "ни повороты направляющих к ним не ведут)",
        "Speed and accuracy (no limit: neither the drive, nor lengths up to six times longer or shorter,\n"
        "nor turned guides lead to one)",
    ),
    "chart_suffix": (
        "{file}: такой рисунок записать нельзя; подходят {suffixes}",
        "{file}: no figure can be written with this suffix; valid: {suffixes}",
    ),
    "no_working": ("механизм не собирается ни в одном положении", "the mechanism assembles in no position"),
}
