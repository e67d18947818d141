"""Chapter 4: the state that fragments meet."""
from dataclasses import dataclass

import numpy as np

from .numbers import one, quantize
from .state import NO_DRAW_BUFFER, CompareFunc, StencilOp


@dataclass
class ResolvedFace:
    func: int
    ref: int
    mask: int
    operations: dict
    write_mask: int

    def can_change(self):
        """[R14.8]"""
        return self.write_mask != 0 and any(op != StencilOp.Keep for op in self.operations.values())


def resolved_face(face, test, bits):
    if not test:
        keep = dict.fromkeys(("fail", "zfail", "zpass"), StencilOp.Keep)
        return ResolvedFace(CompareFunc.Always, 0, 0, keep, 0)
    operations = {"fail": face.fail, "zfail": face.zfail, "zpass": face.zpass}
    return ResolvedFace(face.func, face.ref % 2**32, face.mask & one(bits), operations,
                        face.write_mask & one(bits))


class Resolved:
    """[R4.5] The state that fragments meet."""

    def __init__(self, state, profile):
        self.depth_func = state.depth.func if state.depth.test else CompareFunc.Always
        self.depth_mask = state.depth.mask and state.depth.test
        self.alpha_func = state.alpha.func if state.alpha.test else CompareFunc.Always
        self.alpha_ref = quantize(state.alpha.ref, profile.color_bits)
        self.stencil_test = state.stencil.test
        front = resolved_face(state.stencil.front, state.stencil.test, profile.stencil_bits)
        back = resolved_face(state.stencil.back, state.stencil.test, profile.stencil_bits)
        self.faces = (front, back if state.stencil.two_side else front)
        self.blend = state.blend
        self.blend_equation = state.blend_equation
        self.blend_alpha = state.blend_alpha
        self.blend_color = np.array([quantize(v, profile.color_bits) for v in state.blend_color],
                                    np.int64)
        self.logic_op = state.logic_op
        self.draw_buffer = state.draw_buffer
        self.written_bits = written_bits(state, profile)
        if state.draw_buffer == NO_DRAW_BUFFER:
            self.written_bits = (0,) * 4


def written_bits(state, profile):
    """[R12.13], [R12.19] Of the channels R, G, B, A."""
    mask, bits, every = state.color_mask, state.color_mask_bits, one(profile.color_bits)
    return tuple(getattr(bits, c) & every if getattr(mask, c) else 0 for c in "rgba")


def with_written_bits(stored, values, bits):
    """[R12.19] Of one channel."""
    return (stored & ~bits) | (values & bits)


def stencil_write_mask(state, profile):
    """[R4.6] Of clears, copies and rectangles."""
    return state.stencil.front.write_mask & one(profile.stencil_bits)
