"""Chapter 9: which pixels a piece, line or point covers, and integer planes over them."""
import math

import numpy as np

from .numbers import bounded, clamp01, rne, rne_quotient, to_integer
from .planes import AtMost, IntegerPlane, LimitedPlane, MovedPlane, centers

# ---- Coverage -------------------------------------------------------------------------------


def no_pixels():
    return np.zeros(0, np.int64), np.zeros(0, np.int64)


def rectangle(box):
    """All pixels of a box, rows upwards."""
    y, x = np.mgrid[box[1]:box[3], box[0]:box[2]]
    return x.ravel().astype(np.int64), y.ravel().astype(np.int64)


def covered(corners, box, state, s, steps=0):
    """Columns and rows of the pixels inside the box that the corners cover, each once."""
    if len(corners) == 3:
        return stippled_pixels(*piece_pixels(corners, box, s), state.polygon_stipple)
    if len(corners) == 2:
        return line_pixels(corners, box, state, s, steps)
    return point_pixels(corners[0], box, whole(corners[0].vertex.point_size), s)


def whole(size):
    """[R9.4], [R9.5]"""
    return math.floor(size + 0.5)


def stippled_pixels(x, y, rows):
    """[R9.21]"""
    if not rows:
        return x, y
    kept = np.array(rows, np.int64)[y % 32] >> (31 - x % 32) & 1 != 0
    return x[kept], y[kept]


def piece_pixels(corners, box, s):
    """[R9.1], [R9.2]"""
    a, b, c = counter_clockwise(corners)
    xs, ys = [p.X for p in (a, b, c)], [p.Y for p in (a, b, c)]
    bounds = (min(xs) >> s, min(ys) >> s, (max(xs) >> s) + 1, (max(ys) >> s) + 1)
    low = (max(box[0], bounds[0]), max(box[1], bounds[1]))
    high = (min(box[2], bounds[2]), min(box[3], bounds[3]))
    if low[0] >= high[0] or low[1] >= high[1]:
        return no_pixels()
    x, y = rectangle((*low, *high))
    inside = covers_center((a, b, c), x, y, s)
    return x[inside], y[inside]


def covers_center(corners, x, y, s):
    """[R9.2] Of one pixel or of arrays."""
    a, b, c = counter_clockwise(corners)
    px, py = centers(x, s), centers(y, s)
    inside = True
    for start, end in ((a, b), (b, c), (c, a)):
        dx, dy = end.X - start.X, end.Y - start.Y
        top_left = dy < 0 or (dy == 0 and dx < 0)
        inside &= dx * (py - start.Y) - dy * (px - start.X) - (0 if top_left else 1) >= 0
    return inside


def counter_clockwise(corners):
    a, b, c = corners
    return (a, b, c) if doubled_area(a, b, c) > 0 else (a, c, b)


def doubled_area(a, b, c):
    return (b.X - a.X) * (c.Y - a.Y) - (b.Y - a.Y) * (c.X - a.X)


def is_x_major(corners):
    """[R9.3]"""
    a, b = corners
    return abs(b.X - a.X) >= abs(b.Y - a.Y)


def diamond_column(corner, x_major, width, s):
    """[R9.34] The column, or row, in whose diamond a corner lies; None: in none."""
    half = 1 << (s - 1)
    x, y = corner.X, corner.Y
    if x_major:
        y -= (width - 1) * half
    else:
        x -= (width - 1) * half
    i, j = (x - 1) >> s, y >> s
    dx, dy = x - centers(i, s), y - centers(j, s)
    inside = dx + abs(dy) <= half if dx > 0 else abs(dx) + abs(dy) < half
    return (i if x_major else j) if inside else None


def line_columns(corners, state, s):
    """[R9.4], [R9.34] The columns of a line, or its rows, from corner 0 on."""
    x_major = is_x_major(corners)
    start, end = ((c.X if x_major else c.Y) for c in corners)
    half = 1 << (s - 1)
    if not state.diamond_lines:
        if start <= end:
            return range(-((half - start) >> s), -((half - end) >> s))
        return range((start - half) >> s, (end - half) >> s, -1)
    low, high = sorted((start, end))
    columns = set(range(-((half - low) >> s), -((half - high) >> s)))
    first, last = (diamond_column(c, x_major, whole(state.line_width), s) for c in corners)
    if first is not None:
        columns.add(first)
    columns.discard(last)
    return sorted(columns, reverse=end < start)


def line_pixels(corners, box, state, s, steps):
    """[R9.3], [R9.4], [R9.20], [R9.34]"""
    first, second = corners
    x_major, width, stipple = is_x_major(corners), whole(state.line_width), state.line_stipple
    if x_major:
        x0, y0, x1, y1 = first.X, first.Y, second.X, second.Y
        low, high, rows = box[0], box[2], (box[1], box[3])
    else:
        x0, y0, x1, y1 = first.Y, first.X, second.Y, second.X
        low, high, rows = box[1], box[3], (box[0], box[2])
    dx, dy = x1 - x0, y1 - y0
    column = np.array(line_columns(corners, state, s), np.int64)
    n = np.arange(len(column))
    inside = (column >= low) & (column < high)
    if stipple.enable:
        inside &= (stipple.pattern >> ((n + steps) // stipple.factor % 16) & 1) != 0
    column = column[inside]
    if len(column) == 0:
        return no_pixels()
    sign = 1 if dx > 0 else -1
    numerator = sign * (y0 * dx + dy * (centers(column, s) - x0) - (width - 1) * 2**(s - 1) * dx)
    if state.diamond_lines and not (x_major and dx * dy > 0):
        numerator -= 1
    row = numerator // (sign * dx * 2**s)
    major = np.repeat(column, width)
    minor = (row[:, None] + np.arange(width)).ravel()
    kept = (minor >= rows[0]) & (minor < rows[1])
    major, minor = major[kept], minor[kept]
    return (major, minor) if x_major else (minor, major)


def point_pixels(corner, box, size, s):
    """[R9.5]"""
    column, row = ((v - (size - 1) * 2**(s - 1)) >> s for v in (corner.X, corner.Y))
    low = (max(box[0], column), max(box[1], row))
    high = (min(box[2], column + size), min(box[3], row + size))
    if low[0] >= high[0] or low[1] >= high[1]:
        return no_pixels()
    return rectangle((*low, *high))


# ---- Planes ---------------------------------------------------------------------------------


class Frame:
    """[R9.6], [R9.7] How integers at the corners become gradients, for one piece, line or point."""

    sprite_size = 0  # of a point that is a sprite [R9.32]

    def __init__(self, corners, s):
        self.s = s
        if len(corners) == 3:
            self.set_piece(corners)
        elif len(corners) == 2:
            self.set_line(corners)
        else:
            self.order, self.X0, self.Y0 = (0,), corners[0].X, corners[0].Y

    def set_piece(self, corners):
        first = min(range(3), key=lambda i: (corners[i].Y, corners[i].X))
        order = (first, (first + 1) % 3, (first + 2) % 3)
        self.D = doubled_area(*(corners[i] for i in order))
        if self.D < 0:
            order, self.D = (order[0], order[2], order[1]), -self.D
        self.order = order
        p0, p1, p2 = (corners[i] for i in order)
        self.X0, self.Y0 = p0.X, p0.Y
        self.d1, self.d2 = (p1.X - p0.X, p1.Y - p0.Y), (p2.X - p0.X, p2.Y - p0.Y)

    def set_line(self, corners):
        dx, dy = corners[1].X - corners[0].X, corners[1].Y - corners[0].Y
        self.x_major = abs(dx) >= abs(dy)
        along = dx if self.x_major else dy
        self.order = (0, 1) if along > 0 else (1, 0)
        self.D = abs(along)
        self.X0, self.Y0 = corners[self.order[0]].X, corners[self.order[0]].Y

    def plane(self, values):
        """The plane with an integer at each corner, in the corners' own order."""
        a = [values[i] for i in self.order]
        scale = 1 << (16 + self.s)
        if len(a) == 3:
            (dx1, dy1), (dx2, dy2) = self.d1, self.d2
            g = (rne_quotient(((a[1] - a[0]) * dy2 - (a[2] - a[0]) * dy1) * scale, self.D),
                 rne_quotient(((a[2] - a[0]) * dx1 - (a[1] - a[0]) * dx2) * scale, self.D))
        elif len(a) == 2:
            along = rne_quotient((a[1] - a[0]) * scale, self.D)
            g = (along, 0) if self.x_major else (0, along)
        else:
            g = (0, 0)
        return IntegerPlane(a[0], *g, self.X0, self.Y0, self.s)

    def sloped_plane(self, a0, Gx, Gy):
        """[R9.32]"""
        return IntegerPlane(a0, Gx, Gy, self.X0, self.Y0, self.s)

    def numerator(self, values, q):
        """The plane of a U of R9.14."""
        return self.plane(values)


class OuterFrame(Frame):
    """[R9.28] For pixels whose centre is outside."""

    def plane(self, values):
        return LimitedPlane(super().plane(values), min(values), max(values))

    def numerator(self, values, q):
        return AtMost(self.plane(values), q)


class MovedFrame(Frame):
    """[R17.8] For pixels with the values of one sample: after a move, in sub-pixels."""

    def __init__(self, corners, s, move):
        super().__init__(corners, s)
        self.move = move

    def plane(self, values):
        return MovedPlane(super().plane(values), *self.move)

    def sloped_plane(self, a0, Gx, Gy):
        return MovedPlane(super().sloped_plane(a0, Gx, Gy), *self.move)


def offset(state, plane, depth_bits):
    """[R9.12] Polygon offset of a filled piece."""
    m = float(min(max(abs(plane.Gx), abs(plane.Gy)), 2**62))
    o = rne(state.polygon_offset.factor * m / 65536) + rne(state.polygon_offset.units)
    return to_integer(o, -2**depth_bits, 2**depth_bits)


# ---- Perspective ----------------------------------------------------------------------------


class Perspective:
    """[R9.13] The denominator Q of a piece, line or point."""

    def __init__(self, frame, w):
        self.frame, self.w, self.w_min = frame, w, min(w)
        self.q = frame.plane([to_integer(rne(2.0**30 * (self.w_min / v)), 1, 2**30) for v in w])

    def value(self, values, k, largest_exponent, least_exponent=0):
        """[R9.14] The numerator's plane and its exponent e."""
        most = max(values) - k
        e = next((e for e in range(least_exponent, largest_exponent) if 2.0**e >= most),
                 largest_exponent)
        u = [to_integer(rne((2.0**30 * clamp01((v - k) / 2.0**e)) * (self.w_min / w)), 0, 2**30)
             for v, w in zip(values, self.w)]
        return self.frame.numerator(u, self.q), e


class Projective:
    """[R9.17] The denominator of coordinates with a q of their own."""

    def __init__(self, frame, w, q):
        self.frame, self.w = frame, w
        ratios = [a / b for a, b in zip(q, w)]
        self.H = 0.0
        for ratio in ratios:
            self.H = abs(ratio) if self.H < abs(ratio) else self.H
        self.usable = 0 < self.H < float("inf")
        self.q = frame.plane([self.rounded(r / self.H) if self.usable else 0 for r in ratios])

    @staticmethod
    def rounded(v):
        return to_integer(rne(2.0**30 * v), -2**30, 2**30)

    def value(self, values):
        if not self.usable:
            return self.frame.plane([0] * len(values)), 0
        scaled = [v / w / self.H for v, w in zip(values, self.w)]
        most = 0.0
        for v in scaled:
            most = abs(v) if most < abs(v) else most
        e = next((e for e in range(-60, 61) if 2.0**e >= most), 60)
        return self.frame.plane([self.rounded(v / 2.0**e) for v in scaled]), e


def reciprocal(q, x, y):
    """[R9.15] W, float32, at covered pixels; where Q < 1 any number."""
    return np.float32(1) / np.maximum(q.at(x, y), 1).astype(np.float32)


def quotient(u, W, x, y):
    """[R9.15] u, float32."""
    return u.at(x, y).astype(np.float32) * W


def slopes(u, q, x, y):
    """[R9.18] In double, at pixels: along rows and along columns."""
    i0, j0 = u.X0 >> u.s, u.Y0 >> u.s

    def narrowed(v):
        return float(np.float32(bounded(float(v), 2.0**62)))

    Ux, Uy, Qx, Qy = (narrowed(v) for v in (u.Gx, u.Gy, q.Gx, q.Gy))
    u0, q0 = narrowed(u.at_pixel(i0, j0)), narrowed(q.at_pixel(i0, j0))
    A, B = Ux * q0 - u0 * Qx, Uy * q0 - u0 * Qy
    K = float(np.float32((Ux * Qy - Uy * Qx) / 65536))
    return np.abs(A + K * (y - j0)), np.abs(B - K * (x - i0))


def joined_slopes(scaled, exact):
    """[R10.12], [R10.46] Of all coordinates: pairs of slopes and their scale to texels."""
    directions = ([], [])
    for pair, scale in scaled:
        for direction, slope in zip(directions, pair):
            direction.append(slope * scale)
    if not exact:
        return np.maximum.reduce([slope for direction in directions for slope in direction])
    lengths = []
    for direction in directions:
        squares = direction[0] * direction[0]
        for slope in direction[1:]:
            squares = squares + slope * slope
        lengths.append(np.sqrt(squares))
    return np.maximum(*lengths)
