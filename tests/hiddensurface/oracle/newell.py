"""Newell, Newell and Sancha: extents of pieces on the grid, distances behind planes."""
from oracle.compare import Spread, Near, Oracle, of
from oracle.pieces import Pieces


class Newell(Oracle):
    AXES = {"1-x-extents": 0, "2-y-extents": 1, "z-extents": 2}

    sampled = {(test, result) for result in ("yes", "no")
               for test in ("1-x-extents", "2-y-extents", "z-extents")}

    def __init__(self, run):
        super().__init__(run)
        self.pieces, self.reaches = Pieces(run), {}

    def reach(self, name, axis):
        if name not in self.reaches:
            corners = [self.camera.on_grid(p) for p in self.pieces.corners(name)]
            self.reaches[name] = [[Near(min(v), 1e-6), Near(max(v), 1e-6)] for v in zip(*corners)]
        return self.reaches[name][axis]

    @of("1-x-extents yes", "1-x-extents no", "2-y-extents yes", "2-y-extents no",
        "z-extents yes", "z-extents no")
    def extents(self, said):
        first, second = (self.reach(name, self.AXES[said.test]) for name in said.pieces)
        apart = first[0].value - second[1].value
        if said.test != "z-extents":
            apart = max(apart, second[0].value - first[1].value)
        if abs(apart) > 1e-4 and (said.result == "yes") != (apart > 0):
            return f"they are {apart} apart"
        return {"first_reach": first, "second_reach": second}

    def distances(self, said):
        first, second = said.pieces
        return Spread([Near(d, 1e-9 * max(1, abs(d))) for d in self.pieces.behind(first, second)])

    @of("3-behind yes", "3-behind no", "4-before yes", "4-before no",
        "3'-behind yes", "3'-behind no", "4'-before yes", "4'-before no")
    def plane(self, said):
        behind = self.distances(said)
        found = [d.value if "behind" in said.test else -d.value for d in behind.items]
        if (said.result == "yes") != (min(found) >= -self.pieces.tolerance):
            return f"the distances are {found}"
        return {"behind": behind, "tolerance": Near(self.pieces.tolerance, 1e-15)}

    @of("split seen-plane")
    def split(self, said):
        behind = self.distances(said)
        return self.pieces.cut(*said.pieces, said.made) or {"behind": behind}

    @of("farthest-corner sorted", "farthest-corner moved")
    def order(self, said):
        reach = [self.reach(name, 2)[1] for name in said.pieces]
        return {"z": reach}

    @of("draw piece")
    def draw(self, said):
        return {"pixels": self.pieces.pixels(said.pieces[0])}
