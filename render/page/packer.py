"""Modules of the pages packed into one script: each once, after its imports, in the single scope of the page.

Names are kept as written. Two modules of a page that declare the same name are refused, and so are circular imports and
names that nobody exports.
"""

import re
from functools import cache

from render.page.web_page import part

RE = re.M | re.S
_IMPORT = re.compile(r'^import \{([^}]*)\} from "\./(\w+)\.js";\n', re.M)
_DECLARED = re.compile(
    r"^(export |)(?:(?:async )?(?:function|class) ([\w$]+)|(?:const|let) \[?(.*?;)( //[^\n]*)?$)", RE
)
_INNER = re.compile(r'"[^"]*"|`[^`]*`|\([^()]*\)|\{[^{}]*\}|(?<=[=,] )\[[^\[\]]*\]')
_NAME = re.compile(r"(?:^|, )([\w$]+)(?=[ ,(;\]])")
_TOLD = r"/\*\*(?:(?!\*/).)*\*/"  # types, which a browser does not need
_REMARK = re.compile(rf"^ *//[^\n]*\n|^ *{_TOLD}\n| +// [^\n]*$|{_TOLD} |^ +|^export ", RE)


def packed(*entries: str) -> str:
    """One script of modules and all their imports, without indentation and comments."""
    order: dict[str, str] = {}
    for entry in entries:
        _add(entry, (), order)
    owners: dict[str, str] = {}
    for module in order:
        for name in _names(module):
            if owners.setdefault(name, module) != module:
                raise ValueError(f"{owners[name]}.js and {module}.js both call something {name}: give one another name")
    return "".join(order.values())


def _add(module: str, way: tuple[str, ...], order: dict[str, str]) -> None:
    """Add a module after its imports; ``way`` is the chain of importers."""
    if module in way:
        raise ValueError(f"modules go round: {' → '.join((*way, module))}; move what both need to a third")
    if module in order:
        return
    for named, other in _IMPORT.findall(_text(module)):
        _add(other, (*way, module), order)
        for name in filter(None, re.split(r"[\s,]+", named)):
            if not _names(other).get(name):
                raise ValueError(f"{module}.js imports {name} from {other}.js, which exports no {name}")
    order[module] = _REMARK.sub("", _IMPORT.sub("", _text(module)))


@cache
def _text(module: str) -> str:
    return part(f"{module}.js")


@cache
def _names(module: str) -> dict[str, str]:
    """The names a module declares, and whether it exports them."""
    exports = {}
    for export, named, declared, _ in _DECLARED.findall(_text(module)):
        shorter = _INNER.sub("", declared)
        while shorter != declared:
            declared, shorter = shorter, _INNER.sub("", shorter)
        for name in _NAME.findall(named + re.split(r"[({\[]", declared)[0] + " "):
            exports[name] = export
    return exports
