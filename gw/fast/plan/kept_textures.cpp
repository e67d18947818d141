#include "gw/fast/plan/kept_textures.h"

#include <algorithm>

namespace gw::fast {

FastTexels& KeptTextures::find_or_make(const TextureRef& texture, const Profile& profile) {
    const TextureHistory& history = texture->history;
    Kept& kept = all_[history.address()];
    // Expired: the origin that had this address is gone.
    if (kept.origin.expired()) kept = {history.origin(), {}};
    Version& version = version_of(kept, *texture, profile);
    version.segment = segment_;
    return version.texels;
}

KeptTextures::Version& KeptTextures::version_of(Kept& kept, const Texture& texture,
                                                const Profile& profile) {
    const std::uint64_t number = texture.history.number();
    for (Version& v : kept.versions)
        if (v.number == number) return v;
    Version* const before = version_before(kept, texture.history);
    if (!kept.versions.empty()) crowded_.push_back(texture.history.address());
    if (!before) {
        made_ += 1;
        return kept.versions.emplace_back(
            Version{number, 0, make_fast_texels(make_texels(texture, texel_bits_of(profile)))});
    }
    const auto parts = texture.history.since(before->number);
    Version& out = before->segment == segment_ ? kept.versions.emplace_back(*before) : *before;
    update(out.texels, texture, parts, texel_bits_of(profile));
    out.number = number;
    return out;
}

/// The latest one that the texture follows from; null: none.
KeptTextures::Version* KeptTextures::version_before(Kept& kept, const TextureHistory& history) {
    Version* found = nullptr;
    for (Version& v : kept.versions)
        if (history.knows_since(v.number) && (!found || v.number > found->number)) found = &v;
    return found;
}

void KeptTextures::end_segment() {
    drop_old_versions();
    drop_expired();
    made_ = 0;
    ++segment_;
}

void KeptTextures::drop_old_versions() {
    for (const void* const origin : crowded_) {
        std::list<Version>& versions = all_[origin].versions;
        const auto latest = std::max_element(
            versions.begin(), versions.end(),
            [](const Version& a, const Version& b) { return a.number < b.number; });
        versions.splice(versions.begin(), versions, latest);
        versions.resize(1);
    }
    crowded_.clear();
}

void KeptTextures::drop_expired() {
    const std::size_t count = all_.bucket_count();
    for (std::size_t i = 0; i < std::min(2 * made_ + 4, count); ++i) {
        next_bucket_ = (next_bucket_ + 1) % count;
        for (auto at = all_.begin(next_bucket_); at != all_.end(next_bucket_);) {
            if (!at->second.origin.expired()) {
                ++at;
                continue;
            }
            const void* const address = at->first;
            all_.erase(address);
            at = all_.begin(next_bucket_);
        }
    }
}

}  // namespace gw::fast
