"""Chapter 17: samples of surfaces."""
import math
from dataclasses import dataclass, replace

import numpy as np

from .numbers import clamp01, one
from .rasterization import Frame, MovedFrame, covered, whole
from .state import Plane

# [R17.2] In 1/8 pixel from the lower left corner.
PLACES = {2: ((6, 6), (2, 2)),
          4: ((3, 1), (7, 3), (1, 5), (5, 7)),
          8: ((4, 2), (3, 5), (6, 4), (2, 1), (1, 6), (0, 3), (5, 7), (7, 0))}


CENTER = -1


def count_of(machine):
    return len(machine.surface.samples)


def has_places(machine):
    """[R17.2] Whether samples have places of their own."""
    return count_of(machine) > 1 and machine.state.multisample.enable


def move_of(place, s):
    """[R17.2] In sub-pixels."""
    x, y = place
    return (4 - x) * 2**(s - 3), (4 - y) * 2**(s - 3)


def moved(ready, place, s):
    """[R17.2]"""
    dx, dy = move_of(place, s)
    return replace(ready, corners=tuple(replace(c, X=c.X + dx, Y=c.Y + dy)
                                        for c in ready.corners))


@dataclass
class Covered:
    """[R17.2] Fragments: their pixels, and by sample whether they cover it and their depth; the
    sample whose values they have, or CENTER [R17.3], [R17.8]."""
    x: np.ndarray
    y: np.ndarray
    masks: np.ndarray
    depths: list
    place: np.ndarray

    def chosen(self, here):
        return Covered(self.x[here], self.y[here], self.masks[:, here],
                       [z[here] for z in self.depths], self.place[here])


def fragments(stage, ready):
    """[R17.2] stage: of a draw."""
    s = stage.profile.subpixel_bits
    left, bottom, right, top = stage.box
    if left >= right or bottom >= top:
        return None
    places = PLACES[count_of(stage.machine)]
    masks = np.zeros((len(places), top - bottom, right - left), bool)
    center = np.zeros((top - bottom, right - left), bool)
    for mask, corners in zip((*masks, center),
                             (*(moved(ready, p, s).corners for p in places), ready.corners)):
        x, y = covered(corners, stage.box, stage.state, s, ready.steps)
        mask[y - bottom, x - left] = True
    row, column = np.nonzero(masks.any(axis=0))
    x, y = column + left, row + bottom
    depths = [stage.depths(ready, Frame(moved(ready, place, s).corners, s), x, y)
              for place in places]
    first = masks[:, row, column].argmax(axis=0)
    return Covered(x, y, masks[:, row, column], depths,
                   np.where(center[row, column], CENTER, first))


def frame_at(stage, ready, place):
    """[R17.3], [R17.8] Of the centres, or of a sample."""
    s = stage.profile.subpixel_bits
    if place == CENTER:
        return Frame(ready.corners, s)
    return MovedFrame(ready.corners, s, move_of(PLACES[count_of(stage.machine)][place], s))


def draw(stage, ready):
    """The stages of one piece, line or point."""
    found = fragments(stage, ready)
    if found is None:
        return
    for place in np.unique(found.place):
        frame = frame_at(stage, ready, place)
        if len(ready.corners) == 1 and stage.state.point_sprite:
            frame.sprite_size = whole(ready.corners[0].vertex.point_size)
        here = found.chosen(found.place == place)
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
