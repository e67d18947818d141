#include "image/output/output_folder.h"

#include "gw/error.h"
#include "image/output/temporaries.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>

namespace gw::image {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse_folder(const fs::path& target, const std::string& why) {
    throw Error(target.string(), 0, why);
}

/// Links followed, without a slash at its end.
fs::path real_target(const fs::path& target) {
    std::error_code error;
    if (const fs::path real = fs::canonical(target, error); !error) return real;
    const fs::path whole = fs::absolute(target).lexically_normal();
    return whole.has_filename() ? whole : whole.parent_path();
}

fs::path unused_name(const fs::path& folder) {
    static std::atomic<unsigned> count = 0;
    return folder /
           (".gw-" + std::to_string(::getpid()) + "-folder-" + std::to_string(count++) + ".tmp");
}

}  // namespace

OutputFolder::OutputFolder(const fs::path& target, std::vector<std::string> known)
    : asked_(target), target_(real_target(target)), known_(std::move(known)) {
    const fs::path parent = target_.parent_path();
    std::error_code error;
    if (!fs::is_directory(parent, error))
        refuse_folder(
            asked_, "cannot be made: folder " + parent.string() + " does not exist; expected one");
    if (::access(parent.c_str(), W_OK) != 0)
        refuse_folder(asked_, std::string("cannot be made: ") + std::strerror(errno) +
                                  "; expected a name in a folder that can be written into");
    check_replaceable();
    remove_stale_temporaries(parent);
    temporary_ = unused_name(parent);
    register_temporary_tree(temporary_);
    if (!fs::create_directory(temporary_, error)) {
        forget_temporary(temporary_);
        refuse_folder(asked_, "cannot be made: " +
                                  (error ? error.message() : temporary_.string() + " is there"));
    }
    lock_ = ::open(temporary_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (lock_ >= 0) ::flock(lock_, LOCK_EX | LOCK_NB);  // for remove_stale_temporaries elsewhere
}

OutputFolder::~OutputFolder() {
    if (lock_ >= 0) ::close(lock_);
    if (temporary_.empty()) return;
    std::error_code ignored;
    fs::remove_all(temporary_, ignored);
    forget_temporary(temporary_);
}

void OutputFolder::check_replaceable() const {
    std::error_code error;
    if (!fs::exists(target_, error)) return;
    if (!fs::is_directory(target_, error))
        refuse_folder(asked_, "is not a folder; expected a name for a new one");
    std::string stranger;
    bool empty = true, marked = false;
    for (const auto& entry : fs::directory_iterator(target_, error)) {
        const std::string name = entry.path().filename().string();
        empty = false;
        marked = marked || name == known_.front();
        if (std::ranges::find(known_, name) == known_.end()) stranger = name;
    }
    if (!empty && (!marked || !stranger.empty()))
        refuse_folder(asked_,
                      (stranger.empty() ? "has no " + known_.front() + " of this command"
                                        : "holds " + stranger + ", which is not of this command") +
                          "; expected a new name, an empty folder or an earlier output to replace");
    if (error) refuse_folder(asked_, "cannot be read: " + error.message());
}

/// One try; another process may make or take the target in between.
std::error_code OutputFolder::put_in_place() const {
    std::error_code error;
    if (!fs::exists(target_, error)) {
        fs::rename(temporary_, target_, error);
        return error;
    }
    check_replaceable();
#ifdef RENAME_EXCHANGE
    if (::renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, target_.c_str(), RENAME_EXCHANGE) == 0)
        return {};  // one of the two exists at any time
    if (errno == ENOENT) return std::make_error_code(std::errc::no_such_file_or_directory);
#endif
    const fs::path old = unused_name(target_.parent_path());
    fs::rename(target_, old, error);
    if (error) return error;
    fs::rename(temporary_, target_, error);
    std::error_code ignored;
    if (error) fs::rename(old, target_, ignored);
    fs::remove_all(old, ignored);
    return error;
}

void OutputFolder::commit() {
    constexpr int most_tries = 100;
    std::error_code error = put_in_place();
    const auto another_process_was_faster = [&] {
        return error == std::errc::directory_not_empty || error == std::errc::file_exists ||
               error == std::errc::no_such_file_or_directory;
    };
    for (int tries = 1; another_process_was_faster() && tries < most_tries; ++tries)
        error = put_in_place();
    if (error) refuse_folder(asked_, "cannot be made: " + error.message());
    std::error_code ignored;
    fs::remove_all(temporary_, ignored);  // the earlier folder, if there was one
    forget_temporary(temporary_);
    temporary_.clear();
}

}  // namespace gw::image
