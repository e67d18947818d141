// Ray casting [L9]: the nearest intersection of the ray through every pixel, by brute force. It
// works after perspective: on the window grid all lines of sight are parallel to z. No reflection:
// raytrace/ follows rays further.
#include "hiddensurface/interface/algorithm.h"
#include "raytrace/casting/intersect.h"

#include <algorithm>

namespace gw::hiddensurface {
namespace {

struct Targets {
    std::vector<raytrace::PlanePolygon> triangles;
    std::vector<std::uint32_t> ids;
};
using Ray = raytrace::Ray;

Targets targets_of(const Input& input) {
    Targets targets;
    for (const Polygon& polygon : input.polygons)
        for (const WindowTriangle& t : polygon.triangles) {
            // One unit behind the origins, so that t = 1 is the near plane.
            std::vector<dvec3> corners;
            for (const GridPoint& p : t.corners) corners.push_back(to_dvec3(p) + dvec3(0, 0, 1));
            targets.triangles.push_back(raytrace::plane_polygon(std::move(corners), 2));
            targets.ids.push_back(polygon.id);
        }
    return targets;
}

/// All polygons that the ray meets, near to far.
void log_ray(const Ray& ray, const Targets& targets, int x, int y, StepLog& log) {
    std::vector<std::pair<double, std::uint32_t>> hits;
    for (std::size_t i = 0; i < targets.triangles.size(); ++i)
        if (const auto hit = raytrace::nearest_hit(ray, {&targets.triangles[i], 1}))
            hits.emplace_back(hit->t - 1, targets.ids[i]);
    std::stable_sort(hits.begin(), hits.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    Step step{.level = Level::Pixel,
              .test = "ray",
              .result = hits.empty()       ? "background"
                        : hits.size() == 1 ? "one"
                                           : "nearest",
              .decisive = hits.size() > 1,
              .window = pixels_of({y, x, x + 1})};
    std::vector<double> z;
    for (const auto& [depth, id] : hits) {
        step.pieces.push_back(std::to_string(id));
        z.push_back(depth);
    }
    step.values = {{"z", z}, {"tested", std::int64_t(targets.triangles.size())}};
    log.add(std::move(step));
}

std::vector<Painted> cast_line(const Input& input, const Targets& targets, int y, StepLog& log) {
    const int s = input.subpixel_bits();
    std::vector<Painted> painted;
    for (int x = 0; x < input.view.width; ++x) {
        const Ray ray{{double(center(x, s)), double(center(y, s)), 0}, {0, 0, 1}};
        if (const auto hit = raytrace::nearest_hit(ray, targets.triangles))
            add_run(painted, {y, x, x + 1}, targets.ids[hit->polygon]);
        if (log.wants(Level::Pixel)) log_ray(ray, targets, x, y, log);
    }
    return painted;
}

Output run(const Input& input, StepLog& log) {
    Output output{.list = begin_picture(input, "ray casting")};
    log.watch(watched(output.counts));
    const Targets targets = targets_of(input);
    for (int y = input.view.height - 1; y >= 0; --y) {
        std::vector<Painted> painted = cast_line(input, targets, y, log);
        output.counts.rays += targets.triangles.size() * std::uint64_t(input.view.width);
        output.counts.spans += painted.size();
        draw_line(input, y, std::move(painted), output, log);
    }
    output.counts.peak_bytes = targets.triangles.size() * sizeof(raytrace::PlanePolygon);
    return output;
}

}  // namespace

Algorithm ray_casting() {
    return {.name = "ray-casting",
            .title = "Ray casting, every ray against every polygon [L9]",
            .claim = Claim::Always,
            .growth = {GrowthLaw::Rays, 50},
            .run = run};
}

}  // namespace gw::hiddensurface
