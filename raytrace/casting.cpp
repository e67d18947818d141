#include "raytrace/casting.h"

#include "gw/vertex.h"
#include "raytrace/box.h"

#include <array>
#include <numeric>

namespace gw::raytrace {
namespace {

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

/// What all methods share: asking one shape, keeping the nearest.
class Asker {
public:
    Asker(const std::vector<CastShape>& shapes, InsideTest test) : shapes_(shapes), test_(test) {}

    void ask(const Ray& ray, std::size_t i, std::optional<CastHit>& nearest, CastCounts& counts) const {
        ++counts.shapes;
        const auto* sphere = std::get_if<Sphere>(&shapes_[i].shape);
        const auto t = sphere ? intersect(ray, *sphere)
                              : intersect(ray, std::get<PlanePolygon>(shapes_[i].shape), test_);
        if (!t) return;
        if (!nearest || *t < nearest->t || (*t == nearest->t && i < nearest->shape)) nearest = CastHit{i, *t};
    }

    const std::vector<CastShape>& shapes() const { return shapes_; }

private:
    const std::vector<CastShape>& shapes_;
    InsideTest test_;
};

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

/// Shapes of one object follow each other.
class BoundingVolumes : public RayCaster {
public:
    explicit BoundingVolumes(const Asker& asker) : asker_(asker) {
        const auto& shapes = asker.shapes();
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
            for (std::size_t i = volume.first; i < volume.last; ++i) asker_.ask(ray, i, hit, counts);
        }
        return hit;
    }

private:
    struct Volume {
        Box box;
        std::size_t first = 0, last = 0;
    };
    Asker asker_;
    std::vector<Volume> volumes_;
};

class BoxHierarchy : public RayCaster {
public:
    explicit BoxHierarchy(const Asker& asker) : asker_(asker), order_(asker.shapes().size()) {
        std::iota(order_.begin(), order_.end(), std::size_t{0});
        for (const CastShape& s : asker.shapes()) boxes_.push_back(box_of(s));
        if (!order_.empty()) build(0, order_.size());
    }
    std::optional<CastHit> nearest(const Ray& ray, CastCounts& counts) const override {
        ++counts.rays;
        std::optional<CastHit> hit;
        if (!nodes_.empty()) search(0, ray, hit, counts);
        return hit;
    }

private:
    static constexpr std::size_t most_in_leaf = 4;
    struct Node {
        Box box;
        std::size_t first = 0, last = 0;
        std::size_t left = 0, right = 0;  ///< 0: a leaf
    };

    std::size_t build(std::size_t first, std::size_t last) {
        const std::size_t index = nodes_.size();
        nodes_.push_back({{}, first, last});
        Box box;
        for (std::size_t i = first; i < last; ++i) box.add(boxes_[order_[i]]);
        nodes_[index].box = box;
        if (last - first <= most_in_leaf) return index;
        int axis = 0;
        for (int k = 1; k < 3; ++k)
            if (box.high[k] - box.low[k] > box.high[axis] - box.low[axis]) axis = k;
        const auto middle = [&](std::size_t i) { return boxes_[i].low[axis] + boxes_[i].high[axis]; };
        std::stable_sort(order_.begin() + std::ptrdiff_t(first), order_.begin() + std::ptrdiff_t(last),
                         [&](std::size_t a, std::size_t b) { return middle(a) < middle(b); });
        const std::size_t left = build(first, (first + last) / 2), right = build((first + last) / 2, last);
        nodes_[index].left = left;
        nodes_[index].right = right;
        return index;
    }

    void search(std::size_t index, const Ray& ray, std::optional<CastHit>& hit, CastCounts& counts) const {
        const Node& node = nodes_[index];
        ++counts.boxes;
        const auto in = through(node.box, ray);
        if (!in || (hit && in->from > hit->t)) return;
        if (node.left == 0) {
            for (std::size_t i = node.first; i < node.last; ++i) asker_.ask(ray, order_[i], hit, counts);
            return;
        }
        search(node.left, ray, hit, counts);
        search(node.right, ray, hit, counts);
    }

    Asker asker_;
    std::vector<std::size_t> order_;
    std::vector<Box> boxes_;
    std::vector<Node> nodes_;
};

class Grid : public RayCaster {
public:
    explicit Grid(const Asker& asker) : asker_(asker) {
        const auto& shapes = asker.shapes();
        if (shapes.empty()) return;
        for (const CastShape& s : shapes) box_.add(box_of(s));
        lay_out(shapes.size());
        for (std::size_t i = 0; i < shapes.size(); ++i) enter(box_of(shapes[i]), i);
    }

    std::optional<CastHit> nearest(const Ray& ray, CastCounts& counts) const override {
        ++counts.rays;
        std::optional<CastHit> hit;
        const auto in = voxels_.empty() ? std::nullopt : through(box_, ray);
        if (!in) return hit;
        Walk walk = begin(ray, in->from);
        for (;;) {
            ++counts.voxels;
            for (const std::size_t i : voxels_[index(walk.at)]) asker_.ask(ray, i, hit, counts);
            // A shape reaches into other voxels: what is met beyond this one may not be the nearest.
            const int axis = walk.next[0] < walk.next[1] ? (walk.next[0] < walk.next[2] ? 0 : 2)
                                                         : (walk.next[1] < walk.next[2] ? 1 : 2);
            if (hit && hit->t < walk.next[std::size_t(axis)]) return hit;
            walk.at[std::size_t(axis)] += walk.step[std::size_t(axis)];
            if (walk.at[std::size_t(axis)] < 0 || walk.at[std::size_t(axis)] >= counts_[std::size_t(axis)])
                return hit;
            walk.next[std::size_t(axis)] += walk.delta[std::size_t(axis)];
        }
    }

private:
    /// The voxel, which way to the next along each axis, the t where it begins, the t between two.
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
        return (std::size_t(at[2]) * std::size_t(counts_[1]) + std::size_t(at[1])) * std::size_t(counts_[0]) +
               std::size_t(at[0]);
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

    Asker asker_;
    Box box_;
    std::array<int, 3> counts_{};
    dvec3 voxel_{0};
    std::vector<std::vector<std::size_t>> voxels_;
};

/// The corners of every polygon of a mesh.
std::vector<std::vector<std::uint32_t>> polygons_of(const Mesh& mesh) {
    const MeshData& data = mesh.data();
    std::vector<std::vector<std::uint32_t>> polygons;
    const auto corner = [&](std::size_t i) {
        return data.indices.empty() ? std::uint32_t(i) : data.indices[i];
    };
    if (data.primitive == Primitive::Quads || data.primitive == Primitive::Polygons) {
        std::size_t next = 0;
        for (std::uint32_t i = 0; i < mesh.polygon_count(); ++i) {
            const std::size_t all = data.indices.empty() ? data.positions.size() : data.indices.size();
            const std::size_t n = data.primitive == Primitive::Quads ? 4
                                  : data.polygon_sizes.empty()       ? all
                                                                     : data.polygon_sizes[i];
            polygons.emplace_back();
            for (std::size_t k = 0; k < n; ++k) polygons.back().push_back(corner(next + k));
            next += n;
        }
        return polygons;
    }
    for (const Triangle& t : mesh.triangles()) polygons.push_back({t.vertex.begin(), t.vertex.end()});
    return polygons;
}

/// The radius of the sphere around the origin that the mesh stands for: its vertices lie on it, and have its
/// normals. None: it does not, or has too few vertices to say so.
std::optional<double> radius_of(const Mesh& mesh) {
    constexpr std::size_t fewest = 12;
    constexpr double rounding = 1e-5;
    const auto& p = mesh.data().positions;
    const auto& n = mesh.data().normals;
    if (p.size() < fewest || n.size() != p.size()) return std::nullopt;
    const double radius = std::sqrt(dot3(dvec3(p[0]), dvec3(p[0])));
    for (std::size_t i = 0; i < p.size(); ++i) {
        const dvec3 away = dvec3(p[i]) - radius * normalized(dvec3(n[i]));
        if (!(dot3(away, away) <= rounding * rounding * radius * radius)) return std::nullopt;
    }
    return radius;
}

/// The object as a sphere, where it is one.
std::optional<Sphere> sphere_of(const scene::Object& object) {
    const dmat4& m = object.world_from_object;
    const double scale = dot3(dvec3(m[0]), dvec3(m[0]));
    for (int k = 1; k < 3; ++k)
        if (std::abs(dot3(dvec3(m[k]), dvec3(m[k])) - scale) > 1e-9 * scale) return std::nullopt;
    const auto radius = radius_of(*object.mesh);
    if (!radius) return std::nullopt;
    return Sphere{dvec3(m[3]), *radius * std::sqrt(scale)};
}

}  // namespace

std::vector<CastShape> cast_shapes(const scene::Scene& scene) {
    std::vector<CastShape> shapes;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const scene::Object& object = scene.objects[i];
        if (const auto sphere = sphere_of(object)) {
            shapes.push_back({*sphere, i});
            continue;
        }
        for (const auto& polygon : polygons_of(*object.mesh)) {
            std::vector<dvec3> corners;
            for (const std::uint32_t v : polygon)
                corners.push_back(dvec3(
                    transform(object.world_from_object, dvec4(dvec3(object.mesh->data().positions[v]), 1))));
            shapes.push_back({plane_polygon(std::move(corners)), i});
        }
    }
    return shapes;
}

std::unique_ptr<RayCaster> make_caster(CastMethod method, const std::vector<CastShape>& shapes,
                                       InsideTest test) {
    const Asker asker(shapes, test);
    switch (method) {
        case CastMethod::BruteForce: return std::make_unique<BruteForce>(asker);
        case CastMethod::BoundingVolumes: return std::make_unique<BoundingVolumes>(asker);
        case CastMethod::Hierarchy: return std::make_unique<BoxHierarchy>(asker);
        case CastMethod::Grid: return std::make_unique<Grid>(asker);
    }
    return nullptr;
}

}  // namespace gw::raytrace
