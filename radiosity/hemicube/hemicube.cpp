#include "radiosity/hemicube/hemicube.h"

#include "gw/base/elementary.h"
#include "scene/draw/draw_commands.h"

#include <algorithm>
#include <cmath>

namespace gw::radiosity {
namespace {

/// Of cube_views: +y is the top, the others are the sides.
constexpr std::array<std::size_t, hemicube_faces> cube_face{2, 0, 1, 4, 5};

/// In parts of the scene's extent: a surface lower than this over the horizon is not seen. It is
/// the rest of the patch's own plane.
constexpr double horizon = 1e-7;

/// cube_from_world: +y becomes the normal.
dmat4 turned(const dvec3& position, const dvec3& normal, double turn) {
    const dvec3 any = std::abs(normal.x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
    dvec3 a = cross3(any, normal);
    a /= length(a);
    const dvec3 b = cross3(normal, a);
    const dvec3 x = cos_degrees(turn) * a + sin_degrees(turn) * b, z = cross3(x, normal);
    dmat4 m(1);
    for (int k = 0; k < 3; ++k) m[k] = dvec4(x[k], normal[k], z[k], 0);
    m[3] = dvec4(-transform3(dmat3(m), position), 1);
    return m;
}

dmat4 after(const dmat4& eye_from_cube, const dmat4& cube_from_world) {
    dmat4 m(1);
    for (int k = 0; k < 4; ++k)
        m[k] = dvec4(transform3(dmat3(eye_from_cube), dvec3(cube_from_world[k])),
                     cube_from_world[k].w);
    return m;
}

double atan(double t) { return atan2(t, 1); }

// d2/dxdy = 1 / (pi (1 + x^2 + y^2)^2): the top, at height 1 (Howell's B-4 as an indefinite
// integral).
double top_integral(double x, double y) {
    const double a = std::sqrt(1 + x * x), b = std::sqrt(1 + y * y);
    return (x / a * atan(y / a) + y / b * atan(x / b)) / (2 * pi);
}

// d2/dydz = z / (pi (1 + y^2 + z^2)^2): a side, z the height over the horizon (B-3).
double side_integral(double y, double z) {
    const double a = std::sqrt(1 + z * z);
    return -atan(y / a) / (2 * pi * a);
}

/// Differences of an integral at the corners of the pixels.
template <class Integral>
std::vector<double> pixels(int columns, int rows, double left, double bottom, Integral integral) {
    const double step = 2.0 / columns;
    std::vector<double> corner;
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i)
            corner.push_back(integral(left + i * step, bottom + j * step));
    std::vector<double> values;
    const auto width = std::size_t(columns) + 1;
    for (std::size_t j = 0; j < std::size_t(rows); ++j)
        for (std::size_t i = 0; i < std::size_t(columns); ++i) {
            const double* c = &corner[j * width + i];
            values.push_back((c[width + 1] - c[width]) - (c[1] - c[0]));
        }
    return values;
}

}  // namespace

Hemicube hemicube_at(const dvec3& position, const dvec3& normal, double turn, double near_plane,
                     double far_plane, int size) {
    const std::array<scene::View, 6> cube =
        scene::cube_views(dvec3(0), near_plane, far_plane, size);
    const dmat4 cube_from_world = turned(position, normal, turn);
    Hemicube hemicube{.position = position, .normal = normal, .views = {}};
    for (std::size_t face = 0; face < hemicube_faces; ++face) {
        scene::View& view = hemicube.views[face] = cube[cube_face[face]];
        view.eye_from_world = after(view.eye_from_world, cube_from_world);
    }
    return hemicube;
}

Profile id_profile() {
    Profile profile = ideal();
    profile.name = "identifiers";
    profile.color_bits = profile.lit_bits = 8;
    return profile;
}

HemicubePainter::HemicubePainter(int size)
    : HemicubePainter(make_fast(id_profile(), size, size, {.threads = 1})) {}
HemicubePainter::HemicubePainter(std::unique_ptr<Machine> machine) : machine_(std::move(machine)) {}

void HemicubePainter::draw(const PixmapModel& model, const Hemicube& hemicube, IdBuffers& buffers) {
    CommandList list;
    list.commands.reserve(hemicube_faces * (4 + model.joined.objects.size()));
    for (std::uint32_t face = 0; face < hemicube_faces; ++face) {
        const scene::View& view = hemicube.views[face];
        const int size = view.width, first_row = face == 0 ? 0 : size / 2;
        const Rect rect{0, first_row, size, size - first_row};
        const dvec4 above = face == 0 ? dvec4(0, 0, -1, 0) : dvec4(0, 1, 0, 0);
        scene::IdPass options;
        options.scissor = {.test = true, .box = rect};
        options.clip = {.enable = true, .plane = above - dvec4(0, 0, 0, horizon * model.extent)};
        for (Command& command : scene::id_pass(model.joined, view, options).commands)
            list.commands.push_back(std::move(command));
        list.add(Read{.key = face, .plane = Plane::Color, .rect = rect, .packed = true});
        IdBuffer& buffer = buffers[face];
        buffer.size = rect.width;
        buffer.rows = rect.height;
        buffer.pixels.resize(rect.area());
        machine_->read_into(face, buffer.pixels);
    }
    machine_->execute(list);
    machine_->reset_passes();
    for (IdBuffer& buffer : buffers) {
        buffer.present.assign(model.facets.size() + 1, 0);
        mark_present_ids(buffer.pixels, std::size_t(buffer.size), buffer.present.data());
    }
}

DeltaFormFactors delta_form_factors(int size) {
    return {size, pixels(size, size, -1, -1, top_integral),
            pixels(size, size / 2, -1, 0, side_integral)};
}

}  // namespace gw::radiosity
