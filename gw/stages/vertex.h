// The vertex stages: transform, lighting, texture coordinates and fog at one vertex, in double and
// in the order of operations written here. docs/manual/geometry.md, "Vertices". Does not clip,
// divide or snap, and does not call libm.
#pragma once

#include "gw/base/types.h"
#include "gw/command_list.h"
#include "gw/profile.h"

#include <array>
#include <cmath>

namespace gw {

/// The part of a vertex that clipping depends on.
struct ClipPosition {
    dvec4 clip{0};                                   ///< clip coordinates
    std::array<double, max_clip_planes> distance{};  ///< to the user clip planes that are enabled
};

/// A vertex after the vertex stages, before clipping.
struct Vertex : ClipPosition {
    dvec4 texcoord{0, 0, 0, 1};  ///< s, t, r, q
    /// of units 1 to 3
    std::array<dvec4, max_texture_units - 1> more_texcoords;

    const dvec4& texcoord_of(std::size_t unit) const {
        return unit == 0 ? texcoord : more_texcoords[unit - 1];
    }
    std::array<double, 4> color{};       ///< integers 0 .. 2^color_bits - 1
    std::array<double, 4> back_color{};  ///< of a back face, with lighting.two_side
    std::array<double, 4> secondary{}, back_secondary{};  ///< likewise; the last is 0
    /// fog at the vertex: factor 0 .. 2^color_bits - 1; else coordinate, 1 at the table's end
    double fog = 0;
};

/// Texture coordinates and the fog distance are clamped to 2^200, so that no later sum or product
/// overflows.
inline constexpr double largest_coordinate = 0x1p200;

/// The inputs of the vertex stages that are the same for all vertices of a draw.
struct VertexProgram {
    const State* state = nullptr;
    const Draw* draw = nullptr;
    const Profile* profile = nullptr;
    dmat4 clip_from_object{1};
    dmat3 normal_eye_from_object{1};  ///< inverse transpose up to a positive factor
    double normal_scale = 1;          ///< the factor of normals; 0: they are normalised
    bool fragment_fog = false;
    double fog_depth = 1;          ///< the distance that is 1 in fog per fragment
    bool is_affine = true;         ///< all positions have w = 1 in object space and in eye space
    bool has_one_material = true;  ///< on each side, for all vertices
};

VertexProgram vertex_program(const State& state, const Draw& draw, const Profile& profile);
/// Makes a program that of another draw under the same state and transform.
void change_draw(VertexProgram& program, const Draw& draw);

/// Runs the vertex stages on vertex `index` of the draw's mesh.
Vertex run_vertex(const VertexProgram& program, std::uint32_t index);

/// Vertex::fog of vertex `index`, which is at this z in eye space.
double fog_of(const VertexProgram& program, std::uint32_t index, double z_eye);

/// The values of a vertex: the mesh's, or the draw's current ones. Colours are not yet rounded.
vec4 given_color(const Draw& draw, std::uint32_t index);
dvec3 given_normal(const Draw& draw, std::uint32_t index);
/// s, t, r, q of a texture unit.
dvec4 given_texcoord(const Draw& draw, std::uint32_t index, std::size_t unit = 0);
vec3 given_secondary_color(const Draw& draw, std::uint32_t index);
double given_fog_coordinate(const Draw& draw, std::uint32_t index);

/// The material of one side of a vertex.
Material material_of(const VertexProgram& program, std::uint32_t index, Face side);
/// Whether a side's material follows the vertex colours.
constexpr bool follows_color(const ColorMaterialState& state, Face side) {
    return state.enable && (state.face == Face::FrontAndBack || state.face == side);
}
/// Sets the parameters that follow a vertex colour.
void follow_color(ColorMaterial mode, const vec4& color, Material& material);

/// Whether two draws give the same values to vertices for which their mesh has none.
bool same_current(const Draw& a, const Draw& b);

/// Whether the draw's texture has one dimension: its t is 0.
inline bool is_one_dimensional(const Draw& draw, std::size_t unit = 0) {
    const TextureBinding& map = map_of(draw, unit);
    return map.texture && map.texture->dimensions == 1;
}

/// A vertex's position in object space.
inline dvec4 object_position(const MeshData& mesh, std::uint32_t index) {
    return {dvec3(mesh.positions[index]), mesh.w.empty() ? 1.0 : double(mesh.w[index])};
}
/// The point of homogeneous eye coordinates; of w = 0 their direction.
inline dvec3 eye_point(const dvec4& p) {
    return p.w == 0 ? dvec3(p) : dvec3(p.x / p.w, p.y / p.w, p.z / p.w);
}

/// m * v, each component ((m0 x + m1 y) + (m2 z + m3 w)).
inline dvec4 transform(const dmat4& m, const dvec4& v) {
    dvec4 out;
    for (int i = 0; i < 4; ++i)
        out[i] = (m[0][i] * v.x + m[1][i] * v.y) + (m[2][i] * v.z + m[3][i] * v.w);
    return out;
}
/// The product a b: its columns are transform(a, column of b).
dmat4 product(const dmat4& a, const dmat4& b);
/// v / |v|; 0 for the zero vector.
inline dvec3 normalized(const dvec3& v) {
    const double size = length(v);
    return size > 0 ? dvec3(v.x / size, v.y / size, v.z / size) : dvec3(0);
}

}  // namespace gw
