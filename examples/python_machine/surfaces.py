"""Chapter 16: surfaces, blits, and planes of surfaces as textures."""
from copy import copy
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from . import samples
from .rasterization import rectangle
from .state import (NO_DRAW_BUFFER, DrawBuffer, MagFilter, Plane, ReadBuffer, corners_of,
                    intersection, pixel_box)
from .texture import Texture, bilinear

DRAWABLE = (Plane.Color, Plane.Depth, Plane.Stencil)


@dataclass
class Surface:
    """[R16.1] The window is surface 0, which has all planes."""
    width: int
    height: int
    has: int
    profile: Any
    samples: list  # Planes of each; of a surface without samples, one [R17.1]

    @property
    def values(self):
        return self.samples[0]

    def has_plane(self, plane):
        return self.has >> plane & 1 == 1


def make(machine, command):
    """[R16.1]"""
    if command.width == 0:
        machine.surfaces.pop(command.number, None)
        return
    profile = machine.window_profile
    if command.depth_bits:  # [R16.6]
        profile = replace(profile, depth_bits=command.depth_bits)
    machine.surfaces[command.number] = Surface(
        command.width, command.height, command.planes, profile,
        [type(machine.planes)(command.width, command.height)
         for _ in range(max(1, command.samples))])


def use(machine, command):
    """[R16.2]"""
    machine.use(command.number)


def state_on(surface, state, number):
    """[R16.3] The state as commands on a surface see it."""
    if number == 0:
        return state
    state = copy(state)
    state.read_buffer = ReadBuffer.Front
    colored = state.draw_buffer != NO_DRAW_BUFFER and surface.has_plane(Plane.Color)
    state.draw_buffer = DrawBuffer.Front if colored else NO_DRAW_BUFFER
    if not surface.has_plane(Plane.Depth):
        state.depth = replace(state.depth, test=False, mask=False)
    if not surface.has_plane(Plane.Stencil):
        front = replace(state.stencil.front, write_mask=0)
        state.stencil = replace(state.stencil, test=False, front=front)
    if len(surface.samples) > 1 and state.multisample.enable:  # [R17.2]
        state.point_smooth = state.line_smooth = state.polygon_smooth = False
        state.diamond_lines = False
    return state


def texture(machine, number, plane):
    """[R16.5]"""
    surface = machine.surfaces[number]
    return Texture.of_plane(surface.values.of(plane), plane == Plane.Depth, surface.profile)


def places(source, source_size, target_size, flip):
    """[R16.7] The centres of columns, or rows, in 1/256 pixel of the source."""
    i = np.arange(target_size, dtype=np.int64)
    if flip:
        i = target_size - 1 - i
    return 256 * source + 128 * (2 * i + 1) * source_size // max(target_size, 1)


def between(colors, u, v, bits):
    """[R16.8] The mean of four pixels; those outside the surface are the nearest inside."""
    height, width = colors.shape[:2]
    i, j = (u - 128) >> 8, (v - 128) >> 8

    def at(x, y):
        return colors[np.clip(y, 0, height - 1), np.clip(x, 0, width - 1)]

    return bilinear(at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1), u - 128, v - 128,
                    bits)


def blit(machine, command):
    """[R16.7] to [R16.9]"""
    source, target = machine.surfaces[command.from_surface], command.target
    box = pixel_box(machine.state, machine.width, machine.height)
    x, y = rectangle(intersection(box, corners_of(target)))
    if len(x) == 0:
        return
    us = places(command.source.x, command.source.width, target.width, command.flip_x)
    vs = places(command.source.y, command.source.height, target.height, command.flip_y)
    u, v = us[x - target.x], vs[y - target.y]
    inside = (u >= 0) & (v >= 0) & (u >> 8 < source.width) & (v >> 8 < source.height)
    x, y, u, v = x[inside], y[inside], u[inside], v[inside]
    for plane in DRAWABLE:
        both = source.has_plane(plane) and machine.surface.has_plane(plane)
        if not (command.planes >> plane & 1 and both):
            continue
        for values, planes in zip(samples.given(source, plane, machine.surface),
                                  machine.surface.samples):
            if plane == Plane.Color and is_back(machine, command):
                values = source.values.back
            copy_plane(machine, command, plane, values, planes, (x, y, u, v))
        written = len(machine.planes.drawn(machine.state.draw_buffer)) \
            if plane == Plane.Color else 1
        moved = (samples.samples_read(source, plane, machine.surface)
                 + max(1, written) * len(machine.surface.samples))
        machine.counters["pixels"] += len(x)  # [R16.10]
        machine.counters["bytes"] += moved * len(x) * machine.bytes_of[Plane(plane).name]


def copy_plane(machine, command, plane, values, planes, places_of):
    """[R16.8], [R16.9]"""
    x, y, u, v = places_of
    if plane == Plane.Color and command.filter == MagFilter.Linear:
        copied = between(values, u, v, machine.profile.color_bits)
    else:
        copied = values[v >> 8, u >> 8].copy()
    targets = [planes.of(plane)] if plane != Plane.Color \
        else planes.drawn(machine.state.draw_buffer)
    for to in targets:
        to[y, x] = copied


def is_back(machine, command):
    """[R16.9] Only the window has two colour planes."""
    return command.from_surface == 0 and machine.given_state.read_buffer == ReadBuffer.Back
