#include "gw/texture.h"

#include "gw/error.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace gw {
namespace {

void check(const std::string& name, int width, int height, std::size_t values, int most) {
    const std::string size = std::to_string(width) + "x" + std::to_string(height);
    if (width < 1 || height < 1 || width > most || height > most)
        throw Error("texture " + name + ": " + size + " texels; expected sides of 1 to " +
                    std::to_string(most));
    if (values != std::size_t{4} * std::size_t(width) * std::size_t(height))
        throw Error("texture " + name + ": " + std::to_string(values) + " values for " + size +
                    " texels of 4");
}

int next_power_of_two(int side) {
    return static_cast<int>(std::bit_ceil(static_cast<unsigned>(side)));
}

// The position of texel centre i of `to` texels among `from` texels. It is between `low` and
// `high`, at `weight` / (2 `to`) of the distance from low to high. Clamped at the ends, so that
// opposite sides never mix.
struct Position {
    int low, high;
    std::uint64_t weight;
};

Position position_of(int i, int from, int to) {
    const int twice = 2 * to;
    const int position = std::clamp((2 * i + 1) * from - to, 0, (from - 1) * twice);
    const int low = position / twice;
    return {low, std::min(low + 1, from - 1), static_cast<std::uint64_t>(position % twice)};
}

// Bilinear, rounded once to nearest, ties up. The four weights add up to 4 * width * height of the
// result.
TextureLevel resample(int width, int height, std::span<const std::uint16_t> rgba) {
    TextureLevel level{next_power_of_two(width), next_power_of_two(height), {}};
    if (level.width == width && level.height == height) {
        level.rgba = std::vector(rgba.begin(), rgba.end());
        return level;
    }
    std::vector<std::uint16_t>& out = level.rgba.edit();
    out.reserve(std::size_t{4} * std::size_t(level.width) * std::size_t(level.height));
    const std::uint64_t parts_x = 2 * static_cast<std::uint64_t>(level.width);
    const std::uint64_t parts_y = 2 * static_cast<std::uint64_t>(level.height);
    for (int y = 0; y < level.height; ++y)
        for (int x = 0; x < level.width; ++x) {
            const Position px = position_of(x, width, level.width),
                           py = position_of(y, height, level.height);
            const auto texel = [&](int column, int row, int channel) {
                return std::uint64_t{rgba[std::size_t(4 * (row * width + column) + channel)]};
            };
            for (int c = 0; c < 4; ++c) {
                const auto along = [&](int row) {
                    return texel(px.low, row, c) * (parts_x - px.weight) +
                           texel(px.high, row, c) * px.weight;
                };
                const std::uint64_t sum =
                    along(py.low) * (parts_y - py.weight) + along(py.high) * py.weight;
                out.push_back(static_cast<std::uint16_t>((sum + parts_x * parts_y / 2) /
                                                         (parts_x * parts_y)));
            }
        }
    return level;
}

// Means of 2x2 texels, (a + b + c + d + 2) / 4. A single row or column gives means of 2 texels by
// the same formula.
TextureLevel half(const TextureLevel& level) {
    TextureLevel result{std::max(1, level.width / 2), std::max(1, level.height / 2), {}};
    std::vector<std::uint16_t>& out = result.rgba.edit();
    const int dx = level.width > 1, dy = level.height > 1;
    for (int y = 0; y < result.height; ++y)
        for (int x = 0; x < result.width; ++x)
            for (int c = 0; c < 4; ++c) {
                const auto texel = [&](int column, int row) {
                    return unsigned{level.rgba[std::size_t(4 * (row * level.width + column) + c)]};
                };
                const int column = x << dx, row = y << dy;
                const unsigned sum = texel(column, row) + texel(column + dx, row) +
                                     texel(column, row + dy) + texel(column + dx, row + dy);
                out.push_back(static_cast<std::uint16_t>((sum + 2) / 4));
            }
    return result;
}

/// The texels of a side that texel i of its half covers, and their weights.
struct CoveredTexels {
    int first, count;
    std::array<int, 3> weight;
    int total() const { return weight[0] + weight[1] + weight[2]; }
};
CoveredTexels covered(int side, int i) {
    const int n = side / 2;
    if (side == 1) return {0, 1, {1}};
    if (side % 2 == 0) return {2 * i, 2, {1, 1}};
    return {2 * i, 3, {n - i, n, i + 1}};
}

/// Means over the area that each texel covers, to nearest, ties up.
TextureLevel half_of_any_size(const TextureLevel& level) {
    TextureLevel result{std::max(1, level.width / 2), std::max(1, level.height / 2), {}};
    std::vector<std::uint16_t>& out = result.rgba.edit();
    for (int y = 0; y < result.height; ++y)
        for (int x = 0; x < result.width; ++x) {
            const CoveredTexels columns = covered(level.width, x), rows = covered(level.height, y);
            const std::uint64_t total =
                std::uint64_t(columns.total()) * std::uint64_t(rows.total());
            for (int c = 0; c < 4; ++c) {
                std::uint64_t sum = 0;
                for (int j = 0; j < rows.count; ++j)
                    for (int i = 0; i < columns.count; ++i)
                        sum += std::uint64_t(rows.weight[std::size_t(j)]) *
                               std::uint64_t(columns.weight[std::size_t(i)]) *
                               level.rgba[4 * pixel_index(columns.first + i, rows.first + j,
                                                          level.width) +
                                          std::size_t(c)];
                out.push_back(static_cast<std::uint16_t>((2 * sum + total) / (2 * total)));
            }
        }
    return result;
}

/// Weighted means of slices, two or three of the level before.
TextureLevel half_of_slices(const TextureLevel& level, const std::vector<TextureLevel>& halves) {
    TextureLevel result{halves[0].width, halves[0].height, {}, std::max(1, level.layers / 2)};
    std::vector<std::uint16_t>& out = result.rgba.edit();
    for (int k = 0; k < result.layers; ++k) {
        const CoveredTexels slices = covered(level.layers, k);
        const auto total = std::uint64_t(slices.total());
        for (std::size_t i = 0; i < halves[0].rgba.size(); ++i) {
            std::uint64_t sum = 0;
            for (int j = 0; j < slices.count; ++j)
                sum += std::uint64_t(slices.weight[std::size_t(j)]) *
                       halves[std::size_t(slices.first + j)].rgba[i];
            out.push_back(static_cast<std::uint16_t>((2 * sum + total) / (2 * total)));
        }
    }
    return result;
}

void add_levels(Texture& texture) {
    while (texture.levels.back().width > 1 || texture.levels.back().height > 1) {
        const TextureLevel& last = texture.levels.back();
        const bool is_plain = !is_any_size(last.width, last.height);
        texture.levels.push_back(is_plain ? half(last) : half_of_any_size(last));
    }
}

std::shared_ptr<Texture> texture_named(std::string name) {
    auto texture = std::make_shared<Texture>();
    texture->name = std::move(name);
    texture->history = TextureHistory::begin();
    return texture;
}

/// The rules of cubes, of three dimensions and of depths.
void check_kind(const Texture& t, const auto& fail) {
    const int layers = t.levels.front().layers;
    const int most = t.dimensions == 3 ? max_volume_side : t.cube ? 6 : 1, least = t.cube ? 6 : 1;
    if (t.cube && t.dimensions != 2) fail("a cube without two dimensions; expected 2");
    if (t.cube && t.width() != t.height()) fail("faces that are no squares; expected equal sides");
    if (layers < least || layers > most)
        fail(std::to_string(layers) + " layers; expected " + std::to_string(least) + " to " +
             std::to_string(most));
    if (t.dimensions == 3 && (t.width() > max_volume_side || t.height() > max_volume_side))
        fail("sides in three dimensions of more than " + std::to_string(max_volume_side));
    if (t.border && needs_r(t)) fail("a border with r; expected none");
    const bool is_grey = t.format == TextureFormat::Luminance ||
                         t.format == TextureFormat::Intensity || t.format == TextureFormat::Alpha;
    if (t.depths && (!is_grey || t.dimensions == 3 || t.cube || t.srgb))
        fail("depths of another kind; expected Luminance, Intensity or Alpha in two dimensions");
}

void check_levels(const Texture& t) {
    const auto fail = [&](const std::string& what) {
        throw Error("texture " + t.name + ": " + what);
    };
    if (t.levels.empty()) fail("no level; expected 1 or more");
    if (t.dimensions < 1 || t.dimensions > 3)
        fail(std::to_string(t.dimensions) + " dimensions; expected 1 to 3");
    check_kind(t, fail);
    if (t.dimensions == 1 && t.height() != 1) fail("a height in one dimension; expected 1");
    if (t.format > TextureFormat::Intensity)
        fail("format " + std::to_string(int(t.format)) + "; expected 0 to 5");
    int width = t.width(), height = t.height(), layers = t.levels.front().layers;
    for (std::size_t i = 0; i < t.levels.size(); ++i) {
        const TextureLevel& level = t.levels[i];
        check(t.name, width, height, std::size_t{4} * std::size_t(width) * std::size_t(height),
              max_texture_side);
        if (level.width != width || level.height != height)
            fail("level " + std::to_string(i) + " of " + std::to_string(level.width) + "x" +
                 std::to_string(level.height) + " texels; expected " + std::to_string(width) + "x" +
                 std::to_string(height));
        if (level.layers != layers)
            fail("level " + std::to_string(i) + " of " + std::to_string(level.layers) +
                 " layers; expected " + std::to_string(layers));
        const std::size_t values = 4 * stored_rect(t, level).area() * std::size_t(layers);
        if (level.rgba.size() != values)
            fail("level " + std::to_string(i) + " has " + std::to_string(level.rgba.size()) +
                 " values; expected " + std::to_string(values));
        if (t.dimensions == 3) layers = std::max(1, layers / 2);
        width = std::max(1, width / 2);
        height = std::max(1, height / 2);
    }
}

template <TextureFormat format>
void complete(std::span<std::uint16_t> rgba) {
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
        std::uint16_t* const t = &rgba[i];
        const Rgba texel = completed(format, {t[0], t[1], t[2], t[3]}, 65535);
        for (std::size_t c = 0; c < 4; ++c) t[c] = texel[c];
    }
}

/// The same, a texel at once.
template <>
void complete<TextureFormat::RGB>(std::span<std::uint16_t> rgba) {
    constexpr auto alpha = std::bit_cast<std::uint64_t>(Rgba{0, 0, 0, 65535});
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
        std::uint64_t texel;
        std::memcpy(&texel, &rgba[i], sizeof texel);
        texel |= alpha;
        std::memcpy(&rgba[i], &texel, sizeof texel);
    }
}

}  // namespace

void complete(TextureFormat format, std::span<std::uint16_t> rgba) {
    switch (format) {
        case TextureFormat::RGBA: return;
        case TextureFormat::RGB: return complete<TextureFormat::RGB>(rgba);
        case TextureFormat::LuminanceAlpha: return complete<TextureFormat::LuminanceAlpha>(rgba);
        case TextureFormat::Luminance: return complete<TextureFormat::Luminance>(rgba);
        case TextureFormat::Alpha: return complete<TextureFormat::Alpha>(rgba);
        case TextureFormat::Intensity: return complete<TextureFormat::Intensity>(rgba);
    }
}

TextureHistory TextureHistory::begin() {
    TextureHistory history;
    history.origin_ = std::make_shared<const char>();
    return history;
}

void TextureHistory::replace(const TexturePart& part) {
    constexpr std::size_t most = 64;
    if (parts_.size() == most) parts_.erase(parts_.begin(), parts_.begin() + most / 2);
    parts_.push_back(part);
    ++number_;
}

TextureLevel next_level(const TextureLevel& level, int dimensions) {
    const std::size_t size = 4 * std::size_t(level.width) * std::size_t(level.height);
    std::vector<TextureLevel> halves;
    for (std::size_t k = 0; k < std::size_t(level.layers); ++k)
        halves.push_back(
            half_of_any_size({level.width, level.height,
                              std::vector(level.rgba.begin() + std::ptrdiff_t(k * size),
                                          level.rgba.begin() + std::ptrdiff_t((k + 1) * size))}));
    if (dimensions == 3) return half_of_slices(level, halves);
    TextureLevel result{halves[0].width, halves[0].height, {}, level.layers};
    std::vector<std::uint16_t>& out = result.rgba.edit();
    for (const TextureLevel& half : halves)
        out.insert(out.end(), half.rgba.begin(), half.rgba.end());
    return result;
}

TextureRef share_texture(Texture given) {
    given.given_levels = true;
    check_levels(given);
    if (given.history.is_empty()) given.history = TextureHistory::begin();
    return std::make_shared<const Texture>(std::move(given));
}

TextureRef make_texture(Texture given) {
    check_levels(given);
    for (TextureLevel& level : given.levels)
        if (given.format != TextureFormat::RGBA && !given.depths)
            complete(given.format, level.rgba.edit());
    given.history = {};
    return share_texture(std::move(given));
}

TextureRef make_texture(std::string name, int width, int height,
                        std::span<const std::uint16_t> rgba) {
    check(name, width, height, rgba.size(), max_texture_size);
    auto texture = texture_named(std::move(name));
    texture->levels.push_back(resample(width, height, rgba));
    add_levels(*texture);
    return texture;
}

TextureRef make_whole_texture(std::string name, int width, int height,
                              std::span<const std::uint16_t> rgba, bool srgb) {
    check(name, width, height, rgba.size(), max_texture_side);
    auto texture = texture_named(std::move(name));
    texture->srgb = srgb;
    texture->levels.push_back({width, height, std::vector(rgba.begin(), rgba.end())});
    add_levels(*texture);
    return texture;
}

TextureRef make_texture8(std::string name, int width, int height,
                         std::span<const std::uint8_t> rgba) {
    std::vector<std::uint16_t> wide(rgba.size());
    std::transform(rgba.begin(), rgba.end(), wide.begin(),
                   [](std::uint8_t v) { return static_cast<std::uint16_t>(257 * v); });
    return make_texture(std::move(name), width, height, wide);
}

}  // namespace gw
