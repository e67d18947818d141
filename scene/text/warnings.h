// Warnings about statements that a reader understands but does not honour. Not errors, and never
// silent.
#pragma once

#include "gw/error.h"

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace gw::scene {

class Warnings {
public:
    /// Adds "file:line: text" unless `kind` was warned about in this file before.
    void add(const std::string& file, int line, const std::string& kind, std::string_view text) {
        if (said_.insert(file + '\n' + kind).second) lines_.push_back(at_line(file, line, text));
    }
    const std::vector<std::string>& lines() const { return lines_; }

private:
    std::vector<std::string> lines_;
    std::set<std::string> said_;
};

}  // namespace gw::scene
