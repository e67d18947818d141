// Antialiased primitives: each pixel that they cover in part, with the covered area.
// docs/manual/rasterization.md, "Antialiasing". Does not shade.
#pragma once

#include "gw/reference/shade.h"
#include "gw/stages/area.h"
#include "gw/stages/stipple.h"

#include <map>
#include <utility>
#include <vector>

namespace gw::reference {

/// A piece of a smooth polygon.
struct SmoothPiece {
    SnappedTriangle triangle;
    Shader shade;
};

/// The areas that the shapes of one primitive cover, by pixel of a box.
class Areas {
public:
    explicit Areas(const Rect& box) : box_(box) {}

    struct Covered {
        std::int64_t area = 0;     ///< of all shapes
        std::int64_t largest = 0;  ///< of one shape
        std::size_t shape = 0;     ///< the first with the largest area
    };
    /// `ordinal` of a shape in its primitive.
    void add(Shape shape, std::size_t ordinal);
    void add(const Disc& disc);

    /// By row and column.
    const std::map<std::pair<int, int>, Covered>& pixels() const { return pixels_; }

private:
    void add_around(Shape corners, std::size_t ordinal, const auto& area_at);

    Rect box_;
    std::map<std::pair<int, int>, Covered> pixels_;
};

/// Makes the fragments of all pieces of a polygon together.
void draw_smooth_polygon(const std::vector<SmoothPiece>& pieces);
/// `stippled`: steps before the line.
void draw_smooth_line(const Shader& shade, const SnappedLine& line, std::uint64_t stippled);
/// Around a snapped position.
void draw_smooth_point(const Shader& shade, std::int64_t x, std::int64_t y, float size);

}  // namespace gw::reference
