"""Chapter 10, second section: textures at the pixel."""
import math

import numpy as np

from .numbers import clamp, mul, one, quantize, rescale, to_integer_array
from .rasterization import Perspective, Projective, quotient, reciprocal, slopes
from .state import MagFilter, MinFilter, TexEnv, TextureFormat, Wrap

LINEAR_FILTERS = (MinFilter.Linear, MinFilter.LinearMipmapNearest, MinFilter.LinearMipmapLinear)


def pyramid(image):
    """[R10.6] All levels of an image of 16 bits: arrays [row, column, channel]."""
    levels = [image.astype(np.int64)]
    while levels[-1].shape[:2] != (1, 1):
        v = levels[-1]
        h, w = v.shape[:2]
        j, i = np.arange(max(h // 2, 1)), np.arange(max(w // 2, 1))
        low, high = 2 * j if h > 1 else j, 2 * j + 1 if h > 1 else j
        left, right = 2 * i if w > 1 else i, 2 * i + 1 if w > 1 else i
        a, b = v[np.ix_(low, left)], v[np.ix_(low, right)]
        c, d = v[np.ix_(high, left)], v[np.ix_(high, right)]
        levels.append((a + b + c + d + 2) >> 2)
    return levels


def texels_of(level, profile):
    """[R10.6], [R10.23]"""
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

    def __init__(self, levels, depths=None):
        self.levels, self.depths = levels, depths
        self.bordered = [None] * len(levels)  # the levels with their borders [R10.25]
        self.format, self.dimensions = TextureFormat.RGBA, 2

    @classmethod
    def of_image(cls, image, profile):
        if image.given is None:
            return cls([texels_of(level, profile) for level in pyramid(image.texels)])
        levels = [texels_of(completed(level, image.format), profile) for level in image.given]
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
        return cls([np.repeat(gray[:, :, None], 4, axis=2)], values)

    def log2_sides(self, level):
        h, w = self.levels[level].shape[:2]
        return w.bit_length() - 1, h.bit_length() - 1


class Coordinate:
    """[R9.15] u 2^e of one coordinate at the pixels, and the whole part k [R10.8]."""

    def __init__(self, plane, e, W, x, y, wrap, k, wide_q=None):
        self.plane, self.e, self.wrap, self.k = plane, e, wrap, k
        self.u = quotient(plane, W, x, y)
        self.wide = None if wide_q is None else plane.at(x, y) / wide_q.at(x, y)

    def position(self, log2_side):
        """[R10.9] In units of 1/256 texel."""
        if self.wide is not None:
            return self.wide_position(log2_side + 8)
        limit = np.float32(2.0**30)
        scaled = self.u * np.float32(2.0**(self.e + log2_side + 8))
        p = np.floor(np.minimum(np.maximum(scaled, -limit), limit)).astype(np.int64)
        return p + self.k * 2**(log2_side + 8) if self.wrap != Wrap.Repeat else p

    def wide_position(self, shift):
        """[R10.27]"""
        p = np.floor(self.wide * 2.0**(self.e + shift)).astype(np.int64)
        if self.wrap == Wrap.Repeat:
            return p & (2**shift - 1)
        return np.clip(p + self.k * 2**shift, -2**30, 2**30)

    def limited(self, p, log2_side):
        """[R10.25]"""
        return np.clip(p, 0, 2**(log2_side + 8)) if self.wrap == Wrap.BorderClamp else p

    def filtered_index(self, index, log2_side):
        """[R10.25] -1 and the side are the border."""
        return index if self.wrap == Wrap.BorderClamp else self.wrapped(index, log2_side)

    def wrapped(self, index, log2_side):
        if self.wrap == Wrap.Repeat:
            return index & (2**log2_side - 1)
        return np.clip(index, 0, 2**log2_side - 1)


def whole_part(values, wrap):
    """[R10.8]"""
    k = math.floor(min(values))
    return clamp(k, -1024, 1023) if wrap != Wrap.Repeat else k


class TextureStage:
    """Looks one draw's texture up at the pixels of one piece, line or point."""

    def __init__(self, state, profile, texture, projective, border_color):
        self.border_color = border_color
        self.state, self.profile, self.texture = state, profile, texture
        self.projective = projective  # [R10.22]

    def texels(self, frame, corners, x, y):
        given = [c.vertex.texture for c in corners]
        w = [c.w for c in corners]
        if self.projective:
            denominator = Projective(frame, w, [g[3] for g in given])
            in_front = denominator.q.at(x, y) >= 1
        else:
            denominator = Perspective(frame, w)
            in_front = np.ones(len(x), bool)
        W = reciprocal(denominator.q, x, y)
        wrap_t = self.state.wrap_t if self.texture.dimensions == 2 else Wrap.Clamp  # [R10.26]
        s, t, r = (self.coordinate(denominator, [g[c] for g in given], wrap, W, x, y)
                   for c, wrap in enumerate((self.state.wrap_s, wrap_t, Wrap.Repeat)))
        if self.state.shadow_compare:
            result = self.shadow(s, t, r)
        else:
            result = self.filtered(s, t, denominator.q, W, x, y)
        result[~in_front] = one(self.profile.color_bits)  # [R10.19]
        return result

    def coordinate(self, denominator, values, wrap, W, x, y):
        if self.projective:
            plane, e = denominator.value(values)
            return Coordinate(plane, e, W, x, y, wrap, 0)
        if max(values) - math.floor(min(values)) > 2.0**10:  # [R9.19]
            k = math.floor(min(values))
            k = k if wrap == Wrap.Repeat else clamp(k, -2**30, 2**30)
            plane, e = denominator.value(values, k, 32, 11)
            return Coordinate(plane, e, W, x, y, wrap, k, denominator.q)
        k = whole_part(values, wrap)
        plane, e = denominator.value(values, k, 10)
        return Coordinate(plane, e, W, x, y, wrap, k)

    # ---- Filters --------------------------------------------------------------------------

    def filtered(self, s, t, q, W, x, y):
        """[R10.12] to [R10.15]"""
        low, mag = self.state.min_filter, self.state.mag_filter
        if (low, mag) in ((MinFilter.Linear, MagFilter.Linear),
                          (MinFilter.Nearest, MagFilter.Nearest)):
            return self.look_up(0, mag == MagFilter.Linear, s, t)
        bits = self.rho(s, t, q, W, x, y).view(np.int32).astype(np.int64)
        special = mag == MagFilter.Linear and low in (MinFilter.NearestMipmapNearest,
                                                      MinFilter.NearestMipmapLinear)
        magnified = bits <= (0x3FB504F3 if special else 0x3F800000)
        result = self.look_up(0, mag == MagFilter.Linear, s, t)
        result[~magnified] = self.minified(low, bits, s, t)[~magnified]
        return result

    def rho(self, s, t, q, W, x, y):
        """[R10.12]"""
        log2_w, log2_h = self.texture.log2_sides(0)
        most = np.maximum(slopes(s.plane, q, x, y) * 2.0**(s.e + log2_w),
                          slopes(t.plane, q, x, y) * 2.0**(t.e + log2_h))
        return (most.astype(np.float32) * (W * W)) * np.float32(2.0**-16)

    def minified(self, low, bits, s, t):
        """[R10.13]"""
        linear = low in LINEAR_FILTERS
        last = len(self.texture.levels) - 1
        if low in (MinFilter.Nearest, MinFilter.Linear):
            return self.look_up(0, linear, s, t)
        if low in (MinFilter.NearestMipmapNearest, MinFilter.LinearMipmapNearest):
            level = np.clip((bits - 0x3F3504F4) >> 23, 0, last)
            return self.by_level(level, linear, s, t)
        level = (bits - 0x3F800000) >> 23  # [R10.14]
        first = np.clip(level, 0, last)
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
        image = self.texture.levels[level]
        log2_w, log2_h = self.texture.log2_sides(level)
        p, q = s.position(log2_w), t.position(log2_h)
        if not linear:
            return image[t.wrapped(q >> 8, log2_h), s.wrapped(p >> 8, log2_w)].copy()
        p, q = s.limited(p, log2_w) - 128, t.limited(q, log2_h) - 128
        left, right = (s.filtered_index((p >> 8) + k, log2_w) for k in (0, 1))
        low, high = (t.filtered_index((q >> 8) + k, log2_h) for k in (0, 1))
        x, y = (p & 255)[:, None], (q & 255)[:, None]
        around = self.with_border(level)
        a, b = around[low + 1, left + 1], around[low + 1, right + 1]
        c, d = around[high + 1, left + 1], around[high + 1, right + 1]
        if self.profile.color_bits == 8:
            t0 = 64 * a + (((b - a) * 64 * x + 128) >> 8)
            t1 = 64 * c + (((d - c) * 64 * x + 128) >> 8)
            return (t0 + (((t1 - t0) * y + 128) >> 8) + 32) >> 6
        lower, upper = a * (256 - x) + b * x, c * (256 - x) + d * x
        return (lower * (256 - y) + upper * y + 2**15) >> 16

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
        bits = self.profile.depth_bits
        u = r.u if self.projective else np.zeros_like(r.u)
        depth = to_integer_array(np.floor(u.astype(np.float64) * 2.0**(r.e + bits)), 0, one(bits))
        return self.compared(s, t, depth)

    def compared(self, s, t, depth):
        log2_w, log2_h = self.texture.log2_sides(0)
        stored = self.texture.depths[t.wrapped(t.position(log2_h) >> 8, log2_h),
                                     s.wrapped(s.position(log2_w) >> 8, log2_w)]
        lit = np.where(depth <= stored, one(self.profile.color_bits), 0)
        return np.repeat(lit[:, None], 4, axis=1)


def between_levels(m):
    """[R10.15]"""
    return min(255, round(256 * math.log2(1 + m / 256)))


BETWEEN_LEVELS = np.array([between_levels(m) for m in range(256)], dtype=np.int64)


def environment(f, t, state, form, bits):
    """[R10.17], [R10.24] f: the fragments' colours, t: their texels."""
    return np.stack([environment_channel(f, t, state, form, c, bits) for c in range(4)], axis=1)


def environment_channel(f, t, state, form, c, bits):
    env, fragment, texel = state.env, f[:, c], t[:, c]
    lacks_alpha = form in (TextureFormat.RGB, TextureFormat.Luminance)
    if c == 3 and (lacks_alpha or env == TexEnv.Decal):
        return fragment
    if c < 3 and form == TextureFormat.Alpha:
        return fragment
    if env == TexEnv.Replace:
        return texel
    if env == TexEnv.Modulate or (c == 3 and form != TextureFormat.Intensity):
        return mul(fragment, texel, bits)
    weight = t[:, 3] if env == TexEnv.Decal else texel
    other = texel if env == TexEnv.Decal else quantize(state.env_color[c], bits)
    return mul(fragment, one(bits) - weight, bits) + mul(other, weight, bits)


def look_ups(min_filter):
    """[R14.6]"""
    return {MinFilter.Nearest: 1, MinFilter.NearestMipmapNearest: 1,
            MinFilter.NearestMipmapLinear: 2, MinFilter.Linear: 4,
            MinFilter.LinearMipmapNearest: 4, MinFilter.LinearMipmapLinear: 8}[min_filter]


class Place:
    """[R13.13] A coordinate that does not change; otherwise as `Coordinate`."""

    limited, filtered_index = Coordinate.limited, Coordinate.filtered_index
    wrapped = Coordinate.wrapped

    def __init__(self, value, wrap):
        self.value, self.wrap = value, wrap

    def position(self, log2_side):
        scaled = np.array([np.floor(self.value * 2.0**(log2_side + 8))])
        return to_integer_array(scaled, -2**30, 2**30)


def texel_in_place(state, profile, texture, strq):
    """[R13.13] A row of R, G, B, A."""
    s, t, r, q = strq
    if q <= 0:
        return np.full((1, 4), one(profile.color_bits), np.int64)
    lookup = state.texture
    stage = TextureStage(lookup, profile, texture, False, state.border_color)
    wrap_t = lookup.wrap_t if texture.dimensions == 2 else Wrap.Clamp  # [R10.26]
    s, t = Place(s / q, lookup.wrap_s), Place(t / q, wrap_t)
    if lookup.shadow_compare:
        bits = profile.depth_bits
        incoming = to_integer_array(np.array([np.floor(r / q * 2.0**bits)]), 0, one(bits))
        return stage.compared(s, t, incoming)
    return stage.look_up(0, lookup.mag_filter == MagFilter.Linear, s, t)
