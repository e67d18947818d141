"""Roberts: convex solids and flat pieces as bodies, and the part of each line that a body hides,
in the world; then as parts of the drawn line."""
from oracle.compare import Near, Oracle, of
from oracle.pieces import is_convex
from oracle.raster import triangles_of
from oracle.vectors import cross, dot, minus, normal, plane_through, side

LARGEST = 4096  # facets of a solid
SHORTEST = 1e-9  # parts of lines that rounding leaves


def middle(loop):
    return [sum(v) / len(loop) for v in zip(*loop)]


class Roberts(Oracle):
    def __init__(self, run):
        super().__init__(run)
        polygons = run.header["polygons"]
        self.tolerance = 1e-6 * max(abs(v) for p in polygons for q in p["world"] for v in q)
        self.bodies = []  # (planes, number of the solid or None)
        self.sides = []   # p, q, polygon, solid, whether both its faces look away
        done, solids = set(), 0
        for figure in self.figures(polygons):
            facets = [facet for polygon in figure for facet in self.facets(polygon)]
            body, fronts = self.solid(facets)
            if body:
                self.bodies.append((body, solids))
            else:
                for _, parts, plane in facets:
                    self.bodies += [(self.flat(loop, plane), None) for loop in parts
                                    if abs(self.towards(plane)) > self.tolerance]
            for polygon in figure:
                world = [tuple(p) for p in polygon["world"]]
                for p, q in zip(world, world[1:] + world[:1]):
                    key = polygon["part"], min(p, q), max(p, q)
                    if p != q and key not in done:
                        done.add(key)
                        back = body is not None and not any(fronts[frozenset((p, q))])
                        self.sides.append((p, q, polygon["id"], solids if body else None, back))
            solids += body is not None
        self.steps = self.all_steps()

    def figures(self, polygons):
        """Polygons of one part that are connected by corners, in the scene's order."""
        parent = list(range(len(polygons)))
        def root(i):
            while parent[i] != i:
                i = parent[i]
            return i
        first = {}
        for i, polygon in enumerate(polygons):
            for p in polygon["world"]:
                other = root(first.setdefault((polygon["part"], *p), i))
                mine = root(i)
                parent[max(mine, other)] = min(mine, other)
        found = {}
        for i, polygon in enumerate(polygons):
            found.setdefault(root(i), []).append(polygon)
        return [found[i] for i in sorted(found)]

    def facets(self, polygon):
        """(polygon, convex loops, plane) of each plane part."""
        world = polygon["world"]
        n = normal(world)
        size = max(abs(v) for p in world for v in p)
        off = max(abs(dot(n, minus(p, world[0]))) for p in world)
        plane = off <= 1e-6 * size * dot(n, n) ** 0.5
        if plane and is_convex(world):
            return [(polygon["id"], [world], plane_through(world))]
        grid = [self.camera.on_grid(p) for p in world]
        loops = [[min(world, key=lambda p: sum(abs(a - b) for a, b in zip(
                  grid[world.index(p)], q))) for q in t] for t in triangles_of(polygon)]
        if plane:
            return [(polygon["id"], loops, plane_through(world))]
        return [(polygon["id"], [loop], plane_through(loop)) for loop in loops]

    def towards(self, plane):
        """How far the eye is before the plane; parallel: with the whole vector to the eye."""
        if not self.camera.parallel:
            return side(plane, self.camera.eye)
        view = self.header["view"]
        return dot(plane, minus(view["eye"], view["at"]))

    def solid(self, facets):
        """Its planes if the facets are those of a closed convex solid seen from outside, and which
        facets at each side look at the eye."""
        if not 4 <= len(facets) <= LARGEST or any(len(parts) > 1 for _, parts, _ in facets):
            return None, None
        at = {}
        for i, (_, (loop,), _) in enumerate(facets):
            loop = [tuple(p) for p in loop]
            for p, q in zip(loop, loop[1:] + loop[:1]):
                at.setdefault(frozenset((p, q)), []).append(i)
        if any(len(found) != 2 for found in at.values()):
            return None, None
        inner = middle([middle(loop) for _, (loop,), _ in facets])
        corners = {tuple(p) for _, (loop,), _ in facets for p in loop}
        outward, front = [], []
        for _, _, plane in facets:
            if side(plane, inner) > 0:
                plane = [-v for v in plane]
            if any(side(plane, p) > self.tolerance for p in corners):
                return None, None
            outward.append(plane)
            front.append(self.towards(plane) > self.tolerance)
        if not any(front):
            return None, None
        planes = [[-v for v in plane] for plane, looks in zip(outward, front) if looks]
        for ends, (i, k) in at.items():
            if front[i] != front[k]:
                planes.append(self.contour(*ends, inner))
        return planes, {ends: (front[i], front[k]) for ends, (i, k) in at.items()}

    def contour(self, p, q, inner):
        """The plane through the eye and a side, above 0 where the inner point is."""
        to_eye = self.camera.to_eye if self.camera.parallel else minus(self.camera.eye, p)
        n = cross(minus(q, p), to_eye)
        length = dot(n, n) ** 0.5
        plane = [v / length for v in n]
        plane.append(-dot(plane, p))
        return plane if side(plane, inner) > 0 else [-v for v in plane]

    def flat(self, loop, plane):
        behind = [-v for v in plane] if self.towards(plane) > 0 else plane
        return [behind] + [self.contour(p, q, middle(loop))
                           for p, q in zip(loop, loop[1:] + loop[:1])]

    def hidden(self, planes, p, q):
        part = [0, 1]
        for plane in planes:
            a, b = (0 if abs(d) <= self.tolerance else d for d in (side(plane, p), side(plane, q)))
            if a <= 0 and b <= 0:
                return None
            if a < 0:
                part[0] = max(part[0], a / (a - b))
            if b < 0:
                part[1] = min(part[1], a / (a - b))
            if part[0] >= part[1]:
                return None
        return part

    def drawn(self, p, q, s):
        """The place in the window of a place on the line."""
        if self.camera.parallel:
            return s
        a, b = self.camera.distance(p), self.camera.distance(q)
        return s * b / ((1 - s) * a + s * b)

    def all_steps(self):
        for p, q, polygon, solid, back in self.sides:
            a, b = self.camera.on_grid(p), self.camera.on_grid(q)
            if max(abs(a[0] - b[0]), abs(a[1] - b[1])) < 1e-6:
                continue  # seen end on: not drawn
            hidden, names = [], [str(polygon)]
            for number, (planes, of_solid) in enumerate(self.bodies):
                if back or (solid is not None and solid == of_solid):
                    continue
                part = self.hidden(planes, p, q)
                if part:
                    hidden.append(part)
                    places = [Near(self.drawn(p, q, s)) for s in part]
                    yield ("body", "hides"), names, {"body": number, "hidden": places}, None
            visible, since = [], 0
            for first, last in [] if back else sorted(hidden) + [[1, 1]]:
                if first - since > SHORTEST:
                    visible += [since, first]
                since = max(since, last)
            result = "hidden" if not visible else "visible" if visible == [0, 1] else "parts"
            places = [Near(self.drawn(p, q, s)) for s in visible]
            yield ("bodies", result), names, {"visible": places}, (a, b)

    @of("body hides", "bodies parts", "bodies hidden", "bodies visible")
    def expect(self, said):
        kind, pieces, numbers, ends = next(self.steps, (None,) * 4)
        if kind != (said.test, said.result) or pieces != said.pieces:
            return f"expected is {kind} of {pieces}"
        drawn = (said.line["from"], said.line["to"]) if ends else ()
        if any(abs(v - w) > 1e-3 for p, q in zip(drawn, ends or ()) for v, w in zip(p, q)):
            return f"the line is from {ends[0]} to {ends[1]}"
        return numbers

    def finish(self):
        return ["steps are missing"] if next(self.steps, None) else []
