"""What the operating system says of a failure, in Russian."""

from __future__ import annotations

import errno
import os

SYSTEM = {
    os.strerror(code): words
    for code, words in {
        errno.ENOENT: "нет такого файла или папки",
        errno.EACCES: "нет прав доступа",
        errno.EPERM: "не разрешено",
        errno.EISDIR: "это папка",
        errno.ENOTDIR: "часть пути не папка",
        errno.ENOSPC: "на диске нет места",
        errno.EROFS: "диск доступен только для чтения",
        errno.ENAMETOOLONG: "слишком длинное имя файла",
        errno.EEXIST: "такой файл уже есть",
        errno.ENOTEMPTY: "папка не пуста",
        errno.EBUSY: "файл занят",
        errno.ELOOP: "ссылки замкнуты в круг",
        errno.EMFILE: "открыто слишком много файлов",
        errno.EDQUOT: "исчерпана квота диска",
        errno.EIO: "ошибка чтения или записи",
        errno.EFBIG: "файл слишком велик",
        errno.EINVAL: "недопустимое имя или значение",
        errno.ENOMEM: "не хватает памяти",
        errno.ECONNREFUSED: "в соединении отказано",
        errno.ETIMEDOUT: "время ожидания истекло",
    }.items()
}


def in_russian(text: str) -> str:
    """The Russian of what the system says; anything else as it is."""
    return SYSTEM.get(text, text)
