// A folder that appears complete or not at all: it is filled under a temporary name beside its
// target, then renamed. For more files than an OutputSet can have open. Does not write files.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace gw::image {

/// Without a commit, on an exception and on a signal, the temporary folder is removed with all its
/// files.
class OutputFolder {
public:
    /// Construct it before long work. Throws Error if `target` cannot be created: its parent is
    /// missing or cannot be written into, a file has that name, or a folder of another kind has it.
    /// An earlier folder of the same kind is replaced at commit: it is empty, or has only `known`
    /// names and the first of them.
    OutputFolder(const std::filesystem::path& target, std::vector<std::string> known);
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

    /// The folder to write into until commit.
    const std::filesystem::path& temporary() const { return temporary_; }
    void commit();

private:
    void check_replaceable() const;
    std::error_code put_in_place() const;

    std::filesystem::path asked_, target_, temporary_;
    std::vector<std::string> known_;
    int lock_ = -1;  ///< on the temporary folder; shows that its process lives
};

}  // namespace gw::image
