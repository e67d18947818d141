#include "multipass/shadow/shadow_map.h"

#include "gw/base/arithmetic.h"
#include "gw/base/elementary.h"
#include "gw/stages/vertex.h"
#include "multipass/passes/catalogue.h"
#include "multipass/steps/commands.h"
#include "multipass/steps/placed_model.h"
#include "scene/draw/draw_commands.h"
#include "scene/draw/nearest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gw::multipass {
namespace {

/// Maps of at most this half angle are one picture.
constexpr double widest_cone = 60;
/// The nearest of a light's depths is at least this part of the farthest.
constexpr double least_near = 1.0 / 4096;

/// Smallest and largest distance of anything in the box from `p`.
scene::DepthInterval distances(const scene::Bounds& bounds, const dvec3& p) {
    scene::DepthInterval d;
    dvec3 outside(0);
    for (int k = 0; k < 3; ++k)
        outside[k] = std::max({0.0, bounds.low[k] - p[k], p[k] - bounds.high[k]});
    d.nearest = length(outside);
    for (int i = 0; i < 8; ++i) d.farthest = std::max(d.farthest, length(corner(bounds, i) - p));
    return d;
}

/// A box along the light's way around the whole scene.
scene::View directional_view(const scene::Light& light, const scene::Bounds& bounds, int size) {
    const dvec3 center = (bounds.low + bounds.high) * 0.5, direction = dvec3(light.direction);
    scene::View view{.width = size, .height = size};
    view.eye_from_world =
        scene::look_at(center, center + direction / length(direction), dvec3(0, 1, 0));
    dvec3 reach(0);
    for (int i = 0; i < 8; ++i) {
        const dvec3 p = transform3(dmat3(view.eye_from_world), corner(bounds, i) - center);
        for (int k = 0; k < 3; ++k) reach[k] = std::max(reach[k], std::abs(p[k]));
    }
    // A flat scene has a box all the same.
    const double least = 1e-3 * std::max({reach.x, reach.y, reach.z, 1e-30});
    for (int k = 0; k < 3; ++k) reach[k] = 1.01 * std::max(reach[k], least);
    view.clip_from_eye = scene::ortho(-reach.x, reach.x, -reach.y, reach.y, -reach.z, reach.z);
    return view;
}

scene::View spot_view(const scene::Light& light, double near_plane, double far_plane, int size) {
    const dvec3 p(light.position);
    scene::View view{.width = size, .height = size};
    view.eye_from_world = scene::look_at(p, p + dvec3(light.direction), dvec3(0, 1, 0));
    const double cone = std::max(light.cone_angle, 0.1),
                 slope = tan_degrees(cone) * 1.02 * near_plane;
    // Its tangent is at least the slope's: wider than the view.
    view.camera = {.fov = 2 * 1.02 * cone, .near_plane = near_plane, .far_plane = far_plane};
    view.clip_from_eye = scene::frustum(-slope, slope, -slope, slope, near_plane, far_plane);
    return view;
}

/// Whether the box around a part surely lies outside a window of the view: beyond one of its sides,
/// or of its near and far planes. In pixels the window is [x, x + width] x [y, y + height].
struct PartBox {
    std::array<dvec3, 8> corners;  ///< object space

    explicit PartBox(const Mesh& mesh) {
        constexpr double inf = std::numeric_limits<double>::infinity();
        scene::Bounds b{dvec3(inf), dvec3(-inf), false};
        for (const vec3& p : mesh.data().positions)
            for (int k = 0; k < 3; ++k) {
                b.low[k] = std::min(b.low[k], double(p[k]));
                b.high[k] = std::max(b.high[k], double(p[k]));
            }
        for (int i = 0; i < 8; ++i) corners[std::size_t(i)] = corner(b, i);
    }

    bool misses(const dmat4& clip_from_object, const scene::View& view, const Rect& window) const {
        // A pixel more than the window: vertices are snapped.
        const auto ndc = [](double pixel, int size) { return 2 * pixel / size - 1; };
        const double left = ndc(window.x - 1, view.width), bottom = ndc(window.y - 1, view.height),
                     right = ndc(window.x + window.width + 1, view.width),
                     top = ndc(window.y + window.height + 1, view.height);
        std::array<int, 6> beyond{};
        for (const dvec3& p : corners) {
            const dvec4 c = transform(clip_from_object, dvec4(p, 1));
            const std::array<bool, 6> out{c.x<left * c.w, c.x> right * c.w,
                                          c.y<bottom * c.w, c.y> top * c.w, c.z<-c.w, c.z> c.w};
            for (std::size_t k = 0; k < 6; ++k) beyond[k] += out[k];
        }
        return std::find(beyond.begin(), beyond.end(), 8) != beyond.end();
    }
};

/// Z of the parts that cast shadows through a window of the map. False: there are none in it.
bool add_tile(CommandList& list, const PlacedModel& whole, const std::vector<PartBox>& boxes,
              const Rect& window) {
    const PassModel& model = *whole.model;
    PassModel seen{.scene = model.scene};
    PlacedModel placed = whole;
    placed.eye_from_object.clear();
    for (std::size_t i = 0; i < model.parts.size(); ++i) {
        const dmat4& eye_from_object = whole.eye_from_object[i];
        if (boxes[i].misses(product(whole.state.projection, eye_from_object), whole.view, window))
            continue;
        seen.parts.push_back(model.parts[i]);
        placed.eye_from_object.push_back(eye_from_object);
    }
    placed.model = &seen;
    placed.state.viewport = {-window.x, -window.y, whole.view.width, whole.view.height};
    Step step{.pass = depth_pass};
    step.pass.name = "light Z";
    step.pass.objects = PassObjects::Casting;
    if (std::none_of(seen.parts.begin(), seen.parts.end(),
                     [&](const Part& part) { return concerns(step, part, seen); }))
        return false;
    add_step(list, placed, step, {});
    return true;
}

/// Copies a tile that was read back into its map.
void take(ShadowMap& map, const Readback& tile, int x, int y) {
    const int size = map.view.width;
    for (int row = 0; row < tile.rect.height; ++row)
        std::copy_n(tile.values.begin() + std::ptrdiff_t{row} * tile.rect.width, tile.rect.width,
                    map.depth.begin() + std::ptrdiff_t{y + row} * size + x);
}

}  // namespace

std::vector<scene::View> light_views(const scene::Light& light, const scene::Bounds& bounds,
                                     int size) {
    if (light.kind == scene::LightKind::Directional) return {directional_view(light, bounds, size)};
    const auto [nearest, farthest] = distances(bounds, dvec3(light.position));
    const double far_plane = farthest * 1.01,
                 near_plane = std::max(nearest * 0.99, far_plane * least_near);
    if (light.kind == scene::LightKind::Spot && light.cone_angle <= widest_cone)
        return {spot_view(light, near_plane, far_plane, size)};
    // A face's corners are farther along its axis than along themselves, never nearer than 1 /
    // sqrt(3).
    const auto cube = scene::cube_views(dvec3(light.position), near_plane * 0.57, far_plane, size);
    return {cube.begin(), cube.end()};
}

std::vector<scene::View> light_views(const scene::Light& light, const scene::Scene& scene,
                                     int size) {
    std::vector<scene::View> views = light_views(light, scene::bounds(scene), size);
    if (light.kind == scene::LightKind::Directional) return views;
    scene::Scene casters;
    for (const scene::Object& caster : scene.objects)
        if (caster.casts_shadow && scene.materials[caster.material].d >= 1)
            casters.objects.push_back(caster);
    for (scene::View& view : views)
        view = scene::sparing_near(view, casters, scene::edge_on_in_map(view));
    return views;
}

int shadow_map_size(int width, int height) {
    int size = 64;
    while (size < 2 * std::max(width, height) && size < max_window_size) size *= 2;
    return size;
}

std::vector<ShadowMap> draw_shadow_maps(Machine& machine, const PassModel& model,
                                        const std::vector<scene::View>& views, int width,
                                        int height) {
    std::vector<PartBox> boxes;
    for (const Part& part : model.parts) boxes.emplace_back(*part.mesh);
    const std::uint32_t farthest = max_of_bits(machine.profile().depth_bits);
    std::vector<ShadowMap> maps;
    for (const scene::View& view : views) {
        PlacedModel placed = place_model(model, view);
        placed.cull.assign(placed.cull.size(), {});  // both sides cast shadows
        const int size = view.width;
        ShadowMap map{
            .view = view,
            .depth = std::vector<std::uint32_t>(std::size_t(size) * std::size_t(size), farthest)};
        CommandList list;
        std::vector<ivec2> tiles;
        for (int y = 0; y < size; y += height)
            for (int x = 0; x < size; x += width) {
                const Rect rect{0, 0, std::min(width, size - x), std::min(height, size - y)};
                if (!add_tile(list, placed, boxes, {x, y, rect.width, rect.height})) continue;
                list.add(
                    Read{.key = std::uint32_t(tiles.size()), .plane = Plane::Depth, .rect = rect});
                tiles.emplace_back(x, y);
            }
        if (!tiles.empty()) machine.execute(list);
        for (std::size_t i = 0; i < tiles.size(); ++i)
            take(map, machine.readbacks().at(std::uint32_t(i)), tiles[i].x, tiles[i].y);
        maps.push_back(std::move(map));
    }
    return maps;
}

}  // namespace gw::multipass
