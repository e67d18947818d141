"""Vectors of three numbers, planes (n, d), and the tolerance of a comparison. Shares no code with
the project's C++."""
import math


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    length = math.sqrt(dot(a, a))
    return [x / length for x in a]


def normal(corners):
    """The vector area of a loop, doubled: summed over triangles at the first corner, since sums
    over sides far from the origin lose digits."""
    n = [0, 0, 0]
    for a, b in zip(corners[1:], corners[2:]):
        n = [x + y for x, y in zip(n, cross(minus(a, corners[0]), minus(b, corners[0])))]
    return n


def plane_through(corners):
    """(n, d) with a normal of length 1."""
    n = unit(normal(corners))
    return [*n, -dot(n, corners[0])]


def side(plane, p):
    """The distance of a point from a plane, above 0 on the normal's side."""
    return plane[0] * p[0] + plane[1] * p[1] + plane[2] * p[2] + plane[3]
