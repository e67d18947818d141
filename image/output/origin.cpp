#include "image/output/origin.h"

#ifdef __linux__
#include <sys/xattr.h>
#endif

namespace gw::image {
namespace {

std::string origin;

[[maybe_unused]] constexpr const char* attribute = "user.gw.command";

}  // namespace

void set_origin(std::string command) { origin = std::move(command); }

#ifdef __linux__

void note_origin(const std::filesystem::path& file) {
    // Too long, or no such attributes here: a file without its note is as good.
    if (!origin.empty()) ::setxattr(file.c_str(), attribute, origin.data(), origin.size(), 0);
}

std::string origin_of(const std::filesystem::path& file) {
    const ssize_t size = ::getxattr(file.c_str(), attribute, nullptr, 0);
    if (size <= 0) return "";
    std::string text(std::size_t(size), '\0');
    return ::getxattr(file.c_str(), attribute, text.data(), text.size()) == size ? text : "";
}

#else

void note_origin(const std::filesystem::path&) {}
std::string origin_of(const std::filesystem::path&) { return ""; }

#endif

}  // namespace gw::image
