#include "bench/radiosity/embree_hemicube.h"

#include "gw/error.h"
#include "tests/raytrace/embree_scene.h"

#include <algorithm>

namespace gw::bench {
namespace {

/// The facets' triangles, and the facet of each.
struct Triangles {
    std::vector<vec3> corners;
    std::vector<std::uint32_t> facets;

    explicit Triangles(const radiosity::PixmapModel& model) {
        for (std::uint32_t f = 0; f < model.facets.size(); ++f)
            for (const radiosity::Triangle2& triangle : model.facets[f].triangles) {
                for (const dvec2& uv : triangle) corners.push_back(vec3(model.facets[f].at(uv)));
                facets.push_back(f);
            }
    }
};

}  // namespace

struct EmbreeHemicube::Scene {
    const radiosity::PixmapModel& model;
    Triangles triangles;
    radiosity::DeltaFormFactors delta;
    raytrace::EmbreeScene embree;
    std::vector<RTCRayHit> rays;  ///< of a row of pixels
    std::vector<double> factors;
    std::vector<std::uint32_t> ids;

    Scene(const radiosity::PixmapModel& of, int size)
        : model(of),
          triangles(of),
          delta(radiosity::delta_form_factors(size)),
          embree(triangles.corners),
          rays(std::size_t(size)) {}

    void row(const radiosity::Hemicube& hemicube, const scene::View& view, int y,
             const double* deltas) {
        const dmat3 world_from_eye = glm::transpose(dmat3(view.eye_from_world));
        const double half = view.width * 0.5;
        for (std::size_t x = 0; x < rays.size(); ++x) {
            const vec3 way(transform3(
                world_from_eye, dvec3((double(x) + 0.5) / half - 1, (y + 0.5) / half - 1, -1)));
            const vec3 from(hemicube.position);
            RTCRayHit& r = rays[x];
            r.ray = {from.x, from.y, from.z, 0, way.x, way.y, way.z, 0, 3e38f, ~0u, 0, 0};
            r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        }
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        rtcIntersect1M(embree.scene(), &context, rays.data(), unsigned(rays.size()),
                       sizeof(RTCRayHit));
        for (std::size_t x = 0; x < rays.size(); ++x) {
            const RTCRayHit& r = rays[x];
            if (r.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
                ids.push_back(0);
                continue;
            }
            const std::uint32_t facet = triangles.facets[r.hit.primID];
            ids.push_back(facet + 1);
            add(model.facets[facet], hemicube.position,
                dvec3(r.ray.dir_x, r.ray.dir_y, r.ray.dir_z) * double(r.ray.tfar), deltas[x]);
        }
    }

    void add(const radiosity::Facet& facet, const dvec3& from, const dvec3& way, double value) {
        if (dot3(facet.normal, way) >= 0) return;  // its back
        const radiosity::Pixmap& pixmap = model.pixmaps[facet.pixmap];
        const dvec2 uv = facet.texel_of(from + way);
        const auto inside = [](double v, int count) {
            return std::clamp(static_cast<int>(v), 0, count - 1);
        };
        factors[pixmap.texel(inside(uv.x, pixmap.width), inside(uv.y, pixmap.height))] += value;
    }
};

EmbreeHemicube::EmbreeHemicube(const radiosity::PixmapModel& model, int size)
    : scene_(std::make_unique<Scene>(model, size)) {}
EmbreeHemicube::~EmbreeHemicube() = default;

void EmbreeHemicube::gather(const radiosity::Hemicube& hemicube) {
    scene_->factors.assign(scene_->model.texel_count(), 0);
    scene_->ids.clear();
    for (std::size_t face = 0; face < radiosity::hemicube_faces; ++face) {
        const scene::View& view = hemicube.views[face];
        const int first = face == 0 ? 0 : view.height / 2;
        const std::vector<double>& deltas = face == 0 ? scene_->delta.top : scene_->delta.side;
        for (int y = first; y < view.height; ++y)
            scene_->row(hemicube, view, y,
                        &deltas[std::size_t(y - first) * std::size_t(view.width)]);
    }
}

const std::vector<double>& EmbreeHemicube::factors() const { return scene_->factors; }
const std::vector<std::uint32_t>& EmbreeHemicube::ids() const { return scene_->ids; }

}  // namespace gw::bench
