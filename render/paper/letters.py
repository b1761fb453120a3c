"""Names and numbers as written in a language: ⟨a_CB^t⟩ as pieces of plain, lowered and raised letters, units, μ."""

import re
from collections.abc import Iterable, Iterator, Mapping
from html import escape

from planes import words
from planes.words import Lang, available_languages, say
from planes.words.frozen import frozen
from planes.words.naming import Naming
from planes.words.records import Json
from planes.words.units import mu_unit_text, number_text

BRACKETED_NAME_PATTERN = re.compile(r"⟨([^⟩]*)⟩")
_INDEX_PATTERN = re.compile(r"([_^])\{([^{}]*)\}")
COMMAND_PATTERN = r"(?<![\w-])--?[a-z]+(?: [^\s()]*[.=,][^\s();]*\w)?"  # an option with its argument
_QUANTITY_PATTERN = r"(?:[A-Za-z]{1,2}|omega|epsilon)_[A-Z0-9][A-Za-z0-9]*(?:\^[a-z])?"
_AFTER_MARK_A_PATTERN = r"(?=[,:;.)=–]| \(|$)"  # "a" is a mark only before one of these


@frozen
class Piece:
    """A run of text: ``shift`` "sub", "sup" or "" on the line; ``name`` where it is a letter of a quantity."""

    text: str
    shift: str = ""
    name: bool = False


def lettered_pieces(text: str, naming: Naming, plan: str = "") -> Iterator[Piece]:
    """The runs of a sentence; _{…} and ^{…} in it are indices too."""
    for k, part in enumerate(BRACKETED_NAME_PATTERN.split(text)):
        yield from split_indices(naming.lettered_name(part, plan) if k % 2 else part, bool(k % 2))


def tagged_sentence(text: str, naming: Naming, plan: str = "") -> str:
    """The sentence in tags, as used by HTML and reportlab: names in italics, indices lowered and raised."""
    lettered = ""
    for piece in lettered_pieces(text, naming, plan):
        inner = escape(piece.text)
        inner = f"<{piece.shift}>{inner}</{piece.shift}>" if piece.shift else inner
        lettered += f"<i>{inner}</i>" if piece.name else inner
    return lettered


def name_search_pattern(names: Iterable[str]) -> str:
    """The search pattern for a sentence, for Python and a page's script: a command (group 1), or one of these names or
    of any quantity (group 2)."""
    known = sorted(filter(None, set(names)), key=lambda n: (-len(n), n))
    escaped = [re.escape(n) + (_AFTER_MARK_A_PATTERN if n in ("a", "A") else "") for n in known]
    return rf"({COMMAND_PATTERN})|(?<![\w.'′/\\-])({'|'.join([*escaped, _QUANTITY_PATTERN])})(?![\w'′^]|[.-]\w)"


def sentence_html(
    text: str, names: Iterable[str], naming: Naming, plan: str = "", links: Mapping[str, str] | None = None
) -> str:
    """The HTML of a plain sentence: its names lettered, its commands unbroken, the names of files (of ``links``) linked
    to their addresses."""
    lettered = ""
    end = 0
    links = links or {}
    for match in re.finditer(name_search_pattern([*names, *links]), text):
        name = match[0]
        command = match[1]
        lettered += escape(text[end : match.start()])
        if command:
            lettered += f'<span class="command">{escape(name)}</span>'
        elif name in links:
            lettered += f'<a href="{escape(links[name])}">{escape(name)}</a>' if links[name] else escape(name)
        else:
            lettered += tagged_sentence(f"⟨{name}⟩", naming, plan)
        end = match.end()
    return lettered + escape(text[end:])


def names_for_script(names: Iterable[str], lettering: Json) -> dict[str, dict[str, list[tuple[str, str]]]]:
    """Names for a page's script, in every language: pieces of text, each lowered ("sub"), raised or neither. After the
    first language only the differences."""
    namings = [Naming(lang, **lettering) for lang in available_languages()]
    names = dict.fromkeys(names)
    pole = {"acceleration:p": [("π", "")]}
    first, *rest = [
        pole | {name: [(p.text, p.shift) for p in split_indices(n.lettered_name(name), True)] for name in names}
        for n in namings
    ]
    own = [first, *({name: z for name, z in other.items() if z != first[name]} for other in rest)]
    return {n.lang: one for n, one in zip(namings, own, strict=True)}


def split_indices(text: str, name: bool = False) -> Iterator[Piece]:
    """The letters on the line and the indices; an empty index is a piece too."""
    end = 0
    for match in _INDEX_PATTERN.finditer(text):
        if match.start() > end:
            yield Piece(text[end : match.start()], "", name)
        yield Piece(match[2], "sub" if match[1] == "_" else "sup", name)
        end = match.end()
    if end < len(text):
        yield Piece(text[end:], "", name)


def with_minus_and_decimal_sign(text: str, lang: Lang) -> str:
    """A printed number with a true minus and the decimal sign of the language."""
    return words.with_decimal_sign(text.replace("-", "−"), lang)


def unit_text(key: str, lang: Lang) -> str:
    """A unit as written beside a number; a plain number ("1") has none."""
    return "" if key in ("", "1") else say(key, lang)


def name_with_unit(name: str, key: str, lang: Lang) -> str:
    """A quantity and its unit, as written at the end of an axis."""
    return ", ".join(filter(None, (name, unit_text(key, lang))))


def value_with_unit(value: str, key: str, lang: Lang) -> str:
    """A printed number with its unit; a degree sign follows it directly."""
    return " ".join(filter(None, (value, unit_text(key, lang)))).replace(" °", "°")


def mu_with_unit(mu: float, key: str, naming: Naming) -> str:
    """μ with its unit: 20 mm/(m/s), or inverted; for plain numbers in mm."""
    per = unit_text(key, naming.lang)
    lang = naming.lang
    inverse = naming.convention == "unit_per_mm"
    plain = f"1/{say('mm', lang)}" if inverse else say("mm", lang)
    return f"{number_text(1 / mu if inverse else mu, lang)} {mu_unit_text(per, lang, inverse) if per else plain}"
