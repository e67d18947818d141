// The table of suites: what each is about, and what it must reach.
#include "tests/fuzz/suites.h"

namespace gw::fuzz {
namespace {

constexpr PlaneMask color = mask_of(Plane::Color), depth = mask_of(Plane::Depth),
                    stencil = mask_of(Plane::Stencil), accum = mask_of(Plane::Accum);
using C = Counters;

}  // namespace

const std::vector<Suite>& suites() {
    static const std::vector<Suite> all{
        {"raster",
         "triangles of every shape, culling, the fill rule",
         raster_case,
         color | depth,
         {&C::rejected, &C::degenerate, &C::culled, &C::drawn}},
        {"clip",
         "near, far, user planes and guard band; w of every size and sign",
         clip_case,
         color | depth,
         {&C::rejected, &C::clipped, &C::degenerate, &C::drawn}},
        {"viewport",
         "viewports, scissors and depth ranges",
         viewport_case,
         color | depth,
         {&C::drawn, &C::fragments}},
        {"jitter",
         "the same geometry at many integer jitters",
         jitter_case,
         color | depth | accum,
         {&C::drawn}},
        {"depth",
         "every depth function and mask, ranges, offsets, flat and steep",
         depth_case,
         color | depth,
         {&C::depth_killed, &C::written}},
        {"coincident",
         "faces drawn again in other words, under Equal",
         coincident_case,
         color | depth,
         {&C::depth_killed, &C::written}},
        {"stencil",
         "every stencil function, operation and mask",
         stencil_case,
         color | depth | stencil,
         {&C::stencil_killed, &C::depth_killed}},
        {"blend",
         "blend factors, colour masks, alpha test",
         blend_case,
         color,
         {&C::alpha_killed, &C::written}},
        {"accumulation",
         "accumulation with every weight",
         accumulation_case,
         color | accum,
         {&C::accum_overflows, &C::pixels}},
        {"texture", "filters, wraps, environments, sizes", texture_case, color, {&C::texels}},
        {"generated-texture",
         "sphere, refraction and projected maps, slots",
         generated_texture_case,
         color,
         {&C::texels, &C::pixels}},
        {"shadow", "depth slots compared with r", shadow_case, color | depth, {&C::texels, &C::pixels}},
        {"fog", "fog at the vertex and per fragment", fog_case, color, {&C::written}},
        {"lighting",
         "materials and lights, flat and smooth, two-sided",
         lighting_case,
         color,
         {&C::vertices, &C::written}},
        {"lines-and-points",
         "lines and points of every width",
         lines_and_points_case,
         color | depth,
         {&C::rejected, &C::clipped, &C::degenerate, &C::drawn}},
        {"polygon-modes",
         "outlines and corners of polygons",
         polygon_mode_case,
         color | depth,
         {&C::culled, &C::clipped}},
        {"identifiers",
         "item buffers: identifiers bypass every stage",
         identifier_case,
         color,
         {&C::written}},
        {"pixels-and-copies",
         "clears, spans, rectangles, copies, read-backs, slots",
         pixels_case,
         color | depth | stencil,
         {&C::alpha_killed, &C::stencil_killed, &C::depth_killed, &C::pixels}},
        {"multipass",
         "whole frames: depth pass, shadow volumes, additive Equal passes, fog, accumulation",
         multipass_case,
         color | depth | stencil | accum,
         {&C::stencil_killed, &C::depth_killed, &C::texels}},
        {"profiles",
         "users' profiles with everything",
         profile_case,
         color | depth | stencil | accum,
         {&C::written}},
        {"everything",
         "all state at once",
         everything_case,
         color | depth | stencil | accum,
         {&C::alpha_killed, &C::stencil_killed, &C::depth_killed, &C::texels, &C::clipped}},
    };
    return all;
}

Case make_case(const Suite& suite, std::uint64_t index) {
    Random random(seed_of(suite.name, index));
    return suite.make(random);
}

}  // namespace gw::fuzz
