"""Chapter 17: samples of surfaces."""
import math
from dataclasses import dataclass, replace

import numpy as np

from .antialiasing import has_center
from .numbers import clamp01, one
from .rasterization import Frame, OuterFrame, covered, whole
from .state import Plane

# [R17.2] In 1/8 pixel from the lower left corner.
PLACES = {2: ((6, 6), (2, 2)),
          4: ((3, 1), (7, 3), (1, 5), (5, 7)),
          8: ((4, 2), (3, 5), (6, 4), (2, 1), (1, 6), (0, 3), (5, 7), (7, 0))}


def count_of(machine):
    return len(machine.surface.samples)


def has_places(machine):
    """[R17.2] Whether samples have places of their own."""
    return count_of(machine) > 1 and machine.state.multisample.enable


def moved(ready, place, s):
    """[R17.2]"""
    dx, dy = ((4 - v) * 2**(s - 3) for v in place)
    return replace(ready, corners=tuple(replace(c, X=c.X + dx, Y=c.Y + dy)
                                        for c in ready.corners))


@dataclass
class Covered:
    """[R17.2] Fragments: their pixels, and by sample whether they cover it and their depth."""
    x: np.ndarray
    y: np.ndarray
    masks: np.ndarray
    depths: list
    outer: np.ndarray  # by fragment [R17.3]

    def chosen(self, here):
        return Covered(self.x[here], self.y[here], self.masks[:, here],
                       [z[here] for z in self.depths], self.outer[here])


def fragments(stage, ready):
    """[R17.2] stage: of a draw."""
    s = stage.profile.subpixel_bits
    left, bottom, right, top = stage.box
    if left >= right or bottom >= top:
        return None
    places = PLACES[count_of(stage.machine)]
    masks = np.zeros((len(places), top - bottom, right - left), bool)
    for mask, place in zip(masks, places):
        here = moved(ready, place, s)
        x, y = covered(here.corners, stage.box, stage.state, s, ready.steps)
        mask[y - bottom, x - left] = True
    row, column = np.nonzero(masks.any(axis=0))
    x, y = column + left, row + bottom
    depths = [stage.depths(ready, Frame(moved(ready, place, s).corners, s), x, y)
              for place in places]
    outer = np.array([is_outer(stage, ready, int(i), int(j), s) for i, j in zip(x, y)], bool)
    return Covered(x, y, masks[:, row, column], depths, outer)


def is_outer(stage, ready, x, y, s):
    """[R17.3]"""
    if len(ready.corners) == 1:
        return bool(stage.state.point_sprite)
    return not has_center(ready.corners, x, y, s)


def draw(stage, ready):
    """[R17.3] The stages of one piece, line or point."""
    found = fragments(stage, ready)
    if found is None:
        return
    for frame_of, outer in ((Frame, False), (OuterFrame, True)):
        frame = frame_of(ready.corners, stage.profile.subpixel_bits)
        if len(ready.corners) == 1 and stage.state.point_sprite:
            frame.sprite_size = whole(ready.corners[0].vertex.point_size)
        here = found.chosen(found.outer == outer)
        stage.shade(ready, frame, here.x, here.y, samples=here)


def kept(machine, colors):
    """[R17.4] By sample, the fragments that keep it; and their colours."""
    N, most = count_of(machine), one(machine.profile.color_bits)
    masks = np.ones((N, len(colors)), bool)
    if not has_places(machine):
        return masks, colors
    state = machine.state.multisample
    if state.alpha_to_coverage:
        for k in range(N):
            masks[k] &= colors[:, 3] >= -(-(2 * k + 1) * most // (2 * N))
    if state.alpha_to_one:
        colors = colors.copy()
        colors[:, 3] = most
    if state.coverage_test:
        c = math.floor(clamp01(state.coverage) * N + 0.5)
        for k in range(N):
            masks[k] &= (k < c) != state.invert
    return masks, colors


def given(source, plane, target):
    """[R17.6] What a surface gives to each sample of another one."""
    values = [sample.of(plane) for sample in source.samples]
    N = len(values)
    if N == 1:
        return values * len(target.samples)
    if len(target.samples) > 1:
        return values
    return [(sum(values) + N // 2) // N if plane == Plane.Color else values[0]]


def samples_read(source, plane, target):
    """[R17.7]"""
    resolves = len(target.samples) == 1 and plane != Plane.Color
    return 1 if resolves else len(source.samples)
