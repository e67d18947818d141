"""Warnock's windows: which faces surround them and reach into them, on exact sides and depths."""
from oracle.compare import Foretold, Near, of, window
from oracle.raster import faces_of, turn


class Warnock(Foretold):
    def __init__(self, run):
        super().__init__(run)
        faces = faces_of(run.header)
        for face in faces:
            face.sides = self.sides(face)
        self.steps = self.look((0, 0, *self.size), [], faces)

    def sides(self, face):
        """(a, b, c), a x + b y + c above 0 at pixels whose centres are inside; at 0 on a left or
        a top side. And the pixels that the face's box meets."""
        loop = face.loop
        if sum(turn(loop[0], p, q) for p, q in zip(loop[1:], loop[2:])) < 0:
            loop = loop[::-1]  # clockwise on the screen
        found, half, size = [], self.unit // 2, len(loop)
        for i in range(size):
            p, q = loop[i], loop[(i + 1) % size]
            dx, dy = q[0] - p[0], q[1] - p[1]
            owned = dy < 0 or (dy == 0 and dx > 0)
            found.append((-dy * self.unit, dx * self.unit,
                          dx * (half - p[1]) - dy * (half - p[0]) - (0 if owned else 1)))
        x, y = [p[0] for p in loop], [self.size[1] * self.unit - p[1] for p in loop]
        face.box = [(min(v) // self.unit, max(v) // self.unit) for v in (x, y)]
        return found

    def cover(self, face, corners, box):
        """The window's four corner pixels decide: one side may keep all outside, or none does."""
        x, y, width, height = box
        up = self.size[1] - y - height
        (x0, x1), (y0, y1) = face.box
        if x0 >= x + width or x > x1 or y0 >= up + height or up > y1:
            return None
        surrounds = True
        for a, b, c in face.sides:
            outside = sum(a * px + b * py + c < 0 for px, py in corners)
            if outside == 4:
                return None
            surrounds = surrounds and not outside
        return "surrounds" if surrounds else "reaches in"

    def look(self, box, around, others):
        x, y, width, height = box
        corners = [(px, py) for py in (y + height - 1, y) for px in (x, x + width - 1)]
        cover = [(face, self.cover(face, corners, box)) for face in others]
        around = around + [face for face, how in cover if how == "surrounds"]
        inside = [face for face, how in cover if how == "reaches in"]
        if around:
            first = around[0]
            for face in around[1:]:
                first = face if face.is_nearer(first, *corners[0]) else first
            hidden = [face for face in around + inside if face is not first and
                      all(first.is_nearer(face, *p) for p in corners)]
            around = [face for face in around if face not in hidden]
            inside = [face for face in inside if face not in hidden]
            if hidden:
                z = [[Near(float(face.z(*p)), 1e-6) for p in corners] for face in [first] + hidden]
                yield ("window", "hidden"), [first.name], {
                    "z": z[0], "z_hidden": sum(z[1:], []), **window(x, y, width, height)}
        shown = {"surrounding": len(around), "inside": len(inside), **window(x, y, width, height)}
        if len(around) + len(inside) < 2:
            if not around and not inside:
                yield ("window", "empty"), [], shown
                return
            face = (around + inside)[0]
            pixels = sum(max(min(face.runs[row][1], x + width) - max(face.runs[row][0], x), 0)
                         for row in range(y, y + height) if row in face.runs)
            if pixels:
                yield (("window", "surrounded" if around else "one-face"), [face.name],
                       {"pixels": pixels, **window(x, y, width, height)})
            return
        yield ("window", "divided"), [face.name for face in around + inside], shown
        left, low = (width + 1) // 2, (height + 1) // 2  # the first half's, from the lower left
        for part_y, part_height in ((y, height - low), (y + height - low, low)):
            for part_x, part_width in ((x, left), (x + left, width - left)):
                if part_width and part_height:
                    yield from self.look((part_x, part_y, part_width, part_height), around, inside)

    @of("window empty", "window surrounded", "window one-face", "window divided", "window hidden")
    def expect(self, said):
        return self.next_step(said)
