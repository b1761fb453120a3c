"""The second sheet of a course project, forces, as a list of views: every group as a free body with its loads, its plan
and its links; the driver; the lever."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from planes.plans.apart import LinkApart
from planes.solving import Position
from planes.words import say
from planes.words.names import LEVER_PLAN, MOTION_PLAN, POLE_LABEL, VELOCITY_PLAN, NameTuple, PlanId
from render.sheet.composer import Composer
from render.sheet.sizes import LOADED_VIEW_KEY, SINGLE_LINKS_VIEW_KEY
from render.views import View, make_view, put_views_in_row
from render.views.arms import with_unseen_arm_names
from render.views.loading import Loading
from render.views.moments import Lever
from render.views.plotted import Plotted, plot_position, plot_with_single_links, scheme_mu
from render.views.scheme import Scheme


@dataclass
class ForceSheet:
    """The views of sheet 2."""

    composer: Composer

    def all_views(self, position: Position, scheme: Position, letter: float) -> list[View]:
        """The scheme with loads, which may be larger; every group with its forces and its plan, the driver, the lever,
        tables, all at one choice of μ, used for the arms everywhere."""
        c = self.composer
        plotted, links_apart = plot_with_single_links(position)
        every_view: list[View | None] = [self.loaded_scheme_view(scheme)]
        for plan in position.plans.plan_names:
            if plan.is_force:
                links = plan.links
                single = links_apart[plan]
                moments = c.moments_view(position, letter, links)
                step = [
                    c.stack_existing_views("group", self.group_view(position, plan, links), moments, gap=5.0),
                    c.stack_existing_views(plan, c.plan(plotted, plan), c.equations_view(plotted, (plan,), letter, "")),
                    self.single_links_view(position, links, self.single_link_plan_views(plotted, single, letter, False))
                    if single
                    else None,
                    *self.single_link_plan_views(plotted, single, letter, True),
                ]
                every_view += [replace(v, step=plan) for v in step if v]
        every_view.append(self.lever_view(position, letter))
        tables = c.make_tables(position, letter)
        return [v for v in (*every_view, tables.given_table(), *tables.force_tables(), *c.note_views(letter)) if v]

    def loaded_scheme_view(self, position: Position) -> View:
        """The scheme with all external loads."""
        c = self.composer

        def make() -> View:
            loading = Loading(position, c.naming, tuple(position.plans.mechanism.links))
            loading.draw_loads(carried=False)
            drawn = Scheme(position, c.naming).drawn_marks(True, loading.marks, loading.named)
            return make_view(LOADED_VIEW_KEY, c.title_with_mu(position, "loaded"), drawn, True)

        return c.cached_view(("loaded", scheme_mu(position)), make)

    def group_view(self, position: Position, plan: PlanId, links: NameTuple) -> View | None:
        """A group as a free body with its forces, reactions and arms."""
        c = self.composer

        def make() -> View:
            loading = Loading(position, c.naming, links, position.plans.moment_equations_on_links(links))
            loading.draw_loads(carried=True)
            loading.draw_reactions(plan)
            driver = links == (position.plans.structure.driver,)
            if driver:
                loading.draw_balancing_load(*links)
            loading.draw_arms()
            drawn = Scheme(position, c.naming, links, False).drawn_marks(False, loading.marks, loading.named)
            drawn = with_unseen_arm_names(loading.named, loading.short_arms, drawn, c.lang)
            alone = "loaded_driver" if driver else "loaded_link"
            key = "loaded_group" if len(links) > 1 else alone
            title = c.title_with_mu(position, key, links="–".join(map(c.naming.link_number, links)))
            return make_view("group", title, drawn, True)

        return c.cached_view(("loaded", links, scheme_mu(position)), make)

    def single_links_view(self, position: Position, links: NameTuple, written: Sequence[View] = ()) -> View | None:
        """The links of a group one by one, each with its loads and all reactions on it, including the inner ones; with
        the text ``written`` beneath them."""
        if len(links) < 2:
            return None
        c = self.composer

        def make() -> View:
            title = c.title_with_mu(position, "links_apart", links=", ".join(map(c.naming.link_number, links)))
            return make_view(
                SINGLE_LINKS_VIEW_KEY,
                title,
                put_views_in_row([self.single_link_view(position, x) for x in links]).marks,
                True,
            )

        return c.stack_existing_views(
            SINGLE_LINKS_VIEW_KEY, c.cached_view(("apart", links, scheme_mu(position)), make), *written
        )

    def single_link_plan_views(
        self, plotted: Plotted, apart: Sequence[LinkApart], letter: float, polygons: bool
    ) -> list[View]:
        """The plans of single links with their equations; or only the equations where just two forces act."""
        c = self.composer
        drawn = [x for x in apart if x.polygon is polygons and plotted.has_marks(x.plan, POLE_LABEL)]
        return [
            c.stack_existing_views(
                x.plan, c.plan(plotted, x.plan) if polygons else None, c.equations_view(plotted, (x.plan,), letter, "")
            )
            for x in drawn
        ]

    def single_link_view(self, position: Position, link: str) -> View:
        """A link with its loads and all reactions on it."""
        loading = Loading(position, self.composer.naming, (link,))
        loading.draw_loads(carried=False)
        loading.draw_whole_reactions()
        if position.plans.structure.drive_pair.has_link(link):
            loading.draw_balancing_load(link)
        scheme = Scheme(position, self.composer.naming, (link,), False)
        return make_view("part", "", scheme.drawn_marks(False, loading.marks, loading.named))

    def lever_view(self, position: Position, letter: float) -> View | None:
        """Zhukovsky's lever with its moment equation."""
        c = self.composer
        drawer = Lever(position, self.composer.naming)
        if LEVER_PLAN.pole not in position.drawing:
            return None
        kind = MOTION_PLAN if position.plans.at_rest else VELOCITY_PLAN
        title = f"{say('lever', c.lang)}, {c.title_mu(plot_position(position), kind)}"
        key = ("lever", position.scales[kind.mu_name])
        drawn = c.cached_view(key, lambda: make_view("lever", title, drawer.drawn_marks(), True))
        return c.stack_existing_views("lever", drawn, c.moments_view(position, letter, ("lever",)))
