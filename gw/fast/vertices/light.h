// Colours of many vertices at once: the lighting equation and the rounding of given colours, in
// vectors of doubles. docs/manual.md, "Lighting"; scalar twins: gw/stages/lighting.cpp, operation
// by operation, and quantize_color(). Does not transform positions to the window.
#pragma once

#include "gw/stages/vertex.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gw::fast {

/// A light, and the terms that do not depend on the vertex.
struct PreparedLight {
    const Light* light;
    dvec3 position, spot_direction;
    bool directional = true, spot = false;
    // of the materials in use
    bool glossy = false;
    bool turns = false;  ///< its contribution depends on the normal
};

/// The terms of the lights of draws that live as long as it does.
class PreparedLights {
public:
    std::span<PreparedLight> of(const LightsRef& lights);

private:
    const std::vector<Light>* lights_ = nullptr;  ///< the last ones
    std::vector<PreparedLight> terms_;
};

/// Sets colors[index], for each of `indices`, to the colour that run_vertex gives the vertex's
/// front (or back). Precondition: lighting is on.
void light_vertices(const VertexProgram& program, PreparedLights& lights,
                    std::span<const std::uint32_t> indices, bool back, std::span<Rgba> colors);

/// Vertex colours before rounding.
struct GivenColors {
    const std::vector<vec4>& all;
    std::span<const std::uint32_t> indices;
    int bits;
};
/// Sets colors[index], for each of `indices`, to quantize_color() of its given colour.
void quantize_colors(const GivenColors& given, std::span<Rgba> colors);

}  // namespace gw::fast
