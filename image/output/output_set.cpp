#include "image/output/output_set.h"

#include "gw/error.h"
#include "image/output/temporaries.h"

#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#include <cstring>
#include <optional>

namespace gw::image {

namespace fs = std::filesystem;

namespace {

std::optional<std::pair<std::uint64_t, std::uint64_t>> identity(const std::filesystem::path& file) {
    struct stat status {};
    if (::stat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return {};
    return std::pair(std::uint64_t(status.st_dev), std::uint64_t(status.st_ino));
}

}  // namespace

OutputSet::~OutputSet() {
    files_.clear();
    std::error_code ignored;
    for (const fs::path& folder : made_) {
        fs::remove(folder, ignored);
        forget_temporary(folder);
    }
}

void OutputSet::make_folder(const fs::path& folder) {
    std::error_code error;
    if (fs::is_directory(folder, error)) {
        if (::access(folder.c_str(), W_OK) != 0)
            throw Error(folder.string(), 0,
                        std::string("folder cannot be written into: ") + std::strerror(errno) +
                            "; expected one that can");
        return;
    }
    if (fs::exists(folder, error) && !fs::is_directory(folder, error)) {
        throw Error(folder.string(), 0, "is not a folder; expected one, or a name for a new one");
    }
    register_temporary(folder);
    if (!fs::create_directory(folder, error)) {
        forget_temporary(folder);
        if (!error) return;  // another process made it meanwhile
        throw Error(folder.string(), 0,
                    "folder cannot be made: " + error.message() +
                        "; expected a name in a folder that can be written into");
    }
    made_.push_back(folder);
}

OutputFile& OutputSet::add(const fs::path& target) {
    inputs_.check(target);
    auto file = std::make_unique<OutputFile>(target);
    for (const auto& other : files_)
        if (!file->temporary().empty() && file->real_target() == other->real_target())
            throw Error(target.string(), 0,
                        "cannot be written: it is also " + other->target().string() +
                            ", another output; expected two names");
    files_.push_back(std::move(file));
    return *files_.back();
}

std::vector<fs::path> OutputSet::targets() const {
    std::vector<fs::path> names;
    for (const auto& file : files_) names.push_back(file->target());
    return names;
}

void OutputSet::commit() {
    for (const auto& file : files_) file->commit();
    for (const fs::path& folder : made_) forget_temporary(folder);
    files_.clear();
    made_.clear();
}

void InputFiles::add(const std::filesystem::path& file) {
    const auto known = identity(file);
    if (!known) return;
    files_.insert(*known);
    names_.push_back(file);
}

void InputFiles::check(const std::filesystem::path& target) const {
    const auto known = identity(target);
    if (known && files_.contains(*known))
        throw Error(target.string(), 0,
                    "cannot be written: this command reads it; expected another name");
}

}  // namespace gw::image
