// Blame: which step of a log spoiled which pixels. Does not compare pictures.
#pragma once

#include "hiddensurface/run/compare.h"

#include <string>
#include <vector>

namespace gw::hiddensurface {

/// Wrong pixels that one step painted last, of one kind.
struct Blame {
    std::size_t step = 0;        ///< 1, 2, ...; 0: no step painted them
    std::uint32_t id = 0;        ///< that it painted
    std::uint32_t over = 0;      ///< that it covered
    std::uint32_t expected = 0;  ///< the Z-buffer's
    std::uint64_t pixels = 0;
    int x = 0, y = 0;  ///< the first of them: of the uppermost row the leftmost; rows upwards
    bool operator==(const Blame&) const = default;
};

/// "Step 5 painted 3 over 1 at 3600 pixels, first at (260, 90). Expected: 1." The pixel is counted from
/// the picture's upper left corner. `height`: the picture's.
std::string sentence_of(const Blame& blame, int height);

/// By steps. Every wrong pixel of a compared result is in one of them.
std::vector<Blame> blame_of(const std::vector<Step>& steps, const Result& result, int width);

}  // namespace gw::hiddensurface
