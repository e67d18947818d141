// docs/manual/state.md: its tables of fields are those of gw/describe/state_fields.h, and these are
// all members.
#include "gw/describe/enumerators.h"
#include "gw/describe/opengl.h"
#include "gw/describe/state_fields.h"
#include "test_paths.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace gw {
namespace {

// ---- A field as the page writes it --------------------------------------------------------------

template <class T>
std::string type_words() {
    if constexpr (std::is_enum_v<T>) return std::string(type_name<T>);
    if constexpr (std::is_same_v<T, bool>) return "bool";
    if constexpr (std::is_same_v<T, int>) return "int";
    if constexpr (std::is_same_v<T, std::uint16_t>) return "uint16";
    if constexpr (std::is_same_v<T, std::uint32_t>) return "uint32";
    if constexpr (std::is_same_v<T, float>) return "float32";
    if constexpr (std::is_same_v<T, double>) return "double";
    if constexpr (std::is_same_v<T, vec4>) return "4 of float32";
    if constexpr (std::is_same_v<T, dvec4>) return "4 of double";
    if constexpr (std::is_same_v<T, dmat4>) return "matrix of double";
    if constexpr (std::is_same_v<T, Rect>) return "x, y, width, height: int";
    if constexpr (std::is_same_v<T, PolygonStippleState>) return "none, or 32 rows of uint32";
    if constexpr (std::is_same_v<T, MoreTextures>) return "none, or 3 of the fields of `texture`";
    return "";
}

template <class T>
constexpr bool is_of_numbers = std::is_floating_point_v<T> || std::is_same_v<T, vec4> ||
                               std::is_same_v<T, dvec4> || std::is_same_v<T, dmat4>;

template <class T>
std::string range_words(const Bounds& b) {
    if (b.check == Bounds::Check::Range) return fmt::format("{} .. {}", b.least, b.most);
    if (b.words[0] != 0) return b.words;
    return is_of_numbers<T> ? "finite" : "";
}

std::string value_words(bool v) { return v ? "true" : "false"; }
std::string value_words(int v) { return std::to_string(v); }
std::string value_words(double v) { return fmt::format("{}", v); }
template <class T>
requires std::unsigned_integral<T> std::string value_words(T v) {
    EXPECT_EQ(v, std::numeric_limits<T>::max());
    return fmt::format("2^{} - 1", 8 * sizeof(T));
}
template <class T>
requires std::is_enum_v<T> std::string value_words(T v) { return std::string(enumerator(v)); }
std::string value_words(const auto& v) requires requires { v.w; }
{ return fmt::format("{}, {}, {}, {}", v.x, v.y, v.z, v.w); }
std::string value_words(const Rect& r) {
    return fmt::format("{}, {}, {}, {}", r.x, r.y, r.width, r.height);
}
std::string value_words(const dmat4& m) { return m == dmat4(1) ? "identity" : "?"; }
std::string value_words(const PolygonStippleState& s) { return s.pattern ? "?" : "none"; }

std::string value_words(const MoreTextures& m) { return m.units ? "?" : "none"; }

/// "clip_planes[0 .. 5].enable" for "clip_planes.0.enable"; "" for other elements.
std::string name_words(const std::string& path) {
    static const std::regex other(R"(.*\.[1-9]\..*)");
    if (std::regex_match(path, other)) return "";
    const bool planes = path.starts_with("clip_planes");
    return std::regex_replace(path, std::regex(R"(\.0\.)"), planes ? "[0 .. 5]." : "[0 .. 3].");
}

std::vector<std::string> rows_of_fields() {
    std::vector<std::string> rows;
    for_each_value(State{}, [&]<Plain T>(const Path& path, const T& value, const auto& field) {
        const std::string name = name_words(path.str()), range = range_words<T>(field.bounds);
        if (!name.empty())
            rows.push_back(fmt::format("| `{}` | {} |{} | {} | {} |", name, type_words<T>(),
                                       range.empty() ? "" : " " + range, value_words(value),
                                       field.rules));
    });
    return rows;
}

std::vector<std::string> rows_of_page() {
    std::ifstream page(GW_SOURCE_DIR "/docs/manual/state.md");
    std::vector<std::string> rows;
    bool inside = false;
    for (std::string line; std::getline(page, line);) {
        if (line.starts_with("| field | type |")) inside = true;
        if (line.empty()) inside = false;
        if (inside && line.starts_with("| `")) rows.push_back(line);
    }
    return rows;
}

// [R4.1] [R4.2]
TEST(ManualState, HasEveryFieldInItsTables) {
    const std::vector<std::string> fields = rows_of_fields(), page = rows_of_page();
    for (std::size_t i = 0; i < fields.size(); ++i)
        ASSERT_EQ(i < page.size() ? page[i] : "no row", fields[i]) << "expected row " << i;
    EXPECT_EQ(page.size(), fields.size());
}

// ---- The tables against the structs -------------------------------------------------------------

/// Stands for a member of any type.
struct AnyMember {
    template <class T>
    operator T() const;
};
/// Whether an aggregate takes that many members.
template <class Struct, std::size_t... i>
constexpr bool takes(std::index_sequence<i...>) {
    return requires { Struct{(static_cast<void>(i), AnyMember{})...}; };
}
template <class Struct, std::size_t count = 0>
constexpr std::size_t count_members() {
    if constexpr (takes<Struct>(std::make_index_sequence<count + 1>()))
        return count_members<Struct, count + 1>();
    else
        return count;
}

template <class Struct>
struct Tables {
    static void check() {
        EXPECT_EQ(std::tuple_size_v<decltype(fields_of<Struct>)>, count_members<Struct>())
            << type_name<Struct>;
        EXPECT_NE(sentence_of<Struct>[0], 0) << type_name<Struct>;
        for_each_field<Struct>([](const auto& field) {
            using Member = typename std::remove_cvref_t<decltype(field)>::Member;
            EXPECT_NE(field.sentence[0], 0) << type_name<Struct> << "." << field.name;
            Tables<Member>::check();
        });
    }
};
template <Plain Value>
struct Tables<Value> {
    static void check() {
        if constexpr (std::is_enum_v<Value>) {
            EXPECT_NE(sentence_of<Value>[0], 0) << type_name<Value>;
        }
    }
};
template <class Element, std::size_t size>
struct Tables<std::array<Element, size>> : Tables<Element> {};

TEST(StateFields, AreAllMembers) { Tables<State>::check(); }

TEST(StateFields, AreAtTheirMembers) {
    State state;
    std::set<const void*> places;
    for_each_value(state, [&](const Path& path, const Plain auto& value, const auto& field) {
        EXPECT_TRUE(places.insert(&value).second) << path.str() << ": the member of another field";
        EXPECT_NE(field.rules[0], 0) << path.str();
    });
}

TEST(Enumerators, HaveTheNamesOfTheSource) {
    EXPECT_EQ(enumerator(BlendFactor::OneMinusSrcAlpha), "OneMinusSrcAlpha");
    EXPECT_EQ(enumerator(TexGen::None), "None");
    EXPECT_EQ(enumerator(BlendFactor(200)), "");
    EXPECT_EQ(count_of<LogicOp>, 16u);
    EXPECT_EQ(last_of<Face>, Face::FrontAndBack);
    EXPECT_EQ(type_name<BlendState>, "BlendState");
    EXPECT_EQ(type_name<DepthFunc>, "CompareFunc");
}

/// OpenGL names logical operations by their bits, too (gw/state.h).
TEST(OpenglWords, LeadBackToTheEnumerator) {
    for (std::size_t i = 0; i < count_of<LogicOp>; ++i) {
        const auto op = static_cast<LogicOp>(i);
        EXPECT_EQ(opengl_word(op).number, 0x1500 + i);
        EXPECT_EQ(from_opengl<LogicOp>(opengl_word(op).number), op);
    }
    EXPECT_EQ(from_opengl<LogicOp>(0x1510), std::nullopt);
    EXPECT_FALSE(has_word(Extensions{}, BlendEquation::Max));
    EXPECT_TRUE(has_word(Extensions{.blend_minmax = true}, BlendEquation::Max));
    EXPECT_TRUE(has_word(Extensions{}, BlendEquation::Add));
}

}  // namespace
}  // namespace gw
