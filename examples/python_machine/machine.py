"""Chapters 1, 5 and 14: the machine, its passes, counters and digests.

It takes lists that a machine accepts: the refusals of [R5.7] are not part of this example.
"""
from collections import Counter

import numpy as np
import xxhash

from . import draw, pixels, surfaces
from .layers import layered
from .state import Plane, State
from .texture import Texture


class Planes:
    """[R1.5], [R1.6] Arrays [row from the bottom, column], of integers."""

    def __init__(self, width, height):
        self.color = np.zeros((height, width, 4), np.int64)
        self.depth = np.zeros((height, width), np.int64)
        self.stencil = np.zeros((height, width), np.int64)
        self.accum = np.zeros((height, width, 4), np.int64)
        self.back = np.zeros((height, width, 4), np.int64)

    def of(self, plane):
        return (self.color, self.depth, self.stencil, self.accum, self.back)[plane]

    def drawn(self, buffer):
        """[R12.16] The colour planes of a draw buffer."""
        front, back = [self.color], [self.back]
        return ([], front, back, front + back)[buffer]


STORED = {Plane.Color: "<u2", Plane.Depth: "<u4", Plane.Stencil: "u1", Plane.Accum: "<i4",
          Plane.Back: "<u2"}


def digest(values, plane):
    """[R14.10] Of values of that plane, as 32 hexadecimal digits."""
    values = values.astype(STORED[plane])
    height, width = values.shape[:2]
    blocks = b"".join(
        xxhash.xxh3_128_digest(values[y:y + 64, x:x + 64].tobytes())
        for y in range(0, height, 64) for x in range(0, width, 64))
    return xxhash.xxh3_128_hexdigest(blocks)


class Machine:
    """[R1.1] A machine has a profile and a window, and executes commands."""

    def __init__(self, profile, width, height):
        self.window_profile = profile
        self.surfaces = {0: surfaces.Surface(width, height, 15, profile, [Planes(width, height)])}
        self.use(0)
        self.state = State()
        self.slots, self.readbacks = {}, {}
        self.counters = Counter()
        self.textures = {}
        self.pass_name = None
        self.query, self.queries = None, []  # [R14.11]
        self.color_map = None

    def use(self, number):
        """[R16.2] The surface that commands draw to."""
        self.number, surface = number, self.surfaces[number]
        self.surface, self.planes = surface, surface.values
        self.width, self.height = surface.width, surface.height
        profile = self.profile = surface.profile
        # [R14.8]
        self.bytes_of = {"Color": 4 * -(-profile.color_bits // 8),
                         "Depth": -(-profile.depth_bits // 8), "Stencil": 1,
                         "Accum": 4 * -(-profile.accum_bits // 8)}

    @property
    def state(self):
        return surfaces.state_on(self.surface, self.given_state, self.number)

    @state.setter
    def state(self, given):
        self.given_state = given

    def execute(self, commands):
        """Runs commands; yields (name, counters, digests, queries) of each pass that ends
        [R14.1]."""
        for command in commands:
            if command.kind == "BeginPass":
                if self.pass_name is not None:
                    yield self.end_pass()
                self.pass_name = command.name
            elif command.kind == "SetState":
                self.state = command.state
            else:
                if self.pass_name is None:
                    self.pass_name = ""
                self.run(command)
            self.color_map = command.color_map
        if self.pass_name is not None:
            yield self.end_pass()

    def end_pass(self):
        window = self.surfaces[0].values  # [R16.4]
        digests = {plane.name.lower(): digest(window.of(plane), plane) for plane in Plane
                   if plane != Plane.Back or self.profile.color_planes == 2}
        if self.color_map is not None:  # [R18.6]
            digests["shown"] = digest(self.color_map.shown(window.color), Plane.Color)
        ended = (self.pass_name, {k: v for k, v in self.counters.items() if v}, digests,
                 self.queries)
        if self.query is not None:
            self.query += self.counters["written"]
        self.counters.clear()
        self.queries = []
        return ended

    def run_query(self, command):
        """[R14.11] While a query is active, `query` counts from before the pass began."""
        if command.begin:
            self.query = -self.counters["written"]
        else:
            self.queries.append([command.key, self.query + self.counters["written"]])
            self.query = None

    def run(self, command):
        """[R5.1]"""
        if command.kind == "Query":
            self.run_query(command)
            return
        {"Clear": pixels.clear, "Draw": draw.run, "WriteSpans": pixels.write_spans,
         "WritePixels": pixels.write_pixels, "Accumulate": pixels.accumulate,
         "Copy": pixels.copy, "CopyTexture": pixels.copy_texture,
         "Read": pixels.read, "DrawPixels": pixels.draw_pixels,
         "SwapBuffers": pixels.swap_buffers, "MakeSurface": surfaces.make,
         "UseSurface": surfaces.use, "Blit": surfaces.blit}[command.kind](self, command)

    def texture_of(self, command, unit):
        """The texture of a unit: an image's pyramid, made once, a slot, or a surface's plane."""
        image, plane = command.texture_of(unit), command.plane_of(unit)
        if plane is not None:
            return surfaces.texture(self, *plane)
        if image is None:
            return self.slots[command.slot_of(unit)]
        key = id(image)
        if key not in self.textures:
            make = layered if image.needs_r() else Texture.of_image
            self.textures[key] = make(image, self.window_profile)
        return self.textures[key]
