#include "scene/shapes/revolve.h"

#include "gw/base/elementary.h"
#include "scene/shapes/grid.h"

namespace gw::scene {

MeshData revolve(const std::vector<ProfilePoint>& profile, int slices) {
    const int rows = static_cast<int>(profile.size()) - 1;
    // On the axis a vertex belongs to one triangle: that of the slice after it if the curve leaves
    // the axis, of the slice before it if the curve returns to it. It takes s and the normal from
    // the middle of that slice.
    const auto slice = [&](int column, int row) {
        const bool on_axis = profile[std::size_t(row)].position.x == 0;
        return on_axis ? column + (row == rows ? -0.5 : 0.5) : column;
    };
    return make_grid(slices, rows, [&](int column, int row) {
        const ProfilePoint& point = profile[std::size_t(row)];
        const double middle = slice(column, row);
        const double degrees =
            360 * (middle == slices ? 0 : middle) / slices;  // the last column is the first
        const double x = sin_degrees(degrees), z = cos_degrees(degrees);
        const dvec2 p = point.position, n = point.normal;
        return GridVertex{
            {p.x * x, p.y, p.x * z}, {n.x * x, n.y, n.x * z}, {middle / slices, point.t}};
    });
}

}  // namespace gw::scene
