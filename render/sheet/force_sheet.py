"""The second sheet of a course project, forces, as a list of views: every group as a free body with its loads, its plan
and its links; the driver; the lever."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from planes.plans.apart import LinkApart
from planes.solving import Position
from planes.words import say
from planes.words.names import POLE, at, kind_of, links_of, mu_of
from render.sheet.composer import Composer
from render.sheet.sizes import APART, LOADED
from render.views import View, beside, view
from render.views.arms import with_unlettered
from render.views.loading import Loading
from render.views.moments import Lever
from render.views.plotted import Plotted, of_position, scheme_mu, with_links_apart
from render.views.scheme import Scheme


@dataclass
class ForceSheet:
    """The views of sheet 2."""

    composer: Composer

    def views(self, position: Position, scheme: Position, letter: float) -> list[View]:
        """The scheme with loads, which may be larger; every group with its forces and its plan, the driver, the lever,
        tables, all at one choice of μ, used for the arms everywhere."""
        c, (plotted, links_apart) = self.composer, with_links_apart(position)
        every_view: list[View | None] = [self.loaded(scheme)]
        for plan in position.plans.drawn:
            if kind_of(plan) == "force":
                links, single = links_of(plan), links_apart[plan]
                moments = c.moments(position, letter, links)
                step = [
                    c.stack("group", self.group(position, plan, links), moments, gap=5.0),
                    c.stack(plan, c.plan(plotted, plan), c.formulas(plotted, (plan,), letter, "")),
                    self.apart(position, links, self.closed(plotted, single, letter, False)) if single else None,
                    *self.closed(plotted, single, letter, True),
                ]
                every_view += [replace(v, step=plan) for v in step if v]
        every_view.append(self.lever(position, letter))
        tables = c.tables(position, letter)
        return [v for v in (*every_view, tables.given(), *tables.forces(), *c.notes(letter)) if v]

    def loaded(self, position: Position) -> View:
        """The scheme with all external loads."""
        c = self.composer

        def make() -> View:
            loading = Loading(position, c.naming, tuple(position.plans.mechanism.links))
            loading.loads(carried=False)
            drawn = Scheme(position, c.naming).drawn(True, loading.marks, loading.named)
            return view(LOADED, c.titled(position, "loaded"), drawn, True)

        return c.once(("loaded", scheme_mu(position)), make)

    def group(self, position: Position, plan: str, links: tuple[str, ...]) -> View | None:
        """A group as a free body with its forces, reactions and arms."""
        c = self.composer

        def make() -> View:
            loading = Loading(position, c.naming, links)
            loading.loads(carried=True)
            loading.reactions(plan)
            driver = links == (position.plans.structure.driver,)
            if driver:
                loading.balancing(*links)
            loading.arms(position.plans.on(links))
            drawn = Scheme(position, c.naming, links, False).drawn(False, loading.marks, loading.named)
            drawn = with_unlettered(loading.named, drawn, c.lang)
            alone = "loaded_driver" if driver else "loaded_link"
            key = "loaded_group" if len(links) > 1 else alone
            title = c.titled(position, key, links="–".join(map(c.naming.link, links)))
            return view("group", title, drawn, True)

        return c.once(("loaded", links, scheme_mu(position)), make)

    def apart(self, position: Position, links: tuple[str, ...], written: Sequence[View] = ()) -> View | None:
        """The links of a group one by one, each with its loads and all reactions on it, including the inner ones; with
        the text ``written`` beneath them."""
        if len(links) < 2:
            return None
        c = self.composer

        def make() -> View:
            title = c.titled(position, "links_apart", links=", ".join(map(c.naming.link, links)))
            return view(APART, title, beside([self.alone(position, x) for x in links]).marks, True)

        return c.stack(APART, c.once(("apart", links, scheme_mu(position)), make), *written)

    def closed(self, plotted: Plotted, apart: Sequence[LinkApart], letter: float, polygons: bool) -> list[View]:
        """The plans of single links with their equations; or only the equations where just two forces act."""
        c, drawn = self.composer, [x for x in apart if x.polygon is polygons and plotted.has(x.plan, POLE)]
        return [
            c.stack(x.plan, c.plan(plotted, x.plan) if polygons else None, c.formulas(plotted, (x.plan,), letter, ""))
            for x in drawn
        ]

    def alone(self, position: Position, link: str) -> View:
        """A link with its loads and all reactions on it."""
        loading = Loading(position, self.composer.naming, (link,))
        loading.loads(carried=False)
        loading.whole_reactions()
        if position.plans.structure.drive_pair.joins(link):
            loading.balancing(link)
        scheme = Scheme(position, self.composer.naming, (link,), False)
        return view("part", "", scheme.drawn(False, loading.marks, loading.named))

    def lever(self, position: Position, letter: float) -> View | None:
        """Zhukovsky's lever with its moment equation."""
        c, drawer = self.composer, Lever(position, self.composer.naming)
        if at("lever", POLE) not in position.drawing:
            return None
        kind = "motion" if position.plans.at_rest else "velocity"
        title = f"{say('lever', c.lang)}, {c.mu(of_position(position), kind)}"
        key = ("lever", position.scales[mu_of(kind)])
        drawn = c.once(key, lambda: view("lever", title, drawer.drawn(), True))
        return c.stack("lever", drawn, c.moments(position, letter, ("lever",)))
