"""``python -m planes.cli``: the same as ``planes``."""

import sys

from planes.__main__ import run

if __name__ == "__main__":
    sys.exit(run())
