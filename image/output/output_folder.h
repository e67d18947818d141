// A folder that appears whole or not at all: filled under a temporary name beside its target, then
// renamed.
// For more files than an OutputSet holds at a time. Does not know what is in it.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace gw::image {

/// Without a commit, on an exception and on a signal, the temporary folder goes away with all that
/// is in it.
class OutputFolder {
public:
    /// To be asked before long work. Throws Error where `target` cannot be made: its parent is
    /// missing or cannot be written into, a file has that name, or a folder that is not empty and
    /// holds anything but `known` names or not the first of them: an earlier folder of the same
    /// kind is replaced at commit, others are left alone.
    OutputFolder(const std::filesystem::path& target, std::vector<std::string> known);
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

    /// Where to write until commit.
    const std::filesystem::path& temporary() const { return temporary_; }
    void commit();

private:
    void check_replaceable() const;
    std::error_code put_in_place() const;

    std::filesystem::path asked_, target_, temporary_;
    std::vector<std::string> known_;
    int lock_ = -1;  ///< on the temporary folder: its process lives
};

}  // namespace gw::image
