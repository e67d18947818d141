#include "hiddensurface/structures/octree.h"

#include "gw/stages/vertex.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace gw::hiddensurface {
namespace {

constexpr int deepest = 10;

class OctreeBuilder {
public:
    OctreeBuilder(const std::vector<Polygon>& polygons, std::size_t few)
        : polygons_(polygons), few_(few) {}

    std::unique_ptr<Cube> cube(const dvec3& low, const dvec3& high, std::vector<std::size_t> inside,
                               int depth) const {
        if (inside.empty()) return nullptr;
        auto cube = std::make_unique<Cube>();
        cube->low = low;
        cube->high = high;
        if (inside.size() <= few_ || depth == deepest) {
            cube->polygons = std::move(inside);
            return cube;
        }
        const dvec3 middle = 0.5 * (low + high);
        std::array<std::vector<std::size_t>, 8> parts;
        for (const std::size_t i : inside) {
            const std::size_t part = part_of(polygons_[i].world, middle);
            (part < 8 ? parts[part] : cube->polygons).push_back(i);
        }
        for (std::size_t k = 0; k < 8; ++k) {
            dvec3 a = low, b = middle;
            for (int axis = 0; axis < 3; ++axis)
                if (k >> axis & 1) {
                    a[axis] = middle[axis];
                    b[axis] = high[axis];
                }
            cube->parts[k] = this->cube(a, b, std::move(parts[k]), depth + 1);
        }
        return cube;
    }

private:
    /// The part that has all of the polygon; 8: no single part.
    static std::size_t part_of(const Loop& loop, const dvec3& middle) {
        std::size_t part = 0;
        for (int axis = 0; axis < 3; ++axis) {
            bool lower = false, upper = false;
            for (const dvec3& p : loop) (p[axis] < middle[axis] ? lower : upper) = true;
            if (lower && upper) return 8;
            part += upper ? std::size_t{1} << axis : 0;
        }
        return part;
    }

    const std::vector<Polygon>& polygons_;
    std::size_t few_;
};

}  // namespace

std::unique_ptr<Cube> build_octree(const std::vector<Polygon>& polygons, std::size_t few) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    dvec3 low(infinity), high(-infinity);
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        if (!polygons[i].visible()) continue;
        all.push_back(i);
        for (const dvec3& p : polygons[i].world)
            for (int axis = 0; axis < 3; ++axis) {
                low[axis] = std::min(low[axis], p[axis]);
                high[axis] = std::max(high[axis], p[axis]);
            }
    }
    return OctreeBuilder(polygons, few).cube(low, high, std::move(all), 0);
}

std::array<std::size_t, 8> near_to_far(const Cube& cube, const dvec4& eye) {
    std::size_t nearest = 0;
    for (int axis = 0; axis < 3; ++axis)
        if (eye[axis] > 0.5 * (cube.low[axis] + cube.high[axis]) * eye.w)
            nearest += std::size_t{1} << axis;
    std::array<std::size_t, 8> order{0, 1, 2, 4, 3, 5, 6, 7};  // by the middle planes between
    for (std::size_t& part : order) part ^= nearest;
    return order;
}

WindowBox window_box(const dvec3& low, const dvec3& high, const scene::View& view,
                     const Profile& profile) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double x0 = infinity, y0 = infinity, z0 = infinity, x1 = -infinity, y1 = -infinity;
    for (int k = 0; k < 8; ++k) {
        const dvec4 world(k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z,
                          1);
        const dvec4 p = transform(view.clip_from_eye, transform(view.eye_from_world, world));
        if (p.z < -p.w || p.w <= 0) return {{0, 0, view.width, view.height}, 0};
        x0 = std::min(x0, p.x / p.w);
        x1 = std::max(x1, p.x / p.w);
        y0 = std::min(y0, p.y / p.w);
        y1 = std::max(y1, p.y / p.w);
        z0 = std::min(z0, p.z / p.w);
    }
    // One pixel more on every side, and two units of depth: the snap and rounding move less.
    const auto pixel = [](double ndc, int size, int more) {
        return static_cast<int>(
            std::clamp(std::floor((ndc + 1) / 2 * size) + more, 0.0, double(size)));
    };
    const int left = pixel(x0, view.width, -1), bottom = pixel(y0, view.height, -1);
    const double largest = double((std::uint64_t{1} << profile.depth_bits) - 1);
    return {{left, bottom, pixel(x1, view.width, 2) - left, pixel(y1, view.height, 2) - bottom},
            static_cast<std::int64_t>(
                std::clamp(std::floor((z0 + 1) / 2 * largest) - 2, 0.0, largest))};
}

}  // namespace gw::hiddensurface
