// All 256 x 256 operands of each pair of blend factors through the machine, against rationals.
// Samples for 12 and 16 bits. docs/manual/fragments.md, "Blending".
#include "tests/gw/random.h"
#include "tests/gw/workbench.h"

#include <algorithm>

namespace gw {
namespace {

using namespace test;

constexpr BlendFactor sources[] = {BlendFactor::Zero,
                                   BlendFactor::One,
                                   BlendFactor::DstColor,
                                   BlendFactor::OneMinusDstColor,
                                   BlendFactor::SrcAlpha,
                                   BlendFactor::OneMinusSrcAlpha,
                                   BlendFactor::DstAlpha,
                                   BlendFactor::OneMinusDstAlpha,
                                   BlendFactor::SrcAlphaSaturate};
constexpr BlendFactor destinations[] = {BlendFactor::Zero,     BlendFactor::One,
                                        BlendFactor::SrcColor, BlendFactor::OneMinusSrcColor,
                                        BlendFactor::SrcAlpha, BlendFactor::OneMinusSrcAlpha,
                                        BlendFactor::DstAlpha, BlendFactor::OneMinusDstAlpha};

/// The specification's table by channel, with `one` for 1.
std::int64_t factor(BlendFactor f, const Rgba& s, const Rgba& d, std::size_t c, std::int64_t one) {
    const std::int64_t As = s[3], Ad = d[3];
    if (f == BlendFactor::Zero) return 0;
    if (f == BlendFactor::One) return one;
    if (f == BlendFactor::SrcColor) return s[c];
    if (f == BlendFactor::OneMinusSrcColor) return one - s[c];
    if (f == BlendFactor::DstColor) return d[c];
    if (f == BlendFactor::OneMinusDstColor) return one - d[c];
    if (f == BlendFactor::SrcAlpha) return As;
    if (f == BlendFactor::OneMinusSrcAlpha) return one - As;
    if (f == BlendFactor::DstAlpha) return Ad;
    if (f == BlendFactor::OneMinusDstAlpha) return one - Ad;
    return c == 3 ? one : std::min(As, one - Ad);  // SrcAlphaSaturate
}

/// The nearest integer to a b / one. There are no ties, because one is odd.
std::int64_t product(std::int64_t a, std::int64_t b, std::int64_t one) {
    return (2 * a * b + one) / (2 * one);
}

Rgba expected(const BlendState& b, const Rgba& s, const Rgba& d, std::int64_t one) {
    Rgba out;
    for (std::size_t c = 0; c < 4; ++c) {
        const std::int64_t sum = product(s[c], factor(b.src, s, d, c, one), one) +
                                 product(d[c], factor(b.dst, s, d, c, one), one);
        out[c] = std::uint16_t(std::min(sum, one));
    }
    return out;
}

/// A window whose pixel k has the source and stored colours of index k.
struct Operands {
    std::vector<Rgba> source, stored;
};

void check_all_pairs(const Profile& profile, int size, const Operands& operands) {
    const std::int64_t one = (std::int64_t{1} << profile.color_bits) - 1;
    const Rect all{0, 0, size, size};
    Workbench bench(profile, size, size);
    for (const BlendFactor src : sources)
        for (const BlendFactor dst : destinations) {
            bench.state.blend = {};
            bench.run(WritePixels{all, Plane::Color, operands.stored, {}, 0});
            bench.state.blend = {true, src, dst};
            bench.run(WritePixels{all, Plane::Color, operands.source, {}, 0});
            for (std::size_t i = 0; i < operands.source.size(); ++i)
                ASSERT_EQ(bench.planes().color[i],
                          expected(bench.state.blend, operands.source[i], operands.stored[i], one))
                    << "factors " << int(src) << " " << int(dst) << ", pixel " << i;
        }
}

TEST(ExhaustiveBlend, All256x256OperandsOfEachPairOfFactors) {
    // Red has every pair of colours, alpha every pair of alphas, green and blue have mixed pairs.
    Operands o;
    for (int stored = 0; stored < 256; ++stored)
        for (int source = 0; source < 256; ++source) {
            const auto s = std::uint16_t(source), d = std::uint16_t(stored);
            o.source.push_back({s, s, std::uint16_t(255 - s), s});
            o.stored.push_back({d, std::uint16_t(d ^ 0x5A), std::uint16_t((d * 37) & 255), d});
        }
    check_all_pairs(vgx(), 256, o);
    for (std::size_t i = 0; i < o.source.size(); ++i) {  // alphas independent of the colours
        o.source[i][3] = std::uint16_t((i * 89) & 255);
        o.stored[i][3] = std::uint16_t((i / 256 * 151 + i) & 255);
    }
    check_all_pairs(vgx(), 256, o);
}

TEST(ExhaustiveBlend, SamplesOf10And12And16Bits) {
    for (const int bits : {10, 12, 16}) {
        Profile profile = ideal();
        profile.color_bits = profile.lit_bits = bits;
        Random random(7);
        Operands o;
        const std::int64_t one = (1 << bits) - 1;
        const auto value = [&] {
            return std::uint16_t(random.one_in(4) ? (random.one_in(2) ? one : 0)
                                                  : random.between(0, one));
        };
        for (int i = 0; i < 128 * 128; ++i) {
            o.source.push_back({value(), value(), value(), value()});
            o.stored.push_back({value(), value(), value(), value()});
        }
        check_all_pairs(profile, 128, o);
    }
}

// [R12.12]
TEST(ExhaustiveBlend, AFactorOfTheWrongSideIsRefused) {
    Workbench bench;
    bench.state.blend = {true, BlendFactor::SrcColor, BlendFactor::One};
    EXPECT_EQ(error_of([&] { bench.clear(); }),
              "command 0 (SetState): blend.src = SrcColor; expected a source factor");
    bench.state.blend = {true, BlendFactor::One, BlendFactor::SrcAlphaSaturate};
    EXPECT_EQ(error_of([&] { bench.clear(); }),
              "command 0 (SetState): blend.dst = SrcAlphaSaturate; expected a destination factor");
}

}  // namespace
}  // namespace gw
