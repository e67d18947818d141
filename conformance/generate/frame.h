// The map from window positions to object space, flat or in perspective. Does not make meshes.
#pragma once

#include "conformance/generate/random.h"
#include "gw/profile.h"
#include "gw/state.h"

namespace gw::conformance {

/// A projection and a transform; `place` inverts both.
struct Frame {
    int width = 1, height = 1;  ///< of the viewport
    int subpixel_bits = 3;
    /// z is the eye distance (w = z); if not deep, the normalized depth -1 .. 1 (w = 1)
    bool deep = false;
    double near_z = 1, far_z = 9;  ///< of a deep frame
    dmat4 projection{1};
    dmat4 eye_from_object{1};
    /// p_object = p_eye * scale + shift: exact powers of two
    dvec3 object_scale{1}, object_shift{0};
};

Frame any_frame(Random& random, int width, int height, int subpixel_bits);
Frame flat_frame(Random& random, int width, int height, int subpixel_bits);

/// The object-space position of a vertex at window position x, y in pixels and z by Frame::deep.
vec3 place(const Frame& frame, const dvec3& window);

/// A coordinate inside or around 0 .. size: on pixel centres, edges, the sub-pixel grid, between
/// grid points, on tile borders, seldom far outside.
double any_coordinate(Random& random, int size, int subpixel_bits);
/// A z for `place`: on planes, between them, outside.
double any_z(Random& random, const Frame& frame);

}  // namespace gw::conformance
