"""From the world to the window grid, with the camera of a log's header."""
import math

from oracle.vectors import cross, dot, minus, unit


class Camera:
    def __init__(self, header):
        view = header["view"]
        self.size, self.unit, self.depth = header["size"], header["unit"], header["depth"]
        self.eye, self.parallel = view["eye"], view["ortho_height"] > 0
        self.to_eye = unit(minus(view["eye"], view["at"]))
        right = unit(cross(view["up"], self.to_eye))
        self.axes = right, cross(self.to_eye, right), self.to_eye
        self.near, self.far = view["near"], view["far"]
        half = (view["ortho_height"] / 2 if self.parallel
                else math.tan(math.radians(view["fov"]) / 2))
        # Grid units of 1 in the world; of a perspective, at depth 1.
        self.scale = self.size[1] / 2 * self.unit / half

    def before(self, plane):
        """How far the eye is before a world plane (n, d): a distance, or a cosine."""
        return dot(plane, self.to_eye) if self.parallel else dot(plane, self.eye) + plane[3]

    def distance(self, p):
        """Of a point, along the line of sight through the middle of the picture."""
        return -dot(minus(p, self.eye), self.to_eye)

    def on_grid(self, p):
        """x, y downwards and z of a point before the eye; not rounded."""
        x, y, z = (dot(axis, minus(p, self.eye)) for axis in self.axes)
        n, f = self.near, self.far
        if self.parallel:
            w, depth = 1, (-z - n) / (f - n)
        else:
            w, depth = -z, f * (-z - n) / ((f - n) * -z)
        return [self.size[0] / 2 * self.unit + self.scale * x / w,
                self.size[1] / 2 * self.unit - self.scale * y / w, self.depth * depth]
