"""Chapter 8: the secondary colour of a fragment is added to its colour."""
import numpy as np

from .numbers import one
from .state import ColorSource


def sums_colors(state):
    """[R8.13]"""
    if state.color_source == ColorSource.Lighting:
        return state.separate_specular
    return state.color_sum and state.color_source == ColorSource.Vertex


def summed(colors, secondary, bits):
    """[R8.13] colors: rows of R, G, B, A; secondary: a row, or as many, of R, G, B."""
    result = colors.copy()
    result[:, :3] = np.minimum(colors[:, :3] + secondary, one(bits))
    return result
