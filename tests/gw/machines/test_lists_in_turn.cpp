// Hundreds of short lists on one pair of machines. Most meshes and textures are deleted after their
// list, so that later ones may have their addresses; the others are used again. Random lists of
// conformance/random are alone on their machines and keep everything.
#include "conformance/generate/draw.h"
#include "conformance/generate/pixels.h"
#include "conformance/generate/script.h"
#include "conformance/generate/state.h"
#include "tests/fuzz/suites.h"
#include "tests/gw/workbench.h"

namespace gw::fuzz {
namespace {

constexpr int width = 70, height = 40;

/// Meshes and textures that outlive their list for a while.
struct Pool {
    std::vector<MeshRef> meshes{4};
    std::vector<TextureRef> textures{4};
    std::vector<std::uint32_t> color_slots, depth_slots;
};

template <class Ref>
Ref old_or_new(Random& r, std::vector<Ref>& pool, const auto& make) {
    Ref& chosen = pool[std::size_t(r.below(int(pool.size())))];
    if (chosen && r.chance(50)) return chosen;
    const Ref made = make();
    if (r.chance(50)) chosen = made;
    return made;
}

void add_draw(Script& s, Pool& pool) {
    Random& r = s.random;
    const MeshWish wish{.normals = true, .texcoords = true, .most = 4};
    Draw d{.mesh = old_or_new(r, pool.meshes, [&] { return any_triangles(r, s.frame, wish); }),
           .eye_from_object = s.frame.eye_from_object};
    if (r.chance(60))
        d.map.texture = old_or_new(r, pool.textures, [&] { return any_texture(r); });
    else if (!s.color_slots.empty())
        d.map.slot = r.pick(s.color_slots);
    if (s.state.color_source == ColorSource::Lighting) {
        d.material = any_material(r);
        d.lights = any_lights(r, s.out.profile.max_lights, eye_depth(s.frame));
    }
    const int repeats = r.pick({1, 1, 2});
    for (int i = 0; i < repeats; ++i) add(s, d);
}

CommandList any_list(Random& r, const Frame& frame, const Profile& profile, Pool& pool) {
    Script s{r, {profile, width, height, {}}, {}, frame, pool.color_slots, pool.depth_slots};
    s.state.projection = frame.projection;
    s.state.depth = any_depth(r);
    s.state.blend = r.chance(50) ? any_blend(r) : BlendState{};
    s.state.color_source = r.any(ColorSource::PolygonId);
    s.state.texture = any_texture_state(r);
    if (r.chance(20)) s.state.jitter = any_jitter(r, profile);
    s.out.list.add(SetState{s.state});
    if (r.chance(40)) add(s, any_clear(r));
    const int draws = r.between(0, 4);
    for (int i = 0; i < draws; ++i) add_draw(s, pool);
    if (r.chance(15)) copy_texture(s, Plane::Color);
    if (r.chance(10)) add(s, any_read(r, s.out));
    between_draws(s);
    pool.color_slots = s.color_slots;
    pool.depth_slots = s.depth_slots;
    return s.out.list;
}

class ListsInTurn : public testing::TestWithParam<Profile> {};

TEST_P(ListsInTurn, MayUseWhatEarlierListsDeletedOrKept) {
    const Profile& profile = GetParam();
    test::Workbench bench(profile, width, height);
    Random r(seed_of("lists in turn", profile.name.size()));
    Frame frame = any_frame(r, width, height, profile.subpixel_bits);
    Pool pool;
    for (int i = 0; i < 400; ++i) {
        SCOPED_TRACE(i);
        if (r.chance(10)) frame = any_frame(r, width, height, profile.subpixel_bits);
        bench.run(any_list(r, frame, profile, pool));
        if (r.chance(50)) bench.compare();
        if (HasFailure()) return;
    }
    EXPECT_GT(bench.take_counters().written, 10000u);
}

INSTANTIATE_TEST_SUITE_P(Profiles, ListsInTurn, testing::ValuesIn(profiles()),
                         [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace gw::fuzz
