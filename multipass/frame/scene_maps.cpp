#include "multipass/frame/scene_maps.h"

#include "gw/base/arithmetic.h"
#include "multipass/frame/frame_drawer.h"
#include "multipass/frame/superpose.h"
#include "multipass/steps/commands.h"
#include "scene/draw/nearest.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace gw::multipass {
namespace {

constexpr int positions = 4;  // per texel and direction

/// The pixel of a 90 degree view, `size` pixels wide, that sees x / w, from -1 to 1.
std::size_t pixel(double x, double w, int size) {
    return std::size_t(std::clamp(int((x / w + 1) / 2 * size), 0, size - 1));
}

/// The mean of n values of `max`, as 16 bits.
std::uint16_t mean16(std::uint64_t sum, std::uint64_t n, std::uint64_t max) {
    return static_cast<std::uint16_t>((sum * 65535 * 2 + n * max) / (n * max * 2));
}

/// Pixels of a view for each texel of its map.
constexpr int fineness = 2;
/// The nearest depth of a view in parts of the farthest, if nothing stands before it.
constexpr double near_part = 1.0 / 4096;

std::array<std::vector<scene::Map>*, 2> looked_up_by_ray(scene::Material& m) {
    return {&m.refl, &m.refraction};
}

/// The largest generated map of a material; 0: it has none.
int size_of(const scene::Material& material) {
    int size = 0;
    for (const auto* maps : {&material.refl, &material.refraction})
        for (const scene::Map& map : *maps)
            if (!map.texture) size = std::max(size, map.from_scene);
    return size;
}

/// The part of the scene that the six views show.
scene::Scene surroundings(const scene::Scene& s) {
    scene::Scene out = s;
    for (scene::Material& material : out.materials)
        for (auto* maps : looked_up_by_ray(material))
            std::erase_if(*maps, [](const scene::Map& map) { return map.from_scene > 0; });
    for (scene::Object& item : out.objects) item.glare.reset();
    return out;
}

dvec3 center(const scene::Scene& s, std::size_t index) {
    scene::Scene alone;
    alone.objects.push_back(s.objects[index]);
    const scene::Bounds b = scene::bounds(alone);
    return (b.low + b.high) * 0.5;
}

std::array<scene::View, 6> views_from(const dvec3& p, const scene::Scene& s, int size) {
    const double farthest = std::max(scene::reach_around(p, scene::bounds(s)), 1e-6);
    auto views = scene::cube_views(p, farthest * near_part, farthest, size);
    for (scene::View& view : views)
        view = scene::sparing_near(view, s, scene::edge_on_in_map(view));
    return views;
}

/// The window of width x height pixels whose lower left one is pixel (x, y) of the view.
scene::View window_of(const scene::View& view, int x, int y, int width, int height) {
    scene::View out = view;
    out.width = width;
    out.height = height;
    const double scale_x = double(view.width) / width, scale_y = double(view.height) / height;
    const double shift_x = double(view.width - 2 * x) / width - 1,
                 shift_y = double(view.height - 2 * y) / height - 1;
    for (int column = 0; column < 4; ++column) {
        const dvec4& from = view.clip_from_eye[column];
        out.clip_from_eye[column].x = scale_x * from.x + shift_x * from.w;
        out.clip_from_eye[column].y = scale_y * from.y + shift_y * from.w;
    }
    return out;
}

/// Draws views of one scene.
struct Painter {
    Machine& machine;
    FrameDrawer& drawer;
    std::string what;

    void draw_window(const scene::View& window) {
        superpose(machine, 1, drawer.images(),
                  [&](const Sample& sample) { drawer.draw(window, sample); });
    }

    const std::vector<Rgba>& read(const Rect& rect) {
        CommandList list;
        begin_pass(list, what);
        list.add(Read{.key = 0, .plane = Plane::Color, .rect = rect});
        machine.execute(list);
        return machine.readbacks().at(0).color;
    }

    std::vector<Rgba> draw(const scene::View& view) {
        const int size = view.width, width = machine.planes().width,
                  height = machine.planes().height;
        std::vector<Rgba> color(std::size_t(size) * std::size_t(size));
        for (int y = 0; y < size; y += height)
            for (int x = 0; x < size; x += width) {
                draw_window(window_of(view, x, y, width, height));
                const int columns = std::min(width, size - x), rows = std::min(height, size - y);
                const auto& part = read({0, 0, columns, rows});
                for (int row = 0; row < rows; ++row)
                    std::copy_n(part.begin() + std::ptrdiff_t{row} * columns, columns,
                                color.begin() + std::ptrdiff_t{y + row} * size + x);
            }
        return color;
    }
};

CubePicture draw_around(Machine& machine, scene::Scene s, std::size_t index, int size,
                        const Options& options) {
    const dvec3 p = center(s, index);
    const std::string what = "surroundings of " + s.objects[index].name;
    s.objects.erase(s.objects.begin() + std::ptrdiff_t(index));
    const PassList passes = options.pass_list
                                ? *options.pass_list
                                : passes_for(s, options.renderer, options.translucency);
    CubePicture around{.views = views_from(p, s, size * fineness)};
    FrameDrawer drawer(machine, s, passes, options, s.background);
    Painter painter{machine, drawer, what};
    for (std::size_t face = 0; face < 6; ++face)
        around.colors[face] = painter.draw(around.views[face]);
    return around;
}

bool looks_up(const scene::Scene& s, const Options& options) {
    const PassList passes = options.pass_list
                                ? *options.pass_list
                                : passes_for(s, options.renderer, options.translucency);
    return std::any_of(passes.begin(), passes.end(), [](const Pass& pass) {
        return pass.material.Map == PassMap::Reflection || pass.material.Map == PassMap::Refraction;
    });
}

}  // namespace

const Rgba& CubePicture::seen(const dvec3& direction) const {
    for (std::size_t face = 0; face < 6; ++face) {
        const dvec3 e = transform3(dmat3(views[face].eye_from_world), direction);
        const int size = views[face].width;
        if (-e.z <= 0 || std::abs(e.x) > -e.z || std::abs(e.y) > -e.z) continue;
        return colors[face][pixel(e.y, -e.z, size) * std::size_t(size) + pixel(e.x, -e.z, size)];
    }
    return colors[0][0];
}

dvec3 direction_of(double s, double t) {
    // The point (x, y) of a unit sphere seen from far away reflects the line of sight so.
    const double x = 2 * s - 1, y = 2 * t - 1, r = x * x + y * y;
    if (r >= 1) return {0, 0, -1};
    const double z = std::sqrt(1 - r);
    return {2 * z * x, 2 * z * y, 2 * z * z - 1};
}

TextureRef sphere_map(std::string name, const CubePicture& around, const dmat4& eye_from_world,
                      int size, int color_bits) {
    const dmat3 world_from_eye = glm::transpose(dmat3(eye_from_world));
    const int fine = size * positions;
    const auto side = std::size_t(size);
    std::vector<std::array<std::uint64_t, 3>> sums(side * side);
    for (int j = 0; j < fine; ++j)
        for (int i = 0; i < fine; ++i) {
            const dvec3 d_eye = direction_of((i + 0.5) / fine, (j + 0.5) / fine);
            const Rgba& color = around.seen(transform3(world_from_eye, d_eye));
            auto& sum = sums[std::size_t(j / positions) * side + std::size_t(i / positions)];
            for (std::size_t c = 0; c < 3; ++c) sum[c] += color[c];
        }
    std::vector<std::uint16_t> texels;
    for (const auto& sum : sums) {
        for (const std::uint64_t s : sum)
            texels.push_back(mean16(s, positions * positions, max_of_bits(color_bits)));
        texels.push_back(65535);
    }
    return make_texture(std::move(name), size, size, texels);
}

bool has_scene_maps(const scene::Scene& s, const Options& options) {
    return looks_up(s, options) &&
           std::any_of(s.objects.begin(), s.objects.end(), [&](const scene::Object& item) {
               return size_of(s.materials[item.material]) > 0;
           });
}

scene::Scene with_scene_maps(Machine& machine, const scene::Scene& s, const scene::View& view,
                             const Options& options) {
    scene::Scene out = s;
    if (!has_scene_maps(s, options)) return out;
    const scene::Scene shown = surroundings(s);
    for (std::size_t i = 0; i < s.objects.size(); ++i) {
        scene::Material material = s.materials[s.objects[i].material];
        const int size = size_of(material);
        if (size == 0) continue;
        const CubePicture around = draw_around(machine, shown, i, size, options);
        for (auto* maps : looked_up_by_ray(material))
            for (scene::Map& map : *maps)
                if (map.from_scene > 0 && !map.texture)
                    map.texture = sphere_map("surroundings of " + s.objects[i].name, around,
                                             view.eye_from_world, map.from_scene,
                                             machine.profile().color_bits);
        out.objects[i].material = out.materials.size();
        out.materials.push_back(std::move(material));
    }
    return out;
}

}  // namespace gw::multipass
