#!/usr/bin/env python3
"""A BSP tree in Python, walked as it is built: what lies behind a plane is drawn before it.

    gw play scenes/hidden/cycle.toml --polygons polygons.json
    python3 examples/hidden_surfaces/bsp.py polygons.json > steps.jsonl
    gw play scenes/hidden/cycle.toml steps.jsonl --steps played
"""
import json
import sys

ON_PLANE = 1  # grid units: the corners are rounded

def step(**members):
    print(json.dumps(members))

def distance(plane, point):
    return sum(c * p for c, p in zip(plane, (*point, 1))) / sum(map(abs, plane[:3]))

def half(loop, plane, sign):
    """The part of a loop before the plane (sign -1) or behind it (sign 1)."""
    part = []
    for p, q in zip(loop, loop[1:] + loop[:1]):
        d, e = distance(plane, p), distance(plane, q)
        if d * sign >= -ON_PLANE:
            part.append(p)
        if min(d, e) < -ON_PLANE and max(d, e) > ON_PLANE:
            if d > e:  # from one end in both halves, for the same corner
                p, q, d, e = q, p, e, d
            part.append([a + d / (d - e) * (b - a) for a, b in zip(p, q)])
    return part

def draw(pieces):
    """Back to front: what is behind the first one's plane, the first one, what is before it."""
    if not pieces:
        return
    root, before, behind = pieces[0], [], []
    for piece in pieces[1:]:
        sides = [distance(root["plane"], p) for loop in piece["outline"] for p in loop]
        step(kind="compare", test=f"corners before the plane of {root['name']}",
             result=str(sum(s < 0 for s in sides)), pieces=[piece["name"], root["name"]])
        if max(sides) <= ON_PLANE:
            before.append(piece)
        elif min(sides) >= -ON_PLANE:
            behind.append(piece)
        else:
            for letter, sign, side in (("a", -1, before), ("b", 1, behind)):
                parts = [half(loop, root["plane"], sign) for loop in piece["outline"]]
                side.append({"name": piece["name"] + letter, "plane": piece["plane"],
                             "outline": [part for part in parts if len(part) > 2]})
            step(kind="split", decisive=True, pieces=[piece["name"], root["name"]],
                 made=[{"name": p["name"], "outline": p["outline"]}
                       for p in (before[-1], behind[-1])])
    draw(behind)
    step(kind="draw", pieces=[root["name"]])
    draw(before)

with open(sys.argv[1], encoding="utf-8") as file:
    polygons = json.load(file)["polygons"]
pieces = (piece for polygon in polygons for piece in polygon["pieces"])
draw([piece for piece in pieces if piece["plane"] and piece["outline"]])
