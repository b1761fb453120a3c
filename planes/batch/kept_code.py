"""Machine code cached between processes: a loop's object file, by its text, the compiler and the processor.

It is in the user's cache (``PLANES_CACHE`` names another folder; ``off``, none), the ``MOST`` files used last. A file
that cannot be written, or is damaged, is compiled anew without a message.
"""

import os
import sys
from contextlib import suppress
from hashlib import sha256
from pathlib import Path

from planes.scene.files import save_bytes

MOST_KEPT_FILES = 200  # files; a loop of a six-link is 40 kB
_DIGEST_BYTES = sha256().digest_size


def code_folder() -> Path | None:
    """Where code is kept."""
    if setting := os.environ.get("PLANES_CACHE"):
        return None if setting == "off" else Path(setting)
    homes = {"win32": os.environ.get("LOCALAPPDATA"), "darwin": "~/Library/Caches"}
    home = homes.get(sys.platform) or os.environ.get("XDG_CACHE_HOME") or "~/.cache"
    return Path(home).expanduser() / "planes" / "code"


def kept_object_file(name: str) -> bytes | None:
    """The object file of a name, if it exists and is complete."""
    where = code_folder()
    with suppress(OSError):
        if where:
            file = where / name
            data = file.read_bytes()
            os.utime(file)
            code = data[_DIGEST_BYTES:]
            if sha256(code).digest() == data[:_DIGEST_BYTES]:
                return code
            return None
    return None


def keep_object_file(name: str, code: bytes) -> None:
    """Store an object file; those unused for longest are deleted."""
    where = code_folder()
    with suppress(OSError):
        if where:
            where.mkdir(parents=True, exist_ok=True)
            save_bytes(sha256(code).digest() + code, where / name)
            for old in sorted(where.iterdir(), key=lambda f: f.stat().st_mtime)[:-MOST_KEPT_FILES]:
                old.unlink(missing_ok=True)
