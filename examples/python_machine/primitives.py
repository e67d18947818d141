"""Chapter 6: the points, lines and triangles of a mesh."""
from dataclasses import dataclass

from .polygons import edges_of, triangulated


@dataclass
class PrimitiveOf:
    """A point, line or triangle: places of its corners in the mesh [R6.2]."""
    corners: tuple
    flat: int
    polygon: int
    edges: tuple = (True, True, True)


def primitives(mesh):
    """[R6.1] to [R6.5] In order."""
    c = mesh.indices if mesh.indices else list(range(len(mesh.positions)))
    n, kind = len(c), mesh.primitive
    if n == 0:
        return
    if kind == "Points":
        for i in range(n):
            yield PrimitiveOf((c[i],), c[i], i)
    elif kind == "Lines":
        for i in range(n // 2):
            yield PrimitiveOf((c[2 * i], c[2 * i + 1]), c[2 * i + 1], i)
    elif kind == "LineStrip":
        for i in range(n - 1):
            yield PrimitiveOf((c[i], c[i + 1]), c[i + 1], i)
    elif kind == "Triangles":
        for i in range(n // 3):
            corners = tuple(c[3 * i:3 * i + 3])
            yield PrimitiveOf(corners, corners[2], i, flagged(mesh, corners, (True,) * 3))
    elif kind == "TriangleStrip":
        for i in range(n - 2):
            order = (i + 1, i, i + 2) if i % 2 == 1 else (i, i + 1, i + 2)
            yield PrimitiveOf(tuple(c[k] for k in order), c[i + 2], i)
    elif kind == "TriangleFan":
        for i in range(n - 2):
            yield PrimitiveOf((c[0], c[i + 1], c[i + 2]), c[i + 2], i)
    elif kind == "Quads":
        for i in range(n // 4):
            yield from polygon_triangles(mesh, c[4 * i:4 * i + 4], c[4 * i + 3], i)
    else:
        start = 0
        for i, size in enumerate(mesh.polygon_sizes or [n]):
            yield from polygon_triangles(mesh, c[start:start + size], c[start], i)
            start += size


def polygon_triangles(mesh, corners, flat, number):
    """[R6.3], [R6.4]"""
    if len(corners) == 3:
        yield PrimitiveOf(tuple(corners), flat, number, flagged(mesh, corners, (True,) * 3))
        return
    for t in triangulated([mesh.positions[i] for i in corners]):
        places = tuple(corners[k] for k in t)
        yield PrimitiveOf(places, flat, number,
                          flagged(mesh, places, edges_of(t, len(corners))))


def flagged(mesh, corners, edges):
    """[R6.29] The sides that edge flags leave."""
    if not mesh.edge_flags:
        return edges
    return tuple(edge and mesh.edge_flags[i] != 0 for edge, i in zip(edges, corners))


def identifier(mesh, polygon):
    """[R6.5]"""
    return mesh.polygon_ids[polygon] if mesh.polygon_ids else polygon
