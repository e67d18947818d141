"""The algorithms that compare depths as the depth plane stores them: the Z-buffer at polygons and
pixels, and the lecture's scan line. Ray casting compares exact depths."""
from oracle.compare import Near, Oracle, of, window
from oracle.raster import Plane, StoredDepth, rows_of, runs, triangles_of
from oracle.scan_lines import merged


class Triangle:
    def __init__(self, corners, order, polygon, header):
        self.corners, self.order, self.polygon = corners, order, polygon
        self.depth = StoredDepth(corners, header)
        self.rows = {y: found[0] for y, found in
                     runs([corners], header["size"], header["unit"]).items()}

    def covers(self, x, y):
        run = self.rows.get(y)
        return run is not None and run[0] <= x < run[1]


def all_triangles(header):
    """In the order in which the machine draws them."""
    found = []
    for polygon in header["polygons"]:
        for corners in triangles_of(polygon):
            found.append(Triangle(corners, len(found), polygon["id"], header))
    return found


class ZBuffer(Oracle):
    def __init__(self, run):
        super().__init__(run)
        self.of = {}
        for triangle in all_triangles(run.header):
            self.of.setdefault(triangle.polygon, []).append(triangle)
        self.stored = {}
        self.pixels = self.in_order()

    def fragments(self, polygon):
        """From the top of each triangle, left to right: x, y, z."""
        for triangle in self.of.get(polygon, []):
            for y, (a, b) in triangle.rows.items():
                for x in range(a, b):
                    yield x, y, triangle.depth.at(x, y)

    @of("z-buffer all", "z-buffer some", "z-buffer none")
    def polygon(self, said):
        tested = passed = 0
        for x, y, z in self.fragments(int(said.pieces[0])):
            tested += 1
            if z < self.stored.get((x, y), self.header["depth"]):
                self.stored[x, y] = z
                passed += 1
        if said.result != ("all" if passed == tested else "some" if passed else "none"):
            return f"{passed} of {tested} pass"
        return {"tested": tested, "passed": passed}

    def in_order(self):
        for polygon in self.of:
            for x, y, z in self.fragments(polygon):
                yield str(polygon), x, y, z

    @of("z nearer", "z not-nearer")
    def pixel(self, said):
        name, x, y, z = next(self.pixels)
        stored = self.stored.get((x, y), self.header["depth"])
        if [name] != said.pieces or said.result != ("nearer" if z < stored else "not-nearer"):
            return f"{name} has z {z} at {x}, {y}, stored is {stored}"
        self.stored[x, y] = min(z, stored)
        return {"z": z, "Z": stored, **window(x, y, 1)}


class RayCasting(Oracle):
    def __init__(self, run):
        super().__init__(run)
        self.triangles = all_triangles(run.header)
        for triangle in self.triangles:
            triangle.plane = Plane(triangle.corners)
        self.pixels = ((x, y) for y in range(self.size[1]) for x in range(self.size[0]))
        self.row = []

    @of("ray background", "ray one", "ray nearest")
    def ray(self, said):
        x, y = next(self.pixels)
        half = self.unit // 2
        hits = sorted((t.plane.at(x * self.unit + half, y * self.unit + half), t.order, t.polygon)
                      for t in self.triangles if t.covers(x, y))
        if [str(id) for _, _, id in hits] != said.pieces:
            return f"the ray meets {hits}"
        self.y = y
        self.row.append(hits[0][2] if hits else None)
        return {"z": [Near(float(z), 1e-6) for z, _, _ in hits], "tested": len(self.triangles),
                **window(x, y, 1)}

    @of("draw line")
    def line(self, said):
        found, self.row = merged(self.row[-self.size[0]:]), []
        return {"spans": found, **window(0, self.y, self.size[0])}


class ScanLine(Oracle):
    def __init__(self, run):
        super().__init__(run)
        self.parts = {}  # by name: the triangles of a plane part
        self.triangles = all_triangles(run.header)
        names = {name for s in run.steps if s["test"] == "edge-table" for name in s["pieces"]}
        for triangle in self.triangles:
            name, part = str(triangle.polygon), 1
            while name not in names and f"{triangle.polygon}.{part}" in self.parts:
                part += 1
            if name not in names:
                name = f"{name}.{part}"
            self.parts.setdefault(name, []).append(triangle)
        self.segments = {}  # by row: (name, first pixel, pixel after the last)
        for name, triangles in self.parts.items():
            for y in range(self.size[1]):
                found = []
                for a, b in sorted(t.rows[y] for t in triangles if y in t.rows):
                    if found and found[-1][2] == a:
                        found[-1] = name, found[-1][1], b
                    else:
                        found.append((name, a, b))
                if found:
                    self.segments.setdefault(y, []).extend(found)
        self.rows = iter(sorted(self.segments))
        self.spans = iter(())

    def at(self, name, x, y):
        """z and order of the part at a pixel."""
        triangle = next(t for t in self.parts[name] if t.covers(x, y))
        return triangle.depth.at(x, y), triangle.order

    @of("edge-table filled")
    def table(self, said):
        tops = {}
        for name, triangles in self.parts.items():
            tops[name] = min((rows[0] for rows in (rows_of([t.corners], self.size[1], self.unit)
                                                   for t in triangles) if rows), default=None)
        rows = [tops[name] for name in said.pieces]
        if rows != sorted(rows) or {n for n in tops if tops[n] is not None} != set(said.pieces):
            return f"the first rows are {tops}"
        return {"rows": rows}

    @of("active-edges segments")
    def active(self, said):
        y = next(self.rows)
        found = sorted(self.segments[y])
        if sorted(said.pieces) != [name for name, _, _ in found]:
            return f"the segments are {found}"
        ends = sorted({x for _, a, b in found for x in (a, b)})
        self.spans = ((y, a, b, {n for n, first, last in found if first <= a and b <= last})
                      for a, b in zip(ends, ends[1:]))
        x0, x1, left = [], [], list(found)
        for name in said.pieces:
            segment = next(s for s in left if s[0] == name)
            left.remove(segment)
            x0.append(segment[1])
            x1.append(segment[2] - 1)
        return {"x0": x0, "x1": x1, **window(0, y, self.size[0])}

    @of("span one", "span one-nearest", "span they-cross")
    def span(self, said):
        y, a, b, over = next((s for s in self.spans if s[3]), (0, 0, 0, set()))
        if over != set(said.pieces):
            return f"over the span are {over}"
        nearest = {min(over, key=lambda name: self.at(name, x, y)) for x in range(a, b)}
        if said.result != "they-cross" and len(nearest) > 1:
            return f"nearest are {nearest}"
        return {"z_left": [self.at(name, a, y)[0] for name in said.pieces],
                "z_right": [self.at(name, b - 1, y)[0] for name in said.pieces],
                **window(a, y, b - a)}

    @of("draw line")
    def line(self, said):
        if any(s[3] for s in self.spans):
            return "spans are missing"
        y, ids = said.window[1], []
        for x in range(self.size[0]):
            over = [name for name, a, b in self.segments[y] if a <= x < b]
            best = min(over, key=lambda name: self.at(name, x, y), default=None)
            ids.append(best and best.split(".")[0])
        return {"spans": merged(ids), **window(0, y, self.size[0])}

    def finish(self):
        return ["rows are missing"] if next(self.rows, None) is not None else []
