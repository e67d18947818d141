// A voxel grid [L12], walked along the ray as Amanatides and Woo 1987 do.
#include "raytrace/casting/cast_methods.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gw::raytrace {
namespace {

class Grid : public RayCaster {
public:
    explicit Grid(const ShapeTester& tester) : tester_(tester) {
        const auto& shapes = tester.shapes();
        if (shapes.empty()) return;
        for (const CastShape& s : shapes) box_.add(box_of(s));
        lay_out(shapes.size());
        for (std::size_t i = 0; i < shapes.size(); ++i) enter(box_of(shapes[i]), i);
    }

private:
    std::optional<CastHit> search(const Ray& ray, CastCounts& counts,
                                  std::vector<CastVisit>* visits) const override {
        ++counts.rays;
        std::optional<CastHit> hit;
        const auto in = voxels_.empty() ? std::nullopt : through(box_, ray);
        if (!in) return hit;
        Walk walk = begin(ray, in->from);
        for (;;) {
            ++counts.voxels;
            const std::vector<std::size_t>& here = voxels_[index(walk.at)];
            if (visits) visits->push_back({box_of_voxel(walk.at), here.size()});
            for (const std::size_t i : here) tester_.test(ray, i, hit, counts);
            // A shape reaches into other voxels: a hit beyond this voxel may not be the nearest.
            const int axis = walk.next[0] < walk.next[1] ? (walk.next[0] < walk.next[2] ? 0 : 2)
                                                         : (walk.next[1] < walk.next[2] ? 1 : 2);
            if (hit && hit->t < walk.next[std::size_t(axis)]) return hit;
            walk.at[std::size_t(axis)] += walk.step[std::size_t(axis)];
            if (walk.at[std::size_t(axis)] < 0 ||
                walk.at[std::size_t(axis)] >= counts_[std::size_t(axis)])
                return hit;
            walk.next[std::size_t(axis)] += walk.delta[std::size_t(axis)];
        }
    }

    /// The voxel; along each axis, the step to the next one, the t where that begins, and the t
    /// between two.
    struct Walk {
        std::array<int, 3> at{}, step{};
        std::array<double, 3> next{}, delta{};
    };

    /// About two voxels a shape, nearly cubes, at most 128 along an axis.
    void lay_out(std::size_t shapes) {
        const dvec3 size = box_.high - box_.low;
        const double longest = std::max({size.x, size.y, size.z, 1e-300});
        dvec3 side(0);
        for (int k = 0; k < 3; ++k) side[k] = std::max(size[k], 1e-3 * longest);
        double cells = 1;
        for (; cells < 128; ++cells) {
            double all = 1;
            for (int k = 0; k < 3; ++k) all *= std::max(1.0, std::floor(side[k] / longest * cells));
            if (all >= 2 * double(shapes)) break;
        }
        for (int k = 0; k < 3; ++k) {
            const double slack = 1e-6 * longest;
            box_.low[k] -= slack;
            box_.high[k] += slack;
            counts_[std::size_t(k)] = std::max(1, int(side[k] / longest * cells));
            voxel_[k] = (box_.high[k] - box_.low[k]) / counts_[std::size_t(k)];
        }
        voxels_.resize(std::size_t(counts_[0]) * std::size_t(counts_[1]) * std::size_t(counts_[2]));
    }

    int place(double p, int k) const {
        return std::clamp(int((p - box_.low[k]) / voxel_[k]), 0, counts_[std::size_t(k)] - 1);
    }
    std::size_t index(const std::array<int, 3>& at) const {
        return (std::size_t(at[2]) * std::size_t(counts_[1]) + std::size_t(at[1])) *
                   std::size_t(counts_[0]) +
               std::size_t(at[0]);
    }

    Box box_of_voxel(const std::array<int, 3>& at) const {
        const dvec3 low = box_.low + dvec3(at[0], at[1], at[2]) * voxel_;
        return {low, low + voxel_};
    }

    /// Into every voxel that its box touches, or nearly.
    void enter(const Box& box, std::size_t shape) {
        std::array<int, 3> low, high;
        for (int k = 0; k < 3; ++k) {
            low[std::size_t(k)] = place(box.low[k] - 1e-9 * voxel_[k], k);
            high[std::size_t(k)] = place(box.high[k] + 1e-9 * voxel_[k], k);
        }
        for (int z = low[2]; z <= high[2]; ++z)
            for (int y = low[1]; y <= high[1]; ++y)
                for (int x = low[0]; x <= high[0]; ++x) voxels_[index({x, y, z})].push_back(shape);
    }

    Walk begin(const Ray& ray, double from) const {
        constexpr double never = std::numeric_limits<double>::infinity();
        const dvec3 p = point_at(ray, from);
        Walk walk;
        for (int k = 0; k < 3; ++k) {
            const std::size_t a = std::size_t(k);
            const double d = ray.direction[k];
            walk.at[a] = place(p[k], k);
            walk.step[a] = d < 0 ? -1 : 1;
            const double border = box_.low[k] + voxel_[k] * (walk.at[a] + (d < 0 ? 0 : 1));
            walk.next[a] = d == 0 ? never : (border - ray.origin[k]) / d;
            walk.delta[a] = d == 0 ? never : voxel_[k] / std::abs(d);
        }
        return walk;
    }

    ShapeTester tester_;
    Box box_;
    std::array<int, 3> counts_{};
    dvec3 voxel_{0};
    std::vector<std::vector<std::size_t>> voxels_;
};

}  // namespace

std::unique_ptr<RayCaster> cast_by_grid(const ShapeTester& tester) {
    return std::make_unique<Grid>(tester);
}

}  // namespace gw::raytrace
