// Blocks that store the depth plane of the triangle that covers them. The planes differ by less
// than a unit or by one, they cross, they are many, they lie at the ends of the range. The
// reference machine writes every pixel.
#include "conformance/generate/random.h"
#include "tests/gw/workbench.h"

#include <cmath>

namespace gw::test {
namespace {

constexpr int width = 128, height = 80;  ///< whole tiles and tiles cut by the window

/// Two triangles over the window, given by the depths at its lower left, lower right and upper left
/// corners.
void add_sheet(MeshData& data, double low, double right, double up) {
    const std::vector<vec3> corner{
        {0, 0, low}, {width, 0, right}, {width, height, right + up - low}, {0, height, up}};
    for (const std::size_t i : {0, 1, 2, 0, 2, 3}) data.positions.push_back(corner[i]);
}
Draw sheet(double low, double right, double up) {
    MeshData data = mesh_data(Primitive::Triangles, {});
    add_sheet(data, low, right, up);
    return {.mesh = make_mesh(std::move(data)),
            .id_base = std::uint32_t(0x10203 + std::fmod(low + 7 * right, 65536))};
}

State drawn(const Workbench& bench, DepthFunc func, bool mask, bool color) {
    State state = bench.state;
    state.depth = {true, func, mask};
    state.color_source = ColorSource::PolygonId;
    if (!color) state.color_mask = {false, false, false, false};
    return state;
}

/// Draws the sheets in turn. Pixels are compared after the last.
void draw_sheets(const Profile& profile, const std::vector<Draw>& sheets, DepthFunc func, bool mask,
                 bool color) {
    Workbench bench(profile, width, height);
    CommandList list;
    list.add(SetState{drawn(bench, DepthFunc::Always, true, true)});
    list.add(Clear{.planes = all_planes, .color = vec4(0, 0, 1, 1), .depth = 0.5});
    list.add(sheets.front());
    list.add(SetState{drawn(bench, func, mask, color)});
    for (std::size_t i = 1; i < sheets.size(); ++i) list.add(sheets[i]);
    bench.run(list);
    EXPECT_GT(bench.take_counters().fragments, 0u);
}
void draw_under_all_tests(const Profile& profile, const std::vector<Draw>& sheets) {
    for (const DepthFunc func :
         {DepthFunc::Never, DepthFunc::Less, DepthFunc::Equal, DepthFunc::LEqual,
          DepthFunc::Greater, DepthFunc::NotEqual, DepthFunc::GEqual, DepthFunc::Always})
        for (const bool mask : {false, true})
            for (const bool color : {false, true}) {
                SCOPED_TRACE(int(func));
                draw_sheets(profile, sheets, func, mask, color);
            }
}

TEST(DepthPlanes, OfTheSameDepthsAreEqual) {
    draw_under_all_tests(vgx(), {sheet(1000, 3000, 1500), sheet(1000, 3000, 1500)});
}

TEST(DepthPlanes, DifferByPartsOfAUnit) {
    const Draw stored = sheet(1000, 1037, 1011);
    for (const Draw& incoming :
         {sheet(1000, 1037, 1012), sheet(1000, 1038, 1011), sheet(1001, 1037, 1011),
          sheet(999, 1037, 1011), sheet(1000, 1036, 1012)})
        draw_under_all_tests(vgx(), {stored, incoming});
}

TEST(DepthPlanes, DifferByAUnitOrTwo) {
    const Draw stored = sheet(1000, 1037, 1011);
    for (const int by : {-2, -1, 1, 2})
        draw_under_all_tests(vgx(), {stored, sheet(1000 + by, 1037 + by, 1011 + by)});
}

TEST(DepthPlanes, Cross) {
    draw_under_all_tests(vgx(), {sheet(1000, 9000, 1500), sheet(9000, 1000, 1500),
                                 sheet(1500, 1500, 9000), sheet(1000, 9000, 1500)});
    draw_under_all_tests(vgx(), {sheet(1000, 1200, 1500), sheet(1200, 1000, 1500)});
}

TEST(DepthPlanes, OfAllDepthsThereAre) {
    for (const Profile& profile : {vgx(), ideal()}) {
        const double far = std::ldexp(1.0, profile.depth_bits) - 1, half = std::floor(far / 2);
        draw_under_all_tests(profile, {sheet(0, half, half), sheet(half, 0, half),
                                       sheet(far, half, half), sheet(1, half, 2)});
        const Draw level = sheet(half, half, half);
        draw_under_all_tests(profile, {level, sheet(0, std::floor(half / 2), 7)});
        draw_under_all_tests(profile, {level, sheet(far, far - 7, far - std::floor(half / 2))});
    }
}

TEST(DepthPlanes, UnderALevelOne) {
    draw_under_all_tests(
        vgx(), {sheet(1000, 3000, 1500), sheet(1700, 1700, 1700), sheet(900, 3000, 1500)});
}

/// More sheets than a tile stores, one above the other, in one mesh and in a mesh each. Then a part
/// is cleared and drawn again.
TEST(DepthPlanes, ManyOfThem) {
    Workbench bench(vgx(), width, height);
    const State state = drawn(bench, DepthFunc::LEqual, true, true);
    CommandList list;
    list.add(SetState{state});
    list.add(Clear{.planes = all_planes, .depth = 1});
    MeshData data = mesh_data(Primitive::Triangles, {});
    for (int i = 0; i < 300; ++i) add_sheet(data, 9000 - 3 * i, 9500 - 2 * i, 9000 - 3 * i);
    list.add(Draw{.mesh = make_mesh(std::move(data)), .id_base = 5});
    for (int i = 0; i < 300; ++i) list.add(sheet(8000 - 3 * i, 8500 - 2 * i, 8000));
    State part = state;
    part.scissor = {true, {10, 20, 70, 31}};
    list.add(SetState{part});
    list.add(Clear{.planes = all_planes, .depth = 1});
    list.add(sheet(12000, 13000, 12500));
    list.add(SetState{state});
    list.add(sheet(11000, 12000, 13500));
    list.add(Read{.key = 1, .plane = Plane::Depth, .rect = {0, 0, width, height}});
    bench.run(list);
    EXPECT_EQ(bench.readbacks().at(1).values[0], 7112u);  // 7103 + 799 / 256 + 897 / 160
    EXPECT_GT(bench.readbacks().at(1).values[width * 30 + 40], 11000u);
}

/// A sheet whose depths are near those of all others, or a triangle of such a sheet.
Draw any_sheet(conformance::Random& r) {
    const int reach = r.pick({1, 3, 40, 2000});
    MeshData data = mesh_data(Primitive::Triangles, {});
    const double low = 10000 + r.between(-reach, reach), right = 10000 + r.between(-reach, reach);
    add_sheet(data, low, right, r.chance(20) ? low : 10000 + r.between(-reach, reach));
    if (r.chance(40)) {
        data.positions.resize(3);
        for (vec3& p : data.positions)
            p.x += float(r.between(-600, 600)) / 8, p.y += float(r.between(-600, 600)) / 8;
    }
    return {.mesh = make_mesh(std::move(data)), .id_base = r.bits(24)};
}
void change(conformance::Random& r, State& state) {
    state.depth = {true, r.chance(50) ? DepthFunc::Less : r.any(DepthFunc::Always), r.chance(80)};
    state.blend = {r.chance(30), BlendFactor::One, BlendFactor::One};
    const bool color = r.chance(60);
    state.color_mask = {color, color, color, color};
    state.scissor = {r.chance(20), {r.below(60), r.below(40), r.between(1, 90), r.between(1, 60)}};
}

TEST(DepthPlanes, AnySheets) {
    for (std::uint64_t list_number = 0; list_number < 100; ++list_number) {
        SCOPED_TRACE(list_number);
        conformance::Random r(conformance::seed_of("held planes", list_number));
        Profile profile = r.chance(50) ? vgx() : ideal();
        profile.color_bits = profile.lit_bits = 8;  // for packed reads
        Workbench bench(profile, width, height);
        State state = drawn(bench, DepthFunc::Always, true, true);
        CommandList list;
        list.add(SetState{state});
        list.add(Clear{.planes = all_planes, .depth = r.pick({0.0, 0.0006, 1.0})});
        for (int i = 0; i < 12; ++i) {
            change(r, state);
            list.add(SetState{state});
            if (r.chance(10)) list.add(Clear{.planes = all_planes, .depth = 0.0006});
            if (r.chance(90)) list.add(any_sheet(r));
            if (r.chance(10))
                list.add(Read{.key = 1, .plane = Plane::Depth, .rect = {0, 0, width, height}});
            if (r.chance(10)) list.add(Read{.key = 2, .rect = {3, 5, 101, 70}, .packed = true});
        }
        bench.run(list);
    }
}

}  // namespace
}  // namespace gw::test
