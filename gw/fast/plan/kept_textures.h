// Textures packed for the kernels, kept from list to list. Does not keep the textures alive.
#pragma once

#include "gw/fast/plan/texels.h"
#include "gw/profile.h"
#include "gw/texture.h"

#include <memory>
#include <unordered_map>

namespace gw::fast {

/// Packed texels are dropped soon after the last reference to their texture.
class KeptTextures {
public:
    FastTexels& find_or_make(const TextureRef& texture, const Profile& profile);
    /// Checks a few of the kept textures.
    void end_segment();

    std::size_t size() const { return all_.size(); }

private:
    struct Kept {
        std::weak_ptr<const Texture> owner;
        FastTexels texels;
    };
    std::unordered_map<const Texture*, Kept> all_;
    std::size_t made_ = 0;  ///< in this segment
    std::size_t next_bucket_ = 0;
};

}  // namespace gw::fast
