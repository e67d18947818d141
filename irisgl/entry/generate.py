#!/usr/bin/env python3
"""Makes the doors of IRIS GL from its table: generate.py functions.txt FOLDER

FOLDER/include/gl/functions.h has the prototypes for programs, FOLDER/calls.h declares the calls
that carry the functions out, FOLDER/entry_points.cpp defines the functions, FOLDER/exports.map
names them, FOLDER/functions.inc has a line GW_IRISGL_FUNCTION(name, kind) for each.
"""
import pathlib
import re
import sys

KINDS = ("list", "now", "free", "hand", "left")
LINE = re.compile(r'(\w+)\s+(?:"([^"]*)"\s+)?(.*?)\s*\b(\w+\*?)\((.*)\)$')
COORDINATES = {"": "Coord", "i": "Icoord", "s": "Scoord"}


class Parameter:
    """`text` is of C; `kind` is value, array, matrix, string, out, words, raw or rest."""

    def __init__(self, text):
        self.count = None
        if text == "...":
            self.kind, self.name, self.type = "rest", "", ""
            return
        marked = re.match(r"(out|raw|words)\s+(.*)", text)
        mark, text = marked.groups() if marked else ("", text)
        if mark == "words":
            self.kind, self.name, self.type = "words", text, "unsigned long"
            return
        if match := re.match(r"(.*?)\(\*(\w+)\)\[4\]$", text):
            self.kind, self.name, self.type = "rows", match[2], match[1].strip()
            return
        match = re.match(r"(.*?[\s*])(\w+)((?:\[[^\]]*\])*)$", text)
        self.type, self.name = match[1].strip(), match[2]
        sizes = re.findall(r"\[([^\]]*)\]", match[3])
        if mark == "out":
            self.kind = "out"
        elif self.type == "Matrix":
            self.kind, self.count, self.inner, self.type = "array", "16", "[4]", "float"
            self.outer = "4"
        elif sizes:
            self.kind, self.count = "array", "*".join(f"({s})" for s in sizes)
            if not self.fixed():
                self.count = f"product({', '.join(sizes)})"
            self.outer = sizes[0]
            self.inner = "".join(f"[{s}]" for s in sizes[1:])
        elif self.type == "String":
            self.kind = "string"
        else:
            self.kind = "value"

    def fixed(self):
        return re.fullmatch(r"[\d()* ]+", self.count) is not None

    def c(self, word=None):
        t = word or self.type
        if self.kind == "rest":
            return "..."
        if self.kind == "array":
            return f"{t} {self.name}[{self.outer if self.outer.isdigit() else ''}]{self.inner}"
        if self.kind == "rows":
            return f"{t} {self.name}[4][4]"
        if self.kind in ("out", "words"):
            return f"{t}* {self.name}"
        return f"{t} {self.name}".replace("String ", "const char* ")

    def cpp(self, word=None):
        t = word or self.type
        if self.kind == "array":
            return f"const {t}* {self.name}"
        if self.kind == "rows":
            return f"{t}* {self.name}"
        if self.kind == "string":
            return f"const char* {self.name}"
        return self.c(word)

    def call_type(self):
        if self.kind == "array":
            return f"Values {self.name}"
        if self.kind == "string":
            return f"const std::string& {self.name}"
        if self.kind == "rows":
            return f"float* {self.name}"
        if self.kind == "words":
            return f"Words {self.name}"
        if self.kind == "out":
            return f"{self.type}* {self.name}"
        return f"{self.type} {self.name}"

    def kept(self):
        """As a lambda keeps it."""
        if self.kind == "array":
            if self.fixed():
                return f"{self.name} = OwnValues<{self.count}>({self.name})"
            return f"{self.name} = keep({self.name}, {self.count})"
        if self.kind == "string":
            return f"{self.name} = std::string({self.name} ? {self.name} : \"\")"
        if self.kind == "words":
            return f"{self.name} = Words({self.name})"
        return self.name

    def is_long(self):
        return self.kind in ("array", "out", "words") and self.type in ("long", "Icoord",
                                                                         "unsigned long")


class Entry:
    def __init__(self, kind, reason, result, name, parameters, call, arguments):
        self.kind, self.reason, self.result, self.name = kind, reason, result, name
        self.parameters, self.call, self.arguments = parameters, call, arguments
        if call is None:
            self.call = name
            self.arguments = ", ".join(p.name for p in parameters)
        self.own = call is None

    def has_int(self):
        return any(p.is_long() for p in self.parameters)


def entries(path):
    for number, line in enumerate(pathlib.Path(path).read_text(encoding="utf-8").split("\n"), 1):
        if not line.strip() or line.startswith("#"):
            continue
        line, _, call = line.partition(" = ")
        match = LINE.match(line.strip())
        if not match or match[1] not in KINDS:
            sys.exit(f"{path}:{number}: '{line}'; expected kind, prototype and perhaps = call")
        target = re.match(r"(\w+)\((.*)\)$", call.strip()) if call else None
        kind, reason, result, name, words = match.groups()
        texts = [t.strip() for t in re.split(r",(?![^\[]*\])", words) if t.strip()]
        for suffix, coordinate in COORDINATES.items() if name.endswith("*") else {"": "Coord"}.items():
            parameters = [Parameter(re.sub(r"\bCoord\b", coordinate, t)) for t in texts]
            yield Entry(kind, reason, result, name.rstrip("*") + suffix, parameters,
                        target and target[1], target and target[2])


def prototype(e, name=None, word=None):
    words = ", ".join(p.c(word if p.is_long() else None) for p in e.parameters) or "void"
    return f"extern {e.result} {name or e.name}({words});"


def generic(e):
    """int or long: programs of 64 bits have both."""
    names = ", ".join(f"p{i}" for i in range(len(e.parameters)))
    at, parameter = next((i, p) for i, p in enumerate(e.parameters) if p.is_long())
    inner = "".join(re.findall(r"\[\w*\]", getattr(parameter, "inner", "")))
    def pointer(t):
        return f"{t} (*){inner}" if inner else f"{t}*"
    return (f"#define {e.name}({names}) _Generic((p{at}), {pointer('int')}: {e.name}_int, "
            f"{pointer('unsigned int')}: {e.name}_int, default: {e.name})({names})")


def header(rows):
    ints = [e for e in rows if e.has_int()]
    return ["/* Made from irisgl/entry/functions.txt. */", *(prototype(e) for e in rows),
            *(prototype(e, e.name + "_int", "int") for e in ints),
            "#ifndef __cplusplus", *(generic(e) for e in ints), "#endif"]


def body(e, is_int):
    keep = ", ".join(p.kept() for p in e.parameters if p.kind != "out")
    if e.kind == "left":
        returned = "" if e.result == "void" else "return "
        return f"    {returned}left_out(\"{e.name}\", \"{e.reason}\");"
    before, after, arguments = [], [], e.arguments
    before.append(f"    const CallScope scope(\"{e.name}\", __builtin_return_address(0));")
    for p in e.parameters:
        if p.kind == "out":
            t = "int" if is_int and p.is_long() else p.type
            before += [f"    {t} {p.name}_unused = {{}};",
                       f"    if ({p.name} == nullptr) {p.name} = &{p.name}_unused;"]
    if is_int:
        for p in e.parameters:
            if p.kind == "out" and p.is_long():
                before.append(f"    long {p.name}_long = 0;")
                after.append(f"    *{p.name} = int({p.name}_long);")
                arguments = re.sub(rf"\b{p.name}\b", f"&{p.name}_long", arguments)
    run = {"list": "run_kept", "now": "run_now", "free": "run_free"}[e.kind]
    captured = keep
    if e.kind != "list":
        extra = [p.kept() for p in e.parameters if p.kind in ("array", "string", "words")]
        captured = ", ".join(["&", *extra])
    call = f"{run}(\"{e.name}\", [{captured}] {{ return calls::{e.call}({arguments}); }});"
    if e.result == "void":
        return "\n".join([*before, "    " + call, *after])
    return "\n".join([*before, f"    const auto result = {call}", *after,
                      "    return result;"])


def definition(e, is_int=False):
    words = ", ".join(p.cpp("int" if is_int and p.is_long() else None) for p in e.parameters)
    if e.kind == "left":
        words = ", ".join("..." if p.kind == "rest" else p.cpp().rsplit(" ", 1)[0]
                          for p in e.parameters)
    name = e.name + ("_int" if is_int else "")
    return f"{e.result} {name}({words}) {{\n{body(e, is_int)}\n}}"


def declarations(rows):
    seen = set()
    for e in rows:
        if e.own and e.kind in ("list", "now", "free") and e.name not in seen:
            seen.add(e.name)
            yield f"{e.result} {e.call}({', '.join(p.call_type() for p in e.parameters)});"


def main():
    table, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    rows = list(entries(table))
    names = [e.name for e in rows]
    for name in sorted({n for n in names if names.count(n) > 1}):
        sys.exit(f"{table}: {name} stands twice")
    (folder / "include/gl").mkdir(parents=True, exist_ok=True)
    made = "// Made from irisgl/entry/functions.txt by irisgl/entry/generate.py."
    defined = [e for e in rows if e.kind != "hand"]
    files = {
        "include/gl/functions.h": header(rows),
        "calls.h": [made, "#pragma once", '#include "irisgl/calls/values.h"',
                    "namespace gw::irisgl::calls {", *declarations(rows),
                    "}  // namespace gw::irisgl::calls"],
        "entry_points.cpp": [made, '#include "irisgl/calls/run.h"', '#include "irisgl/calls/shared.h"',
                             '#include "generated/irisgl/calls.h"',
                             "using namespace gw::irisgl;",
                             "#pragma GCC visibility push(default)", 'extern "C" {',
                             *(definition(e) for e in defined),
                             *(definition(e, True) for e in defined if e.has_int()),
                             "}", "#pragma GCC visibility pop"],
        "functions.inc": [made, *(f"GW_IRISGL_FUNCTION({e.name}, {e.kind})" for e in rows)],
    }
    exported = [n for e in rows for n in (e.name, e.name + "_int") if n == e.name or e.has_int()]
    files["exports.map"] = ["{", f"    global: {'; '.join(exported)};", "    local: *;", "};"]
    for name, lines in files.items():
        (folder / name).write_text("\n".join(lines) + "\n", encoding="utf-8")


main()
