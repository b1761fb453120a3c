"""Modules of the pages packed into one script: each once, after its imports, in the single scope of the page.

Names are kept as written. Two modules of a page that declare the same name are refused, and so are circular imports and
names that nobody exports.
"""

import re
from functools import cache

from render.page.web_page import page_files_text

REGEX_FLAGS = re.M | re.S
_IMPORT_PATTERN = re.compile(r'^import \{([^}]*)\} from "\./(\w+)\.js";\n', re.M)
_DECLARATION_PATTERN = re.compile(
    r"^(export |)(?:(?:async )?(?:function|class) ([\w$]+)|(?:const|let) \[?(.*?;)( //[^\n]*)?$)", REGEX_FLAGS
)
_BRACKETED_PATTERN = re.compile(r'"[^"]*"|`[^`]*`|\([^()]*\)|\{[^{}]*\}|(?<=[=,] )\[[^\[\]]*\]')
_NAME_PATTERN = re.compile(r"(?:^|, )([\w$]+)(?=[ ,(;\]])")
_TYPE_COMMENT_PATTERN = r"/\*\*(?:(?!\*/).)*\*/"  # types, which a browser does not need
_COMMENT_PATTERN = re.compile(
    rf"^ *//[^\n]*\n|^ *{_TYPE_COMMENT_PATTERN}\n| +// [^\n]*$|{_TYPE_COMMENT_PATTERN} |^ +|^export ", REGEX_FLAGS
)


def pack_modules(*entries: str) -> str:
    """One script of modules and all their imports, without indentation and comments."""
    order: dict[str, str] = {}
    for entry in entries:
        _add_module(entry, (), order)
    owners: dict[str, str] = {}
    for module in order:
        for name in _declared_names(module):
            if owners.setdefault(name, module) != module:
                raise ValueError(f"{owners[name]}.js and {module}.js both call something {name}: give one another name")
    return "".join(order.values())


def _add_module(module: str, way: tuple[str, ...], order: dict[str, str]) -> None:
    """Add a module after its imports; ``way`` is the chain of importers."""
    if module in way:
        raise ValueError(f"modules go round: {' → '.join((*way, module))}; move what both need to a third")
    if module in order:
        return
    for named, other in _IMPORT_PATTERN.findall(_module_text(module)):
        _add_module(other, (*way, module), order)
        for name in filter(None, re.split(r"[\s,]+", named)):
            if not _declared_names(other).get(name):
                raise ValueError(f"{module}.js imports {name} from {other}.js, which exports no {name}")
    order[module] = _COMMENT_PATTERN.sub("", _IMPORT_PATTERN.sub("", _module_text(module)))


@cache
def _module_text(module: str) -> str:
    return page_files_text(f"{module}.js")


@cache
def _declared_names(module: str) -> dict[str, str]:
    """The names a module declares, and whether it exports them."""
    exports = {}
    for export, named, declared, _ in _DECLARATION_PATTERN.findall(_module_text(module)):
        shorter = _BRACKETED_PATTERN.sub("", declared)
        while shorter != declared:
            declared = shorter
            shorter = _BRACKETED_PATTERN.sub("", shorter)
        for name in _NAME_PATTERN.findall(named + re.split(r"[({\[]", declared)[0] + " "):
            exports[name] = export
    return exports
