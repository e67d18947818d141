#include "gl/record/whole_file.h"

#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace gw::gl {

namespace fs = std::filesystem;

std::string write_whole_file(const std::string& file, std::string_view bytes) {
    std::error_code ignored;
    fs::path target = file;  // a link may lead to a file that does not exist yet
    for (int links = 0; links < 40 && fs::is_symlink(target, ignored); ++links)
        target = target.parent_path() / fs::read_symlink(target, ignored);
    const fs::file_status status = fs::status(target, ignored);
    const bool replaces = fs::is_regular_file(status), direct = fs::exists(status) && !replaces;
    const fs::path part =
        direct ? target : fs::path(target.string() + "." + std::to_string(::getpid()) + ".part");
    errno = 0;
    std::ofstream out(part, std::ios::binary);
    out.write(bytes.data(), std::streamsize(bytes.size()));
    out.close();
    if (out && replaces) fs::permissions(part, status.permissions(), ignored);
    std::error_code failure(errno, std::generic_category());
    if (out && !direct) fs::rename(part, target, failure);
    if (out && (direct || !failure)) return {};
    if (!direct) fs::remove(part, ignored);
    return failure.message();
}

}  // namespace gw::gl
