"""Writes PACKAGE/_gw.pyi: the types and docstrings of the compiled module, for mypy and editors.

Reads the signatures that pybind11 puts first into each docstring. e.g.:
    python3 python/make_stubs.py build/release/python/gw
"""
import importlib.util
import pathlib
import re
import sys
import textwrap

HEADER = '''"""{doc}"""
# Made by python/make_stubs.py.
from pathlib import Path
from typing import Any, Dict, Iterator, List, Optional, Sequence, Set, Tuple, Union, overload
import os
import numpy
import numpy.typing

'''
ENUM_MEMBERS = '''    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    def __eq__(self, other: object) -> bool: ...
    def __hash__(self) -> int: ...
'''


def plain(signature):
    """A signature as Python writes it."""
    signature = signature.replace("gw._gw.", "").replace("_gw.", "")
    signature = re.sub(r"\bgw::(?:\w+::)*", "", signature)  # a class that was not known yet
    signature = re.sub(r"\blist\b(?!\[)", "List[Any]",
                       re.sub(r"\bdict\b(?!\[)", "Dict[Any, Any]", signature))
    signature = re.sub(r"numpy\.ndarray\[numpy\.(\w+)\]", r"numpy.typing.NDArray[numpy.\1]",
                       signature)
    signature = re.sub(r"\bnumpy\.ndarray\b(?!\[)", "numpy.typing.NDArray[Any]", signature)
    signature = re.sub(r"= <[^>]*>", "= ...", signature)
    signature = re.sub(r"= [A-Z]\w*\([^()]*(\([^()]*\)[^()]*)*\)", "= ...", signature)
    signature = signature.replace("os.PathLike", "Union[str, os.PathLike[str]]")
    signature = re.sub(r"(\w+)\[\d+\]", r"\1", signature)  # List[ClipPlane[6]]
    signature = re.sub(r": (\w+) = None", r": Optional[\1] = None", signature)
    signature = signature.replace("**kwargs", "**kwargs: Any")
    return re.sub(r"\bobject\b", "Any", signature)


def accepting(signature):
    """Arguments take whatever the casters do: any sequence for a vector, a name for an
    enumeration."""
    arguments, arrow, result = signature.partition(") -> ")
    arguments = re.sub(r"Tuple\[((?:float|int)(?:, (?:float|int))+)\]", lambda m:
                       f"Sequence[{m[1].split(',')[0]}]", arguments)
    arguments = re.sub(r"numpy\.typing\.NDArray\[[\w.]+\]", "numpy.typing.ArrayLike", arguments)
    names = "|".join(sorted(set(enums) | {"Profile"}, key=len, reverse=True))
    arguments = re.sub(rf"(: |\[)({names})\b", r"\1Union[\2, str]", arguments)
    return arguments + arrow + result


def docstring(text, indent):
    text = text.strip()
    if not text:
        return indent + "...\n"
    return f'{indent}"""' + text.replace("\\", "\\\\") + '"""\n'


def function(name, value, indent="", static=False):
    """The stub of a function or method, from its docstring."""
    first, _, rest = (value.__doc__ or "").partition("\n")
    if not first.startswith(name + "("):
        raise SystemExit(f"make_stubs: {name} has no signature")
    if first == f"{name}(*args, **kwargs)":
        blocks = re.findall(rf"^\d+\. ({re.escape(name)}\(.*)\n((?:(?!^\d+\. ).*\n?)*)", rest, re.M)
        return "".join(f"{indent}@overload\n" + one(name, s, d, indent, static) for s, d in blocks)
    return one(name, first, rest, indent, static)


def one(name, signature, doc, indent, static):
    text = accepting(re.sub(r"\(self: [\w.]+", "(self", plain(signature)))
    decorator = f"{indent}@staticmethod\n" if static else ""
    return f"{decorator}{indent}def {text}:\n" + docstring(doc, indent + "    ") + (
        f"{indent}    ...\n" if doc.strip() else "")


def property_type(value, kind):
    text = (getattr(value, kind).__doc__ or "").split("\n")[0]
    return plain(text.partition(" -> ")[2]) or "Any"


def class_stub(cls):
    lines = [
        f"class {cls.__name__}({'ValueError' if issubclass(cls, Exception) else ''}):\n".replace(
            "()", "")]
    lines.append(docstring((cls.__doc__ or "").split("\n\nMembers:")[0], "    "))
    members = getattr(cls, "__members__", None)
    if members is not None:
        lines += [f"    {name}: {cls.__name__}\n" for name in members]
        lines.append("    def __init__(self, value: Union[int, str]) -> None: ...\n" + ENUM_MEMBERS)
        return "".join(lines)
    fields = cls.__dict__.get("_fields")
    for name, value in cls.__dict__.items():
        if isinstance(value, property):
            lines.append(f"    @property\n    def {name}(self) -> {property_type(value, 'fget')}:\n"
                         + docstring(value.__doc__ or "", "        ") + "        ...\n")
            if value.fset is not None:
                kind = property_type(value, "fget")
                lines.append(
                    f"    @{name}.setter\n    def {name}(self, value: {kind}) -> None: ...\n")
        elif name == "__init__" and fields is not None and not issubclass(cls, Exception):
            arguments = ", ".join(
                accepting(f"{f}: {property_type(cls.__dict__[f], 'fget')} = ...) -> ")[
                    : -len(") -> ")] for f in fields)
            overloads = "1. " in (value.__doc__ or "")
            extra = ""
            if overloads and cls.__name__ == "Profile":
                lines.append("    @overload\n    def __init__(self, text: str) -> None: ...\n")
                extra = "    @overload\n"
            lines.append(f"{extra}    def __init__(self, *, {arguments}) -> None: ...\n")
        elif isinstance(value, staticmethod):
            lines.append(function(name, value.__func__, "    ", static=True))
        elif name == "__init__" and not (value.__doc__ or "").startswith("__init__("):
            continue
        elif name in ("__init__", "__len__", "__iter__", "__next__") or (callable(value)
            and not name.startswith("_")):
            lines.append(function(name, value, "    "))
    if fields is not None:
        lines.append("    def __eq__(self, other: object) -> bool: ...\n")
    return "".join(lines)


def stubs(module):
    text = HEADER.format(doc=module.__doc__)
    for name, value in sorted(vars(module).items(),
                              key=lambda item: (not isinstance(item[1], type), item[0])):
        if name.startswith("_"):
            continue
        text += class_stub(value) if isinstance(value, type) else function(name, value)
        text += "\n"
    return text


package = pathlib.Path(sys.argv[1])
found = next(package.glob("_gw*.so"))
spec = importlib.util.spec_from_file_location("_gw", found)
module = importlib.util.module_from_spec(spec)
spec.loader.exec_module(module)
enums = [name for name, value in vars(module).items() if hasattr(value, "__members__")]
(package / "_gw.pyi").write_text(stubs(module), encoding="utf-8")
