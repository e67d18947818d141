#include "gl/assemble/run_calls.h"

#include <algorithm>

namespace gw::gl {

namespace {

/// The vertex that completes primitive i of a run of n vertices. [GL11] 2.6.1
std::size_t completing_vertex(GLenum mode, std::size_t i, std::size_t n) {
    switch (mode) {
        case GL_POINTS: return i;
        case GL_LINES: return 2 * i + 1;
        case GL_LINE_STRIP:
        case GL_LINE_LOOP: return std::min(i + 1, n - 1);  // a loop's last line ends at its first
        case GL_TRIANGLES: return 3 * i + 2;
        case GL_TRIANGLE_STRIP:
        case GL_TRIANGLE_FAN: return i + 2;
        case GL_QUADS: return 4 * i + 3;
        case GL_QUAD_STRIP: return 2 * i + 3;
    }
    return n - 1;
}

/// Whether the run goes on with this call.
bool goes_on(CallRun& run, const CallPlace& call, std::uint32_t primitive) {
    if (run.call.function != call.function || run.call.source != call.source ||
        run.call.list != call.list)
        return false;
    const std::uint32_t further = primitive - run.first;
    if (further == 1) run.step = call.number - run.call.number;
    return call.number == run.call.number + run.step * further;
}

}  // namespace

void RunCalls::begin(GLenum mode, const Assembly& mesh) {
    mode_ = mode;
    first_ = mesh.primitive_count();
    vertices_.clear();
}

void RunCalls::end(const Assembly& mesh, std::vector<CallRun>& runs) {
    const std::size_t before = runs.size(), n = vertices_.size();
    for (std::size_t i = 0; first_ + i < mesh.primitive_count(); ++i) {
        const CallPlace& call = vertices_[completing_vertex(mode_, i, n)];
        const auto primitive = static_cast<std::uint32_t>(first_ + i);
        if (runs.size() > before && goes_on(runs.back(), call, primitive)) continue;
        runs.push_back(
            {.first = primitive, .call = call, .ordinal = static_cast<std::uint32_t>(i)});
    }
    vertices_.clear();
}

}  // namespace gw::gl
