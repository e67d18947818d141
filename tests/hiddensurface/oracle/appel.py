"""Appel's quantitative invisibility: the number of faces that hide each part of a line, by
comparing it with every triangle in exact fractions; contours and faces that a line passes."""
from fractions import Fraction

from oracle.compare import Near, Oracle, of
from oracle.raster import triangles_of, turn


def sign(v):
    return (v > 0) - (v < 0)


class Triangle:
    """Corners counter-clockwise with y upwards; a plane with n.z above 0."""

    def __init__(self, corners, polygon):
        a, b, c = ((x, -y, z) for x, y, z in corners)
        if turn(a, b, c) < 0:
            b, c = c, b
        self.corners, self.polygon = (a, b, c), polygon
        u, v = [b[i] - a[i] for i in range(3)], [c[i] - a[i] for i in range(3)]
        self.n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                  u[0] * v[1] - u[1] * v[0])
        self.box = [(min(v), max(v)) for v in zip(a, b, c)]

    def behind(self, p):
        return sum(n * (v - v0) for n, v, v0 in zip(self.n, p, self.corners[0]))

    def hides(self, a, b):
        """The part of a -> b behind the triangle, as (from, to), or None. A line along a side
        counts as moved a little to its left."""
        part = [Fraction(0), Fraction(1)]
        for p, q in zip(self.corners, self.corners[1:] + self.corners[:1]):
            at_a, at_b = turn(p, q, a), turn(p, q, b)
            if at_a == at_b == 0:
                at_a = at_b = (q[0] - p[0]) * (b[0] - a[0]) + (q[1] - p[1]) * (b[1] - a[1])
            if not keep(part, at_a, at_b):
                return None
        return tuple(part) if keep(part, self.behind(a), self.behind(b)) else None


def keep(part, at_a, at_b):
    """Shortens a part to where a linear value is above 0. False: nothing is left."""
    if at_a <= 0 and at_b <= 0:
        return False
    if at_a < 0:
        part[0] = max(part[0], Fraction(at_a, at_a - at_b))
    elif at_b < 0:
        part[1] = min(part[1], Fraction(at_a, at_a - at_b))
    return part[0] < part[1]


class Appel(Oracle):
    def __init__(self, run):
        super().__init__(run)
        self.triangles = [Triangle(corners, polygon["id"]) for polygon in run.header["polygons"]
                          for corners in triangles_of(polygon)]
        self.sides = {}  # by both corners, in order: [polygon, faces to the left, to the right]
        number = {}
        for triangle in self.triangles:
            corners = triangle.corners
            for p in corners:
                number.setdefault(p, len(number))
            for p, q in zip(corners, corners[1:] + corners[:1]):
                forward = number[p] < number[q]
                side = self.sides.setdefault((p, q) if forward else (q, p),
                                             [triangle.polygon, 0, 0])
                side[1 if forward else 2] += 1
        self.contours = [(p, q, *side) for (p, q), side in self.sides.items()
                         if side[1] != side[2]]
        self.lines = iter([s for s in run.steps if "line" in s])
        self.passed = None  # contours and faces that the next line passes

    def ends(self, line):
        return [(int(x), -int(y), int(z)) for x, y, z in (line["from"], line["to"])]

    def passes(self, a, b):
        """Contours in front of the line that it passes behind, faces that it goes through."""
        low, high = [min(v) for v in zip(a, b)], [max(v) for v in zip(a, b)]
        for p, q, polygon, left, right in self.contours:
            if (min(p[0], q[0]) > high[0] or max(p[0], q[0]) < low[0] or
                    min(p[1], q[1]) > high[1] or max(p[1], q[1]) < low[1] or {p, q} & {a, b}):
                continue
            at_a, at_b, at_p, at_q = turn(p, q, a), turn(p, q, b), turn(a, b, p), turn(a, b, q)
            if sign(at_a) * sign(at_b) != -1 or sign(at_p) * sign(at_q) != -1:
                continue
            t, u = Fraction(at_a, at_a - at_b), Fraction(at_p, at_p - at_q)
            if p[2] + u * (q[2] - p[2]) < a[2] + t * (b[2] - a[2]):
                yield "contour", polygon, t, right - left if at_a > 0 else left - right
        for triangle in self.triangles:
            if ({a, b} & set(triangle.corners) or
                    any(l > h or m < w for w, h, (l, m) in zip(low, high, triangle.box))):
                continue
            at_a, at_b = triangle.behind(a), triangle.behind(b)
            if sign(at_a) * sign(at_b) != -1:
                continue
            t = Fraction(at_a, at_a - at_b)
            x, y = (v + t * (w - v) for v, w in zip(a[:2], b[:2]))
            c = triangle.corners
            if all(turn(p, q, (x, y)) > 0 for p, q in zip(c, c[1:] + c[:1])):
                yield "pierced", triangle.polygon, t, 1 if at_b > 0 else -1

    def of_next_line(self):
        if self.passed is None:
            self.next_line = next(self.lines)
            self.passed = list(self.passes(*self.ends(self.next_line["line"])))
        return self.passed

    @of("contour more", "contour fewer", "pierced more", "pierced fewer")
    def change(self, said):
        left = self.of_next_line()
        if not left:
            return "the line passes nothing more"
        test, polygon, t, change = left.pop(0)
        result = "more" if change > 0 else "fewer"
        if (test, result) != (said.test, said.result) or said.pieces[1] != str(polygon):
            return f"expected is {test} {result} {polygon} at {float(t)}"
        return {"at": Near(float(t)), "change": change}

    @of("carried visible", "carried hidden", "carried parts", "compared visible",
        "compared hidden", "compared parts")
    def line(self, said):
        left = self.of_next_line()
        self.passed = None
        if self.run.level in ("span", "pixel") and said.test == "carried" and left:
            return f"passes {left} without a step"
        a, b = self.ends(said.line)
        polygon = self.run.polygons[int(said.pieces[0])]
        on_grid = {(int(x), -int(y), int(z)) for loop in polygon["outline"] for x, y, z in loop}
        if not {a, b} <= on_grid:
            return "the line is not of its polygon"
        low, high = [min(v) for v in zip(a, b)], [max(v) for v in zip(a, b)]
        number, changes, hidden = 0, {}, []
        for triangle in self.triangles:
            (x0, x1), (y0, y1), (z0, _) = triangle.box
            if x0 > high[0] or x1 < low[0] or y0 > high[1] or y1 < low[1] or z0 > high[2]:
                continue
            part = triangle.hides(a, b)
            if part is None:
                continue
            number += part[0] == 0
            for t, delta in zip(part, (1, -1)):
                if 0 < t < 1:
                    changes[t] = changes.get(t, 0) + delta
        numbers, places, visible, since = [number], [], [], Fraction(0)
        for t, delta in sorted(changes.items()):
            if delta:
                if number == 0:
                    visible += [since, t]
                number, since = number + delta, t
                numbers.append(number)
                places.append(Near(float(t)))
        if number == 0:
            visible += [since, Fraction(1)]
        result = "hidden" if not visible else "visible" if visible == [0, 1] else "parts"
        if result != said.result:
            return f"numbers {numbers} at {[p.value for p in places]}"
        return {"invisibility": numbers, "changes": places,
                "visible": [Near(float(t)) for t in visible]}
