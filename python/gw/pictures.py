"""Arrays as pictures, in files and in notebooks. Values are not changed."""
from __future__ import annotations

import os
import struct
import zlib
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._gw import Error, write_file, write_picture


class Picture:
    """Pixels with the top row first; 8 or 16 bits a channel. Notebooks show it."""

    def __init__(self, pixels: NDArray[Any], zoom: int = 1) -> None:
        self.pixels = pixels
        self.zoom = zoom

    def png(self) -> bytes:
        """The bytes of a PNG file."""
        pixels = self._zoomed()
        height, width = pixels.shape[:2]
        wide = pixels.dtype.itemsize == 2
        kind = 0 if pixels.ndim == 2 else 2
        rows = np.ascontiguousarray(pixels.astype(">u2") if wide else pixels)
        bytes_of_rows = rows.view(np.uint8).reshape(height, -1)
        filtered = np.zeros((height, bytes_of_rows.shape[1] + 1), np.uint8)
        filtered[:, 1:] = bytes_of_rows
        header = struct.pack(">IIBBBBB", width, height, 16 if wide else 8, kind, 0, 0, 0)
        return (
            b"\x89PNG\r\n\x1a\n"
            + _chunk(b"IHDR", header)
            + _chunk(b"IDAT", zlib.compress(filtered.tobytes(), 6))
            + _chunk(b"IEND", b"")
        )

    def save(self, file: str | os.PathLike[str]) -> None:
        """Writes a file, whole or not at all, in the format of its extension, as gw render does."""
        if os.fsdecode(file).lower().endswith(".png"):
            write_file(file, self.png())
        else:
            write_picture(file, self._zoomed()[::-1], 8 * self.pixels.dtype.itemsize)

    def _zoomed(self) -> NDArray[Any]:
        return self.pixels.repeat(self.zoom, 0).repeat(self.zoom, 1)

    def _repr_png_(self) -> bytes:
        return self.png()


def picture(plane: NDArray[Any], bits: int = 8, zoom: int = 1) -> Picture:
    """A plane as a picture: colours (height, width, 3 or 4) of `bits` bits, or one value a pixel,
    which is stretched from the least (black) to the greatest (white). Alpha is left out."""
    plane = np.asarray(plane)
    if plane.ndim == 3 and plane.shape[2] in (3, 4) and plane.size:
        colors = plane[::-1, :, :3]
        _check_colors(colors, bits)
        if bits == 8:
            return Picture(colors.astype(np.uint8), zoom)
        return Picture((colors.astype(np.uint32) * 65535 // ((1 << bits) - 1)).astype(np.uint16),
                       zoom)
    if plane.ndim == 2 and plane.size:
        values = plane[::-1].astype(np.float64)
        if not np.isfinite(values).all():
            raise Error("plane: values that are not finite; expected numbers")
        low, high = values.min(), values.max()
        return Picture(((values - low) * (255 / (high - low or 1))).astype(np.uint8), zoom)
    raise Error(
        f"plane: an array of shape {plane.shape}; expected (height, width, 3 or 4) or (height, width)")


def _check_colors(colors: NDArray[Any], bits: int) -> None:
    if not 1 <= bits <= 16:
        raise Error(f"bits: {bits}; expected 1 .. 16")
    if colors.dtype.kind not in "iub":
        raise Error(f"plane: colours of type {colors.dtype}; expected whole numbers")
    most = (1 << bits) - 1
    if colors.min() < 0 or colors.max() > most:
        raise Error(
            f"plane: colours from {colors.min()} to {colors.max()}; expected 0 .. {most}, or bits = "
            "the plane's bits a channel")


def _chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
