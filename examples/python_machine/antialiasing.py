"""Chapter 9, "Antialiasing": the part of each pixel that a smooth primitive covers."""
import math
from collections import defaultdict
from dataclasses import dataclass

import numpy as np

from .numbers import one, rne, rne_quotient
from .rasterization import counter_clockwise, covers_center

S = 4096


def is_smooth(state, ready):
    """[R9.23]"""
    if ready.filled:
        return state.polygon_smooth
    return state.line_smooth if len(ready.corners) == 2 else (
        state.point_smooth and not state.point_sprite)  # [R9.33]


def limited(v, low, high):
    return max(low, min(v, high))


def left(a, b, i, j):
    """[R9.24] The area in a pixel to the left of a side."""
    if a[1] > b[1]:
        return -left(b, a, i, j)
    y0, y1 = max(a[1], j * S), min(b[1], (j + 1) * S)
    if y0 >= y1:
        return 0
    dx, dy = b[0] - a[0], b[1] - a[1]
    if dx == 0:
        return 2**16 * (y1 - y0) * limited(a[0] - i * S, 0, S)

    def h(y):
        n = (a[0] - i * S) * dy + (y - a[1]) * dx
        if n < 0:
            return 0
        return n * n if n <= S * dy else S * dy * (2 * n - S * dy)

    numerator = 2**16 * (h(y1) - h(y0)) * (1 if dx > 0 else -1)
    return rne_quotient(numerator, 2 * abs(dx) * dy)


def polygon_area(corners, i, j):
    """[R9.24]"""
    return sum(left(a, b, i, j) for a, b in zip(corners, corners[1:] + corners[:1]))


def disc(c, H):
    """[R9.27] The corners."""
    K = next(K for K in (8, 16, 32, 64, 128) if 32 * K * K >= H)
    P = []
    for k in range(K):
        t = (2 * k + 1) * (math.sqrt(2) - 1) / (2 * K)
        d = 1 + t * t
        P.append((int(rne(H * ((1 - t * t) / d))), int(rne(H * ((t + t) / d)))))
    P += [(y, x) for x, y in reversed(P)]
    corners = []
    for _ in range(4):
        corners += [(c[0] + x, c[1] + y) for x, y in P]
        P = [(-y, x) for x, y in P]
    return corners


def on_grid(corner, s):
    return corner.X * 2**(12 - s), corner.Y * 2**(12 - s)


def steps(corners, s):
    """[R9.26] n, of a smooth line."""
    a, b = corners
    dx, dy = b.X - a.X, b.Y - a.Y
    return math.ceil(math.sqrt(dx * dx + dy * dy) / 2**s)


def rectangles(ready, state, s):
    """[R9.26]"""
    a, b = ready.corners
    dx, dy = b.X - a.X, b.Y - a.Y
    L = math.sqrt(dx * dx + dy * dy)
    n = steps(ready.corners, s)
    H = rne(2048 * state.line_width)
    ox, oy = -int(rne(H * dy / L)), int(rne(H * dx / L))
    x0, y0 = on_grid(a, s)

    def p(k):
        if k == n:
            return on_grid(b, s)
        return x0 + int(rne(4096 * k * dx / L)), y0 + int(rne(4096 * k * dy / L))

    def rectangle(first, end):
        (px, py), (qx, qy) = p(first), p(end)
        return [(px - ox, py - oy), (qx - ox, qy - oy), (qx + ox, qy + oy), (px + ox, py + oy)]

    stipple = state.line_stipple
    if not stipple.enable:
        return [rectangle(0, n)]
    return [rectangle(k, k + 1) for k in range(n)
            if stipple.pattern >> ((k + ready.steps) // stipple.factor % 16) & 1]


def pixels_around(corners, box):
    xs, ys = [c[0] for c in corners], [c[1] for c in corners]
    for j in range(max(box[1], min(ys) // S), min(box[3], max(ys) // S + 1)):
        for i in range(max(box[0], min(xs) // S), min(box[2], max(xs) // S + 1)):
            yield i, j


@dataclass
class Covered:
    """Arrays of the pixels that one primitive covers, and the piece that gives their values."""
    x: np.ndarray
    y: np.ndarray
    coverage: np.ndarray
    piece: np.ndarray
    outer: np.ndarray  # [R9.28]


def shapes(ready, state, s):
    """Lists of corners, counter-clockwise."""
    corners = ready.corners
    if len(corners) == 1:
        return [disc(on_grid(corners[0], s), int(rne(2048 * corners[0].vertex.point_size)))]
    if len(corners) == 2:
        return rectangles(ready, state, s)
    return [[on_grid(c, s) for c in counter_clockwise(corners)]]


def covered(pieces, box, state, profile):
    """[R9.23] Of the pieces of a polygon [R9.25], or of one line or point."""
    s, bits = profile.subpixel_bits, profile.coverage_bits
    areas = defaultdict(lambda: [0] * len(pieces))
    for k, ready in enumerate(pieces):
        for shape in shapes(ready, state, s):
            for pixel in pixels_around(shape, box):
                areas[pixel][k] += polygon_area(shape, *pixel)
    rows = []
    for (x, y), parts in areas.items():
        coverage = (limited(sum(parts), 0, 2**40) * one(bits) + 2**39) >> 40
        if coverage == 0 or (pieces[0].filled and is_left_out(state, x, y)):
            continue
        inner = [k for k, ready in enumerate(pieces) if has_center(ready.corners, x, y, s)]
        rows.append((x, y, coverage, inner[0] if inner else parts.index(max(parts)), not inner))
    columns = np.array(rows, np.int64).reshape(-1, 5).T
    return Covered(*columns[:4], columns[4] != 0)


def is_left_out(state, x, y):
    """[R9.30]"""
    rows = state.polygon_stipple
    return bool(rows) and rows[y % 32] >> (31 - x % 32) & 1 == 0


def has_center(corners, x, y, s):
    """[R9.28] Whether the centre of the pixel is no outer one."""
    if len(corners) == 3:
        return covers_center(corners, x, y, s)
    if len(corners) == 1:
        return True
    a, b = corners
    x_major = abs(b.X - a.X) >= abs(b.Y - a.Y)
    ends = (a.X, b.X) if x_major else (a.Y, b.Y)
    return min(ends) <= ((x if x_major else y) << s) + (1 << (s - 1)) <= max(ends)


def with_coverage(colors, coverage, bits):
    """[R9.29]"""
    result = colors.copy()
    result[:, 3] = (2 * colors[:, 3] * coverage + one(bits)) // (2 * one(bits))
    return result
