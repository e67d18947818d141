"""Chapter 9: the integer planes of values, at centres and elsewhere."""
from dataclasses import dataclass, replace

import numpy as np


def centers(i, s):
    return (i << s) + (1 << (s - 1))


@dataclass
class IntegerPlane:
    a0: int
    Gx: int
    Gy: int
    X0: int
    Y0: int
    s: int

    def at_pixel(self, i, j):
        """[R9.8] At any one pixel, as an integer of any size."""
        moved = (self.Gx * (int(centers(i, self.s)) - self.X0)
                 + self.Gy * (int(centers(j, self.s)) - self.Y0)) >> self.s
        return (self.a0 * 2**16 + 2**15 + moved) >> 16

    def at(self, x, y):
        """[R9.8] At covered pixels. Their values fit 40 bits, so sums modulo 2^64 give them."""
        dx = (centers(x, self.s) - self.X0).astype(np.uint64)
        dy = (centers(y, self.s) - self.Y0).astype(np.uint64)
        total = np.uint64(self.Gx % 2**64) * dx + np.uint64(self.Gy % 2**64) * dy
        start = np.uint64(((self.a0 * 2**16 + 2**15) << self.s) % 2**64)
        # 64 - s - 16 bits are left, with the sign at the top.
        return (total + start).astype(np.int64) >> (self.s + 16)


@dataclass
class LimitedPlane:
    """[R9.28] A plane limited to the values at the corners."""
    plane: IntegerPlane
    low: int
    high: int

    def __getattr__(self, name):
        return getattr(self.plane, name)

    def at(self, x, y):
        return np.array([max(self.low, min(self.plane.at_pixel(int(i), int(j)), self.high))
                         for i, j in zip(x, y)], np.int64)


@dataclass
class MovedPlane:
    """[R17.8] A plane after a move; what is asked of it elsewhere, such as slopes, has none."""
    plane: IntegerPlane
    dx: int
    dy: int

    def __getattr__(self, name):
        return getattr(self.plane, name)

    def at(self, x, y):
        return replace(self.plane, X0=self.plane.X0 + self.dx, Y0=self.plane.Y0 + self.dy).at(x, y)


@dataclass
class AtMost:
    """[R9.28] A numerator that is at most its denominator."""
    plane: LimitedPlane
    q: LimitedPlane

    def __getattr__(self, name):
        return getattr(self.plane, name)

    def at(self, x, y):
        return np.minimum(self.plane.at(x, y), self.q.at(x, y))
