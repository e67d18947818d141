// What pixels cover of a pixmap [F2.2o]: a vector of pixels, or of their parts, at a time.
// Does not know what is in a texel (spread.h does), nor which pixels are divided (facet_scan.h
// does).
#pragma once

#include "radiosity/hemicube/homography.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gw::radiosity {

/// What vector code may write, or read, behind the last of a list's values.
inline constexpr std::size_t longest_vector = 64;

/// A list of boxes, in the order in which texels receive what they carry. Each member has room for
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
    /// In texels, along u or v: where the facet lies, and how many texels the pixmap has.
    struct Axis {
        double low = 0, high = 0;
        int count = 0;
    };
    Homography texel_from_pixel;
    Axis u, v;
    int most_parts = 64;  ///< ScanOptions
};

/// The pixels of a row that see the facet. Each member has room for a row and a vector more.
struct FacetPixels {
    std::vector<std::int32_t> x;       ///< ascending
    std::vector<std::int32_t> nx, ny;  ///< in how many parts the pixel is to be divided
    std::size_t count = 0;

    void reserve(std::size_t row);
};

/// x and count: those of row[first .. end - 1] that are `pixel`.
void find_pixels(const std::uint32_t* row, int first, int end, std::uint32_t pixel,
                 FacetPixels& found) noexcept;

/// nx, ny, and the box of each pixel, or where it is to be divided, of one of its parts, about the
/// pixel's middle; with its delta form factor. y: the row, whose `deltas` these are. `boxes` is
/// overwritten, and has room. Returns whether a box may be longer than a texel, or a pixel is to be
/// divided.
bool find_footprints(const FacetMap& map, int y, const double* deltas, FacetPixels& pixels,
                     Boxes& boxes) noexcept;

/// Parts of pixels: where their middles are in the face, and in texels. Each member has room for
/// `count` parts and a vector more.
struct Parts {
    std::vector<double> x, y, u, v;
    std::vector<std::int32_t> inside;  ///< 1: falls on the facet, 0
    std::size_t count = 0;

    void reserve(std::size_t more);
};

/// u, v and inside, from x and y.
void find_parts(const FacetMap& map, Parts& parts) noexcept;

}  // namespace gw::radiosity
