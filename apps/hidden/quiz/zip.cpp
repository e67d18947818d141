#include "apps/hidden/quiz/zip.h"

#include <zlib.h>

#include <cstdint>

namespace gw::apps {
namespace {

void put16(std::string& to, std::size_t value) {
    to += char(value & 255);
    to += char(value >> 8 & 255);
}
void put32(std::string& to, std::size_t value) {
    put16(to, value & 65535);
    put16(to, value >> 16);
}

/// What a file's header and its entry of the directory share, from the version to the lengths.
std::string facts_of(const std::string& name, const std::string& bytes) {
    constexpr std::size_t version = 20, first_day = 1 << 5 | 1;  // 1980-01-01
    std::string facts;
    put16(facts, version);
    put16(facts, 0);  // flags
    put16(facts, 0);  // stored
    put16(facts, 0);  // midnight
    put16(facts, first_day);
    put32(facts, crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), uInt(bytes.size())));
    put32(facts, bytes.size());
    put32(facts, bytes.size());
    put16(facts, name.size());
    put16(facts, 0);  // extra
    return facts;
}

}  // namespace

std::string zip_of(const std::vector<std::pair<std::string, std::string>>& files) {
    constexpr std::size_t version = 20;
    std::string zip, directory;
    for (const auto& [name, bytes] : files) {
        directory += "PK\1\2";
        put16(directory, version);
        directory += facts_of(name, bytes);
        directory.append(10, '\0');  // comment, disk, attributes
        put32(directory, zip.size());
        directory += name;
        zip += "PK\3\4" + facts_of(name, bytes) + name + bytes;
    }
    const std::size_t begin = zip.size();
    zip += directory + "PK\5\6";
    put32(zip, 0);  // disks
    put16(zip, files.size());
    put16(zip, files.size());
    put32(zip, directory.size());
    put32(zip, begin);
    put16(zip, 0);  // comment
    return zip;
}

}  // namespace gw::apps
