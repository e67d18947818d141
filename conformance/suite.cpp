#include "conformance/suite.h"

#include "conformance/directed/directed.h"
#include "conformance/suites.h"
#include "gw/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace gw::conformance {
namespace {

using fuzz::Case;
using fuzz::Random;

/// A group, its generator and the number of its recordings.
struct Source {
    Group group;
    Case (*make)(Random&);
    int count;
};

// clang-format off
const std::vector<Source>& sources() {
    static const std::vector<Source> all{
        {{"profiles", "profiles of every bit width, with all state and commands", "R1.3 R2.8 R2.9 R2.10 R1.5 R9.10"}, fuzz::profile_case, 14},
        {{"blocks", "a window of six blocks of 64 x 64 pixels", "R1.6 R14.10"}, blocks_case, 1},
        {{"everything", "all state and all commands at once", "R1.8-R1.10 R4.1-R4.6 R5.1-R5.3"}, fuzz::everything_case, 12},
        {{"mesh", "primitives, indices, identifiers, sizes, absent arrays", "R6.1-R6.8 R5.3 R15.1"}, mesh_case, 6},
        {{"gradient-ties", "gradients half-way between two integers", "R9.6 R9.8"}, ties_case, 6},
        {{"raster", "triangles of every shape, culling, the fill rule", "R6.20-R6.24 R9.1 R9.2 R9.6 R9.8 R9.9 R9.11"}, fuzz::raster_case, 8},
        {{"clip", "near, far, user planes and guard band; w of every size and sign", "R6.9 R6.10 R6.15-R6.19 R6.25 R6.26 R2.1-R2.5"}, fuzz::clip_case, 24},
        {{"cut-slivers", "polygons that the snap bends after a cut", "R6.25 R6.26"}, cut_slivers_case, 4},
        {{"viewport", "viewports, scissors and depth ranges", "R4.3 R4.4 R6.20 R6.21"}, fuzz::viewport_case, 6},
        {{"jitter", "the same geometry at many jitters", "R6.22"}, fuzz::jitter_case, 4},
        {{"polygons", "concave polygons, and polygons that touch and cross themselves", "R7.1-R7.9 R6.3 R6.4"}, polygons_case, 16},
        {{"polygon-modes", "outlines and corners of polygons", "R6.7 R14.3"}, fuzz::polygon_mode_case, 6},
        {{"identifiers", "identifiers bypass texture and fog", "R6.13 R6.5"}, fuzz::identifier_case, 4},
        {{"lighting", "materials and lights, flat and smooth, two-sided", "R8.1-R8.8 R6.6 R6.11 R6.12 R5.5 R5.6 R3.1-R3.9"}, fuzz::lighting_case, 14},
        {{"extreme-lights", "lights and normals that overflow, underflow and vanish", "R8.1-R8.8 R2.5-R2.7"}, extreme_lights_case, 6},
        {{"lines-and-points", "lines and points of every width", "R9.3-R9.5 R9.7 R14.4"}, fuzz::lines_and_points_case, 8},
        {{"offset", "polygon offset on slopes of every size", "R9.12"}, offset_case, 4},
        {{"texture", "filters, wraps, environments, sizes", "R10.1 R10.6 R10.8-R10.15 R10.17 R9.13-R9.16 R9.18 R9.19 R5.2 R5.4 R6.14 R14.6"}, fuzz::texture_case, 20},
        {{"far-coordinates", "texture coordinates far from 0, spans beyond 1024 repeats", "R10.8 R10.9 R9.17 R9.19"}, far_coordinates_case, 6},
        {{"generated-texture", "sphere, refraction and projected maps, slots", "R10.1-R10.5 R10.16 R10.19 R9.17"}, fuzz::generated_texture_case, 14},
        {{"shadow", "depth slots compared with r", "R10.18 R10.19"}, fuzz::shadow_case, 10},
        {{"fog", "fog at the vertex and per fragment", "R11.1-R11.7 R3.6"}, fuzz::fog_case, 14},
        {{"stencil", "every stencil function, operation and mask", "R12.1-R12.8"}, fuzz::stencil_case, 8},
        {{"depth", "every depth function and mask", "R12.9"}, fuzz::depth_case, 6},
        {{"coincident", "faces drawn again by other primitives, under Equal", "R1.10"}, fuzz::coincident_case, 4},
        {{"blend", "blend factors, colour masks, alpha test", "R12.4 R12.10-R12.13"}, fuzz::blend_case, 8},
        {{"stipple", "stipples, polygon modes of both faces, offsets of outlines", "R6.30 R9.20 R9.21 R9.22"}, fuzz::stipple_case, 12},
        {{"antialiasing", "smooth points, lines and polygons", "R9.23-R9.30"}, fuzz::antialiasing_case, 20},
        {{"texture-formats", "texture formats, borders, given levels, one dimension", "R10.23 R10.24 R10.25 R10.26 R10.17"}, fuzz::texture_formats_case, 16},
        {{"vertices", "positions of any w, materials by vertex, current values, texture coordinates by rule", "R5.9 R6.27-R6.29 R8.9 R8.10 R10.20-R10.22"}, fuzz::vertices_case, 12},
        {{"joined-colors", "logical operations, blend equations, a constant colour", "R12.14 R12.15"}, fuzz::joined_colors_case, 8},
        {{"pixels", "clears, spans, rectangles, copies, read-backs, slots", "R13.1-R13.7 R12.2 R12.3"}, fuzz::pixels_case, 10},
        {{"drawn-pixels", "rectangles of pixels through all stages: zoom, bits, sources", "R13.10-R13.15"}, fuzz::drawn_pixels_case, 12},
        {{"accumulation", "accumulation with every weight", "R13.8 R13.9"}, fuzz::accumulation_case, 6},
        {{"buffers", "two colour planes, draw and read buffers, accumulation cleared to values", "R12.16 R13.16-R13.18"}, fuzz::buffers_case, 8},
        {{"multipass", "whole frames: depth pass, shadow volumes, additive passes, samples", "R1.8 R1.10 R14.1 R14.2 R14.5 R14.7-R14.9 R15.2-R15.4"}, fuzz::multipass_case, 6},
    };
    return all;
}
// clang-format on

/// A pass for each command that is not SetState, so that the first difference names its command.
inspect::Recording recording_of(const Case& c, const std::string& name) {
    inspect::Recording out;
    out.producer = "gw conformance";
    out.scene = name;
    out.profile = c.profile;
    out.width = c.width;
    out.height = c.height;
    CommandList list;
    std::size_t ordinal = 0;
    for (const Command& command : c.list.commands) {
        if (std::holds_alternative<BeginPass>(command)) continue;
        if (!std::holds_alternative<SetState>(command))
            list.add(BeginPass{fmt::format("{:02} {}", ++ordinal, name_of(command))});
        list.add(command);
    }
    out.lists.push_back(std::move(list));
    return out;
}

/// A foreign machine may be slow, and all recordings together stay below 4 MB.
bool is_small(const inspect::Recording& recording) {
    constexpr int most_pixels = 3000;
    constexpr std::size_t most_bytes = 20000;
    return recording.width * recording.height <= most_pixels &&
           inspect::encode(recording).size() <= most_bytes;
}

}  // namespace

const std::vector<Group>& groups() {
    static const std::vector<Group> all = [] {
        std::vector<Group> out;
        for (const Source& source : sources()) out.push_back(source.group);
        return out;
    }();
    return all;
}

std::vector<Member> members(const Group& group) {
    const auto source = std::find_if(sources().begin(), sources().end(),
                                     [&](const Source& s) { return s.group.name == group.name; });
    std::vector<Member> out;
    for (std::uint64_t index = 0; int(out.size()) < source->count; ++index) {
        Random random(fuzz::seed_of("conformance " + group.name, index));
        const std::string name = fmt::format("{}_{:02}", group.name, out.size() + 1);
        inspect::Recording recording = recording_of(source->make(random), name);
        if (is_small(recording) || source->count == 1) out.push_back({name, std::move(recording)});
    }
    return out;
}

std::vector<std::string> rules_of(const Group& group) {
    std::vector<std::string> out;
    std::istringstream words(group.rules);
    for (std::string word; words >> word;) {
        int chapter = 0, first = 0, last = 0;
        const int read = std::sscanf(word.c_str(), "R%d.%d-R%*d.%d", &chapter, &first, &last);
        for (int rule = first; rule <= (read == 3 ? last : first); ++rule)
            out.push_back(fmt::format("R{}.{}", chapter, rule));
    }
    return out;
}

}  // namespace gw::conformance
