// Textures in blocks of S3TC, against colours written down by hand. GL_EXT_texture_compression_s3tc
#include "tests/gl/unit/support/window.h"

#include <algorithm>

namespace gw::gl {
namespace {

using Pixel = std::array<GLubyte, 4>;
using Bytes = std::vector<GLubyte>;

/// A block's colours: 5, 6, 5 bits, the lower byte first; then a byte of four codes for each row, the
/// first texel's in the lowest bits.
Bytes colors(unsigned first, unsigned second, std::array<GLubyte, 4> rows) {
    return {GLubyte(first),  GLubyte(first >> 8),
            GLubyte(second), GLubyte(second >> 8),
            rows[0],         rows[1],
            rows[2],         rows[3]};
}
constexpr unsigned red_565 = 0xF800, blue_565 = 0x001F;
/// Rows of the codes 0 to 3, 3 to 0, all 2, all 3.
constexpr std::array<GLubyte, 4> rows{0b11100100, 0b00011011, 0b10101010, 0b11111111};

std::vector<Pixel> coded_texels(const std::array<Pixel, 4>& codes) {
    std::vector<Pixel> out;
    for (const int code : {0, 1, 2, 3, 3, 2, 1, 0, 2, 2, 2, 2, 3, 3, 3, 3})
        out.push_back(codes[std::size_t(code)]);
    return out;
}

Bytes joined(Bytes a, const Bytes& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

void give(GLenum format, int width, int height, const Bytes& blocks) {
    glCompressedTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, GLsizei(blocks.size()),
                           blocks.data());
}
std::vector<Pixel> read_texels(int count) {
    std::vector<Pixel> out(static_cast<std::size_t>(count));
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, out.data());
    return out;
}

std::array<GLubyte, 4> all_rows(GLubyte row) { return {row, row, row, row}; }

/// The blocks of 4x4 texels that are given with a format.
Bytes blocks_of(GLenum format, const std::vector<Pixel>& texels) {
    glTexImage2D(GL_TEXTURE_2D, 0, GLint(format), 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 texels.data());
    GLint size = 0;
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_COMPRESSED_IMAGE_SIZE, &size);
    Bytes out(std::size_t(size), GLubyte{0});
    glGetCompressedTexImage(GL_TEXTURE_2D, 0, out.data());
    return out;
}

}  // namespace

TEST(GlCompressedTextures, HaveTheColoursOfTheirBlocks) {
    const Window window;
    const std::array<Pixel, 4> four{
        {{255, 0, 0, 255}, {0, 0, 255, 255}, {170, 0, 85, 255}, {85, 0, 170, 255}}};
    give(GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 4, 4, colors(red_565, blue_565, rows));
    EXPECT_EQ(read_texels(16), coded_texels(four));
    const std::array<Pixel, 4> three{
        {{0, 0, 255, 255}, {255, 0, 0, 255}, {127, 0, 127, 255}, {0, 0, 0, 255}}};
    give(GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 4, 4, colors(blue_565, red_565, rows));
    EXPECT_EQ(read_texels(16), coded_texels(three));
    std::array<Pixel, 4> with_hole = three;
    with_hole[3][3] = 0;
    give(GL_COMPRESSED_RGBA_S3TC_DXT1_EXT, 4, 4, colors(blue_565, red_565, rows));
    EXPECT_EQ(read_texels(16), coded_texels(with_hole));
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

TEST(GlCompressedTextures, HaveTheAlphasOfTheirBlocks) {
    const Window window;
    const auto alphas = [] {
        std::vector<int> out;
        for (const Pixel& texel : read_texels(16)) out.push_back(texel[3]);
        return out;
    };
    const Bytes color = colors(blue_565, red_565, rows);  // four colours, whatever the order
    give(GL_COMPRESSED_RGBA_S3TC_DXT3_EXT, 4, 4,
         joined({0x10, 0x32, 0x54, 0x76, 0x98, 0xBA, 0xDC, 0xFE}, color));
    std::vector<int> expected;
    for (int i = 0; i < 16; ++i) expected.push_back(17 * i);
    EXPECT_EQ(alphas(), expected);
    EXPECT_EQ(read_texels(16)[2][0], 85);
    // Codes 0 to 7, twice, of 3 bits.
    const Bytes codes{0x88, 0xC6, 0xFA, 0x88, 0xC6, 0xFA};
    give(GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, 4, 4, joined(joined({210, 70}, codes), color));
    EXPECT_EQ(alphas(), (std::vector{210, 70, 190, 170, 150, 130, 110, 90, 210, 70, 190, 170, 150,
                                     130, 110, 90}));
    give(GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, 4, 4, joined(joined({70, 170}, codes), color));
    EXPECT_EQ(alphas(), (std::vector{70, 170, 90, 110, 130, 150, 0, 255, 70, 170, 90, 110, 130, 150,
                                     0, 255}));
}

TEST(GlCompressedTextures, GiveTheirBlocksBackAndTakeOthers) {
    const Window window;
    const Bytes block = colors(red_565, blue_565, rows), other = colors(blue_565, red_565, rows);
    const Bytes four = joined(joined(block, block), joined(block, block));
    const GLenum format = GL_COMPRESSED_RGB_S3TC_DXT1_EXT;
    give(format, 6, 5, four);
    GLint size = 0, is_compressed = 0;
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_COMPRESSED, &is_compressed);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_COMPRESSED_IMAGE_SIZE, &size);
    EXPECT_EQ(is_compressed, GL_TRUE);
    EXPECT_EQ(size, 32);
    glCompressedTexSubImage2D(GL_TEXTURE_2D, 0, 4, 0, 2, 4, format, 8, other.data());
    Bytes back(32);
    glGetCompressedTexImage(GL_TEXTURE_2D, 0, back.data());
    EXPECT_EQ(back, joined(joined(block, other), joined(block, block)));
    const std::vector<Pixel> now = read_texels(30);
    give(format, 6, 5, back);
    EXPECT_EQ(read_texels(30), now);
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

TEST(GlCompressedTextures, WrongCallsAreErrorsAndChangeNothing) {
    const Window window;
    const Bytes block = colors(red_565, blue_565, rows);
    const GLenum format = GL_COMPRESSED_RGB_S3TC_DXT1_EXT;
    give(format, 4, 4, block);
    const std::vector<Pixel> before = read_texels(16);
    const auto expect = [&](GLenum error, const char* what) {
        EXPECT_EQ(glGetError(), error) << what;
    };
    glCompressedTexImage2D(GL_TEXTURE_2D, 0, format, 4, 4, 0, 7, block.data());
    expect(GL_INVALID_VALUE, "size");
    glCompressedTexImage2D(GL_TEXTURE_2D, 0, format, 4, 4, 0, -8, block.data());
    expect(GL_INVALID_VALUE, "a negative size");
    glCompressedTexImage2D(GL_TEXTURE_2D, 0, format, -4, 4, 0, 8, block.data());
    expect(GL_INVALID_VALUE, "width");
    glCompressedTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 4, 4, 0, 8, block.data());
    expect(GL_INVALID_ENUM, "format");
    glCompressedTexImage2D(GL_TEXTURE_1D, 0, format, 4, 4, 0, 8, block.data());
    expect(GL_INVALID_ENUM, "target");
    glCompressedTexImage1D(GL_TEXTURE_1D, 0, format, 4, 0, 8, block.data());
    expect(GL_INVALID_ENUM, "one dimension");
    const Bytes four_blocks(32);
    glCompressedTexImage2D(GL_TEXTURE_2D, 0, format, 6, 6, 1, 32, four_blocks.data());
    expect(GL_INVALID_OPERATION, "border");
    glCompressedTexSubImage2D(GL_TEXTURE_2D, 0, 1, 0, 3, 4, format, 8, block.data());
    expect(GL_INVALID_OPERATION, "half a block");
    glCompressedTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 4, 4, GL_COMPRESSED_RGBA_S3TC_DXT3_EXT, 16,
                              four_blocks.data());
    expect(GL_INVALID_OPERATION, "another format");
    glCompressedTexSubImage2D(GL_TEXTURE_2D, 0, 4, 0, 4, 4, format, 8, block.data());
    expect(GL_INVALID_VALUE, "outside");
    glCompressedTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 4, 4, format, 9, block.data());
    expect(GL_INVALID_VALUE, "size");
    EXPECT_EQ(read_texels(16), before);
    const Pixel white{255, 255, 255, 255};
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, white.data());
    Bytes back(8);
    glGetCompressedTexImage(GL_TEXTURE_2D, 0, back.data());
    expect(GL_INVALID_OPERATION, "a part is not of blocks");
}

TEST(GlCompressedTextures, TexelsBecomeBlocks) {
    const Window window;
    const Pixel red{255, 0, 0, 255}, blue{0, 0, 255, 255}, clear{9, 9, 9, 0};
    const std::vector<Pixel> halves{red, red, blue, blue, red, red, blue, blue,
                                    red, red, blue, blue, red, red, blue, blue};
    GLenum format = GL_COMPRESSED_RGB_S3TC_DXT1_EXT;
    EXPECT_EQ(blocks_of(format, halves), colors(red_565, blue_565, all_rows(0b01010000)));
    EXPECT_EQ(read_texels(16), halves);
    // 85 is a third of 255: the code between the ends.
    std::vector<Pixel> thirds(halves);
    thirds[0] = {170, 0, 85, 255};
    EXPECT_EQ(blocks_of(format, thirds)[4], 0b01010010);
    EXPECT_EQ(read_texels(16), thirds);
    // A hole: the first colour is the lesser one.
    std::vector<Pixel> with_hole(halves);
    with_hole[3] = clear;
    format = GL_COMPRESSED_RGBA_S3TC_DXT1_EXT;
    const std::array<GLubyte, 4> holed{0b11000101, 0b00000101, 0b00000101, 0b00000101};
    EXPECT_EQ(blocks_of(format, with_hole), colors(blue_565, red_565, holed));
    EXPECT_EQ(read_texels(16)[3], (Pixel{0, 0, 0, 0}));
    EXPECT_EQ(blocks_of(format, std::vector<Pixel>(16, clear)), colors(0, 0, all_rows(0xFF)));
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

TEST(GlCompressedTextures, AlphasBecomeBlocks) {
    const Window window;
    std::vector<Pixel> texels;
    for (int i = 0; i < 16; ++i) texels.push_back({255, 0, 0, GLubyte(17 * i)});
    const Bytes red = colors(red_565, red_565, all_rows(0));
    EXPECT_EQ(blocks_of(GL_COMPRESSED_RGBA_S3TC_DXT3_EXT, texels),
              joined({0x10, 0x32, 0x54, 0x76, 0x98, 0xBA, 0xDC, 0xFE}, red));
    EXPECT_EQ(read_texels(16), texels);
    GLint bits = 0;
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_ALPHA_SIZE, &bits);
    EXPECT_EQ(bits, 4);
    // The eight alphas from 210 to 70, twice: codes 0, 2 .. 7, 1.
    for (std::size_t i = 0; i < 16; ++i) texels[i][3] = GLubyte(210 - 20 * (i % 8));
    EXPECT_EQ(blocks_of(GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, texels),
              joined(joined({210, 70}, {0xD0, 0x58, 0x3F, 0xD0, 0x58, 0x3F}), red));
    EXPECT_EQ(read_texels(16), texels);
}

/// An image that is no whole number of blocks, and parts of it.
TEST(GlCompressedTextures, PartsAreWholeBlocks) {
    const Window window;
    const Pixel red{255, 0, 0, 255}, blue{0, 0, 255, 255};
    const GLenum format = GL_COMPRESSED_RGB_S3TC_DXT1_EXT;
    const auto give_part = [](int x, int y, int width, int height, const Pixel& color) {
        const std::vector<Pixel> part(std::size_t(width * height), color);
        glTexSubImage2D(GL_TEXTURE_2D, 0, x, y, width, height, GL_RGBA, GL_UNSIGNED_BYTE,
                        part.data());
        return glGetError();
    };
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    const std::vector<Pixel> all(6 * 5, red);
    glTexImage2D(GL_TEXTURE_2D, 0, format, 6, 5, 0, GL_RGBA, GL_UNSIGNED_BYTE, all.data());
    EXPECT_EQ(give_part(0, 0, 2, 4, blue), GLenum(GL_INVALID_OPERATION));
    EXPECT_EQ(read_texels(30), all);
    EXPECT_EQ(give_part(4, 0, 2, 4, blue), GLenum(GL_NO_ERROR)) << "up to the image's side";
    EXPECT_EQ(read_texels(30)[4], blue);
    EXPECT_EQ(read_texels(30)[3], red);
    Bytes back(32);
    glGetCompressedTexImage(GL_TEXTURE_2D, 0, back.data());
    const Bytes reds = colors(red_565, red_565, all_rows(0)),
                blues = colors(blue_565, blue_565, all_rows(0));
    EXPECT_EQ(back, joined(joined(reds, blues), joined(reds, reds)));
    // Without texels: blocks can be given afterwards.
    glCompressedTexImage2D(GL_TEXTURE_2D, 0, format, 4, 4, 0, 8, nullptr);
    glCompressedTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 4, 4, format, 8, blues.data());
    EXPECT_EQ(read_texels(16), std::vector<Pixel>(16, blue));
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

/// [GL13] 3.8.1: a format that the library does not compress is that of its base.
TEST(GlCompressedTextures, OtherFormatsAreThoseOfTheirBase) {
    const Window window;
    const auto stored = [](GLenum format, GLint border) {
        glTexImage2D(GL_TEXTURE_2D, 0, GLint(format), 4 + 2 * border, 4 + 2 * border, border,
                     GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        GLint value = 0, compressed = -1;
        glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_INTERNAL_FORMAT, &value);
        glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_COMPRESSED, &compressed);
        EXPECT_EQ(compressed, 0);
        return value;
    };
    EXPECT_EQ(stored(GL_COMPRESSED_RGB, 0), GL_RGB);
    EXPECT_EQ(stored(GL_COMPRESSED_INTENSITY, 0), GL_INTENSITY);
    EXPECT_EQ(stored(GL_COMPRESSED_SRGB_ALPHA, 0), GL_SRGB_ALPHA);
    EXPECT_EQ(stored(GL_COMPRESSED_SLUMINANCE, 0), GL_SLUMINANCE);
    EXPECT_EQ(stored(GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, 1), GL_RGBA) << "a border";
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    GLint size = 0;
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_COMPRESSED_IMAGE_SIZE, &size);
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
}

}  // namespace gw::gl
