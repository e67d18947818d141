// Ray casting as it is taught [L9 to L12]: pictures and their costs by a method and an inside test,
// what one ray looks at, and the three inside tests on any polygon.
#include "gw/error.h"
#include "image/plane_pictures.h"
#include "raytrace/casting/cast_picture.h"
#include "render/words/option_words.h"
#include "web/engine/json_point.h"
#include "web/engine/method.h"
#include "web/engine/rgba.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace gw::lab {
namespace {

Json json_of(const raytrace::CastCounts& c) {
    return {{"rays", c.rays}, {"shapes", c.shapes}, {"boxes", c.boxes}, {"voxels", c.voxels}};
}

raytrace::Ray ray_through(const scene::View& view, double x, double y) {
    const scene::PixelRay ray = scene::PixelRays(view).through(x + 0.5, y + 0.5);
    return {ray.o, ray.d};
}

/// Refuses a picture of too many tests, by those of 8 x 8 of its rays.
void check_tests(const raytrace::RayCaster& caster, const scene::View& view, double limit) {
    raytrace::CastCounts counts;
    for (int j = 0; j < 8; ++j)
        for (int i = 0; i < 8; ++i)
            (void)caster.nearest(
                ray_through(view, view.width * (i + 0.5) / 8, view.height * (j + 0.5) / 8), counts);
    const double tests = double(counts.all()) / 64 * view.width * view.height;
    if (tests > limit)
        throw Error(
            fmt::format("about {:.0e} tests; expected at most {:.0e}: a smaller picture, "
                        "fewer shapes, or another method",
                        tests, limit));
}

}  // namespace

const raytrace::RayCaster& LabSession::caster_for(const Json& options) {
    const std::string key =
        options.value("method", "grid") + " " + options.value("inside", "crossings");
    if (shapes_.empty()) shapes_ = raytrace::cast_shapes(finished().scene);
    if (!caster_ || key != caster_key_) {
        caster_ =
            raytrace::make_caster(render::value_from("method", options.value("method", "grid"),
                                                     render::cast_method_words),
                                  shapes_,
                                  render::value_from("inside", options.value("inside", "crossings"),
                                                     render::inside_test_words));
        caster_key_ = key;
    }
    return *caster_;
}

Json LabSession::cast(const Json& options) {
    const scene::Scene scene = scene_for(options);
    const scene::View view = view_of(scene, options);
    const raytrace::RayCaster& caster = caster_for(options);
    check_tests(caster, view, options.value("limit", 5e7));
    const auto begun = std::chrono::steady_clock::now();
    const raytrace::CastPicture picture = raytrace::cast_picture(caster, shapes_, scene, view, 1);
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begun;
    picture_ = rgba_of(image::picture_of(picture.color, view.width, view.height, 8));
    change_ = rgba_of(image::amount_picture(picture.tests, view.width, view.height));
    return {{"counts", json_of(picture.counts)},
            {"shapes", shapes_.size()},
            {"milliseconds", time.count()}};
}

Json LabSession::visits(const Json& options) {
    const scene::Scene scene = scene_for(options);
    const scene::View view = view_of(scene, options);
    const raytrace::RayCaster& caster = caster_for(options);
    const raytrace::Ray ray =
        ray_through(view, options.at("x"), view.height - 1 - int(options.at("y")));
    raytrace::CastCounts counts;
    const auto hit = caster.nearest(ray, counts);
    Json boxes = Json::array();
    for (const raytrace::CastVisit& visit : caster.visits(ray))
        boxes.push_back({{"low", json_of(visit.box.low)},
                         {"high", json_of(visit.box.high)},
                         {"shapes", visit.shapes}});
    Json answer{{"from", json_of(ray.origin)},
                {"to", json_of(raytrace::point_at(ray, hit ? hit->t : 1))},
                {"counts", json_of(counts)},
                {"boxes", boxes}};
    if (hit) answer["object"] = scene.objects[shapes_[hit->shape].object].name;
    return answer;
}

Json LabSession::inside(const Json& options) {
    std::vector<dvec2> corners;
    for (const Json& corner : options.at("corners"))
        corners.push_back({corner.at(0), corner.at(1)});
    const int columns = options.at("columns"), rows = options.at("rows");
    Json cells = Json::array(), sides = Json::array();
    const auto tests_of = [&](const dvec2& p) {
        int bits = 0, bit = 1;
        for (const auto& test : render::inside_test_words) {
            if (raytrace::inside(test.second, p, corners)) bits |= bit;
            bit *= 2;
        }
        return bits;
    };
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) cells.push_back(tests_of({x + 0.5, y + 0.5}));
    const dvec2 p{options.at("point").at(0), options.at("point").at(1)};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const dvec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
        const auto angle = raytrace::seen_angle(p, a, b);
        sides.push_back({{"crossed", raytrace::crosses(p, a, b)},
                         {"product", raytrace::side_product(p, a, b)},
                         {"angle", angle ? Json(*angle) : Json()}});
    }
    return {{"cells", cells}, {"sides", sides}, {"tests", tests_of(p)}};
}

const Method cast_methods[] = {
    {"cast",
     &LabSession::cast,
     {{"picture", &LabSession::picture}, {"tests", &LabSession::change}}},
    {"visits", &LabSession::visits},
    {"inside", &LabSession::inside},
};

}  // namespace gw::lab
