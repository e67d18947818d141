"""Chapter 10, third section: textures with r at the pixel."""
import numpy as np

from .numbers import one, quantize, rescale, to_integer_array
from .fragments import compare
from .rasterization import Projective, joined_slopes, reciprocal, slopes
from .state import MagFilter, MinFilter, Wrap
from .texture import (Coordinate, Texture, TextureStage, bilinear, completed, look_ups,
                      texels_of)

# [R10.42] For each face: the coordinate that is largest, and those of s and t with their signs.
FACES = (((0, 1), (2, -1), (1, -1)), ((0, -1), (2, 1), (1, -1)), ((1, 1), (0, 1), (2, 1)),
         ((1, -1), (0, 1), (2, -1)), ((2, 1), (0, 1), (1, -1)), ((2, -1), (0, -1), (1, -1)))


def faces_of(d):
    """[R10.42] d: arrays of x, y, z."""
    x, y, z = (np.abs(v) for v in d)
    along_x, along_y = (x >= y) & (x >= z), y >= z
    return np.where(along_x, np.where(d[0] < 0, 1, 0),
                    np.where(along_y, np.where(d[1] < 0, 3, 2), np.where(d[2] < 0, 5, 4)))


def on_faces(d):
    """[R10.42] The faces, and s and t of 0 .. 1 there."""
    d = np.asarray(d, np.float64)
    faces = faces_of(d)
    s, t = np.full(len(faces), 0.5), np.full(len(faces), 0.5)
    for face, ((major, _), *rules) in enumerate(FACES):
        here = (faces == face) & (np.abs(d[major]) > 0)
        for to, (c, sign) in zip((s, t), rules):
            to[here] = (sign * d[c][here] / np.abs(d[major][here]) + 1) / 2
    return faces, s, t


def rescaled_depths(level, bits):
    """[R10.40] R and G are the halves of 32 bits."""
    given = level[:, :, 0].astype(np.int64) * 2**16 + level[:, :, 1]
    return given >> (32 - bits)


def layered(image, profile):
    """[R10.38] A Texture whose levels are arrays [layer, row, column, channel]."""
    levels, level_depths = [], []
    for k, level in enumerate(image.given):
        layers = 6 if image.cube else max(1, image.layers >> k)
        if image.depths:  # [R10.40]
            level_depths.append(rescaled_depths(level, profile.depth_bits))
            grey = rescale(level_depths[k], profile.depth_bits, profile.color_bits)
            texels = completed(np.repeat(grey[:, :, None], 4, axis=2), image.format,
                               one(profile.color_bits))
        else:
            texels = texels_of(completed(level, image.format), profile, image.srgb)
        levels.append(texels.reshape(layers, -1, level.shape[1], 4))
    result = Texture(levels, depth_bits=profile.depth_bits)
    result.level_depths = level_depths
    result.format, result.dimensions = image.format, image.dimensions
    result.cube, result.with_r = image.cube, True
    return result


class Value(Coordinate):
    """[R10.38] A coordinate v 2^e in double."""

    def __init__(self, v, e, wrap):
        self.wide, self.e, self.wrap, self.k, self.any_size = v, e, wrap, 0, True

    def position_on_face(self, side):
        """[R10.42]"""
        return np.floor(self.wide * (256.0 * side)).astype(np.int64)


class VolumeStage(TextureStage):
    """Of a texture with r: its levels are arrays [layer, row, column, channel]."""

    def __init__(self, state, profile, texture, projective, unit=0):
        super().__init__(state, profile, texture, projective, unit)
        self.wrap_r, self.seamless = state.wrap_r, state.seamless

    def sides(self, level):
        layers, h, w = self.texture.levels[level].shape[:3]
        return w, h, layers

    def wraps(self):
        if self.texture.cube:
            return (Wrap.Clamp,) * 3
        wrap_t = self.state.wrap_t if self.texture.dimensions > 1 else Wrap.Clamp
        return self.state.wrap_s, wrap_t, self.wrap_r

    def texels(self, frame, corners, x, y):
        sprite = self.sprite(frame)
        if sprite:
            self.q, self.planes = sprite.q, [(plane, 0) for plane in sprite.of]
        else:
            given = [c.vertex.textures[self.unit] for c in corners]
            denominator = Projective(frame, [c.w for c in corners], [g[3] for g in given])
            self.q = denominator.q
            self.planes = [denominator.value([g[c] for g in given]) for c in range(3)]
        self.x, self.y = x, y
        q = self.q.at(x, y)
        self.U = [plane.at(x, y) for plane, _ in self.planes]
        values = [Value(u / np.maximum(q, 1), e, wrap)
                  for u, (_, e), wrap in zip(self.U, self.planes, self.wraps())]
        result = self.value_at(values)
        result[q < 1] = one(self.profile.color_bits)  # [R10.19]
        return result

    def value_at(self, values):
        if self.state.shadow_compare:
            return self.compared_with(*values)
        return self.filtered(*self.two_of(values), None, None, None, None)

    def magnified(self, values):
        """Of a rectangle of pixels."""
        if self.state.shadow_compare:
            return self.compared_with(*values)
        return self.look_up(self.lod.base, self.state.mag_filter == MagFilter.Linear,
                            *self.two_of(values))

    def two_of(self, values):
        """s and t, of a cube on its faces; r is kept."""
        s, t, self.r = values
        if not self.texture.cube:
            return s, t
        self.faces, s, t = on_faces([v.wide * 2.0**v.e for v in values])
        return Value(s, 0, Wrap.Clamp), Value(t, 0, Wrap.Clamp)

    def compared_with(self, s, t, r):
        """[R10.41]"""
        bits, base = self.texture.depth_bits, self.lod.base
        incoming = to_integer_array(np.floor(r.wide * 2.0**(r.e + bits)), 0, one(bits))
        w, h, _ = self.sides(base)
        around = np.pad(self.texture.level_depths[base], 1,
                        constant_values=quantize(self.border_color[0], bits))
        stored = around[t.wrapped(t.position(h) >> 8, h) + 1, s.wrapped(s.position(w) >> 8, w) + 1]
        most = one(self.profile.color_bits)
        lit = np.where(compare(self.compare_func, incoming, stored), most, 0)
        grey = np.repeat(lit[:, None, None], 4, axis=2)
        return completed(grey, self.texture.format, most)[:, 0]

    def rho(self, s, t, q, W, x, y):
        """[R10.38], [R10.43]"""
        if self.texture.cube:
            return self.rho_on_faces()
        W = reciprocal(self.q, self.x, self.y)
        count = 3 if self.texture.dimensions == 3 else 2
        of_all = list(zip(self.planes, self.sides(self.lod.base)))[:count]
        most = joined_slopes([(slopes(plane, self.q, self.x, self.y), 2.0**e * side)
                              for (plane, e), side in of_all], self.exact_rho)
        return self.lod.of((most.astype(np.float32) * (W * W)) * np.float32(2.0**-16))

    def rho_on_faces(self):
        rho = np.zeros(len(self.x), np.float32)
        for face, ((major, _), *rules) in enumerate(FACES):
            here = (self.faces == face) & (self.U[major] != 0)
            if not here.any():
                continue
            plane, e_major = self.planes[major]
            side = self.sides(self.lod.base)[0]
            most = joined_slopes([(slopes(own, plane, self.x[here], self.y[here]),
                                   2.0**(e - e_major - 1) * side)
                                  for own, e in (self.planes[c] for c, _ in rules)],
                                 self.exact_rho)
            W = np.float32(1) / np.abs(self.U[major][here]).astype(np.float32)
            rho[here] = self.lod.of((most.astype(np.float32) * (W * W)) * np.float32(2.0**-16))
        return rho

    # ---- Look-ups ---------------------------------------------------------------------------

    def look_up(self, level, linear, s, t):
        w, h, layers = self.sides(level)
        if self.texture.cube:
            return self.face_look_up(level, linear, s.position_on_face(w), t.position_on_face(w))
        p, q = s.position(w), t.position(h)
        if self.texture.dimensions < 3:
            return self.slice(level, linear, s, t, p, q, np.zeros(len(p), np.int64))
        at = self.r.position(layers)
        if not linear:
            return self.slice(level, linear, s, t, p, q, self.r.wrapped(at >> 8, layers))
        at = self.r.limited(at, layers) - 128  # [R10.45]
        low, high = (self.slice(level, linear, s, t, p, q,
                                self.r.filtered_index((at >> 8) + k, layers)) for k in (0, 1))
        return low + (((high - low) * (at & 255)[:, None] + 128) >> 8)

    def slice(self, level, linear, s, t, p, q, layer):
        """[R10.10], [R10.11] in slices; -1 and the number of slices are the border."""
        w, h, layers = self.sides(level)
        around = self.with_borders(level)
        layer = layer + 1
        if not linear:
            return around[layer, t.wrapped(q >> 8, h) + 1, s.wrapped(p >> 8, w) + 1].copy()
        p, q = s.limited(p, w) - 128, t.limited(q, h) - 128
        left, right = (s.filtered_index((p >> 8) + k, w) + 1 for k in (0, 1))
        low, high = (t.filtered_index((q >> 8) + k, h) + 1 for k in (0, 1))
        return bilinear(around[layer, low, left], around[layer, low, right],
                        around[layer, high, left], around[layer, high, right], p, q,
                        self.profile.color_bits)

    def with_borders(self, level):
        image = self.texture.levels[level]
        bits = self.profile.color_bits
        color = np.array([[[quantize(v, bits) for v in self.border_color]]])
        around = np.empty(tuple(n + 2 for n in image.shape[:3]) + (4,), np.int64)
        around[:] = completed(color, self.texture.format, one(bits))
        around[1:-1, 1:-1, 1:-1] = image
        return around

    def face_look_up(self, level, linear, p, q):
        """[R10.42], [R10.44]"""
        n, image = self.sides(level)[0], self.texture.levels[level]
        if not linear:
            i, j = np.clip(p >> 8, 0, n - 1), np.clip(q >> 8, 0, n - 1)
            return image[self.faces, j, i].copy()
        p, q = p - 128, q - 128
        at = self.seamless_texel if self.seamless else self.clamped_texel
        a, b, c, d = (at(image, n, (p >> 8) + i, (q >> 8) + j) for j in (0, 1) for i in (0, 1))
        return bilinear(a, b, c, d, p, q, self.profile.color_bits)

    def clamped_texel(self, image, n, i, j):
        return image[self.faces, np.clip(j, 0, n - 1), np.clip(i, 0, n - 1)]

    def seamless_texel(self, image, n, i, j):
        """[R10.44]"""
        x, y = np.clip(i, 0, n - 1), np.clip(j, 0, n - 1)
        own = image[self.faces, y, x]
        beyond_s, beyond_t = self.neighbour(image, n, i, y), self.neighbour(image, n, x, j)
        outside_s, outside_t = (i != x)[:, None], (j != y)[:, None]
        corner = (2 * (own + beyond_s + beyond_t) + 3) // 6
        return np.where(outside_s & outside_t, corner,
                        np.where(outside_s, beyond_s, np.where(outside_t, beyond_t, own)))

    def neighbour(self, image, n, i, j):
        """The texel that the direction through the centre of texel i, j of the face meets."""
        s, t = (2 * i + 1 - n) / n, (2 * j + 1 - n) / n
        d = np.zeros((3, len(i)))
        for face, ((major, sign), (c_s, sign_s), (c_t, sign_t)) in enumerate(FACES):
            here = self.faces == face
            d[major][here] = sign
            d[c_s][here], d[c_t][here] = sign_s * s[here], sign_t * t[here]
        faces, s, t = on_faces(d)
        i, j = (np.minimum(np.floor(v * n).astype(np.int64), n - 1) for v in (s, t))
        return image[faces, j, i]


def unit_look_ups(machine, command, unit):
    """[R14.6]"""
    low = machine.state.of_unit(unit).texture.min_filter
    count = look_ups(low)
    linear = low in (MinFilter.Linear, MinFilter.LinearMipmapNearest, MinFilter.LinearMipmapLinear)
    return 2 * count if linear and machine.texture_of(command, unit).dimensions == 3 else count


def volume_texel_in_place(state, profile, texture, strq):
    """[R13.13] A row of R, G, B, A."""
    q = strq[3]
    if q <= 0:
        return np.full((1, 4), one(profile.color_bits), np.int64)
    stage = VolumeStage(state, profile, texture, True)
    values = [Value(np.array([v / q]), 0, wrap) for v, wrap in zip(strq, stage.wraps())]
    return stage.magnified(values)
