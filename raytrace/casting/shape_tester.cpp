#include "raytrace/casting/shape_tester.h"

namespace gw::raytrace {

Box box_of(const CastShape& s) {
    Box box;
    if (const auto* sphere = std::get_if<Sphere>(&s.shape)) {
        box.add(sphere->center - dvec3(sphere->radius));
        box.add(sphere->center + dvec3(sphere->radius));
    } else {
        for (const dvec3& p : std::get<PlanePolygon>(s.shape).corners) box.add(p);
    }
    return box;
}

void Asker::ask(const Ray& ray, std::size_t i, std::optional<CastHit>& nearest,
                CastCounts& counts) const {
    ++counts.shapes;
    const auto* sphere = std::get_if<Sphere>(&shapes_[i].shape);
    const auto t = sphere ? intersect(ray, *sphere)
                          : intersect(ray, std::get<PlanePolygon>(shapes_[i].shape), test_);
    if (!t) return;
    if (!nearest || *t < nearest->t || (*t == nearest->t && i < nearest->shape))
        nearest = CastHit{i, *t};
}

}  // namespace gw::raytrace
