"""Chapter 11: fog, by a factor at the vertex or by a table at the pixel."""
import math

import numpy as np

from .elementary import exp
from .numbers import bounded, divide, larger, mul, quantize
from .state import FogCoordinate, FogMode, FogSource

LN2 = float.fromhex("0x1.62e42fefa39efp-1")


def factor(fog, z, bits):
    """[R11.2]"""
    if fog.mode == FogMode.Linear:
        return quantize(divide(fog.end - z, fog.end - fog.start), bits)
    if fog.mode == FogMode.Exp:
        return quantize(exp(-(fog.density * z)), bits)
    return quantize(exp(-((fog.density * z) * (fog.density * z))), bits)


def per_fragment(state, profile):
    """[R11.4]"""
    if state.fog.coordinate == FogCoordinate.Profile:
        return profile.fragment_fog
    return state.fog.coordinate == FogCoordinate.Fragment


def vertex_value(state, profile, p_eye, coordinate):
    """[R11.3], [R11.5], [R11.6], [R11.8] The value that clipping interpolates."""
    given = state.fog_source == FogSource.Coordinate
    z = bounded(coordinate if given else -p_eye[2], 2.0**200)
    if per_fragment(state, profile):
        return divide(z, unit(state, profile.color_bits))
    return float(factor(state.fog, z if given or z > 0 else 0.0, profile.color_bits))


def unit(state, bits):
    """[R11.6], [R11.8] The distance that is 1 in values of fog per fragment."""
    fog = state.fog
    if state.fog_source == FogSource.Coordinate and fog.mode == FogMode.Linear:
        return abs(fog.end - fog.start)
    return table_depth(fog, bits)


def factors_of_coordinates(state, u, e, k, bits):
    """[R11.8] u: float32 of pixels."""
    scale = unit(state, bits)
    return np.array([factor(state.fog, scale * (k + float(v) * 2.0**e), bits) for v in u],
                    dtype=np.int64)


def table_depth(fog, bits):
    """[R11.6] The distance where the table ends."""
    if fog.mode == FogMode.Linear:
        return larger(larger(fog.start, fog.end), 1e-30)
    if fog.mode == FogMode.Exp:
        return divide((bits + 1) * LN2, fog.density)
    return divide(math.sqrt((bits + 1) * LN2), fog.density)


class Table:
    """[R11.7]"""

    def __init__(self, fog, bits):
        self.steps = 256 if bits == 8 else 1024
        step = table_depth(fog, bits) / self.steps
        self.values = np.array([factor(fog, i * step, bits) for i in range(self.steps + 1)],
                               dtype=np.int64)

    def factors(self, u, e):
        """u: float32 of pixels, the coordinate being u 2^e [R9.15]."""
        n = self.steps
        t = u * np.float32(2.0**(e + n.bit_length() - 1 + 8))
        position = np.trunc(np.minimum(t, np.float32(256 * n))).astype(np.int64)
        i = position >> 8
        low = np.minimum(i, n - 1)
        a, b = self.values[low], self.values[low + 1]
        between = a + (((b - a) * (position & 255) + 128) >> 8)
        return np.where(i >= n, self.values[n], between)


def fogged(colors, factors, fog, bits):
    """[R11.1] colors: rows of R, G, B, A."""
    one = (1 << bits) - 1
    result = colors.copy()
    for c in range(3):
        fog_color = quantize(fog.color[c], bits)
        result[:, c] = mul(factors, colors[:, c], bits) + mul(one - factors, fog_color, bits)
    return result
