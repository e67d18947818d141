// Planes in the host's layout, and their digests.
#include "gw/planes.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>

namespace gw {

Planes::Planes(int w, int h, int color_planes) : width(w), height(h) {
    const std::size_t size = std::size_t(w) * std::size_t(h);
    color.resize(size);
    depth.resize(size);
    stencil.resize(size);
    accum.resize(size);
    if (color_planes == 2) back.resize(size);
}

Planes::Planes(const Surface& surface) : width(surface.width), height(surface.height) {
    const std::size_t size = std::size_t(width) * std::size_t(height);
    color.resize(size);
    depth.resize(size);
    stencil.resize(size);
}

namespace {

constexpr int block = 64;

/// Digest of one block: its rows in order, each cut at the window's edge.
template <typename T>
XXH128_hash_t block_digest(const std::vector<T>& plane, const Planes& p, int x0, int y0) {
    const auto width = std::size_t(std::min(block, p.width - x0));
    std::vector<T> pixels;
    pixels.reserve(block * block);
    for (int y = y0; y < std::min(y0 + block, p.height); ++y) {
        const auto row = plane.begin() + static_cast<std::ptrdiff_t>(p.index(x0, y));
        pixels.insert(pixels.end(), row, row + static_cast<std::ptrdiff_t>(width));
    }
    return XXH3_128bits(pixels.data(), pixels.size() * sizeof(T));
}

template <typename T>
Digest plane_digest(const std::vector<T>& plane, const Planes& p) {
    std::vector<XXH128_canonical_t> digests;
    for (int y = 0; y < p.height; y += block)
        for (int x = 0; x < p.width; x += block) {
            XXH128_canonical_t canonical;
            XXH128_canonicalFromHash(&canonical, block_digest(plane, p, x, y));
            digests.push_back(canonical);
        }
    const XXH128_hash_t hash =
        XXH3_128bits(digests.data(), digests.size() * sizeof(XXH128_canonical_t));
    return {hash.high64, hash.low64};
}

}  // namespace

Digest digest(const Planes& planes, Plane plane) {
    switch (plane) {
        case Plane::Color: return plane_digest(planes.color, planes);
        case Plane::Depth: return plane_digest(planes.depth, planes);
        case Plane::Stencil: return plane_digest(planes.stencil, planes);
        case Plane::Accum: return plane_digest(planes.accum, planes);
        case Plane::Back: return planes.back.empty() ? Digest{} : plane_digest(planes.back, planes);
    }
    return {};
}

std::string to_string(const Digest& digest) {
    return fmt::format("{:016x}{:016x}", digest.high, digest.low);
}

}  // namespace gw
