"""A Z-buffer in Python, row by row: of the plane parts over a pixel centre the nearest is shown."""
import json
import math
import sys
from fractions import Fraction

with open(sys.argv[1], encoding="utf-8") as file:
    header = json.load(file)
unit, (width, height) = header["unit"], header["size"]


def run_of(loop, y):
    """The pixels of a convex loop whose centres are on this line: the first, and that after the last."""
    ends = []
    for (x0, y0, _), (x1, y1, _) in zip(loop, loop[1:] + loop[:1]):
        if (y0 <= y) != (y1 <= y):
            x = x0 + (y - y0) * Fraction(x1 - x0) / Fraction(y1 - y0)
            ends.append(math.ceil(x / unit - Fraction(1, 2)))
    return (max(min(ends), 0), min(max(ends), width)) if ends else (0, 0)


parts = [(polygon["id"], part["plane"], loop) for polygon in header["polygons"]
         for part in polygon["pieces"] if part["plane"] for loop in part["outline"]]
for row in range(height):
    y = Fraction(2 * row + 1, 2) * unit
    nearest = [(header["depth"] + 1, 0)] * width
    for number, (a, b, _, d), loop in parts:
        first, end = run_of(loop, y)
        for x in range(first, end):
            z = -(a * (x + 0.5) * unit + b * float(y) + d)
            nearest[x] = min(nearest[x], (z, number))
    painted = [[row, x, x + 1, number] for x, (_, number) in enumerate(nearest) if number]
    if painted:
        print(json.dumps({"kind": "draw", "painted": painted}))
