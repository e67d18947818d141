// Blit: the pixel of the source that each pixel of the target shows. docs/manual/surfaces.md, "Blits".
// Does not know machines: planes go in and out in the host's layout.
#pragma once

#include "gw/command_list.h"
#include "gw/stages/resolve.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gw {

/// The planes that a blit copies, and where from.
struct BlitSource {
    Surface surface;
    std::span<const Planes> samples;        ///< of each sample, or one for all: blit_samples()
    ReadBuffer buffer = ReadBuffer::Front;  ///< of the window
};
/// What a surface with these samples gives to one of `to` samples: all of them, or one of each pixel.
std::vector<Planes> blit_samples(std::span<const Planes> from, const Surface& to);

/// The rectangles that a blit reads and writes, and the same blit between planes of just these.
struct BlitParts {
    Rect source, target;
    Blit blit;  ///< in pixels of `source` and `target`
};
BlitParts blit_parts(const Blit& blit, const Rect& pixel_box, const Surface& from);

/// The planes that it names and both surfaces have.
PlaneMask blitted_planes(const Blit& blit, const Surface& from, const Surface& to);

/// Copies one plane to sample `k` of the target inside the pixel box of `state`. Returns the number
/// of pixels, counted once for each plane. The source is another object than the target.
std::uint64_t blit_plane(const Blit& blit, Plane plane, const BlitSource& from, std::size_t k,
                         const Resolved& state, int bits, Planes& to);

/// Bytes of a pixel of one plane: the samples that are read, and those that are written.
std::uint64_t blit_bytes(Plane plane, const Surface& from, const Surface& to, const State& state,
                         const Profile& profile);

}  // namespace gw
