// Blit: the pixel of the source that each pixel of the target shows. docs/manual/surfaces.md, "Blits".
// Does not know machines: planes go in and out in the host's layout.
#pragma once

#include "gw/command_list.h"
#include "gw/stages/resolve.h"

#include <cstdint>

namespace gw {

/// The planes that a blit copies, and where from.
struct BlitSource {
    Surface surface;
    const Planes& planes;
    ReadBuffer buffer = ReadBuffer::Front;  ///< of the window
};

/// The planes that it names and both surfaces have.
PlaneMask blitted_planes(const Blit& blit, const Surface& from, const Surface& to);

/// Copies one plane to `to` inside the pixel box of `state`. Returns the number of pixels, counted
/// once for each plane. The source is another object than the target.
std::uint64_t blit_plane(const Blit& blit, Plane plane, const BlitSource& from,
                         const Resolved& state, int bits, Planes& to);

}  // namespace gw
