// Claims: damaged pictures of every format are textures or errors, in little memory and time;
// decoding goes on after a crash.
#include "image/decoder_process.h"
#include "image/decoder_reply.h"

#include "tests/image/files.h"
#include "tests/image/refusal.h"
#include "tests/judge/judge.h"

#include <sys/resource.h>

#include <array>
#include <fstream>

namespace gw::image {
namespace {

/// A picture of 20 x 12 pixels in the format of the extension; false if there is none.
bool write_sample(const std::filesystem::path& file) {
    std::vector<std::uint8_t> values(20 * 12 * 3);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::uint8_t(i * i / 7);
    return judge::store(file, {20, 12, 3}, values);
}

/// Some bytes replaced, most of them in the header; the seed chooses.
std::string damaged(std::string bytes, std::uint32_t seed) {
    const auto random = [&seed](std::size_t below) {
        seed = seed * 1664525 + 1013904223;
        return (seed >> 8) % below;
    };
    for (std::size_t n = 1 + random(6); n > 0; --n) {
        const std::size_t end =
            random(4) == 0 ? bytes.size() : std::min<std::size_t>(bytes.size(), 800);
        const std::size_t at = random(end);
        if (random(8) == 0)
            bytes.resize(at + 1);
        else
            bytes[at] = "\0\xff\x7f\x80"[random(4)];
    }
    return bytes;
}

bool reads(DecoderProcess& decoder, const std::filesystem::path& file) {
    try {
        return decoder.read(file).width == 20;
    } catch (const Error&) {
        return false;
    }
}

constexpr std::array formats{"sgi", "dpx", "cin",  "tga",  "bmp",   "tif", "jpg",
                             "gif", "ppm", "hdr",  "exr",  "rla",   "ico", "iff",
                             "pic", "jp2", "webp", "heic", "zfile", "fits"};
constexpr int most_not_written = 5;  // by Debian 12's OpenImageIO: three

/// Runs check(file, whole, decoder) for a sample of each format, with a decoder of its own.
template <typename Check>
void for_samples(const Check& check) {
    const Folder folder;
    int not_written = 0;
    for (const char* format : formats) {
        SCOPED_TRACE(format);
        const auto file = folder / (std::string("a.") + format);
        DecoderProcess decoder;
        if (write_sample(file))
            check(file, bytes_of(file), decoder);
        else
            ++not_written;
    }
    EXPECT_LE(not_written, most_not_written);
}

void write(const std::filesystem::path& file, const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
}

}  // namespace

TEST(DamagedPictures, AreTexturesOrErrorsOfOneLine) {
    for_samples(
        [](const std::filesystem::path& file, const std::string& whole, DecoderProcess& decoder) {
            // some readers refuse what the writers write
            const bool readable = reads(decoder, file);
            for (std::uint32_t seed = 0; seed < 25; ++seed) {
                write(file, damaged(whole, seed));
                try {
                    decoder.read(file);
                } catch (const Error& error) {
                    const std::string message = error.what();
                    EXPECT_EQ(message.find('\n'), message.npos) << "seed " << seed;
                    EXPECT_LT(message.size(), 400u) << "seed " << seed;
                }
            }
            write(file, whole);
            EXPECT_EQ(reads(decoder, file), readable);
        });
}

TEST(DamagedPictures, ThatAreCutAreErrorsOrTheWholePicture) {
    for_samples(
        [](const std::filesystem::path& file, const std::string& whole, DecoderProcess& decoder) {
            if (!reads(decoder, file)) return;  // some readers refuse what the writers write
            const Texels expected = decoder.read(file);
            for (const std::size_t part : {1u, 7u, 20u, 32u, 45u, 57u, 60u, 62u, 63u}) {
                write(file, whole.substr(0, whole.size() * part / 64));
                try {
                    const Texels found = decoder.read(file);
                    EXPECT_EQ(found.width, expected.width) << part;
                    EXPECT_TRUE(found.rgba == expected.rgba) << part << " of 64 parts";
                } catch (const Error& error) {
                    EXPECT_NE(std::string(error.what()), "") << part;
                }
            }
        });
}

TEST(DecoderProcess, LimitsMemory) {
    rusage before{}, after{};
    getrusage(RUSAGE_CHILDREN, &before);
    const Folder folder;
    const auto file = folder / "a.dpx";
    ASSERT_TRUE(write_sample(file));
    std::string bytes = bytes_of(file);
    for (const std::size_t at : {772u, 776u})  // width and height, the high byte first
        bytes.replace(at, 4, std::string("\0\0\xff\xff", 4));
    folder.write("a.dpx", bytes);
    EXPECT_NE(refusal(file), "");
    getrusage(RUSAGE_CHILDREN, &after);
    EXPECT_LT(std::uint64_t(after.ru_maxrss), 2 * decoder_megabytes * 1024);
}

/// 35 bytes that say they are 4,294,836,225 pixels.
TEST(DecoderProcess, RefusesAGifThatWouldFillTheMemory) {
    const auto gif = [](std::size_t canvas, std::size_t picture) {
        const auto word = [](std::size_t n) { return std::string{char(n & 255), char(n >> 8)}; };
        return "GIF89a" + word(canvas) + word(canvas) +
               std::string("\x80\0\0\0\0\0\xff\xff\xff", 9) + "," + std::string(4, '\0') +
               word(picture) + word(picture) + std::string("\0\2\2\x4c\1\0;", 7);
    };
    const Folder folder;
    rusage after{};
    for (const std::size_t picture : {65535u, 1u}) {
        folder.write("a.gif", gif(65535, picture));
        EXPECT_EQ(refusal(folder / "a.gif"), "decoding it needs more than " +
                                                 std::to_string(decoder_megabytes) +
                                                 " MB; expected a smaller picture");
    }
    folder.write("a.gif", gif(16, 65535));
    EXPECT_NE(refusal(folder / "a.gif").find("; expected a picture file"), std::string::npos);
    getrusage(RUSAGE_CHILDREN, &after);
    EXPECT_LT(std::uint64_t(after.ru_maxrss), 2 * decoder_megabytes * 1024);
}

TEST(DecoderProcess, RefusesAPortableMapWhoseLargestValueIsZero) {
    const Folder folder;
    for (const char* text : {"P2\n1 1\n0\n0\n", "P3\n# a comment 1\n1 1\n00\n0 0 0\n"}) {
        folder.write("a.ppm", text);
        EXPECT_EQ(refusal(folder / "a.ppm"),
                  "its largest value is 0; expected one from 1 to 65535");
    }
}

}  // namespace gw::image
