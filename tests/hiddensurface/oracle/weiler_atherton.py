"""Weiler and Atherton: depths of regions before and behind the clip polygon, the pixels of the
regions that are left. Regions are those of the steps; their areas are proved here: a cut leaves
nothing out and adds nothing."""
from fractions import Fraction

from oracle.compare import Near, Oracle, of
from oracle.raster import faces_of

NUDGE = Fraction(1, 2**24), Fraction(1, 2**44)  # right and down: left and top sides are inside


def area(loops):
    return sum(a[0] * b[1] - b[0] * a[1] for loop in loops
               for a, b in zip(loop, loop[1:] + loop[:1])) / 2


def inside(loops, x, y):
    """Even and odd crossings; no side runs through the point."""
    odd = False
    for loop in loops:
        for a, b in zip(loop, loop[1:] + loop[:1]):
            if (a[1] > y) != (b[1] > y):
                at = (x - a[0]) * (b[1] - a[1]) - (y - a[1]) * (b[0] - a[0])
                odd ^= (at > 0) == (b[1] > a[1])
    return odd


def outside_by(loop, p):
    """How far a point is outside a convex loop; below 0: inside."""
    sign = 1 if area([loop]) > 0 else -1
    far = -1e9
    for a, b in zip(loop, loop[1:] + loop[:1]):
        length = ((b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2) ** 0.5
        turn = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
        far = max(far, -sign * turn / length)
    return far


def clipped(loops, clip):
    """The corners of the loops within a convex loop, and the points where their sides cross it."""
    sign = 1 if area([clip]) > 0 else -1
    for a, b in zip(clip, clip[1:] + clip[:1]):
        def side(p):
            return sign * ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]))
        rest = []
        for loop in loops:
            kept = []
            for p, q in zip(loop, loop[1:] + loop[:1]):
                at_p, at_q = side(p), side(q)
                if at_p >= 0:
                    kept.append(p)
                if (at_p > 0 > at_q) or (at_p < 0 < at_q):
                    t = Fraction(at_p) / (at_p - at_q)
                    kept.append((p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])))
            rest.append(kept)
        loops = rest
    return loops


class WeilerAtherton(Oracle):
    def __init__(self, run):
        super().__init__(run)
        self.faces = {face.name: face for face in faces_of(run.header)}
        self.regions = {name: [face.loop] for name, face in self.faces.items()}
        self.painted, self.cut = set(), None

    def face(self, name):
        return self.faces[name.rstrip("ab")]

    @of("nearest-corner sorted")
    def order(self, said):
        return {"z": [self.face(name).nearest for name in said.pieces]}

    @of("split outline")
    def outline(self, said):
        name, clip = said.pieces[0], self.face(said.pieces[1]).loop
        parent, self.cut = self.regions[name], (name + "a", said.pieces[1])
        halves = [piece["outline"] for piece in said.made]
        self.regions[name + "a"], self.regions[name + "b"] = halves
        if abs(sum(map(area, halves)) - area(parent)) > 1e-5 * max(1, abs(area(parent))):
            return f"areas {area(parent)} and {list(map(area, halves))}"
        own = self.face(name).loop
        for p in (p for half in halves for loop in half for p in loop):
            if outside_by(own, p) > 1e-5:
                return f"{p} is outside its face"
        if any(outside_by(clip, p) > 1e-5 for loop in halves[0] for p in loop):
            return "the inner part is not inside the outline"
        if any(outside_by(clip, p) < -1e-5 for loop in halves[1] for p in loop):
            return "the outer part is not outside the outline"
        return {}

    def depths(self, name, clip):
        """Behind the clip polygon, at the corners of the region."""
        p, q = self.face(name).plane, self.face(clip).plane
        found = []
        loops = [[(Fraction(c[0]), Fraction(c[1])) for c in loop] for loop in self.regions[name]]
        if self.cut != (name, clip):  # only what has no area is outside, and is left out
            loops = clipped(loops, self.face(clip).loop)
        for loop in loops:
            for x, y in loop:
                found.append(float(p.at(x, y) - q.at(x, y)))
        return found

    @of("inside hidden", "inside before", "inside pierces")
    def compare(self, said):
        name, clip = said.pieces
        found = self.depths(name, clip)
        low, high = min(found + [0]), max(found + [0])
        if abs(low) < 1e-3 > abs(high):
            right = said.result  # one plane: the scene's first is before
        else:
            right = ("hidden" if low > -1e-3 else "before" if high < 1e-3 else "pierces")
        if said.result != right:
            return f"from {low} to {high} behind"
        return {"nearest": Near(low, 1e-3), "farthest": Near(high, 1e-3)}

    @of("split pierced")
    def pierced(self, said):
        name = said.pieces[0]
        before, piece = self.regions[name], said.made[0]
        self.cut = piece["name"], said.pieces[1]
        self.regions[piece["name"]] = piece["outline"]
        if max(self.depths(piece["name"], said.pieces[1])) > 1e-3 * self.header["depth"]:
            return "part of it is behind"
        if not 0 < area(piece["outline"]) / area(before) < 1:
            return "the part before is not a part"
        return {}

    @of("draw unhidden")
    def draw(self, said):
        loops, face, pixels = self.regions[said.pieces[0]], self.face(said.pieces[0]), 0
        loops = [[(Fraction(p[0]), Fraction(p[1])) for p in loop] for loop in loops]
        ys = [p[1] for loop in loops for p in loop]
        for y, (a, b) in face.runs.items():
            middle = y * self.unit + self.unit // 2
            if not ys or not min(ys) - 1 <= middle <= max(ys) + 1:
                continue
            for x in range(a * self.unit + self.unit // 2, b * self.unit, self.unit):
                pixels += inside(loops, x + NUDGE[0], middle + NUDGE[1])
        for y, a, b, _ in said.painted:
            for x in range(a, b):
                if (x, y) in self.painted:
                    return f"pixel {x}, {y} is drawn twice"
                self.painted.add((x, y))
        return {"pixels": pixels}

    def finish(self):
        covered = {(x, y) for face in self.faces.values() for y, (a, b) in face.runs.items()
                   for x in range(a, b)}
        return [] if covered == self.painted else ["not every pixel is drawn"]
