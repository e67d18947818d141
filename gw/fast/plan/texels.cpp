#include "gw/fast/plan/texels.h"

#include <algorithm>
#include <utility>

namespace gw::fast {
namespace {

void add_pairs(const TexelLevel& level, const std::uint32_t* packed, Wrap wrap_s, Wrap wrap_t,
               std::vector<TexelPair>& out) {
    for (int j = 0; j < level.height; ++j) {
        const std::uint32_t* row = packed + j * level.width;
        const std::uint32_t* next = packed + wrap_index(wrap_t, j + 1, level.height) * level.width;
        for (int i = 0; i <= level.width; ++i) {
            const int column = wrap_index(wrap_s, i, level.width);
            out.push_back({row[column], next[column]});
        }
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

const TexelPairs* texel_pairs(FastTexels& texels, Wrap wrap_s, Wrap wrap_t) {
    if (texels.packed.empty()) return nullptr;
    TexelPairs& out = texels.pairs[std::size_t(wrap_s) * 2 + std::size_t(wrap_t)];
    if (!out.pairs.empty()) return &out;
    for (std::size_t i = 0; i < texels.texels.levels.size(); ++i) {
        out.first[i] = std::int32_t(out.pairs.size());
        add_pairs(texels.texels.levels[i], texels.packed.data() + texels.first[i], wrap_s, wrap_t,
                  out.pairs);
    }
    return &out;
}

}  // namespace gw::fast
