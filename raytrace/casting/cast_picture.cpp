#include "raytrace/casting/cast_picture.h"

#include "gw/base/cancel.h"
#include "gw/base/parallel.h"
#include "gw/stages/vertex.h"
#include "raytrace/tracer/render.h"
#include "scene/draw/nearest.h"
#include "scene/draw/shading.h"
#include "scene/draw/view.h"

namespace gw::raytrace {
namespace {

dvec3 normal_of(const CastShape& s, const dvec3& p) {
    const auto* sphere = std::get_if<Sphere>(&s.shape);
    return sphere ? normal_at(*sphere, p) : normalized(std::get<PlanePolygon>(s.shape).normal);
}

/// Without its maps.
scene::Material plain(scene::Material m) {
    for (auto* maps : {&m.map_Ka, &m.map_Kd, &m.map_Ks, &m.map_Ke, &m.refl, &m.refraction})
        maps->clear();
    return m;
}

struct Shader {
    const std::vector<CastShape>& shapes;
    const scene::Scene& scene;
    const scene::View& view;
    std::vector<scene::Material> materials;
    std::vector<gw::Light> lights;

    dvec3 color(const CastHit& hit, const Ray& ray) const {
        const CastShape& shape = shapes[hit.shape];
        const scene::Object& object = scene.objects[shape.object];
        const dvec3 p = point_at(ray, hit.t);
        dvec3 n = normal_of(shape, p);
        if (dot3(n, ray.direction) > 0) n = -n;
        const dmat3 turn(view.eye_from_world);
        const scene::SurfacePoint point{.p = transform3(turn, p) + dvec3(view.eye_from_world[3]),
                                        .n = transform3(turn, n),
                                        .to_eye = -transform3(turn, normalized(ray.direction))};
        dvec3 sum = scene::own_color(materials[object.material], point);
        for (std::size_t i = 0; i < lights.size(); ++i)
            if (scene::lights_object(scene.lights[i], object))
                sum += scene::light_color(materials[object.material], lights[i], point);
        return sum;
    }
};

}  // namespace

CastPicture cast_picture(const RayCaster& caster, const std::vector<CastShape>& shapes,
                         const scene::Scene& scene, const scene::View& view, int threads) {
    Shader shader{shapes, scene, view, {}, {}};
    for (const scene::Material& m : scene.materials) shader.materials.push_back(plain(m));
    for (const scene::Light& light : scene.lights)
        shader.lights.push_back(scene::eye_light(light, view));
    const scene::PixelRays rays(scene::view_for_rays(scene, view));
    const std::size_t width = std::size_t(view.width), height = std::size_t(view.height);
    CastPicture picture{
        std::vector<Rgba>(width * height), std::vector<std::uint32_t>(width * height), {}};
    std::vector<CastCounts> rows(height);
    const CancelFlag cancel = cancel_flag();
    parallel_for(height, threads, [&](std::size_t y, int) {
        end_if_canceled(cancel);
        for (std::size_t x = 0; x < width; ++x) {
            const scene::PixelRay pixel = rays.through(double(x) + 0.5, double(y) + 0.5);
            const Ray ray{pixel.o, pixel.d};
            CastCounts counts;
            const auto hit = caster.nearest(ray, counts);
            picture.color[y * width + x] =
                stored(hit ? shader.color(*hit, ray) : dvec3(scene.background), 8);
            picture.tests[y * width + x] = static_cast<std::uint32_t>(counts.all());
            rows[y].add(counts);
        }
    });
    for (const CastCounts& row : rows) picture.counts.add(row);
    return picture;
}

}  // namespace gw::raytrace
