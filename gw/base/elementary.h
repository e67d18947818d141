// Elementary functions made of + - * / sqrt and tables: they give the same bits on every IEEE 754
// machine, and libm's functions do not. No libm function of these names may reach a pixel, a vertex
// or a matrix. Does not set errno or raise errors: outside its range a function returns NaN or
// infinity, as stated. Does not know float or vectors.
//
// Worst errors in ulp (units in the last place of the exact value; 0.5 is correctly rounded, 1 is
// at most 2.3e-16 of the value), over every float32 of the range. In brackets: a bound that no
// sample of doubles in the whole range exceeded.
//   exp   [-104, 0]                                     0.516 [0.52]
//   pow   [0, 1]^y, y = 0.5, 1, 10, 27.3, 128, 1000     0.517 [0.52], 1 exact; 0.752 [0.76] if denormal
//   sin   [-2 pi, 2 pi]                                 0.587 [0.60], in degrees too
//   cos                                                 0.570 [0.60]
//   tan                                                 0.572 [0.60]
// Samples only: log [0.51], atan2 [1.5], acos and asin [2.2].
#pragma once

namespace gw {

inline constexpr double pi = 0x1.921fb54442d18p1;  // nearest double

/// e^x. Underflows to 0 below -745.2, overflows to infinity above 709.8.
double exp(double x) noexcept;

/// Natural logarithm. -infinity at 0, NaN below.
double log(double x) noexcept;

/// x^y for x >= 0 and any y. pow(x, 0) = pow(1, y) = 1, also 0^0: a highlight with exponent 0
/// covers everything. NaN for x < 0.
double pow(double x, double y) noexcept;

/// Angles in radians. NaN for |x| > 2^20, and for NaN.
double sin(double x) noexcept;
double cos(double x) noexcept;
double tan(double x) noexcept;

/// Angles in degrees. Multiples of 90 degrees give exactly 0, 1 and -1; tan 45 degrees is 1, tan 90
/// degrees is +infinity. NaN for |x| > 2^20.
double sin_degrees(double x) noexcept;
double cos_degrees(double x) noexcept;
double tan_degrees(double x) noexcept;

/// The angle of (x, y) in [-pi, pi], with the sign of y, also of a zero. Arguments are finite. At
/// (+-0, y = 0) it is 0 or pi.
double atan2(double y, double x) noexcept;

/// In [0, pi] and [-pi/2, pi/2]. NaN for |x| > 1.
double acos(double x) noexcept;
double asin(double x) noexcept;

}  // namespace gw
