// Adds figures, pixmaps and facets to a model, object after object. For figures.cpp and st.cpp.
#pragma once

#include "radiosity/model/charts.h"
#include "radiosity/model/figures.h"

#include <map>
#include <optional>

namespace gw::radiosity {

inline constexpr int largest_pixmap = 4096;

/// The affine map that gives three points of a plane these texel coordinates; none if they have no
/// area.
std::optional<Facet> facet_of(const std::array<dvec3, 3>& p, const std::array<dvec2, 3>& uv);

/// The map u = 0, v = 0 at `origin`, one texel along du and along dv.
Facet facet_along(const dvec3& origin, const dvec3& du, const dvec3& dv, const dvec3& normal);

class ModelBuilder {
public:
    ModelBuilder(const scene::Scene& scene, const ModelOptions& options);

    PixmapModel model;

    /// The object that is added now: its welded surface in the world, and the facets of its
    /// triangles.
    void begin(std::uint32_t object);
    const scene::Object& object() const { return scene_.objects[object_]; }
    const Surface& surface() const { return surface_; }
    std::array<dvec3, 3> corners(std::uint32_t triangle) const;
    /// Adds the object's triangles to model.drawn, which id_pass draws.
    void end();

    /// Throws Error from the object's pixmap.
    [[noreturn]] void fail(const std::string& what) const;

    /// Whether a triangle of the object has one.
    bool has_area() const;
    /// Instead of adding the object, which has no area. Throws Error if it is to emit.
    void leave_out();

    std::uint32_t add_figure(std::uint32_t pixmap);
    std::uint32_t add_pixmap(std::string name, int width, int height);
    /// The pixmap that the object's choice names, or its own.
    std::uint32_t add_shared_pixmap();
    /// With its triangles in; they are these of the surface.
    void add_facet(Facet facet, const std::vector<std::uint32_t>& triangles, std::uint32_t figure);
    /// A facet of its own.
    void add_triangle(std::uint32_t triangle, const Triangle2& uv, std::uint32_t figure);

    /// How many texels a length has.
    int texels(double length) const;

private:
    const scene::Scene& scene_;
    double texels_per_unit_ = 0;
    std::uint32_t object_ = 0;
    Surface surface_;
    std::vector<std::uint32_t> facet_of_triangle_;
    std::map<std::string, std::uint32_t> shared_;
};

/// Every chart is projected along its normal.
void add_automatic(ModelBuilder& builder);
/// ST are the mesh's texture coordinates: one figure, in a pixmap that may be shared.
void add_given(ModelBuilder& builder);

}  // namespace gw::radiosity
