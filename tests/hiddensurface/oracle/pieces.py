"""Pieces of polygons in the world, cut anew by planes; and the pixels of pieces as drawn."""
import math

from oracle.compare import Between
from oracle.logs import polygon_of
from oracle.raster import Plane, count, exact, joined, turn
from oracle.vectors import cross, dot, minus, normal, plane_through, side


def is_convex(loop):
    n, size = normal(loop), len(loop)
    return all(dot(cross(minus(loop[(i + 1) % size], loop[i]),
                         minus(loop[(i + 2) % size], loop[(i + 1) % size])), n) >= 0
               for i in range(size))


def divide(loops, plane):
    """The parts of convex loops on the side of a plane's normal, and on the other side."""
    front, back = [], []
    for loop in loops:
        halves = [], []
        for a, b in zip(loop, loop[1:] + loop[:1]):
            da, db = side(plane, a), side(plane, b)
            if da >= 0:
                halves[0].append(a)
            if da <= 0:
                halves[1].append(a)
            if (da > 0 > db) or (da < 0 < db):
                t = da / (da - db)
                p = [x + t * (y - x) for x, y in zip(a, b)]
                halves[0].append(p)
                halves[1].append(p)
        for half, into in zip(halves, (front, back)):
            if len(half) > 2:
                into.append(half)
    return front, back


class Pieces:
    def __init__(self, run):
        self.camera, self.size, self.unit = run.camera, run.header["size"], run.header["unit"]
        self.world, self.planes, self.outlines = {}, {}, {}
        self.counted, self.covered = {}, {}
        reach = 0
        for polygon in run.header["polygons"]:
            reach = max([reach] + [abs(v) for p in polygon["world"] for v in p])
            for piece in polygon["pieces"]:
                self.add(polygon, piece, len(polygon["pieces"]) == 1)
        self.tolerance = 1e-6 * reach

    def add(self, polygon, piece, alone):
        name, corners = piece["name"], polygon["world"]
        self.outlines[name] = piece["outline"]
        if alone and is_convex(corners):
            self.world[name] = [corners]
            self.planes[name] = plane_through(corners)
            return
        # Triangles, whose corners are those of the polygon that are nearest on the grid.
        on_grid = [self.camera.on_grid(p) for p in corners]
        def nearest(q):
            return min(range(len(corners)), key=lambda i: dot(minus(on_grid[i], q),
                                                             minus(on_grid[i], q)))
        self.world[name] = [[corners[nearest(q)] for q in loop] for loop in piece["outline"]]
        n = [sum(v) for v in zip(*map(normal, self.world[name]))]
        length = dot(n, n) ** 0.5
        n = [v / length for v in n]
        self.planes[name] = [*n, -dot(n, self.world[name][0][0])]

    def plane(self, name):
        return self.planes[name.rstrip("ab")]

    def corners(self, name):
        return [p for loop in self.world[name] for p in loop]

    def distances(self, name, plane):
        return [side(plane, p) for p in self.corners(name)]

    def behind(self, name, by):
        """Distances behind the plane of a piece, seen from the eye."""
        plane = self.plane(by)
        sign = -1 if self.camera.before(plane) > 0 else 1
        return [sign * d for d in self.distances(name, plane)]

    def cut(self, name, by, made):
        """Cuts the piece in the world. Returns what is wrong with the outlines that were made."""
        front, back = divide(self.world[name], self.plane(by))
        self.world[name + "a"], self.world[name + "b"] = front, back
        for piece in made:
            self.outlines[piece["name"]] = piece["outline"]
        whole, parts = area(self.outlines[name]), sum(area(piece["outline"]) for piece in made)
        if abs(whole - parts) > 1e-5 * max(1, whole):
            return f"an area of {whole} is cut into {parts}"
        planes = [Plane(loop) for loop in map(exact, self.outlines[name.rstrip("ab")])]
        planes = [plane for plane in planes if plane.n > 0]
        for x, y, z in (p for piece in made for loop in piece["outline"] for p in loop):
            off = [abs((plane.x * x + plane.y * y + plane.c) / plane.n - z) for plane in planes]
            if off and min(off) > 1:
                return f"{x}, {y}, {z} is {min(off)} off its polygon"
        return None

    def pixels(self, name):
        """How many a piece as drawn has."""
        sure, unsure = self.pixels_of(name)
        return Between(len(sure), len(sure) + unsure) if unsure else len(sure)

    def pixels_of(self, name):
        """Of a piece as drawn: the polygon's pixels within the piece's outline on the grid, as
        (row, pixel), and the number of those that rounding decides. A centre within a millionth
        of a side is inside if the side is one of the polygon's own; on a cut, nothing can tell."""
        if name not in self.counted:
            loops, whole = self.outlines[name], self.outlines[name.rstrip("ab")]
            own = [side for loop in whole for side in zip(loop, loop[1:] + loop[:1])]
            sure, unsure = [], 0
            for y, x in self.centres(name.rstrip("ab"), loops):
                places = [self.place(loop, own, x, y) for loop in loops]
                if "inside" in places or name[-1] not in "ab":
                    sure.append((y // self.unit, x // self.unit))
                elif "cut" in places:
                    unsure += 1
            self.counted[name] = sure, unsure
        return self.counted[name]

    def centres(self, polygon, loops):
        """The polygon's centres around the loops, as points of the grid."""
        if polygon not in self.covered:
            self.covered[polygon] = joined(list(map(exact, self.outlines[polygon])), self.size,
                                           self.unit)
        corners = [p for loop in loops for p in loop]
        if not corners:
            return
        (left, right), (top, bottom) = ((min(v), max(v)) for v in list(zip(*corners))[:2])
        for y, runs in self.covered[polygon].items():
            middle = y * self.unit + self.unit // 2
            if top - 1 <= middle <= bottom + 1:
                for a, b in runs:
                    for x in range(a * self.unit + self.unit // 2, b * self.unit, self.unit):
                        if left - 1 <= x <= right + 1:
                            yield middle, x

    @staticmethod
    def place(loop, own, x, y):
        """Of a centre: inside, outside, or on a cut of the convex loop."""
        clockwise = sum(turn(loop[0], a, b) for a, b in zip(loop[1:], loop[2:])) > 0
        found = "inside"
        for a, b in zip(loop, loop[1:] + loop[:1]):
            length = math.hypot(b[0] - a[0], b[1] - a[1])
            if length < 1e-9:
                continue
            distance = turn(a, b, (x, y)) / length * (1 if clockwise else -1)
            if distance < -1e-6:
                return "outside"
            if distance < 1e-6 and not any(on_line(a, *s) and on_line(b, *s) for s in own):
                found = "cut"
        return found


def on_line(p, a, b):
    length = math.hypot(b[0] - a[0], b[1] - a[1])
    return length > 0 and abs(turn(a, b, p)) / length < 1e-6


def area(loops):
    return sum(abs(sum(turn(loop[0], a, b) for a, b in zip(loop[1:], loop[2:]))) / 2
               for loop in loops)


def whole(run, name):
    """The pixels of a whole polygon."""
    loops = [loop for loop in run.polygons[polygon_of(name)]["outline"]]
    return count(joined(list(map(exact, loops)), run.header["size"], run.header["unit"]))
