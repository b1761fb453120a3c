"""``python -m planes.cli``: the same as ``planes``."""

import sys

from planes.cli import main

if __name__ == "__main__":
    sys.exit(main())
