// GoogleMock matchers for planes:
//
//     EXPECT_THAT(machine->planes(), HasColor(12, 40, {10, 10, 10, 255}));
//     EXPECT_THAT(machine->planes(), PlaneEq(Plane::Depth, expected, profile));
//
// Pixels are in window coordinates, row 0 at the bottom; values in the units of the plane
// (gw/planes.h).
#pragma once

#include "gw/planes.h"
#include "gw/profile.h"

#include <gmock/gmock.h>

#include <optional>
#include <string>

namespace gw {

/// How GoogleTest prints planes: "planes of 64 x 48 pixels".
void PrintTo(const Planes& planes, std::ostream* out);

}  // namespace gw

namespace gw::testing {

using PlanesMatcher = ::testing::Matcher<const Planes&>;

/// Pixel (x, y) has this value; outside the planes is a mismatch that says so.
PlanesMatcher HasColor(int x, int y, Rgba color);
PlanesMatcher HasDepth(int x, int y, std::uint32_t depth);
PlanesMatcher HasStencil(int x, int y, std::uint8_t stencil);
PlanesMatcher HasAccum(int x, int y, std::array<std::int32_t, 4> sum);

/// Every pixel of one plane has the same bits as in `expected`. A mismatch names the number of
/// wrong pixels and the worst of them, and leaves pictures (failure_files.h) if `profile` is given.
PlanesMatcher PlaneEq(Plane plane, Planes expected, std::optional<Profile> profile = {});
/// All four planes.
PlanesMatcher PlanesEq(Planes expected, std::optional<Profile> profile = {});

/// The plane's digest (gw::digest) as 32 lower-case hexadecimal digits.
PlanesMatcher HasDigest(Plane plane, std::string digest);

/// The number of pixels whose value in this plane is not `background`'s, such as those that a draw
/// covered.
PlanesMatcher CoveredPixels(Plane plane, Planes background, ::testing::Matcher<std::size_t> count);

}  // namespace gw::testing
