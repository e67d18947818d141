"""Chapter 18: indices, and how a screen shows them."""
from dataclasses import dataclass

import numpy as np

from .numbers import one

WINDOW = 0  # [R18.5] the planes that show nothing below


@dataclass
class ColorMap:
    """[R18.4] Of a list."""
    planes: int
    bits: int
    bits_in_r: int
    entries: np.ndarray

    def index(self, color):
        """[R18.1] Of pixels R, G, B, A."""
        low, high = color[..., 0] & one(self.bits_in_r), color[..., 1] << self.bits_in_r
        return (low | high) & one(self.bits)

    def shown(self, color):
        """[R18.5] R, G, B, A of 8 bits."""
        index = self.index(color)
        entry = self.entries[index]
        rgba = np.stack([entry & 255, entry >> 8 & 255, entry >> 16 & 255,
                         np.full_like(entry, 255)], axis=-1)
        if self.planes != WINDOW:
            rgba[index == 0] = 0
        return rgba


def color_map_of(given, before):
    """[R18.4] Of a list that has this table, after a list with the map `before`."""
    if given is None:
        return before
    if given.bits == 0:
        return None
    return ColorMap(given.planes, given.bits, given.bitsInR, np.array(given.entries, np.int64))
