#include "gw/base/arithmetic.h"
#include "gw/error.h"
#include "image/png/png.h"

#include <png.h>

#include <algorithm>
#include <cctype>

namespace gw::image {
namespace {

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
                 picture.channels == 1 ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGB,
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
