#include "scene/photometry.h"

#include "gw/base/arithmetic.h"
#include "gw/base/elementary.h"
#include "scene/scene.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gw::scene {
namespace {

constexpr double degrees_per_radian = 180 / pi;

/// The place of a value among ascending numbers: between `index` and the next.
struct AnglePlace {
    std::size_t index = 0;
    double part = 0;
};

AnglePlace place_in(const std::vector<double>& numbers, double value) {
    if (numbers.size() == 1) return {};
    const auto above = std::upper_bound(numbers.begin() + 1, numbers.end() - 1, value);
    const auto index = std::size_t(above - numbers.begin()) - 1;
    return {index,
            std::clamp((value - numbers[index]) / (numbers[index + 1] - numbers[index]), 0.0, 1.0)};
}

bool is_beyond(double angle, const std::vector<double>& angles) {
    return angle < angles.front() - 1e-9 || angle > angles.back() + 1e-9;
}

/// Type B: angles from 0 stand for both sides.
double mirrored_at_0(double angle, const std::vector<double>& angles) {
    return angles.front() == 0 ? std::abs(angle) : angle;
}

/// Type C: within the file's horizontal angles, by its symmetry.
double folded(double angle, const std::vector<double>& horizontal) {
    angle -= 360 * std::floor(angle / 360);
    const double last = horizontal.back();
    if (horizontal.front() == 90 && last == 270) {  // the plane from 90 to 270 is a mirror
        return angle < 90 ? 180 - angle : angle > 270 ? 540 - angle : angle;
    }
    if (last > 180) return angle;
    if (angle > 180) angle = 360 - angle;
    return last <= 90 && angle > 90 ? 180 - angle : angle;
}

/// The integral of (f + (g - f) (x - a) / (b - a)) sin x from a to b radians: over directions, of a
/// function linear in the vertical angle.
double band(double a, double b, double f, double g) {
    const double slope = (g - f) / (b - a);
    return f * cos(a) - g * cos(b) + slope * (sin(b) - sin(a));
}

double lumen_of_c(const Photometry& web) {
    const std::vector<double>&vertical = web.vertical, &horizontal = web.horizontal;
    const auto plane = [&](std::size_t h) {
        double sum = 0;
        for (std::size_t v = 0; v + 1 < vertical.size(); ++v)
            sum += band(vertical[v] / degrees_per_radian, vertical[v + 1] / degrees_per_radian,
                        web.candela[h * vertical.size() + v],
                        web.candela[h * vertical.size() + v + 1]);
        return sum;
    };
    if (horizontal.size() == 1) return 2 * pi * plane(0);
    double sum = 0;  // linear between the planes
    for (std::size_t h = 0; h + 1 < horizontal.size(); ++h)
        sum += (plane(h) + plane(h + 1)) / 2 * (horizontal[h + 1] - horizontal[h]);
    return 2 * pi * sum / (horizontal.back() - horizontal.front());
}

/// Planes go through the axis of width, so theirs are the vertical angles.
double lumen_of_b(const Photometry& web) {
    const std::vector<double>&vertical = web.vertical, &horizontal = web.horizontal;
    const auto plane = [&](std::size_t v) {
        double sum = 0;
        for (std::size_t h = 0; h + 1 < horizontal.size(); ++h)
            sum += band((horizontal[h] + 90) / degrees_per_radian,
                        (horizontal[h + 1] + 90) / degrees_per_radian,
                        web.candela[h * vertical.size() + v],
                        web.candela[(h + 1) * vertical.size() + v]);
        return horizontal.front() == 0 ? 2 * sum : sum;
    };
    double sum = 0;
    for (std::size_t v = 0; v + 1 < vertical.size(); ++v)
        sum += (plane(v) + plane(v + 1)) / 2 * (vertical[v + 1] - vertical[v]);
    return (vertical.front() == 0 ? 2 * sum : sum) / degrees_per_radian;
}

struct Angles {
    double vertical = 0, horizontal = 0;
};

/// The angles of a direction, for a luminaire whose straight down is `axis`.
Angles angles_of(Photometry::Type type, const dvec3& axis, const dvec3& direction, double turn) {
    // The shortest turn of -y to the axis takes x and -z there.
    const dvec3 down(0, -1, 0);
    const auto carried = [&](const dvec3& v) {
        const double c = dot3(down, axis);
        if (c < -1 + 1e-12) return dvec3(v.x, -v.y, -v.z);  // half a turn about x
        const dvec3 half = down + axis;
        return v - half * (dot3(v, half) / (1 + c)) + axis * (2 * dot3(v, down));
    };
    const double x = dot3(direction, carried({1, 0, 0})), y = dot3(direction, carried({0, 0, -1})),
                 z = std::clamp(dot3(direction, axis), -1.0, 1.0);
    if (type == Photometry::Type::C)
        return {acos(z) * degrees_per_radian, atan2(y, x) * degrees_per_radian - turn};
    const double c = cos_degrees(turn), s = sin_degrees(turn);
    const double across = std::clamp(s * x - c * y, -1.0, 1.0);
    return {atan2(c * x + s * y, z) * degrees_per_radian, 90 - acos(across) * degrees_per_radian};
}

dvec3 axis_of(const Light& light) {
    const dvec3 d(light.direction);
    return d / length(d);
}

}  // namespace

double luminance_of(const dvec3& color) {
    return 0.2126 * color.x + 0.7152 * color.y + 0.0722 * color.z;
}

dvec3 with_luminance_1(const dvec3& color) { return color / luminance_of(color); }

double Photometry::at(double vertical_angle, double horizontal_angle) const {
    if (type == Type::B) {
        vertical_angle = mirrored_at_0(vertical_angle, vertical);
        horizontal_angle = mirrored_at_0(horizontal_angle, horizontal);
        if (is_beyond(horizontal_angle, horizontal)) return 0;
    } else {
        horizontal_angle = folded(horizontal_angle, horizontal);
    }
    if (is_beyond(vertical_angle, vertical)) return 0;
    const AnglePlace v = place_in(vertical, vertical_angle),
                     h = place_in(horizontal, horizontal_angle);
    const auto along = [&](std::size_t plane) {
        const double* const row = &candela[plane * vertical.size()];
        return row[v.index] * (1 - v.part) + (v.part > 0 ? row[v.index + 1] * v.part : 0);
    };
    return along(h.index) * (1 - h.part) + (h.part > 0 ? along(h.index + 1) * h.part : 0);
}

double Photometry::lumen() const { return type == Type::B ? lumen_of_b(*this) : lumen_of_c(*this); }

dvec3 intensity(const Light& light, const dvec3& direction) {
    if (!light.luminous || light.kind == LightKind::Directional) return dvec3(0);
    const Luminous& luminous = *light.luminous;
    if (luminous.web) {
        const Angles angles =
            angles_of(luminous.web->type, axis_of(light), direction, luminous.turn);
        return luminous.candela * luminous.web->at(angles.vertical, angles.horizontal);
    }
    if (light.kind == LightKind::Point) return luminous.candela;
    const double c = dot3(axis_of(light), direction);
    if (c < cos_degrees(light.cone_angle)) return dvec3(0);
    return luminous.candela * pow(std::max(c, 0.0), double(light.spot_exponent));
}

dvec3 luminous_flux(const Light& light) {
    if (!light.luminous || light.kind == LightKind::Directional) return dvec3(0);
    const Luminous& luminous = *light.luminous;
    if (luminous.web) return luminous.candela * luminous.web->lumen();
    if (light.kind == LightKind::Point) return luminous.candela * (4 * pi);
    const double e = double(light.spot_exponent) + 1;
    return luminous.candela * (2 * pi * (1 - pow(cos_degrees(light.cone_angle), e)) / e);
}

}  // namespace gw::scene
