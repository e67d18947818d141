#include "gw/fast/plan/texels.h"

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

/// Row j and what lies beside it, from the first index on. `texels` are those of the level; `row` is
/// the memory that it uses.
void pack_row(const TexelLevel& level, const std::uint32_t* texels, const Addressing& how, int j,
              std::vector<std::uint32_t>& row) {
    const auto at = [&](int i) { return packed(filter_texel(level, how, i, j)); };
    const int first = first_index(how.wrap_s);
    row.clear();
    if (first < 0) row.push_back(at(first));
    if (const int k = wrapped_row(level, how, j); k >= 0)
        row.insert(row.end(), texels + pixel_index(0, k, level.width),
                   texels + pixel_index(0, k + 1, level.width));
    else
        for (int i = 0; i < level.width; ++i) row.push_back(at(i));
    row.push_back(at(level.width));
}

void add_pairs(const TexelLevel& level, const std::uint32_t* texels, const Addressing& how,
               std::vector<TexelPair>& out) {
    std::vector<std::uint32_t> row, next;
    pack_row(level, texels, how, first_index(how.wrap_t), row);
    for (int j = first_index(how.wrap_t); j < level.height; ++j) {
        pack_row(level, texels, how, j + 1, next);
        const std::size_t from = out.size();
        out.resize(from + row.size());
        for (std::size_t i = 0; i < row.size(); ++i) out[from + i] = {row[i], next[i]};
        std::swap(row, next);
    }
}

}  // namespace

FastTexels make_fast_texels(Texels texels) {
    FastTexels f;
    std::size_t count = 0;
    for (const TexelLevel& level : texels.levels) count += level.texels.size();
    if (texels.bits == 8)
        f.packed.resize(count);
    else
        f.wide.reserve(count);
    std::size_t at = 0;
    for (std::size_t i = 0; i < texels.levels.size(); ++i) {
        const std::vector<Rgba>& level = texels.levels[i].texels;
        f.first[i] = std::int32_t(at);
        if (texels.bits == 8)
            std::transform(level.begin(), level.end(), f.packed.begin() + std::ptrdiff_t(at),
                           packed);
        else
            f.wide.insert(f.wide.end(), level.begin(), level.end());
        at += level.size();
    }
    f.texels = std::move(texels);
    return f;
}

const TexelPairs* texel_pairs(FastTexels& texels, Addressing how) {
    constexpr std::size_t most = 16;
    if (texels.packed.empty()) return nullptr;
    const bool reaches = how.wrap_s == Wrap::BorderClamp || how.wrap_t == Wrap::BorderClamp;
    if (!reaches || !texels.texels.levels[0].bordered.empty()) how.border_color = {};
    for (const TexelPairs& pairs : texels.pairs)
        if (pairs.how == how) return &pairs;
    if (texels.pairs.size() == most) return nullptr;
    TexelPairs& out = texels.pairs.emplace_back();
    out.how = how;
    out.pairs.reserve(texels.packed.size() * 5 / 4);
    for (std::size_t i = 0; i < texels.texels.levels.size(); ++i) {
        out.first[i] = std::int32_t(out.pairs.size());
        add_pairs(texels.texels.levels[i], &texels.packed[std::size_t(texels.first[i])], how,
                  out.pairs);
    }
    return &out;
}

}  // namespace gw::fast
