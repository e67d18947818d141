#include "apps/hidden/page.h"

#include "gw/error.h"

#include <zlib.h>

namespace gw::apps {

namespace {

/// In the format of gzip, which browsers unpack.
std::string packed(const std::string& text) {
    constexpr int window_bits_of_gzip = 15 + 16;
    z_stream stream{};
    if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, window_bits_of_gzip, 9,
                     Z_DEFAULT_STRATEGY) != Z_OK)
        throw Error("not enough memory to pack the data of a page");
    std::string out(deflateBound(&stream, uLong(text.size())), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
    stream.avail_in = uInt(text.size());
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = uInt(out.size());
    const int result = deflate(&stream, Z_FINISH);
    out.resize(stream.total_out);
    deflateEnd(&stream);
    if (result != Z_STREAM_END) throw Error("the data of a page cannot be packed");
    return out;
}

}  // namespace

std::string base64(std::string_view bytes) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (i + k < bytes.size() ? std::uint8_t(bytes[i + k]) : 0);
        for (std::size_t k = 0; k < 4; ++k)
            out += i + k <= bytes.size() ? digits[group >> (18 - 6 * k) & 63] : '=';
    }
    return out;
}

std::string page_with(std::string_view name, const std::vector<std::string>& texts) {
    constexpr std::string_view mark = "<!-- data -->";
    std::string page(embedded_page(name));
    if (page.empty()) return page;
    std::string scripts;
    for (const std::string& text : texts)
        scripts +=
            "<script class=\"data\" type=\"text/plain\">" + base64(packed(text)) + "</script>\n";
    const std::size_t at = page.find(mark);
    if (at == page.npos)
        throw Error("the built-in " + std::string(name) + " lacks '" + std::string(mark) + "'");
    return page.replace(at, mark.size(), scripts);
}

}  // namespace gw::apps
