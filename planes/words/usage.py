"""What the reader of the command line itself says."""

from __future__ import annotations

USAGE: dict[str, tuple[str, str]] = {
    "usage_line": ("порядок: ", "usage: "),
    "usage_given": ("что указать:", "positional arguments:"),
    "usage_options": ("ключи:", "options:"),
    "usage_help": ("показать эту справку", "show this help message and exit"),
    "usage_version": ("показать номер версии", "show program's version number and exit"),
    "usage_error": (": ошибка: ", ": error: "),
    "usage_missing": ("не указано: ", "the following arguments are required: "),
    "usage_unknown": ("лишнее в команде: ", "unrecognized arguments: "),
    "usage_argument": ("аргумент ", "argument "),
    "usage_no_value": ("нужно значение", "expected one argument"),
    "usage_choice": ("не подходит ", "invalid choice: "),
    "usage_choices": (" (допустимо: ", " (choose from "),
    "usage_not_with": ("нельзя указать вместе с ", "not allowed with argument "),
    "usage_number": ("нужно целое число, а не ", "invalid int value: "),
}
