# SPDX-License-Identifier: Apache-2.0
"""Stages written in Python: a class with typed parameters, known to pipelines by its name."""

from __future__ import annotations

import inspect
import os
import typing
import uuid
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple, Type, TypeVar

from . import _native
from ._errors import UsageError
from ._stage_calls import CALLS

_Class = TypeVar("_Class", bound=Type[Any])
_TYPES = {bool: "bool", int: "int", float: "float", str: "str", typing.List[float]: "list[float]",
          typing.get_type_hints(type("T", (), {"__annotations__": {"t": "list[float]"}}))["t"]:
          "list[float]"}

#: What decides of the results of stages that no file holds: bench() reuses none of another process.
salts: Dict[Tuple[str, str], str] = {}


class Parameter:
    """The declaration of a parameter; see param()."""

    def __init__(self, default: Any, text: str, unit: str, range: Optional[Tuple[float, float]],
                 odd: bool, choices: Sequence[str], elements: Sequence[int]) -> None:
        self.default, self.text, self.unit, self.range = default, text, unit, range
        self.odd, self.choices, self.elements = odd, tuple(choices), tuple(elements)


def param(default: Any, text: str = "", *, unit: str = "",
          range: Optional[Tuple[float, float]] = None, odd: bool = False,
          choices: Sequence[str] = (), elements: Sequence[int] = ()) -> Any:
    """A parameter of a stage class, with its default and one sentence for its users.

    range: smallest and largest value, both included. odd: whether a whole number must be odd.
    choices: the texts there are. elements: how many values a list may have.
    """
    return Parameter(default, text, unit, range, odd, choices, elements)


def _declared(cls: Type[Any]) -> List[Tuple[str, Any, Parameter]]:
    """Names, types and declarations of the annotated attributes."""
    found = []
    for name, kind in typing.get_type_hints(cls).items():
        if name.startswith("_"):
            continue
        if kind not in _TYPES:
            raise TypeError(f"{cls.__name__}.{name}: a parameter is of type "
                            "bool, int, float, str or list[float]")
        if not hasattr(cls, name):
            raise TypeError(f"{cls.__name__}.{name}: a parameter needs a default, for example "
                            f"{name}: {_TYPES[kind]} = xgm.param(...)")
        value = getattr(cls, name)
        parameter = value if isinstance(value, Parameter) else param(value)
        found.append((name, kind, parameter))
    return found


def _default(cls: Type[Any], name: str, kind: Any, parameter: Parameter) -> Any:
    value = parameter.default
    if _TYPES[kind] == "list[float]":
        if not isinstance(value, (list, tuple)):
            raise TypeError(f"{cls.__name__}.{name}: the default {value!r} is no list")
        return [float(element) for element in value]
    if kind is float and type(value) is int:
        value = float(value)
    if type(value) is not kind:
        raise TypeError(f"{cls.__name__}.{name}: the default {value!r} is not of type "
                        f"{_TYPES[kind]}")
    if parameter.choices and value not in parameter.choices:
        raise TypeError(f"{cls.__name__}.{name}: the default {value!r} is none of the choices")
    return value


def _source_file(cls: Type[Any]) -> str:
    try:
        file = inspect.getsourcefile(cls) or ""
    except TypeError:  # a class of a notebook or of the prompt
        return ""
    return os.path.abspath(file) if os.path.isfile(file) else ""


def stage(kind: str, name: str, *, summary: str = "",
          publication: str = "") -> Callable[[_Class], _Class]:
    """Makes a class a stage that pipelines can name: a filter, cost, refinement or matcher.

    Its annotated attributes are the parameters, and its run() is called; docs/python.md says with
    what, for each kind. A class that is decorated again under a name replaces the one before for
    pipelines that are loaded from then on; names of the library's own stages are refused.
    """

    def register(cls: _Class) -> _Class:
        if kind in CALLS and not callable(getattr(cls, "run", None)):
            raise TypeError(f"{cls.__name__}: a {kind} needs a method run()")
        parameters = _declared(cls)
        native = [
            _native.Parameter(key, parameter.text, parameter.unit,
                              _default(cls, key, hint, parameter), parameter.range, parameter.odd,
                              list(parameter.choices), list(parameter.elements))
            for key, hint, parameter in parameters
        ]

        def make(**values: Any) -> Callable[..., Any]:
            instance = cls()
            for key, value in values.items():
                setattr(instance, key, value)
            if hasattr(instance, "__post_init__"):
                instance.__post_init__()
            return CALLS[kind](instance)

        text = summary or (inspect.getdoc(cls) or "").split("\n\n")[0].replace("\n", " ")
        if (kind, name) in salts:
            _native.remove_stage(kind, name)
        file = _source_file(cls)
        _native.add_stage(kind, name, text, publication, file, native, make)
        salts[kind, name] = "" if file else uuid.uuid4().hex
        return cls

    if not name.isidentifier():
        raise UsageError(f"'{name}' is no name of a stage; use letters, digits and _")
    return register
