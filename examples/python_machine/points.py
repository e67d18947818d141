"""[R9.31], [R9.32] Sizes of points by distance, and sprites."""
import math

import numpy as np

from .numbers import bounded


def size_at(state, point):
    """[R9.31] point: in eye space. Python's floats are float64; the result is a float32."""
    p, (x, y, z) = state.point_parameters, point
    d = bounded(math.sqrt((x * x + y * y) + z * z), 2.0**200)
    by = (p.constant + p.linear * d) + p.quadratic * (d * d)
    size = state.point_size * math.sqrt(1 / by) if by > 0 else p.max_size
    return float(np.float32(min(max(size, p.min_size), p.max_size)))


def gradient(size):
    """[R9.32] No tie exists."""
    return (2**46 + size // 2) // size


class SpritePlanes:
    """[R9.32] Q, and U of s, t and r."""

    def __init__(self, frame, size, one_dimensional):
        self.q = frame.sloped_plane(2**30, 0, 0)
        g = gradient(size)
        t = (0, 0, 0) if one_dimensional else (2**29, 0, -g)
        self.of = [frame.sloped_plane(*v) for v in ((2**29, g, 0), t, (0, 0, 0))]
