// Surfaces, blits between them, their planes as textures, and occlusion counts through Mesa and us.
#include "gw/machine.h"
#include "tests/peer/compare.h"

#include <cmath>

namespace gw {
namespace {

using namespace test;

class Surfaces : public Driver {};
INSTANTIATE_TEST_SUITE_P(AgainstMesa, Surfaces, testing::Values("llvmpipe", "softpipe"),
                         [](const auto& driver) { return std::string(driver.param); });

constexpr gw::Surface small{40, 24, surface_planes, 0, 0};

/// Random values of all pixels of a plane.
WritePixels random_values(Random& random, Plane plane, int width, int height) {
    WritePixels out{.rect = {0, 0, width, height}, .plane = plane};
    for (int i = 0; i < width * height; ++i) {
        const std::uint64_t bits = random.next();
        if (plane == Plane::Color)
            out.colors.push_back({std::uint16_t(bits & 255), std::uint16_t(bits >> 8 & 255),
                                  std::uint16_t(bits >> 16 & 255), 255});
        else
            out.values.push_back(std::uint32_t(bits & (plane == Plane::Depth ? 0xFFFF00 : 255)));
    }
    return out;
}

/// Surface 1 with random values is the one in use.
CommandList random_surface(Random& random) {
    CommandList list;
    list.add(SetState{window_state()});
    list.add(Clear{all_planes, {0.5f, 0.25f, 0, 1}, 0.5, 7});
    list.add(MakeSurface{1, small});
    list.add(UseSurface{1});
    for (const Plane plane : {Plane::Color, Plane::Depth, Plane::Stencil})
        list.add(random_values(random, plane, small.width, small.height));
    return list;
}

struct Blitted {
    CommandList list;
    Blit blit;
};

Blitted blitted(Random& random, bool scaled) {
    Blitted out{random_surface(random), {}};
    const int x = int(random.between(0, 10)), y = int(random.between(0, 10));
    const Rect source{x, y, int(random.between(1, small.width - x)),
                      int(random.between(1, small.height - y))};
    const int across = scaled ? int(random.between(1, 60)) : source.width,
              up = scaled ? int(random.between(1, 60)) : source.height;
    out.blit = {.from_surface = 1,
                .planes = surface_planes,
                .source = source,
                .target = {int(random.between(-9, 9)), int(random.between(-9, 9)), across, up},
                .flip_x = random.one_in(2),
                .flip_y = random.one_in(2)};
    State state = window_state();
    state.scissor = {.test = random.one_in(2), .box = {4, 6, 40, 30}};
    out.list.add(UseSurface{0});
    add(out.list, state, out.blit);
    return out;
}

/// Whether a pixel's place in the source is within 1/64 pixel of a border between two.
bool is_between(int place, int from, int to) {
    const double at = (place + 0.5) * from / to;
    return std::abs(at - std::round(at)) < 1.0 / 64;
}
bool is_undecided(const Blit& b, int x, int y) {
    return is_between(x - b.target.x, b.source.width, b.target.width) ||
           is_between(y - b.target.y, b.source.height, b.target.height);
}

TEST_P(Surfaces, BlitsAgree) {
    Random random(30);
    std::vector<Blitted> all;
    std::vector<CommandList> lists;
    for (int i = 0; i < 80; ++i)
        lists.push_back(all.emplace_back(blitted(random, i % 2 == 0)).list);
    const std::vector<Planes> ours = execute(lists, size, size, opengl()),
                              theirs = play(lists, opengl()).planes;
    Tally color, depth, stencil;
    for (std::size_t i = 0; i < all.size(); ++i)
        for_pixels([&](int x, int y, std::size_t p) {
            if (i % 2 == 0 && is_undecided(all[i].blit, x, y)) return;
            color.add(difference(ours[i].color[p], theirs[i].color[p]));
            depth.add(std::abs(double(ours[i].depth[p]) - double(theirs[i].depth[p])));
            stencil.add(std::abs(ours[i].stencil[p] - theirs[i].stencil[p]));
        });
    report(GetParam(), "blits: colour", color);
    report(GetParam(), "blits: depth", depth);
    report(GetParam(), "blits: stencil", stencil);
    EXPECT_GT(color.compared, 200000);
    EXPECT_EQ(color.different, 0);
    EXPECT_LE(depth.worst, 4);
    EXPECT_EQ(stencil.different, 0);
}

/// A square of the window's size with a plane of surface 1 as its texture.
Draw plane_square(Plane plane, float r) {
    MeshData data{.primitive = Primitive::Quads};
    data.positions = {{0, 0, 0}, {size, 0, 0}, {size, size, 0}, {0, size, 0}};
    data.texcoords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    data.texcoords_rq.assign(4, vec2{r, 1});
    Draw draw{.mesh = make_mesh(std::move(data))};
    draw.map.surface = SurfacePlane{1, plane};
    return draw;
}

/// A triangle drawn to a surface, and its plane of colours or depths drawn to the window.
TEST_P(Surfaces, PlanesAreTextures) {
    Random random(31);
    std::vector<CommandList> lists;
    std::vector<GridTriangle> triangles;
    for (int i = 0; i < 60; ++i) {
        CommandList& list = lists.emplace_back();
        list.add(SetState{window_state()});
        list.add(Clear{all_planes});
        list.add(MakeSurface{1, {size, size, surface_planes, 0, 0}});
        list.add(UseSurface{1});
        list.add(Clear{surface_planes, {0, 0, 0.5f, 1}, 1});
        triangles.push_back(random_triangle(random));
        const std::int64_t z = random.between(0, 200) << 16;
        const vec4 color = random_color(random);
        State state = window_state();
        state.depth = {.test = true, .func = DepthFunc::Less};
        add(list, state,
            Draw{.mesh = make_mesh(mesh_of(triangles.back(), {z, z, z}, {color, color, color}))});
        list.add(UseSurface{0});
        state = window_state();
        state.texture = {.min_filter = MinFilter::Nearest,
                         .mag_filter = MagFilter::Nearest,
                         .env = TexEnv::Replace,
                         .shadow_compare = i % 2 == 0,
                         .compare_func = CompareFunc(random.between(0, 7))};
        const float r = (float(random.between(0, 255)) + 0.5f) / 256;
        add(list, state, plane_square(i % 2 == 0 ? Plane::Depth : Plane::Color, r));
    }
    const std::vector<Planes> ours = execute(lists, size, size, opengl()),
                              theirs = play(lists, opengl()).planes;
    Tally tally;
    for (std::size_t i = 0; i < lists.size(); ++i)
        for_pixels([&](int x, int y, std::size_t p) {
            if (!near_side(triangles[i], x, y))
                tally.add(difference(ours[i].color[p], theirs[i].color[p]));
        });
    report(GetParam(), "planes of surfaces as textures, compared", tally);
    EXPECT_EQ(tally.different, 0);
}

/// Rectangles at whole pixels under tests, each counted. Their depths differ, so that no rounding decides.
CommandList counted(Random& random) {
    CommandList list;
    list.add(Clear{all_planes, {}, 0.5, 3});
    for (std::uint32_t key = 0; key < 10; ++key) {
        State state = window_state();
        state.depth = {.test = !random.one_in(3),
                       .func = DepthFunc(random.between(0, 7)),
                       .mask = random.one_in(2)};
        state.stencil = {.test = random.one_in(2),
                         .func = StencilFunc(random.between(0, 7)),
                         .ref = int(random.between(0, 6)),
                         .zpass = StencilOp::Incr};
        state.alpha = {.test = random.one_in(3), .func = AlphaFunc::Greater, .ref = 0.5f};
        state.color_mask.r = random.one_in(2);
        const auto x = float(random.between(-9, 50)), y = float(random.between(-9, 50)),
                   z = float((random.between(0, 255) << 16) + (key << 12) + 2048);
        const auto right = x + float(random.between(1, 40)), top = y + float(random.between(1, 40));
        MeshData data{.primitive = Primitive::Quads};
        data.positions = {{x, y, z}, {right, y, z}, {right, top, z}, {x, top, z}};
        data.colors.assign(4, random_color(random));
        list.add(SetState{state});
        list.add(Query{key, true});
        list.add(Draw{.mesh = make_mesh(std::move(data))});
        list.add(Query{key, false});
    }
    return list;
}

TEST_P(Surfaces, OcclusionCountsAgree) {
    Random random(32);
    std::vector<CommandList> lists;
    for (int i = 0; i < 40; ++i) lists.push_back(counted(random));
    const Answers theirs = play(lists, opengl());
    std::uint64_t samples = 0;
    Tally counts;
    for (std::size_t i = 0; i < lists.size(); ++i) {
        const std::unique_ptr<Machine> machine = make_reference(opengl(), size, size);
        machine->execute(lists[i]);
        std::vector<QueryResult> ours;
        for (const PassReport& pass : machine->passes())
            ours.insert(ours.end(), pass.queries.begin(), pass.queries.end());
        ASSERT_EQ(ours.size(), theirs.queries[i].size());
        for (std::size_t k = 0; k < ours.size(); ++k) {
            EXPECT_EQ(ours[k].key, theirs.queries[i][k].key);
            counts.add(double(ours[k].samples) - double(theirs.queries[i][k].samples));
            samples += ours[k].samples;
        }
    }
    report(GetParam(), "occlusion counts", counts);
    // softpipe counts some pixels on the diagonal of a quad in both triangles, or in none.
    EXPECT_LE(counts.different, std::string(GetParam()) == "llvmpipe" ? 0 : 4);
    EXPECT_GT(samples, 20000u);
}

}  // namespace
}  // namespace gw
