// Components behind panes [K3.4, K3.5]: their images add up to the picture.
#include "multipass/frame/driver.h"
#include "tests/multipass/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace gw::multipass {
namespace {

constexpr int size = 16;
constexpr std::size_t middle = size / 2 * size + size / 2;

/// A wall whose components saturate together, and panes before it.
scene::Scene wall_behind_panes(int panes) {
    scene::Scene s;
    add_square(s, "wall", {.Ka = vec3(0.9f), .Kd = vec3(0.6f, 0.4f, 0), .Ke = vec3(0, 0, 0.3f)});
    for (int i = 0; i < panes; ++i)
        add_square(s, "pane", {.Ka = vec3(0.3f), .Kd = vec3(0, 0.5f, 0.2f), .d = 0.5f},
                   {0.4 * i, 0, 0.5 + 0.5 * i});
    s.lights.push_back({.direction = {0, 0, -1}, .Ia = vec3(0.9f), .Id = vec3(0.7f)});
    s.camera = scene::Camera{.eye = {0, 0, 5}, .near_plane = 1, .far_plane = 9, .ortho_height = 3};
    return s;
}

std::vector<ComponentImage> images_of(const scene::Scene& s, const Options& options) {
    const auto machine = make_reference(vgx(), size, size);
    return render_components(*machine, s, scene::make_view(s, size, size), options);
}

std::vector<Rgba> picture_of(const scene::Scene& s, const Options& options) {
    const auto machine = make_reference(vgx(), size, size);
    render(*machine, s, scene::make_view(s, size, size), options);
    return machine->planes().color;
}

TEST(Components, AddUpBehindPanesWhateverTheirOrderFogAndSamples) {
    for (const int panes : {1, 2})
        for (const bool fog : {false, true})
            for (const int samples : {1, 3})
                for (const Translucency translucency :
                     {Translucency::Sorted, Translucency::Unsorted, Translucency::Layers}) {
                    scene::Scene s = wall_behind_panes(panes);
                    if (fog)
                        s.fog = scene::Fog{
                            .mode = FogMode::Exp, .color = {0.4f, 0.5f, 0.6f}, .density = 0.1f};
                    const Options options{.translucency = translucency, .samples = samples};
                    EXPECT_EQ(sum_of(images_of(s, options), vgx()), picture_of(s, options))
                        << panes << " panes, fog " << fog << ", " << samples << " samples, order "
                        << int(translucency);
                }
}

/// A square of 8 x 8 pixels, from pixel 4 on, whose two components are of this strength.
scene::Scene lone_square(float strength) {
    scene::Scene s;
    add_square(s, "square", {.Ka = vec3(strength), .Kd = vec3(strength)});
    s.lights.push_back({.direction = {0, 0, -1}, .Ia = vec3(0.9f), .Id = vec3(0.7f)});
    s.camera = scene::Camera{.eye = {0, 0, 5}, .near_plane = 1, .far_plane = 9, .ortho_height = 4};
    return s;
}

/// Without panes each image is a mean that is rounded by itself, and of samples that do not
/// saturate where their sum does.
TEST(Components, OfSamplesAddUpWhereNoImageChangesAndNearlyWhereNoSampleSaturates) {
    for (const float strength : {0.37f, 0.9f}) {
        const scene::Scene s = lone_square(strength);
        const Options options{.samples = 7};
        const auto images = images_of(s, options);
        const int most = (int(images.size()) + 1) / 2;
        const auto sum = sum_of(images, vgx()), picture = picture_of(s, options);
        const bool saturates = strength > 0.5f;
        int rounded = 0, darker = 0;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const auto i = std::size_t(y * size + x);
                const int difference = int(sum[i][0]) - int(picture[i][0]);
                const auto inside = [](int v) { return v >= 5 && v <= 10; };
                const auto outside = [](int v) { return v < 3 || v > 12; };
                if ((inside(x) && inside(y)) || outside(x) || outside(y)) {
                    ASSERT_EQ(difference, 0) << x << ' ' << y;
                } else {
                    ASSERT_GE(difference, -most) << x << ' ' << y;
                    ASSERT_TRUE(saturates || difference <= most) << x << ' ' << y;
                    rounded += difference != 0 && std::abs(difference) <= most;
                    darker += difference > most;
                }
            }
        EXPECT_EQ(darker > 0, saturates);
        EXPECT_TRUE(saturates || rounded > 0) << "else the sum is exact";
    }
}

TEST(Components, OfOneEquationAddUpBehindPanes) {
    const scene::Scene s = wall_behind_panes(2);
    const Options options{.renderer = Renderer::Hardware};
    EXPECT_EQ(sum_of(images_of(s, options), vgx()), picture_of(s, options));
}

/// The wall saturates (0.81 + 0.42 > 1) and the pane halves it: 127 in all, of which the first
/// component has its own half, and the second what is left.
TEST(Components, AreDimmedAndSaturatedAsInThePicture) {
    scene::Scene s = wall_behind_panes(1);
    s.materials[1].Ka = s.materials[1].Kd = vec3(0);
    const auto images = images_of(s, {});
    ASSERT_EQ(images[0].name, "ambient");
    ASSERT_EQ(images[1].name, "diffuse");
    const int ambient = images[0].color[middle][0], diffuse = images[1].color[middle][0];
    EXPECT_NEAR(ambient, 0.81 * 127, 1);
    EXPECT_EQ(ambient + diffuse, picture_of(s, {})[middle][0]);
    EXPECT_NEAR(ambient + diffuse, 127, 1);
}

TEST(Components, DimFogBehindAPane) {
    scene::Scene s = wall_behind_panes(1);
    s.fog = scene::Fog{.mode = FogMode::Exp, .color = vec3(1), .density = 0.2f};
    scene::Scene bare = s;
    bare.objects.pop_back();
    const auto fog_in = [](const std::vector<ComponentImage>& images) {
        const auto fog = std::find_if(images.begin(), images.end(),
                                      [](const ComponentImage& i) { return i.name == "fog"; });
        return int(fog->color[middle][2]);
    };
    EXPECT_NEAR(fog_in(images_of(s, {})), fog_in(images_of(bare, {})) / 2, 1);
}

TEST(Components, FogOfDensity0ChangesNothing) {
    scene::Scene s = wall_behind_panes(1);
    const auto bare = picture_of(s, {});
    for (const FogMode mode : {FogMode::Exp, FogMode::Exp2}) {
        s.fog = scene::Fog{.mode = mode, .color = vec3(1), .density = 0};
        EXPECT_EQ(picture_of(s, {}), bare);
    }
}

}  // namespace
}  // namespace gw::multipass
