// The five ID buffers as one list [F2.2], in which a position of any face is looked up. Beside each
// identifier stands how far it is alone: many texels are known by one look.
#pragma once

#include "radiosity/hemicube/hemicube.h"

#include <cstdint>
#include <vector>

namespace gw::radiosity {

/// The top's rows first, then those of the sides, in the order of the faces.
struct SeenIds {
    int size = 0;
    /// Low 24 bits: the identifier. High 8 bits: the largest of 0, 1, 2, 4, 8 such that all pixels
    /// of the same face that are so near, in rows and columns, are there and have this identifier.
    std::vector<std::uint32_t> pixels;

private:
    friend void find_seen(const IdBuffers& buffers, SeenIds& seen);
    std::vector<std::uint64_t> bits_;
};

constexpr std::uint32_t id_bits = 0xFFFFFF;

/// `seen` is overwritten.
void find_seen(const IdBuffers& buffers, SeenIds& seen);

}  // namespace gw::radiosity
