// A file that appears complete or not at all: it is written under a temporary name beside its
// target, then renamed. Does not interpret its bytes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

namespace gw::image {

/// Throws Error if a file of this name cannot be written: no such folder, a folder of that name, no
/// permission. Call it before long work.
void check_target(const std::filesystem::path& target);

/// Between construction and commit the bytes are in `temporary()`, in the target's folder. Without a
/// commit, on an exception and on a signal (image/output/temporaries.h), that file is removed and the
/// target stays as it was. A link is followed, even to a file that does not exist yet. A replaced
/// file keeps its owner and mode. A target that is no regular file (a device, a pipe) is written to
/// directly. Temporary files of killed processes in the folder are removed. Throws Error "out.png:
/// cannot be written: No space left on device".
class OutputFile {
public:
    explicit OutputFile(const std::filesystem::path& target);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// The name that the user gave.
    const std::filesystem::path& target() const { return asked_; }
    /// Empty if the target is written to directly.
    const std::filesystem::path& temporary() const { return temporary_; }
    /// Absolute, links followed.
    const std::filesystem::path& real_target() const { return target_; }
    void write(std::span<const std::uint8_t> bytes);
    void write_text(std::string_view text);
    void commit();

private:
    [[noreturn]] void fail(int error) const;
    void open_temporary();
    void keep_owner_and_mode() const;
    void close();

    std::filesystem::path asked_;
    std::filesystem::path target_;
    std::filesystem::path temporary_;
    int descriptor_ = -1;
};

/// Writes a whole file at once.
void write_file(const std::filesystem::path& target, std::string_view bytes);

}  // namespace gw::image
