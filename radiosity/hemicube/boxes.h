// Boxes in texels: what a pixel, or a part of one, covers of a pixmap, and what it carries [F2.2o].
#pragma once

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

}  // namespace gw::radiosity
