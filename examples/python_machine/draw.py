"""[R1.9] A Draw from its mesh to fragments: chapters 6 to 12 in their order."""
import numpy as np

from . import antialiasing, fog, samples
from .color_sum import summed, sums_colors
from .environment import environments
from .fragments import FragmentStage
from .geometry import PrimitiveStage
from .numbers import one, rne
from .rasterization import (Frame, OuterFrame, Perspective, covered, offset, quotient,
                            reciprocal, whole)
from .layers import VolumeStage, unit_look_ups
from .resolved import Resolved
from .state import ColorSource, FogSource, ShadeModel, draw_box
from .texture import TextureStage
from .texture_coordinates import divided_by_q


def run(machine, draw):
    counters = machine.counters
    counters["draws"] += 1
    counters["vertices"] += len(draw.mesh.positions)
    before = counters["fragments"]
    stage = PixelStage(machine, draw)
    for pieces in PrimitiveStage(machine, draw).run():
        stage.run(pieces)
    for unit in stage.textures:
        counters["texels"] += ((counters["fragments"] - before)
                               * unit_look_ups(machine, draw, unit))


class PixelStage:
    """Stages 7 to 12 of [R1.9]."""

    def __init__(self, machine, draw):
        self.machine, self.state, self.profile = machine, machine.state, machine.profile
        self.box = draw_box(self.state, machine.width, machine.height)
        self.fragments = FragmentStage(machine, Resolved(self.state, self.profile))
        has_id = self.state.color_source == ColorSource.PolygonId
        self.textures = {} if has_id else {unit: self.texture_stage(machine, draw, unit)
                                           for unit in draw.units()}
        self.fog = self.state.fog if self.state.fog.enable and not has_id else None
        self.fog_table = None
        if self.fog and fog.per_fragment(self.state, self.profile):
            self.fog_table = fog.Table(self.fog, self.profile.color_bits)

    def texture_stage(self, machine, draw, unit):
        state, texture = self.state.of_unit(unit), machine.texture_of(draw, unit)
        stage = VolumeStage if texture.with_r else TextureStage
        return stage(state, self.profile, texture, divided_by_q(state, draw, unit), unit)

    def run(self, pieces):
        """Of one primitive: a smooth polygon has several pieces."""
        s = self.profile.subpixel_bits
        if antialiasing.is_smooth(self.state, pieces[0]):
            self.run_smooth(pieces, s)
            return
        ready, = pieces
        if samples.has_places(self.machine):
            samples.draw(self, ready)
            return
        x, y = covered(ready.corners, self.box, self.state, s, ready.steps)
        if len(ready.corners) == 2 and self.state.diamond_lines:
            inner = np.array([antialiasing.has_center(ready.corners, int(i), int(j), s)
                              for i, j in zip(x, y)], bool)
            self.shade(ready, OuterFrame(ready.corners, s), x[~inner], y[~inner])  # [R9.34]
            x, y = x[inner], y[inner]
        frame = Frame(ready.corners, s)
        if len(ready.corners) == 1 and self.state.point_sprite:
            frame.sprite_size = whole(ready.corners[0].vertex.point_size)
        self.shade(ready, frame, x, y)

    def run_smooth(self, pieces, s):
        """[R9.28]"""
        c = antialiasing.covered(pieces, self.box, self.state, self.profile)
        for k, ready in enumerate(pieces):
            for frame_of, outer in ((Frame, False), (OuterFrame, True)):
                here = (c.piece == k) & (c.outer == outer)
                self.shade(ready, frame_of(ready.corners, s), c.x[here], c.y[here],
                           c.coverage[here])

    def shade(self, ready, frame, x, y, coverage=None, samples=None):
        bits = self.profile.color_bits
        if len(x) == 0:
            return
        depths = samples.depths if samples else self.depths(ready, frame, x, y)
        colors = self.colors(ready, frame, x, y, [c.color for c in ready.corners])
        colors = environments(colors, {
            unit: (stage.texels(frame, ready.corners, x, y), stage.texture.format)
            for unit, stage in self.textures.items()}, self.state, bits)
        if sums_colors(self.state):
            colors = summed(colors, self.colors(ready, frame, x, y,
                                                [c.secondary for c in ready.corners]), bits)
        if self.fog:
            colors = fog.fogged(colors, self.fog_factors(ready, frame, x, y), self.fog, bits)
        if coverage is not None:
            colors = antialiasing.with_coverage(colors, coverage, self.profile.coverage_bits)
        self.fragments.run(x, y, colors, depths, ready.front, samples.masks if samples else None)

    def depths(self, ready, frame, x, y):
        """[R9.11], [R9.12]"""
        plane = frame.plane([c.Z for c in ready.corners])
        values = plane.at(x, y)
        sloped = None
        if ready.filled and self.state.polygon_offset.enable:
            sloped = plane
        if ready.offset:  # [R9.22]
            sloped = Frame(ready.offset, self.profile.subpixel_bits).plane(
                [c.Z for c in ready.offset])
        if sloped is not None:
            moved = values + offset(self.state, sloped, self.profile.depth_bits)
            values = np.clip(moved, 0, one(self.profile.depth_bits))
        return values

    def colors(self, ready, frame, x, y, given):
        """[R9.10], [R9.16], [R8.12] given: a colour of each corner, primary or secondary."""
        channels = [[color[c] for color in given] for c in range(len(given[0]))]
        if not (self.profile.perspective_color and self.state.shade_model == ShadeModel.Smooth):
            return np.stack([frame.plane(values).at(x, y) for values in channels], axis=1)
        most = one(self.profile.color_bits)
        perspective = Perspective(frame, [c.w for c in ready.corners])
        W = reciprocal(perspective.q, x, y)
        result = []
        for values in channels:
            plane, e = perspective.value([v / most for v in values], 0, 10)
            u = quotient(plane, W, x, y) * np.float32(2.0**e)
            nearest = np.rint(u * np.float32(most)).astype(np.int64)
            result.append(np.clip(nearest, min(values), max(values)))
        return np.stack(result, axis=1)

    def fog_factors(self, ready, frame, x, y):
        """[R11.5], [R11.6], [R11.8]"""
        values = [c.vertex.fog for c in ready.corners]
        if not fog.per_fragment(self.state, self.profile):
            return frame.plane([rne(v) for v in values]).at(x, y)
        perspective = Perspective(frame, [c.w for c in ready.corners])
        W = reciprocal(perspective.q, x, y)
        if self.state.fog_source == FogSource.Coordinate:
            plane, e = perspective.value(values, min(values), 512)
            return fog.factors_of_coordinates(self.state, quotient(plane, W, x, y), e,
                                              min(values), self.profile.color_bits)
        plane, e = perspective.value([abs(v) for v in values], 0, 40)
        u = quotient(plane, W, x, y)
        return self.fog_table.factors(u, e)
