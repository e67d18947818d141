#!/usr/bin/env python3
"""A painter's algorithm in Python: sorts by the farthest corner and draws far to near.

    gw play scenes/hidden/cycle.toml --polygons polygons.json
    python3 examples/hidden_surfaces/painter.py polygons.json > steps.jsonl
    gw play scenes/hidden/cycle.toml steps.jsonl --steps played
"""

import json
import sys


def depth(polygon):
    """z of the farthest corner in the window; larger is farther."""
    return max(z for loop in polygon["outline"] for x, y, z in loop)


def step(**members):
    print(json.dumps(members))


with open(sys.argv[1], encoding="utf-8") as file:
    polygons = json.load(file)["polygons"]

in_window = [polygon for polygon in polygons if polygon["outline"]]
far_to_near = sorted(in_window, key=depth, reverse=True)
step(kind="sort", test="farthest corner", result="sorted",
     pieces=[str(polygon["id"]) for polygon in far_to_near],
     values={"z": [depth(polygon) for polygon in far_to_near]})
for polygon in far_to_near:
    step(kind="draw", pieces=[str(polygon["id"])])
