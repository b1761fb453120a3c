"""Words of the lesson's page, whose places {…} are filled by its script, in Russian and in English."""

from __future__ import annotations

PAGES: dict[str, tuple[str, str]] = {
    "page_back": ("Назад", "Back"),
    "page_next": ("Вперёд", "Next"),
    "page_play": ("Показать подряд", "Play"),
    "page_spin": ("Вращать ведущее звено", "Turn the driver"),
    "page_step": ("Шаг построения", "Step of the construction"),
    "page_crank": ("Положение ведущего звена", "Position of the driver"),
    "page_home": ("Заданное положение", "Given position"),
    "page_practise": ("Практика", "Practice"),
    "page_score": ("Верно с первого раза", "Right at once"),
    "page_over": ("Построение закончено. Верно с первого раза:", "The drawing is done. Right at once:"),
    "page_again": ("Сначала", "Again"),
    "page_right": ("Верно.", "Right."),
    "page_shown": ("Верный ответ построен, идём дальше.", "The right answer is drawn; on we go."),
    "page_or_else": ("или", "or"),
    "page_check": ("Проверить", "Check"),
    "page_list": ("Выбрать из отмеченных мест", "Choose among marked places"),
    "page_millimetres": ("мм", "mm"),
    "page_ask_known": (
        "Что известно о каждом векторе? Нажимайте: две черты — всё, одна — направление или величина, ни одной — "
        "ничего.",
        "What is known of each vector? Press: two lines — all, one — direction or length, none — nothing.",
    ),
    "page_ask_direction": ("Куда направлен {name} от {start}?", "Which way does {name} run from {start}?"),
    "page_ask_length": ("Сколько миллиметров откладываем для {name}?", "How many millimetres are laid off for {name}?"),
    "page_ask_line": (
        "Ищем {mark}. Какую прямую проводим через {through}?",
        "We look for {mark}. Which line goes through {through}?",
    ),
    "page_ask_place": ("Где {mark}? Нажмите на чертеже.", "Where is {mark}? Click on the drawing."),
    "page_ask_similar": (
        "Где {mark} по подобию? Нажмите на чертеже.",
        "Where is {mark} by similarity? Click on the drawing.",
    ),
    "page_why_known": (
        "Две черты — построенные раньше и вычисленные векторы (нормальные, кориолисовы); одна — те, у которых "
        "известна только линия действия; полный искомый вектор не подчёркивают.",
        "Two lines: vectors drawn before and calculated ones (normal, Coriolis); one line: those of which only the "
        "line of action is known; the sought whole vector has none.",
    ),
}
