"""Faces on the window grid in exact arithmetic: which pixels they cover, how deep they are there.
The rules are those of docs/step_logs.md: a pixel is its centre; y grows downwards; a centre on a
left or a top side is inside. Depths as the depth plane stores them follow R9.6 and R9.8 of
docs/manual/rasterization.md, whose Y grows upwards."""
from fractions import Fraction


def turn(a, b, c):
    """Twice the area of a triangle; above 0 if it turns clockwise on the screen."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def exact(loop):
    """Corners of a log's outline; whole numbers stay integers."""
    return [tuple(int(v) if v == int(v) else Fraction(v) for v in p) for p in loop]


def ceil_div(a, b):
    return -(-a // b)


def edge_pixels(loops, y, unit):
    """For each side across the middle of row y: the first pixel whose centre is not left of it."""
    middle, half = y * unit + unit // 2, unit // 2
    found = []
    for loop in loops:
        for a, b in zip(loop, loop[1:] + loop[:1]):
            if a[1] == b[1]:
                continue
            if a[1] > b[1]:
                a, b = b, a
            if a[1] <= middle < b[1]:
                rise = b[1] - a[1]
                at = (a[0] - half) * rise + (b[0] - a[0]) * (middle - a[1])
                found.append(ceil_div(at, rise * unit) if isinstance(at, int) else
                             ceil_div(Fraction(at) / (rise * unit), 1))
    return sorted(int(x) for x in found)


def rows_of(loops, height, unit):
    """The rows whose middles the loops reach."""
    ys = [p[1] for loop in loops for p in loop]
    if not ys:
        return range(0)
    first = ceil_div(Fraction(min(ys)) - unit // 2, unit)
    last = ceil_div(Fraction(max(ys)) - unit // 2, unit)
    return range(max(int(first), 0), min(int(last), height))


def runs(loops, size, unit):
    """{row: [(first pixel, pixel after the last), ...]} of the area inside the loops."""
    found = {}
    for y in rows_of(loops, size[1], unit):
        x = edge_pixels(loops, y, unit)
        in_row = []
        for a, b in zip(x[::2], x[1::2]):
            a, b = max(a, 0), min(b, size[0])
            if a < b:
                in_row.append((a, b))
        if in_row:
            found[y] = in_row
    return found


def joined(loops, size, unit):
    """The runs of several loops that share sides but no area: triangles of one polygon."""
    rows = {}
    for loop in loops:
        for y, found in runs([loop], size, unit).items():
            rows.setdefault(y, []).extend(found)
    return {y: sorted(found) for y, found in rows.items()}


class Plane:
    """z = (x X + y Y + c) / n at a point of the grid, n > 0; all integers."""

    def __init__(self, loop):
        a, b, c = loop[0], loop[1], loop[2]
        for k in range(2, len(loop)):
            b, c = loop[k - 1], loop[k]
            if turn(a, b, c) != 0:
                break
        u, v = [b[i] - a[i] for i in range(3)], [c[i] - a[i] for i in range(3)]
        nx, ny, nz = u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]
        if nz < 0:
            nx, ny, nz = -nx, -ny, -nz
        self.x, self.y, self.n = -nx, -ny, nz
        self.c = nx * a[0] + ny * a[1] + nz * a[2]

    def scaled(self, x, y):
        return self.x * x + self.y * y + self.c

    def at(self, x, y):
        return Fraction(self.scaled(x, y)) / self.n


class StoredDepth:
    """The depths of a triangle as the depth plane stores them."""

    def __init__(self, triangle, header):
        self.unit, self.depth = header["unit"], header["depth"]
        self.shift = 16 + self.unit.bit_length() - 1
        p = [(x, -y, z) for x, y, z in triangle]  # Y upwards
        p.sort(key=lambda q: (q[1], q[0]))
        if turn(*p) < 0:
            p[1], p[2] = p[2], p[1]
        self.p0 = p[0]
        (dx1, dy1, da1), (dx2, dy2, da2) = ([q[i] - p[0][i] for i in range(3)] for q in p[1:])
        area = dx1 * dy2 - dx2 * dy1
        self.gx = round(Fraction((da1 * dy2 - da2 * dy1) << self.shift, area))
        self.gy = round(Fraction((da2 * dx1 - da1 * dx2) << self.shift, area))

    def at(self, x, y):
        """At the centre of pixel x of row y from the top."""
        half = self.unit // 2
        px, py = x * self.unit + half, -(y * self.unit + half)
        step = (self.gx * (px - self.p0[0]) + self.gy * (py - self.p0[1])) // self.unit
        return min(max((self.p0[2] * 65536 + 32768 + step) >> 16, 0), self.depth)


class Face:
    """A plane convex face of the header. `place`: of equal depths the first is seen."""

    def __init__(self, name, polygon, place, loop, header):
        self.name, self.polygon, self.place = name, polygon, place
        self.loop = exact(loop)
        self.plane = Plane(self.loop)
        self.size, self.unit = header["size"], header["unit"]
        z = [p[2] for p in self.loop]
        self.nearest, self.farthest = min(z), max(z)
        self.runs = {y: found[0] for y, found in runs([self.loop], self.size, self.unit).items()}

    def scaled(self, x, y):
        return self.plane.scaled(x * self.unit + self.unit // 2, y * self.unit + self.unit // 2)

    def z(self, x, y):
        return self.scaled(x, y) / self.plane.n

    def covers(self, x, y):
        run = self.runs.get(y)
        return run is not None and run[0] <= x < run[1]

    def is_nearer(self, other, x, y):
        a = self.scaled(x, y) * other.plane.n
        b = other.scaled(x, y) * self.plane.n
        return (a, self.place) < (b, other.place)


def faces_of(header):
    """Those that the algorithms of the window compare, in the scene's order."""
    faces = []
    for polygon in header["polygons"]:
        for piece in polygon["pieces"]:
            for loop in piece["outline"]:
                faces.append(Face(piece["name"], polygon["id"], len(faces), loop, header))
    return faces


def triangles_of(polygon):
    """The polygon's triangles on the grid: those of its outline, fans of larger loops."""
    found = []
    for loop in map(exact, polygon["outline"]):
        found += [(loop[0], b, c) for b, c in zip(loop[1:], loop[2:]) if turn(loop[0], b, c) != 0]
    return found


def nearest(faces, x, y):
    best = None
    for face in faces:
        if face.covers(x, y) and (best is None or face.is_nearer(best, x, y)):
            best = face
    return best


def count(rows):
    return sum(b - a for found in rows.values() for a, b in found)
