// Scratch vectors for making geometry sets. Each worker thread has its own.
#pragma once

#include "gw/fast/vertices/project.h"
#include "gw/stages/clip.h"
#include "gw/stages/fan.h"

#include <cstdint>
#include <vector>

namespace gw::fast {

/// A primitive that touches a tile.
struct BinEntry {
    std::uint16_t column, row;
    std::uint32_t primitive;
};

struct GeometryScratch {
    std::vector<Outcode> outcode;  ///< of a part's vertices, or of those of several parts
    // vertices of several parts
    std::vector<vec3> positions;
    std::vector<SnappedVertex> at;
    std::vector<double> w;
    PositionClipper clipper;
    std::vector<SnappedPoint> fan_corners;
    std::vector<std::uint8_t> sides;  ///< that a part's vertices show
    std::vector<BinEntry> bin_entries;
    std::vector<std::uint32_t> next;  ///< in the bins of a set's tiles

    /// Frees memory that a large mesh needed.
    void trim() {
        if (outcode.capacity() + bin_entries.capacity() > std::size_t{1} << 16) *this = {};
    }
};

}  // namespace gw::fast
