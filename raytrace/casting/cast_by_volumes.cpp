// A box around every object [L12].
#include "raytrace/casting/cast_methods.h"

namespace gw::raytrace {
namespace {

/// Shapes of one object follow each other.
class BoundingVolumes : public RayCaster {
public:
    explicit BoundingVolumes(const ShapeTester& tester) : tester_(tester) {
        const auto& shapes = tester.shapes();
        for (std::size_t i = 0; i < shapes.size(); ++i) {
            if (i == 0 || shapes[i].object != shapes[i - 1].object) volumes_.push_back({{}, i, i});
            volumes_.back().box.add(box_of(shapes[i]));
            volumes_.back().last = i + 1;
        }
    }
    std::optional<CastHit> nearest(const Ray& ray, CastCounts& counts) const override {
        ++counts.rays;
        std::optional<CastHit> hit;
        for (const Volume& volume : volumes_) {
            ++counts.boxes;
            const auto in = through(volume.box, ray);
            if (!in || (hit && in->from > hit->t)) continue;
            for (std::size_t i = volume.first; i < volume.last; ++i)
                tester_.test(ray, i, hit, counts);
        }
        return hit;
    }

private:
    struct Volume {
        Box box;
        std::size_t first = 0, last = 0;
    };
    ShapeTester tester_;
    std::vector<Volume> volumes_;
};

}  // namespace

std::unique_ptr<RayCaster> cast_by_volumes(const ShapeTester& tester) {
    return std::make_unique<BoundingVolumes>(tester);
}

}  // namespace gw::raytrace
