// Points, lines and polygons of IRIS GL as primitives of OpenGL: colour map mode, depth
// cueing, swapped meshes, concave polygons.
#pragma once

#include "gw/base/types.h"
#include "irisgl/window/window.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace gw::irisgl {

enum class Shape : std::uint8_t { Points, Line, ClosedLine, Polygon, Mesh, Triangles, Strip };

/// A vertex in object coordinates with the values that were current.
struct Vertex {
    dvec4 p{0, 0, 0, 1};
    double index = 0;
    vec4 rgb{0, 0, 0, 1};
    vec3 normal{0, 0, 1};
    vec4 texture{0, 0, 0, 1};
    bool is_lit = false;
};

/// The vertices of a bgn .. end.
struct Assembly {
    bool is_open = false;
    Shape shape = Shape::Points;
    std::vector<Vertex> vertices;
    std::vector<std::size_t> swaps;  ///< numbers of vertices before a swaptmesh
    std::vector<Vertex> polygon;     ///< of pmv and pdr
};
Assembly& assembly();

/// The current values at a place.
Vertex vertex_here(double x, double y, double z, double w = 1);
void draw_shape(Shape shape, std::span<const Vertex> vertices);
/// The same without counting as a part of a frame. `is_placed`: subpixel does not matter, the
/// vertices stay where they are.
void draw_part(Shape shape, std::span<const Vertex> vertices, bool is_placed = false);
/// Moves vertices to the middles of their pixels, where IRIS GL draws them unless subpixel is on.
/// Vertices behind the eye stay. One on a side between two pixels goes to the right one and, of areas,
/// to the lower one, else to the upper: so areas between sides of pixels keep their pixels.
void snap_to_pixels(std::span<Vertex> vertices, bool is_area);
/// A polygon of a command older than bgnpolygon: it owns the pixels of its edges too.
void draw_old_polygon(std::span<const Vertex> vertices);
/// A rectangle of whole pixels of the window, both ends included, in the current colour, at a depth of
/// -1 .. 1.
void fill_pixels(const Bounds& pixels, double depth = 0);
/// If the rectangle's edges are rows and columns of pixels, moves its corners half a pixel out and
/// returns true. IRIS GL's rectangles own the pixels of all their edges.
bool own_edge_pixels(std::vector<dvec4>& corners);
/// The pixels around vertices; of the whole window if one is behind the eye.
Bounds pixels_around(std::span<const Vertex> vertices);
/// scrbox: these pixels are drawn to.
void track(const Bounds& pixels);
/// The pixels of a smooth line in colour map mode as points in the window's coordinates, -1 .. 1.
std::vector<Vertex> smooth_pixels(std::span<const Vertex> line, bool is_closed);
/// Brings OpenGL's matrices up to date.
void load_matrices();
/// Clip coordinates.
dvec4 clip_from_object(const dvec4& p);
/// x, y in pixels (0.5: the middle of pixel 0), z in 0 .. 1. None behind the eye.
std::optional<dvec3> window_from_object(const dvec4& p);
/// A depth of IRIS GL as 0 .. 1.
double depth_of(long z);
/// The same of lsetdepth, lshaderange and lRGBrange, as GLC_ZRANGEMAP says.
double depth_of_range(long z);
/// OpenGL's current colour for an index, as the planes hold it.
void gl_index_color(unsigned index);
/// Whether colours are indices in the draw mode.
bool draws_indices();
PlaneState& planes_now();

/// Triangles by cutting ears, with the polygon's orientation.
std::vector<Vertex> tessellated(std::span<const Vertex> polygon);
/// Whether polygons are drawn as PYM_HOLLOW says.
bool draws_hollow();
/// Draws the polygons of a shape one by one, each with `draw`. `outline`: of Shape::Polygon and of
/// what a concave polygon became; of other shapes it is not looked at.
void draw_hollow(Shape shape, std::span<const Vertex> vertices, std::span<const Vertex> outline,
                 const std::function<void(Shape, std::span<const Vertex>)>& draw);

/// A texture whose texel i is the pixel of index i. False, with a warning: the profile has no
/// textures of 4096 texels, so indices are not shaded.
bool bind_index_texture();
void use_index_texture(bool on);
/// Gives lit vertices the index of their light.
void light_indices(std::vector<Vertex>& vertices);
/// In a lit primitive: the material of a vertex that is lit, or one that shines in `rgb` only.
void emit_material(bool is_lit, const vec4& rgb);

}  // namespace gw::irisgl
