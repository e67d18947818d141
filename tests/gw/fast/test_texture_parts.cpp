// Textures that follow from each other by parts. The fast machine brings what it keeps of an earlier
// one up to date; the reference machine makes each anew.
#include "tests/gw/random.h"
#include "tests/gw/workbench.h"

#include <algorithm>

namespace gw::test {
namespace {

constexpr int side = 64;

std::uint16_t any_value(Random& random) { return std::uint16_t(random.next()); }

Texture any_texture(Random& random) {
    Texture t{.format = TextureFormat(random.between(0, 5)),
              .dimensions = random.one_in(4) ? 1 : 2,
              .border = random.one_in(2),
              .history = TextureHistory::begin()};
    int width = 1 << random.between(0, 5),
        height = t.dimensions == 1 ? 1 : 1 << random.between(0, 5);
    do {
        TextureLevel level{width, height, {}};
        std::vector<std::uint16_t> rgba(4 * stored_rect(t, level).area());
        for (std::uint16_t& v : rgba) v = any_value(random);
        complete(t.format, rgba);
        level.rgba = std::move(rgba);
        t.levels.push_back(std::move(level));
        if (width == 1 && height == 1) break;
        width = std::max(1, width / 2);
        height = std::max(1, height / 2);
    } while (!random.one_in(6));
    return t;
}

/// A range of 0 .. size - 1, which often ends at a side.
std::pair<int, int> any_range(Random& random, int size) {
    int first = int(random.between(0, size - 1)), last = int(random.between(first, size - 1));
    if (random.one_in(4)) first = 0;
    if (random.one_in(4)) last = size - 1;
    return {first, last - first + 1};
}

void replace_part(Texture& t, Random& random) {
    const int number = int(random.between(0, int(t.levels.size()) - 1));
    TextureLevel& level = t.levels[std::size_t(number)];
    const Rect all = stored_rect(t, level);
    const auto [x, width] = any_range(random, all.width);
    const auto [y, height] = any_range(random, all.height);
    std::vector<std::uint16_t>& rgba = level.rgba.edit();
    for (int row = y; row < y + height; ++row) {
        const std::span part(&rgba[4 * pixel_index(x, row, all.width)], 4 * std::size_t(width));
        for (std::uint16_t& v : part) v = any_value(random);
        complete(t.format, part);
    }
    t.history.replace({number, {x, y, width, height}});
}

TextureState any_state(Random& random) {
    TextureState s{.min_filter = MinFilter(random.between(0, 5)),
                   .mag_filter = MagFilter(random.between(0, 1)),
                   .wrap_s = Wrap(random.between(0, 2)),
                   .wrap_t = Wrap(random.between(0, 2)),
                   .env = TexEnv::Replace};
    s.border_color = {random.fraction(), random.fraction(), random.fraction(), 1};
    return s;
}

/// A square of the window with more than the whole texture.
Draw square(TextureRef texture, Random& random) {
    const auto x = float(random.between(0, 32)), y = float(random.between(0, 32));
    const float size = random.one_in(3) ? 5 : 32;
    MeshData data = mesh_data(
        Primitive::Quads, {{x, y, 0}, {x + size, y, 0}, {x + size, y + size, 0}, {x, y + size, 0}});
    data.texcoords = {{-0.3f, -0.4f}, {1.4f, -0.4f}, {1.4f, 1.3f}, {-0.3f, 1.3f}};
    Draw draw{.mesh = make_mesh(std::move(data))};
    draw.map.texture = std::move(texture);
    return draw;
}

void draw_parts(const Profile& profile, std::uint64_t seed) {
    Random random(seed);
    Workbench bench(profile, side, side);
    Texture next = any_texture(random);
    std::vector<TextureRef> versions{share_texture(next)};
    for (int list_number = 0; list_number < 12; ++list_number) {
        CommandList list;
        for (int i = int(random.between(1, 3)); i > 0; --i) {
            for (auto parts = random.between(0, 3); parts > 0; --parts) {
                replace_part(next, random);
                versions.push_back(share_texture(next));
            }
            State state = bench.state;
            state.texture = any_state(random);
            list.add(SetState{state});
            const bool earlier = random.one_in(5);
            list.add(square(
                earlier
                    ? versions[std::size_t(random.between(0, std::int64_t(versions.size()) - 1))]
                    : versions.back(),
                random));
        }
        bench.run(list);
        bench.compare();
    }
}

TEST(TextureParts, DrawAsWholeTextures) {
    Profile wide = opengl();
    wide.color_bits = wide.lit_bits = 12;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        draw_parts(seed % 4 == 0 ? wide : opengl(), seed);
        if (::testing::Test::HasFailure()) return;
    }
}

/// More parts between two draws than a history remembers.
TEST(TextureParts, AreForgottenWhenThereAreMany) {
    Random random(1);
    Workbench bench(opengl(), side, side);
    Texture texture = any_texture(random);
    for (const int parts : {1, 32, 65, 200}) {
        const std::uint64_t before = texture.history.number();
        for (int i = 0; i < parts; ++i) replace_part(texture, random);
        EXPECT_EQ(texture.history.number(), before + std::uint64_t(parts));
        EXPECT_EQ(texture.history.knows_since(before), parts <= 32) << parts;
        bench.state.texture = any_state(random);
        bench.draw(square(share_texture(texture), random));
        bench.compare();
    }
}

TEST(TextureParts, DoNotChangeTheTextureBefore) {
    Random random(2);
    Texture texture = any_texture(random);
    const TextureRef first = share_texture(texture);
    const std::vector<TextureLevel> levels = first->levels;
    std::vector<std::vector<std::uint16_t>> values;
    for (const TextureLevel& level : levels) values.push_back(*level.rgba);
    for (int i = 0; i < 20; ++i) replace_part(texture, random);
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_EQ(first->levels[i].rgba, values[i]);
}

}  // namespace
}  // namespace gw::test
