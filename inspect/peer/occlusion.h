// Queries of the fragments that pass all tests.
#pragma once

#include "gw/command_list.h"
#include "gw/counters.h"

#include <GL/gl.h>

#include <vector>

namespace gw::peer {

class Occlusion {
public:
    void run(const Query& command);
    bool is_active() const { return active_; }
    const std::vector<QueryResult>& results() const { return results_; }

private:
    bool active_ = false;
    GLuint name_ = 0;  ///< one object for all queries; 0: not made yet
    std::vector<QueryResult> results_;
};

}  // namespace gw::peer
