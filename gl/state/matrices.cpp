#include "gl/state/matrices.h"

#include <array>

namespace gw::gl {

dmat4 inverted(const dmat4& m) {
    const auto cofactor = [&](int column, int row) {
        std::array<int, 3> a{}, b{};
        for (int i = 0, n = 0; i < 4; ++i)
            if (i != column) a[std::size_t(n++)] = i;
        for (int i = 0, n = 0; i < 4; ++i)
            if (i != row) b[std::size_t(n++)] = i;
        const double d =
            m[a[0]][b[0]] * (m[a[1]][b[1]] * m[a[2]][b[2]] - m[a[2]][b[1]] * m[a[1]][b[2]]) -
            m[a[1]][b[0]] * (m[a[0]][b[1]] * m[a[2]][b[2]] - m[a[2]][b[1]] * m[a[0]][b[2]]) +
            m[a[2]][b[0]] * (m[a[0]][b[1]] * m[a[1]][b[2]] - m[a[1]][b[1]] * m[a[0]][b[2]]);
        return (column + row) % 2 == 0 ? d : -d;
    };
    dmat4 out(0);
    double determinant = 0;
    for (int i = 0; i < 4; ++i) determinant += m[i][0] * cofactor(i, 0);
    if (determinant == 0 || !std::isfinite(determinant)) return out;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) out[row][column] = cofactor(column, row) / determinant;
    return out;
}

}  // namespace gw::gl
