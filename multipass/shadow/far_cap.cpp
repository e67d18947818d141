#include "multipass/shadow/far_cap.h"

#include "gw/stages/vertex.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gw::multipass {
namespace {

/// If it moves by the reach, a point light's far cap is a polyhedron about the light whose edges
/// span at most 60 degrees. Its faces are nearer to the light than its corners, by a factor of more
/// than 0.8.
constexpr double corner_reach = 1.3;

double beyond(const dvec4& wall, const dvec3& p) { return dot3(dvec3(wall), p) + wall.w; }

std::array<dvec4, 6> walls_of(const scene::Bounds& bounds, const dmat4& world_from_object) {
    std::array<dvec4, 6> walls;
    for (int k = 0; k < 3; ++k) {
        const dvec4 row(world_from_object[0][k], world_from_object[1][k], world_from_object[2][k],
                        world_from_object[3][k]);
        walls[std::size_t(2 * k)] = dvec4(0, 0, 0, bounds.low[k]) - row;
        walls[std::size_t(2 * k + 1)] = row - dvec4(0, 0, 0, bounds.high[k]);
    }
    return walls;
}

/// The direction in which a point is moved: p + t * direction.
dvec3 extrusion_of(const LightInObject& light, const dvec3& p) {
    return light.directional ? light.position : p - light.position;
}

/// t of a point that is moved by the reach. A point in the light stays.
double t_of_reach(const LightInObject& light, const dvec3& p) {
    if (light.directional) return light.reach - dot3(light.position, p);
    const double distance = length(p - light.position);
    return distance > 0 ? light.reach * corner_reach / distance - 1 : 0;
}

/// The path of a point beyond the walls of the bounds, one after the other.
class ExtrusionPath {
public:
    ExtrusionPath(const LightInObject& light, const vec3& p)
        : light_(&light), p_(p), direction_(extrusion_of(light, p_)), end_(t_of_reach(light, p_)) {
        move_on();
    }
    bool at_end() const { return t_ == end_; }
    /// Beyond the next wall, or by the reach.
    void move_on() {
        t_ = next();
        moved_ = at_end() ? moved_by_reach(*light_, p_) : vec3(p_ + t_ * direction_);
        walls_ = walls_before(*light_, dvec3(moved_));
    }
    void move_to_end() {
        while (!at_end()) move_on();
    }
    /// The length of the next step; infinite at the end.
    double step() const {
        return at_end() ? std::numeric_limits<double>::infinity()
                        : (next() - t_) * length(direction_);
    }
    const vec3& moved() const { return moved_; }
    unsigned walls() const { return walls_; }

private:
    double next() const {
        double next = end_;
        for (const dvec4& wall : light_->walls) {
            const double slope = dot3(dvec3(wall), direction_);
            const double t = slope > 0 ? (light_->margin - beyond(wall, p_)) / slope : end_;
            if (t > t_ && t < next) next = t;
        }
        return next;
    }

    const LightInObject* light_;
    dvec3 p_, direction_;
    double t_ = -std::numeric_limits<double>::infinity(), end_;
    vec3 moved_{0};
    unsigned walls_ = 0;
};

/// The points of the far cap on their paths.
class ExtrusionPaths {
public:
    ExtrusionPaths(const Topology& topology, const LightInObject& light, std::span<const int> part)
        : topology_(topology), light_(light), number_(topology.points.size(), none) {
        for (std::size_t i = 0; i < part.size(); ++i)
            if (part[i] != 0) {
                triangles_.push_back(&topology.triangles[i]);
                for (const std::uint32_t point : topology.triangles[i]) start(point);
            }
    }

    /// A wide triangle is split when it is drawn: all of it moves by the reach.
    void end_wide_ones() {
        for (const Triangle* t : triangles_)
            for (std::size_t k = 0; k < 3; ++k)
                if (is_wide(light_, dvec3(topology_.points[(*t)[k]]),
                            dvec3(topology_.points[(*t)[(k + 1) % 3]])))
                    for (const std::uint32_t point : *t) path(point).move_to_end();
    }
    /// Moves points until every triangle is beyond one wall, or at the end: of its corners the one
    /// with the shortest step.
    void move_on() {
        for (bool moved = true; moved;) {
            moved = false;
            for (const Triangle* t : triangles_)
                for (; walls(*t) == 0; moved = true) {
                    ExtrusionPath& path = nearest_next(*t);
                    if (path.at_end()) break;
                    path.move_on();
                }
        }
    }

    FarCap cap() const {
        FarCap cap{std::vector<vec3>(topology_.points.size()), {}};
        for (std::size_t i = 0; i < number_.size(); ++i)
            if (number_[i] != none) cap.moved[i] = paths_[number_[i]].moved();
        for (const Triangle* t : triangles_) cap.walls.set(walls(*t));
        return cap;
    }

private:
    using Triangle = std::array<std::uint32_t, 3>;
    static constexpr std::uint32_t none = ~0u;

    void start(std::uint32_t point) {
        if (number_[point] != none) return;
        number_[point] = std::uint32_t(paths_.size());
        paths_.emplace_back(light_, topology_.points[point]);
    }
    ExtrusionPath& nearest_next(const Triangle& t) {
        const std::uint32_t least = *std::min_element(
            t.begin(), t.end(),
            [&](std::uint32_t a, std::uint32_t b) { return path(a).step() < path(b).step(); });
        return path(least);
    }
    ExtrusionPath& path(std::uint32_t point) { return paths_[number_[point]]; }
    unsigned walls(const Triangle& t) const {
        return paths_[number_[t[0]]].walls() & paths_[number_[t[1]]].walls() &
               paths_[number_[t[2]]].walls();
    }

    const Topology& topology_;
    const LightInObject& light_;
    std::vector<std::uint32_t> number_;  ///< of its path, by point
    std::vector<ExtrusionPath> paths_;
    std::vector<const Triangle*> triangles_;
};

}  // namespace

LightInObject light_in_object(const scene::Light& light, const dmat4& world_from_object,
                              const scene::Bounds& bounds) {
    const dmat4 object_from_world = glm::inverse(world_from_object);
    LightInObject out{.directional = light.kind == scene::LightKind::Directional};
    if (out.directional) {
        const dvec3 direction = transform3(dmat3(object_from_world), dvec3(light.direction));
        out.position = direction / length(direction);
    } else {
        out.position = transform3(dmat3(object_from_world), dvec3(light.position)) +
                       dvec3(object_from_world[3]);
    }
    for (int i = 0; i < 8; ++i) {
        const dvec3 p =
            transform3(dmat3(object_from_world), corner(bounds, i)) + dvec3(object_from_world[3]);
        const double r = out.directional ? dot3(out.position, p) : length(p - out.position);
        out.reach = i == 0 ? r : std::max(out.reach, r);
    }
    // A little farther than everything.
    constexpr double more = 0.01;
    const dvec3 diagonal = bounds.high - bounds.low;
    out.reach += more * length(transform3(dmat3(object_from_world), diagonal));
    out.walls = walls_of(bounds, world_from_object);
    out.margin = more * length(diagonal);
    return out;
}

unsigned walls_before(const LightInObject& light, const dvec3& p) {
    unsigned bits = 0;
    for (std::size_t k = 0; k < light.walls.size(); ++k)
        bits |= beyond(light.walls[k], p) > light.margin / 2 ? 1u << k : 0;
    return bits;
}

bool is_wide(const LightInObject& light, const dvec3& a, const dvec3& b) {
    if (light.directional) return false;
    const dvec3 to_a = a - light.position, to_b = b - light.position;
    const double cosine = dot3(to_a, to_b);  // times both lengths
    return cosine < 0 || 4 * cosine * cosine < dot3(to_a, to_a) * dot3(to_b, to_b);
}

vec3 moved_by_reach(const LightInObject& light, const dvec3& p) {
    return vec3(p + t_of_reach(light, p) * extrusion_of(light, p));
}

FarCap far_cap(const Topology& topology, const LightInObject& light, std::span<const int> part) {
    ExtrusionPaths paths(topology, light, part);
    paths.end_wide_ones();
    paths.move_on();
    return paths.cap();
}

}  // namespace gw::multipass
