// The stencil operations by plain arithmetic, and a row of pixels with every stencil value.
#pragma once

#include "tests/gw/workbench.h"

#include <algorithm>

namespace gw::test {

inline constexpr StencilOp ops[] = {StencilOp::Keep,     StencilOp::Zero,    StencilOp::Replace,
                                    StencilOp::Incr,     StencilOp::Decr,    StencilOp::Invert,
                                    StencilOp::IncrWrap, StencilOp::DecrWrap};

/// By modulo arithmetic and limits.
inline int operated(StencilOp op, int stored, int ref, int count) {
    const int top = count - 1;
    switch (op) {
        case StencilOp::Keep: return stored;
        case StencilOp::Zero: return 0;
        case StencilOp::Replace: return ref % count;
        case StencilOp::Incr: return std::min(stored + 1, top);
        case StencilOp::Decr: return std::max(stored - 1, 0);
        case StencilOp::Invert: return top - stored;
        case StencilOp::IncrWrap: return (stored + 1) % count;
        case StencilOp::DecrWrap: return (stored + top) % count;
    }
    return -1;
}

/// Bit by bit: the new value's bit if the mask's is one, else the stored value's.
inline int masked(int stored, int result, int mask) {
    int out = 0;
    for (int bit = 1; bit < 256; bit *= 2)
        out += ((mask / bit) % 2 == 1 ? result / bit : stored / bit) % 2 * bit;
    return out;
}

/// 256 pixels of a row have every stored value.
struct Row {
    Workbench bench{ideal(), 256, 1};
    const Rect rect{0, 0, 256, 1};
    std::vector<std::uint32_t> values;

    Row() {
        for (std::uint32_t v = 0; v < 256; ++v) values.push_back(v);
        bench.state.color_mask = {false, false, false, false};
    }
    void fill() {
        const StencilState keep = bench.state.stencil;
        bench.state.stencil = {};
        bench.run(WritePixels{rect, Plane::Stencil, {}, values, 0});
        bench.state.stencil = keep;
    }
    int at(int x) { return bench.stencil(x, 0); }
};

}  // namespace gw::test
