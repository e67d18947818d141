#!/usr/bin/env python3
"""Makes C++ from the table of OpenGL's entry points: generate.py functions.txt linked.txt FOLDER

FOLDER/functions.h numbers them, FOLDER/function_names.h names them, FOLDER/entry_points.cpp and
FOLDER/later.cpp define them and the tables behind gl/entry/entry_points.h. FOLDER/names.inc has a
line GW_GL_FUNCTION(Begin) for each that <GL/gl.h> declares, for tests.
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
    "later": "Later",
}
LINE = re.compile(r"(\w+)\s+(.*?)\s*\b(\w+)\((.*?)\)(?:\s*=\s*(\w+)\((.*)\))?$")


def fail(path, number, what):
    sys.exit(f"{path}:{number}: {what}")


def snake_case(name):
    """TexSubImage2D -> tex_sub_image_2d"""
    words = re.sub(r"([a-z])([A-Z])", r"\1_\2", name)
    return re.sub(r"(?<=[a-z])(\dD)$", r"_\1", words).lower()


def entries(path):
    with open(path, encoding="utf-8") as file:
        for number, line in enumerate(file, 1):
            line = line.strip()
            if not line or line.startswith("#"):
                continue
            words = line.split()
            if words[0] == "later" and len(words) == 2:
                yield "later", "void", words[1], "", None, None
                continue
            match = LINE.match(line)
            if not match or match[1] not in KINDS:
                fail(path, number, f"'{line}'; expected kind, prototype and perhaps = call")
            yield match.groups()


def declared(parameter, arguments):
    """A parameter that the call does not take may stay unused."""
    name = parameter.split()[-1]
    return parameter if re.search(rf"\b{name}\b", arguments) else f"[[maybe_unused]] {parameter}"


def function(kind, result, name, parameters, call, arguments):
    if call is None:
        call = snake_case(name)
        arguments = ", ".join(p.split()[-1] for p in parameters.split(",") if p.strip())
    parameters = ", ".join(declared(p.strip(), arguments) for p in parameters.split(",")
                           if p.strip())
    separator = ", " if arguments else ""
    returned = "" if result == "void" else "return "
    return (f"{result} GLAPIENTRY gl{name}({parameters}) {{\n"
            f"    number_call(Function::{name}, __builtin_return_address(0));\n"
            f"    {returned}call<Kind::{KINDS[kind]}, execute::{call}>"
            f"(Function::{name}{separator}{arguments});\n}}")


def functions_header(names):
    return ["#pragma once", "#include <cstdint>", "namespace gw::gl {",
            "/// The entry points, in the table's order.", "enum class Function : std::uint16_t {",
            *(f"    {name}," for name in names), "};", "}  // namespace gw::gl"]


def names_header(names):
    return ["#pragma once", "namespace gw::gl {", "/// In the order of Function.",
            "inline constexpr const char* function_names[] = {",
            *(f'    "gl{name}",' for name in names), "};", "}  // namespace gw::gl"]


def table(function_name, rows):
    return ["namespace gw::gl {", f"std::span<const EntryPoint> {function_name}() {{",
            "    static const EntryPoint table[] = {",
            *(f'        {{"gl{row[2]}", Kind::{KINDS[row[0]]}, '
              f'reinterpret_cast<Address>(&gl{row[2]})}},'
              for row in rows),
            "    };", "    return table;", "}", "}  // namespace gw::gl"]


def exported(definitions):
    return ["#pragma GCC visibility push(default)", 'extern "C" {', *definitions,
            '}  // extern "C"',
            "#pragma GCC visibility pop"]


def definitions(rows):
    return ['#include "gl/lists/call.h"', '#include "gl/api/convert.h"',
            '#include "gl/entry/entry_points.h"', "using namespace gw::gl;",
            *exported(function(*row) for row in rows), *table("entry_points", rows)]


def linked_names(path):
    with open(path, encoding="utf-8") as file:
        return [name for line in file if not line.startswith("#") for name in line.split()]


def later_definitions(rows, linked):
    """Their arguments are not read, so that their prototypes are not needed: <GL/gl.h> is left
    out."""
    names = [row[2] for row in rows] + linked
    return ['#include "gl/entry/entry_points.h"',
            *exported(f"std::intptr_t gl{name}() {{ return gw::gl::later(); }}" for name in names),
            *table("later_entry_points", rows)]


def main():
    path, linked_path, folder = sys.argv[1:]
    rows, linked = list(entries(path)), linked_names(linked_path)
    names = [row[2] for row in rows] + linked
    for name in sorted({n for n in names if names.count(n) > 1}):
        sys.exit(f"{path}: {name} stands twice")
    later = [row for row in rows if row[0] == "later"]
    known = [row for row in rows if row[0] != "later"]
    for name, lines in (("functions.h", functions_header([row[2] for row in known])),
                        ("names.inc", [f"GW_GL_FUNCTION({row[2]})" for row in known
                                       if not row[2].endswith(("EXT", "ARB"))]),
                        ("function_names.h", names_header([row[2] for row in known])),
                        ("entry_points.cpp", definitions(known)),
                        ("later.cpp", later_definitions(later, linked))):
        with open(f"{folder}/{name}", "w", encoding="utf-8") as file:
            file.write("\n".join(["// Made from gl/entry/functions.txt by gl/entry/generate.py.",
                                  *lines]) + "\n")


main()
