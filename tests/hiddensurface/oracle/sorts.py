"""Back-face culling and the painter's algorithms: facings, distances, pixels of whole polygons."""
from oracle.compare import Near, Oracle, of
from oracle.pieces import whole
from oracle.vectors import dot, minus, normal


class BackFace(Oracle):
    @of("facing front", "facing back", "facing edge-on", "facing-parallel front",
        "facing-parallel back", "facing-parallel edge-on")
    def facing(self, said):
        corners = self.run.polygons[int(said.pieces[0])]["world"]
        n = normal(corners)
        parallel = self.camera.parallel
        if parallel == (said.test == "facing"):
            return "lines of sight are parallel, or not"
        towards = self.camera.to_eye if parallel else minus(self.camera.eye, corners[0])
        product = dot(n, towards)
        if said.result != ("front" if product > 0 else "back" if product < 0 else "edge-on"):
            return f"the product is {product}"
        found = {"N": [Near(v) for v in n], "N_d" if parallel else "D_f": Near(product)}
        if parallel:
            found["d"] = [Near(v) for v in towards]
        return found

    @of("draw piece")
    def draw(self, said):
        return {"pixels": whole(self.run, said.pieces[0])}



class Painter(Oracle):
    """`key`: which distance of a polygon's corners."""
    KEYS = {"painter-nearest": min, "painter-farthest": max,
            "painter-centroid": lambda found: sum(found) / len(found)}

    def key(self, name):
        corners = self.run.polygons[int(name)]["world"]
        return Near(self.KEYS[self.run.algorithm]([self.camera.distance(p) for p in corners]))

    @of("distance farther", "distance not-farther")
    def compare(self, said):
        first, second = map(self.key, said.pieces)
        difference = first.value - second.value
        if abs(difference) > 1e-9 and (said.result == "farther") != (difference > 0):
            return f"the distances are {first.value} and {second.value}"
        return {"first_key": first, "second_key": second}

    @of("distance sorted")
    def order(self, said):
        keys = [self.key(name) for name in said.pieces]
        if any(a.value < b.value - 1e-9 for a, b in zip(keys, keys[1:])):
            return "not in order"
        return {"keys": keys}

    @of("draw piece")
    def draw(self, said):
        return {"pixels": whole(self.run, said.pieces[0])}
