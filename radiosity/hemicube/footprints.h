// The footprints of pixels in a pixmap [F2.2o], and their light spread over the texels by area.
// Works on a vector of pixels, or of their parts, at a time. Does not choose the pixels that are
// divided (scan.cpp does).
#pragma once

#include "radiosity/hemicube/facet_view.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gw::radiosity {

/// The number of values that vector code may write, or read, behind the last of a list.
inline constexpr std::size_t longest_vector = 64;

/// A list of boxes, in the order in which texels receive their light. Each member has space for
/// `count` boxes and a vector more.
struct Boxes {
    std::vector<double> u, v, width, height;  ///< the middle and the sides
    std::vector<double> value;
    /// 2, of boxes of at most a texel each way; 3, of at most two
    std::vector<std::int32_t> texels_across;
    std::size_t count = 0;

    void reserve(std::size_t more) {
        const std::size_t size = count + more + longest_vector;
        if (size <= u.size()) return;
        for (auto* values : {&u, &v, &width, &height, &value}) values->resize(2 * size);
        texels_across.resize(2 * size);
    }
};

/// One facet in one face.
struct FacetMap {
    /// In texels, along u or v: the facet's bounds, and the pixmap's number of texels.
    struct Axis {
        double low = 0, high = 0;
        int count = 0;
    };
    Homography texel_from_pixel;
    Axis u, v;
    int most_parts = 64;  ///< ScanOptions
};

/// The pixels of a row that see the facet. Each member has space for a row and a vector more.
struct FacetPixels {
    std::vector<std::int32_t> x;       ///< ascending
    std::vector<std::int32_t> nx, ny;  ///< the number of parts into which the pixel is divided
    std::size_t count = 0;

    void reserve(std::size_t row);
};

/// x and count: those of row[first .. end - 1] that are `pixel`.
void find_pixels(const std::uint32_t* row, int first, int end, std::uint32_t pixel,
                 FacetPixels& found) noexcept;

/// Finds nx, ny, and a box about the pixel's middle with its delta form factor. It is the pixel's
/// own box or, if it is to be divided, the box of one part. y: the row, to which the `deltas`
/// belong. `boxes` is overwritten, and has space. Returns whether a box may be longer than a texel,
/// or a pixel is to be divided.
bool find_footprints(const FacetMap& map, int y, const double* deltas, FacetPixels& pixels,
                     Boxes& boxes) noexcept;

/// Parts of pixels: their middles in the face, and in texels. Each member has space for `count`
/// parts and a vector more.
struct Parts {
    std::vector<double> x, y, u, v;
    std::vector<std::int32_t> inside;  ///< 1: falls on the facet, 0
    std::size_t count = 0;

    void reserve(std::size_t more);
};

/// u, v and inside, from x and y.
void find_parts(const FacetMap& map, Parts& parts) noexcept;

/// The texels of a pixmap.
struct TexelSums {
    double* factors = nullptr;               ///< of the whole model
    std::size_t first = 0;                   ///< of the pixmap
    const std::uint32_t* nearest = nullptr;  ///< null: every texel is an element
};

/// Adds the boxes' values to the texels, box by box, and empties `boxes`. A box that lies beside
/// the facet, as a pixel on its border may, is moved into the facet's bounds, or cut if it is
/// larger than they are.
void spread(const FacetMap& map, Boxes& boxes, const TexelSums& sums) noexcept;

/// Appends boxes first .. end - 1 of `from`. `to` has space.
void append(const Boxes& from, std::size_t first, std::size_t end, Boxes& to) noexcept;

}  // namespace gw::radiosity
