"""Carpenter's A-buffer: masks of 8 x 4 points a pixel, one of them its middle, and the parts of a
pixel's points that its faces get, by the paper's estimate."""
from fractions import Fraction

from oracle.compare import Near, Oracle, of, window
from oracle.raster import faces_of, runs
from oracle.scan_lines import merged

ACROSS, DOWN = 8, 4


class Fragment:
    def __init__(self, face, mask, x, y):
        """Depths of the plane at the pixel's corners, within those of the face."""
        plane, half = face.plane, face.unit // 2
        middle = plane.at(x * face.unit + half, y * face.unit + half)
        reach = Fraction(abs(plane.x) + abs(plane.y)) * half / plane.n
        self.face, self.mask = face, mask
        self.nearest, self.farthest = (min(max(z, face.nearest), face.farthest)
                                       for z in (middle - reach, middle + reach))


class ABuffer(Oracle):
    def __init__(self, run):
        super().__init__(run)
        self.faces = faces_of(run.header)
        self.masks = [self.masks_of(face) for face in self.faces]
        self.next = iter(zip(self.faces, self.masks))
        self.pixels = self.in_order()
        self.row = {}

    def masks_of(self, face):
        """{(x, y): points}. The points are the centres of a finer raster, whose rows count upwards
        from each pixel's lower side: the face is moved by half a step, up and to the right."""
        width, height = self.size
        half = self.unit // 2
        bottom = height * self.unit * DOWN
        fine = [(ACROSS * p[0] + half, bottom - (DOWN * (height * self.unit - p[1]) + half))
                for p in face.loop]
        found = {}
        size = ACROSS * width, DOWN * height
        for y, in_row in runs([fine], size, self.unit).items():
            up = size[1] - 1 - y
            for a, b in in_row:
                for x in range(a, b):
                    pixel = x // ACROSS, height - 1 - up // DOWN
                    point = up % DOWN * ACROSS + x % ACROSS
                    found[pixel] = found.get(pixel, 0) | 1 << point
        return found

    @of("fragments made")
    def made(self, said):
        face, masks = next(self.next)
        if said.pieces != [face.name]:
            return f"expected is {face.name}"
        return {"fragments": len(masks)}

    def in_order(self):
        lists = {}
        for face, masks in zip(self.faces, self.masks):
            for pixel, mask in masks.items():
                lists.setdefault(pixel, []).append(Fragment(face, mask, *pixel))
        for y in range(self.size[1]):
            for x in range(self.size[0]):
                found = lists.get((x, y), [])
                full = [f for f in found if f.mask == 2 ** 32 - 1]
                left = [f for f in found if all(g.farthest >= f.nearest for g in full)]
                if left:
                    yield x, y, left

    @of("points one", "points shared")
    def points(self, said):
        x, y, found = next(self.pixels)
        by_name = {f.face.name: f for f in found}
        if set(by_name) != set(said.pieces):
            return f"at {x}, {y} are {list(by_name)}"
        found = [by_name[name] for name in said.pieces]
        if any(f.nearest > g.nearest + Fraction(1, 10**6) for f, g in zip(found, found[1:])):
            return "fragments are not near to far"
        points, left = [Fraction(0)] * len(found), 2 ** 32 - 1
        for i, f in enumerate(found):
            taken = left & f.mask
            points[i] += taken.bit_count()
            if left and i + 1 < len(found) and found[i + 1].nearest < f.farthest:
                g = found[i + 1]
                seen = (g.farthest - f.nearest) / (
                    f.farthest - f.nearest + g.farthest - g.nearest)
                lost = (1 - seen) * (taken & g.mask).bit_count()
                points[i] -= lost
                points[i + 1] += lost
            left &= ~f.mask
        best = None
        for f in found:
            if f.mask >> (DOWN // 2 * ACROSS + ACROSS // 2) & 1:
                best = f.face if best is None or f.face.is_nearer(best, x, y) else best
        self.row.setdefault(y, {})[x] = best and best.polygon
        return {"points": [Near(float(p)) for p in points], "masks": [f.mask for f in found],
                "z_nearest": [Near(float(f.nearest), 1e-3) for f in found],
                "z_farthest": [Near(float(f.farthest), 1e-3) for f in found], **window(x, y, 1)}

    @of("draw line")
    def line(self, said):
        y = max(self.row)
        ids = [self.row[y].get(x) for x in range(self.size[0])]
        return {"spans": merged(ids), **window(0, y, self.size[0])}

    def finish(self):
        return ["pixels are missing"] if next(self.pixels, None) else []
