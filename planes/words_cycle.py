"""Words of long runs, slicing, claims and charts: key to Russian and English."""

CYCLE: dict[str, tuple[str, str]] = {
    "help_cycle": (
        "рассчитать много положений и записать таблицу",
        "compute many positions and write them as a table",
    ),
    "help_cycle_output": (
        "файл таблицы: .csv, .npy, .npz или .parquet",
        "the table's file: .csv, .npy, .npz or .parquet",
    ),
    "help_slow": ("не компилировать программу в один цикл", "do not compile the program into one loop"),
    "help_explain": (
        "показать, какие шаги программы нужны для искомого, а какие отброшены",
        "list the steps of the program that lead to what is asked, and those dropped",
    ),
    "help_chart": (
        "начертить скорость против точности и устойчивость вблизи особых положений",
        "chart speed against accuracy, and stability near dead points",
    ),
    "help_chart_output": ("файл рисунка: .png, .svg или .pdf", "the figure's file: .png, .svg or .pdf"),
    "help_table": ("записать те же числа таблицей CSV", "write the same numbers as a CSV table"),
    "cycle_suffix": (
        "{file}: такую таблицу записать нельзя; подходят {suffixes}",
        "{file}: no table can be written with this suffix; valid: {suffixes}",
    ),
    "cycle_no_parquet": (
        "для таблиц Parquet нужен pyarrow: pip install pyarrow, или возьмите .npz либо .csv",
        "Parquet tables need pyarrow: pip install pyarrow, or take .npz or .csv",
    ),
    "cannot_write": ("{file}: записать не удалось: {reason}", "{file} cannot be written: {reason}"),
    "cycle_no_mechanism": (
        "{file}: сцена задаёт векторы без механизма, положений у неё нет",
        "{file}: states vectors and has no mechanism, so it has no positions",
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
}
