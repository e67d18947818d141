// Files that belong together: all appear at commit, none before.
// Does not write bytes: OutputFile does.
#pragma once

#include "image/output/input_files.h"
#include "image/output/output_file.h"

#include <memory>
#include <vector>

namespace gw::image {

class OutputSet {
public:
    /// For a run that reads no files.
    OutputSet() = default;
    /// No file that is added may be one of `inputs`.
    explicit OutputSet(InputFiles inputs) : inputs_(std::move(inputs)) {}
    ~OutputSet();
    OutputSet(const OutputSet&) = delete;
    OutputSet& operator=(const OutputSet&) = delete;

    /// Makes a folder unless it is there; its parent must be. Without a commit it goes away again.
    void make_folder(const std::filesystem::path& folder);
    /// To be written to before commit. Throws Error for an input and for a file that was added
    /// before.
    OutputFile& add(const std::filesystem::path& target);
    /// Of the files added since the last commit, in their order.
    std::vector<std::filesystem::path> targets() const;
    void commit();

private:
    InputFiles inputs_;
    std::vector<std::filesystem::path> made_;
    std::vector<std::unique_ptr<OutputFile>> files_;
};

}  // namespace gw::image
