// Small values to and from the recording's schema: vectors, rectangles, enumerations. Every value
// of an enumeration that comes from a file is checked; numbers are not: gw's `validate` does.
#pragma once

#include "gw/command_list.h"
#include "gw/describe/enumerators.h"
#include "gw/error.h"
#include "gw/profile.h"
#include "gw/state.h"
#include "inspect/recording/calls.h"
#include "inspect/shown/color_map.h"
#include "recording_generated.h"

#include <fmt/format.h>

#include <string>
#include <type_traits>
#include <vector>

namespace gw::inspect {

inline gwt::Vec2 to_file(const vec2& v) { return {v.x, v.y}; }
inline gwt::Vec3 to_file(const vec3& v) { return {v.x, v.y, v.z}; }
inline gwt::Vec4 to_file(const vec4& v) { return {v.x, v.y, v.z, v.w}; }
inline gwt::DVec4 to_file(const dvec4& v) { return {v.x, v.y, v.z, v.w}; }
inline gwt::Rect to_file(const Rect& r) { return {r.x, r.y, r.width, r.height}; }
inline gwt::Rgba to_file(const Rgba& c) { return {c[0], c[1], c[2], c[3]}; }
inline gwt::Matrix to_file(const dmat4& m) {
    return {to_file(m[0]), to_file(m[1]), to_file(m[2]), to_file(m[3])};
}

inline vec2 from_file(const gwt::Vec2& v) { return {v.x(), v.y()}; }
inline vec3 from_file(const gwt::Vec3& v) { return {v.x(), v.y(), v.z()}; }
inline vec4 from_file(const gwt::Vec4& v) { return {v.x(), v.y(), v.z(), v.w()}; }
inline dvec4 from_file(const gwt::DVec4& v) { return {v.x(), v.y(), v.z(), v.w()}; }
inline Rect from_file(const gwt::Rect& r) { return {r.x(), r.y(), r.width(), r.height()}; }
inline Rgba from_file(const gwt::Rgba& c) { return {c.r(), c.g(), c.b(), c.a()}; }
inline Rect rect_from_file(const gwt::Rect* r) { return r ? from_file(*r) : Rect{}; }
inline dmat4 from_file(const gwt::Matrix& m) {
    return {from_file(m.column0()), from_file(m.column1()), from_file(m.column2()),
            from_file(m.column3())};
}

/// In place of a member's place in a table: there is none.
inline constexpr std::uint32_t no_place = 0xffffffff;

/// The enumerations of the schema are gw's, value by value.
template <typename File, typename Ours>
constexpr File file_enum(Ours value) {
    return static_cast<File>(value);
}

/// A byte of the file stands for all of our values.
template <typename Ours, typename File>
Ours our_enum(File value) {
    int last = int(last_of<Ours>);
    if constexpr (std::is_enum_v<File>) last = int(File::MAX);
    if (int(value) < 0 || int(value) > last)
        throw Error(
            fmt::format("the value {} of an enumeration; expected 0 to {}", int(value), last));
    return static_cast<Ours>(value);
}

/// None, or as many as further texture units.
template <typename Stored>
bool has_more(const Stored* stored, const char* what) {
    const std::size_t all = max_texture_units - 1, size = stored ? stored->size() : 0;
    if (size != 0 && size != all) throw Error(fmt::format("{} {}; expected {}", size, what, all));
    return size != 0;
}

/// All but its name.
Profile from_file(const gwt::Profile& profile);
/// A texture of given levels, of bytes or of 16-bit values. Throws Error for sizes that do not fit.
TextureRef given_texture(const gwt::Texture& t, const std::string& name,
                         const std::vector<std::uint8_t>& texels8,
                         const std::vector<std::uint16_t>& texels16);

/// The pipeline's state. A group at its initial value is not stored.
flatbuffers::Offset<gwt::State> to_file(flatbuffers::FlatBufferBuilder& out, const State& state);
/// Whether it has a member of version 2 that is not at its initial value.
bool needs_version_2(const State& state);
bool needs_version_2(const Profile& profile);
/// Throws Error for an unknown enumerator.
State from_file(const gwt::State& state);
inline MakeSurface from_file(const gwt::MakeSurface& c) {
    return {c.number(), {c.width(), c.height(), c.planes(), c.depth_bits(), c.samples()}};
}
inline UseSurface from_file(const gwt::UseSurface& c) { return {c.number()}; }
inline Blit from_file(const gwt::Blit& c) {
    return {
        c.from_surface(), c.planes(), rect_from_file(c.source()),     rect_from_file(c.target()),
        c.flip_x(),       c.flip_y(), our_enum<MagFilter>(c.filter())};
}

/// Of a list of commands. A table without runs is not stored.
flatbuffers::Offset<gwt::CallTable> to_file(flatbuffers::FlatBufferBuilder& out,
                                            const CallTable& table);
/// The memory that from_file needs.
std::uint64_t decoded_bytes(const gwt::CallTable& table);
/// Throws Error if it names what there is not.
CallTable from_file(const gwt::CallTable& table, std::size_t commands);

flatbuffers::Offset<gwt::ColorMap> to_file(flatbuffers::FlatBufferBuilder& out,
                                           const ColorMap& map);
/// Throws Error unless there are as many entries as indices.
ColorMap from_file(const gwt::ColorMap& map);

}  // namespace gw::inspect
