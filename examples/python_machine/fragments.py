"""Chapter 12: what happens to fragments. Those of one call lie on different pixels."""
import re
from pathlib import Path

import numpy as np

from . import samples
from .numbers import mul, one
from .resolved import with_written_bits
from .state import BlendEquation, BlendFactor, CompareFunc, DrawBuffer, StencilOp

PAGE = Path(__file__).resolve().parents[2] / "docs" / "manual" / "fragments.md"


def compare(func, incoming, stored):
    """[R12.4]"""
    if func == CompareFunc.Never:
        return np.zeros(len(stored), bool)
    if func == CompareFunc.Less:
        return incoming < stored
    if func == CompareFunc.Equal:
        return incoming == stored
    if func == CompareFunc.LEqual:
        return incoming <= stored
    if func == CompareFunc.Greater:
        return incoming > stored
    if func == CompareFunc.NotEqual:
        return incoming != stored
    if func == CompareFunc.GEqual:
        return incoming >= stored
    return np.ones(len(stored), bool)


def stencil_operation(operation, stored, ref, most):
    """[R12.6]"""
    if operation == StencilOp.Keep:
        return stored
    if operation == StencilOp.Zero:
        return np.zeros_like(stored)
    if operation == StencilOp.Replace:
        return np.full_like(stored, ref & most)
    if operation == StencilOp.Incr:
        return np.where(stored < most, stored + 1, most)
    if operation == StencilOp.Decr:
        return np.where(stored > 0, stored - 1, 0)
    if operation == StencilOp.Invert:
        return ~stored & most
    step = 1 if operation == StencilOp.IncrWrap else -1
    return (stored + step) & most


def factors(factor, s, d, constant, one_value):
    """[R12.12] Of all channels: arrays like s."""
    s_alpha, d_alpha = s[:, 3:], d[:, 3:]
    values = {
        BlendFactor.Zero: 0, BlendFactor.One: one_value,
        BlendFactor.SrcColor: s, BlendFactor.OneMinusSrcColor: one_value - s,
        BlendFactor.DstColor: d, BlendFactor.OneMinusDstColor: one_value - d,
        BlendFactor.SrcAlpha: s_alpha, BlendFactor.OneMinusSrcAlpha: one_value - s_alpha,
        BlendFactor.DstAlpha: d_alpha, BlendFactor.OneMinusDstAlpha: one_value - d_alpha,
        BlendFactor.SrcAlphaSaturate: np.minimum(s_alpha, one_value - d_alpha),
        BlendFactor.ConstantColor: constant,
        BlendFactor.OneMinusConstantColor: one_value - constant,
        BlendFactor.ConstantAlpha: constant[3],
        BlendFactor.OneMinusConstantAlpha: one_value - constant[3],
    }
    result = np.broadcast_to(values[factor], s.shape).copy()
    if factor == BlendFactor.SrcAlphaSaturate:
        result[:, 3] = one_value
    return result


def equations():
    """[R12.14] The formulas of the manual's table: of s, d, one and the products s', d'."""
    text = PAGE.read_text(encoding="utf-8").split("| equation | result | extension |")[1].split("\n\n")[0]
    rows = re.findall(r"^\| (\w+) \| `(.*)` \|", text, re.MULTILINE)
    return {BlendEquation[name]: compile(formula.replace("'", "_part"), name, "eval")
            for name, formula in rows}


EQUATIONS = equations()


def joined_by(src, dst, equation, s, d, constant, bits):
    """[R12.11] All channels."""
    s_part = mul(s, factors(src, s, d, constant, one(bits)), bits)
    d_part = mul(d, factors(dst, s, d, constant, one(bits)), bits)
    return eval(EQUATIONS[equation], {"min": np.minimum, "max": np.maximum}, {
        "s": s, "d": d, "s_part": s_part, "d_part": d_part, "one": one(bits)})


def blended(state, s, d, bits):
    """[R12.10], [R12.17]"""
    blend, alpha, constant = state.blend, state.blend_alpha, state.blend_color
    if not blend.enable:
        return s
    result = joined_by(blend.src, blend.dst, state.blend_equation, s, d, constant, bits)
    if alpha.separate:
        own = joined_by(alpha.src, alpha.dst, alpha.equation, s, d, constant, bits)
        result[:, 3] = own[:, 3]
    return result


def logic_result(operation, s, d, bits):
    """[R12.15] The operation's number is its truth table."""
    parts = [s & d, s & ~d, ~s & d, ~s & ~d]
    result = np.zeros_like(s)
    for k, part in enumerate(parts):
        if operation >> k & 1:
            result |= part
    return result & one(bits)


class FragmentStage:
    """[R12.1] The steps, on a machine's planes, under one resolved state."""

    def __init__(self, machine, resolved):
        self.machine, self.state = machine, resolved
        self.bits = machine.profile.color_bits
        self.planes = machine.planes

    def run(self, x, y, colors, depths, front, masks=None):
        """x, y: pixels, each once. colors: rows of R, G, B, A. depths: one for all samples, or a
        list by sample. masks: by sample, the fragments that cover it; None: all do [R17.2]."""
        self.machine.counters["fragments"] += len(x)
        kept, colors = samples.kept(self.machine, colors)
        if masks is not None:
            kept &= masks
        for k, planes in enumerate(self.machine.surface.samples):
            of_sample = depths[k] if isinstance(depths, list) else depths
            here = kept[k]
            self.planes = planes
            self.run_sample(x[here], y[here], colors[here], of_sample[here], front)

    def run_sample(self, x, y, colors, depths, front):
        """[R17.5]"""
        state, planes, counters = self.state, self.planes, self.machine.counters
        alive = compare(state.alpha_func, colors[:, 3], np.full(len(x), state.alpha_ref))
        counters["alpha_killed"] += count(~alive)
        x, y, colors, depths = x[alive], y[alive], colors[alive], depths[alive]

        face = state.faces[0 if front else 1]
        reached_stencil = len(x)
        stored = planes.stencil[y, x]
        passed = compare(face.func, np.full(len(x), face.ref & face.mask), stored & face.mask)
        self.update_stencil(face, "fail", x[~passed], y[~passed])
        counters["stencil_killed"] += count(~passed)
        x, y, colors, depths = x[passed], y[passed], colors[passed], depths[passed]

        reached_depth = len(x)
        passed = compare(state.depth_func, depths, planes.depth[y, x])
        self.update_stencil(face, "zfail", x[~passed], y[~passed])
        counters["depth_killed"] += count(~passed)
        x, y, colors, depths = x[passed], y[passed], colors[passed], depths[passed]

        self.update_stencil(face, "zpass", x, y)
        if state.depth_mask:
            planes.depth[y, x] = depths
        self.write_colors(x, y, colors)
        counters["written"] += len(x)
        self.count_bytes(reached_stencil, reached_depth, len(x))

    def update_stencil(self, face, name, x, y):
        """[R12.7]"""
        plane, most = self.planes.stencil, one(self.machine.profile.stencil_bits)
        stored = plane[y, x]
        new = stencil_operation(face.operations[name], stored, face.ref, most)
        plane[y, x] = (stored & ~face.write_mask) | (new & face.write_mask)

    def write_colors(self, x, y, colors):
        """[R12.13], [R12.16], [R12.19]"""
        for plane in self.planes.drawn(self.state.draw_buffer):
            result = self.joined(colors, plane[y, x])
            for c, bits in enumerate(self.state.written_bits):
                plane[y, x, c] = with_written_bits(plane[y, x, c], result[:, c], bits)

    def joined(self, colors, stored):
        logic = self.state.logic_op
        if logic.enable:
            return logic_result(logic.op, colors, stored, self.bits)
        return blended(self.state, colors, stored, self.bits)

    def count_bytes(self, reached_stencil, reached_depth, written):
        """[R14.8]"""
        state, size = self.state, self.machine.bytes_of
        total = 0
        if state.stencil_test:
            changes = any(face.can_change() for face in state.faces)
            total += reached_stencil * size["Stencil"] * (2 if changes else 1)
        if state.depth_func != CompareFunc.Always:
            total += reached_depth * size["Depth"]
        if state.depth_mask:
            total += written * size["Depth"]
        if any(state.written_bits):
            logic = state.logic_op
            joins = logic.reads_stored() if logic.enable else state.blend.enable
            twice = joins or any(bits != one(self.bits) for bits in state.written_bits)
            total += (written * size["Color"] * (2 if twice else 1)
                      * colors_written(state.draw_buffer))
        self.machine.counters["bytes"] += total


def colors_written(draw_buffer):
    """[R14.8]"""
    return 2 if draw_buffer == DrawBuffer.FrontAndBack else 1


def count(mask):
    return int(np.count_nonzero(mask))
