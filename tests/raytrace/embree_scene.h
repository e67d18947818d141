// Triangles as Embree has them, and its rays one by one: the other opinion of tests and benches.
#pragma once

#include "raytrace/hierarchy/hierarchy.h"

#include <embree3/rtcore.h>

#include <vector>

namespace gw::raytrace {

/// On one thread. Three corners a triangle.
class EmbreeScene {
public:
    explicit EmbreeScene(const std::vector<vec3>& corners)
        : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_)) {
        rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
        RTCGeometry mesh = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* v = static_cast<float*>(rtcSetNewGeometryBuffer(
            mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, corners.size()));
        auto* index = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
            mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, corners.size() / 3));
        for (const vec3& corner : corners)
            for (int k = 0; k < 3; ++k) *v++ = corner[k];
        for (unsigned i = 0; i < corners.size(); ++i) index[i] = i;
        rtcCommitGeometry(mesh);
        rtcAttachGeometry(scene_, mesh);
        rtcReleaseGeometry(mesh);
        rtcCommitScene(scene_);
    }
    explicit EmbreeScene(const std::vector<HierarchyTriangle>& triangles)
        : EmbreeScene(corners_of(triangles)) {}
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;
    ~EmbreeScene() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }

    RTCScene scene() const { return scene_; }
    /// no_triangle: it meets none.
    HierarchyHit nearest(const HierarchyRay& ray) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRayHit r;
        r.ray = embree_ray(ray);
        r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene_, &context, &r);
        if (r.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {0, no_triangle};
        return {r.ray.tfar, r.hit.primID};
    }
    bool occluded(const HierarchyRay& ray) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRay r = embree_ray(ray);
        rtcOccluded1(scene_, &context, &r);
        return r.tfar < 0;
    }

private:
    static std::vector<vec3> corners_of(const std::vector<HierarchyTriangle>& triangles) {
        std::vector<vec3> corners;
        for (const HierarchyTriangle& t : triangles)
            corners.insert(corners.end(), t.corner.begin(), t.corner.end());
        return corners;
    }
    static RTCRay embree_ray(const HierarchyRay& r) {
        const vec3 &o = r.origin, &d = r.direction;
        return {o.x, o.y, o.z, r.low, d.x, d.y, d.z, 0, r.high, ~0u, 0, 0};
    }

    RTCDevice device_;
    RTCScene scene_;
};

}  // namespace gw::raytrace
