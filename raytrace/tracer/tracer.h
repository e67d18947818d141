// Light along rays [L9]: eq. 3 with shadows at a ray's end, and recursion into reflected and
// transmitted rays. For the ordinary ray tracer, and for eq. 5 [K4] from the first hit on. Does not
// find the first hit.
#pragma once

#include "raytrace/tracer/surface.h"
#include "raytrace/tracer/traced_material.h"
#include "raytrace/tracer/world.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace gw::raytrace {

/// Traced rays, counted by kind, and their work [K4f]. Sums are the same for any number of
/// threads.
struct RayCounts {
    std::uint64_t primary = 0;      ///< from the eye
    std::uint64_t reflected = 0;    ///< from any hit
    std::uint64_t transmitted = 0;  ///< from any hit
    std::uint64_t shadow = 0;       ///< towards lights
    std::uint64_t shaded = 0;       ///< points at which eq. 3 was evaluated
    SearchCounts tests;             ///< of boxes and triangles, for all these rays

    void add(const RayCounts& c) {
        primary += c.primary;
        reflected += c.reflected;
        transmitted += c.transmitted;
        shadow += c.shadow;
        shaded += c.shaded;
        tests.boxes += c.tests.boxes;
        tests.triangles += c.tests.triangles;
    }
    bool operator==(const RayCounts&) const = default;
};

/// A ray after the first, as a tracer follows it; for pictures of paths.
struct FollowedRay {
    dvec3 from{0};
    dvec3 direction{
        0};  ///< of length 1; of a shadow ray: to the light, or opposite to its direction
    std::optional<scene::TrianglePoint> hit;  ///< none: the background, or a shadow ray
    std::optional<std::size_t> light;         ///< of a shadow ray
    bool arrives = false;                     ///< the light does
    bool above = true;  ///< on the side of the surface that is seen: reflected
    int number = 0;     ///< in its path, where the ray from the eye is 1; 0: a shadow ray
    double part = 1;    ///< of the path's light
};

struct TraceOptions {
    /// Rays in a path. With 2, as in Fig. 9 [K4f], the surface that the ray from the eye meets
    /// sends second rays, and paths end there. With 1 there are reflection maps only.
    int depth = 2;
    int threads = 0;  ///< 0: all
    /// Whether a hit of a reflected ray is in the shadow of a light (by its number). Empty: shadow
    /// rays.
    std::function<bool(std::size_t light, const scene::TrianglePoint&)> in_shadow;
    /// Is told every ray after the first, as it is followed. Empty: nobody is.
    std::function<void(const FollowedRay&)> followed;
};

/// A path that carries less than this part of its light ends.
inline constexpr double least_weight = 1.0 / 2048;

/// Refers to scene, world and view, which must outlive it. Any number of threads may use one.
class Tracer {
public:
    /// The world is that of the scene (its triangles are the same drawn or not).
    Tracer(const scene::Scene& scene, const World& world, const scene::View& view,
           TraceOptions options);
    Tracer(const Tracer&) = delete;

    const World& world() const { return world_; }
    const TraceOptions& options() const { return options_; }

    /// Eq. 3 of the drawn scene [K3s], lights that cast shadows found by shadow rays.
    dvec3 local(const Surface& surface, RayCounts& counts) const;

    /// I_raytracing of eq. 5 [K4]: the light that arrives along second rays and those that follow,
    /// and that the surface reflects or transmits. At the end of a path, reflection maps replace
    /// the light that is not traced.
    dvec3 traced(const Surface& surface, RayCounts& counts) const;

    /// Whether `traced` can be anything but black there.
    bool is_traced(std::uint32_t triangle) const { return look_of(triangle).is_traced; }
    /// Less than 1: the surface is translucent and blended over the light from behind [K3.4].
    double opacity(std::uint32_t triangle) const { return double(look_of(triangle).drawn->d); }
    /// The surface that is seen through a translucent one, before the far plane; none: the
    /// background.
    std::optional<Surface> behind(const Surface& translucent, RayCounts& counts) const;
    /// Whether texture coordinates matter there.
    bool looks_up_maps(std::uint32_t triangle) const;

private:
    struct Path {
        int rays_left = 0;
        double weight = 1;
    };
    struct LightSource {
        gw::Light eye;
        std::size_t number = 0;
    };
    /// The material and lights of an object, looked up once. Refers to the members below.
    struct Look {
        const scene::Material* drawn = nullptr;
        const TracedMaterial* traced = nullptr;
        bool is_traced = false;
        std::shared_ptr<const std::vector<LightSource>> lights;
    };
    using FarMaps = const std::vector<scene::Map>*;

    static std::shared_ptr<const std::vector<LightSource>> light_list(
        const scene::Scene& scene, const std::vector<std::size_t>& numbers,
        const scene::View& view);
    const Look& look_of(std::uint32_t triangle) const {
        return looks_[world_.triangles().object_of(triangle)];
    }

    dvec3 followed(const Surface& surface, const Path& path, RayCounts& counts) const;
    dvec3 arriving(const Surface& from, const dvec3& direction, FarMaps far, const Path& path,
                   RayCounts& counts) const;
    bool reflects_map(const Surface& surface, bool by_rays, RayCounts& counts) const;
    dvec3 far_away(const dvec3& direction, FarMaps far) const;
    dvec3 shaded(const Surface& surface, bool by_rays, RayCounts& counts) const;
    bool arrives(const LightSource& light, const Surface& surface, bool by_rays,
                 RayCounts& counts) const;

    const World& world_;
    const scene::View& view_;
    scene::Scene drawn_;
    TraceOptions options_;

    /// as the scene has them: traced_ refers to their maps
    std::vector<scene::Material> materials_;
    std::vector<TracedMaterial> traced_;  ///< by material
    std::vector<Look> looks_;             ///< by object
    /// The first light that casts a shadow, if reflection maps are kept out of it.
    std::optional<LightSource> keeps_off_reflections_;
};

}  // namespace gw::raytrace
