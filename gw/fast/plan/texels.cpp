#include "gw/fast/plan/texels.h"

#include <algorithm>
#include <utility>

namespace gw::fast {
namespace {

int first_index(Wrap wrap) { return wrap == Wrap::BorderClamp ? -1 : 0; }

std::vector<std::uint32_t> packed_row(const TexelLevel& level, const Addressing& how, int j) {
    std::vector<std::uint32_t> row;
    for (int i = first_index(how.wrap_s); i <= level.width; ++i)
        row.push_back(packed(filter_texel(level, how, i, j)));
    return row;
}

void add_pairs(const TexelLevel& level, const Addressing& how, std::vector<TexelPair>& out) {
    std::vector<std::uint32_t> row = packed_row(level, how, first_index(how.wrap_t));
    for (int j = first_index(how.wrap_t); j < level.height; ++j) {
        std::vector<std::uint32_t> next = packed_row(level, how, j + 1);
        for (std::size_t i = 0; i < row.size(); ++i) out.push_back({row[i], next[i]});
        row = std::move(next);
    }
}

}  // namespace

FastTexels make_fast_texels(Texels texels) {
    FastTexels f;
    for (std::size_t i = 0; i < texels.levels.size(); ++i) {
        f.first[i] = std::int32_t(std::max(f.packed.size(), f.wide.size()));
        for (const Rgba& t : texels.levels[i].texels) {
            if (texels.bits == 8)
                f.packed.push_back(packed(t));
            else
                f.wide.push_back(t);
        }
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
    for (std::size_t i = 0; i < texels.texels.levels.size(); ++i) {
        out.first[i] = std::int32_t(out.pairs.size());
        add_pairs(texels.texels.levels[i], how, out.pairs);
    }
    return &out;
}

}  // namespace gw::fast
