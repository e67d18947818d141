#!/usr/bin/env python3
"""Makes C++ from the table of OpenGL's entry points: generate.py functions.txt linked.txt FOLDER

FOLDER/functions.h numbers them, FOLDER/function_names.h names them, FOLDER/entry_points.cpp defines
them and the table behind gl/entry/entry_points.h. FOLDER/linked.cpp defines those that are not
offered. For tests, FOLDER/names.inc has a line GW_GL_FUNCTION(Begin) for each function of the
table, FOLDER/linked.inc a line GW_GL_LINKED(UseProgram) for each that is not offered.
"""
import re
import sys

KINDS = {
    "vertex": "Vertex",
    "state": "State",
    "draw": "Draw",
    "expand": "Expand",
    "client": "Client",
    "now": "Now",
}
LINE = re.compile(r"(\w+)\s+(.*?)\s*\b(\w+)\((.*?)\)(?:\s*=\s*(\w+)\((.*)\))?$")
SINCE = re.compile(r"since\s+(\d)\.(\d)(?:\s+(\w+))?$")
ALIAS = re.compile(r"alias\s+(\w+)\s+(\w+)$")


def fail(path, number, what):
    sys.exit(f"{path}:{number}: {what}")


def snake_case(name):
    """TexSubImage2D -> tex_sub_image_2d"""
    words = re.sub(r"([a-z])([A-Z])", r"\1_\2", name)
    return re.sub(r"(?<=[a-z])(\dD)$", r"_\1", words).lower()


class Entry:
    """A function, its call, and since when it is offered."""

    def __init__(self, kind, result, name, parameters, call, arguments, since):
        self.kind, self.result, self.name = kind, result, name
        self.parameters, self.since = parameters, since
        self.call, self.arguments = call, arguments
        if call is None:
            self.call = snake_case(name)
            names = [p.split()[-1] for p in parameters.split(",") if p.strip()]
            self.arguments = ", ".join(names)

    def named(self, name, since):
        return Entry(self.kind, self.result, name, self.parameters, self.call, self.arguments,
                     since)


def entries(path):
    since = None
    known = {}
    with open(path, encoding="utf-8") as file:
        for number, line in enumerate(file, 1):
            line = line.strip()
            if not line or line.startswith("#"):
                continue
            if match := SINCE.match(line):
                since = match.groups()
                continue
            if match := ALIAS.match(line):
                if match[2] not in known:
                    fail(path, number, f"alias of '{match[2]}'; expected a function above it")
                entry = known[match[2]].named(match[1], since)
            else:
                match = LINE.match(line)
                if not match or match[1] not in KINDS:
                    fail(path, number, f"'{line}'; expected kind, prototype and perhaps = call")
                entry = Entry(*match.groups(), since)
            if since is None:
                fail(path, number, "a function before the first line 'since'")
            known[entry.name] = entry
            yield entry


def declared(parameter, arguments):
    """A parameter that the call does not take may stay unused."""
    name = parameter.split()[-1]
    return parameter if re.search(rf"\b{name}\b", arguments) else f"[[maybe_unused]] {parameter}"


def function(entry):
    parameters = ", ".join(declared(p.strip(), entry.arguments)
                           for p in entry.parameters.split(",") if p.strip())
    separator = ", " if entry.arguments else ""
    returned = "" if entry.result == "void" else "return "
    return (f"{entry.result} GLAPIENTRY gl{entry.name}({parameters}) {{\n"
            f"    number_call(Function::{entry.name}, __builtin_return_address(0));\n"
            f"    {returned}call<Kind::{KINDS[entry.kind]}, execute::{entry.call}>"
            f"(Function::{entry.name}{separator}{entry.arguments});\n}}")


def functions_header(names):
    return ["#pragma once", "#include <cstdint>", "namespace gw::gl {",
            "/// The entry points, in the table's order.", "enum class Function : std::uint16_t {",
            *(f"    {name}," for name in names), "};", "}  // namespace gw::gl"]


def names_header(names):
    return ["#pragma once", "namespace gw::gl {", "/// In the order of Function.",
            "inline constexpr const char* function_names[] = {",
            *(f'    "gl{name}",' for name in names), "};", "}  // namespace gw::gl"]


def offer(entry):
    major, minor, feature = entry.since
    return f"{{{major}{minor}, {'&Extensions::' + feature if feature else 'nullptr'}}}"


def table(rows):
    return ["namespace gw::gl {", "std::span<const EntryPoint> entry_points() {",
            "    static const EntryPoint table[] = {",
            *(f'        {{"gl{row.name}", Kind::{KINDS[row.kind]}, '
              f'reinterpret_cast<Address>(&gl{row.name}), {offer(row)}}},' for row in rows),
            "    };", "    return table;", "}", "}  // namespace gw::gl"]


def exported(definitions):
    return ["#pragma GCC visibility push(default)", 'extern "C" {', *definitions,
            '}  // extern "C"',
            "#pragma GCC visibility pop"]


def definitions(rows):
    return ['#include "gl/lists/call.h"', '#include "gl/api/convert.h"',
            '#include "gl/entry/entry_points.h"', "using namespace gw::gl;",
            *exported(function(row) for row in rows), *table(rows)]


def linked_names(path):
    with open(path, encoding="utf-8") as file:
        return [name for line in file if not line.startswith("#") for name in line.split()]


def linked_definitions(names):
    """Their arguments are not read, so that their prototypes are not needed: <GL/gl.h> is left
    out."""
    return ['#include "gl/entry/entry_points.h"',
            *exported(f"std::intptr_t gl{name}() {{ return gw::gl::not_offered(); }}"
                      for name in names)]


def main():
    path, linked_path, folder = sys.argv[1:]
    rows, linked = list(entries(path)), linked_names(linked_path)
    names = [row.name for row in rows]
    for name in sorted({n for n in names + linked if (names + linked).count(n) > 1}):
        sys.exit(f"{path}: {name} stands twice")
    for name, lines in (("functions.h", functions_header(names)),
                        ("names.inc", [f"GW_GL_FUNCTION({name})" for name in names]),
                        ("linked.inc", [f"GW_GL_LINKED({name})" for name in linked]),
                        ("function_names.h", names_header(names)),
                        ("entry_points.cpp", definitions(rows)),
                        ("linked.cpp", linked_definitions(linked))):
        with open(f"{folder}/{name}", "w", encoding="utf-8") as file:
            file.write("\n".join(["// Made from gl/entry/functions.txt by gl/entry/generate.py.",
                                  *lines]) + "\n")


main()
