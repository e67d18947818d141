#include "scene/draw/nearest.h"

#include "gw/base/elementary.h"
#include "gw/stages/vertex.h"
#include "scene/text/number.h"
#include "scene/text/suggest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <vector>

namespace gw::scene {
namespace {

/// Fitted planes leave this part of the scene's depth free on both sides.
constexpr double spared_margin = 1.0 / 64;
/// If something stands nearer than a 4096th of far, near is at least this part of far: 24 bits of
/// depth then tell what is a 500th of far behind the middle.
constexpr double least_spared_near = 1.0 / 65536;

/// The part of eye space that a window shows: |x| <= x0 + x1 d and |y| <= y0 + y1 d at distance d
/// along the line of sight.
struct Opening {
    double x0 = 0, x1 = 0, y0 = 0, y1 = 0;
};

Opening opening(const View& view) {
    const double aspect = double(view.width) / view.height;
    if (view.camera.ortho_height > 0) {
        const double y = view.camera.ortho_height / 2;
        return {.x0 = y * aspect, .y0 = y};
    }
    const double y = tan_degrees(view.camera.fov / 2);
    return {.x1 = y * aspect, .y1 = y};
}

/// How far from the eye moving objects get; the scene's box has them in the middle of their motion.
double farthest_moved(const Scene& scene, const dmat4& eye_from_world) {
    Bounds box;
    for (const Object& object : scene.objects) {
        if (object.move == dvec3(0)) continue;
        for (const vec3& p : object.mesh->data().positions)
            for (const double time : {-0.5, 0.5})
                extend(box,
                       dvec3(object.world_from_object * dvec4(dvec3(p), 1)) + object.move * time);
    }
    return box.empty ? 0 : depth_interval(box, eye_from_world).farthest;
}

/// Eye space with z as distance: positive before the eye.
dvec3 seen(const dmat4& eye_from_object, const vec3& p) {
    const dvec3 eye = transform3(dmat3(eye_from_object), dvec3(p)) + dvec3(eye_from_object[3]);
    return {eye.x, eye.y, -eye.z};
}

class Finder {
public:
    Finder(const Opening& opening, double limit, double edge_on)
        : o_(opening), limit_(limit), edge_on_(edge_on) {}

    /// The smallest distance of a mesh's parts in the opening, if it is below the limit.
    double of(const Mesh& mesh, const dmat4& eye_from_object) {
        points_.clear();
        bool any = false;
        for (const vec3& p : mesh.data().positions) {
            points_.push_back(seen(eye_from_object, p));
            any = any || points_.back().z < limit_;
        }
        double nearest = limit_;
        if (!any) return nearest;
        for (const Triangle& t : mesh.triangles())
            if (edge_on_ <= 0 || !is_edge_on(t)) look_at(t.vertex, nearest);
        for (const auto& line : mesh.lines()) look_at(line, nearest);
        for (const std::uint32_t point : mesh.points()) look_at(std::array{point}, nearest);
        return nearest;
    }

private:
    bool is_edge_on(const Triangle& t) const {
        const dvec3& a = points_[t.vertex[0]];
        const dvec3 n = cross3(points_[t.vertex[1]] - a, points_[t.vertex[2]] - a);
        return std::abs(dot3(n, a)) <= edge_on_ * length(n);
    }

    template <std::size_t N>
    void look_at(const std::array<std::uint32_t, N>& corners, double& nearest) {
        const auto distance = [&](std::uint32_t i) { return points_[i].z; };
        if (std::ranges::all_of(corners, [&](std::uint32_t i) { return distance(i) >= nearest; }) ||
            std::ranges::all_of(corners, [&](std::uint32_t i) { return distance(i) < 0; }))
            return;
        piece_.clear();
        for (const std::uint32_t i : corners) piece_.push_back(points_[i]);
        clip([](const dvec3& p) { return p.z; });
        clip([&](const dvec3& p) { return o_.x0 + o_.x1 * p.z - p.x; });
        clip([&](const dvec3& p) { return o_.x0 + o_.x1 * p.z + p.x; });
        clip([&](const dvec3& p) { return o_.y0 + o_.y1 * p.z - p.y; });
        clip([&](const dvec3& p) { return o_.y0 + o_.y1 * p.z + p.y; });
        for (const dvec3& p : piece_) nearest = std::min(nearest, p.z);
    }

    /// Sutherland and Hodgman; a segment is a polygon of two corners.
    template <class Inside>
    void clip(const Inside& inside) {
        std::vector<dvec3>& out = clipped_;
        out.clear();
        for (std::size_t i = 0; i < piece_.size(); ++i) {
            const dvec3 &a = piece_[i], &b = piece_[(i + 1) % piece_.size()];
            const double at_a = inside(a), at_b = inside(b);
            if (at_a >= 0) out.push_back(a);
            if ((at_a >= 0) != (at_b >= 0)) out.push_back(a + (b - a) * (at_a / (at_a - at_b)));
        }
        std::swap(piece_, out);
    }

    const Opening& o_;
    double limit_, edge_on_;
    std::vector<dvec3> points_, piece_, clipped_;
};

}  // namespace

Nearest nearest_in(const View& view, const Scene& scene, double limit, double edge_on) {
    Nearest nearest;
    const Opening window = opening(view);
    Finder finder(window, limit, edge_on);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        for (const double time : {0.0, -0.5, 0.5}) {
            if (time != 0 && object.move == dvec3(0)) continue;
            dmat4 world_from_object = object.world_from_object;
            world_from_object[3] += dvec4(object.move * time, 0);
            const double distance =
                finder.of(*object.mesh, view.eye_from_world * world_from_object);
            if (distance < std::min(limit, nearest.distance)) nearest = {i, distance};
        }
    }
    return nearest;
}

View sparing_near(const View& view, const Scene& scene, double edge_on) {
    const double near_plane = view.camera.near_plane, far_plane = view.camera.far_plane;
    const double nearest = nearest_in(view, scene, near_plane, edge_on).distance;
    if (nearest >= near_plane) return view;
    return with_planes(view, std::max(nearest * (1 - spared_margin), far_plane * least_spared_near),
                       far_plane);
}

double edge_on_in_map(const View& view) { return view.camera.far_plane * least_spared_near; }

View fitted_view(const Camera& camera, const Scene& scene, const Bounds& bounds, int width,
                 int height) {
    View view = make_view(camera, bounds, width, height);
    if (camera.far_plane <= 0) {
        const double farthest = farthest_moved(scene, view.eye_from_world);
        if (farthest > view.camera.far_plane)
            view = with_planes(view, view.camera.near_plane, farthest * (1 + spared_margin));
    }
    return camera.near_plane <= 0 ? sparing_near(view, scene) : view;
}

std::optional<Nearest> cut_by_near(const Scene& scene, const View& view) {
    if (scene.camera && scene.camera->near_plane > 0) return std::nullopt;
    const Nearest nearest = nearest_in(view, scene, view.camera.near_plane);
    return nearest.distance < view.camera.near_plane ? std::optional(nearest) : std::nullopt;
}

std::string near_warning(const Scene& scene, const View& view) {
    const auto cut = cut_by_near(scene, view);
    if (!cut) return {};
    const auto number = [](double value) { return number_text(std::round(value * 1e4) / 1e4); };
    return "object '" + printable(scene.objects[cut->object].name) +
           "' is cut off: it comes as near to the eye as " + number(cut->distance) +
           ", and depth reaches from " + number(view.camera.near_plane) + " to " +
           number(view.camera.far_plane) + "; expected a smaller far, or a renderer by rays";
}

View view_for_rays(const Scene& scene, const View& view) {
    const auto cut = cut_by_near(scene, view);
    if (!cut) return view;
    const double near_plane = std::max(cut->distance / 2, view.camera.far_plane * 0x1p-40);
    return with_planes(view, near_plane, view.camera.far_plane);
}

}  // namespace gw::scene
