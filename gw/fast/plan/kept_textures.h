// Textures packed for the kernels, kept from list to list. Does not keep the textures alive.
#pragma once

#include "gw/fast/plan/texels.h"
#include "gw/profile.h"
#include "gw/texture.h"

#include <list>
#include <memory>
#include <unordered_map>
#include <vector>

namespace gw::fast {

/// Packed texels are dropped soon after the last reference to a texture of their origin.
class KeptTextures {
public:
    /// The texels are at their place until the segment ends.
    FastTexels& find_or_make(const TextureRef& texture, const Profile& profile);
    /// Checks a few of the kept textures.
    void end_segment();

    /// How many are kept.
    std::size_t size() const { return all_.size(); }

private:
    /// The texels of one texture of an origin.
    struct Version {
        std::uint64_t number = 0;
        std::uint64_t segment = 0;  ///< that used it last
        FastTexels texels;
    };
    struct Kept {
        std::weak_ptr<const void> origin;
        std::list<Version> versions;
    };
    Version& version_of(Kept& kept, const Texture& texture, const Profile& profile);
    Version* version_before(Kept& kept, const TextureHistory& history);
    void drop_old_versions();
    void drop_expired();

    std::unordered_map<const void*, Kept> all_;  ///< by the address of the origin
    std::vector<const void*> crowded_;           ///< those that got a further version
    std::uint64_t segment_ = 1;
    std::size_t made_ = 0;  ///< in this segment
    std::size_t next_bucket_ = 0;
};

}  // namespace gw::fast
