#include "multipass/effects/translucency.h"

#include "gw/error.h"
#include "multipass/steps/commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace gw::multipass {
namespace {

struct SortedTriangle {
    double distance = 0;  ///< three times the centroid's
    std::size_t part = 0;
    std::uint32_t triangle = 0;
};

void add_triangles(std::vector<SortedTriangle>& all, const PlacedModel& placed, std::size_t index) {
    const Mesh& mesh = *placed.model->parts[index].mesh;
    const dmat4& m = placed.eye_from_object[index];
    const auto distance = [&](std::uint32_t vertex) {
        return -(transform3(dmat3(m), dvec3(mesh.data().positions[vertex])).z + m[3].z);
    };
    for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
        const auto& v = mesh.triangles()[i].vertex;
        all.push_back({distance(v[0]) + distance(v[1]) + distance(v[2]), index, i});
    }
}

std::array<dvec3, 3> eye_corners(const PlacedModel& placed, const SortedTriangle& t) {
    const Mesh& mesh = *placed.model->parts[t.part].mesh;
    const dmat4& m = placed.eye_from_object[t.part];
    std::array<dvec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
        corners[k] =
            transform3(dmat3(m),
                       dvec3(mesh.data().positions[mesh.triangles()[t.triangle].vertex[k]])) +
            dvec3(m[3]);
    return corners;
}

/// Faces of one plane hide nothing of each other. So those of one name that follow each other are
/// gathered by part: a surface that was cut by its opacity then needs few draws.
void gather_in_planes(std::vector<SortedTriangle>& all, const PlacedModel& placed) {
    const auto& parts = placed.model->parts;
    for (auto first = all.begin(); first != all.end();) {
        const auto [a, b, c] = eye_corners(placed, *first);
        const dvec3 cross = cross3(b - a, c - a), normal = cross / length(cross), origin = a;
        const std::string& name = parts[first->part].object->name;
        const auto last = std::find_if(first + 1, all.end(), [&](const SortedTriangle& t) {
            if (parts[t.part].object->name != name) return true;
            const std::array<dvec3, 3> corners = eye_corners(placed, t);
            return std::any_of(corners.begin(), corners.end(), [&](const dvec3& p) {
                return !(std::abs(dot3(normal, p - origin)) <= 1e-6 * length(p));
            });
        });
        std::stable_sort(first, last, [](const SortedTriangle& x, const SortedTriangle& y) {
            return x.part < y.part;
        });
        first = last;
    }
}

Rect window(const PlacedModel& placed) { return {0, 0, placed.view.width, placed.view.height}; }

/// Every translucent fragment; changes only stencil and Z, by their state.
State fragment_state(const PlacedModel& placed, const StencilState& stencil, bool update_depth) {
    State state = placed.state;
    state.color_source = ColorSource::Vertex;
    state.color_mask = {false, false, false, false};
    state.depth = {.test = true, .func = DepthFunc::Always, .mask = update_depth};
    state.stencil = stencil;
    return state;
}

void draw_translucent(CommandList& list, const PlacedModel& placed, State state) {
    for (std::size_t i = 0; i < placed.model->parts.size(); ++i) {
        if (!placed.model->parts[i].translucent) continue;
        if (placed.cull[i] != state.cull) {
            state.cull = placed.cull[i];
            list.add(SetState{state});
        }
        list.add(black_draw(placed, {.part = i}));
    }
}

void clear(CommandList& list, PlaneMask planes) { list.add(Clear{.planes = planes, .depth = 0}); }

/// How many translucent fragments every pixel gets; Z of the opaque picture is read besides.
std::vector<std::uint32_t> count_fragments(Machine& machine, const PlacedModel& placed,
                                           std::vector<std::uint32_t>& opaque) {
    CommandList list;
    list.add(BeginPass{.name = "count layers"});
    const State state = fragment_state(placed, {.test = true, .zpass = StencilOp::Incr}, false);
    list.add(SetState{state});
    clear(list, mask_of(Plane::Stencil));
    draw_translucent(list, placed, state);
    list.add(Read{.key = 0, .plane = Plane::Depth, .rect = window(placed)});
    list.add(Read{.key = 1, .plane = Plane::Stencil, .rect = window(placed)});
    machine.execute(list);
    const auto& depth = machine.readbacks().at(0).values;
    const auto& counts = machine.readbacks().at(1).values;
    opaque.assign(depth.begin(), depth.end());
    return {counts.begin(), counts.end()};
}

/// Z of every pixel's fragment number `ordinal`: the stencil counts those before it.
void draw_fragment(CommandList& list, const PlacedModel& placed, std::uint32_t ordinal) {
    const StencilState stencil{.test = true,
                               .func = StencilFunc::Equal,
                               .ref = int(ordinal),
                               .fail = StencilOp::Incr,
                               .zfail = StencilOp::Incr,
                               .zpass = StencilOp::Incr};
    const State state = fragment_state(placed, stencil, true);
    begin_pass(list, "layer Z " + std::to_string(ordinal + 1), state);
    clear(list, PlaneMask(mask_of(Plane::Stencil) | mask_of(Plane::Depth)));
    draw_translucent(list, placed, state);
    list.add(Read{.key = ordinal, .plane = Plane::Depth, .rect = window(placed)});
}

/// The Z of one pixel's visible layers, far to near.
std::vector<std::uint32_t> sorted_layers(const std::map<std::uint32_t, Readback>& fragments,
                                         std::uint32_t count, std::size_t pixel,
                                         std::uint32_t opaque) {
    std::vector<std::uint32_t> z;
    for (std::uint32_t k = 0; k < count; ++k) z.push_back(fragments.at(k).values[pixel]);
    std::erase_if(z, [&](std::uint32_t v) { return v >= opaque; });
    std::sort(z.begin(), z.end(), std::greater<>());
    z.erase(std::unique(z.begin(), z.end()), z.end());
    return z;
}

void add_pixel(Layers& layers, std::size_t pixel, const std::vector<std::uint32_t>& z) {
    while (layers.depth.size() < z.size()) {
        layers.depth.emplace_back(layers.opaque.size());
        layers.present.emplace_back(layers.opaque.size());
    }
    for (std::size_t r = 0; r < z.size(); ++r) {
        layers.depth[r][pixel] = z[r];
        layers.present[r][pixel] = 1;
    }
}

void write(CommandList& list, const PlacedModel& placed, Plane plane,
           const std::vector<std::uint32_t>& values) {
    list.add(WritePixels{.rect = window(placed), .plane = plane, .values = values});
}

}  // namespace

std::vector<Portion> far_to_near(const PlacedModel& placed) {
    const auto& parts = placed.model->parts;
    std::vector<SortedTriangle> all;
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (parts[i].translucent && parts[i].mesh->kind() == MeshKind::Triangles)
            add_triangles(all, placed, i);
    std::stable_sort(all.begin(), all.end(), [](const SortedTriangle& a, const SortedTriangle& b) {
        return a.distance > b.distance;
    });
    gather_in_planes(all, placed);
    std::vector<Portion> portions;
    PortionMaker maker(placed);
    for (auto first = all.begin(); first != all.end();) {
        const auto last = std::find_if(
            first, all.end(), [&](const SortedTriangle& p) { return p.part != first->part; });
        std::vector<std::uint32_t> triangles;
        for (auto p = first; p != last; ++p) triangles.push_back(p->triangle);
        portions.push_back(maker.portion_of(first->part, triangles));
        first = last;
    }
    return portions;
}

Layers find_layers(Machine& machine, const PlacedModel& placed) {
    Layers layers;
    const auto counts = count_fragments(machine, placed, layers.opaque);
    const std::uint32_t most = *std::max_element(counts.begin(), counts.end());
    const std::uint32_t limit = (1u << machine.profile().stencil_bits) - 1;
    if (most >= limit)
        throw Error(
            fmt::format("{} or more translucent faces at a pixel; {} stencil bits count fewer",
                        most, machine.profile().stencil_bits));
    CommandList list;
    for (std::uint32_t k = 0; k < most; ++k) draw_fragment(list, placed, k);
    machine.execute(list);
    for (std::size_t i = 0; i < counts.size(); ++i)
        add_pixel(layers, i, sorted_layers(machine.readbacks(), counts[i], i, layers.opaque[i]));
    return layers;
}

void begin_layer(CommandList& list, const PlacedModel& placed, const Layers& layers,
                 std::size_t index) {
    begin_pass(list, "layer " + std::to_string(index + 1), placed.state);
    write(list, placed, Plane::Depth, layers.depth[index]);
    write(list, placed, Plane::Stencil, layers.present[index]);
}

void end_layers(CommandList& list, const PlacedModel& placed, const Layers& layers) {
    begin_pass(list, "end layers", placed.state);
    write(list, placed, Plane::Depth, layers.opaque);
    list.add(Clear{.planes = mask_of(Plane::Stencil)});
}

}  // namespace gw::multipass
