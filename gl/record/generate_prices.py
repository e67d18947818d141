#!/usr/bin/env python3
"""Makes C++ from the VGX's price list: generate_prices.py vgx.toml FILE

FILE has the machine's name and a line for each counter of the machine that has a price. The prices
of rays are left out: a program of OpenGL traces none.
"""
import re
import sys


def values_of(text):
    """Keys and values of a table; a value is a string or a number."""
    return {key: value.strip('"') for key, value in
            re.findall(r'^(\w+)\s*=\s*("[^"]*"|[\d.]+|true|false)', text, re.MULTILINE)}


def main():
    path, out = sys.argv[1:]
    with open(path, encoding="utf-8") as file:
        text = re.sub(r"^#.*$", "", file.read(), flags=re.MULTILINE)
    head, *tables = re.split(r"^\[\[price\]\]$", text.split("[calibration]")[0],
                             flags=re.MULTILINE)
    rows = []
    for table in map(values_of, tables):
        if table["stage"] == "processor":
            continue
        price = table["nanoseconds"]
        rows.append(f'    {{&Counters::{table["count"]}, {str(table["stage"] == "geometry").lower()}, '
                    f'{price}, {table.get("low", price)}, {table.get("high", price)}}},')
    if not rows:
        sys.exit(f"{path}: no prices of geometry or pixels; expected [[price]]")
    lines = [f"// Made from {path.split('/')[-1]} by gl/record/generate_prices.py.", "#pragma once",
             '#include "gl/record/estimate.h"', "namespace gw::gl {",
             f'inline constexpr const char* priced_machine = "{values_of(head)["machine"]}";',
             "inline constexpr Price vgx_prices[] = {", *rows, "};", "}  // namespace gw::gl"]
    with open(out, "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")


main()
