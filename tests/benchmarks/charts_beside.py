"""The chart of a scene with programs by others beside ours: `python -m tests.benchmarks.charts_beside SCENE CHART`."""

import sys

from planes.documents.charts import draw_chart
from planes.scene import load
from tests.helpers.other_programs import installed

if __name__ == "__main__":
    draw_chart(load(sys.argv[1]), sys.argv[2], None, "en", installed())
