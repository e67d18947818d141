#include "image/output/input_files.h"

#include "gw/error.h"

#include <sys/stat.h>

#include <optional>

namespace gw::image {
namespace {

std::optional<std::pair<std::uint64_t, std::uint64_t>> identity(const std::filesystem::path& file) {
    struct stat status {};
    if (::stat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return {};
    return std::pair(std::uint64_t(status.st_dev), std::uint64_t(status.st_ino));
}

}  // namespace

void InputFiles::add(const std::filesystem::path& file) {
    if (const auto known = identity(file)) files_.insert(*known);
}

void InputFiles::check(const std::filesystem::path& target) const {
    const auto known = identity(target);
    if (known && files_.contains(*known))
        throw Error(target.string(), 0,
                    "cannot be written: this command reads it; expected another name");
}

}  // namespace gw::image
