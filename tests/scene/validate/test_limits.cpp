// Claims: files and code have the same limits. Both take the ends of a range,
// and refuse what lies beyond with the same words; so it is with the rules that
// join values.
#include <gtest/gtest.h>

#include "scene/text/number.h"
#include "scene/validate/check.h"
#include "tests/scene/folder.h"

namespace gw::scene {
namespace {

constexpr double none = 1e300;

/// A number of a scene, as docs/scenes.md limits it.
struct Limited {
    std::string before, key, after;  ///< in a file
    double low, high;
    void (*set)(Scene&, double);
};

const std::string object = "[[object]]\nshape = 'box'\n", fog = "[fog]\nmode = 'exp'\n",
                  light = "[[light]]\nposition = [0, 0, 0]\n",
                  glare = object + "material = {Ke = 1}\nglare = {",
                  area = light + "area = {shape = 'line', u = [1, 0, 0], ";

const std::vector<Limited> limited{
    {"[camera]\n", "fov", "", 0.1, 179, [](Scene& s, double v) { s.camera->fov = v; }},
    {"[camera]\n", "near", "", 0, none, [](Scene& s, double v) { s.camera->near_plane = v; }},
    {"[camera]\n", "far", "", 0, none, [](Scene& s, double v) { s.camera->far_plane = v; }},
    {"[camera]\n", "ortho", "", 0, none, [](Scene& s, double v) { s.camera->ortho_height = v; }},
    {"[camera]\n", "aperture", "", 0, none, [](Scene& s, double v) { s.camera->aperture = v; }},
    {"[camera]\n", "focus", "", 0, none, [](Scene& s, double v) { s.camera->focus = v; }},
    {fog, "density", "", 0, none, [](Scene& s, double v) { s.fog->density = float(v); }},
    {fog, "start", "", 0, none, [](Scene& s, double v) { s.fog->start = float(v); }},
    {fog, "end", "", 0, none, [](Scene& s, double v) { s.fog->end = float(v); }},
    {light, "cone", "", 0, 90, [](Scene& s, double v) { s.lights[0].cone_angle = v; }},
    {light, "exponent", "", 0, 128,
     [](Scene& s, double v) { s.lights[0].spot_exponent = float(v); }},
    {area, "samples", "}", 1, 4096, [](Scene& s, double v) { s.lights[0].area.samples = int(v); }},
    {"[material.m]\n", "Ns", "", 0, 10000,
     [](Scene& s, double v) { s.materials[0].Ns = float(v); }},
    {"[material.m]\n", "Ni", "", 0.01, 100,
     [](Scene& s, double v) { s.materials[0].Ni = float(v); }},
    {"[material.m]\n", "d", "", 0, 1, [](Scene& s, double v) { s.materials[0].d = float(v); }},
    {"[material.m]\n", "illum", "", 0, 10,
     [](Scene& s, double v) { s.materials[0].illum = int(v); }},
    {"[material.m]\n", "Kd", "", 0, none,
     [](Scene& s, double v) { s.materials[0].Kd = vec3(float(v)); }},
    {glare, "radius", "}", 1e-9, 1e9, [](Scene& s, double v) { s.objects[0].glare->radius = v; }},
    {glare, "strength", "}", 0, none,
     [](Scene& s, double v) { s.objects[0].glare->strength = float(v); }},
    {glare, "rays", "}", 0, 64, [](Scene& s, double v) { s.objects[0].glare->rays = int(v); }},
    {glare, "samples", "}", 1, 4096,
     [](Scene& s, double v) { s.objects[0].glare->samples = int(v); }},
    {object + "pixmap = {", "texels", "}", 1e-9, 1e9,
     [](Scene& s, double v) { s.objects[0].pixmap.texels_per_unit = v; }},
    {"", "texels", "", 1e-9, 1e9, [](Scene& s, double v) { s.texels_per_unit = v; }},
};

Scene whole_scene() {
    Scene scene{.name = "s", .materials = {{.name = "m"}}, .lights = {{.name = "l"}}};
    scene.camera = Camera{};
    scene.fog = Fog{.mode = FogMode::Exp};
    scene.objects.push_back({.name = "o",
                             .mesh = make_mesh({.primitive = Primitive::Triangles,
                                                .positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}),
                             .glare = Glare{}});
    return scene;
}

/// The expectation of a refusal; "no error" stays.
std::string expected_in(const std::string& message) {
    const auto at = message.find("; expected ");
    return at == message.npos ? message : message.substr(at + 2);
}

struct Limits : testing::Test {
    Folder folder;

    std::string in_file(const Limited& row, double value) {
        const std::string line = row.before + row.key + " = " + number_text(value) + row.after;
        const bool has_object = row.before.starts_with(object);
        return expected_in(folder.scene_error("s.toml", line + "\n" + (has_object ? "" : object)));
    }
    std::string in_code(const Limited& row, double value) {
        Scene scene = whole_scene();
        row.set(scene, value);
        return expected_in(folder.error([&] { check_scene(scene); }));
    }
};

TEST_F(Limits, AreTheSameInFilesAndCode) {
    for (const Limited& row : limited) {
        SCOPED_TRACE(row.before + row.key);
        for (const double end : {row.low, row.high}) {
            if (end == none) continue;
            EXPECT_EQ(in_file(row, end), "no error");
            EXPECT_EQ(in_code(row, end), "no error");
        }
        for (const double beyond : {row.low - 1, row.high * 2 + 1}) {
            if (beyond > 1e200) continue;
            const std::string file = in_file(row, beyond), code = in_code(row, beyond);
            EXPECT_EQ(file, code) << beyond;
            EXPECT_EQ(file.substr(0, 8), "expected") << beyond;
        }
    }
}

}  // namespace
}  // namespace gw::scene
