// What a draw puts at the vertices of its geometry set: colours and fog, texture coordinates. Each
// is shared by the draws that agree in what it depends on. Does not interpolate.
#pragma once

#include "gw/fast/vertices/geometry.h"

#include <memory>
#include <vector>

namespace gw::fast {

/// What lit colours depend on beyond their geometry set.
struct ColorKey {
    const GeometrySet* set = nullptr;
    Material material;
    LightsRef lights;  ///< compared by what they are, not by where
    ColorSource color_source = ColorSource::Vertex;
    LightingState lighting;
    bool operator==(const ColorKey& other) const;
};
ColorKey color_key(const GeometrySet& set, const State& state, const Draw& draw);

/// By vertex of the set; what a draw has no use for is empty.
struct VertexColors {
    ColorKey key;
    std::vector<Rgba> front, back;
    /// one colour everywhere: no light, or only ambient light as strong everywhere
    bool uniform = false;
    void clear() { key = {}, front.clear(), back.clear(), uniform = false; }
};

/// What fog depends on: all of its state but the colour.
struct FogKey {
    const GeometrySet* set = nullptr;
    FogState fog;
    bool operator==(const FogKey&) const = default;
};
FogKey fog_key(const GeometrySet& set, const State& state);

struct VertexFog {
    FogKey key;
    /// the factor, or where it is found per fragment the table's coordinate
    std::vector<double> value;
    void clear() { key = {}, value.clear(); }
};

/// What texture coordinates depend on.
struct TexcoordKey {
    const GeometrySet* set = nullptr;
    TexGen gen = TexGen::None;
    double eta = 1;
    dmat4 eye_linear{1};
    bool operator==(const TexcoordKey&) const = default;
};
TexcoordKey texcoord_key(const GeometrySet& set, const State& state);

struct VertexTexcoords {
    TexcoordKey key;
    std::vector<dvec4> strq;
    void clear() { key = {}, strq.clear(); }
};

/// Each fills what has its key.
void shade_vertices(VertexColors& colors, const State& state, const Draw& draw,
                    const Profile& profile);
void fog_vertices(VertexFog& fog, const State& state, const Draw& draw, const Profile& profile);
void texture_vertices(VertexTexcoords& texcoords, const State& state, const Draw& draw,
                      const Profile& profile);

}  // namespace gw::fast
