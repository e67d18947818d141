#include "web/engine/ray_scene.h"

#include "gw/error.h"
#include "gw/stages/vertex.h"
#include "itembuffer/traced_component.h"
#include "scene/draw/item_buffer.h"
#include "web/engine/json_point.h"

#include <algorithm>
#include <chrono>

namespace gw::lab {
namespace {

using Json = RayScene::Json;

constexpr std::size_t most_rays = 400;

double now_ms() {
    using namespace std::chrono;
    return duration<double, std::milli>(steady_clock::now().time_since_epoch()).count();
}

Json json_of(const raytrace::RayCounts& c) {
    return {{"primary", c.primary},
            {"reflected", c.reflected},
            {"transmitted", c.transmitted},
            {"shadow", c.shadow},
            {"shaded", c.shaded}};
}

}  // namespace

/// The rays of one pixel as they are followed.
struct RayScene::Walk {
    const RayScene& of;
    const scene::WorldTriangles& triangles;
    double far;  ///< the length of a ray that leaves the scene
    Json rays = Json::array();
    std::size_t all = 0;

    void name(Json& json, std::uint32_t triangle) const {
        const std::uint32_t id = triangles.id_of(triangle);
        json["object"] = of.scene_.objects[triangles.object_of(triangle)].name;
        json["id"] = id;
    }
    void add(const raytrace::FollowedRay& ray) {
        if (++all > most_rays) return;
        Json json{{"kind", ray.light   ? "shadow"
                           : ray.above ? "reflected"
                                       : "transmitted"},
                  {"number", ray.number},
                  {"part", ray.part},
                  {"from", json_of(ray.from)},
                  {"to", json_of(ray.hit ? ray.hit->p : end_of(ray))}};
        if (ray.light) {
            json["light"] = of.scene_.lights[*ray.light].name;
            json["arrives"] = !ray.hit;
        }
        if (ray.hit && !ray.light) name(json, ray.hit->triangle);
        rays.push_back(json);
    }
    /// The end of a ray that meets nothing: the light, or far away.
    dvec3 end_of(const raytrace::FollowedRay& ray) const {
        const bool has_end =
            ray.light && of.scene_.lights[*ray.light].kind != scene::LightKind::Directional;
        return has_end ? ray.from + ray.direction : ray.from + far * normalized(ray.direction);
    }
};

RayScene::RayScene(Machine& machine, scene::Scene scene, int depth)
    : machine_(machine), scene_(std::move(scene)), depth_(depth) {}

const std::shared_ptr<const raytrace::World>& RayScene::world() {
    if (!world_) world_ = std::make_shared<raytrace::World>(scene_, 1);
    return world_;
}

Json RayScene::by_passes(const scene::View& view) {
    const double begun = now_ms();
    const bool made = !driver_;
    if (made) {
        multipass::Options passes;
        const bool any = raytrace::any_traced(scene_);
        if (any) {
            passes.pass_list =
                itembuffer::passes_with_tracing(scene_, multipass::Translucency::Sorted);
            const itembuffer::Options rays{
                .depth = depth_, .threads = 1, .counts = &counts_, .world = world()};
            passes.trace = [this, trace = itembuffer::tracing(scene_, rays)](
                               Machine& machine, const scene::Scene& now, const scene::View& seen,
                               const JitterState& jitter) {
                drawn_ = seen;  // its far plane lies behind all shadow volumes
                const double from = now_ms();
                auto colors = trace(machine, now, seen, jitter);
                tracing_ += now_ms() - from;
                return colors;
            };
        }
        driver_ = std::make_unique<multipass::Driver>(
            machine_, any ? raytrace::drawn_scene(scene_) : scene_, passes);
    }
    counts_ = {};
    tracing_ = 0;
    asked_ = drawn_ = view;
    driver_->draw(view);
    return {{"counts", json_of(counts_)},
            {"milliseconds", now_ms() - begun},
            {"tracing", tracing_},
            {"made", made}};
}

Json RayScene::by_rays(const scene::View& view) {
    const double begun = now_ms();
    const bool made = !world_;
    const raytrace::Tracer tracer(scene_, *world(), view, options());
    const raytrace::RaytracedPicture picture =
        raytrace::raytraced_picture(tracer, scene_, view, {}, machine_.profile());
    machine_.execute(raytrace::commands(picture, view));
    return {{"counts", json_of(picture.counts)},
            {"milliseconds", now_ms() - begun},
            {"tracing", now_ms() - begun},
            {"made", made}};
}

const std::vector<std::uint32_t>& RayScene::identify(const scene::View& view) {
    const bool is_drawn = asked_.width == view.width && asked_.height == view.height &&
                          asked_.eye_from_world == view.eye_from_world &&
                          asked_.clip_from_eye == view.clip_from_eye;
    view_ = is_drawn ? drawn_ : view;
    ids_ = scene::draw_item_buffer(machine_, raytrace::drawn_scene(scene_), view_, {});
    return ids_;
}

std::vector<std::uint8_t> RayScene::traced() {
    const raytrace::Tracer tracer(scene_, *world(), view_, options());
    std::vector<std::uint8_t> traced;
    for (const std::uint32_t id : ids_) {
        const auto triangle = world_->triangles().first_of(id);
        traced.push_back(triangle && tracer.is_traced(*triangle));
    }
    return traced;
}

Json RayScene::path(int x, int y, bool ordinary) {
    if (ids_.empty() || x < 0 || y < 0 || x >= view_.width || y >= view_.height)
        throw Error("pixel " + std::to_string(x) + " " + std::to_string(y) +
                    " is outside the picture");
    y = view_.height - 1 - y;
    const scene::WorldTriangles& triangles = world()->triangles();
    const scene::Bounds bounds = scene::bounds(scene_);
    Walk walk{*this, triangles, length(bounds.high - bounds.low) / 4};
    raytrace::TraceOptions followed = options();
    followed.followed = [&walk](const raytrace::FollowedRay& ray) { walk.add(ray); };
    const raytrace::Tracer tracer(scene_, *world(), view_, followed);

    const std::size_t pixel = view_.index(x, y);
    const scene::PixelRay ray = scene::PixelRays(view_).through(x + 0.5, y + 0.5);
    const auto triangle = triangles.first_of(ids_[pixel]);
    Json answer{{"id", ids_[pixel]},
                {"traced", triangle && tracer.is_traced(*triangle)},
                {"eye", json_of(scene::is_orthographic(view_) ? ray.o : view_.camera.eye)}};
    const auto at =
        ordinary ? world_->nearest({ray.o, ray.d}, 1) : triangles.meet(ids_[pixel], ray.o, ray.d);
    answer["to"] = json_of(at ? at->p : ray.o + ray.d);
    if (at) walk.name(answer, at->triangle);
    raytrace::RayCounts counts;
    if (ordinary) {
        ++counts.primary;
        if (at)
            raytrace::seen_color(tracer,
                                 raytrace::surface(triangles, *at, normalized(ray.d), view_),
                                 scene_, machine_.profile(), counts);
    } else {
        std::vector<std::uint32_t> only(ids_.size(), 0);
        only[pixel] = ids_[pixel];
        counts = itembuffer::traced_component(tracer, scene_, view_, only, {}, machine_.profile())
                     .counts;
    }
    answer["counts"] = json_of(counts);
    answer["rays"] = walk.rays;
    answer["all"] = walk.all;
    return answer;
}

}  // namespace gw::lab
