// docs/manual/fragments.md: the worked examples. tests/gw/exhaustive has every case of the tables.
#include "gw/base/arithmetic.h"
#include "gw/describe/opengl.h"
#include "gw/stages/tables.h"
#include "test_paths.h"
#include "tests/gw/workbench.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <map>

namespace gw {
namespace {

using test::Workbench;
const Rect pixel{0, 0, 1, 1};

// [R12.13]
TEST(ManualFragments, TheColourMask) {
    Workbench bench(vgx(), 1, 1);
    bench.write(pixel, {1, 2, 3, 4});
    bench.state.color_mask = {true, false, true, false};
    bench.write(pixel, {10, 0, 0, 0});
    EXPECT_EQ(bench.color(0, 0), (Rgba{10, 2, 0, 4}));
}

// [R12.19] The worked example.
TEST(ManualFragments, SomeBitsOfAChannel) {
    Workbench bench(vgx(), 1, 1);
    bench.write(pixel, {15, 200, 7, 9});
    bench.state.color_mask_bits = {.r = 0xF0, .g = 0x0F, .a = 0};
    bench.state.blend = {true, BlendFactor::One, BlendFactor::One};
    bench.write(pixel, {170, 85, 51, 0});
    EXPECT_EQ(bench.color(0, 0), (Rgba{191, 207, 58, 9}));
}

// [R12.19] Clears, copies and returns write the same bits, to both planes.
TEST(ManualFragments, EveryCommandWritesThroughTheBits) {
    const auto after = [](const auto& command) {
        Profile two = vgx();
        two.color_planes = 2;
        Workbench bench(two, 2, 1);
        bench.state.draw_buffer = DrawBuffer::FrontAndBack;
        bench.write({0, 0, 1, 1}, {0x5A, 0x5A, 0x5A, 0x5A});
        bench.write({1, 0, 1, 1}, {0xC3, 0xC3, 0xC3, 0xC3});
        bench.run(Accumulate{AccumOp::Load, 1});
        bench.state.color_mask_bits = {.r = 0x0F, .g = 0xF0, .b = 0};
        bench.state.color_mask.a = false;
        bench.run(command);
        EXPECT_EQ(bench.back(0, 0), bench.color(0, 0));
        return bench.color(0, 0);
    };
    EXPECT_EQ(after(Clear{mask_of(Plane::Color), vec4(1)}), (Rgba{0x5F, 0xFA, 0x5A, 0x5A}));
    EXPECT_EQ(after(Copy{.plane = Plane::Color, .source = {1, 0, 1, 1}}),
              (Rgba{0x53, 0xCA, 0x5A, 0x5A}));
    EXPECT_EQ(after(Accumulate{AccumOp::Return, 2}), (Rgba{0x54, 0xBA, 0x5A, 0x5A}));  // 0xB4
}

// [R12.19] [R14.8] Bits that are not written are read, unless the plane has no such bits.
TEST(ManualFragments, BitsAboveThePlaneHaveNoEffect) {
    Workbench bench(vgx(), 1, 1);
    const auto bytes = [&](const ColorMaskBits& bits) {
        bench.state.color_mask_bits = bits;
        bench.take_counters();
        bench.write(pixel, {1, 1, 1, 1});
        return bench.take_counters().bytes;
    };
    EXPECT_EQ(bytes({0xFF, 0xFF, 0xFF, 0xFF}), 4u);
    EXPECT_EQ(bytes({0xFF, 0xFF, 0xFF, 0x7F}), 8u);
    EXPECT_EQ(bytes({0xFF00, 0xFF00, 0xFF00, 0xFF00}), 0u);
}

// [R12.5] [R12.6] [R12.7]
TEST(ManualFragments, StencilByHand) {
    Workbench bench(vgx(), 1, 1);
    const auto after = [&](const StencilState& state) {
        bench.state.stencil = {};
        bench.clear(mask_of(Plane::Stencil), vec4(0), 1, 5);
        bench.state.stencil = state;
        bench.write(pixel, {});
        return bench.stencil(0, 0);
    };
    EXPECT_EQ(after({.test = true,
                     .func = StencilFunc::Equal,
                     .ref = 3,
                     .mask = 1,
                     .zpass = StencilOp::Invert,
                     .write_mask = 0x0F}),
              10);
    EXPECT_EQ(after({.test = true,
                     .func = StencilFunc::Less,
                     .ref = 3,
                     .fail = StencilOp::Zero,
                     .zpass = StencilOp::Incr}),
              6);
    EXPECT_EQ(after({.test = true,
                     .func = StencilFunc::Greater,
                     .ref = 3,
                     .fail = StencilOp::Zero,
                     .zpass = StencilOp::Incr}),
              0);
    EXPECT_EQ(after({.test = false, .func = StencilFunc::Never, .fail = StencilOp::Zero}), 5);
}

// [R12.1]
TEST(ManualFragments, TestsInTheirOrder) {
    // A fragment that fails the alpha test changes no stencil value; one that fails the stencil
    // test changes no depth.
    Workbench bench(vgx(), 1, 1);
    bench.clear(all_planes, vec4(0), 1, 5);
    bench.take_counters();
    bench.state.alpha = {true, AlphaFunc::Greater, 0.5f};
    bench.state.stencil = {.test = true,
                           .func = StencilFunc::Never,
                           .fail = StencilOp::Incr,
                           .zpass = StencilOp::Zero};
    bench.state.depth.test = true;
    bench.write(pixel, {1, 1, 1, 128}, 7);  // 128 > 128 fails
    EXPECT_EQ(bench.stencil(0, 0), 5);
    bench.write(pixel, {1, 1, 1, 129}, 7);
    EXPECT_EQ(bench.stencil(0, 0), 6);
    EXPECT_EQ(bench.depth(0, 0), 16777215u);
    const Counters c = bench.take_counters();
    EXPECT_EQ(c.fragments, 2u);
    EXPECT_EQ(c.alpha_killed, 1u);
    EXPECT_EQ(c.stencil_killed, 1u);
}

/// A formula of the page: names, numbers, + and -, min(a, b) and max(a, b).
class Formula {
public:
    using Values = std::map<std::string, int, std::less<>>;
    static int value(std::string_view text, const Values& values) {
        Formula formula{text, values};
        const int v = formula.sum();
        if (!formula.rest_.empty()) ADD_FAILURE() << "no formula: " << text;
        return v;
    }

private:
    Formula(std::string_view text, const Values& values) : rest_(text), values_(values) {}
    bool take(char c) {
        while (rest_.starts_with(' ')) rest_.remove_prefix(1);
        if (!rest_.starts_with(c)) return false;
        rest_.remove_prefix(1);
        return true;
    }
    int sum() {
        int v = operand();
        while (true) {
            if (take('+'))
                v += operand();
            else if (take('-'))
                v -= operand();
            else
                return v;
        }
    }
    int operand() {
        take(' ');
        const auto end = std::ranges::find_if_not(
            rest_, [](unsigned char c) { return std::isalnum(c) || c == '\''; });
        const std::string word(rest_.begin(), end);
        rest_.remove_prefix(word.size());
        if (take('(')) {
            const int a = sum();
            take(',');
            const int b = sum();
            take(')');
            return word == "min" ? std::min(a, b) : std::max(a, b);
        }
        const auto named = values_.find(word);
        return named != values_.end() ? named->second : std::stoi(word);
    }

    std::string_view rest_;
    const Values& values_;
};

/// "| Subtract | `max(0, s' - d')` | blend_subtract |", a row of the table of equations.
struct EquationRow {
    std::string name, formula, extension;
};

std::vector<EquationRow> equations_of_page() {
    std::ifstream page(GW_SOURCE_DIR "/docs/manual/fragments.md");
    std::vector<EquationRow> rows;
    bool inside = false;
    for (std::string line; std::getline(page, line);) {
        if (line.starts_with("| equation |")) inside = true;
        if (line.empty()) inside = false;
        const std::size_t start = line.find(" | `"), end = line.rfind("` |");
        if (!inside || start == line.npos) continue;
        rows.push_back({line.substr(2, start - 2), line.substr(start + 4, end - start - 4),
                        line.size() > end + 6 ? line.substr(end + 4, line.size() - end - 6) : ""});
    }
    return rows;
}

std::string extension_of(BlendEquation equation) {
    for (const ExtensionName& extension : extension_names())
        if (extension.member == opengl_word(equation).extension) return extension.name;
    return "";
}

// [R12.11] [R12.14]
TEST(ManualFragments, EveryEquationIsThatOfItsRow) {
    const auto rows = equations_of_page();
    ASSERT_EQ(rows.size(), count_of<BlendEquation>);
    BlendState state{true, BlendFactor::ConstantAlpha, BlendFactor::OneMinusConstantAlpha};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto& [name, formula, extension] = rows[i];
        state.equation = static_cast<BlendEquation>(i);
        ASSERT_EQ(name, enumerator(state.equation));
        EXPECT_EQ(extension, extension_of(state.equation)) << name;
        for (std::uint16_t s = 0; s < 256; ++s)
            for (std::uint16_t d = 0; d < 256; ++d) {
                const int s_part = int(mul(s, 200u, 8)), d_part = int(mul(d, 55u, 8));
                const Formula::Values values{
                    {"one", 255}, {"s", s}, {"d", d}, {"s'", s_part}, {"d'", d_part}};
                ASSERT_EQ(blend(state, {{s}, {d}, {0, 0, 0, 200}}, 8)[0],
                          Formula::value(formula, values))
                    << name << " of " << s << " and " << d;
            }
    }
}

// [R12.14] [R12.15]
TEST(ManualFragments, JoinedColoursByHand) {
    Workbench bench(opengl(), 1, 1);
    const auto joined = [&](const BlendState& blend, const LogicOpState& logic) {
        bench.state.blend = {};
        bench.state.logic_op = {};
        bench.write(pixel, {100, 100, 100, 100});
        bench.state.blend = blend;
        bench.state.logic_op = logic;
        bench.write(pixel, {200, 200, 200, 200});
        return bench.color(0, 0)[0];
    };
    const auto blended = [&](BlendEquation equation) {
        return joined({true, BlendFactor::One, BlendFactor::One, equation}, {});
    };
    EXPECT_EQ(blended(BlendEquation::Subtract), 100);
    EXPECT_EQ(blended(BlendEquation::ReverseSubtract), 0);
    EXPECT_EQ(blended(BlendEquation::Min), 100);
    EXPECT_EQ(blended(BlendEquation::Max), 200);
    const auto logic = [&](LogicOp op) { return joined({true}, {true, op}); };
    EXPECT_EQ(logic(LogicOp::And), 64);
    EXPECT_EQ(logic(LogicOp::AndReverse), 136);
    EXPECT_EQ(logic(LogicOp::Xor), 172);
    EXPECT_EQ(logic(LogicOp::Nor), 19);
    EXPECT_EQ(logic(LogicOp::Invert), 155);
    EXPECT_EQ(logic(LogicOp::Copy), 200);
    EXPECT_EQ(logic(LogicOp::Noop), 100);
    EXPECT_EQ(logic(LogicOp::Set), 255);
}

// [R12.17] [R12.18]
TEST(ManualFragments, AlphaIsBlendedByItsOwnFactors) {
    Workbench bench(opengl(), 1, 1);
    const auto blended = [&](const BlendState& blend) {
        bench.state.blend = {};
        bench.write(pixel, {100, 100, 100, 255});
        bench.state.blend = blend;
        bench.write(pixel, {200, 100, 50, 128});
        return bench.color(0, 0);
    };
    BlendState blend{true, BlendFactor::SrcAlpha, BlendFactor::OneMinusSrcAlpha};
    blend.alpha = {false, BlendFactor::DstAlpha, BlendFactor::One, BlendEquation::ReverseSubtract};
    EXPECT_EQ(blended(blend), (Rgba{150, 100, 75, 191}));
    blend.alpha.separate = true;
    EXPECT_EQ(blended(blend), (Rgba{150, 100, 75, 127}));
    blend.src = BlendFactor::SrcColor;
    blend.dst = BlendFactor::DstColor;
    EXPECT_EQ(blended(blend), (Rgba{196, 78, 49, 127}));  // 156.86 + 39.22, 78.43, 9.80 + 39.22
    blend.alpha = {true, BlendFactor::One, BlendFactor::SrcAlphaSaturate};
    EXPECT_THROW(blended(blend), Error);
}

// [R12.17] [R12.18]
TEST(ManualFragments, SeparateAndSquareBlendsAreExtensions) {
    const auto refusal_of = [](bool Extensions::*missing, const BlendState& blend) {
        Profile profile = opengl();
        profile.extensions.*missing = false;
        Workbench bench(profile, 1, 1);
        bench.state.blend = blend;
        return test::error_of([&] { bench.write(pixel, {}); });
    };
    BlendState blend{true, BlendFactor::One, BlendFactor::One};
    blend.alpha.separate = true;
    EXPECT_EQ(refusal_of(&Extensions::blend_separate, blend),
              "command 0 (SetState): extension blend_separate is not in profile opengl");
    EXPECT_EQ(refusal_of(&Extensions::blend_square, blend), "");
    blend.alpha.equation = BlendEquation::Min;
    EXPECT_EQ(refusal_of(&Extensions::blend_minmax, blend),
              "command 0 (SetState): extension blend_minmax is not in profile opengl");
    blend.alpha.dst = BlendFactor::DstColor;
    EXPECT_EQ(refusal_of(&Extensions::blend_square, blend),
              "command 0 (SetState): blend.alpha.dst = DstColor; expected a destination factor");
    blend.alpha.separate = false;
    blend.alpha.dst = BlendFactor::Zero;
    EXPECT_EQ(refusal_of(&Extensions::blend_minmax, blend), "");
}

// [R12.12]
TEST(ManualFragments, AConstantColour) {
    Workbench bench(opengl(), 1, 1);
    bench.write(pixel, {100, 100, 100, 255});
    bench.state.blend = {.enable = true,
                         .src = BlendFactor::ConstantColor,
                         .dst = BlendFactor::OneMinusConstantAlpha,
                         .color = {1, 0.5f, 0, 0.25f}};
    bench.write(pixel, {200, 200, 200, 255});
    // k = (255, 128, 0, 64): mul(100, 191) = 75 (74.90) more than mul(200, k)
    EXPECT_EQ(bench.color(0, 0), (Rgba{255, 175, 75, 255}));
}

// [R12.10] [R12.11] [R12.12]
TEST(ManualFragments, BlendByHand) {
    Workbench bench(vgx(), 1, 1);
    const auto over = [&](BlendFactor src, BlendFactor dst) {
        bench.state.blend = {};
        bench.write(pixel, {100, 100, 100, 255});
        bench.state.blend = {true, src, dst};
        bench.write(pixel, {200, 100, 50, 128});
        return bench.color(0, 0);
    };
    EXPECT_EQ(over(BlendFactor::SrcAlpha, BlendFactor::OneMinusSrcAlpha),
              (Rgba{150, 100, 75, 191}));
    EXPECT_EQ(over(BlendFactor::One, BlendFactor::One), (Rgba{255, 200, 150, 255}));
    EXPECT_EQ(over(BlendFactor::DstColor, BlendFactor::Zero),
              (Rgba{78, 39, 20, 128}));  // 78.43, 39.22, 19.61
    EXPECT_EQ(over(BlendFactor::Zero, BlendFactor::SrcColor), (Rgba{78, 39, 20, 128}));
    EXPECT_EQ(over(BlendFactor::SrcAlphaSaturate, BlendFactor::One),
              (Rgba{100, 100, 100, 255}));  // min(128, 0)
}

TEST(ManualFragments, TheAlphaTestDecidesAlsoWhereNoColorIsWritten) {
    Workbench bench;
    bench.clear();
    bench.state.alpha = {.test = true, .func = AlphaFunc::Greater, .ref = 0.5f};
    bench.state.color_mask = {false, false, false, false};
    bench.state.depth = {.test = true, .func = DepthFunc::Less};
    bench.draw(
        Primitive::Quads,
        {{0, 0, 9}, {8, 0, 9}, {8, 8, 9}, {0, 8, 9}, {8, 0, 9}, {16, 0, 9}, {16, 8, 9}, {8, 8, 9}},
        {vec4(1), vec4(1), vec4(1), vec4(1), vec4(0), vec4(0), vec4(0), vec4(0)});
    EXPECT_EQ(bench.depth(7, 7), 9u);
    EXPECT_EQ(bench.depth(8, 7), 0xFFFFFFu);
    EXPECT_EQ(bench.color(7, 7), (Rgba{}));
    const Counters c = bench.take_counters();
    EXPECT_EQ(c.alpha_killed, 64u);
    EXPECT_EQ(c.written, 64u);
}

}  // namespace
}  // namespace gw
