// Values at the vertices of a geometry set: colours, fog, texture coordinates. Draws with equal
// inputs share them. Does not interpolate.
#pragma once

#include "gw/fast/vertices/geometry.h"

#include <cstddef>
#include <vector>

namespace gw {
struct Draw;
}

namespace gw::fast {

/// The draws of a set's parts, and the state that they have in common.
struct VertexInputs {
    const GeometrySet* set = nullptr;
    const State* state = nullptr;
    const Draw* const* draws = nullptr;  ///< one for each part
};

/// By vertex of the set; a list that no draw needs is empty.
struct VertexColors {
    VertexInputs inputs;
    std::vector<Rgba> front, back;
    /// each primitive has one colour
    bool uniform = false;

    void clear() {
        front.clear();
        back.clear();
        uniform = false;
    }
    std::size_t bytes() const { return (front.capacity() + back.capacity()) * sizeof(Rgba); }
};
struct VertexFog {
    VertexInputs inputs;
    /// the factor; with fog per fragment, the coordinate in the fog table
    std::vector<double> value;

    void clear() { value.clear(); }
    std::size_t bytes() const { return value.capacity() * sizeof(double); }
};
struct VertexTexcoords {
    VertexInputs inputs;
    std::vector<dvec4> strq;

    void clear() { strq.clear(); }
    std::size_t bytes() const { return strq.capacity() * sizeof(dvec4); }
};

/// Whether two draws get the same values. Lights are compared by value.
bool same_colors(const VertexInputs& a, const VertexInputs& b);
bool same_fog(const VertexInputs& a, const VertexInputs& b);
bool same_texcoords(const VertexInputs& a, const VertexInputs& b);

/// Each fills an object that has its inputs.
void shade_vertices(VertexColors& colors, const Profile& profile);
void fog_vertices(VertexFog& fog, const Profile& profile);
void texture_vertices(VertexTexcoords& texcoords, const Profile& profile);

}  // namespace gw::fast
