"""Chapter 7: polygons of more than three corners become triangles. All decisions are exact."""
from fractions import Fraction

from .numbers import cross


def projected(corners):
    """[R7.1] The corners seen along an axis, as pairs of floats."""
    normal, magnitude = (0.0,) * 3, (0.0,) * 3
    first = corners[0]
    for i in range(1, len(corners) - 1):
        c = cross(minus(corners[i], first), minus(corners[i + 1], first))
        normal = tuple(a + b for a, b in zip(normal, c))
        magnitude = tuple(a + abs(b) for a, b in zip(magnitude, c))
    v = magnitude if all(x == 0 for x in normal) else tuple(abs(x) for x in normal)
    axis = 2 if v[2] >= v[0] and v[2] >= v[1] else 1 if v[1] >= v[0] else 0
    first_axis, second_axis = (axis + 1) % 3, (axis + 2) % 3
    if not normal[axis] >= 0:
        first_axis, second_axis = second_axis, first_axis
    return [(p[first_axis], p[second_axis]) for p in corners]


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def triangulated(corners):
    """The triangles of a polygon as triples of ordinals of its corners."""
    polygon = Polygon(projected(corners))
    if polygon.is_convex():
        return [(0, i, i + 1) for i in range(1, len(corners) - 1)]
    return polygon.clip_ears()


def edges_of(triangle, corner_count):
    """[R7.9] Which of the three sides are sides of the polygon."""
    return tuple(triangle[(k + 1) % 3] == (triangle[k] + 1) % corner_count for k in range(3))


class Polygon:
    def __init__(self, points):
        self.float_points = points
        # Multiplied by 2^149, every float32 is an integer: products are exact.
        self.points = [tuple(int(Fraction(v) * 2**149) for v in p) for p in points]
        self.count = len(points)

    def orient(self, a, b, c):
        """[R7.2] Of three corners by number: 1 for a turn to the left."""
        (ax, ay), (bx, by), (cx, cy) = (self.points[i] for i in (a, b, c))
        value = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        return (value > 0) - (value < 0)

    def is_convex(self):
        """[R7.3]"""
        n, q = self.count, self.points
        if any(q[i] == q[(i + 1) % n] for i in range(n)):
            return False
        if any(self.orient(i, (i + 1) % n, (i + 2) % n) < 0 for i in range(n)):
            return False
        # Pairs compare by x, then by y: rightward is `<`.
        rightward = [q[i] < q[(i + 1) % n] for i in range(n)]
        if sum(rightward[i] != rightward[(i + 1) % n] for i in range(n)) != 2:
            return False
        return all(self.orient(0, i, i + 1) > 0 for i in range(1, n - 1))

    def clip_ears(self):
        """[R7.4]"""
        n = self.count
        self.next = [(i + 1) % n for i in range(n)]
        self.previous = [(i - 1) % n for i in range(n)]
        self.turn = [self.orient(self.previous[i], i, self.next[i]) for i in range(n)]
        self.reflex = {i for i in range(n) if self.turn[i] <= 0}
        self.head, self.left, self.triangles = 0, n, []
        for cut in ("Ear", "TouchingEar", "Flat", "Convex", "Any"):
            passes = 0
            while self.left > 3 and passes < 8:
                before = self.left
                self.run_pass(cut)
                if self.left == before:
                    break
                passes = 1 if self.left < before // 2 else passes + 1
        self.triangles.append((self.previous[self.head], self.head, self.next[self.head]))
        return self.triangles

    def ring(self):
        corner = self.head
        for _ in range(self.left):
            yield corner
            corner = self.next[corner]

    def run_pass(self, cut):
        """[R7.5]"""
        queue = list(self.ring())
        latest = {corner: place for place, corner in enumerate(queue)}
        place = -1
        while place + 1 < len(queue) and self.left > 3:
            place += 1
            corner = queue[place]
            if latest.get(corner) != place or not self.may_cut(corner, cut):
                continue
            p, n = self.previous[corner], self.next[corner]
            self.triangles.append((p, corner, n))
            self.next[p], self.previous[n] = n, p
            self.reflex.discard(corner)
            del latest[corner]
            for k in (p, n):
                self.turn[k] = self.orient(self.previous[k], k, self.next[k])
                if self.turn[k] > 0:
                    self.reflex.discard(k)
            self.head = n
            self.left -= 1
            for k in (p, n):
                latest[k] = len(queue)
                queue.append(k)

    def may_cut(self, corner, cut):
        """[R7.6]"""
        if cut == "Any":
            return True
        if self.turn[corner] == 0:
            return cut in ("Flat", "Convex")
        if self.turn[corner] < 0:
            return False
        return cut == "Convex" or self.is_ear(corner, strict=cut == "Ear")

    def is_ear(self, corner, strict):
        t = (self.previous[corner], corner, self.next[corner])
        others = self.reflex - set(t)
        if any(self.in_the_way(t, k, strict) for k in others):
            return False
        if any(self.points[k] == self.points[corner] for k in others):
            return self.encloses(t)
        return True

    def in_the_way(self, t, k, strict):
        """[R7.7]"""
        a, b, d = (self.orient(t[i], t[(i + 1) % 3], k) for i in range(3))
        if a < 0 or b < 0 or d < 0:
            return False
        if a > 0 and b > 0 and d > 0:
            return True
        if strict and d == 0 and a > 0 and b > 0:
            return True
        return self.enters(t, k, self.previous[k]) or self.enters(t, k, self.next[k])

    def enters(self, t, start, to):
        for i in range(3):
            if self.points[start] == self.points[t[i]]:
                return (self.orient(t[i], t[(i + 1) % 3], to) > 0
                        and self.orient(t[(i + 2) % 3], t[i], to) > 0)
        for i in range(3):
            if self.orient(t[i], t[(i + 1) % 3], start) == 0:
                return self.orient(t[i], t[(i + 1) % 3], to) > 0
        return False

    def encloses(self, t):
        """[R7.8] In doubles."""
        q = self.float_points
        m = tuple(((q[t[0]][axis] + q[t[1]][axis]) + q[t[2]][axis]) / 3 for axis in (0, 1))
        winding = 0
        for k in self.ring():
            ax, ay = minus(q[k], m)
            bx, by = minus(q[self.next[k]], m)
            side = ax * by - ay * bx
            if ay <= 0 and by > 0 and side > 0:
                winding += 1
            if by <= 0 and ay > 0 and side < 0:
                winding -= 1
        return winding > 0
