#!/usr/bin/env python3
"""Writes lamps.toml beside this file: a building at night with 100 lamps [K3.3]. CMake and
scripts/lab call it.

All lengths are in metres: ten bays of 2.6, an arcade below, four floors above, a square with
lanterns and a fountain before it.
"""

import pathlib

BAYS, FLOORS = 10, 4
BAY, ARCADE, STOREY = 2.6, 3.4, 2.7
LENGTH = BAYS * BAY
HEIGHT = ARCADE + FLOORS * STOREY

HEAD = """\
# A building with 100 lamps [K3.3]: point lights with attenuation, twelve of them with shadows. The
# machine knows eight in a pass; multi-pass has no limit. Made by scenes/make_lamps.py.
#     gw render scenes/lamps.toml -o lamps.png
name = "lamps"
background = [0.02, 0.03, 0.08]

[camera]
eye = [-9, 6.2, 38]
at = [-0.1, 6, 0]
fov = 33

[material.wall]
Ka = [0.5, 0.55, 0.8]
Kd = [0.85, 0.78, 0.66]

[material.cornice]
Ka = [0.5, 0.55, 0.8]
Kd = [0.9, 0.86, 0.78]

[material.window]
Ka = 0
Kd = [0.1, 0.1, 0.12]
Ke = [0.2, 0.14, 0.06]

[material.dark_window]
Ka = 0.2
Kd = [0.1, 0.1, 0.14]

[material.square]
Ka = [0.4, 0.45, 0.7]
Kd = [0.8, 0.76, 0.72]
map_Kd = { file = "maps/granite.png", scale = [36, 28] }

[material.stone]
Ka = [0.5, 0.55, 0.8]
Kd = 0.8
Ks = 0.2
Ns = 20

[material.bronze]
Ka = 0.2
Kd = [0.35, 0.55, 0.45]
Ks = 0.6
Ns = 30

[material.warm]
Ka = 0
Kd = 0
Ke = [1, 0.85, 0.55]

[material.cold]
Ka = 0
Kd = 0
Ke = [0.75, 0.9, 1]
"""


def triple(x, y, z):
    return f"[{x:.4g}, {y:.4g}, {z:.4g}]"


def placed(name, shape, place, material):
    return (f'\n[[object]]\nname = "{name}"\n{shape}\ntranslate = {triple(*place)}\n'
            f'material = "{material}"\n')


class Lamps:
    """Numbers lamps in the order in which they are made."""

    def __init__(self):
        self.number = 0

    def lamp(self, kind, place, cold, shadow, strength, reach, radius):
        """The visible globe, and the light slightly below it, so that its shadow goes upwards.
        reach: metres to a fifth of the strength."""
        self.number += 1
        name = f"{kind} {self.number}"
        x, y, z = place
        r, g, b = (0.5, 0.75, 1) if cold else (1, 0.68, 0.32)
        text = (f'\n[[light]]\nname = "{name}"\nposition = {triple(x, y - 2 * radius, z)}\n'
                f"Id = {triple(r * strength, g * strength, b * strength)}\n"
                f"Is = {triple(0.5 * r, 0.5 * g, 0.5 * b)}\n"
                f"attenuation = [0.25, 0, {4.75 / (reach * reach):.4g}]\n")
        if self.number == 1:
            text += "Ia = 0.06\n"
        if shadow:
            text += 'shadow = "volume"\n'
        return text + placed(f"globe of {name}",
                             f'shape = "icosphere"\nradius = {radius:.3g}\ndivisions = 2', place,
                             "cold" if cold else "warm")


def middle_of(bay):
    return -LENGTH / 2 + (bay + 0.5) * BAY


def walls():
    text = placed("wall", f'shape = "rectangle"\nwidth = {LENGTH:.4g}\ndepth = {HEIGHT:.4g}\n'
                  "columns = 130\nrows = 70\nrotate = [90, 0, 0]", (0, HEIGHT / 2, 0), "wall")
    text += placed("side wall", f'shape = "rectangle"\nwidth = {HEIGHT:.4g}\ndepth = 9\n'
                   "columns = 24\nrows = 16\nrotate = [0, 0, 90]",
                   (-LENGTH / 2, HEIGHT / 2, -4.5), "wall")
    for f in range(FLOORS + 1):
        height, depth, segments = (0.18, 0.5, 48) if f else (0.35, 5.2, 40)
        text += placed(f"cornice {f + 1}", f'shape = "box"\nwidth = {LENGTH + 0.3:.4g}\n'
                       f"height = {height}\ndepth = {depth}\nsegments = {segments}",
                       (0, ARCADE + f * STOREY, 0.1 if f else 0.0), "cornice")
    return text


def windows():
    return "".join(
        placed(f"window {f + 1} {i + 1}",
               'shape = "box"\nwidth = 1.1\nheight = 1.5\ndepth = 0.12\nsegments = 2',
               (middle_of(i), ARCADE + f * STOREY + 1.15, 0.02),
               "window" if (3 * f + 7 * i) % 5 < 2 else "dark_window")
        for f in range(FLOORS) for i in range(BAYS))


def columns():
    return "".join(
        placed(f"column {i + 1}",
               'shape = "cylinder"\nradius = 0.24\nheight = 3.3\nslices = 24\nstacks = 14',
               (-LENGTH / 2 + i * BAY, 1.65, 2.3), "stone") for i in range(BAYS + 1))


def square():
    return (placed("square", 'shape = "rectangle"\nwidth = 44\ndepth = 34\ncolumns = 132\n'
                   "rows = 102", (0, 0, 9), "square") +
            placed("basin", 'shape = "bowl"\nslices = 64\nsegments = 10\nscale = [3.2, 0.9, 3.2]',
                   (0, 0, 10.5), "stone") +
            placed("vase", 'shape = "vase"\nslices = 64\nsegments = 14\nscale = 2.6',
                   (0, 0.3, 10.5), "bronze"))


def lanterns(lamps):
    text = ""
    for row, z in enumerate((5.4, 14.2)):
        for i in range(12):
            x = -14.3 + i * 2.6
            text += placed(f"post {row + 1} {i + 1}", 'shape = "cylinder"\nradius = 0.05\n'
                           "height = 1.1\nslices = 12\nstacks = 4", (x, 0.55, z), "stone")
            text += lamps.lamp("lantern", (x, 1.25, z), row == 1, row == 1 and i in (3, 8), 0.75,
                               3.2, 0.13)
    return text


def fountain(lamps):
    # Fourteen in a ring: cosines and sines of a 14th of the circle, to five digits, so that no
    # libm is needed.
    cosine = (1, 0.90097, 0.62349, 0.22252, -0.22252, -0.62349, -0.90097)
    sine = (0, 0.43388, 0.78183, 0.97493, 0.97493, 0.78183, 0.43388)
    text = ""
    for i in range(14):
        sign = 1 if i < 7 else -1
        text += lamps.lamp("fountain", (sign * 2.3 * cosine[i % 7], 0.3,
                                        10.5 + sign * 2.3 * sine[i % 7]), True, False, 0.6, 2.2,
                           0.07)
    return text


def house(lamps):
    text = ""
    for i in range(BAYS):
        text += lamps.lamp("arcade", (middle_of(i), 2.7, 1.1), False, True, 0.4, 4.6, 0.12)
    for f in range(FLOORS):
        for i in range(BAYS):
            text += lamps.lamp("wall", (middle_of(i), ARCADE + f * STOREY + 2.2, 0.42), False,
                               False, 0.8, 2, 0.08)
    for i in range(12):
        x = -LENGTH / 2 + 1 + i * (LENGTH - 2) / 11
        text += lamps.lamp("roof", (x, HEIGHT + 0.35, 0.25), True, False, 0.7, 1.8, 0.09)
    return text


def building():
    lamps = Lamps()
    fountain_lamps, lantern_lamps, house_lamps = fountain(lamps), lanterns(lamps), house(lamps)
    return (HEAD + walls() + windows() + columns() + square() + house_lamps + lantern_lamps +
            fountain_lamps)


file = pathlib.Path(__file__).with_name("lamps.toml")
text = building()
if not file.exists() or file.read_text() != text:
    file.write_text(text)
