// Both colour planes and both lit sides, which the player makes of one plane and one colour.
#include "tests/peer/compare.h"

namespace gw {
namespace {

using namespace test;

class PlanesAndSides : public Driver {};
INSTANTIATE_TEST_SUITE_P(AgainstMesa, PlanesAndSides, testing::Values("llvmpipe", "softpipe"),
                         [](const auto& driver) { return std::string(driver.param); });

Clear clear_to(float red, float green) {
    return {.planes = mask_of(Plane::Color), .color = {red, green, 0, 1}};
}

State drawing_to(DrawBuffer buffer) {
    State s = window_state();
    s.draw_buffer = buffer;
    s.read_buffer = buffer == DrawBuffer::Back ? ReadBuffer::Back : ReadBuffer::Front;
    return s;
}

TEST_P(PlanesAndSides, BackPlanesAreDrawnCopiedAndExchanged) {
    CommandList list;
    add(list, drawing_to(DrawBuffer::Back), clear_to(1, 0));
    add(list, drawing_to(DrawBuffer::Front), clear_to(0, 1));
    State corner = drawing_to(DrawBuffer::Back);
    corner.scissor = {true, {0, 0, 5, 7}};
    add(list, corner, clear_to(1, 1));
    add(list, drawing_to(DrawBuffer::Back), Copy{.source = {0, 0, 9, 9}, .x = 20, .y = 30});
    for (const bool exchanged : {false, true}) {
        if (exchanged) list.add(SwapBuffers{});
        const Planes ours = execute({list}, size, size, opengl())[0];
        const Planes theirs = play({list}, opengl()).planes[0];
        EXPECT_EQ(ours.color, theirs.color);
        EXPECT_EQ(ours.back, theirs.back);
        EXPECT_NE(ours.color, ours.back);
    }
}

/// Lit from behind: the front is ambient red, the back diffuse green.
TEST_P(PlanesAndSides, BackFacesHaveTheColoursOfTheBack) {
    auto lights = std::make_shared<std::vector<Light>>();
    lights->push_back({.position = {0, 0, -1, 0}, .Ia = {1, 1, 1}, .Id = {1, 1, 1}, .Is = {}});
    State s = window_state();
    s.color_source = ColorSource::Lighting;
    s.shade_model = ShadeModel::Flat;
    s.lighting.two_side = true;
    Random random(77);
    std::vector<GridTriangle> triangles;
    CommandList list;
    for (int i = 0; i < 40; ++i) {
        triangles.push_back(random_triangle(random));
        Draw draw{.mesh = make_mesh(mesh_of(triangles.back(), {0, 0, 0}, {}))};
        draw.material = {.Ka = {1, 0, 0}, .Kd = {}};
        draw.back_material = std::make_shared<const Material>(Material{.Ka = {}, .Kd = {0, 1, 0}});
        draw.lights = lights;
        add(list, s, draw);
    }
    const Planes ours = execute({list}, size, size)[0], theirs = play({list}).planes[0];
    long red = 0, green = 0;
    for_pixels([&](int x, int y, std::size_t i) {
        if (near_side(triangles, x, y)) return;
        EXPECT_EQ(ours.color[i], theirs.color[i]) << x << " " << y;
        red += ours.color[i][0] == 255;
        green += ours.color[i][1] == 255;
    });
    EXPECT_GT(red, 50);
    EXPECT_GT(green, 50);
}

}  // namespace
}  // namespace gw
