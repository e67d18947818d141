"""The floating horizon: each line of a height field compared with all nearer lines of the surface,
on a picture plane that stands upright along the rows. There lines stay lines, so each nearer one
lies above or below the line on one stretch; hidden is what has nearer lines on both sides."""
from oracle.compare import Near, Oracle, of

SHORTEST = 1e-9  # parts of lines that rounding leaves


class Segment:
    """A line from left to right on the upright plane, with depths that grow away from the eye."""

    def __init__(self, p, q, upright):
        ends = sorted((upright(p), upright(q)), key=lambda e: e[0])
        (self.u0, self.y0, self.depth0), (self.u1, self.y1, self.depth1) = ends
        self.swapped = upright(p)[0] > upright(q)[0]

    def at(self, u):
        s = (u - self.u0) / (self.u1 - self.u0)
        return self.y0 + s * (self.y1 - self.y0)


def union(parts):
    found = []
    for a, b in sorted(parts):
        if found and a <= found[-1][1] + SHORTEST:
            found[-1][1] = max(found[-1][1], b)
        else:
            found.append([a, b])
    return found


class FloatingHorizon(Oracle):
    def __init__(self, run):
        super().__init__(run)
        polygons = run.header["polygons"]
        corners = [p for polygon in polygons for p in polygon["world"]]
        eye = self.camera.eye
        def beyond(axis):
            return max(min(p[axis] for p in corners) - eye[axis],
                       eye[axis] - max(p[axis] for p in corners))
        if self.camera.parallel:
            self.sweep = 2 if abs(self.camera.to_eye[2]) >= abs(self.camera.to_eye[0]) else 0
        else:
            self.sweep = 2 if beyond(2) >= beyond(0) else 0
        lines = {}
        for polygon in polygons:
            world = [tuple(p) for p in polygon["world"]]
            sides = list(zip(world, world[1:] + world[:1]))
            if len(world) == 4:  # the machine's two triangles
                sides.append((world[0], world[2]))
            for p, q in sides:
                lines[min(p, q), max(p, q)] = None
        self.segments = [Segment(p, q, self.upright) for p, q in lines]
        self.segments = [s for s in self.segments if s.u1 - s.u0 > 1e-12]
        low, high = min(s.u0 for s in self.segments), max(s.u1 for s in self.segments)
        self.low, self.step = low, (high - low) / 64 or 1
        self.columns = {}
        for s in self.segments:
            for column in range(self.column(s.u0), self.column(s.u1) + 1):
                self.columns.setdefault(column, []).append(s)

    def column(self, u):
        return int((u - self.low) / self.step)

    def upright(self, p):
        """Across and up on the plane, and the depth behind it."""
        across, axis = 2 - self.sweep, self.sweep
        if self.camera.parallel:
            d = self.camera.to_eye
            t = p[axis] / d[axis]
            return p[across] - t * d[across], p[1] - t * d[1], -t
        eye = self.camera.eye
        depth = abs(p[axis] - eye[axis])
        return (p[across] - eye[across]) / depth, (p[1] - eye[1]) / depth, depth

    def depth(self, s, u):
        """Depths of a line are even in the world, their inverses on the plane of a near eye."""
        t = (u - s.u0) / (s.u1 - s.u0)
        if self.camera.parallel:
            return s.depth0 + t * (s.depth1 - s.depth0)
        return 1 / (1 / s.depth0 + t * (1 / s.depth1 - 1 / s.depth0))

    def hidden(self, line):
        """In parts of the line on the upright plane."""
        above, below = [], []
        near = {id(s): s for c in range(self.column(line.u0), self.column(line.u1) + 1)
                for s in self.columns.get(c, [])}
        width = line.u1 - line.u0
        for s in near.values():
            a, b = max(s.u0, line.u0), min(s.u1, line.u1)
            if b - a < 1e-12 or self.depth(s, (a + b) / 2) > self.depth(line, (a + b) / 2) - 1e-9:
                continue
            over_a, over_b = s.at(a) - line.at(a), s.at(b) - line.at(b)
            size = 1e-12 * (abs(s.at(a)) + abs(s.at(b)) + 1)
            over_a, over_b = (0 if abs(v) < size else v for v in (over_a, over_b))
            cut = a + over_a / (over_a - over_b) * (b - a) if over_a * over_b < 0 else None
            for over, into in ((1, above), (-1, below)):
                if over * over_a > 0 or over * over_b > 0:
                    first = a if over * over_a > 0 or cut is None else cut
                    last = b if over * over_b > 0 or cut is None else cut
                    into.append(((first - line.u0) / width, (last - line.u0) / width))
        both = []
        for a, b in union(above):
            both += [(max(a, c), min(b, d)) for c, d in union(below) if max(a, c) < min(b, d)]
        return union(both)

    def on_line(self, p, q, line, s):
        """From a part of the line on the upright plane to one of the drawn line."""
        if self.camera.parallel:
            return s
        s = s * line.depth0 / ((1 - s) * line.depth1 + s * line.depth0)
        a, b = self.camera.distance(p), self.camera.distance(q)
        return s * b / ((1 - s) * a + s * b)

    @of("horizon visible", "horizon hidden", "horizon parts")
    def line(self, said):
        world = self.run.polygons[int(said.pieces[0])]["world"]
        def corner(q):
            return min(world, key=lambda p: sum(
                abs(a - b) for a, b in zip(self.camera.on_grid(p)[:2], q)))
        p, q = corner(said.line["from"]), corner(said.line["to"])
        if p == q:
            return "the line is not of its polygon"
        line = Segment(p, q, self.upright)
        found = {"heights": [Near(self.upright(p)[1]), Near(self.upright(q)[1])]}
        if line.u1 - line.u0 < 1e-12:
            return found  # seen end on
        if line.swapped:
            return "the line is drawn from right to left"
        visible, since = [], 0
        for a, b in self.hidden(line) + [[1, 1]]:
            if a - since > SHORTEST:
                visible += [since, a]
            since = b
        result = "hidden" if not visible else "visible" if visible == [0, 1] else "parts"
        if result != said.result:
            return f"visible is {visible}"
        found["visible"] = [Near(self.on_line(p, q, line, s), 1e-7) for s in visible]
        return found
