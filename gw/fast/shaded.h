// What a draw puts at the vertices of its geometry set: colours, texture coordinates, fog. Shared by draws
// that agree. Does not interpolate.
#pragma once

#include "gw/fast/geometry.h"

#include <memory>
#include <vector>

namespace gw::fast {

/// What shaded vertices depend on beyond their geometry set.
struct ShadeKey {
    const GeometrySet* set = nullptr;
    Material material;
    LightsRef lights;
    ColorSource color_source = ColorSource::Vertex;
    LightingState lighting;
    FogState fog;
    bool textured = false;
    TexGen gen = TexGen::None;
    double eta = 1;
    dmat4 eye_linear{1};
    bool operator==(const ShadeKey&) const = default;
};
ShadeKey shade_key(const GeometrySet& set, const State& state, const Draw& draw);

/// By vertex of the set; what a draw has no use for is empty.
struct ShadedVertices {
    ShadeKey key;
    std::vector<Rgba> front, back;
    std::vector<dvec4> texcoord;
    std::vector<double> fog;
};

std::unique_ptr<ShadedVertices> shade_vertices(const GeometrySet& set, const State& state, const Draw& draw,
                                               const Profile& profile);

}  // namespace gw::fast
