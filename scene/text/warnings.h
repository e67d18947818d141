// Warnings about statements that a scene's readers understand but do not honour, and the names of
// the files they read. A warning is never an error, and never silent.
#pragma once

#include "gw/error.h"

#include <filesystem>
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

    /// Notes a file that was read.
    void add_file(std::filesystem::path file) { files_.push_back(std::move(file)); }
    const std::vector<std::filesystem::path>& files() const { return files_; }

private:
    std::vector<std::string> lines_;
    std::set<std::string> said_;
    std::vector<std::filesystem::path> files_;
};

}  // namespace gw::scene
