"""The plan of a truss: external forces as arrows, members as lines by their senses, regions by their letters."""

from dataclasses import dataclass

from planes.plans.structures.figure import member_strains
from planes.words.names import CREMONA_PLAN
from planes.words.naming import Naming
from render.labels import Label
from render.paper.marks import Arrow, Line, Mark
from render.paper.symbols import Marks, dot
from render.views.plotted import SAME_PLACE_MM, Plotted, group_names_by_place
from render.views.polygon import FORCE_LETTER_MM, MARK_LETTER_MM
from render.views.senses import marks_with_labels

MEMBER_LINE_STYLES = {"tension": "vector", "compression": "vector", "idle": "thin"}


@dataclass
class Cremona:
    """The plan under construction."""

    plotted: Plotted
    naming: Naming

    def drawn_marks(self) -> Marks:
        """All marks with their letters."""
        marks = list[Mark]()
        named = []
        regions = dict[str, complex]()
        senses = member_strains(self.plotted.figure, self.plotted.drawing)
        for s in self.plotted.drawn_segments(CREMONA_PLAN):
            start, end = ends = self.plotted.vector_ends(CREMONA_PLAN, s)
            regions |= {s.start: start, s.end: end}
            if abs(end - start) <= SAME_PLACE_MM:
                continue
            if sense := senses.get(s.name):
                marks.append(Line(ends, MEMBER_LINE_STYLES[sense], "result", name=f"{sense} {s.name}"))
            else:
                marks.append(Arrow(*ends, "result", "force", s.name))
                named.append(Label(self.naming.lettered_vector(s.name), ends, FORCE_LETTER_MM, name=s.name))
        for z, letters in group_names_by_place(regions.items()):
            marks += dot(z, 0.5, "plan")
            text = ", ".join(letters)
            named.append(Label(text, z, MARK_LETTER_MM, clear=0.7, priority=1, name=text))
        return marks_with_labels(named, marks)
