"""The single gate between the program's names and people's: the lettering of a sheet, and the meaning of a typed name.

F_30 of the program is F_36 on sheets whose frame is link 6, and R_63 where a reaction is indexed "from the first link
on the second"; I_2 is Φ_2, the pole of accelerations π. All code that prints or reads a name goes through here.
"""

import re
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from itertools import product

from planes.words import Lang, Phrase, available_languages, say, with_decimal_sign
from planes.words.errors import PlanesError, list_valid_choices
from planes.words.frozen import frozen, replace
from planes.words.lettering import (
    letter_and_analogue_index,
    terminal_spelling,
    with_number_as_subscript,
    without_index_markup,
)
from planes.words.names import POLE_LABEL, NameTuple, component_ending_at, split_value_name, without_markup
from planes.words.units import Convention, mu_text

PRIME_SIGN = "′"
_POLE_SPELLINGS = {"π", "p", "p'", "π'", "полюс", "pole", "P"}
Ways = Mapping[str, Sequence[str]]


@frozen
class Naming:
    """The lettering of a sheet: its language, the number of the frame, the convention of reactions (``from_on``: R_12
    acts from 1 on 2, with tangential component R^τ and arm H_12), the driver, the vectors that end at the point of the
    frame under a slider, the convention of μ."""

    lang: Lang = "ru"
    frame: str = "0"
    from_on: bool = False
    driver: str = "1"
    grounded: Collection[str] = ()
    convention: Convention = "mm_per_unit"

    def mu_with_unit(self, size: float, kind: str) -> str:
        """μ of a kind of plan as written: 30 mm/(m/s)."""
        return with_decimal_sign(mu_text(size, kind, self.lang, self.convention), self.lang)

    def link_number(self, name: str) -> str:
        """A link's number; the frame has the number given in the scene."""
        return self.frame if name == "0" else name

    def lettered_point(self, name: str) -> str:
        """A point of the scheme: S2 -> S_{2}."""
        return with_number_as_subscript(name)

    def mark(self, label: str, plan: str) -> str:
        """A mark of a velocity or acceleration plan: s2' -> s_{2}′, n_CB -> n_{CB}, the pole of accelerations π."""
        if label == "p":
            return "π" if plan == "acceleration" else "p"
        primes = len(label) - len(label.rstrip("'′"))
        label = label.rstrip("'′")
        return with_number_as_subscript(label) + PRIME_SIGN * primes

    def lettered_vector(self, name: str) -> str:
        """A vector or a value: v_CB, a_HL^k, F_21^t, G_2, I_2, P_5, omega_2, M_3, l_AB, omegaq_2 for a unit velocity of
        the driver."""
        times, _, vector = name.partition("·")
        if vector:
            return f"{with_decimal_sign(times, self.lang)}·{self.lettered_vector(vector)}"
        base, _, part = name.partition("^")
        letter, _, index = base.partition("_")
        part = "τ" if self.from_on and part == "t" else part
        if letter == "MR":
            return f"M({self.lettered_vector(index)})"
        if letter == "arm":
            return f"h_{{{without_index_markup(self.lettered_vector(index))}}}"
        if letter in ("MZ", "FZ"):
            letter = letter[0]
            part = say("lever_letter", self.lang)
        letter, analogue = letter_and_analogue_index(letter)
        if letter in ("F", "R") and index:
            letter = "R" if self.from_on else letter
            index = self.reaction_link_pair(index)
        elif letter == "I":
            letter = "Φ"
        elif letter == "M" and index == self.driver:
            index = say("balance", self.lang)
        elif letter in ("MI", "MP"):
            letter, index = "M", ("Φ" if letter == "MI" else "P") + index
        elif letter in ("N", "T", "PT", "MT", "ω") and index.startswith("F_"):  # friction is indexed like its reaction
            letter, index = letter[0], letter[1:] + analogue + self.reaction_link_pair(index[2:])
        elif letter in ("v", "a"):
            index = self.driver if index == "drive" else index.removeprefix("slide_")
            index = analogue + (index[:-1] + self.frame if index[-1:] == "0" and base in self.grounded else index)
        elif analogue:
            index = analogue + index
        elif letter == "Fb":
            return self.balancing_letter(False)
        return letter + (f"_{{{index.replace('_', ',')}}}" if index else "") + (f"^{{{part}}}" if part else "")

    def own_vector_name(self, name: str) -> str:
        """A point's own vector for one that is the same, since it ends at a point of the frame: v_B for v_BB0."""
        half = name[: (len(name) - 1) // 2 + 1]
        if name in self.grounded and name == f"{half}{half[2:]}0":
            return half
        return name

    def lettered_arm(self, force: str, arm: str) -> str:
        """An arm of a force by its name in the program: h_G_2_C -> h_{G2}, h_G_2_B^B -> h_{G2}^{B}, H_G_2 -> H_{G2};
        of a reaction R_12 from 1 on 2 H_{12}."""
        about = arm.removeprefix(f"{arm[0]}_{force}").partition("^")[2]
        index = without_index_markup(self.lettered_vector(force))
        letter = arm[0]
        if self.from_on and force.startswith("F_"):
            index = index.removeprefix("R")
            letter = "H"
        return f"{letter}_{{{index}}}" + (f"^{{{without_index_markup(self.lettered_point(about))}}}" if about else "")

    def reaction_link_pair(self, index: str) -> str:
        """The two links of a reaction in the order this sheet uses."""
        on, by = index.split("_", 1) if "_" in index else (index[:1], index[1:])
        if by[-1:] in ("t", "n"):
            by = by[:-1]
        pair = (
            (self.link_number(by), self.link_number(on))
            if self.from_on
            else (self.link_number(on), self.link_number(by))
        )
        return "".join(pair) if max(map(len, pair)) == 1 else ",".join(pair)

    def balancing_letter(self, turning: bool) -> str:
        """The balancing moment or force."""
        return f"{'M' if turning else 'F'}_{{{say('balance', self.lang)}}}"

    def lettered_name(self, name: str, plan: str = "") -> str:
        """A name in running text: a mark of a plan, an arm, a point or a vector; a direction takes that of its
        vector."""
        plain = name.strip("|‖°").removesuffix("_given")
        letter, _, index = plain.partition("_")
        if letter in ("h", "H") and index:
            return self.lettered_arm(index.rpartition("_")[0] if letter == "h" else index, plain)
        if "'" in plain or plain == "p":
            return self.mark(plain, plan)
        if index:
            return self.lettered_vector(component_ending_at(plain))
        return with_number_as_subscript(plain)

    def lettered_curve(self, name: str) -> str:
        """A curve's name as a letter with its index in _{…}: v_C_x, vq_slide_3, F_21, F_11_10, F_50_arm."""
        head, *index = name.split("_")
        last = index.pop() if index[1:] and index[-1] in _COMPONENT_SUFFIXES else ""
        axis = last if last in ("x", "y") else ""
        subject = "".join(index[1:] if index[:1] == ["slide"] else index)
        if head == "r":
            return f"{axis or 'r'}_{{{subject}}}"
        if head == "u":
            return f"u_{{{','.join(index)}}}"
        if head in ("M", "MZ", "Fb", "FbZ"):
            return self.balancing_letter(head.startswith("M")) + ("^{Ж}" if head.endswith("Z") else "")
        if head == "F":
            letter = {"arm": "h", "moment": "M"}.get(last, "R" if self.from_on else "F")
            return f"{letter}_{{{self.reaction_link_pair('_'.join(index))}{axis}}}"
        letter, analogue = ("a^{k}", "") if head == "coriolis" else letter_and_analogue_index(head)
        return f"{letter}_{{{analogue}{subject}{axis}}}"

    def typed_name(self, name: str) -> str:
        """A name as it is typed in a table or an option: that of the program but for reactions, F_36 or R_63."""
        head, _, part = name.rpartition("_")
        if part in _COMPONENT_SUFFIXES:
            return f"{self.typed_name(head)}_{part}"
        letter, index, _ = split_value_name(name)
        if letter not in ("F", "R") or not index[:1].isalnum():
            return name
        if index.isalnum() or "_" in index:
            return terminal_spelling(self.lettered_vector(name))
        return name

    def retell_in_typed_names(self, text: str, names: Iterable[str]) -> str:
        """A sentence that was told in the program's names, in those that people type and sheets print."""
        other = {name: said for name in names if (said := re.sub("^I_", "Φ_", self.typed_name(name))) != name}
        some = "|".join(map(re.escape, sorted(other, key=len, reverse=True)))
        if other:
            return re.sub(rf"(?<![\w^])(?:{some})(?![\w^])", lambda m: other[m[0]], text)
        return text

    def terminal_vector_name(self, name: str) -> str:
        """A vector or a value as printed at a terminal: omega_2_1 -> ω2,1."""
        return without_index_markup(self.lettered_vector(name))

    def all_letterings(self, name: str) -> NameTuple:
        """All ways in which this sheet letters a name of the program."""
        letter, _, index = name.partition("_")
        ways = [self.lettered_vector(component_ending_at(name)), self.lettered_name(name)]
        letter, index = (f"{letter}T", index[1:]) if letter in "PM" and index.startswith("T") else (letter, index)
        if letter in _FRICTION_LETTERS and index[:1].isdigit():
            ways.append(self.lettered_vector(f"{letter}_F_{index}"))
        balancing = name.startswith(("M_", "MZ_", "Fb_", "FbZ_")) and name.partition("_")[2] == self.driver
        if balancing or name.startswith(("coriolis_", "r_")) or name.rpartition("_")[2] in _COMPONENT_SUFFIXES:
            ways += [self.lettered_curve(name), self.typed_name(name)]
        return tuple(ways)

    def name_finder(self, known: Iterable[str], poles: bool = True, more: Ways | None = None) -> "Names":
        """The gate for the ``known`` names of the program. ``poles`` also accepts the ways to write p; ``more`` gives
        other spellings of some names."""
        return Names(known, self, poles, more)

    @cached_property
    def other_namings(self) -> tuple["Naming", ...]:
        """Namings of the same scene under the other convention, in other languages, with the frame's number and 0."""
        frames = dict.fromkeys((self.frame, "0"))
        orders = (self.from_on, not self.from_on)
        ways = product(dict.fromkeys((self.lang, *available_languages())), frames, orders)
        return tuple(replace(self, lang=lang, frame=frame, from_on=order) for lang, frame, order in ways)


_COMPONENT_SUFFIXES = ("x", "y", "arm", "moment")
_FRICTION_LETTERS = ("N", "T", "PT", "MT")  # of friction: they have the index of their reaction


class Names:
    """Finds the program's name for a typed one in any lettering; ``poles`` also accepts the ways to write p. The
    lettering of the scene's own sheets and of the program takes precedence."""

    def __init__(self, known: Iterable[str], naming: Naming, poles: bool = True, more: Ways | None = None) -> None:
        self.known = dict.fromkeys(known)
        self.naming = naming
        self.poles = poles
        self.more = more or {}

    @cached_property
    def _names_by_spelling(self) -> Ways:
        return self._group_names(self._own_spellings, str)

    @cached_property
    def _names_by_other_spelling(self) -> Ways:
        """The lettering of other sheets: R_63 or R_36 for F_36 where the scene does not settle which."""
        return self._group_names(self._other_spellings, str)

    @cached_property
    def _names_by_lower_case(self) -> tuple[Ways, Ways]:
        """Names in lower case, with and without primes."""
        return self._group_names(self._own_spellings, str.casefold), self._group_names(
            self._own_spellings, lambda k: k.casefold().replace("'", "")
        )

    def _group_names(self, ways: Callable[[str], Iterable[str]], key: Callable[[str], str]) -> Ways:
        names_by = dict[str, dict[str, None]]()
        for name in self.known:
            for way in ways(name):
                names_by.setdefault(key(without_markup(way)), {})[name] = None
        return {way: [*names] for way, names in names_by.items()}

    def _own_spellings(self, name: str) -> Iterator[str]:
        yield from (name, *self.more.get(name, ()), *self.naming.all_letterings(name))

    def _other_spellings(self, name: str) -> Iterator[str]:
        for naming in self.naming.other_namings:
            for way in naming.all_letterings(name):
                yield from (way, way.replace(",", ""))
                if way.startswith("F_") and not self.naming.from_on:
                    yield from (f"R{way[1:]}", f"R{way[1:]}".replace(",", ""))

    def find_exact_name(self, written: str) -> str | None:
        """The program's name if typed letter by letter, or the pole however it is typed."""
        name = self.find_name(written)
        if name == POLE_LABEL or without_markup(written) in self._names_by_spelling:
            return name
        return None

    def find_name(self, written: str) -> str | None:
        """The program's name, or None where none or two fit."""
        meant = self.possible_names(written)
        return meant[0] if len(meant) == 1 else None

    def require_name(self, written: str, refusal: str, same: Callable[[str], object] = str, **more: object) -> str:
        """The name meant, any of those that are the ``same``. :class:`PlanesError` names the two candidates, or lists
        the valid names in the words of the ``refusal``."""
        meant = {same(name): name for name in reversed(self.possible_names(written))}
        if len(meant) == 1:
            return next(iter(meant.values()))
        if meant:
            raise PlanesError(Phrase("name_of_two", name=written, names=", ".join(meant.values())))
        valid = list_valid_choices(written, map(self.naming.typed_name, self.known))
        raise PlanesError(Phrase(refusal, name=written, valid=valid, **more))

    def possible_names(self, written: str) -> Sequence[str]:
        """All names of the program that a typed one may stand for; empty where it is nobody's spelling."""
        if written in self.known and not written.startswith(("F_", "R_")):
            return [written]
        key = without_markup(written)
        if self.poles and key in _POLE_SPELLINGS:
            return [POLE_LABEL]
        if names := self._names_by_spelling.get(key) or self._names_by_other_spelling.get(key):
            return names
        primed, plain = self._names_by_lower_case
        if self.poles:  # of marks primes are left out at times
            return primed.get(key.casefold()) or plain.get(key.casefold().replace("'", ""), [])
        return primed.get(key.casefold(), [])
