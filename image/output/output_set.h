// The files of a run. Outputs that belong together all appear at commit, none before; none replaces
// an input. Does not write bytes: OutputFile does.
#pragma once

#include "image/output/output_file.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace gw::image {

/// The files that a run reads: no output may replace one.
class InputFiles {
public:
    /// Remembers the file behind this name, if it exists.
    void add(const std::filesystem::path& file);

    /// Throws Error "scene.toml: cannot be written: this command reads it; ..." if `target` is one
    /// of the files, by any name or link.
    void check(const std::filesystem::path& target) const;

    /// The names that were added, in their order.
    const std::vector<std::filesystem::path>& names() const { return names_; }

private:
    std::vector<std::filesystem::path> names_;
    std::set<std::pair<std::uint64_t, std::uint64_t>> files_;  ///< device, number
};

class OutputSet {
public:
    /// For a run that reads no files.
    OutputSet() = default;
    /// No file that is added may be one of `inputs`.
    explicit OutputSet(InputFiles inputs) : inputs_(std::move(inputs)) {}
    ~OutputSet();
    OutputSet(const OutputSet&) = delete;
    OutputSet& operator=(const OutputSet&) = delete;

    /// Creates a folder unless it exists; its parent must exist. Without a commit it is removed again.
    void make_folder(const std::filesystem::path& folder);
    /// Adds a file, which the caller writes before commit. Throws Error for an input, and for a file
    /// that was added before.
    OutputFile& add(const std::filesystem::path& target);
    /// The names of the files added since the last commit, in their order.
    std::vector<std::filesystem::path> targets() const;
    void commit();

private:
    InputFiles inputs_;
    std::vector<std::filesystem::path> made_;
    std::vector<std::unique_ptr<OutputFile>> files_;
};

}  // namespace gw::image
