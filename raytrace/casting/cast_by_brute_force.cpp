// Every shape is asked [L9].
#include "raytrace/casting/cast_methods.h"

namespace gw::raytrace {
namespace {

class BruteForce : public RayCaster {
public:
    explicit BruteForce(const Asker& asker) : asker_(asker) {}
    std::optional<CastHit> nearest(const Ray& ray, CastCounts& counts) const override {
        ++counts.rays;
        std::optional<CastHit> hit;
        for (std::size_t i = 0; i < asker_.shapes().size(); ++i) asker_.ask(ray, i, hit, counts);
        return hit;
    }

private:
    Asker asker_;
};

}  // namespace

std::unique_ptr<RayCaster> cast_by_brute_force(const Asker& asker) {
    return std::make_unique<BruteForce>(asker);
}

}  // namespace gw::raytrace
