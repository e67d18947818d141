#include "conformance/groups.h"

#include "conformance/cases.h"

namespace gw::conformance {
namespace {

constexpr PlaneMask color = mask_of(Plane::Color), depth = mask_of(Plane::Depth),
                    stencil = mask_of(Plane::Stencil), accum = mask_of(Plane::Accum),
                    back = mask_of(Plane::Back);
using C = Counters;

}  // namespace

// clang-format off
// NOLINTNEXTLINE(readability-function-size): a table
const std::vector<Group>& all_groups() {
    static const std::vector<Group> all{
        {"profiles", "profiles of every bit width, with all state and commands", "R1.3 R2.8 R2.9 R2.10 R1.5 R9.10",
         profile_case, 14, color | depth | stencil | accum, {&C::written}},
        {"blocks", "a window of six blocks of 64 x 64 pixels", "R1.6 R14.10",
         blocks_case, 1},
        {"everything", "all state and all commands at once", "R1.8-R1.10 R4.1-R4.6 R5.1-R5.3",
         everything_case, 12, color | depth | stencil | accum, {&C::alpha_killed, &C::stencil_killed, &C::depth_killed, &C::texels, &C::clipped}},
        {"mesh", "primitives, indices, identifiers, sizes, absent arrays", "R6.1-R6.8 R5.3 R15.1",
         mesh_case, 6},
        {"gradient-ties", "gradients half-way between two integers", "R9.6 R9.8",
         ties_case, 6},
        {"raster", "triangles of every shape, culling, the fill rule", "R6.20-R6.24 R9.1 R9.2 R9.6 R9.8 R9.9 R9.11",
         raster_case, 8, color | depth, {&C::rejected, &C::degenerate, &C::culled, &C::drawn}},
        {"clip", "near, far, user planes and guard band; w of every size and sign", "R6.9 R6.10 R6.15-R6.19 R6.25 R6.26 R2.1-R2.5",
         clip_case, 24, color | depth, {&C::rejected, &C::clipped, &C::degenerate, &C::drawn}},
        {"cut-slivers", "polygons that the snap bends after a cut", "R6.25 R6.26",
         cut_slivers_case, 4},
        {"viewport", "viewports, scissors and depth ranges", "R4.3 R4.4 R6.20 R6.21",
         viewport_case, 6, color | depth, {&C::drawn, &C::fragments}},
        {"jitter", "the same geometry at many jitters", "R6.22",
         jitter_case, 4, color | depth | accum, {&C::drawn}},
        {"polygons", "concave polygons, and polygons that touch and cross themselves", "R7.1-R7.9 R6.3 R6.4",
         polygons_case, 16},
        {"polygon-modes", "outlines and corners of polygons", "R6.7 R14.3",
         polygon_mode_case, 6, color | depth, {&C::culled, &C::clipped}},
        {"identifiers", "identifiers bypass texture and fog", "R6.13 R6.5",
         identifier_case, 4, color, {&C::written}},
        {"lighting", "materials and lights, flat and smooth, two-sided", "R8.1-R8.8 R6.6 R6.11 R6.12 R5.5 R5.6 R3.1-R3.9",
         lighting_case, 14, color, {&C::vertices, &C::written}},
        {"extreme-lights", "lights and normals that overflow, underflow and vanish", "R8.1-R8.8 R2.5-R2.7",
         extreme_lights_case, 6},
        {"lines-and-points", "lines and points of every width", "R9.3-R9.5 R9.7 R14.4",
         lines_and_points_case, 8, color | depth, {&C::rejected, &C::clipped, &C::degenerate, &C::drawn}},
        {"offset", "polygon offset on slopes of every size", "R9.12",
         offset_case, 4},
        {"texture", "filters, wraps, environments, sizes", "R10.1 R10.6 R10.8-R10.15 R10.17 R9.13-R9.16 R9.18 R9.19 R5.2 R5.4 R6.14 R14.6",
         texture_case, 20, color, {&C::texels}},
        {"far-coordinates", "texture coordinates far from 0, spans beyond 1024 repeats", "R10.8 R10.9 R10.27 R9.17 R9.19",
         far_coordinates_case, 6},
        {"generated-texture", "sphere, refraction and projected maps, slots", "R10.1-R10.5 R10.16 R10.19 R9.17",
         generated_texture_case, 14, color, {&C::texels, &C::pixels}},
        {"texture-churn", "many textures and slots in turn", "",
         texture_churn_case, 0, color, {&C::texels, &C::pixels}},
        {"shadow", "depth slots compared with r", "R10.18 R10.19",
         shadow_case, 10, color | depth, {&C::texels, &C::pixels}},
        {"fog", "fog at the vertex and per fragment", "R11.1-R11.7 R3.6",
         fog_case, 14, color, {&C::written}},
        {"stencil", "every stencil function, operation and mask", "R12.1-R12.8",
         stencil_case, 8, color | depth | stencil, {&C::stencil_killed, &C::depth_killed}},
        {"depth", "every depth function and mask", "R12.9",
         depth_case, 6, color | depth, {&C::depth_killed, &C::written}},
        {"coincident", "faces drawn again by other primitives, under Equal", "R1.10",
         coincident_case, 4, color | depth, {&C::depth_killed, &C::written}},
        {"blend", "blend factors, colour masks, alpha test", "R12.4 R12.10-R12.13",
         blend_case, 8, color, {&C::alpha_killed, &C::written}},
        {"alpha-mask", "the alpha test while few or no channels are written", "",
         alpha_mask_case, 0, color | depth | stencil, {&C::alpha_killed, &C::written}},
        {"stipple", "stipples, polygon modes of both faces, offsets of outlines", "R6.30 R9.20 R9.21 R9.22",
         stipple_case, 12, color | depth, {&C::clipped, &C::depth_killed, &C::written}},
        {"antialiasing", "smooth points, lines and polygons", "R9.23-R9.30",
         antialiasing_case, 20, color | depth, {&C::clipped, &C::alpha_killed, &C::depth_killed, &C::texels, &C::written}},
        {"texture-formats", "texture formats, borders, given levels, one dimension", "R10.23 R10.24 R10.25 R10.26 R10.17",
         texture_formats_case, 16, color, {&C::texels, &C::written}},
        {"vertices", "positions of any w, materials by vertex, current values, texture coordinates by rule", "R5.9 R6.27-R6.29 R8.9 R8.10 R10.20-R10.22",
         vertices_case, 12, color | depth, {&C::rejected, &C::clipped, &C::texels, &C::written}},
        {"joined-colors", "logical operations, blend equations, a constant colour", "R12.14 R12.15",
         joined_colors_case, 8, color, {&C::alpha_killed, &C::written}},
        {"pixels", "clears, spans, rectangles, copies, read-backs, slots", "R13.1-R13.7 R12.2 R12.3",
         pixels_case, 10},
        {"pixels-and-copies", "clears, spans, rectangles, copies, read-backs, slots", "",
         pixels_case, 0, color | depth | stencil, {&C::alpha_killed, &C::stencil_killed, &C::depth_killed, &C::pixels}},
        {"drawn-pixels", "rectangles of pixels through all stages: zoom, bits, sources", "R13.10-R13.15",
         drawn_pixels_case, 12, color | depth | stencil, {&C::alpha_killed, &C::stencil_killed, &C::depth_killed, &C::texels, &C::pixels, &C::written}},
        {"accumulation", "accumulation with every weight", "R13.8 R13.9",
         accumulation_case, 6, color | accum, {&C::accum_overflows, &C::pixels}},
        {"buffers", "two colour planes, draw and read buffers, accumulation cleared to values", "R12.16 R13.16-R13.19",
         buffers_case, 8, color | back | depth | accum, {&C::stencil_killed, &C::depth_killed, &C::pixels, &C::written}},
        {"multipass", "whole frames: depth pass, shadow volumes, additive passes, samples", "R1.8 R1.10 R14.1 R14.2 R14.5 R14.7-R14.9 R15.2-R15.4",
         multipass_case, 6, color | depth | stencil | accum, {&C::stencil_killed, &C::depth_killed, &C::texels}},
        {"tiny-draws", "hundreds of draws of a few triangles, changes of state between them", "",
         tiny_draws_case, 0, color | depth | stencil, {&C::draws, &C::depth_killed, &C::written}},
    };
    return all;
}
// clang-format on

}  // namespace gw::conformance
