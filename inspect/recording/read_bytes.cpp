#include "inspect/recording/read_bytes.h"

#include "gw/error.h"

#include <algorithm>
#include <fstream>

namespace gw::inspect {
namespace {

constexpr std::uintmax_t largest = std::uintmax_t{1} << 31;
constexpr std::size_t beginning_size = 4096;

std::ifstream opened(const std::filesystem::path& file) {
    using enum std::filesystem::file_type;
    std::error_code code;
    const auto kind = std::filesystem::status(file, code).type();
    if (kind == directory) throw Error(file.string(), 0, "is a folder; expected a file");
    if (kind == fifo || kind == socket) throw Error(file.string(), 0, "is a pipe; expected a file");
    if (kind == character || kind == block)
        throw Error(file.string(), 0, "is a device; expected a file");
    std::ifstream in(file, std::ios::binary);
    if (!in) throw Error(file.string(), 0, "cannot be opened; expected a file that can be read");
    return in;
}

/// Reads at most `most` bytes more.
template <class Bytes>
void append(Bytes& bytes, std::ifstream& in, std::size_t most, const std::filesystem::path& file) {
    const std::size_t before = bytes.size();
    bytes.resize(before + most);
    in.read(reinterpret_cast<char*>(bytes.data()) + before, std::streamsize(most));
    if (in.bad()) throw Error(file.string(), 0, "cannot be read to its end");
    bytes.resize(before + std::size_t(in.gcount()));
}

}  // namespace

std::string first_bytes(const std::filesystem::path& file) {
    std::ifstream in = opened(file);
    std::string bytes;
    append(bytes, in, beginning_size, file);
    return bytes;
}

std::vector<std::uint8_t> read_bytes(const std::filesystem::path& file,
                                     const Beginning& beginning) {
    std::ifstream in = opened(file);
    std::vector<std::uint8_t> bytes;
    append(bytes, in, beginning_size, file);
    std::error_code code;
    if (const std::uintmax_t size = std::filesystem::file_size(file, code); !code && size > largest)
        throw Error(file.string(), 0, "has more than 2 GB; expected less");
    if (!beginning.fits({reinterpret_cast<const char*>(bytes.data()), bytes.size()}))
        throw Error(file.string(), 0, beginning.otherwise);
    // A file may grow while it is read.
    while (in && bytes.size() <= largest)
        append(bytes, in, std::max<std::size_t>(bytes.size(), 1 << 16), file);
    if (bytes.size() > largest) throw Error(file.string(), 0, "has more than 2 GB; expected less");
    return bytes;
}

bool has_identifier(std::string_view bytes, std::string_view identifier) {
    return bytes.size() >= 8 && bytes.substr(4, 4) == identifier;
}

}  // namespace gw::inspect
