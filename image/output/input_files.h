// The files that a run reads: no output may replace one. Does not read them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <utility>

namespace gw::image {

class InputFiles {
public:
    /// Remembers the file behind this name; nothing where there is none.
    void add(const std::filesystem::path& file);

    /// Throws Error "scene.toml: cannot be written: this command reads it; ..." where `target` is
    /// one of the files, by whatever name or link.
    void check(const std::filesystem::path& target) const;

private:
    std::set<std::pair<std::uint64_t, std::uint64_t>> files_;  ///< device, number
};

}  // namespace gw::image
