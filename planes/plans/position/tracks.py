"""The assembly of a higher group: all are found and counted at the drive's position, one chosen and followed."""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from planes.drafting.drawing import draw_program
from planes.drafting.program import Program
from planes.drafting.steps.tracks import TrackStep
from planes.geometry import plane
from planes.geometry.arithmetic import Arithmetic, Real
from planes.geometry.plane import greatest_distance
from planes.geometry.tracks import Pose, Tie, newton_step
from planes.plans.assur.basic_chains import BasicChain
from planes.plans.assur.basic_links import Triad
from planes.plans.position.bodies import AssemblyChoice, Bodies, TrackChoice
from planes.plans.position.branch import Branch, follow_branch
from planes.scene.mechanism import Assembly
from planes.words import Phrase
from planes.words.errors import PlanFailure, SceneError
from planes.words.names import SCHEME_PLAN, scheme_mark

if TYPE_CHECKING:
    from planes.geometry.sextic import Counted

LEAD_PAIR_ORDERS = ((0, 1), (1, 2), (2, 0))
AnyChoice = AssemblyChoice | TrackChoice
# of the distance from a scene's ``near`` to the second nearest assembly: the nearest must be this close
MOST_NEAREST_DISTANCE_RATIO = 0.8
# the same for two places that nobody would confuse: up to about the middle between them
MOST_CLEAR_DISTANCE_RATIO = 0.95


class Tracks:
    """The assemblies of a higher group at the drive's position in the file."""

    def __init__(self, b: Bodies, program: Program, choice: TrackChoice) -> None:
        self.bodies = b
        self.choice = choice
        self.whole = program
        named = [n for h in choice.holds for n in (h.place, h.turn if h.kind == "line" else "", h.reach) if n]
        self.program = program.cut_to_names([n for n in named if n in b.draft.steps])
        self.size = greatest_distance([b.draft.given[h.local] for h in choice.holds])
        if not self.size:  # three guides through one point, which fixes them
            self.size = (
                greatest_distance([tie.place for tie in self.ties_at_drive_position(self.drive_position_in_file)])
                or 1.0
            )
        b.draft.given[choice.guess.size] = self.size

    def ties_at_drive_position(self, value: Real) -> list[Tie]:
        """The leads at a position of the drive, in m."""
        given = {**self.bodies.draft.given, SCHEME_PLAN.mu_name: 1.0, self.choice.guess.drive: value}
        things = draw_program(self.program, given).things
        return [hold.lead_tie(things, 1.0, Arithmetic()) for hold in self.choice.holds]

    @property
    def drive_position_in_file(self) -> float:
        """The drive's position in the file."""
        return self.bodies.mechanism.drive.position

    def all_assemblies(self) -> Counted:
        """All assemblies there; few scenes need them, so the method is imported here."""
        from planes.geometry.assemblies import all_assemblies

        return all_assemblies(self.ties_at_drive_position(self.drive_position_in_file), self.size)

    def place_of_point(self, pose: Pose, point: str) -> complex:
        """The place of a point of the group in an assembly."""
        self.store_assembly(
            Branch(
                self.drive_position_in_file - 1.0,
                self.drive_position_in_file + 1.0,
                self.sense_of_lead_lines(pose),
                (pose[0] / self.size,),
                series_angles_of_pose(pose),
            )
        )
        mark = scheme_mark(point)
        program = Program(tuple(self.bodies.draft.steps.values())).cut_to_names([mark])
        return complex(draw_program(program, {**self.bodies.draft.given, SCHEME_PLAN.mu_name: 1.0})[mark])

    def sense_of_lead_lines(self, pose: Pose) -> float:
        """The sense of the leads' lines about each other."""
        if newton_step(self.ties_at_drive_position(self.drive_position_in_file), pose)[2] > 0:
            return 1.0
        return -1.0

    def store_assembly(self, branch: Branch) -> None:
        """Give the program an assembly and its range."""
        d = self.bodies.draft
        old = self.choice.guess
        basics = self.choice.group.basics
        d.given[old.middle] = (branch.low + branch.high) / 2
        d.given[old.half] = (branch.high - branch.low) / 2
        d.given[self.choice.side] = branch.side
        laws = [("track", basics[0], branch.places), *(("turning", *x) for x in zip(basics, branch.turns, strict=True))]
        places, *turned = (tuple(f"{what}_{basic}_{k}" for k in range(len(terms))) for what, basic, terms in laws)
        for names, (_, _, terms) in zip((places, *turned), laws, strict=True):
            d.given |= dict(zip(names, terms, strict=True))
        guess = replace(old, places=places, turns=tuple(turned))
        for name, step in d.steps.items():
            if isinstance(step, TrackStep) and step.holds == self.choice.holds:
                d.steps[name] = replace(step, guess=guess)

    def choose_pose(self, pose: Pose) -> None:
        """Choose an assembly, follow it, and draw by the leads that cross most sharply there."""
        branch = follow_branch(
            self.ties_at_drive_position, self.drive_position_in_file, pose, self.size, self.choice.guess.turning
        )
        if branch is None:
            raise self.error(Phrase("track_not_followed", **self.names_for_sentences()))
        self.store_assembly(branch)
        if isinstance(self.choice.group, BasicChain):
            return
        leads = self.choice.group.leads
        sharp = self.crossing_sharpness(pose)
        first = sharp.index(max(sharp))
        self.bodies.leads[self.choice.group.basic] = leads[first:] + leads[:first]

    def crossing_sharpness(self, pose: Pose) -> list[float]:
        """The sharpness of the crossing of two leads in the special point; in class IV of one lead with its driven
        line."""
        ties = self.ties_at_drive_position(self.drive_position_in_file)
        pulls = [tie.error_and_wrench(*pose)[1] for tie in ties]
        if isinstance(self.choice.group, Triad):
            return [abs(plane.cross(pulls[i], pulls[j])) for i, j in LEAD_PAIR_ORDERS]
        if ties[2].kind == "guide":  # the basic link slides, so all its points move alike
            return [abs(plane.cross(pull, pulls[2])) for pull in pulls[:2]]
        hinge = pose[0] + pose[1] * ties[2].local
        held = [tie.held_place(*pose) for tie in ties[:2]]
        return [abs(plane.cross(n, p - hinge)) / abs(p - hinge) for n, p in zip(pulls, held, strict=False)]

    def names_for_sentences(self) -> dict[str, object]:
        """The names of the group for sentences."""
        return names_for_choice_sentences(self.bodies, self.choice)

    def error(self, why: Phrase, *path: str) -> SceneError:
        """An error at its line."""
        where = self.bodies.mechanism.where
        return SceneError(why, self.bodies.file, where.get(path or ("assembly",), where.get(("links",))))


def choose_triad_assembly(b: Bodies, program: Program, choice: TrackChoice) -> None:
    """Choose the assembly of a triad; :class:`SceneError` lists all where the scene does not settle which."""
    tracks = Tracks(b, program, choice)
    try:
        counted = tracks.all_assemblies()
    except PlanFailure as failure:
        raise tracks.error(Phrase("near_not_drawn", key=choice.key, failure=failure.phrase)) from None
    if not counted.is_count_proved:
        raise tracks.error(Phrase("tracks_touch", **tracks.names_for_sentences()), "drive")
    if not counted.poses:
        raise tracks.error(
            Phrase("tracks_miss" if counted.whole else "tracks_not_met", **tracks.names_for_sentences()), "drive"
        )
    said = _scene_entries_for_triad(b, choice)
    if not said and len(counted.poses) == 1 and counted.whole:
        tracks.choose_pose(counted.poses[0])
        return
    if not said or any(assembly.near is None for _, assembly in said):
        raise tracks.error(_assembly_choice_question(tracks, counted, said[0][0] if said else choice.key))
    chosen = {}
    for key, assembly in said:
        places = {tracks.place_of_point(pose, key): pose for pose in counted.poses}
        if len(places) < len(counted.poses):
            raise tracks.error(Phrase("near_same", key=key, point=key), "assembly", key)
        assert assembly.near is not None
        chosen[key] = places[nearest_place_meant(b, choice, key, assembly.near, list(places))]
    require_consistent_choice(b, choice, chosen, dict(_offers_by_pose(tracks, counted, choice.key)))
    tracks.choose_pose(chosen[said[0][0]])


def nearest_place_meant(
    b: Bodies,
    choice: AnyChoice,
    key: str,
    near: complex,
    places: Sequence[complex],
    doubtful: float = MOST_NEAREST_DISTANCE_RATIO,
) -> complex:
    """The place that a scene's ``near`` means; :class:`SceneError` where the second nearest is hardly farther."""
    ordered = sorted(places, key=lambda place: abs(place - near))
    off = [abs(place - near) for place in ordered]
    if len(off) > 1 and off[0] > doubtful * off[1]:
        offers = tuple(words_choosing_place(key, z) for z in places)
        details = {"key": key, "off": off[0], "next": off[1], "count": len(off), "offers": offers}
        line = b.mechanism.where.get(("assembly", key))
        raise SceneError(Phrase("near_between", **details, **names_for_choice_sentences(b, choice)), b.file, line)
    return ordered[0]


def require_consistent_choice(
    b: Bodies, choice: AnyChoice, chosen: Mapping[str, object], offers: Mapping[object, Phrase]
) -> None:
    """Refuse contradictory choices: one assembly by one point and another by another."""
    (key, first), *others = chosen.items()
    against = next((other for other, it in others if it != first), None)
    if against is not None:
        details = {"key": key, "other": against, "offers": tuple(offers[x] for x in offers)}
        line = b.mechanism.where.get(("assembly", against))
        raise SceneError(Phrase("near_against", **details, **names_for_choice_sentences(b, choice)), b.file, line)


def names_for_choice_sentences(b: Bodies, choice: AnyChoice) -> dict[str, object]:
    """The names of a group and of the drive's position, for sentences."""
    g = choice.group
    drive = b.mechanism.drive
    name, unit = ("φ", "°") if drive.rotates else ("s", " m")
    return {
        "level": g.level,
        "links": g.links,
        "name": g.pair_letters,
        "drive": name,
        "value": f"{drive.position:.10g}{unit}",
    }


def _scene_entries_for_triad(b: Bodies, choice: TrackChoice) -> list[tuple[str, Assembly]]:
    """The scene's entries for a triad, under any points that move with it."""
    inside = choice.group.inner_pairs
    outer = {pair.point for pair in choice.group.pairs if pair not in inside}
    points = {p for link in choice.group.links for p in b.mechanism.links[link].points} - outer
    return [(key, said) for key, said in b.mechanism.assembly.items() if key in points]


def _assembly_choice_question(tracks: Tracks, counted: Counted, key: str) -> Phrase:
    """All assemblies, each with the words that choose it."""
    offers = tuple(offer for _, offer in _offers_by_pose(tracks, counted, key))
    more = bool(tracks.bodies.mechanism.assembly)
    details = {
        "count": len(offers),
        "offers": offers,
        "proof": Phrase("tracks_proved" if counted.whole else "tracks_met"),
    }
    return Phrase("tracks_more" if more else "tracks_all", **details, **tracks.names_for_sentences())


def _offers_by_pose(tracks: Tracks, counted: Counted, key: str) -> Iterator[tuple[Pose, Phrase]]:
    for pose in counted.poses:
        yield pose, words_choosing_place(key, tracks.place_of_point(pose, key))


def words_choosing_place(key: str, z: complex) -> Phrase:
    """The words that choose a place, as typed in a scene."""
    return Phrase("track_offer", key=key, place=f"[{z.real:.5g}, {z.imag:.5g}]")


def series_angles_of_pose(pose: Pose) -> tuple[tuple[float, ...], ...]:
    """The angles of a pose, radians, each as a series of one term."""
    return tuple((cmath.phase(axis),) for axis in pose[1:])
