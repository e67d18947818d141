// What a step of a program gave: numbers and pictures, and how two implementations differ in them.
#pragma once

#include "tests/gl/peer/library.h"

#include <array>
#include <string>
#include <vector>

namespace gw::gl_peer {

inline constexpr int window_width = 48, window_height = 40;

/// The planes of the window, by ReadPixels, bottom row first.
struct Picture {
    std::vector<std::array<GLubyte, 4>> color;
    std::vector<GLfloat> depth;
    std::vector<GLubyte> stencil;
};

/// Numbers of one kind that a step got.
struct Values {
    std::string what;
    std::vector<double> values;
    double bound = 0;        ///< of the difference, relative to 1 or to the larger number
    std::size_t record = 0;  ///< if not 0: a set of records of so many numbers
};

struct Results {
    std::vector<Values> values;
    std::vector<Picture> pictures;
    int color_bound = 2;  ///< of the channels of the pictures, in 255ths
};

/// Pixels that differ by more than the bounds. A pixel that has an equal neighbour on both sides is
/// one of an edge: where an edge is, rounding decides.
struct Difference {
    std::string first;  ///< the first value or pixel that differs; empty: none does
    int edge_pixels = 0, wrong_pixels = 0;
};

/// Reads the planes; the pixel state of the program stays as it is.
Picture picture_of(const Gl& gl);

Difference compare(const Results& a, const Results& b);

/// At most so many pixels of edges may differ, and others: the ends of lines, points at the border.
inline constexpr int most_edge_pixels = window_width * window_height / 32;
inline constexpr int most_wrong_pixels = 12;

inline bool is_accepted(const Difference& d) { return d.first.empty(); }

}  // namespace gw::gl_peer
