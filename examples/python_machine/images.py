"""Chapter 15: the textures of a recording."""
from dataclasses import dataclass
from typing import Any

import numpy as np


@dataclass
class Image:
    """A texture: texels of level 0, or the levels that were given."""
    texels: Any
    given: Any = None
    format: int = 0
    dimensions: int = 2
    border: bool = False
    srgb: bool = False
    layers: int = 1
    cube: bool = False
    depths: bool = False

    def needs_r(self):
        """[R10.38]"""
        return self.dimensions == 3 or self.cube or self.depths


def image_of(table):
    """[R5.4], [R15.2] Rows of texels of 16 bits, from the bottom."""
    if table.Texels8Length():
        texels = table.Texels8AsNumpy().astype(np.int64) * 257
    else:
        texels = table.Texels16AsNumpy().astype(np.int64)
    if table.LevelCount() == 0:
        return Image(texels.reshape(table.Height(), table.Width(), 4), srgb=table.Srgb())
    return Image(None, given_levels(table, texels), table.Format(), table.Dimensions(),
                 table.Border(), table.Srgb(), 6 if table.Cube() else table.Layers(),
                 table.Cube(), table.Depths())


def given_levels(table, texels):
    """[R10.23] Level after level, borders included."""
    levels, more = [], 2 if table.Border() else 0
    width, height, layers = table.Width(), table.Height(), table.Layers()
    for _ in range(table.LevelCount()):
        rows = height + (more if table.Dimensions() != 1 else 0)
        rows *= 6 if table.Cube() else layers  # one layer above the other
        size = 4 * (width + more) * rows
        levels.append(texels[:size].reshape(rows, width + more, 4))
        texels = texels[size:]
        width, height, layers = (max(1, side // 2) for side in (width, height, layers))
    return levels
