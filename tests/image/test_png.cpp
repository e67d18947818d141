// Claims: PNG files of every kind give the same texels as through OpenImageIO; damaged ones give
// none.
#include "image/textures.h"
#include "image/write.h"

#include "tests/image/files.h"
#include "tests/image/refusal.h"
#include "tests/judge/judge.h"

#include <png.h>

namespace gw::image {
namespace {

struct Kind {
    const char* name;
    int color_type, bits;
    bool transparent = false, interlaced = false;
};

constexpr int width = 9, height = 5;

void write_header(png_structp png, png_infop info, const Kind& kind) {
    png_set_IHDR(png, info, width, height, kind.bits, kind.color_type,
                 kind.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    const png_color palette[] = {{10, 20, 30}, {40, 50, 60}, {70, 80, 90}, {100, 110, 120}};
    png_byte alphas[] = {0, 77};
    png_color_16 key{.index = 0, .red = 1, .green = 1, .blue = 1, .gray = 1};
    const bool indexed = kind.color_type == PNG_COLOR_TYPE_PALETTE;
    if (indexed) png_set_PLTE(png, info, palette, 4);
    if (kind.transparent)
        png_set_tRNS(png, info, alphas, indexed ? 2 : 0, indexed ? nullptr : &key);
    png_set_gAMA(png, info, 1.0);  // not looked at
    png_write_info(png, info);
}

/// Indices 0 .. 3 for a palette; else bytes of all values, among them the transparent colour.
std::vector<png_byte> row_of(const Kind& kind, std::size_t bytes, int y) {
    std::vector<png_byte> row(bytes);
    for (std::size_t i = 0; i < bytes; ++i) {
        const auto byte = static_cast<unsigned>(y * 53 + static_cast<int>(i) * 31);
        row[i] = static_cast<png_byte>(kind.color_type == PNG_COLOR_TYPE_PALETTE && kind.bits == 8
                                           ? byte % 4
                                       : y == 1 ? (kind.bits == 16 ? i % 2 : 1)
                                                : byte);
    }
    return row;
}

void write_kind(const std::filesystem::path& file, const Kind& kind) {
    std::FILE* out = std::fopen(file.c_str(), "wb");
    ASSERT_TRUE(out);
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, out);
    write_header(png, info, kind);
    const int passes = png_set_interlace_handling(png);
    for (int pass = 0; pass < passes; ++pass)
        for (int y = 0; y < height; ++y)
            png_write_row(png, row_of(kind, png_get_rowbytes(png, info), y).data());
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    std::fclose(out);
}

/// As OpenImageIO reads them, R, G, B, A, bottom row first.
std::vector<std::uint16_t> judged(const std::filesystem::path& file) {
    const auto [spec, values] = judge::stored_in<std::uint16_t>(file);
    const auto channels = std::size_t(spec.channels);
    std::vector<std::uint16_t> rgba;
    for (int y = height - 1; y >= 0; --y) {
        for (int x = 0; x < width; ++x) {
            const std::uint16_t* v = &values[std::size_t(y * width + x) * channels];
            const std::size_t color = channels < 3 ? 0 : 1;
            const bool alpha = channels % 2 == 0;
            rgba.insert(rgba.end(), {v[0], v[color], v[2 * color],
                                     alpha ? v[channels - 1] : std::uint16_t{65535}});
        }
    }
    return rgba;
}

}  // namespace

TEST(PngKinds, HoldTheTexelsThatOpenImageIOFinds) {
    const Kind kinds[] = {Kind{"grey1", PNG_COLOR_TYPE_GRAY, 1},
                          Kind{"grey2", PNG_COLOR_TYPE_GRAY, 2},
                          Kind{"grey4", PNG_COLOR_TYPE_GRAY, 4},
                          Kind{"grey8", PNG_COLOR_TYPE_GRAY, 8},
                          Kind{"grey16", PNG_COLOR_TYPE_GRAY, 16},
                          Kind{"grey_key", PNG_COLOR_TYPE_GRAY, 8, true},
                          Kind{"grey_alpha8", PNG_COLOR_TYPE_GRAY_ALPHA, 8},
                          Kind{"grey_alpha16", PNG_COLOR_TYPE_GRAY_ALPHA, 16},
                          Kind{"rgb8", PNG_COLOR_TYPE_RGB, 8},
                          Kind{"rgb16", PNG_COLOR_TYPE_RGB, 16},
                          Kind{"rgb_key", PNG_COLOR_TYPE_RGB, 8, true},
                          Kind{"rgb16_key", PNG_COLOR_TYPE_RGB, 16, true},
                          Kind{"rgba8", PNG_COLOR_TYPE_RGB_ALPHA, 8},
                          Kind{"rgba16", PNG_COLOR_TYPE_RGB_ALPHA, 16},
                          Kind{"indexed2", PNG_COLOR_TYPE_PALETTE, 2},
                          Kind{"indexed8", PNG_COLOR_TYPE_PALETTE, 8},
                          Kind{"indexed_alpha", PNG_COLOR_TYPE_PALETTE, 2, true},
                          Kind{"interlaced", PNG_COLOR_TYPE_RGB, 8, false, true},
                          Kind{"interlaced_grey1", PNG_COLOR_TYPE_GRAY, 1, false, true}};
    for (const Kind& kind : kinds) {
        SCOPED_TRACE(kind.name);
        const Folder folder;
        write_kind(folder / "a.png", kind);
        const TextureRef expected = make_texture("", width, height, judged(folder / "a.png"));
        EXPECT_EQ(read_texture(folder / "a.png")->levels, expected->levels);
    }
}

TEST(ReadPng, KnowsOneByItsBytesWhateverItsName) {
    const Folder folder;
    write_kind(folder / "a.png", {"rgb8", PNG_COLOR_TYPE_RGB, 8});
    std::filesystem::copy_file(folder / "a.png", folder / "a.jpg");
    EXPECT_EQ(read_texture(folder / "a.jpg")->levels, read_texture(folder / "a.png")->levels);
    const Picture grey{.width = 1, .height = 1, .channels = 1, .bits = 8, .values = {128}};
    write_picture(folder / "b.tif", grey);
    std::filesystem::rename(folder / "b.tif", folder / "b.png");
    EXPECT_EQ(read_texture(folder / "b.png")->levels[0].rgba[0], 128 * 257);
}

TEST(ReadPng, RefusesEveryPartOfAFile) {
    const Folder folder;
    write_kind(folder / "a.png", {"rgb8", PNG_COLOR_TYPE_RGB, 8});
    const std::string whole = bytes_of(folder / "a.png");
    for (std::size_t size = 8; size < whole.size(); ++size) {
        folder.write("cut.png", whole.substr(0, size));
        const std::string why = refusal(folder / "cut.png");
        EXPECT_NE(why.find("picture file"), why.npos) << size;
        EXPECT_NE(why.find("cut short"), why.npos) << why;
    }
}

TEST(ReadPng, RefusesPixelsOfWhichOneBitIsDamaged) {
    const Folder folder;
    write_kind(folder / "a.png", {"rgb8", PNG_COLOR_TYPE_RGB, 8});
    const std::string whole = bytes_of(folder / "a.png");
    const std::size_t data = whole.find("IDAT") + 4, end = whole.find("IEND") - 8;
    for (std::size_t byte = data; byte < end; ++byte) {
        std::string damaged = whole;
        damaged[byte] = static_cast<char>(damaged[byte] ^ 4);
        folder.write("damaged.png", damaged);
        EXPECT_NE(refusal(folder / "damaged.png").find("expected a whole picture file"),
                  std::string::npos)
            << byte;
    }
}

}  // namespace gw::image
