// Translucent objects [K3.4]: sorted, unsorted, in exact layers; against blending worked out by
// hand.
#include "gw/base/arithmetic.h"
#include "gw/error.h"
#include "inspect/replay/forwarding_machine.h"
#include "multipass/effects/translucency.h"
#include "multipass/frame/driver.h"
#include "tests/multipass/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace gw::multipass {
namespace {

constexpr int size = 16;
constexpr std::size_t middle = size / 2 * size + size / 2;

/// Squares behind one another at z = 0, 1, 2 ..., seen from +z; each has its own light only (Ke).
struct Stack {
    scene::Scene s;
    Stack() {
        s.camera =
            scene::Camera{.eye = {0, 0, 9}, .near_plane = 1, .far_plane = 20, .ortho_height = 4};
    }
    Stack& add(const vec3& Ke, float d) {
        const double z = double(s.objects.size());
        add_square(s, "square", {.Ka = vec3(0), .Kd = vec3(0), .Ke = Ke, .d = d}, {0, 0, z});
        return *this;
    }
    Stack& reverse() {
        std::reverse(s.objects.begin(), s.objects.end());
        return *this;
    }
};

Rgba draw(const scene::Scene& s, Translucency translucency, const Profile& profile = vgx()) {
    const auto machine = make_reference(profile, size, size);
    render(*machine, s, scene::make_view(s, size, size), {.translucency = translucency});
    return machine->planes().color[middle];
}

/// `colors` over one another, each with its opacity; the first is opaque.
double over(std::initializer_list<std::pair<double, double>> colors) {
    double sum = 0;
    for (const auto& [c, d] : colors) sum = sum * (1 - d) + c * d;
    return sum;
}

TEST(Translucency, BlendsOneOverAnOpaqueObject) {
    for (const Translucency t :
         {Translucency::Sorted, Translucency::Unsorted, Translucency::Layers}) {
        const Rgba seen = draw(Stack().add({1, 0, 0}, 1).add({0, 1, 0}, 0.25f).s, t);
        // alpha = 64 of 255; 255 (1 - a) = 191, 255 a = 64.
        EXPECT_EQ(seen, (Rgba{191, 64, 0, 255})) << int(t);
    }
}

TEST(Translucency, SortsFarToNearWhateverTheOrderOfTheScene) {
    Stack stack =
        Stack().add({1, 1, 1}, 1).add({1, 0, 0}, 0.5f).add({0, 1, 0}, 0.5f).add({0, 0, 1}, 0.5f);
    const double red = over({{1, 1}, {1, 0.5}, {0, 0.5}, {0, 0.5}}),
                 green = over({{1, 1}, {0, 0.5}, {1, 0.5}, {0, 0.5}}),
                 blue = over({{1, 1}, {0, 0.5}, {0, 0.5}, {1, 0.5}});
    for (int i = 0; i < 2; ++i, stack.reverse())
        for (const Translucency t : {Translucency::Sorted, Translucency::Layers}) {
            const Rgba seen = draw(stack.s, t);
            EXPECT_NEAR(seen[0], 255 * red, 2) << int(t);
            EXPECT_NEAR(seen[1], 255 * green, 2) << int(t);
            EXPECT_NEAR(seen[2], 255 * blue, 2) << int(t);
        }
}

TEST(Translucency, UnsortedIsWrongWhereObjectsOverlap) {
    Stack stack = Stack().add({1, 1, 1}, 1).add({1, 0, 0}, 0.5f).add({0, 0, 1}, 0.5f);
    EXPECT_EQ(draw(stack.s, Translucency::Unsorted), draw(stack.s, Translucency::Sorted))
        << "they come far to near";
    const Rgba right = draw(stack.reverse().s, Translucency::Sorted),
               wrong = draw(stack.s, Translucency::Unsorted);
    EXPECT_GT(right[2], right[0]) << "the blue one is in front";
    EXPECT_LT(wrong[2], wrong[0]) << "as if it was behind";
}

TEST(Translucency, SeesNothingBehindAnOpaqueObject) {
    for (const Translucency t :
         {Translucency::Sorted, Translucency::Unsorted, Translucency::Layers})
        EXPECT_EQ(draw(Stack().add({1, 0, 0}, 0.5f).add({0, 1, 0}, 1).s, t),
                  (Rgba{0, 255, 0, 255}));
}

/// Two squares that pierce each other in a cross, in front of white.
scene::Scene crossed() {
    Stack stack;
    stack.add({1, 1, 1}, 1).add({1, 0, 0}, 0.5f).add({0, 0, 1}, 0.5f);
    stack.s.objects[1].world_from_object[0].z = 1;
    stack.s.objects[2].world_from_object[0].z = -1;
    stack.s.objects[1].world_from_object[3] = stack.s.objects[2].world_from_object[3] =
        dvec4(0, 0, 3, 1);
    return stack.s;
}

TEST(Translucency, LayersAreRightWhereObjectsPierceEachOther) {
    const auto machine = make_reference(vgx(), size, size);
    const scene::Scene s = crossed();
    render(*machine, s, scene::make_view(s, size, size), {.translucency = Translucency::Layers});
    const auto& color = machine->planes().color;
    // The red square is nearer on the right, the blue one on the left.
    const Rgba left = color[size / 2 * size + 5], right = color[size / 2 * size + 10];
    EXPECT_NEAR(left[2], 255 * over({{1, 1}, {0, 0.5}, {1, 0.5}}), 2);
    EXPECT_NEAR(left[0], 255 * over({{1, 1}, {1, 0.5}, {0, 0.5}}), 2);
    EXPECT_NEAR(right[0], 255 * over({{1, 1}, {0, 0.5}, {1, 0.5}}), 2);
    EXPECT_NEAR(right[2], 255 * over({{1, 1}, {1, 0.5}, {0, 0.5}}), 2);
}

TEST(Translucency, EachComponentIsBlendedByItself) {
    // Two lights, three components and a reflection map on two layers, against the same by hand.
    Stack stack = Stack().add({0.5f, 0.5f, 0.5f}, 1).add(vec3(0), 0.5f).add(vec3(0), 0.25f);
    for (std::size_t i : {1u, 2u}) {
        scene::Material& m = stack.s.materials[i];
        m.Ka = vec3(0.2f);
        m.Kd = vec3(i == 1 ? 0.6f : 0.1f);
        m.Ks = vec3(i == 2 ? 0.5f : 0);
        m.refl = {plain_map(0, 0, 100)};
    }
    stack.s.lights.push_back(
        {.direction = {0, 0, -1}, .Ia = vec3(0.5f), .Id = vec3(0.5f), .Is = vec3(0.4f)});
    stack.s.lights.push_back(stack.s.lights[0]);
    const double far = 2 * (0.5 * 0.2 + 0.5 * 0.6), near = 2 * (0.5 * 0.2 + 0.5 * 0.1 + 0.4 * 0.5);
    for (const Translucency t : {Translucency::Sorted, Translucency::Layers}) {
        const Rgba seen = draw(stack.s, t, ideal());
        EXPECT_NEAR(seen[0] / 65535.0, over({{0.5, 1}, {far, 0.5}, {near, 0.25}}), 1e-3) << int(t);
        EXPECT_NEAR(seen[2] / 65535.0, over({{0.5, 1}, {far, 0.5}, {near + 0.5 * 100 / 255, 0.25}}),
                    1e-3)
            << int(t);
    }
}

TEST(Translucency, MoreImagesThanTheAccumulationBufferHoldsSaturate) {
    // 200 lights of 1/255 on a half translucent square: 200 images on a machine that holds 128.
    Stack stack = Stack().add(vec3(0), 1).add(vec3(0), 0.5f);
    stack.s.materials[1].Kd = vec3(1);
    stack.s.lights.assign(200, {.direction = {0, 0, -1}, .Id = vec3(2 / 255.0f)});
    EXPECT_EQ(draw(stack.s, Translucency::Sorted), (Rgba{200, 200, 200, 255}));
    stack.s.lights.assign(400, stack.s.lights[0]);
    EXPECT_EQ(draw(stack.s, Translucency::Sorted), (Rgba{255, 255, 255, 255}));
}

TEST(Translucency, AnyNumberOfWhiteImagesIsWhite) {
    // The buffer holds 128 of them; what goes through the frame buffer and is loaded again is one.
    Stack stack = Stack().add(vec3(0), 1).add(vec3(0), 0.999f);
    stack.s.materials[1].Kd = vec3(1);
    for (const std::size_t lights : {127u, 128u, 129u, 254u, 255u, 256u, 257u}) {
        stack.s.lights.assign(lights, {.direction = {0, 0, -1}, .Id = vec3(1)});
        EXPECT_EQ(draw(stack.s, Translucency::Sorted), (Rgba{255, 255, 255, 255})) << lights;
    }
}

TEST(Translucency, FogOfAllObjects) {
    // Step 2: the opaque square's fog, dimmed by the translucent one, whose own fog is over it.
    for (const Translucency t : {Translucency::Sorted, Translucency::Layers}) {
        Stack stack = Stack().add({1, 0, 0}, 1).add({0, 1, 0}, 0.5f);
        stack.s.camera->ortho_height = 0;
        stack.s.fog =
            // distances 9 and 8: half and 6/10 left
            scene::Fog{.color = {0, 0, 1}, .start = 4, .end = 14};
        const Rgba seen = draw(stack.s, t);
        EXPECT_NEAR(seen[0], 255 * over({{0.5, 1}, {0, 0.5}}), 3);
        EXPECT_NEAR(seen[1], 255 * over({{0, 1}, {0.6, 0.5}}), 3);
        EXPECT_NEAR(seen[2], 255 * over({{0.5, 1}, {0.4, 0.5}}), 3);
    }
}

TEST(Translucency, HardwareBlendsEquation1) {
    const auto machine = make_reference(vgx(), size, size);
    const scene::Scene s = Stack().add({1, 0, 0}, 1).add({0, 1, 0}, 0.25f).s;
    render(*machine, s, scene::make_view(s, size, size), {.renderer = Renderer::Hardware});
    EXPECT_EQ(machine->planes().color[middle], (Rgba{191, 64, 0, 255}));
}

TEST(FarToNear, PutsPolygonsOfAllObjectsInOneOrder) {
    const scene::Scene s =
        Stack().add(vec3(0), 0.5f).add(vec3(0), 0.5f).add(vec3(0), 1).reverse().s;
    const PassModel model = make_pass_model(s);
    const auto order = far_to_near(place_model(model, scene::make_view(s, size, size)));
    ASSERT_EQ(order.size(), 2u);
    EXPECT_EQ(order[0].part, 2u);  // at z = 0
    EXPECT_EQ(order[1].part, 1u);
    EXPECT_EQ(order[0].of(s.objects[2].mesh)->triangles().size(), 2u);
}

TEST(FarToNear, GoesByTheCentroidWhicheverCornerIsFirst) {
    for (std::size_t first = 0; first < 3; ++first) {
        scene::Scene s;
        s.materials.push_back({.d = 0.5f});
        const auto add = [&](std::vector<vec3> corners) {
            std::rotate(corners.begin(), corners.begin() + std::ptrdiff_t(first), corners.end());
            s.objects.push_back(
                {.name = "triangle", .mesh = make_mesh({.positions = std::move(corners)})});
        };
        add({{-1, -1, 1}, {1, -1, 1}, {0, 1, 1}});
        // farther in the mean, with the nearest corner of all
        add({{-1, -1, 2}, {1, -1, 0}, {0, 1, 0}});
        s.camera =
            scene::Camera{.eye = {0, 0, 9}, .near_plane = 1, .far_plane = 20, .ortho_height = 4};
        const PassModel model = make_pass_model(s);
        const auto order = far_to_near(place_model(model, scene::make_view(s, size, size)));
        ASSERT_EQ(order.size(), 2u);
        EXPECT_EQ(order[0].part, 1u) << first;
    }
}

/// Rows of small triangles in a slanted plane, by turns of two parts.
TEST(FarToNear, GathersThePiecesOfOnePlane) {
    for (const bool bent : {false, true}) {
        scene::Scene s;
        s.materials = {{.d = 0.25f}, {.d = 0.75f}};
        for (const int part : {0, 1}) {
            MeshData data;
            for (int i = part; i < 20; i += 2) {
                const float y = float(i) / 10 - 1, z = bent ? y * y : y / 3;
                data.positions.insert(
                    data.positions.end(),
                    {{-1, y, z}, {1, y, z}, {0, y + 0.1f, bent ? z : z + 0.1f / 3}});
            }
            s.objects.push_back({.name = "leaf",
                                 .mesh = make_mesh(std::move(data)),
                                 .material = std::size_t(part)});
        }
        s.camera =
            scene::Camera{.eye = {0, 0, 9}, .near_plane = 1, .far_plane = 20, .ortho_height = 4};
        const auto portions = [&] {
            const PassModel model = make_pass_model(s);
            return far_to_near(place_model(model, scene::make_view(s, size, size))).size();
        };
        EXPECT_EQ(portions(), bent ? 11u : 2u);
        s.objects[1].name = "another";
        EXPECT_EQ(portions(), bent ? 11u : 20u);
    }
}

TEST(Translucency, OfManyPiecesComesInSeveralLists) {
    constexpr int pieces = 35'000;
    Stack stack = Stack().add({0, 0, 0.5f}, 1);
    for (const int k : {0, 1}) {
        MeshData data;
        for (int i = 0; i < pieces; ++i) {
            const float x = float(i % 64) / 16 - 2, y = float(i / 64 % 64) / 16 - 2,
                        z = 1 + float(2 * i + k) / (2 * pieces);
            data.positions.insert(data.positions.end(),
                                  {{x, y, z}, {x + 0.5f, y, z}, {x, y + 0.5f, z}});
        }
        stack.s.objects.push_back({.name = "pieces",
                                   .mesh = make_mesh(std::move(data)),
                                   .material = stack.s.materials.size()});
        stack.s.materials.push_back(
            {.Ka = vec3(0), .Kd = vec3(0), .Ke = k ? vec3(1, 0, 0) : vec3(0, 1, 0), .d = 0.125f});
    }
    const auto in_parts = make_fast(vgx(), size, size), at_once = make_fast(vgx(), size, size);
    std::vector<CommandList> lists;
    inspect::Recorder recorder(*in_parts, lists);
    render(recorder, stack.s, scene::make_view(stack.s, size, size), {});
    CommandList all;
    for (const CommandList& list : lists) {
        EXPECT_LT(list.commands.size(), std::size_t{1 << 16} + 16);
        all.append(list);
    }
    at_once->execute(all);
    EXPECT_GT(all.commands.size(), std::size_t{4 * pieces});
    EXPECT_TRUE(in_parts->planes() == at_once->planes());
    EXPECT_TRUE(in_parts->passes() == at_once->passes());
}

TEST(Layers, CountAllFacesAPixelShows) {
    Stack stack = Stack().add(vec3(0), 0.5f).add(vec3(0), 1).add(vec3(0), 0.5f).add(vec3(0), 0.5f);
    const PassModel model = make_pass_model(stack.s);
    const scene::View view = scene::make_view(stack.s, size, size);
    const auto machine = make_reference(vgx(), size, size);
    machine->execute(frame_list(
        stack.s, view, passes_for(stack.s, Renderer::Multipass, Translucency::Layers), vec3(0)));
    const Layers layers = find_layers(*machine, place_model(model, view));
    EXPECT_EQ(layers.depth.size(), 2u) << "the first square is behind the opaque one";
    EXPECT_GT(layers.depth[0][middle], layers.depth[1][middle]);
    Profile small = vgx();
    small.stencil_bits = 1;
    EXPECT_THROW(draw(stack.s, Translucency::Layers, small), Error);
}

TEST(Layers, AreOneOfEqualDepthsAndNoneInTheOpaquePlane) {
    Stack stack = Stack().add(vec3(0), 1).add(vec3(0), 0.5f);
    const scene::Material translucent = stack.s.materials[1];
    for (const double z : {0.0, 1.0}) add_square(stack.s, "in the plane", translucent, {0, 0, z});
    const PassModel model = make_pass_model(stack.s);
    const scene::View view = scene::make_view(stack.s, size, size);
    const auto machine = make_reference(vgx(), size, size);
    machine->execute(frame_list(
        stack.s, view, passes_for(stack.s, Renderer::Multipass, Translucency::Layers), vec3(0)));
    const Layers layers = find_layers(*machine, place_model(model, view));
    ASSERT_EQ(layers.depth.size(), 1u);
    EXPECT_EQ(layers.present[0][middle], 1u);
    EXPECT_LT(layers.depth[0][middle], layers.opaque[middle]);
}

}  // namespace
}  // namespace gw::multipass
