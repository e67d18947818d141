#include "scene/obj/normals.h"

#include "gw/base/cancel.h"
#include "gw/base/elementary.h"
#include "gw/stages/vertex.h"
#include "scene/geometry/weld.h"

#include <algorithm>
#include <span>
#include <unordered_map>

namespace gw::scene {
namespace {

bool is_zero(const dvec3& v) { return v == dvec3(0); }

constexpr std::size_t points_between_looks = 4096;

// Twice the area times the normal of the polygon's mean plane, concave ones included (Newell's sum
// about its first corner).
dvec3 area_vector(const ObjData& obj, const Element& face) {
    const auto position = [&](std::uint32_t i) {
        return obj.positions[obj.corners[face.first + i].v];
    };
    const dvec3 origin = position(0);
    dvec3 sum(0);
    for (std::uint32_t i = 1; i + 1 < face.count; ++i)
        sum += cross3(position(i) - origin, position(i + 1) - origin);
    return sum;
}

struct FaceNormal {
    dvec3 area, normal;  ///< normal: unit, or 0 for a face without area
    std::int32_t smoothing;
};

// A corner that meets others at one point.
struct Meeting {
    std::uint32_t corner, face;
};

class Normals {
public:
    Normals(ObjData& obj, double crease)
        : obj_(obj), cos_crease_(cos_degrees(crease)), cos_half_crease_(cos_degrees(crease / 2)) {}

    const Element* add() {
        if (!find_corners()) return nullptr;
        find_faces();
        meet();
        for (std::size_t i = 0; i + 1 < begin_.size(); ++i) {
            if (i % points_between_looks == 0) end_if_canceled();
            if (begin_[i] < begin_[i + 1])
                smooth(std::span(meetings_).subspan(begin_[i], begin_[i + 1] - begin_[i]));
        }
        return left_flat_;
    }

private:
    static bool is_face(const Element& element) { return element.count >= 3; }

    // Removes normals of length 0; returns whether any corner of a face is without one.
    bool find_corners() {
        bool any = false;
        for (const Element& element : obj_.elements)
            for (Corner& corner : std::span(obj_.corners).subspan(element.first, element.count)) {
                if (corner.vn != absent && obj_.normals[corner.vn] == vec3(0)) corner.vn = absent;
                any |= is_face(element) && corner.vn == absent;
            }
        return any;
    }

    void find_faces() {
        faces_.reserve(obj_.elements.size());
        for (const Element& element : obj_.elements) {
            const dvec3 area = is_face(element) ? area_vector(obj_, element) : dvec3(0);
            faces_.push_back({area, normalized(area), element.smoothing});
        }
    }

    // Lists the corners of faces by the point they are at: [begin_[p], begin_[p + 1]) of meetings_,
    // in file order.
    void meet() {
        const std::vector<std::uint32_t> point = weld(obj_.positions);
        begin_.assign(point.size() + 1, 0);
        for_each_corner([&](std::uint32_t, std::uint32_t corner) {
            ++begin_[point[obj_.corners[corner].v] + 1];
        });
        for (std::size_t p = 0; p < point.size(); ++p) begin_[p + 1] += begin_[p];
        std::vector<std::uint32_t> at = begin_;
        meetings_.resize(begin_.back());
        for_each_corner([&](std::uint32_t face, std::uint32_t corner) {
            meetings_[at[point[obj_.corners[corner].v]]++] = {corner, face};
        });
    }
    template <typename Visit>
    void for_each_corner(const Visit& visit) const {
        for (std::uint32_t e = 0; e < obj_.elements.size(); ++e)
            for (std::uint32_t i = 0; is_face(obj_.elements[e]) && i < obj_.elements[e].count; ++i)
                visit(e, obj_.elements[e].first + i);
    }

    bool smooth_together(const FaceNormal& a, const FaceNormal& b) const {
        if (a.smoothing != b.smoothing || a.smoothing == smooth_off) return false;
        return a.smoothing != smooth_by_angle || dot3(a.normal, b.normal) >= cos_crease_;
    }

    // The one sum for all corners if the faces at a point are one smooth surface; else 0. Avoids
    // comparing pairs: faces within half the crease angle of their mean are within the angle of
    // each other.
    dvec3 common_sum(std::span<const Meeting> meetings) const {
        const std::int32_t smoothing = faces_[meetings[0].face].smoothing;
        dvec3 sum(0);
        for (const Meeting& m : meetings) {
            if (faces_[m.face].smoothing != smoothing || smoothing == smooth_off) return dvec3(0);
            sum += faces_[m.face].area;
        }
        const dvec3 mean = normalized(sum);
        for (const Meeting& m : meetings)
            if (smoothing == smooth_by_angle &&
                !(dot3(faces_[m.face].normal, mean) >= cos_half_crease_))
                return dvec3(0);
        return sum;
    }

    // The sum of each smoothing group at a point is the same for all faces of the group.
    void sum_groups(std::span<const Meeting> meetings) {
        groups_.clear();
        all_ = dvec3(0);
        for (const Meeting& m : meetings) {
            const FaceNormal& face = faces_[m.face];
            all_ += face.area;
            if (face.smoothing > 0)
                groups_.try_emplace(face.smoothing, 0).first->second += face.area;
        }
    }

    // Compares pairs of faces only if they are smooth by angle. Of very many, each stays flat.
    dvec3 sum_at(std::span<const Meeting> meetings, std::uint32_t own) {
        const FaceNormal& face = faces_[own];
        if (is_zero(face.normal)) return all_;
        if (face.smoothing > 0) return groups_.at(face.smoothing);
        if (face.smoothing == smooth_off) return face.area;
        if (meetings.size() > most_compared) {
            if (!left_flat_) left_flat_ = &obj_.elements[own];
            return face.area;
        }
        dvec3 sum(0);
        for (const Meeting& other : meetings)
            if (other.face == own || smooth_together(face, faces_[other.face]))
                sum += faces_[other.face].area;
        return sum;
    }

    // If the sum is 0, opposite faces cancelled out: each takes its own normal.
    vec3 normal_of(const dvec3& sum, std::uint32_t own) const {
        dvec3 normal = normalized(sum);
        if (is_zero(normal)) normal = faces_[own].normal;
        if (is_zero(normal)) normal = {0, 0, 1};
        return vec3(normal);
    }

    void smooth(std::span<const Meeting> meetings) {
        const std::size_t first = obj_.normals.size();
        const dvec3 common = normalized(common_sum(meetings));
        std::uint32_t common_index = absent;
        if (is_zero(common)) sum_groups(meetings);
        for (const Meeting& meeting : meetings) {
            Corner& corner = obj_.corners[meeting.corner];
            if (corner.vn != absent) continue;
            if (is_zero(common)) {
                corner.vn =
                    index_of(normal_of(sum_at(meetings, meeting.face), meeting.face), first);
                continue;
            }
            if (common_index == absent) common_index = index_of(vec3(common), first);
            corner.vn = common_index;
        }
    }

    // Equal normals at one point (they begin at `first`) share one vn, so that the corners stay one
    // vertex. Looks at no more than the latest 64.
    std::uint32_t index_of(const vec3& normal, std::size_t first) {
        const std::size_t size = obj_.normals.size();
        for (std::size_t i = std::max(first, size - std::min<std::size_t>(size, 64)); i < size; ++i)
            if (obj_.normals[i] == normal) return static_cast<std::uint32_t>(i);
        obj_.normals.push_back(normal);
        return static_cast<std::uint32_t>(size);
    }

    ObjData& obj_;
    std::unordered_map<std::int32_t, dvec3> groups_;  ///< sums at one point
    dvec3 all_{0};                                    ///< the sum of all faces there
    double cos_crease_, cos_half_crease_;
    std::vector<FaceNormal> faces_;
    std::vector<std::uint32_t> begin_;
    std::vector<Meeting> meetings_;
    const Element* left_flat_ = nullptr;
};

}  // namespace

const Element* add_normals(ObjData& obj, double crease) { return Normals(obj, crease).add(); }

}  // namespace gw::scene
