// The matrix stacks. [GL11] 2.10.2; each texture unit has one. The elements are floats, in double for the arithmetic.
#pragma once

#include "gl/state/state.h"

#include <array>
#include <cmath>
#include <vector>

namespace gw::gl {

/// The inverse; all 0 if there is none.
dmat4 inverted(const dmat4& m);

inline bool is_finite(const dmat4& m) {
    for (int i = 0; i < 16; ++i)
        if (!std::isfinite(m[i / 4][i % 4])) return false;
    return true;
}

struct MatrixStack {
    explicit MatrixStack(std::size_t largest) : depth(largest) {}

    std::size_t depth;                     ///< at most so many
    std::vector<dmat4> entries{dmat4(1)};  ///< the last is the top
    dmat4& top() { return entries.back(); }
    const dmat4& top() const { return entries.back(); }
};

struct Matrices {
    MatrixStack modelview{modelview_stack_depth}, projection{projection_stack_depth};
    std::array<MatrixStack, texture_unit_count> texture{
        MatrixStack(texture_stack_depth), MatrixStack(texture_stack_depth),
        MatrixStack(texture_stack_depth), MatrixStack(texture_stack_depth)};
    /// The stack that MatrixMode chose.
    MatrixStack& current(const State& s) {
        const GLenum mode = s.transform.matrix_mode;
        return mode == GL_PROJECTION ? projection
               : mode == GL_TEXTURE  ? texture[s.texture.active]
                                     : modelview;
    }
};

}  // namespace gw::gl
