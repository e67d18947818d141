#include "image/output/output_file.h"

#include "gw/error.h"
#include "image/output/temporaries.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
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

/// The absolute name with links followed, even one to a target that does not exist.
fs::path follow_links(const fs::path& target) {
    constexpr int most_links = 40;
    fs::path at = target;
    std::error_code error;
    for (int links = 0; fs::is_symlink(fs::symlink_status(at, error)); ++links) {
        if (const fs::path real = fs::canonical(at, error); !error) return real;
        if (links == most_links) refuse(target, "too many links");
        const fs::path to = fs::read_symlink(at, error);
        if (error) refuse(target, error.message());
        at = folder_of(at) / to;
    }
    const fs::path folder = fs::canonical(folder_of(at), error);
    return error ? at : folder / at.filename();
}

bool is_device(const fs::path& target) {
    std::error_code error;
    const fs::file_status status = fs::status(target, error);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

// Short, because the target's own name may be as long as a name can be. remove_stale_temporaries
// knows its form.
fs::path temporary_name(const fs::path& folder) {
    static std::atomic<unsigned> count = 0;
    return folder / (".gw-" + std::to_string(::getpid()) + "-" + std::to_string(count++) + ".tmp");
}

}  // namespace

void check_target(const fs::path& target) {
    std::error_code error;
    if (!target.has_filename()) refuse(target, "it names a folder; expected the name of a file");
    if (fs::is_directory(target, error))
        refuse(target, "it is a folder; expected the name of a file");
    const fs::path real = is_device(target) ? target : follow_links(target);
    const fs::path folder = folder_of(real);
    if (!fs::exists(folder, error)) {
        const fs::path named = real == target ? folder : folder_of(target);
        refuse(target, "folder " + (fs::exists(named, error) ? folder : named).string() +
                           " does not exist; expected one to write into");
    }
    if (!fs::is_directory(folder, error))
        refuse(target, folder_of(target).string() + " is not a folder; expected one to write into");
    if (fs::exists(real, error) && ::access(real.c_str(), W_OK) != 0)
        refuse(target, std::strerror(errno));
    if (!is_device(target) && ::access(folder.c_str(), W_OK) != 0)
        refuse(target, std::strerror(errno));
}

OutputFile::OutputFile(const fs::path& target) : asked_(target) {
    check_target(target);
    if (is_device(target)) {
        target_ = target;
        descriptor_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
        if (descriptor_ < 0) fail(errno);
    } else {
        target_ = follow_links(target);
        open_temporary();
    }
}

/// If it replaces a file, whose mode may be strict, nobody else can read it until commit.
void OutputFile::open_temporary() {
    const fs::path folder = folder_of(target_);
    remove_stale_temporaries(folder);
    struct stat old {};
    const mode_t mode = ::stat(target_.c_str(), &old) == 0 ? 0600 : 0666;
    do {
        temporary_ = temporary_name(folder);  // after open, nothing may need memory
        register_temporary(temporary_);
        descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
        const int error = errno;
        if (descriptor_ < 0) {
            forget_temporary(temporary_);
            if (error != EEXIST) fail(error);
        }
    } while (descriptor_ < 0);
    ::flock(descriptor_, LOCK_EX | LOCK_NB);  // for remove_stale_temporaries elsewhere
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

void OutputFile::keep_owner_and_mode() const {
    struct stat old {
    }, now{};
    if (::stat(target_.c_str(), &old) != 0 || ::stat(temporary_.c_str(), &now) != 0) return;
    const bool same_owner = old.st_uid == now.st_uid && old.st_gid == now.st_gid;
    const bool taken = same_owner || ::chown(temporary_.c_str(), old.st_uid, old.st_gid) == 0;
    // Another owner's bits are not ours to give away.
    const mode_t mode = taken ? old.st_mode & 07777 : old.st_mode & 0777 & now.st_mode;
    if (::chmod(temporary_.c_str(), mode) != 0) fail(errno);
}

void OutputFile::commit() {
    close();
    if (temporary_.empty()) return;
    keep_owner_and_mode();
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
