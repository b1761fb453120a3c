"""The teacher's summary of a course."""

from __future__ import annotations

SUMMARY: dict[str, tuple[str, str]] = {
    "sum_title": ("Сводная таблица", "Summary"),
    "sum_student": ("Студент", "Student"),
    "sum_group": ("Группа", "Group"),
    "sum_assignment": ("Задание", "Assignment"),
    "sum_variant": ("Вариант", "Variant"),
    "sum_numbers": ("Числа", "Numbers"),
    "sum_answers": ("Ответы", "Answers"),
    "sum_fault": ("Ошибка", "Fault"),
    "sum_own": ("свой", "own"),
}
