#include "conformance/generate/frame.h"

#include <algorithm>
#include <cmath>

namespace gw::conformance {
namespace {

/// clip = (2 x / width - w, 2 y / height - w, z, w), eye space looking down -z.
dmat4 flat_projection(int width, int height) {
    dmat4 p(0);
    p[0][0] = 2.0 / width;
    p[3][0] = -1;
    p[1][1] = 2.0 / height;
    p[3][1] = -1;
    p[2][2] = -1;
    p[3][3] = 1;
    return p;
}

/// The same for positions times w, w = -z_eye.
dmat4 deep_projection(int width, int height, double n, double f) {
    dmat4 p(0);
    p[0][0] = 2.0 / width;
    p[2][0] = 1;
    p[1][1] = 2.0 / height;
    p[2][1] = 1;
    p[2][2] = -(f + n) / (f - n);
    p[3][2] = -2 * f * n / (f - n);
    p[2][3] = -1;
    return p;
}

double power_of_two(int e) { return std::ldexp(1.0, e); }

/// Object space: mirrored, scaled by powers of two, shifted by integers. Seldom so large or small
/// that squares leave the range of float.
void any_transform(Random& r, Frame& f) {
    const int reach = r.chance(5) ? 100 : 3;
    for (int i = 0; i < 3; ++i) {
        f.object_scale[i] = power_of_two(r.between(-reach, reach));
        f.object_scale[i] *= r.sign(20);
        f.object_shift[i] = r.chance(50) ? 0 : r.between(-20, 20);
        f.eye_from_object[i][i] = 1 / f.object_scale[i];
        f.eye_from_object[3][i] = -f.object_shift[i] / f.object_scale[i];
    }
}

}  // namespace

Frame flat_frame(Random& r, int width, int height, int subpixel_bits) {
    Frame f{width, height, subpixel_bits};
    f.projection = flat_projection(width, height);
    if (r.chance(25)) any_transform(r, f);
    return f;
}

Frame any_frame(Random& r, int width, int height, int subpixel_bits) {
    Frame f = flat_frame(r, width, height, subpixel_bits);
    f.deep = r.chance(60);
    if (f.deep) {
        f.near_z = r.chance(70) ? 1 : r.pick({0.01, 1e-6, 100.0});
        f.far_z = f.near_z * (r.chance(70) ? 9 : r.pick({1.001, 1e4, 1e8}));
        f.projection = deep_projection(width, height, f.near_z, f.far_z);
    }
    // A positive factor of homogeneous coordinates does not change the picture.
    if (r.chance(5)) f.projection *= power_of_two(r.between(-300, 300));
    return f;
}

vec3 place(const Frame& f, const dvec3& window) {
    const double w = f.deep ? window.z : 1;
    const dvec3 object =
        dvec3(window.x * w, window.y * w, -window.z) * f.object_scale + f.object_shift;
    vec3 out;
    for (int i = 0; i < 3; ++i) out[i] = static_cast<float>(std::clamp(object[i], -3e38, 3e38));
    return out;
}

double any_coordinate(Random& r, int size, int subpixel_bits) {
    const int units = 1 << subpixel_bits;
    const int kind = r.below(100);
    if (kind < 20) return r.between(-1, size) + 0.5;                                  // centres
    if (kind < 35) return r.between(-1, size + 1);                                    // edges
    if (kind < 60) return double(r.between(-2 * units, (size + 2) * units)) / units;  // the grid
    // halfway between
    if (kind < 68) return double(r.between(-units, 2 * size * units)) / (2 * units);
    // tile borders
    if (kind < 76) {
        const int border = 64 * r.between(0, 3);
        return border + double(r.between(-units, units)) / units;
    }
    if (kind < 94) return r.real(-0.25 * size - 2, 1.25 * size + 2);
    if (kind < 98) return r.real(-30.0 * size, 30.0 * size);
    return r.scaled(-1, 1, 10, 40);
}

double any_z(Random& r, const Frame& f) {
    const int kind = r.below(100);
    if (f.deep) {
        const double n = f.near_z, span = f.far_z - n;
        if (kind < 20) return n + span * r.between(0, 8) / 8;
        if (kind < 50) return r.real(n, f.far_z);
        if (kind < 85) return n * r.scaled(1, 2, 0, 3);
        if (kind < 92) return r.real(n - span / 2, n + span * 1.5);
        if (kind < 95) return r.pick({0.0, n, f.far_z, -n});
        return r.pick({n * (1 - 0x1p-23), n * (1 + 0x1p-22), f.far_z * (1 + 0x1p-20), 0x1p-40,
                       -0x1p-40, 1e6});
    }
    if (kind < 30) return r.between(-4, 4) / 4.0;
    if (kind < 85) return r.real(-1, 1);
    if (kind < 93) return r.real(-1.5, 1.5);
    return r.pick({-1.0, 1.0, -1 - 0x1p-23, 1 + 0x1p-22, 0x1p-100, -1e9, 1e9});
}

}  // namespace gw::conformance
