"""Hierarchical Z: the octree's cubes and the polygons, near to far, each asked of a pyramid of
depths. Rows count upwards here, from the bottom, as the pyramid's cells do."""
import math

from oracle.compare import Between, Foretold, of
from oracle.stored_depths import all_triangles

FEW, DEEPEST = 8, 10  # polygons of a cube that is not divided; divisions


class Cube:
    def __init__(self, low, high, polygons, depth=0):
        """Polygons across a middle plane stay; the others go to the eight parts."""
        self.low, self.high, self.polygons, self.parts = low, high, polygons, [None] * 8
        self.middle = [(a + b) / 2 for a, b in zip(low, high)]
        if len(polygons) <= FEW or depth == DEEPEST:
            return
        self.polygons, inside = [], [[] for _ in range(8)]
        for polygon in polygons:
            part = 0
            for axis in range(3):
                upper = {p[axis] >= self.middle[axis] for p in polygon["world"]}
                part = None if part is None or len(upper) > 1 else part | (True in upper) << axis
            (self.polygons if part is None else inside[part]).append(polygon)
        for k, some in enumerate(inside):
            if some:
                a = [self.middle[i] if k >> i & 1 else low[i] for i in range(3)]
                b = [high[i] if k >> i & 1 else self.middle[i] for i in range(3)]
                self.parts[k] = Cube(a, b, some, depth + 1)


class Pyramid:
    def __init__(self, width, height, farthest):
        self.levels = []
        while not self.levels or width > 1 or height > 1:
            if self.levels:
                width, height = (width + 1) // 2, (height + 1) // 2
            self.levels.append([[farthest] * width for _ in range(height)])

    def set(self, x, y, z):
        self.levels[0][y][x] = z
        for below, level in zip(self.levels, self.levels[1:]):
            x, y = x // 2, y // 2
            level[y][x] = max(v for row in below[2 * y:2 * y + 2] for v in row[2 * x:2 * x + 2])

    def ask(self, left, low, width, height, nearest):
        """The cells that are nearer, as (level, z), and the first pixel that is not."""
        right, high = left + width - 1, low + height - 1
        level = 0
        while left >> level != right >> level or low >> level != high >> level:
            level += 1
        todo, cells = [(level, left >> level, low >> level)], []
        while todo:
            level, x, y = todo.pop()
            z = self.levels[level][y][x]
            if z < nearest:
                cells.append((level, z))
            elif level == 0:
                return cells, (x, y, z)
            else:
                down = level - 1
                rows = range(max(2 * y, low >> down), min(2 * y + 1, high >> down) + 1)
                columns = range(max(2 * x, left >> down), min(2 * x + 1, right >> down) + 1)
                todo += [(down, i, j) for j in reversed(rows) for i in reversed(columns)]
        return cells, None


class HierarchicalZ(Foretold):
    def __init__(self, run):
        super().__init__(run)
        self.triangles = {}
        for triangle in all_triangles(run.header):
            self.triangles.setdefault(triangle.polygon, []).append(triangle)
        self.pyramid = Pyramid(*self.size, self.header["depth"])
        self.first = {}
        seen = [p for p in run.header["polygons"] if p["id"] in self.triangles]
        corners = [p for polygon in seen for p in polygon["world"]]
        low, high = ([of(v) for v in zip(*corners)] for of in (min, max))
        self.steps = self.cube(Cube(low, high, seen))

    def cube(self, cube):
        corners = [self.camera.on_grid([(cube.low, cube.high)[k >> i & 1][i] for i in range(3)])
                   for k in range(8)]
        x, y, z = zip(*corners)
        width, height = self.size
        def pixel(v, size, more):
            return min(max(math.floor(v / self.unit) + more, 0), size)
        left, right = pixel(min(x), width, -1), pixel(max(x), width, 2)
        low, high = (pixel(height * self.unit - v, height, more)
                     for v, more in ((max(y), -1), (min(y), 2)))
        # Two units before, since the snap moves depths.
        nearest = [min(max(math.floor(min(z) + more) - 2, 0), self.header["depth"])
                   for more in (-1e-4, 1e-4)]
        hidden = yield from self.question("pyramid-cube", [], (left, low, right - left, high - low),
                                          nearest)
        if hidden:
            return
        for polygon in cube.polygons:
            yield from self.polygon(polygon["id"])
        if self.camera.parallel:
            eye = [e > 0 for e in self.camera.to_eye]
        else:
            eye = [e > m for e, m in zip(self.camera.eye, cube.middle)]
        beside = sum(bit << i for i, bit in enumerate(eye))
        for part in (0, 1, 2, 4, 3, 5, 6, 7):  # across no, one, two, three middle planes
            if cube.parts[part ^ beside]:
                yield from self.cube(cube.parts[part ^ beside])

    def question(self, test, pieces, box, nearest):
        left, low, width, height = box
        if width <= 0 or height <= 0:
            yield (test, "outside"), pieces, {}
            return True
        cells, pixel = self.pyramid.ask(*box, nearest[0])
        shown = nearest[0] if nearest[0] == nearest[1] else Between(*nearest)
        found = {"nearest": shown, "left": left, "width": width, "height": height,
                 "row": self.size[1] - low - height}
        if pixel:
            x, y, z = pixel
            yield (test, "may-be-seen"), pieces, {**found, "pyramid": z, "level": 0, "x": x,
                                                  "y": self.size[1] - 1 - y}
            return False
        found |= {"pyramid": max(z for _, z in cells), "level": min(level for level, _ in cells),
                  "cells": len(cells)}
        yield (test, "hidden" if len(cells) == 1 else "hidden-by-cells"), pieces, found
        return True

    def polygon(self, id):
        corners = [p for t in self.triangles[id] for p in t.corners]
        (x0, x1), (y0, y1) = ((min(v), max(v)) for v in list(zip(*corners))[:2])
        width, height = self.size
        left, right = max(x0 // self.unit, 0), min(x1 // self.unit + 1, width)
        low = max((height * self.unit - y1) // self.unit, 0)
        high = min((height * self.unit - y0) // self.unit + 1, height)
        nearest = min(p[2] for p in corners) - 1
        hidden = yield from self.question("pyramid-polygon", [str(id)],
                                          (left, low, right - left, high - low),
                                          [nearest, nearest])
        if hidden:
            return
        pixels = 0
        for triangle in self.triangles[id]:
            for y, (a, b) in triangle.rows.items():
                for x in range(a, b):
                    z, up = triangle.depth.at(x, y), self.size[1] - 1 - y
                    stored = self.pyramid.levels[0][up][x]
                    if (z, triangle.order) < (stored, self.first.get((x, y), 0)):
                        pixels += 1
                        self.first[x, y] = triangle.order
                        self.pyramid.set(x, up, z)
        if pixels:
            yield ("draw", "nearer"), [str(id)], {"pixels": pixels}

    @of("pyramid-cube hidden", "pyramid-cube hidden-by-cells", "pyramid-cube may-be-seen",
        "pyramid-cube outside", "pyramid-polygon hidden", "pyramid-polygon hidden-by-cells",
        "pyramid-polygon may-be-seen", "pyramid-polygon outside", "draw nearer")
    def expect(self, said):
        return self.next_step(said)
