// Which calls complete the primitives of a run from Begin to End. Knows no context.
#pragma once

#include "gl/assemble/assembly.h"
#include "gl/drawable/call_trace.h"

namespace gw::gl {

/// The calls of a run's vertices, while it is assembled.
class RunCalls {
public:
    /// After Assembly::begin.
    void begin(GLenum mode, const Assembly& mesh);
    /// After Assembly::add.
    void add(const CallPlace& vertex) { vertices_.push_back(vertex); }
    /// After Assembly::end: appends the calls of the run's primitives.
    void end(const Assembly& mesh, std::vector<CallRun>& runs);

private:
    GLenum mode_ = GL_POINTS;
    std::size_t first_ = 0;  ///< primitive of the run
    std::vector<CallPlace> vertices_;
};

}  // namespace gw::gl
