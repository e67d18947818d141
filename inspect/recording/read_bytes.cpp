#include "inspect/recording/read_bytes.h"

#include "gw/error.h"

#include <array>
#include <fstream>

namespace gw::inspect {

std::vector<std::uint8_t> read_bytes(const std::filesystem::path& file) {
    constexpr std::size_t most = std::size_t{1} << 31;
    std::error_code code;
    const auto kind = std::filesystem::status(file, code).type();
    using enum std::filesystem::file_type;
    if (kind == directory) throw Error(file.string(), 0, "is a folder; expected a file");
    if (kind == character || kind == block)
        throw Error(file.string(), 0, "is a device; expected a file");
    std::ifstream in(file, std::ios::binary);
    if (!in) throw Error(file.string(), 0, "cannot be opened; expected a file that can be read");
    std::vector<std::uint8_t> bytes;
    std::array<char, 1 << 16> part;
    while (in.read(part.data(), part.size()) || in.gcount() > 0) {
        bytes.insert(bytes.end(), part.begin(), part.begin() + in.gcount());
        if (bytes.size() > most) throw Error(file.string(), 0, "has more than 2 GB; expected less");
    }
    if (in.bad()) throw Error(file.string(), 0, "cannot be read to its end");
    return bytes;
}

}  // namespace gw::inspect
