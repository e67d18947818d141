// Values at the vertices of a geometry set: colours, fog, texture coordinates. Draws whose key is
// equal share them. Does not interpolate.
#pragma once

#include "gw/fast/vertices/geometry.h"
#include "gw/material.h"

#include <vector>

namespace gw::fast {

/// Everything that lit colours depend on.
struct ColorKey {
    const GeometrySet* set = nullptr;
    Material material;
    LightsRef lights;  ///< compared by value, not by address
    ColorSource color_source = ColorSource::Vertex;
    LightingState lighting;
    bool operator==(const ColorKey& other) const;
};
ColorKey color_key(const GeometrySet& set, const State& state, const Draw& draw);

/// By vertex of the set; a list that no draw needs is empty.
struct VertexColors {
    ColorKey key;
    std::vector<Rgba> front, back;
    /// one colour everywhere: no light, or only ambient light as strong everywhere
    bool uniform = false;
    void clear() {
        key = {};
        front.clear();
        back.clear();
        uniform = false;
    }
};

/// Everything that fog depends on: its state but for the colour.
struct FogKey {
    const GeometrySet* set = nullptr;
    FogState fog;
    bool operator==(const FogKey&) const = default;
};
FogKey fog_key(const GeometrySet& set, const State& state);

struct VertexFog {
    FogKey key;
    /// the factor; with fog per fragment, the coordinate in the fog table
    std::vector<double> value;
    void clear() {
        key = {};
        value.clear();
    }
};

/// Everything that texture coordinates depend on.
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
    void clear() {
        key = {};
        strq.clear();
    }
};

/// Each fills an object that has its key.
void shade_vertices(VertexColors& colors, const State& state, const Draw& draw,
                    const Profile& profile);
void fog_vertices(VertexFog& fog, const State& state, const Draw& draw, const Profile& profile);
void texture_vertices(VertexTexcoords& texcoords, const State& state, const Draw& draw,
                      const Profile& profile);

}  // namespace gw::fast
