#include "image/png.h"

#include "gw/base/arithmetic.h"
#include "gw/error.h"

#include <png.h>
#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
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

constexpr int compression = 2;  // a quarter of the time of 6, an eighth larger

struct Sink {
    std::vector<std::uint8_t> bytes;
    std::string refusal;
};

[[noreturn]] void refuse_writing(png_structp png, png_const_charp why) {
    static_cast<Sink*>(png_get_error_ptr(png))->refusal = why;
    png_longjmp(png, 1);
}

void append(png_structp png, png_bytep first, std::size_t count) {
    auto& bytes = static_cast<Sink*>(png_get_io_ptr(png))->bytes;
    bytes.insert(bytes.end(), first, first + count);
}

struct Writer {
    explicit Writer(Sink& sink)
        : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, &sink, refuse_writing,
                                      [](png_structp, png_const_charp) {})),
          info(png_create_info_struct(png)) {
        png_set_write_fn(png, &sink, append, nullptr);
    }
    ~Writer() { png_destroy_write_struct(&png, &info); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    png_structp png;
    png_infop info;
};

int stored_bits(const Picture& picture) { return picture.bits <= 8 ? 8 : 16; }

/// As the file has them: top row first, the high byte of 16 bits first.
std::vector<std::uint8_t> samples(const Picture& picture) {
    const int bits = stored_bits(picture);
    const auto row = static_cast<std::ptrdiff_t>(picture.width) * picture.channels;
    std::vector<std::uint8_t> bytes;
    bytes.reserve(picture.values.size() * std::size_t(bits / 8));
    for (auto end = picture.values.end(); end != picture.values.begin(); end -= row) {
        std::for_each(end - row, end, [&](std::uint16_t v) {
            const auto scaled = rescale(v, picture.bits, bits);
            if (bits == 16) bytes.push_back(static_cast<std::uint8_t>(scaled >> 8));
            bytes.push_back(static_cast<std::uint8_t>(scaled));
        });
    }
    return bytes;
}

// Nothing here may need a destructor: on refusal libpng jumps back to setjmp.
bool write(const Writer& writer, const Picture& picture, const std::uint8_t* samples) {
    if (setjmp(png_jmpbuf(writer.png))) return false;
    png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(picture.width),
                 static_cast<png_uint_32>(picture.height), stored_bits(picture),
                 picture.channels == 1   ? PNG_COLOR_TYPE_GRAY
                 : picture.channels == 3 ? PNG_COLOR_TYPE_RGB
                                         : PNG_COLOR_TYPE_RGB_ALPHA,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_compression_level(writer.png, compression);
    png_write_info(writer.png, writer.info);
    const std::size_t row = png_get_rowbytes(writer.png, writer.info);
    for (int y = 0; y < picture.height; ++y)
        png_write_row(writer.png, samples + row * std::size_t(y));
    png_write_end(writer.png, nullptr);
    return true;
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

bool is_png_name(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension == ".png";
}

void put_png(OutputFile& file, const Picture& picture) {
    Sink sink;
    const Writer writer(sink);
    if (!write(writer, picture, samples(picture).data()))
        throw Error(file.target().string(), 0, "cannot be written: " + sink.refusal);
    file.write(sink.bytes);
}

}  // namespace gw::image
