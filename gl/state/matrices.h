// The three matrix stacks. [GL11] 2.10.2. The elements are floats, in double for the arithmetic.
#pragma once

#include "gl/state/state.h"

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
    MatrixStack texture{texture_stack_depth};
    /// The stack that MatrixMode chose.
    MatrixStack& current(GLenum mode) {
        return mode == GL_PROJECTION ? projection : mode == GL_TEXTURE ? texture : modelview;
    }
};

}  // namespace gw::gl
