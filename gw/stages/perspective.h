// Perspective-correct values: numerators and a denominator as integer planes.
// docs/manual/rasterization.md, "Perspective". Set-up only, in double. Does not make the planes or
// divide: each machine does, once per pixel.
#pragma once

#include "gw/base/types.h"
#include "gw/state.h"

#include <array>
#include <cstdint>
#include <span>

namespace gw {

/// A value at a primitive's 1 to 3 vertices: offset + (numerator / denominator) * 2^exponent.
struct Numerators {
    std::array<std::int64_t, 3> at{};
    double offset = 0;  ///< k: an integer
    int exponent = 0;
};

/// Q_i = max(1, rne(2^30 wmin / w_i)).
std::array<std::int64_t, 3> denominators(std::span<const double> w);

/// U_i = rne(2^30 clamp((s_i - k) / 2^e, 0, 1) wmin / w_i). e is the least of least_exponent ..
/// largest_exponent with 2^e >= max(s_i - k).
Numerators numerators(std::span<const double> s, std::span<const double> w, double k,
                      int largest_exponent = 10, int least_exponent = 0);
/// Of a texture coordinate, above its integer part (R10.8). One that spans more than 2^10 repeats is
/// wide (R9.19): its exponent is 11 .. 32.
Numerators texture_numerators(std::span<const double> s, std::span<const double> w, bool repeats);
inline constexpr int largest_exponent_in_float = 10;
bool is_wide(double least, double greatest);
/// Texel position of a wide coordinate (R10.26) with numerator u and denominator q at the pixel, on a
/// level whose side is 2^log2_size.
int wide_position(std::int64_t u, std::int64_t q, int exponent, std::int64_t k, int log2_size,
                  bool repeats);
/// The integer part that a wrap adds to a coordinate above it: none, its parity, or all.
std::int64_t added_part(double k, Wrap wrap);
/// Texel position on a level of `size` texels, for any size and for MirroredRepeat (R10.29). The
/// quotient is u, of a wide coordinate U / Q.
int any_position(double quotient, int exponent, std::int64_t k, int size, Wrap wrap);

/// The fog coordinate's numerators; it is clamped to 2^40 fog tables.
inline constexpr int largest_fog_exponent = 40;
/// Those of a given coordinate, above the least one.
Numerators fog_numerators(std::span<const double> f, std::span<const double> w);

/// EyeLinear coordinates s_i / q_i, of any sign. Q_i = rne(2^30 (q_i / w_i) / H) with
/// H = max |q_i / w_i|.
struct Projective {
    std::array<std::int64_t, 3> denominator{};
    std::array<Numerators, 3> numerator;  ///< s, t, r; offset 0, exponent -60 .. 60
};
Projective projective(std::span<const dvec4> strq, std::span<const double> w);

/// The plane of U or Q of one coordinate, for rho: its gradients (16 fraction bits) and its value
/// at pixel (x, y).
struct PlaneSlope {
    double gx = 0, gy = 0;  ///< exact gradients, as doubles
    double value = 0;
};
/// |d(U/Q)| Q^2 along rows and columns. Each is linear in one pixel coordinate, so no neighbour is
/// read.
struct CoordinateSlope {
    double a = 0, b = 0;                ///< Ux Q - U Qx and Uy Q - U Qy at pixel (x, y)
    float k = 0;                        ///< (Ux Qy - Uy Qx) / 2^16
    double along_row(int dy) const;     ///< at pixels of row y + dy
    double along_column(int dx) const;  ///< at pixels of column x + dx
};
CoordinateSlope coordinate_slope(const PlaneSlope& u, const PlaneSlope& q);

/// Joins the slopes of a texture's coordinates, in texels, to the input of rho.
struct JoinedSlopes {
    bool exact = false;          ///< R10.46: lengths; else the largest slope, R10.12
    double row = 0, column = 0;  ///< squares if exact

    void add(const CoordinateSlope& slope, int dx, int dy, double scale);
    double value() const;
};

}  // namespace gw
