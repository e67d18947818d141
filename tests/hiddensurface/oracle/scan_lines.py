"""The algorithms of scan lines: Bouknight's edges and spans, Watkins' guessed spans, on exact
depths of plane faces."""
from oracle.compare import Near, Oracle, of, window
from oracle.raster import edge_pixels, faces_of


def merged(ids):
    """The number of runs of equal ids in a row; None is background."""
    return sum(id is not None and (x == 0 or ids[x - 1] != id) for x, id in enumerate(ids))


class Lines(Oracle):
    """Follows the rows from the top. `follow(y)` yields the steps of a row: the kind, the pieces
    (None: not checked here) and the numbers."""

    def __init__(self, run):
        super().__init__(run)
        self.faces, self.todo = faces_of(run.header), []
        self.edges = {}  # by row: (first pixel, pixel after the last, face); nothing: both equal
        width = self.size[0]
        for face in self.faces:
            for y in range(self.size[1]):
                ends = edge_pixels([face.loop], y, self.unit)
                if ends:
                    a, b = (min(max(x, 0), width) for x in ends)
                    self.edges.setdefault(y, []).append((a, b, face))
        self.steps = (step for y in range(self.size[1]) for step in self.follow(y))

    def seen(self, y):
        """The polygon that is seen at each pixel of the row."""
        found = []
        for x in range(self.size[0]):
            over = [face for a, b, face in self.edges.get(y, []) if a <= x < b]
            best = None
            for face in over:
                if best is None or face.is_nearer(best, x, y):
                    best = face
            found.append(best)
        return found

    def z(self, faces, x, y):
        return [Near(float(face.z(x, y)), 1e-6) for face in faces]

    def expect(self, said):
        kind, pieces, numbers = next(self.steps, (None, None, None))
        if kind != (said.test, said.result):
            return f"expected is {kind} {numbers}"
        if pieces is not None and sorted(pieces) != sorted(said.pieces):
            return f"the pieces are {pieces}"
        return numbers(said) if callable(numbers) else numbers

    def finish(self):
        rest = list(self.steps)
        return [f"{len(rest)} steps are missing"] if rest else []

    def line(self, y, ids):
        """The end of a row that shows something."""
        if any(id is not None for id in ids):
            yield ("draw", "line"), None, {"spans": merged(ids), **window(0, y, self.size[0])}

    def by_name(self, faces, numbers):
        """Numbers by name, in the order of the step's pieces."""
        def ordered(said):
            found = {face.name: face for face in faces}
            return numbers([found[name] for name in said.pieces])
        return ordered


class Bouknight(Lines):
    def follow(self, y):
        row = self.edges.get(y, [])
        if row:
            ends = sorted((x, face.name) for a, b, face in row for x in (a, max(a, b)))
            yield (("active-edges", "sorted"), [name for _, name in ends],
                   {"x": [x for x, _ in ends], **window(0, y, self.size[0])})
            places = sorted({x for x, _ in ends})
            for a, b in zip(places, places[1:]):
                on = [face for first, last, face in row if first <= a and b <= last]
                if on:
                    yield from self.span(y, a, b, on)
        yield from self.line(y, [f and f.polygon for f in self.seen(y)])

    def nearest(self, faces, x, y):
        best = faces[0]
        for face in faces[1:]:
            best = face if face.is_nearer(best, x, y) else best
        return best

    def span(self, y, a, b, on):
        left, right = self.nearest(on, a, y), self.nearest(on, b - 1, y)
        result = "pierce" if left is not right else "one" if len(on) == 1 else "one-nearest"
        numbers = self.by_name(on, lambda faces: {
            "z_left": self.z(faces, a, y), "z_right": self.z(faces, b - 1, y),
            **window(a, y, b - a)})
        yield ("span", result), [face.name for face in on], numbers
        if left is right:
            return
        x = next(x for x in range(a, b) if right.is_nearer(left, x, y))
        yield (("implied-edge", "found"), [left.name, right.name],
               {"x": x, **window(a, y, b - a)})
        yield from self.span(y, a, x, on)
        yield from self.span(y, x, b, on)

    expect = of("active-edges sorted", "span one", "span one-nearest", "span pierce",
                "implied-edge found", "draw line")(lambda self, said: Lines.expect(self, said))


class Watkins(Lines):
    ends = ()  # of the spans that were seen in the line above

    def follow(self, y):
        row = self.edges.get(y, [])
        segment = [face for a, b, face in row if a < b]
        if segment:
            def segments(said):
                ends = {face.name: (a, b - 1) for a, b, face in row}
                return {"x0": [ends[name][0] for name in said.pieces],
                        "x1": [ends[name][1] for name in said.pieces],
                        **window(0, y, self.size[0])}
            yield ("active-edges", "segments"), [face.name for face in segment], segments
        seen = self.seen(y)
        yield from self.spans(y, row, seen)
        ids = [None] + [f and f.polygon for f in seen] + [None]
        self.ends = [x for x in range(self.size[0] + 1) if ids[x] != ids[x + 1]]
        ids = ids[1:-1]
        yield from self.line(y, ids)

    def spans(self, y, row, seen):
        """From the left: the face that is seen, up to the guess or to where another is seen."""
        x, width = 0, self.size[0]
        while x < width:
            guess = next((end for end in self.ends if end > x), width)
            over = [face for a, b, face in row if a < b and a < guess and b > x]
            if not over and all(a < guess for a, _, _ in row):
                return
            end = next((e for e in range(x, guess) if seen[e] is not seen[x]), guess)
            result = ("background" if seen[x] is None else
                      "as-guessed" if end == guess else "shorter")
            numbers = self.by_name(over, lambda faces, x=x, end=end, guess=guess: {
                "guessed": guess, "end": end, "z_left": self.z(faces, x, y),
                "z_right": self.z(faces, end - 1, y), **window(x, y, end - x)})
            yield ("sample-span", result), [face.name for face in over], numbers
            x = end

    expect = of("active-edges segments", "sample-span background", "sample-span as-guessed",
                "sample-span shorter", "draw line")(lambda self, said: Lines.expect(self, said))
