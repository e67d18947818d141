// The draws of a geometry set's parts, as the planner passes them to the kernels. They have one
// resolved state and share vertex values and textures with other draws. Owns nothing and does not
// know tiles: gw/fast/plan/tile_draw.h does.
#pragma once

#include "gw/fast/frame/uniform.h"
#include "gw/stages/resolve.h"
#include "gw/stages/texels.h"

#include <array>
#include <cstdint>
#include <vector>

namespace gw {

struct Draw;

namespace fast {

struct GeometrySet;
struct PartGroup;
struct VertexColors;
struct VertexFog;
struct VertexTexcoords;
struct FastTexels;
struct TexelPairs;

/// A texture unit of a draw that has others than the first.
struct UnitOp {
    const FastTexels* texels = nullptr;  ///< null: off
    const VertexTexcoords* texcoords = nullptr;
    bool projective = false;
    const TexelPairs* pairs = nullptr;  ///< as DrawOp's
};
using UnitOps = std::array<UnitOp, max_texture_units>;

struct DrawOp {
    const Draw* const* draws;  ///< one for each part of `group`
    const Resolved& state;
    const PartGroup* group = nullptr;
    const GeometrySet* set = nullptr;            ///< the group's
    const VertexColors* colors = nullptr;        ///< null: no stage needs a colour
    const VertexFog* fog = nullptr;              ///< null: no fog
    const VertexTexcoords* texcoords = nullptr;  ///< null: untextured
    const FastTexels* texels = nullptr;          ///< null: untextured
    const TexelPairs* pairs = nullptr;           ///< of `texels`, if the filter is bilinear
    const UnitOps* units = nullptr;              ///< null: unit 0 only, by the members above
    int look_ups = 0;  ///< texels of a fragment, even if nothing reads the colour
    const std::vector<std::uint32_t>* fog_table = nullptr;
    bool needs_color = true;         ///< a plane or the alpha test reads it
    bool uniform_color = false;      ///< each primitive has one colour at all its vertices
    bool perspective_color = false;  ///< smooth, not uniform, and the profile divides colours
    bool projective = false;         ///< texture coordinates are divided by q
    bool wide_texcoords = false;     ///< of some primitives (R9.19)
    bool by_pixel = false;           ///< its texture is looked up pixel by pixel
    bool sums_colors = false;        ///< fragments add a secondary colour
    bool direct_fog = false;         ///< fog from a given coordinate: `fog_table` has no part in it
    int visible_record = -1;         ///< the record that it makes or uses; -1: none
    bool counts_by_pixel = false;    ///< its record counts each pixel's fragments
    FragmentBytes bytes;
};

/// Whether its fragments read or write the depth plane.
inline bool needs_depth(const DrawOp& op) {
    return op.state.state.depth.func != DepthFunc::Always || op.state.state.depth.mask;
}
/// The planes whose uniform blocks must be written back before it draws.
inline UniformPlanes touched_planes(const DrawOp& op) {
    return {op.state.writes_color, needs_depth(op)};
}
/// Whether a texture is looked up pixel by pixel, whatever its coordinates: the shadow comparison,
/// sizes and levels by rules of their own.
inline bool has_rare_lookup(const TextureState& s, const Texels& texels) {
    return s.shadow_compare || texels.any_size || texels.with_r || !is_plain_lookup(s);
}
/// Whether fragments have a secondary colour or a given fog coordinate.
inline bool has_rare_values(const DrawOp& op) { return op.sums_colors || op.direct_fog; }
inline bool textures_by_pixel(const DrawOp& op) { return op.by_pixel; }

}  // namespace fast
}  // namespace gw
