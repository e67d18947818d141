#include "gw/error.h"
#include "image/png/png.h"

#include <png.h>

#include <array>
#include <bit>
#include <cstdio>
#include <fstream>
#include <memory>

namespace gw::image {
namespace {

[[noreturn]] void refuse_reading(png_structp png, png_const_charp why) {
    *static_cast<std::string*>(png_get_error_ptr(png)) = why;
    png_longjmp(png, 1);
}

void read_bytes(png_structp png, png_bytep to, std::size_t count) {
    auto* file = static_cast<std::FILE*>(png_get_io_ptr(png));
    if (std::fread(to, 1, count, file) != count) png_error(png, "the file is cut short");
}

struct Reader {
    explicit Reader(std::string& refusal)
        : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, &refusal, refuse_reading,
                                     [](png_structp, png_const_charp) {})),
          info(png_create_info_struct(png)) {}
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    png_structp png;
    png_infop info;
};

// Nothing in the next two functions may need a destructor: on refusal libpng jumps back to setjmp.

/// From here on every row is R, G, B, A of 8 or 16 bits.
bool read_header(const Reader& reader, std::FILE* file) {
    if (setjmp(png_jmpbuf(reader.png))) return false;
    png_set_read_fn(reader.png, file, read_bytes);
    png_read_info(reader.png, reader.info);
    png_set_expand(reader.png);
    png_set_gray_to_rgb(reader.png);
    png_set_add_alpha(reader.png, 0xffff, PNG_FILLER_AFTER);
    if (std::endian::native == std::endian::little) png_set_swap(reader.png);
    png_set_interlace_handling(reader.png);
    png_read_update_info(reader.png, reader.info);
    return true;
}

bool read_rows(const Reader& reader, png_bytepp rows) {
    if (setjmp(png_jmpbuf(reader.png))) return false;
    png_read_image(reader.png, rows);
    png_read_end(reader.png, nullptr);
    return true;
}

template <class T>
std::vector<T> read_rgba(const Reader& reader, std::size_t width, std::size_t height) {
    std::vector<T> rgba(width * height * 4);
    std::vector<png_bytep> rows(height);  // top row first
    for (std::size_t y = 0; y < height; ++y)
        rows[height - 1 - y] = reinterpret_cast<png_bytep>(&rgba[y * width * 4]);
    if (!read_rows(reader, rows.data())) rgba.clear();
    return rgba;
}

}  // namespace

bool holds_png(const std::filesystem::path& file) {
    std::array<char, 8> first{};
    std::ifstream(file, std::ios::binary).read(first.data(), first.size());
    return png_sig_cmp(reinterpret_cast<png_const_bytep>(first.data()), 0, first.size()) == 0;
}

Texels read_png(const std::filesystem::path& file) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> open(std::fopen(file.c_str(), "rb"),
                                                               std::fclose);
    if (!open) throw Error("it cannot be opened; expected a picture file");
    std::string refusal;
    const Reader reader(refusal);
    if (!read_header(reader, open.get()))
        throw Error("it cannot be read: " + refusal + "; expected a picture file");
    const png_uint_32 width = png_get_image_width(reader.png, reader.info);
    const png_uint_32 height = png_get_image_height(reader.png, reader.info);
    check_sides(width, height);
    Texels texels{.width = static_cast<int>(width), .height = static_cast<int>(height), .rgba = {}};
    if (png_get_bit_depth(reader.png, reader.info) == 16)
        texels.rgba = read_rgba<std::uint16_t>(reader, width, height);
    else
        texels.rgba = read_rgba<std::uint8_t>(reader, width, height);
    if (!refusal.empty())
        throw Error("it cannot be read to its end: " + refusal + "; expected a whole picture file");
    return texels;
}

}  // namespace gw::image
