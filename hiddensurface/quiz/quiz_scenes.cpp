#include "hiddensurface/quiz/quiz_scenes.h"

#include "gw/base/elementary.h"

#include <cmath>
#include <string>

namespace gw::hiddensurface {
namespace {

constexpr vec3 colors[quiz_colors] = {
    {0.90f, 0.45f, 0.35f}, {0.30f, 0.65f, 0.70f}, {0.85f, 0.78f, 0.45f}, {0.45f, 0.60f, 0.90f},
    {0.55f, 0.75f, 0.40f}, {0.75f, 0.50f, 0.80f}, {0.80f, 0.80f, 0.80f}, {0.90f, 0.65f, 0.25f}};

/// Adds a polygon as an object of its own, so that each has a colour.
void add_polygon(scene::Scene& scene, std::vector<vec3> corners) {
    const std::string name = std::to_string(scene.objects.size() + 1);
    const vec3 color = colors[scene.objects.size() % quiz_colors];
    scene.materials.push_back({.name = "color" + name, .Ka = color, .Kd = color});
    MeshData data{.primitive = Primitive::Polygons, .positions = std::move(corners)};
    scene.objects.push_back({.name = "polygon" + name,
                             .mesh = make_mesh(std::move(data)),
                             .material = scene.objects.size()});
}

scene::Scene empty_scene(const dvec3& eye) {
    scene::Scene scene;
    scene.camera = scene::Camera{.eye = eye, .at = {0, 0, 0}, .fov = 40};
    scene.background = {0.05f, 0.06f, 0.1f};
    return scene;
}

}  // namespace

QuizRandom::QuizRandom(std::uint32_t seed, std::uint32_t number) {
    std::seed_seq both{seed, number};  // its numbers are the standard's
    engine_.seed(both);
}
double QuizRandom::operator()(double low, double high) {
    return low + (high - low) * (double(engine_()) / 4294967295.0);
}
int QuizRandom::whole(int low, int high) {
    return low + int(engine_() % std::uint32_t(high - low + 1));
}

scene::Scene tilted_polygons(QuizRandom& random, int count, int corners, double size) {
    scene::Scene scene = empty_scene({0, 0, 6});
    for (int i = 0; i < count; ++i) {
        const double z = random(-0.8, 0.8), y = random(-0.6, 0.6), x = random(-0.8, 0.8);
        const dvec3 c(x, y, z);
        const double turn = random(0, 6.28), tilt = random(-0.9, 0.9);
        const dvec3 u(gw::cos(turn), gw::sin(turn), tilt),
            v(-gw::sin(turn), gw::cos(turn), random(-0.9, 0.9));
        const double a = size * random(0.7, 1.5), b = size * random(0.4, 1.2);
        if (corners == 4)
            add_polygon(scene, {vec3(c - a * u - b * v), vec3(c + a * u - b * v),
                                vec3(c + a * u + b * v), vec3(c - a * u + b * v)});
        else
            add_polygon(scene, {vec3(c - a * u - b * v), vec3(c + a * u - b * v),
                                vec3(c + random(-0.5, 0.5) * u + 1.2 * b * v)});
    }
    return scene;
}

scene::Scene facing_rectangles(QuizRandom& random, int count, std::vector<int>& distances) {
    scene::Scene scene = empty_scene({0, 0, 20});
    scene.camera->ortho_height = 4.4;
    distances.clear();
    std::vector<int> free;
    for (int d = 2; d < 2 + 2 * count; ++d) free.push_back(d);
    for (int i = 0; i < count; ++i) {
        const auto pick = std::size_t(random.whole(0, int(free.size()) - 1));
        distances.push_back(free[pick]);
        free.erase(free.begin() + std::ptrdiff_t(pick));
        const double w = random(0.7, 1.6), h = random(0.6, 1.3), x = random(-1.2, 1.2),
                     y = random(-0.7, 0.7);
        const double z = 20 - distances.back();
        add_polygon(scene, {vec3(dvec3(x - w, y - h, z)), vec3(dvec3(x + w, y - h, z)),
                            vec3(dvec3(x + w, y + h, z)), vec3(dvec3(x - w, y + h, z))});
    }
    return scene;
}

scene::Scene whole_number_solid(QuizRandom& random) {
    dvec3 eye(0);
    while (std::abs(eye.x) + std::abs(eye.y) + std::abs(eye.z) < 9 || eye.z < 3)
        eye = {double(random.whole(-7, 7)), double(random.whole(-5, 5)),
               double(random.whole(3, 8))};
    scene::Scene scene = empty_scene(eye);
    // A prism over a triangle or a square, leaning.
    const int n = random.whole(3, 4);
    const int back = random.whole(-1, 1), aside = random.whole(-1, 1);
    const vec3 top(float(aside), 2, float(back));
    std::vector<vec3> base{{-2, -1, 1}, {2, -1, float(random.whole(0, 2))}};
    if (n == 4) base.push_back({2, -1, -2});
    base.push_back({float(random.whole(-2, n == 4 ? -2 : 0)), -1, -2});
    std::vector<vec3> lid;
    for (const vec3& p : base) lid.push_back(p + top);
    add_polygon(scene, lid);
    add_polygon(scene, {base.rbegin(), base.rend()});
    for (std::size_t k = 0; k < base.size(); ++k) {
        const std::size_t next = (k + 1) % base.size();
        add_polygon(scene, {base[k], base[next], lid[next], lid[k]});
    }
    return scene;
}

}  // namespace gw::hiddensurface
