// Random calls, right and wrong, for GL and for the model of its state.
#pragma once

#include "tests/gl/unit/support/model.h"

#include <functional>
#include <initializer_list>
#include <random>
#include <span>

namespace gw::gl::model {

class Dice {
public:
    explicit Dice(unsigned seed) : engine_(seed) {}
    int below(int n) { return int(engine_() % unsigned(n)); }
    bool chance(int percent) { return below(100) < percent; }
    /// Exact in float, also out of most ranges.
    double real() { return double(below(25) - 8) / 8; }
    GLenum among(std::initializer_list<GLenum> names) {
        return chance(12) ? GLenum(0x1234) : names.begin()[below(int(names.size()))];
    }
    unsigned bits() { return unsigned(engine_()); }

private:
    std::mt19937 engine_;
};

/// A call for both sides.
struct Pair {
    Call call;
    std::function<void()> gl;
};
using Maker = Pair (*)(Dice&);

/// Calls of chapters 2 and 4: values of vertices, sizes, tests, clears.
std::span<const Maker> drawing_calls();
/// Pixels, arrays, matrices, stacks, textures, Begin and End.
std::span<const Maker> other_calls();

}  // namespace gw::gl::model
