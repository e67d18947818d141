#include "image/memory_file.h"

#include "gw/error.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

namespace gw::image {

MemoryFile::MemoryFile(std::string_view bytes) : file_(::memfd_create("picture", MFD_CLOEXEC)) {
    while (file_ >= 0 && !bytes.empty()) {
        const ssize_t written = ::write(file_, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) break;
        bytes.remove_prefix(std::size_t(written));
    }
    if (file_ >= 0 && bytes.empty()) return;
    const std::string why = std::strerror(errno);
    if (file_ >= 0) ::close(file_);
    throw Error("it cannot be held in memory: " + why + "; expected a smaller picture");
}

MemoryFile::~MemoryFile() { ::close(file_); }

std::filesystem::path MemoryFile::path() const {
    return "/proc/" + std::to_string(::getpid()) + "/fd/" + std::to_string(file_);
}

}  // namespace gw::image
