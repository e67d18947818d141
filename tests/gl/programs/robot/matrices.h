// Matrices of floats for the robot's picture.
#pragma once

#include <GL/gl.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace robot {

using Matrix = std::array<GLfloat, 16>;  ///< column by column

inline Matrix product(const Matrix& a, const Matrix& b) {
    Matrix out{};
    for (std::size_t column = 0; column < 4; ++column)
        for (std::size_t row = 0; row < 4; ++row)
            for (std::size_t i = 0; i < 4; ++i)
                out[4 * column + row] += a[4 * i + row] * b[4 * column + i];
    return out;
}

using Vec = std::array<GLfloat, 3>;
inline Vec cross(const Vec& a, const Vec& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline float dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vec unit(const Vec& v) {
    const float length = std::sqrt(dot(v, v));
    return {v[0] / length, v[1] / length, v[2] / length};
}

inline Matrix looking(const Vec& eye, const Vec& at) {
    const Vec forward = unit({at[0] - eye[0], at[1] - eye[1], at[2] - eye[2]});
    const Vec right = unit(cross(forward, {0, 0, 1}));
    const Vec up = cross(right, forward);
    return {right[0], up[0], -forward[0], 0, right[1],         up[1],         -forward[1],       0,
            right[2], up[2], -forward[2], 0, -dot(right, eye), -dot(up, eye), dot(forward, eye), 1};
}

}  // namespace robot
