"""Chapter 13: commands that act on whole pixels."""
import math

import numpy as np

from . import fog
from .color_sum import summed, sums_colors
from .environment import environments
from .fragments import FragmentStage, colors_written
from .numbers import bounded, one, quantize, to_integer
from .rasterization import rectangle
from .layers import unit_look_ups, volume_texel_in_place
from .place import texel_in_place
from .resolved import Resolved, stencil_write_mask, with_written_bits, written_bits
from .state import FogSource, Plane, ReadBuffer, corners_of, intersection, pixel_box
from .texture import Texture


def box_of(machine):
    return pixel_box(machine.state, machine.width, machine.height)


def size_of(box):
    return (box[2] - box[0]) * (box[3] - box[1])


def visited(machine, plane, pixels, times=1):
    """[R14.7], [R14.8]"""
    machine.counters["pixels"] += pixels
    machine.counters["bytes"] += (times * pixels * len(machine.surface.samples)
                                  * machine.bytes_of[Plane(plane).name])


def times_written(machine, plane):
    """[R14.8]"""
    return colors_written(machine.state.draw_buffer) if plane == Plane.Color else 1


def plane_read(machine, plane):
    """[R13.17]"""
    if plane == Plane.Color and machine.state.read_buffer == ReadBuffer.Back:
        return machine.planes.back
    return machine.planes.of(plane)


def store(machine, plane, x, y, values):
    """Through the plane's mask, as Clear writes it [R13.2]; in all samples [R17.1]."""
    for planes in machine.surface.samples:
        store_in(machine, planes, plane, x, y, values)


def store_in(machine, planes, plane, x, y, values):
    state = machine.state
    if plane == Plane.Color:
        for color in planes.drawn(state.draw_buffer):
            for c, bits in enumerate(written_bits(state, machine.profile)):
                color[y, x, c] = with_written_bits(color[y, x, c], values[:, c], bits)
    elif plane == Plane.Depth:
        if state.depth.mask:
            planes.depth[y, x] = values
    else:
        mask = stencil_write_mask(state, machine.profile)
        planes.stencil[y, x] = (planes.stencil[y, x] & ~mask) | (values & mask)


def clear(machine, command):
    """[R13.2]"""
    box, profile = box_of(machine), machine.profile
    x, y = rectangle(box)
    values = {
        Plane.Color: np.tile([quantize(v, profile.color_bits) for v in command.color],
                             (len(x), 1)),
        Plane.Depth: quantize(command.depth, profile.depth_bits),
        Plane.Stencil: command.stencil,
    }
    for plane in Plane:
        if not command.planes & machine.surface.has & (1 << plane):
            continue
        visited(machine, plane, size_of(box), times_written(machine, plane))
        if plane == Plane.Accum:
            machine.planes.accum[y, x] = [cleared(v, profile) for v in command.accum]
        else:
            store(machine, plane, x, y, values[plane])


def cleared(v, profile):
    """[R13.16] A channel of the accumulation plane."""
    level = 2.0**accum_fraction_bits(profile)
    whole = int(np.rint(min(max(v, -1.0), 1.0) * one(profile.color_bits) * level))
    return wrapped_to(profile.accum_bits, whole)


def accum_fraction_bits(profile):
    """[R13.19]"""
    return max(0, profile.accum_bits - profile.color_bits - 8) if profile.draw_pixels else 0


def wrapped_to(bits, v):
    """[R13.9]"""
    return ((v + 2**(bits - 1)) & one(bits)) - 2**(bits - 1)


def write_spans(machine, command):
    """[R13.3]"""
    left, bottom, right, top = box_of(machine)
    stage = FragmentStage(machine, Resolved(machine.state, machine.profile))
    for span in command.spans:
        x = np.arange(max(span.x, left), min(span.x + span.length, right), dtype=np.int64)
        if not bottom <= span.y < top or len(x) == 0:
            continue
        places = np.full(len(x), span.first) if span.flat else span.first + (x - span.x)
        stage.run(x, np.full(len(x), span.y), command.colors[places],
                  np.full(len(x), command.depth, np.int64), front=True)


def write_pixels(machine, command):
    """[R13.4]"""
    rect = command.rect
    x, y = rectangle(intersection(box_of(machine), corners_of(rect)))
    places = (y - rect.y) * rect.width + (x - rect.x)
    if command.plane == Plane.Color:
        stage = FragmentStage(machine, Resolved(machine.state, machine.profile))
        stage.run(x, y, command.colors[places], np.full(len(x), command.depth, np.int64),
                  front=True)
    else:
        visited(machine, command.plane, len(x))
        store(machine, command.plane, x, y, command.values[places])


def copy(machine, command):
    """[R13.5]"""
    source = command.source
    window = (0, 0, machine.width, machine.height)
    i, j = rectangle(intersection(window, corners_of(source)))
    x, y = i - source.x + command.x, j - source.y + command.y
    left, bottom, right, top = box_of(machine)
    kept = (x >= left) & (x < right) & (y >= bottom) & (y < top)
    values = plane_read(machine, command.plane)[j[kept], i[kept]].copy()
    visited(machine, command.plane, len(values), 1 + times_written(machine, command.plane))
    store(machine, command.plane, x[kept], y[kept], values)


def copy_texture(machine, command):
    """[R13.6]"""
    left, bottom, right, top = corners_of(command.rect)
    values = plane_read(machine, command.plane)[bottom:top, left:right].copy()
    machine.slots[command.slot] = Texture.of_plane(values, command.plane == Plane.Depth,
                                                   machine.profile)
    visited(machine, command.plane, size_of((left, bottom, right, top)))


def read(machine, command):
    """[R13.7] The values as rows, from the bottom."""
    left, bottom, right, top = corners_of(command.rect)
    values = plane_read(machine, command.plane)[bottom:top, left:right].copy()
    if command.packed:
        values = values @ np.array([1, 2**8, 2**16, 2**24])
    machine.readbacks[command.key] = values
    visited(machine, command.plane, size_of((left, bottom, right, top)))


def swap_buffers(machine, _):
    """[R13.18]"""
    planes = machine.planes
    planes.color, planes.back = planes.back, planes.color


# ---- Drawn pixels ----------------------------------------------------------------------------


def edge(start, zoom, n):
    """[R13.10]"""
    place = (start + zoom * n) - 0.5
    return to_integer(math.ceil(place) if math.isfinite(place) else place, -2**20, 2**20)


def shown(start, zoom, count, low, high):
    """[R13.10] The window's columns (or rows) low .. high - 1 that are covered, and by which."""
    covered, by = [], []
    for n in range(count):
        ends = sorted((edge(start, zoom, n), edge(start, zoom, n + 1)))
        inside = range(max(ends[0], low), min(ends[1], high))
        covered += inside
        by += [n] * len(inside)
    order = np.argsort(np.array(covered, dtype=np.int64), kind="stable")
    return np.array(covered, dtype=np.int64)[order], np.array(by, dtype=np.int64)[order]


def with_source(machine, command):
    """[R13.15] colors, depths, stencils of all pixels, and which of them can be drawn."""
    n, m = np.meshgrid(np.arange(command.width), np.arange(command.height))
    n, m = n.ravel(), m.ravel()
    if command.source is None:
        return command.colors, command.depths, command.stencils, np.ones(len(n), bool)
    i, j = command.source.x + n, command.source.y + m
    inside = (i >= 0) & (i < machine.width) & (j >= 0) & (j < machine.height)
    plane = plane_read(machine, command.source.plane)
    values = np.zeros((len(n),) + plane.shape[2:], np.int64)
    values[inside] = plane[j[inside], i[inside]]
    visited(machine, command.source.plane, int(np.count_nonzero(inside)))
    return tuple(values if command.source.plane == p else None
                 for p in (Plane.Color, Plane.Depth, Plane.Stencil)) + (inside,)


def draw_pixels(machine, command):
    """[R13.10] to [R13.15]"""
    raster, width = command.raster, command.width
    colors, depths, stencils, drawn = with_source(machine, command)
    left, bottom, right, top = box_of(machine)
    x, n = shown(raster.x, command.zoom_x, width, left, right)
    y, m = shown(raster.y, command.zoom_y, command.height, bottom, top)
    places = (m[:, None] * width + n[None, :]).ravel()
    x, y = np.tile(x, len(y)), np.repeat(y, len(x))
    if command.bits is not None:  # [R13.11]
        column, row = places % width, places // width
        byte = command.bits[row * -(-width // 8) + (column >> 3)]
        kept = drawn[places] & ((byte >> (7 - (column & 7)) & 1) == 1)
    else:
        kept = drawn[places]
    x, y, places = x[kept], y[kept], places[kept]
    if stencils is not None:  # [R13.14]
        visited(machine, Plane.Stencil, len(x))
        store(machine, Plane.Stencil, x, y, stencils[places])
        return
    colors = np.tile(np.array(raster.color, np.int64), (len(x), 1)) if colors is None \
        else colors[places]
    depths = np.full(len(x), raster.depth, np.int64) if depths is None else depths[places]
    stage = FragmentStage(machine, Resolved(machine.state, machine.profile))
    stage.run(x, y, shaded(machine, command, colors), depths, front=True)


def shaded(machine, command, colors):
    """[R13.12]"""
    state, profile = machine.state, machine.profile
    bits = profile.color_bits
    texels = {}
    for unit in command.units():
        machine.counters["texels"] += len(colors) * unit_look_ups(machine, command, unit)
        texture = machine.texture_of(command, unit)
        strq = ((command.raster.texcoord,) + command.raster.more_texcoords)[unit]
        in_place = volume_texel_in_place if texture.with_r else texel_in_place
        texel = in_place(state.of_unit(unit), profile, texture, strq)
        texels[unit] = (np.repeat(texel, len(colors), axis=0), texture.format)
    colors = environments(colors, texels, state, bits)
    if sums_colors(state):
        colors = summed(colors, np.array(command.raster.secondary_color[:3]), bits)
    if state.fog.enable:
        given = state.fog_source == FogSource.Coordinate
        distance = command.raster.fog_coordinate if given else command.raster.distance
        f = fog.factor(state.fog, bounded(distance, 2.0**200), bits)
        colors = fog.fogged(colors, f, state.fog, bits)
    return colors


# ---- Accumulation ---------------------------------------------------------------------------


def accumulate(machine, command):
    """[R13.8], [R13.9]"""
    x, y = rectangle(box_of(machine))
    planes, bits = machine.planes, machine.profile.accum_bits

    fraction = accum_fraction_bits(machine.profile)

    def weighted(a, shift=0):
        limit = 2.0**40
        return np.clip(np.rint(a.astype(np.float64) * command.value * 2.0**shift), -limit,
                       limit).astype(np.int64)

    old, color = planes.accum[y, x], plane_read(machine, Plane.Color)[y, x]
    most = one(machine.profile.color_bits)
    if command.op == "Return":
        store(machine, Plane.Color, x, y, np.clip(weighted(old, -fraction), 0, most))
    else:
        new = {"Accum": lambda: old + weighted(color, fraction),
               "Load": lambda: weighted(color, fraction),
               "Add": lambda: old + weighted(np.full_like(old, most), fraction),
               "Mult": lambda: weighted(old)}[command.op]()
        wrapped = wrapped_to(bits, new)
        machine.counters["accum_overflows"] += int(np.count_nonzero(wrapped != new))
        planes.accum[y, x] = wrapped
    machine.counters["pixels"] += len(x)
    times = times_written(machine, Plane.Color) if command.op == "Return" else 1
    machine.counters["bytes"] += len(x) * (machine.bytes_of["Accum"]
                                           + times * machine.bytes_of["Color"])
