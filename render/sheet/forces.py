"""Sheet 2 of a course project, forces: every group apart with its loads, its plan, its links; the driver; the lever."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from planes.solving import Position
from planes.words import say
from planes.words.names import kind_of, links_of, mu_of
from render.sheet.composer import Composer
from render.sheet.sizes import Sizes
from render.views import View, beside, view
from render.views.lever import Lever
from render.views.loading import Loading
from render.views.plotted import Places, of_position
from render.views.scheme import Scheme

CROWDED, ALONE = 1.3, 2.2  # how much larger than on paper a group, or a link alone, counts: it need not grow as far

Drawer = Callable[[Sizes], Position]
"""Draws the position with its plans so many times their usual size, where μ is open."""


def apart(plan: str) -> str:
    """The name under which the scheme of a plan's links grows: "scheme:2-3" of "force:2-3"."""
    return f"scheme:{'-'.join(links_of(plan))}"


def enlarged(sizes: Sizes, group: str) -> Sizes:
    """Sizes at which the scheme, all that is shown of them, is as large as a group apart is drawn."""
    times = sizes.of("position") * sizes.of(group) / sizes.factor**2
    return Sizes(sizes.factor).larger("position", times)


def extents(at: Drawer, sizes: Sizes) -> dict[str, float]:
    """Sizes in mm of the groups apart, each at its own scale."""
    found = {}
    for plan in (p for p in at(sizes).plans.drawn if kind_of(p) == "force"):
        group, links = apart(plan), links_of(plan)
        counts = CROWDED if len(links) > 1 else ALONE
        found[group] = counts * Places(at(enlarged(sizes, group))).size(links)
    return found


@dataclass
class ForceSheet:
    """The views of sheet 2."""

    composer: Composer

    def views(self, at: Drawer, sizes: Sizes, letter: float) -> list[View]:
        """Scheme with loads, every group with its forces and its plan, the driver, the lever, tables."""
        c, position = self.composer, at(sizes)
        plotted = of_position(position)
        found: list[View | None] = [self.loaded(position)]
        for plan in (p for p in position.plans.drawn if kind_of(p) == "force"):
            links = links_of(plan)
            larger = at(enlarged(sizes, apart(plan)))
            moments = c.moments(position, letter, links)
            drawn = c.plan(plotted, plan)
            written = c.formulas(plotted, (plan,), letter, "")
            found.append(c.stack("group", self.group(larger, plan, links), moments, gap=5.0))
            found.append(c.stack(plan, drawn, written))
            found.append(self.apart(larger, links, apart(plan)))
        found.append(self.lever(position, letter))
        tables = c.tables(position, letter)
        return [v for v in (*found, tables.reactions(), tables.check()) if v]

    def loaded(self, position: Position) -> View | None:
        """The scheme with all outer loads."""
        c = self.composer

        def make() -> View:
            loading = Loading(position, c.naming, tuple(position.plans.mechanism.links))
            loading.loads(carried=False)
            drawn = Scheme(position, c.naming).drawn(True, loading.marks, loading.named)
            title = f"{say('loaded', c.lang)}, {c.mu(of_position(position), 'position')}"
            return view("loaded", title, drawn, True, plan="position")

        return c.once(("loaded", position.scales[mu_of("position")]), make)

    def group(self, position: Position, plan: str, links: tuple[str, ...]) -> View | None:
        """A group apart with its forces, reactions and arms."""
        c = self.composer

        def make() -> View:
            loading = Loading(position, c.naming, links)
            loading.loads(carried=True)
            loading.reactions(plan)
            if position.plans.structure.driver in links:
                loading.balancing()
            loading.arms([m for m in position.plans.moments if set(m.links) <= set(links)])
            drawn = Scheme(position, c.naming, links, False).drawn(False, loading.marks, loading.named)
            numbers = "–".join(c.naming.link(x) for x in links)
            key = "loaded_group" if len(links) > 1 else "loaded_driver"
            title = f"{say(key, c.lang, links=numbers)}, {c.mu(of_position(position), 'position')}"
            return view("group", title, drawn, True, plan=apart(plan))

        return c.once(("loaded", links, position.scales[mu_of("position")]), make)

    def apart(self, position: Position, links: tuple[str, ...], name: str = "") -> View | None:
        """The links of a group one by one, each with its loads and all reactions on it, the inner ones too."""
        if len(links) < 2:
            return None
        c = self.composer

        def part(link: str) -> View:
            loading = Loading(position, c.naming, (link,))
            loading.loads(carried=False)
            loading.whole_reactions()
            alone = Scheme(position, c.naming, (link,), False)
            return view("part", "", alone.drawn(False, loading.marks, loading.named))

        def make() -> View:
            numbers = ", ".join(c.naming.link(x) for x in links)
            title = f"{say('links_apart', c.lang, links=numbers)}, {c.mu(of_position(position), 'position')}"
            return view("apart", title, beside([part(link) for link in links]).marks, True, plan=name)

        return c.once(("apart", links, position.scales[mu_of("position")]), make)

    def lever(self, position: Position, letter: float) -> View | None:
        """Zhukovsky's lever with its moment equation."""
        c, found = self.composer, Lever(position, self.composer.naming)
        if not found.there:
            return None
        kind = "motion" if position.plans.at_rest else "velocity"
        key, title = ("lever", position.scales[mu_of(kind)]), self.lever_title(position, kind)
        drawn = c.once(key, lambda: view("lever", title, found.drawn(), True, plan=kind))
        written = c.moments(position, letter, ("lever",))
        return c.stack("lever", drawn, written)

    def lever_title(self, position: Position, kind: str) -> str:
        """The lever's name, with the μ of its velocities."""
        c = self.composer
        name = say("lever", c.lang)
        return name if kind == "motion" else f"{name}, {c.mu(of_position(position), 'velocity')}"
