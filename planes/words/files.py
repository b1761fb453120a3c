"""Words about files of drawings that cannot be read, in Russian and in English."""

from __future__ import annotations

FILES: dict[str, tuple[str, str]] = {
    "check_columns": (
        "{file}: первая строка таблицы должна называть столбцы: mark,x_mm,y_mm или segment,mm или result,value,unit",
        "{file}: the first row must name the columns: mark,x_mm,y_mm or segment,mm or result,value,unit",
    ),
    "check_not_number": ("{file}:{line}: {text} — не число", "{file}:{line}: {text} is not a number"),
    "check_no_place": (
        "{file}:{line}: {text} мм на листе не бывает; длины пишутся в мм",
        "{file}:{line}: there is no {text} mm on a sheet; lengths are in mm",
    ),
    "check_row": ("{file}:{line}: в строке не хватает столбцов", "{file}:{line}: the row has too few columns"),
    "check_json": ("{file}: это не JSON: {why}", "{file}: this is not JSON: {why}"),
    "check_text": ("{file}: файл не читается как текст UTF-8", "{file}: the file cannot be read as UTF-8 text"),
    "check_no_file": ("{file}: файл не открывается: {why}", "{file}: the file cannot be opened: {why}"),
    "check_suffix": (
        "{file}: файлы вида {suffix} не читаются; сохраните картинку как .jpg или .png, чертёж как .svg, .dxf или "
        ".pdf, таблицу как .csv или .json",
        "{file}: files of the kind {suffix} are not read; save a picture as .jpg or .png, a drawing as .svg, .dxf or "
        ".pdf, a table as .csv or .json",
    ),
    "check_no_plain_file": (
        "{file}: это не обычный файл; назовите файл чертежа",
        "{file}: this is no plain file; name a file of a drawing",
    ),
    "check_broken": (
        "{file}: программа не справилась с этим файлом ({why}); проверьте его отдельно или пришлите авторам",
        "{file}: the program failed on this file ({why}); look at it by itself, or send it to the authors",
    ),
    "check_large_file": (
        "{file}: файл больше {most} МБ; сохраните в нём один план без всего лишнего",
        "{file}: the file is larger than {most} MB; save one plan in it, without anything else",
    ),
    "check_too_many": (
        "{file}: в файле больше {most} {what}; оставьте в нём один план",
        "{file}: the file holds more than {most} {what}; leave one plan in it",
    ),
    "count_elements": ("элементов", "elements"),
    "count_levels": ("вложений", "levels of nesting"),
    "count_rows": ("строк", "rows"),
    "count_strokes": ("отрезков", "strokes"),
    "check_svg_entities": (
        "{file}: в SVG объявлены сущности (<!ENTITY>), они не читаются; сохраните чертёж как простой SVG",
        "{file}: the SVG declares entities (<!ENTITY>), which are not read; save the drawing as plain SVG",
    ),
    "check_svg": (
        "{file}: это не SVG или файл испорчен ({why}); сохраните чертёж заново",
        "{file}: this is not an SVG, or is damaged ({why}); save the drawing anew",
    ),
    "check_dxf": (
        "{file}: это не DXF или файл испорчен ({why}); сохраните чертёж заново",
        "{file}: this is not a DXF, or is damaged ({why}); save the drawing anew",
    ),
    "check_needs": (
        "для этого нужен пакет {what}: pip install planes[check]",
        "this needs the package {what}: pip install planes[check]",
    ),
    "check_picture": (
        "{file}: картинка не читается: файл обрезан, испорчен или другого вида; сохраните её заново как JPEG или PNG",
        "{file}: the picture cannot be read: the file is cut, damaged or of another kind; save it anew as JPEG or PNG",
    ),
    "check_empty": ("{file}: файл пуст; передайте его ещё раз", "{file}: the file is empty; send it again"),
    "check_small_picture": (
        "{file}: картинка всего {size} пикселей; сканируйте лист с 200–300 точками на дюйм",
        "{file}: the picture has only {size} pixels; scan the sheet at 200 to 300 dpi",
    ),
    "check_large_picture": (
        "{file}: картинка слишком велика ({size} пикселей); обрежьте её до чертежа или сканируйте лист с 300 точками "
        "на дюйм и сохраните как JPEG",
        "{file}: the picture is too large ({size} pixels); crop it to the drawing, or scan the sheet at 300 dpi and "
        "save it as JPEG",
    ),
}
