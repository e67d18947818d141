"""[R13.13] The texel of drawn pixels, whose coordinates do not change."""
import numpy as np

from .numbers import one, to_integer_array
from .state import MagFilter, Wrap
from .texture import Coordinate, TextureStage


class Place:
    """[R13.13] A coordinate that does not change; otherwise as `Coordinate`."""

    limited, filtered_index = Coordinate.limited, Coordinate.filtered_index
    wrapped = Coordinate.wrapped

    def __init__(self, value, wrap):
        self.value, self.wrap = value, wrap

    def position(self, side):
        scaled = np.array([np.floor(self.value * (256.0 * side))])
        return to_integer_array(scaled, -2**30, 2**30)


def texel_in_place(state, profile, texture, strq):
    """[R13.13] A row of R, G, B, A."""
    s, t, r, q = strq
    if q <= 0:
        return np.full((1, 4), one(profile.color_bits), np.int64)
    lookup = state.texture
    stage = TextureStage(state, profile, texture, False)
    wrap_t = lookup.wrap_t if texture.dimensions == 2 else Wrap.Clamp  # [R10.26]
    s, t = Place(s / q, lookup.wrap_s), Place(t / q, wrap_t)
    if lookup.shadow_compare:
        bits = texture.depth_bits
        incoming = to_integer_array(np.array([np.floor(r / q * 2.0**bits)]), 0, one(bits))
        return stage.compared(s, t, incoming)
    return stage.look_up(stage.lod.base, lookup.mag_filter == MagFilter.Linear, s, t)
