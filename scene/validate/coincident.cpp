#include "scene/validate/coincident.h"

#include "scene/draw/corners.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace gw::scene {
namespace {

/// In parts of the largest coordinate: float32 coordinates of one plane may be off by this much.
constexpr double in_one_plane = 1e-6;
/// Comparisons of triangles; a scene that needs more is not searched further.
constexpr std::uint64_t most_comparisons = std::uint64_t{1} << 24;

struct Faces {
    std::size_t object = 0;
    Bounds box;
    std::size_t count = 0;
};

dvec3 unit_normal(const WorldCorners& c) { return normalized(cross3(c[1] - c[0], c[2] - c[0])); }

double reach(const Bounds& box) {
    double most = 0;
    for (int k = 0; k < 3; ++k)
        most = std::max({most, std::abs(box.low[k]), std::abs(box.high[k])});
    return most;
}

bool apart(const Bounds& a, const Bounds& b, double tolerance) {
    for (int k = 0; k < 3; ++k)
        if (a.low[k] > b.high[k] + tolerance || b.low[k] > a.high[k] + tolerance) return true;
    return false;
}

/// Whether the triangles share an area that is more than rounding: `b` is cut by a's sides.
bool overlap(const WorldCorners& a, const WorldCorners& b, const dvec3& normal, double tolerance) {
    std::vector<dvec3> piece(b.begin(), b.end()), cut;
    for (std::size_t side = 0; side < 3; ++side) {
        const dvec3& from = a[side];
        const dvec3 inwards = normalized(cross3(normal, a[(side + 1) % 3] - from));
        cut.clear();
        for (std::size_t i = 0; i < piece.size(); ++i) {
            const dvec3 &p = piece[i], &q = piece[(i + 1) % piece.size()];
            const double at_p = dot3(inwards, p - from) - tolerance,
                         at_q = dot3(inwards, q - from) - tolerance;
            if (at_p > 0) cut.push_back(p);
            if ((at_p > 0) != (at_q > 0)) cut.push_back(p + (q - p) * (at_p / (at_p - at_q)));
        }
        std::swap(piece, cut);
    }
    dvec3 area(0);
    for (std::size_t i = 2; i < piece.size(); ++i)
        area += cross3(piece[i - 1] - piece[0], piece[i] - piece[0]);
    return length(area) > tolerance * tolerance;
}

class Search {
public:
    explicit Search(const Scene& scene) : scene_(scene) {
        for (std::size_t i = 0; i < scene.objects.size(); ++i) {
            Faces faces{i, {}, scene.objects[i].mesh->triangles().size()};
            for (const Triangle& t : scene.objects[i].mesh->triangles())
                for (const dvec3& p : world_corners(scene.objects[i], t)) extend(faces.box, p);
            if (faces.count > 0) list_.push_back(faces);
        }
    }

    std::optional<std::pair<std::size_t, std::size_t>> first() {
        for (std::size_t a = 0; a < list_.size(); ++a)
            for (std::size_t b = a + 1; b < list_.size(); ++b) {
                if (++compared_ > most_comparisons) return std::nullopt;
                const Faces &x = list_[a], &y = list_[b];
                tolerance_ = in_one_plane * std::max(reach(x.box), reach(y.box));
                if (apart(x.box, y.box, tolerance_) || look_alike(x, y)) continue;
                if (x.count <= y.count ? meet(x, y) : meet(y, x))
                    return std::pair(x.object, y.object);
            }
        return std::nullopt;
    }

private:
    bool look_alike(const Faces& a, const Faces& b) const {
        const Object &x = scene_.objects[a.object], &y = scene_.objects[b.object];
        return x.material == y.material && x.pixmap.emission == y.pixmap.emission &&
               x.pixmap.lumen == y.pixmap.lumen;
    }

    bool meet(const Faces& small, const Faces& other) {
        if (small.count > most_faces_of_small) return false;
        const Object &x = scene_.objects[small.object], &y = scene_.objects[other.object];
        for (const Triangle& s : x.mesh->triangles()) {
            const WorldCorners a = world_corners(x, s);
            const dvec3 normal = unit_normal(a);
            if (normal == dvec3(0)) continue;
            for (const Triangle& t : y.mesh->triangles()) {
                if (++compared_ > most_comparisons) return false;
                const WorldCorners b = world_corners(y, t);
                const bool in_plane = std::ranges::all_of(b, [&](const dvec3& p) {
                    return std::abs(dot3(normal, p - a[0])) <= tolerance_;
                });
                if (in_plane && dot3(unit_normal(b), normal) > 0 &&
                    overlap(a, b, normal, tolerance_))
                    return true;
            }
        }
        return false;
    }

    const Scene& scene_;
    std::vector<Faces> list_;
    double tolerance_ = 0;  ///< of the two that are compared
    std::uint64_t compared_ = 0;
};

}  // namespace

std::optional<std::pair<std::size_t, std::size_t>> coincident_objects(const Scene& scene) {
    return Search(scene).first();
}

}  // namespace gw::scene
