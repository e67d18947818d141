"""Chapter 6: vertices, clipping, window coordinates."""
import math
from dataclasses import dataclass, replace

from . import antialiasing, fog, lighting, points, texture_coordinates
from .numbers import (bounded, cross, divide, dot3, dot4, floor, quantize, clamp01, rne, to_integer,
                      transform, unit)
from .primitives import identifier, primitives
from .rasterization import line_columns
from .state import (ClipDepth, ClipOrigin, ColorSource, Face, PolygonMode, ShadeModel, Winding,
                    viewport_of)

# ---- Vertices -------------------------------------------------------------------------------


@dataclass
class Vertex:
    clip: tuple
    distances: tuple  # to the six user planes
    colors: tuple  # front and back, four integers each
    secondary: tuple = ((0, 0, 0), (0, 0, 0))  # likewise, three each
    textures: tuple = ((0.0, 0.0, 0.0, 1.0),) * 4  # by unit
    fog: float = 0.0
    point_size: float = 1.0


class VertexStage:
    """[R6.8] to [R6.14] What a draw does to every position of its mesh."""

    def __init__(self, state, profile, draw):
        self.state, self.profile, self.draw = state, profile, draw
        self.current = draw.current
        m = draw.eye_from_object
        self.clip_from_object = [transform(state.projection, column) for column in m]
        x, y, z = m[0][:3], m[1][:3], m[2][:3]
        determinant = dot3(x, cross(y, z))
        g = -1.0 if determinant < 0 else 1.0
        self.normal_scale = 1 / abs(determinant) if abs(determinant) > 0 else 0.0
        self.normal_columns = [tuple(g * v for v in cross(a, b))
                               for a, b in ((y, z), (z, x), (x, y))]

    def normal(self, N):
        """[R6.11]"""
        a, b, c = self.normal_columns
        v = tuple((a[i] * N[0] + b[i] * N[1]) + c[i] * N[2] for i in range(3))
        if self.state.normalize:
            return unit(v)
        return tuple(bounded(x * self.normal_scale, 2.0**200) for x in v)  # [R6.28]

    def vertex(self, i):
        state, mesh = self.state, self.draw.mesh
        p = mesh.positions[i] + (mesh.w[i] if mesh.w else 1.0,)
        clip, p_eye = transform(self.clip_from_object, p), transform(self.draw.eye_from_object, p)
        # [R6.27]
        point = tuple(divide(c, p_eye[3]) for c in p_eye[:3]) if p_eye[3] != 0 else p_eye[:3]
        n = self.normal(mesh.normals[i] if mesh.normals else self.current.normal)
        distances = tuple(dot4(plane.plane, p_eye) if plane.enable else 0.0
                          for plane in state.clip_planes)
        vertex = Vertex(clip, distances, *self.colors(i, point, n))
        vertex.textures = tuple(self.coordinates(unit, i, p, p_eye, point, n)
                                for unit in range(4))
        vertex.point_size = points.size_at(state, point)
        if state.fog.enable:
            coordinate = (mesh.fog_coordinates[i] if mesh.fog_coordinates
                          else self.current.fog_coordinate)
            vertex.fog = fog.vertex_value(state, self.profile, point, coordinate)
        return vertex

    def coordinates(self, unit, i, p, p_eye, point, n):
        """[R10.1], [R10.26], [R10.37]"""
        if not self.draw.is_textured(unit):
            return (0.0, 0.0, 0.0, 1.0)
        own = self.draw.mesh.texcoords_of(unit, i)
        if own is None:
            own = ((self.current.texcoord,) + self.current.more_texcoords)[unit]
        s, t, r, q = texture_coordinates.at_vertex(self.state.of_unit(unit), own, p, p_eye, point,
                                                   n)
        image = self.draw.texture_of(unit)
        return (s, 0.0 if image is not None and image.dimensions == 1 else t, r, q)

    def colors(self, i, point, n):
        """[R6.12], [R8.12] Colours and secondary colours, each of front and back."""
        mesh, bits = self.draw.mesh, self.profile.color_bits
        if self.state.color_source == ColorSource.Lighting:
            front = self.lit(i, Face.Front, point, n)
            if not self.state.lighting.two_side:
                return (front[0], front[0]), (front[1], front[1])
            back = self.lit(i, Face.Back, point, tuple(-x for x in n))
            return (front[0], back[0]), (front[1], back[1])
        front = tuple(quantize(v, bits) for v in self.color(i))
        secondary = tuple(quantize(v, bits) for v in (
            mesh.secondary_colors[i] if mesh.secondary_colors else self.current.secondary_color))
        return (front, front), (secondary, secondary)

    def color(self, i):
        return self.draw.mesh.colors[i] if self.draw.mesh.colors else self.current.color

    def lit(self, i, face, p, n):
        material = lighting.material_at(self.state, self.draw, i, face, self.color(i))
        return lighting.lit_colors(self.profile, self.state, material, self.draw.lights, p, n)

    def id_color(self, polygon):
        """[R6.13]"""
        value = ((self.draw.id_base + identifier(self.draw.mesh, polygon)) % 2**32
                 ) >> self.draw.id_shift
        return (value & 255, (value >> 8) & 255, (value >> 16) & 255,
                (1 << self.profile.color_bits) - 1)


# ---- Clipping -------------------------------------------------------------------------------


class Clipper:
    """[R6.15] to [R6.19]"""

    def __init__(self, viewport, control):
        hx, hy, cx, cy = window_map(viewport, control)
        zero_to_one = control.depth == ClipDepth.ZeroToOne  # [R6.32]
        self.distances = [
            lambda v: v.clip[2] if zero_to_one else v.clip[2] + v.clip[3],
            lambda v: v.clip[3] - v.clip[2],
            *(lambda v, k=k: v.distances[k] for k in range(6)),
            lambda v: hx * v.clip[0] + (cx + 6144) * v.clip[3],
            lambda v: (10240 - cx) * v.clip[3] - hx * v.clip[0],
            lambda v: hy * v.clip[1] + (cy + 6144) * v.clip[3],
            lambda v: (10240 - cy) * v.clip[3] - hy * v.clip[1],
        ]

    def clipped(self, vertices):
        """The vertices that are left, or None if rejected; and whether a plane cut."""
        fewest = min(len(vertices), 3)
        if not all(math.isfinite(c) for v in vertices for c in v.clip):
            return None, False
        cut = False
        for distance in self.distances:
            d = [distance(v) for v in vertices]
            if all(x >= 0 for x in d):
                continue
            cut = True
            vertices = walk(vertices, d, closed=fewest == 3)
            if len(vertices) < fewest:
                return None, False
        for v in vertices:
            if not all(math.isfinite(c) for c in v.clip) or not v.clip[3] > 0:
                return None, False
        return vertices, cut


def walk(vertices, d, closed):
    """[R6.17] Sutherland and Hodgman's walk."""
    kept = []
    for i, a in enumerate(vertices):
        if d[i] >= 0:
            kept.append(a)
        if i + 1 == len(vertices) and not closed:
            break
        k = (i + 1) % len(vertices)
        a_inside, b_inside = d[i] >= 0, d[k] >= 0
        if a_inside and not b_inside:
            kept.append(between(a, vertices[k], d[i], d[k]))
        elif b_inside and not a_inside:
            kept.append(between(vertices[k], a, d[k], d[i]))
    return kept


def between(inside, outside, d_inside, d_outside):
    """[R6.18]"""
    t = divide(d_inside, d_inside - d_outside)

    def mix(a, b):
        return tuple(x + t * (y - x) for x, y in zip(a, b))

    def mix_colors(a, b):
        return tuple(tuple(rne(v) for v in mix(x, y)) for x, y in zip(a, b))

    return Vertex(mix(inside.clip, outside.clip), mix(inside.distances, outside.distances),
                  mix_colors(inside.colors, outside.colors),
                  mix_colors(inside.secondary, outside.secondary),
                  tuple(mix(a, b) for a, b in zip(inside.textures, outside.textures)),
                  inside.fog + t * (outside.fog - inside.fog))


# ---- Window coordinates ---------------------------------------------------------------------


@dataclass
class Corner:
    """A vertex in the window: X and Y on the sub-pixel grid, Z in units of the depth plane."""
    X: int
    Y: int
    Z: int
    vertex: Vertex
    color: tuple = ()
    secondary: tuple = (0, 0, 0)

    @property
    def w(self):
        return self.vertex.clip[3]


def window_map(viewport, control):
    """[R6.16], [R6.31] hx, hy, cx, cy"""
    hx, hy = viewport.width / 2, viewport.height / 2
    sign = -1 if control.origin == ClipOrigin.UpperLeft else 1
    return hx, sign * hy, viewport.x + hx, viewport.y + hy


def window_corner(vertex, state, viewport, profile):
    """[R6.20], [R6.21], [R6.32]"""
    x, y, z, w = vertex.clip
    hx, hy, cx, cy = window_map(viewport, state.clip_control)
    n, f = clamp01(state.depth_range.near_value), clamp01(state.depth_range.far_value)
    x_w = divide(x, w) * hx + cx
    y_w = divide(y, w) * hy + cy
    if state.clip_control.depth == ClipDepth.ZeroToOne:
        z_w = divide(z, w) * (f - n) + n
    else:
        z_w = divide(z, w) * ((f - n) / 2) + (f + n) / 2
    s = profile.subpixel_bits
    X, Y = (to_integer(floor(v * 2**s + 0.5), -6144 * 2**s, 10240 * 2**s - 1) for v in (x_w, y_w))
    return Corner(X, Y, quantize(z_w, profile.depth_bits), vertex)


def area2(p, q, r):
    """[R6.23] Twice the signed area."""
    return (q.X - p.X) * (r.Y - p.Y) - (q.Y - p.Y) * (r.X - p.X)


def pieces(corners, area):
    """[R6.25], [R6.26] The pieces that make fragments."""
    n = len(corners)

    def fan(first):
        return [(corners[first], corners[(first + k) % n], corners[(first + k + 1) % n])
                for k in range(1, n - 1)]

    def turned_over(piece):
        return area2(*piece) * area < 0

    first = 0 if n == 3 else next(
        (f for f in range(n) if not any(turned_over(p) for p in fan(f))), 0)
    return [p for p in fan(first) if area2(*p) * area > 0]


@dataclass
class Ready:
    """What rasterization gets: 1 corner, 2 or 3, jitter and colours decided; and its facing."""
    corners: tuple
    front: bool
    filled: bool
    steps: int = 0  # of a stippled line, before it [R9.20]
    offset: tuple = ()  # the piece that gives an outline its offset [R9.22]


class PrimitiveStage:
    """Stages 2 to 6 of [R1.9] for the primitives of one draw, with their counters."""

    def __init__(self, machine, draw):
        self.state, self.profile = machine.state, machine.profile
        self.counters, self.draw = machine.counters, draw
        self.viewport = viewport_of(machine.state, machine.width, machine.height)
        self.clipper = Clipper(self.viewport, machine.state.clip_control)
        self.vertices = VertexStage(machine.state, machine.profile, draw)
        self.cache = [self.vertices.vertex(i) for i in range(len(draw.mesh.positions))]
        self.steps = 0  # of the strip or outline in progress

    def run(self):
        """Lists of what becomes fragments together: the pieces of a smooth polygon [R9.25], or
        one."""
        polygon, pieces = 0, []
        for primitive in primitives(self.draw.mesh):
            if primitive.polygon != polygon:
                if pieces:
                    yield pieces
                pieces = []
                if self.draw.mesh.primitive != "LineStrip":
                    self.steps = 0
            polygon = primitive.polygon
            self.counters["primitives"] += 1
            for ready in self.primitive(primitive):
                if ready.filled and self.state.polygon_smooth:
                    pieces.append(ready)
                else:
                    yield [ready]
        if pieces:
            yield pieces

    def primitive(self, primitive):
        vertices = [self.cache[i] for i in primitive.corners]
        corners, cut = self.window(vertices)
        if corners is None:
            self.counters["rejected"] += 1
            return
        self.counters["clipped"] += cut
        if len(vertices) == 3:
            yield from self.triangle(primitive, vertices, corners)
        elif len(vertices) == 2 and (corners[0].X, corners[0].Y) == (corners[1].X, corners[1].Y):
            self.counters["degenerate"] += 1
        else:
            self.counters["drawn"] += 1
            yield self.ready(primitive, corners, front=True, filled=False)
            self.count_steps(corners)

    def window(self, vertices):
        kept, cut = self.clipper.clipped(vertices)
        if kept is None:
            return None, False
        return [window_corner(v, self.state, self.viewport, self.profile) for v in kept], cut

    def triangle(self, primitive, vertices, corners):
        """[R6.23], [R6.24], [R6.7]"""
        area = sum(area2(corners[0], corners[k], corners[k + 1])
                   for k in range(1, len(corners) - 1))
        if area == 0:
            self.counters["degenerate"] += 1
            return
        turned = self.state.clip_control.origin == ClipOrigin.UpperLeft  # [R6.31]
        winding = Winding.CCW if (area > 0) != turned else Winding.CW
        front = winding == self.state.cull.front
        cull = self.state.cull
        if cull.enable and cull.face in (Face.FrontAndBack, Face.Front if front else Face.Back):
            self.counters["culled"] += 1
            return
        self.counters["drawn"] += 1
        state = self.state
        back = state.two_side_polygon_mode and not front  # [R6.30]
        mode = state.back_polygon_mode if back else state.polygon_mode
        if mode == PolygonMode.Fill:
            for piece in pieces(corners, area):
                yield self.ready(primitive, piece, front, filled=True)
        else:
            offset = state.offset_lines if mode == PolygonMode.Line else state.offset_points
            yield from self.outline(primitive, vertices, front, mode == PolygonMode.Point,
                                    pieces(corners, area)[0] if offset else ())

    def outline(self, primitive, vertices, front, points, offset):
        """[R6.7] Uncounted lines or points along the edges."""
        for k in range(3):
            if not primitive.edges[k]:
                continue
            ends = [vertices[k]] if points else [vertices[k], vertices[(k + 1) % 3]]
            corners, _ = self.window(ends)
            if corners is None:
                continue
            if not points and (corners[0].X, corners[0].Y) == (corners[1].X, corners[1].Y):
                continue
            yield replace(self.ready(primitive, corners, front, filled=False), offset=offset)
            if not points:
                self.count_steps(corners)

    def count_steps(self, corners):
        """[R9.20]"""
        if len(corners) == 2:
            s = self.profile.subpixel_bits
            self.steps += (antialiasing.steps(corners, s) if self.state.line_smooth
                           else len(line_columns(corners, self.state, s)))

    def ready(self, primitive, corners, front, filled):
        """[R6.22] jitter; [R6.6], [R6.13] colours."""
        side = 0 if front else 1
        if self.state.color_source == ColorSource.PolygonId:
            colors = [self.vertices.id_color(primitive.polygon)] * len(corners)
            secondary = [(0, 0, 0)] * len(corners)
        else:
            flat = self.state.shade_model == ShadeModel.Flat
            given = [self.cache[primitive.flat] if flat else c.vertex for c in corners]
            colors = [v.colors[side] for v in given]
            secondary = [v.secondary[side] for v in given]
        jitter = self.state.jitter
        moved = tuple(replace(c, X=c.X + jitter.x, Y=c.Y + jitter.y, color=color, secondary=second)
                      for c, color, second in zip(corners, colors, secondary))
        return Ready(moved, front, filled, self.steps)
