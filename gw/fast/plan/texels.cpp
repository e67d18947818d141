#include "gw/fast/plan/texels.h"

#include "gw/fast/frame/frame.h"

#include <algorithm>
#include <utility>

namespace gw::fast {
namespace {

int first_index(Wrap wrap) { return wrap == Wrap::BorderClamp ? -1 : 0; }

/// The level's row that row j of a filter is; -1: a border.
int wrapped_row(const TexelLevel& level, const Addressing& how, int j) {
    if (how.wrap_t != Wrap::BorderClamp) return wrap_index(how.wrap_t, j, level.height);
    return j < level.height ? j : -1;
}

/// From the first index to before the last.
struct IndexRange {
    int first, end;
};

IndexRange clipped(IndexRange a, IndexRange to) {
    return {std::max(a.first, to.first), std::min(a.end, to.end)};
}

/// A level's pairs.
class LevelPairs {
public:
    LevelPairs(const Texels& texels, const TexelLevel& level, const Addressing& how)
        : texels_(texels),
          level_(level),
          how_(how),
          all_rows_{first_index(how.wrap_t), level.height},
          all_columns_{first_index(how.wrap_s), level.width + 1} {}

    std::size_t count() const {
        return std::size_t(all_rows_.end - all_rows_.first) * std::size_t(row_length());
    }
    /// Makes all of them, from `out` on.
    void make(TexelPair* out) const { make(out, all_rows_, all_columns_); }
    /// Makes those that have texels of a rectangle, which may reach into the border. What lies beside
    /// a side may repeat texels of any side.
    void make_around(TexelPair* out, const Rect& rect) const {
        const bool at_side = rect.x <= 0 || rect.x + rect.width >= level_.width || rect.y <= 0 ||
                             rect.y + rect.height >= level_.height;
        const IndexRange rows = clipped({rect.y - 1, rect.y + rect.height}, all_rows_),
                         columns = clipped({rect.x, rect.x + rect.width}, all_columns_);
        make(out, rows, columns);
        if (!at_side) return;
        const IndexRange below{all_rows_.first, std::min(all_rows_.first + 1, rows.first)},
            above{std::max(all_rows_.end - 1, rows.end), all_rows_.end};
        for (const IndexRange& r : {below, above}) make(out, r, all_columns_);
        const IndexRange left{all_columns_.first, std::min(all_columns_.first + 1, columns.first)},
            right{std::max(all_columns_.end - 1, columns.end), all_columns_.end};
        for (const IndexRange& c : {left, right}) make(out, rows, c);
    }

private:
    int row_length() const { return all_columns_.end - all_columns_.first; }
    std::uint32_t at(int i, int j) const {
        return packed(filter_texel(texels_, level_, how_, i, j));
    }
    /// The texels of row j; null: a border.
    const std::uint32_t* row(int j) const {
        const int k = wrapped_row(level_, how_, j);
        return k < 0 ? nullptr : &texels_.packed[level_.index(0, k)];
    }
    void make(TexelPair* out, IndexRange rows, IndexRange columns) const {
        const IndexRange inner{std::max(columns.first, 0), std::min(columns.end, level_.width)};
        for (int j = rows.first; j < rows.end; ++j) {
            TexelPair* const to =
                out + std::ptrdiff_t(j - all_rows_.first) * row_length() - all_columns_.first;
            const std::uint32_t *const lower = row(j), *const upper = row(j + 1);
            const IndexRange copied =
                lower && upper ? inner : IndexRange{columns.first, columns.first};
            for (int i = copied.first; i < copied.end; ++i) to[i] = {lower[i], upper[i]};
            for (int i = columns.first; i < copied.first; ++i) to[i] = {at(i, j), at(i, j + 1)};
            for (int i = copied.end; i < columns.end; ++i) to[i] = {at(i, j), at(i, j + 1)};
        }
    }

    const Texels& texels_;
    const TexelLevel& level_;
    const Addressing& how_;
    IndexRange all_rows_, all_columns_;
};

}  // namespace

FastTexels make_fast_texels(Texels texels) {
    FastTexels f;
    for (std::size_t i = 0; i < texels.levels.size(); ++i)
        f.first[i] = std::int32_t(texels.levels[i].first);
    f.texels = std::move(texels);
    return f;
}

FastTexels depths_in_place(const Frame& frame, const Profile& profile) {
    FastTexels f;
    f.frame = &frame;
    f.texels.bits = profile.color_bits;
    f.texels.depth_bits = profile.depth_bits;
    f.texels.add_empty_level(frame.grid().width, frame.grid().height);
    return f;
}

void update(FastTexels& fast, const Texture& texture, std::span<const TexturePart> parts,
            const TexelBits& bits) {
    const int border = texture.border ? 1 : 0, border_t = texture.dimensions == 2 ? border : 0;
    for (const TexturePart& part : parts) {
        const auto i = std::size_t(part.level);
        if (i >= texture.levels.size() || part.rect.area() == 0) continue;
        update_texels(fast.texels, texture, part, bits);
        const Rect inner{part.rect.x - border, part.rect.y - border_t, part.rect.width,
                         part.rect.height};
        for (TexelPairs& p : fast.pairs)
            LevelPairs(fast.texels, fast.texels.levels[i], p.how)
                .make_around(&p.pairs[std::size_t(p.first[i])], inner);
    }
}

const TexelPairs* texel_pairs(FastTexels& fast, Addressing how) {
    constexpr std::size_t most = 16;
    const Texels& texels = fast.texels;
    if (texels.packed.empty()) return nullptr;
    const bool reaches = how.wrap_s == Wrap::BorderClamp || how.wrap_t == Wrap::BorderClamp;
    if (!reaches || !texels.levels[0].bordered.empty()) how.border_color = {};
    for (const TexelPairs& pairs : fast.pairs)
        if (pairs.how == how) return &pairs;
    if (fast.pairs.size() == most) return nullptr;
    TexelPairs& out = fast.pairs.emplace_back();
    out.how = how;
    std::size_t count = 0;
    for (std::size_t i = 0; i < texels.levels.size(); ++i) {
        out.first[i] = std::int32_t(count);
        count += LevelPairs(texels, texels.levels[i], out.how).count();
    }
    out.pairs.resize(count);
    for (std::size_t i = 0; i < texels.levels.size(); ++i)
        LevelPairs(texels, texels.levels[i], out.how).make(&out.pairs[std::size_t(out.first[i])]);
    return &out;
}

}  // namespace gw::fast
