#include "raytrace/casting/casting.h"

#include "raytrace/casting/cast_methods.h"

namespace gw::raytrace {
namespace {

class BruteForce : public RayCaster {
public:
    explicit BruteForce(const ShapeTester& tester) : tester_(tester) {}
    std::optional<CastHit> nearest(const Ray& ray, CastCounts& counts) const override {
        ++counts.rays;
        std::optional<CastHit> hit;
        for (std::size_t i = 0; i < tester_.shapes().size(); ++i) tester_.test(ray, i, hit, counts);
        return hit;
    }

private:
    ShapeTester tester_;
};

}  // namespace

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

void ShapeTester::test(const Ray& ray, std::size_t i, std::optional<CastHit>& nearest,
                       CastCounts& counts) const {
    ++counts.shapes;
    const auto* sphere = std::get_if<Sphere>(&shapes_[i].shape);
    const auto t = sphere ? intersect(ray, *sphere)
                          : intersect(ray, std::get<PlanePolygon>(shapes_[i].shape), test_);
    if (!t) return;
    if (!nearest || *t < nearest->t || (*t == nearest->t && i < nearest->shape))
        nearest = CastHit{i, *t};
}

std::unique_ptr<RayCaster> cast_by_brute_force(const ShapeTester& tester) {
    return std::make_unique<BruteForce>(tester);
}

std::unique_ptr<RayCaster> make_caster(CastMethod method, const std::vector<CastShape>& shapes,
                                       InsideTest test) {
    const ShapeTester tester(shapes, test);
    switch (method) {
        case CastMethod::BruteForce: return cast_by_brute_force(tester);
        case CastMethod::BoundingVolumes: return cast_by_volumes(tester);
        case CastMethod::Hierarchy: return cast_by_hierarchy(tester);
        case CastMethod::Grid: return cast_by_grid(tester);
    }
    return nullptr;
}

}  // namespace gw::raytrace
