"""Names of marks, vectors and values as people letter them: F_21^t -> F_{21}^{t}, I_2 -> Φ_{2}; curves over the cycle:
vq_C -> v_{qC}, F_21_x -> F_{21x}. And what a thing is called in a sentence, never by the program's own marks.

A helper mark is named "°y-y" (where a guide stands), "H°CL" (the line of H beside a guide), "H⊥CL" (the foot of H on
it), "B°s" (where a driver's stroke is counted from); a direction "∥CL", "⊥BC" or, by a vector, "∠v_C" and "→v_C".
"""

import re
from collections.abc import Collection
from dataclasses import dataclass

from planes.words import Lang, Phrase, Told, decimal, say
from planes.words.names import kind_of, label_of, letter_of, links_of, parted, written
from planes.words.units import Convention, mu_text

PRIME = "′"
_SPELT = ("omega", "epsilon", "phi", "alpha", "beta", "gamma", "delta", "psi", "theta", "rho")
_GREEK = dict(zip(_SPELT, "ωεφαβγδψθρ", strict=True))
_INDEXED = re.compile(r"([^\W\d_]+)(\d+)")
_HELPER = re.compile(r"(?P<point>[^°⊥∥]*)(?P<sign>[°⊥∥])(?P<guide>[^°⊥∥]+)")


@dataclass(frozen=True)
class Naming:
    """How this sheet names things: language, number of the frame, the convention of reactions (``from_on``: R_12 from 1
    on 2, its tangential part R^τ, its arm H_12), the driver, vectors that end at a point of the frame under a slider,
    the convention of μ."""

    lang: Lang = "ru"
    frame: str = "0"
    from_on: bool = False
    driver: str = "1"
    grounded: Collection[str] = ()
    convention: Convention = "mm_per_unit"

    def mu(self, size: float, kind: str) -> str:
        """μ of a kind of plans as it is written: 30 mm/(m/s)."""
        return decimal(mu_text(size, kind, self.lang, self.convention), self.lang)

    def link(self, name: str) -> str:
        """A link's number; the frame's is the scene's."""
        return self.frame if name == "0" else name

    def point(self, name: str) -> str:
        """A point of the scheme: S2 -> S_{2}."""
        return lowered(name)

    def mark(self, label: str, plan: str) -> str:
        """A mark of a plan of rates: s2' -> s_{2}′, n_CB -> n_{CB}, the pole of accelerations π."""
        if label == "p":
            return "π" if plan == "acceleration" else "p"
        primes, label = len(label) - len(label.rstrip("'′")), label.rstrip("'′")
        return lowered(label) + PRIME * primes

    def vector(self, name: str) -> str:
        """A vector or a value: v_CB, a_HL^k, F_21^t, G_2, I_2, P_5, omega_2, M_3, l_AB, omegaq_2 of a unit drive."""
        times, _, whole = name.partition("·")
        if whole:
            return f"{decimal(times, self.lang)}·{self.vector(whole)}"
        base, _, part = name.partition("^")
        letter, _, index = base.partition("_")
        part = "τ" if self.from_on and part == "t" else part
        if letter == "MR":
            return f"M({self.vector(index)})"
        if letter == "arm":
            return f"h_{{{flat(self.vector(index))}}}"
        if letter in ("MZ", "FZ"):
            letter, part = letter[0], say("lever_letter", self.lang)
        letter, analogue = rate_of(letter)
        if letter in ("F", "R") and index:
            letter, index = "R" if self.from_on else letter, self.reaction(index)
        elif letter == "I":
            letter = "Φ"
        elif letter in ("MI", "MP"):
            letter, index = "M", ("Φ" if letter == "MI" else "P") + index
        elif letter in ("N", "T", "PT", "MT", "ω") and index.startswith("F_"):  # of friction, by its reaction
            letter, index = letter[0], letter[1:] + analogue + self.reaction(index[2:])
        elif letter in ("v", "a"):
            index = self.driver if index == "drive" else index.removeprefix("slide_")
            index = analogue + (index[:-1] + self.frame if base in self.grounded else index)
        elif analogue:
            index = analogue + index
        elif letter == "Fb":
            return self.balancing(False)
        return letter + (f"_{{{index.replace('_', ',')}}}" if index else "") + (f"^{{{part}}}" if part else "")

    def arm(self, force: str, arm: str) -> str:
        """An arm of a force by its name in the program: h_G_2_C -> h_{G2}, h_G_2_B^B -> h_{G2}^{B}, H_G_2 -> H_{G2};
        of a reaction R_12 from 1 on 2 H_{12}."""
        about = arm.removeprefix(f"{arm[0]}_{force}").partition("^")[2]
        of, letter = flat(self.vector(force)), arm[0]
        if self.from_on and force.startswith("F_"):
            of, letter = of.removeprefix("R"), "H"
        return f"{letter}_{{{of}}}" + (f"^{{{flat(self.point(about))}}}" if about else "")

    def reaction(self, index: str) -> str:
        """The two links of a reaction in the order of this sheet."""
        on, by = index.split("_", 1) if "_" in index else (index[:1], index[1:])
        if by[-1:] in ("t", "n"):
            by = by[:-1]
        pair = (self.link(by), self.link(on)) if self.from_on else (self.link(on), self.link(by))
        return "".join(pair) if max(map(len, pair)) == 1 else ",".join(pair)

    def balancing(self, turning: bool) -> str:
        """The balancing moment or force."""
        return f"{'M' if turning else 'F'}_{{{say('balance', self.lang)}}}"

    def named(self, name: str, plan: str = "") -> str:
        """A name in running text: a mark of a plan, an arm, a point or a vector; a direction is its vector's."""
        plain = name.strip("|‖°").removesuffix("_given")
        letter, _, index = plain.partition("_")
        if letter in ("h", "H") and index:
            return self.arm(index.rpartition("_")[0] if letter == "h" else index, plain)
        if "'" in plain or plain == "p":
            return self.mark(plain, plan)
        return self.vector(parted(plain)) if index else lowered(plain)


def flat(text: str) -> str:
    """A name without the markup of its indices, to stand in an index itself."""
    return "".join(c for c in text if c not in "_^{}")


def in_plain_text(name: str) -> str:
    """A vector or a value as a terminal has it: omega_2_1 -> ω2,1."""
    return flat(Naming().vector(name))


def rate_of(letter: str) -> tuple[str, str]:
    """The letter as it is written, and the index of an analogue: omegaq -> ω, q."""
    plain = letter.removesuffix("q")
    known = plain in ("v", "a", *_GREEK)
    return (_GREEK.get(plain, plain), letter[len(plain) :]) if known else (letter, "")


def lowered(name: str) -> str:
    """A letter with its number lowered: S2 -> S_{2}."""
    match = _INDEXED.fullmatch(name)
    if match:
        return f"{match[1]}_{{{match[2]}}}"
    head, _, index = name.partition("_")
    return f"{head}_{{{index}}}" if index and head else name


def greek(name: str) -> str:
    """The name of a parameter: phi_1 -> φ_{1}, l_BS2 -> l_{BS2}."""
    letter, _, index = name.partition("_")
    if letter == "angle" and index:
        return f"∠{index.replace('_', ',')}"
    return _GREEK.get(letter, letter) + (f"_{{{index.replace('_', ',')}}}" if index else "")


def indexed(text: str) -> str:
    """Sentences with the indices of names in them set as such: v_H, F21^t, phi_1."""
    name = rf"(?<!\w)([^\W\d_]{{1,2}}\d*|{'|'.join(_GREEK)})([_^])([^\W_]+)(?!\w)"
    return re.sub(name, lambda m: f"{_GREEK.get(m[1], m[1])}{m[2]}{{{m[3]}}}", text)


def lettered_curve(name: str, naming: Naming) -> str:
    """A curve's name with its index lowered, a letter, then _{…}: v_C_x, vq_slide_3, F_21, F_11_10, F_50_arm."""
    head, *index = name.split("_")
    last = index.pop() if index[1:] and index[-1] in ("x", "y", "arm", "moment") else ""
    axis, of = last if last in ("x", "y") else "", "".join(index[1:] if index[0] == "slide" else index)
    if head == "r":
        return f"{axis or 'r'}_{{{of}}}"
    if head == "u":
        return f"u_{{{','.join(index)}}}"
    if head in ("M", "MZ", "Fb", "FbZ"):
        return naming.balancing(head.startswith("M")) + ("^{Ж}" if head.endswith("Z") else "")
    if head == "F":
        letter = {"arm": "h", "moment": "M"}.get(last, "R" if naming.from_on else "F")
        return f"{letter}_{{{naming.reaction('_'.join(index))}{axis}}}"
    letter, analogue = ("a^{k}", "") if head == "coriolis" else rate_of(head)
    return f"{letter}_{{{analogue}{of}{axis}}}"


def letter_of_scale(lettered: str) -> str:
    """The letter with which the μ of a lettered quantity is written: a^{k}_{4} -> a."""
    return letter_of(lettered).partition("^")[0]


def name_in_words(name: str) -> Told:
    """A mark, direction or value as a sentence names it; ``name`` may carry its plan."""
    label = written(label_of(name).rstrip("′"))
    found = _HELPER.fullmatch(label)
    if found is None:
        return label.strip("|‖∠→").removesuffix("_given") or label
    if found["guide"] == "s" and found["point"]:
        return Phrase("start_of_stroke", point=found["point"])
    if found["point"]:
        key = "beside_guide" if found["sign"] == "°" else "foot_on_guide"
        return Phrase(key, point=found["point"], guide=found["guide"])
    return label if found["sign"] == "⊥" else Phrase("guide_named", name=found["guide"])


def line_in_words(along: str, start: str) -> Phrase:
    """A line through a mark: the guide itself where it is one."""
    mark, (_, parallel, guide) = label_of(start), written(along).partition("∥")
    point, sign, other = next((mark.partition(s) for s in "°⊥" if s in mark), ("", "", ""))
    if parallel and sign and written(other) == guide:
        if sign == "°" and point:
            return Phrase("line_beside", point=point, name=guide)
        return Phrase("line_guide", name=guide)
    return Phrase("line_through", along=written(along), start=name_in_words(start))


def plan_phrase(plan: str) -> Phrase:
    """The name of a plan in words."""
    if plan == "force":
        return Phrase("plan_forces")
    links = links_of(plan)
    if kind_of(plan) == "force" and len(links) == 1:
        return Phrase("plan_force_alone", links=links[0])
    return Phrase(f"plan_{kind_of(plan)}", links=", ".join(links))
