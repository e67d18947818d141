#include "inspect/report/report_folder.h"

#include "gw/error.h"
#include "image/output/output_file.h"
#include "image/write.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace gw::report {

ReportFolder::ReportFolder(std::filesystem::path folder, std::uint64_t most_bytes)
    : folder_(std::move(folder)), most_bytes_(most_bytes) {}

void ReportFolder::make_folder(const std::string& name) {
    std::error_code error;
    if (!std::filesystem::create_directory(folder_ / name, error) && error)
        throw Error((folder_ / name).string(), 0, "cannot be made: " + error.message());
}

void ReportFolder::expect_space(std::uint64_t bytes) const {
    if (bytes > bytes_left())
        throw Error(fmt::format(
            "the report needs more than {} MB; expected fewer passes (--passes A-B), histories "
            "of fewer passes (--history A-B or none), or a larger --limit",
            most_bytes_ / 1'000'000));
}

void ReportFolder::write(const std::string& name, std::string_view text) {
    expect_space(text.size());
    image::write_file(folder_ / name, text);
    bytes_ += text.size();
}

// Not through a temporary file: the whole folder is one.
void ReportFolder::append(const std::string& name, std::string_view text) {
    expect_space(text.size());
    bytes_ += text.size();
    const int file =
        ::open((folder_ / name).c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    bool good = file >= 0;
    while (good && !text.empty()) {
        const ssize_t written = ::write(file, text.data(), text.size());
        good = written > 0 || (written < 0 && errno == EINTR);
        if (written > 0) text.remove_prefix(std::size_t(written));
    }
    const int error = errno;
    if (file >= 0) ::close(file);
    if (!good)
        throw Error((folder_ / name).string(), 0,
                    std::string("cannot be written: ") + std::strerror(error));
}

void ReportFolder::write(const std::string& name, const image::Picture& picture) {
    image::write_picture(folder_ / name, picture);
    const std::uint64_t size = std::filesystem::file_size(folder_ / name);
    expect_space(size);
    bytes_ += size;
}

}  // namespace gw::report
