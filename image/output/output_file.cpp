#include "image/output/output_file.h"

#include "gw/error.h"
#include "image/output/origin.h"
#include "image/output/temporaries.h"

#include <fcntl.h>
#include <unistd.h>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

namespace gw::image {

namespace fs = std::filesystem;

namespace {

fs::path folder_of(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

[[noreturn]] void refuse(const fs::path& target, std::string_view why) {
    throw Error(target.string(), 0, "cannot be written: " + std::string(why));
}

fs::path follow_links(const fs::path& target) {
    std::error_code error;
    const fs::path real = fs::canonical(target, error);
    return error ? target : real;
}

bool is_device(const fs::path& target) {
    std::error_code error;
    const fs::file_status status = fs::status(target, error);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

// Short, because the target's own name may be as long as a name can be.
fs::path temporary_name(const fs::path& folder) {
    static std::atomic<unsigned> count = 0;
    return folder / (".gw-" + std::to_string(::getpid()) + "-" + std::to_string(count++) + ".tmp");
}

}  // namespace

void check_target(const fs::path& target) {
    std::error_code error;
    const fs::path folder = folder_of(target);
    if (!target.has_filename()) refuse(target, "it names a folder; expected the name of a file");
    if (fs::is_directory(target, error))
        refuse(target, "it is a folder; expected the name of a file");
    if (!fs::exists(folder, error)) {
        refuse(target, "folder " + folder.string() + " does not exist; expected one to write into");
    }
    if (!fs::is_directory(folder, error)) {
        refuse(target, folder.string() + " is not a folder; expected one to write into");
    }
    if (::access(fs::exists(target, error) ? target.c_str() : folder.c_str(), W_OK) != 0) {
        refuse(target, std::strerror(errno));
    }
}

OutputFile::OutputFile(const fs::path& target) : asked_(target) {
    check_target(target);
    target_ = follow_links(target);
    if (is_device(target_)) {
        descriptor_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
        if (descriptor_ < 0) fail(errno);
    } else {
        open_temporary();
    }
}

void OutputFile::open_temporary() {
    do {
        const fs::path name = temporary_name(folder_of(target_));
        register_temporary(name);
        descriptor_ = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        const int error = errno;
        if (descriptor_ >= 0) {
            temporary_ = name;
        } else {
            forget_temporary(name);
            if (error != EEXIST) fail(error);
        }
    } while (descriptor_ < 0);
}

OutputFile::~OutputFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (temporary_.empty()) return;
    ::unlink(temporary_.c_str());
    forget_temporary(temporary_);
}

void OutputFile::fail(int error) const { refuse(asked_, std::strerror(error)); }

void OutputFile::write(std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) fail(written < 0 ? errno : ENOSPC);
        bytes = bytes.subspan(std::size_t(written));
    }
}

void OutputFile::write_text(std::string_view text) {
    write({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

// Some file systems report a full disk only here.
void OutputFile::close() {
    const int descriptor = std::exchange(descriptor_, -1);
    if (descriptor >= 0 && ::close(descriptor) != 0) fail(errno);
}

void OutputFile::commit() {
    close();
    if (temporary_.empty()) return;
    note_origin(temporary_);
    if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
    forget_temporary(temporary_);
    temporary_.clear();
}

void write_file(const fs::path& target, std::string_view bytes) {
    OutputFile file(target);
    file.write_text(bytes);
    file.commit();
}

}  // namespace gw::image
