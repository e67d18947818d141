// Points, lines and polygons of IRIS GL as primitives of OpenGL: colour map mode, depth
// cueing, swapped meshes, concave polygons.
#pragma once

#include "gw/base/types.h"
#include "irisgl/window/window.h"

#include <cstdint>
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
/// Those behind the eye stay. On a side between two pixels it is the right one and, of areas, the
/// lower one, else the upper: so areas between sides of pixels keep their pixels.
void snap_to_pixels(std::span<Vertex> vertices, bool is_area);
/// A polygon of a command older than bgnpolygon: it owns the pixels of its edges too.
void draw_old_polygon(std::span<const Vertex> vertices);
/// A rectangle of whole pixels of the window, both ends included, in the current colour, at a depth of
/// -1 .. 1.
void fill_pixels(const Bounds& pixels, double depth = 0);
/// If the rectangle's edges are rows and columns of pixels on the screen, moves its corners half a pixel
/// out: IRIS GL's rectangles own the pixels of all their edges. Returns whether they are.
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
/// Of the arguments of lsetdepth, lshaderange and lRGBrange, as GLC_ZRANGEMAP says.
double depth_of_range(long z);
/// OpenGL's current colour for an index, as the planes hold it.
void gl_index_color(unsigned index);
/// Whether colours are indices in the draw mode.
bool draws_indices();
PlaneState& planes_now();

}  // namespace gw::irisgl
