"""Chapter 10, second section: textures at the pixel."""
import math

import numpy as np

from .numbers import clamp, mul, one, quantize, rescale, to_integer_array
from .rasterization import Perspective, Projective, quotient, reciprocal, slopes
from .state import MagFilter, MinFilter, TexEnv, Wrap

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


class Texture:
    """What a draw looks up: levels in color_bits, and the depths of a slot of the depth plane."""

    def __init__(self, levels, depths=None):
        self.levels, self.depths = levels, depths

    @classmethod
    def of_image(cls, image, bits):
        return cls([rescale(level, 16, bits) for level in pyramid(image)])

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

    def __init__(self, plane, e, W, x, y, wrap, k):
        self.plane, self.e, self.wrap, self.k = plane, e, wrap, k
        self.u = quotient(plane, W, x, y)

    def position(self, log2_side):
        """[R10.9] In units of 1/256 texel."""
        limit = np.float32(2.0**30)
        scaled = self.u * np.float32(2.0**(self.e + log2_side + 8))
        p = np.floor(np.minimum(np.maximum(scaled, -limit), limit)).astype(np.int64)
        return p + self.k * 2**(log2_side + 8) if self.wrap == Wrap.Clamp else p

    def wrapped(self, index, log2_side):
        if self.wrap == Wrap.Repeat:
            return index & (2**log2_side - 1)
        return np.clip(index, 0, 2**log2_side - 1)


def whole_part(values, wrap):
    """[R10.8]"""
    k = math.floor(min(values))
    return clamp(k, -1024, 1023) if wrap == Wrap.Clamp else k


class TextureStage:
    """Looks one draw's texture up at the pixels of one piece, line or point."""

    def __init__(self, state, profile, texture, projective):
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
        s, t, r = (self.coordinate(denominator, [g[c] for g in given], wrap, W, x, y)
                   for c, wrap in enumerate((self.state.wrap_s, self.state.wrap_t, Wrap.Repeat)))
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
        p, q = p - 128, q - 128
        left, right = (s.wrapped((p >> 8) + k, log2_w) for k in (0, 1))
        low, high = (t.wrapped((q >> 8) + k, log2_h) for k in (0, 1))
        x, y = (p & 255)[:, None], (q & 255)[:, None]
        a, b, c, d = image[low, left], image[low, right], image[high, left], image[high, right]
        if self.profile.color_bits == 8:
            t0 = 64 * a + (((b - a) * 64 * x + 128) >> 8)
            t1 = 64 * c + (((d - c) * 64 * x + 128) >> 8)
            return (t0 + (((t1 - t0) * y + 128) >> 8) + 32) >> 6
        lower, upper = a * (256 - x) + b * x, c * (256 - x) + d * x
        return (lower * (256 - y) + upper * y + 2**15) >> 16

    def shadow(self, s, t, r):
        """[R10.18]"""
        bits = self.profile.depth_bits
        log2_w, log2_h = self.texture.log2_sides(0)
        stored = self.texture.depths[t.wrapped(t.position(log2_h) >> 8, log2_h),
                                     s.wrapped(s.position(log2_w) >> 8, log2_w)]
        u = r.u if self.projective else np.zeros_like(r.u)
        depth = to_integer_array(np.floor(u.astype(np.float64) * 2.0**(r.e + bits)), 0, one(bits))
        lit = np.where(depth <= stored, one(self.profile.color_bits), 0)
        return np.repeat(lit[:, None], 4, axis=1)


def between_levels(m):
    """[R10.15]"""
    return min(255, round(256 * math.log2(1 + m / 256)))


BETWEEN_LEVELS = np.array([between_levels(m) for m in range(256)], dtype=np.int64)


def environment(f, t, state, bits):
    """[R10.17] f: the fragments' colours, t: their texels."""
    result = np.empty_like(f)
    alpha, texel_alpha = f[:, 3], t[:, 3]
    for c in range(3):
        env_color = quantize(state.env_color[c], bits)
        if state.env == TexEnv.Modulate:
            result[:, c] = mul(f[:, c], t[:, c], bits)
        elif state.env == TexEnv.Decal:
            result[:, c] = (mul(f[:, c], one(bits) - texel_alpha, bits)
                            + mul(t[:, c], texel_alpha, bits))
        elif state.env == TexEnv.Blend:
            result[:, c] = (mul(f[:, c], one(bits) - t[:, c], bits)
                            + mul(env_color, t[:, c], bits))
        else:
            result[:, c] = t[:, c]
    if state.env == TexEnv.Decal:
        result[:, 3] = alpha
    elif state.env == TexEnv.Replace:
        result[:, 3] = texel_alpha
    else:
        result[:, 3] = mul(alpha, texel_alpha, bits)
    return result


def look_ups(min_filter):
    """[R14.6]"""
    return {MinFilter.Nearest: 1, MinFilter.NearestMipmapNearest: 1,
            MinFilter.NearestMipmapLinear: 2, MinFilter.Linear: 4,
            MinFilter.LinearMipmapNearest: 4, MinFilter.LinearMipmapLinear: 8}[min_filter]
