"""A record whose values never change: the result of ``dataclass(frozen=True)`` in a quarter of the time.

Only the initialiser is generated per class; comparison, hash and repr are shared by all classes. There are 150 of them
between the command line and its first answer, so the user would wait for them.
"""

import copyreg
from collections.abc import Callable
from dataclasses import MISSING, FrozenInstanceError, dataclass, field, fields, replace
from operator import attrgetter
from types import MappingProxyType
from typing import Any, NoReturn, TypeVar, dataclass_transform

__all__ = ["field", "frozen", "refuse_assignment", "replace"]

T = TypeVar("T")


def _read_only_mapping(values: Any) -> Any:
    return MappingProxyType(values)


copyreg.pickle(
    MappingProxyType, lambda view: (_read_only_mapping, (dict(view),))
)  # records go to other processes, and are copied


@dataclass_transform(frozen_default=True, field_specifiers=(field,))
def frozen(cls: type[T]) -> type[T]:
    """Make the class a record of its fields; methods it defines itself are kept."""
    dataclass(init=False, repr=False, eq=False)(cls)
    values = attrgetter("__class__", *(f.name for f in fields(cls) if f.compare))  # type: ignore[arg-type]

    def same(self: T, other: object) -> bool:
        return bool(values(self) == values(other)) if other.__class__ is self.__class__ else NotImplemented

    ours = {"__init__": _make_initialiser(cls), "__eq__": same, "__hash__": lambda self: hash(values(self))}
    ours |= {"__repr__": _record_repr, "__setattr__": refuse_assignment, "__delattr__": refuse_assignment}
    own = {name: vars(cls)[name] for name in ours if vars(cls).get(name) is not None}
    for name, method in (ours | own).items():
        setattr(cls, name, method)
    return cls


def _make_initialiser(cls: type) -> Callable[..., None]:
    heads = []
    lines = []
    known: dict[str, Any] = {"put": object.__setattr__}
    for one in sorted(fields(cls), key=lambda f: bool(f.kw_only)):
        if one.kw_only and "*" not in heads:
            heads.append("*")
        name = one.name
        value = one.name
        if one.default_factory is not MISSING:
            known[f"_{name}"] = one.default_factory
            value = f"_{name}() if {name} is ... else {name}"
            heads.append(f"{name}=...")
        elif one.default is not MISSING:
            known[f"_{name}"] = one.default
            heads.append(f"{name}=_{name}")
        else:
            heads.append(name)
        lines.append(f" put(self, {name!r}, {value})")
    if hasattr(cls, "__post_init__"):
        lines.append(" self.__post_init__()")
    exec(f"def __init__(self, {', '.join(heads)}):\n" + "\n".join(lines or [" pass"]), known)
    made: Callable[..., None] = known["__init__"]
    made.__qualname__ = f"{cls.__qualname__}.__init__"
    return made


def _record_repr(self: Any) -> str:
    values = (f"{f.name}={getattr(self, f.name)!r}" for f in fields(self) if f.repr)
    return f"{type(self).__qualname__}({', '.join(values)})"


def refuse_assignment(self: object, name: str, *value: object) -> NoReturn:
    """The ``__setattr__`` of records."""
    raise FrozenInstanceError(f"cannot change field {name!r}")
