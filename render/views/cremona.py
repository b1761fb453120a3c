"""The plan of a truss: external forces as arrows, members as lines by their senses, regions by their letters."""

from dataclasses import dataclass

from planes.plans.structures.figure import strains
from planes.words.names import CREMONA
from planes.words.naming import Naming
from render.labels import Label
from render.paper.marks import Arrow, Line, Mark
from render.paper.symbols import Marks, dot
from render.views.plotted import NEAR_MM, Plotted, gathered
from render.views.polygon import FORCE_MM, MARK_MM
from render.views.senses import labelled

STYLES = {"tension": "vector", "compression": "vector", "idle": "thin"}


@dataclass
class Cremona:
    """The plan under construction."""

    plotted: Plotted
    naming: Naming

    def drawn(self) -> Marks:
        """All marks with their letters."""
        marks, named, regions = list[Mark](), list[Label](), dict[str, complex]()
        senses = strains(self.plotted.figure, self.plotted.drawing)
        for s in self.plotted.drawn_segments(CREMONA):
            start, end = ends = self.plotted.ends(CREMONA, s)
            regions |= {s.start: start, s.end: end}
            if abs(end - start) <= NEAR_MM:
                continue
            if sense := senses.get(s.name):
                marks.append(Line(ends, STYLES[sense], "result", name=f"{sense} {s.name}"))
            else:
                marks.append(Arrow(*ends, "result", "force", s.name))
                named.append(Label(self.naming.vector(s.name), ends, FORCE_MM, name=s.name))
        for z, letters in gathered(regions.items()):
            marks += dot(z, 0.5, "plan")
            text = ", ".join(letters)
            named.append(Label(text, z, MARK_MM, clear=0.7, priority=1, name=text))
        return labelled(named, marks)
