// A part of a stream: what happened to one window, in the bytes of a recording whose meshes and
// maps may be those of earlier parts. Does not order parts: stream.h does.
#pragma once

#include "gw/planes.h"
#include "inspect/recording/recording.h"

#include <map>
#include <utility>

namespace gw::inspect {

/// Places of values that were stored: by address, then by content.
template <typename Ref>
class Places {
public:
    /// The place of `ref`, and whether it is a new one.
    std::pair<std::uint32_t, bool> place(const Ref& ref, const auto& digest_of) {
        const auto known = by_address_.find(ref.get());
        if (known != by_address_.end()) return {known->second, false};
        const auto [found, is_new] = by_content_.try_emplace(digest_of(*ref), next_);
        next_ += is_new;
        by_address_[ref.get()] = found->second;
        return {found->second, is_new};
    }
    /// Between two parts values may die, and others get their addresses. Contents beyond `most` are
    /// forgotten, so that memory has a bound: they are stored again if they return.
    void begin_part(std::size_t most) {
        by_address_.clear();
        if (by_content_.size() > most) by_content_.clear();
    }
    std::size_t remembered() const { return by_address_.size() + by_content_.size(); }

private:
    std::map<const void*, std::uint32_t> by_address_;
    std::map<Digest, std::uint32_t> by_content_;
    std::uint32_t next_ = 0;
};

/// What the parts so far have stored.
struct StoredValues {
    static constexpr std::size_t most = 1 << 14;
    Places<MeshRef> meshes;
    Places<TextureRef> textures;
    void begin_part() {
        meshes.begin_part(most);
        textures.begin_part(most);
    }
    std::size_t remembered() const { return meshes.remembered() + textures.remembered(); }
};

/// What the parts so far have brought, by their places.
struct DecodedValues {
    std::vector<MeshRef> meshes;
    std::vector<TextureRef> textures;
    std::uint64_t charged = 0;  ///< bytes, of Limits::decoded_bytes
};

enum class WindowEvent : std::uint8_t { Continue, Open, Close };

/// Recording: of Open, the window's profile, size and heading; else only lists.
struct Part {
    std::string window;
    WindowEvent event = WindowEvent::Continue;
    Recording recording;
};

/// Throws Error as `encode` does.
std::vector<std::uint8_t> encode_part(const Part& part, StoredValues& stored);
/// From untrusted bytes. The lists are not validated: they may need those of earlier parts.
Part decode_part(std::span<const std::uint8_t> bytes, DecodedValues& values, const Limits& limits);

}  // namespace gw::inspect
