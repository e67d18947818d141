"""Chapter 10, second section: textures at the pixel."""
import math

import numpy as np

from .elementary import exp, power
from .fragments import compare
from .numbers import clamp, one, quantize, rescale, to_integer_array
from .points import SpritePlanes
from .rasterization import (Perspective, Projective, joined_slopes, quotient, reciprocal,
                            slopes)
from .state import MagFilter, MinFilter, TextureFormat, Wrap

LINEAR_FILTERS = (MinFilter.Linear, MinFilter.LinearMipmapNearest, MinFilter.LinearMipmapLinear)


def halves(side):
    """[R10.28] For each texel of half a side: the texels that it covers, and their weights."""
    n = side // 2
    if side == 1:
        return [((0,), (1,))]
    if side % 2 == 0:
        return [((2 * i, 2 * i + 1), (1, 1)) for i in range(n)]
    return [((2 * i, 2 * i + 1, 2 * i + 2), (n - i, n, i + 1)) for i in range(n)]


def halved(v, axis):
    """Sums along one axis, and the sum of the weights."""
    rows = [sum(w * np.take(v, t, axis) for t, w in zip(texels, weights))
            for texels, weights in halves(v.shape[axis])]
    return np.stack(rows, axis), sum(halves(v.shape[axis])[0][1])


def pyramid(image):
    """[R10.6], [R10.28] All levels of an image of 16 bits: arrays [row, column, channel]."""
    levels = [image.astype(np.int64)]
    while levels[-1].shape[:2] != (1, 1):
        rows, row_total = halved(levels[-1], 0)
        total_sum, column_total = halved(rows, 1)
        total = row_total * column_total
        levels.append((2 * total_sum + total) // (2 * total))
    return levels


def linear_value(b):
    """[R10.36]"""
    v = b / 255
    return quantize(v / 12.92 if v <= 0.04045 else power((v + 0.055) / 1.055, 2.4), 16)


LINEAR_VALUES = np.array([linear_value(b) for b in range(256)], np.int64)


def texels_of(level, profile, srgb):
    """[R10.6], [R10.23], [R10.36]"""
    if srgb:
        colors = LINEAR_VALUES[rescale(level[:, :, :3], 16, 8)]
        level = np.concatenate([colors, level[:, :, 3:]], axis=2)
    bits = profile.texel_bits or profile.color_bits
    return rescale(rescale(level, 16, bits), bits, profile.color_bits)


def completed(level, form, most=one(16)):
    """[R10.24] Channels that a format lacks."""
    level = level.astype(np.int64).copy()
    if form in (TextureFormat.Luminance, TextureFormat.LuminanceAlpha, TextureFormat.Intensity):
        level[:, :, 1:3] = level[:, :, :1]
    if form == TextureFormat.Alpha:
        level[:, :, :3] = most
    if form == TextureFormat.Intensity:
        level[:, :, 3] = level[:, :, 0]
    if form in (TextureFormat.RGB, TextureFormat.Luminance):
        level[:, :, 3] = most
    return level


class Texture:
    """What a draw looks up: levels in color_bits, and the depths of a slot of the depth plane."""

    def __init__(self, levels, depths=None, depth_bits=0):
        self.levels, self.depths, self.depth_bits = levels, depths, depth_bits
        self.bordered = [None] * len(levels)  # the levels with their borders [R10.25]
        self.format, self.dimensions = TextureFormat.RGBA, 2
        self.cube = self.with_r = False

    @classmethod
    def of_image(cls, image, profile):
        if image.given is None:
            return cls([texels_of(level, profile, image.srgb) for level in pyramid(image.texels)])
        levels = [texels_of(completed(level, image.format), profile, image.srgb)
                  for level in image.given]
        if not image.border:
            result = cls(levels)
        else:
            if image.dimensions == 1:
                levels = [np.repeat(level, 3, axis=0) for level in levels]
            result = cls([level[1:-1, 1:-1] for level in levels])
            result.bordered = levels
        result.format, result.dimensions = image.format, image.dimensions
        return result

    @classmethod
    def of_plane(cls, values, is_depth, profile):
        """[R10.16] values: rows of a rectangle of a plane."""
        if not is_depth:
            return cls([values])
        gray = rescale(values, profile.depth_bits, profile.color_bits)
        return cls([np.repeat(gray[:, :, None], 4, axis=2)], values, profile.depth_bits)

    def sides(self, level):
        h, w = self.levels[level].shape[:2]
        return w, h

    def is_any_size(self):
        """[R10.28]"""
        return any(side & (side - 1) or side > 4096 for side in self.sides(0))


def wrapped(wrap, index, side):
    """[R10.9], [R10.30]"""
    if wrap == Wrap.Repeat:
        return index % side
    if wrap == Wrap.MirroredRepeat:
        folded = index % (2 * side)
        return np.where(folded < side, folded, 2 * side - 1 - folded)
    if wrap == Wrap.ClampToBorder:
        return np.clip(index, -1, side)
    return np.clip(index, 0, side - 1)


class Coordinate:
    """[R9.15] u 2^e of one coordinate at the pixels, and the whole part k [R10.8]."""

    def __init__(self, plane, e, W, x, y, wrap, k, wide_q=None, any_size=False):
        self.plane, self.e, self.wrap, self.k = plane, e, wrap, k
        self.u = quotient(plane, W, x, y)
        self.wide = None if wide_q is None else plane.at(x, y) / wide_q.at(x, y)
        self.any_size = any_size or wrap == Wrap.MirroredRepeat

    def position(self, side):
        """[R10.9] In units of 1/256 texel."""
        if self.any_size:
            return self.any_position(side)
        log2_side = side.bit_length() - 1
        if self.wide is not None:
            return self.wide_position(log2_side + 8)
        limit = np.float32(2.0**30)
        scaled = self.u * np.float32(2.0**(self.e + log2_side + 8))
        p = np.floor(np.minimum(np.maximum(scaled, -limit), limit)).astype(np.int64)
        return p + self.k * 2**(log2_side + 8) if self.wrap != Wrap.Repeat else p

    def any_position(self, side):
        """[R10.29]"""
        v = self.u.astype(np.float64) if self.wide is None else self.wide
        n = np.floor(v * (2.0**self.e * 256 * side))
        n = np.minimum(np.maximum(n, -2.0**62), 2.0**62).astype(np.int64)
        if self.wrap == Wrap.Repeat:
            return n % (256 * side)
        if self.wrap == Wrap.MirroredRepeat:
            return (n + self.k % 2 * 256 * side) % (512 * side)
        return np.clip(n + self.k * 256 * side, -2**30, 2**30)

    def wide_position(self, shift):
        """[R10.27]"""
        p = np.floor(self.wide * 2.0**(self.e + shift)).astype(np.int64)
        if self.wrap == Wrap.Repeat:
            return p & (2**shift - 1)
        return np.clip(p + self.k * 2**shift, -2**30, 2**30)

    def limited(self, p, side):
        """[R10.25]"""
        return np.clip(p, 0, 256 * side) if self.wrap == Wrap.BorderClamp else p

    def filtered_index(self, index, side):
        """[R10.25] -1 and the side are the border."""
        return index if self.wrap == Wrap.BorderClamp else self.wrapped(index, side)

    def wrapped(self, index, side):
        return wrapped(self.wrap, index, side)


def repeats(wrap):
    return wrap in (Wrap.Repeat, Wrap.MirroredRepeat)


def whole_part(values, wrap):
    """[R10.8]"""
    k = math.floor(min(values))
    return k if repeats(wrap) else clamp(k, -1024, 1023)


def power_of_two(v):
    """[R10.31] F(v)"""
    ln2 = float.fromhex("0x1.62e42fefa39efp-1")
    return np.float32(exp(clamp(v, -126.0, 126.0) * ln2))


class Lod:
    """[R10.31] The levels that are used, and what happens to rho."""

    def __init__(self, lod, count):
        self.base = min(lod.base_level, count - 1)
        self.last = clamp(lod.max_level, self.base, count - 1)
        self.scale, self.least, self.greatest = (
            power_of_two(v) for v in (lod.bias, lod.min, lod.max))

    def of(self, rho):
        return np.minimum(np.maximum(rho * self.scale, self.least), self.greatest)


def bilinear(a, b, c, d, p, q, bits):
    """[R10.11] Of the lower row and the upper one, at positions p, q."""
    x, y = (p & 255)[:, None], (q & 255)[:, None]
    if bits == 8:
        t0 = 64 * a + (((b - a) * 64 * x + 128) >> 8)
        t1 = 64 * c + (((d - c) * 64 * x + 128) >> 8)
        return (t0 + (((t1 - t0) * y + 128) >> 8) + 32) >> 6
    lower, upper = a * (256 - x) + b * x, c * (256 - x) + d * x
    return (lower * (256 - y) + upper * y + 2**15) >> 16


class TextureStage:
    """Looks one draw's texture up at the pixels of one piece, line or point."""

    def __init__(self, state, profile, texture, projective, unit=0):
        """state: the unit's."""
        self.unit = unit
        self.compare_func = state.compare_func
        self.border_color = state.border_color
        self.state, self.profile, self.texture = state.texture, profile, texture
        self.lod = Lod(state.texture_lod, len(texture.levels))
        self.projective = projective  # [R10.22]
        self.replaces = state.coord_replace
        self.exact_rho = state.exact_rho

    def sprite(self, frame):
        """[R9.32] The planes of a sprite; None: the unit has coordinates of vertices."""
        if frame.sprite_size == 0 or not self.replaces:
            return None
        return SpritePlanes(frame, frame.sprite_size, self.texture.dimensions == 1)

    def texels(self, frame, corners, x, y):
        sprite = self.sprite(frame)
        if sprite:
            W = reciprocal(sprite.q, x, y)
            wraps = self.state.wrap_s, self.wrap_t(), Wrap.Repeat
            s, t, r = (Coordinate(plane, 0, W, x, y, wrap, 0, None, self.texture.is_any_size())
                       for plane, wrap in zip(sprite.of, wraps))
            return self.shadow(s, t, r) if self.state.shadow_compare else self.filtered(
                s, t, sprite.q, W, x, y)
        given = [c.vertex.textures[self.unit] for c in corners]
        w = [c.w for c in corners]
        if self.projective:
            denominator = Projective(frame, w, [g[3] for g in given])
            in_front = denominator.q.at(x, y) >= 1
        else:
            denominator = Perspective(frame, w)
            in_front = np.ones(len(x), bool)
        W = reciprocal(denominator.q, x, y)
        s, t, r = (self.coordinate(denominator, [g[c] for g in given], wrap, W, x, y)
                   for c, wrap in enumerate((self.state.wrap_s, self.wrap_t(), Wrap.Repeat)))
        if self.state.shadow_compare:
            result = self.shadow(s, t, r)
        else:
            result = self.filtered(s, t, denominator.q, W, x, y)
        result[~in_front] = one(self.profile.color_bits)  # [R10.19]
        return result

    def wrap_t(self):
        """[R10.26]"""
        return self.state.wrap_t if self.texture.dimensions == 2 else Wrap.Clamp

    def coordinate(self, denominator, values, wrap, W, x, y):
        any_size = self.texture.is_any_size()
        if self.projective:
            plane, e = denominator.value(values)
            return Coordinate(plane, e, W, x, y, wrap, 0, None, any_size)
        if max(values) - math.floor(min(values)) > 2.0**10:  # [R9.19]
            k = math.floor(min(values))
            k = k if repeats(wrap) else clamp(k, -2**30, 2**30)
            plane, e = denominator.value(values, k, 32, 11)
            return Coordinate(plane, e, W, x, y, wrap, k, denominator.q, any_size)
        k = whole_part(values, wrap)
        plane, e = denominator.value(values, k, 10)
        return Coordinate(plane, e, W, x, y, wrap, k, None, any_size)

    # ---- Filters --------------------------------------------------------------------------

    def filtered(self, s, t, q, W, x, y):
        """[R10.12] to [R10.15]"""
        low, mag = self.state.min_filter, self.state.mag_filter
        if (low, mag) in ((MinFilter.Linear, MagFilter.Linear),
                          (MinFilter.Nearest, MagFilter.Nearest)):
            return self.look_up(self.lod.base, mag == MagFilter.Linear, s, t)
        bits = self.rho(s, t, q, W, x, y).view(np.int32).astype(np.int64)
        special = mag == MagFilter.Linear and low in (MinFilter.NearestMipmapNearest,
                                                      MinFilter.NearestMipmapLinear)
        magnified = bits <= (0x3FB504F3 if special else 0x3F800000)
        result = self.look_up(self.lod.base, mag == MagFilter.Linear, s, t)
        result[~magnified] = self.minified(low, bits, s, t)[~magnified]
        return result

    def rho(self, s, t, q, W, x, y):
        """[R10.12]"""
        w, h = self.texture.sides(self.lod.base)
        most = joined_slopes(((slopes(s.plane, q, x, y), 2.0**s.e * w),
                              (slopes(t.plane, q, x, y), 2.0**t.e * h)), self.exact_rho)
        return self.lod.of((most.astype(np.float32) * (W * W)) * np.float32(2.0**-16))

    def minified(self, low, bits, s, t):
        """[R10.13]"""
        linear = low in LINEAR_FILTERS
        base, last = self.lod.base, self.lod.last
        if low in (MinFilter.Nearest, MinFilter.Linear):
            return self.look_up(base, linear, s, t)
        if low in (MinFilter.NearestMipmapNearest, MinFilter.LinearMipmapNearest):
            level = np.clip(base + ((bits - 0x3F3504F4) >> 23), base, last)
            return self.by_level(level, linear, s, t)
        level = base + ((bits - 0x3F800000) >> 23)  # [R10.14]
        first = np.clip(level, base, last)
        a = self.by_level(first, linear, s, t)
        b = self.by_level(np.minimum(first + 1, last), linear, s, t)
        f = BETWEEN_LEVELS[(bits >> 15) & 255][:, None]
        return np.where((level >= last)[:, None], a, a + (((b - a) * f + 128) >> 8))

    def by_level(self, level, linear, s, t):
        result = np.zeros((len(level), 4), np.int64)
        for one_level in np.unique(level):
            here = level == one_level
            result[here] = self.look_up(int(one_level), linear, s, t)[here]
        return result

    def look_up(self, level, linear, s, t):
        """[R10.10], [R10.11]"""
        w, h = self.texture.sides(level)
        p, q = s.position(w), t.position(h)
        around = self.with_border(level)
        if not linear:
            return around[t.wrapped(q >> 8, h) + 1, s.wrapped(p >> 8, w) + 1].copy()
        p, q = s.limited(p, w) - 128, t.limited(q, h) - 128
        left, right = (s.filtered_index((p >> 8) + k, w) for k in (0, 1))
        low, high = (t.filtered_index((q >> 8) + k, h) for k in (0, 1))
        a, b = around[low + 1, left + 1], around[low + 1, right + 1]
        c, d = around[high + 1, left + 1], around[high + 1, right + 1]
        return bilinear(a, b, c, d, p, q, self.profile.color_bits)

    def with_border(self, level):
        """[R10.25] A level with a texel more on each side."""
        if self.texture.bordered[level] is not None:
            return self.texture.bordered[level]
        image = self.texture.levels[level]
        h, w = image.shape[:2]
        around = np.empty((h + 2, w + 2, 4), np.int64)
        color = np.array([[[quantize(v, self.profile.color_bits) for v in self.border_color]]])
        around[:] = completed(color, self.texture.format, one(self.profile.color_bits))
        around[1:-1, 1:-1] = image
        return around

    def shadow(self, s, t, r):
        """[R10.18]"""
        bits = self.texture.depth_bits
        u = r.u if self.projective else np.zeros_like(r.u)
        depth = to_integer_array(np.floor(u.astype(np.float64) * 2.0**(r.e + bits)), 0, one(bits))
        return self.compared(s, t, depth)

    def compared(self, s, t, depth):
        w, h = self.texture.sides(self.lod.base)
        around = np.pad(self.texture.depths, 1, constant_values=quantize(
            self.border_color[0], self.texture.depth_bits))  # [R10.30]
        stored = around[t.wrapped(t.position(h) >> 8, h) + 1, s.wrapped(s.position(w) >> 8, w) + 1]
        lit = np.where(compare(self.compare_func, depth, stored), one(self.profile.color_bits), 0)
        return np.repeat(lit[:, None], 4, axis=1)


def between_levels(m):
    """[R10.15]"""
    return min(255, round(256 * math.log2(1 + m / 256)))


BETWEEN_LEVELS = np.array([between_levels(m) for m in range(256)], dtype=np.int64)


def look_ups(min_filter):
    """[R14.6]"""
    return {MinFilter.Nearest: 1, MinFilter.NearestMipmapNearest: 1,
            MinFilter.NearestMipmapLinear: 2, MinFilter.Linear: 4,
            MinFilter.LinearMipmapNearest: 4, MinFilter.LinearMipmapLinear: 8}[min_filter]
