#include "gw/fast/plan/kept_textures.h"

#include <algorithm>

namespace gw::fast {

FastTexels& KeptTextures::find_or_make(const TextureRef& texture, const Profile& profile) {
    Kept& kept = all_[texture.get()];
    // Expired: the texture that had this address is gone.
    if (kept.owner.expired()) {
        kept.texels =
            make_fast_texels(make_texels(*texture, profile.color_bits, texel_bits(profile)));
        kept.owner = texture;
        made_ += 1;
    }
    return kept.texels;
}

void KeptTextures::end_segment() {
    const std::size_t count = all_.bucket_count();
    for (std::size_t i = 0; i < std::min(2 * made_ + 4, count); ++i) {
        next_bucket_ = (next_bucket_ + 1) % count;
        for (auto at = all_.begin(next_bucket_); at != all_.end(next_bucket_);) {
            if (!at->second.owner.expired()) {
                ++at;
                continue;
            }
            const Texture* const address = at->first;
            all_.erase(address);
            at = all_.begin(next_bucket_);
        }
    }
    made_ = 0;
}

}  // namespace gw::fast
