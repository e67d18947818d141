#include "multipass/frame/samples.h"

#include "gw/base/elementary.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace gw::multipass {
namespace {

/// What is spread; light i is OverLight + i.
enum Kind : unsigned { OverPixel, OverLens, OverMoment, OverGlare, OverLight };

/// 0.b0 b1 b2 ... in binary, for i = ... b2 b1 b0.
double mirrored(std::size_t i) {
    double value = 0;
    for (double digit = 0.5; i > 0; i >>= 1, digit /= 2) value += double(i & 1) * digit;
    return value;
}

/// A number without common divisors with n: about 0.618 n for kind 0, another for each other kind.
/// Its multiples mod n are an order of 0 .. n - 1 that jumps far.
std::size_t stride(std::size_t n, unsigned kind) {
    const double golden = 0.6180339887498949 * (kind + 1);
    std::size_t step =
        std::max<std::size_t>(1, std::size_t((golden - std::floor(golden)) * double(n)));
    while (std::gcd(step, n) != 1) ++step;
    return step;
}

dvec3 area_point(const scene::AreaLight& area, const dvec2& square) {
    using Shape = scene::AreaLight::Shape;
    const dvec2 centered = square * 2.0 - dvec2(1);
    switch (area.shape) {
        case Shape::None: return dvec3(0);
        case Shape::Line: return dvec3(area.u) * centered.x;
        case Shape::Rectangle: return dvec3(area.u) * centered.x + dvec3(area.v) * centered.y;
        case Shape::Disc: break;
    }
    const dvec2 p = on_disc(square);
    return dvec3(area.u) * p.x + dvec3(area.v) * p.y;
}

}  // namespace

dvec2 spread(const Sample& sample, unsigned kind) {
    const std::size_t n = sample.count;
    const std::size_t i =
        kind == OverPixel ? sample.index : (sample.index * stride(n, kind) + kind) % n;
    return {(double(i) + 0.5) / double(n), mirrored(i) + 0.5 / double(std::bit_ceil(n))};
}

dvec2 on_disc(const dvec2& square) {
    const double a = 2 * square.x - 1, b = 2 * square.y - 1;
    if (a == 0 && b == 0) return dvec2(0);
    const bool wide = std::abs(a) > std::abs(b);
    const double r = wide ? a : b, angle = wide ? pi / 4 * (b / a) : pi / 2 - pi / 4 * (a / b);
    return {r * gw::cos(angle), r * gw::sin(angle)};
}

int samples_of(const scene::Scene& scene) {
    int most = scene.camera && scene.camera->aperture > 0 ? 16 : 1;
    for (const scene::Light& l : scene.lights)
        if (l.area.shape != scene::AreaLight::Shape::None) most = std::max(most, l.area.samples);
    for (const scene::Object& o : scene.objects) {
        if (o.move != dvec3(0)) most = std::max(most, 16);
        if (o.glare) most = std::max(most, o.glare->samples);
    }
    return most;
}

JitterState jitter_of(const Sample& sample, int subpixel_bits) {
    if (sample.count == 1) return {};
    const int grid = 1 << subpixel_bits;
    const dvec2 p = spread(sample, OverPixel);
    return {int(p.x * grid) - grid / 2, int(p.y * grid) - grid / 2};
}

bool moves(const scene::Scene& scene) {
    return std::any_of(scene.objects.begin(), scene.objects.end(),
                       [](const scene::Object& o) { return o.move != dvec3(0); }) ||
           std::any_of(scene.lights.begin(), scene.lights.end(), [](const scene::Light& l) {
               return l.area.shape != scene::AreaLight::Shape::None;
           });
}

void move_to(scene::Scene& now, const scene::Scene& still, const Sample& sample) {
    if (sample.count == 1) return;
    const double time = spread(sample, OverMoment).x - 0.5;
    for (std::size_t i = 0; i < now.objects.size(); ++i)
        now.objects[i].world_from_object[3] =
            still.objects[i].world_from_object[3] + dvec4(still.objects[i].move * time, 0);
    for (std::size_t i = 0; i < now.lights.size(); ++i) {
        const scene::Light& l = still.lights[i];
        const vec3 moved(area_point(l.area, spread(sample, OverLight + unsigned(i))));
        if (l.kind == scene::LightKind::Directional)
            now.lights[i].direction = l.direction + moved;
        else
            now.lights[i].position = l.position + moved;
    }
}

scene::View view_at(const scene::View& view, const Sample& sample) {
    const scene::Camera& camera = view.camera;
    if (sample.count == 1 || !(camera.aperture > 0)) return view;
    const dvec2 shift = on_disc(spread(sample, OverLens)) * camera.aperture;
    const dvec3 line = camera.at - camera.eye;
    const double focus = camera.focus > 0 ? camera.focus : length(line);
    scene::View out = view;
    out.eye_from_world[3] -= dvec4(shift, 0, 0);
    out.clip_from_eye[2].x -= view.clip_from_eye[0].x * shift.x / focus;
    out.clip_from_eye[2].y -= view.clip_from_eye[1].y * shift.y / focus;
    return out;
}

dvec3 glare_displacement(const scene::Glare& g, const Sample& sample) {
    const dvec2 square = spread(sample, OverGlare);
    if (g.rays == 0) return dvec3(on_disc(square) * g.radius, 0);
    // A point of one of the rays; each ray has its share of the samples.
    const double along = square.x * g.rays, ray = std::floor(along);
    const double angle = 2 * pi * ray / g.rays, distance = (along - ray) * g.radius;
    return {distance * gw::sin(angle), distance * gw::cos(angle), 0};
}

}  // namespace gw::multipass
