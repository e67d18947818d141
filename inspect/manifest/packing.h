// Changed values of a plane in few bytes: runs of pixels, then their numbers as differences, with
// zero differences counted (inspect/manifest/values.fbs, version 2). Does not know planes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gw::inspect {

/// Pixels first .. first + count - 1.
struct PixelRun {
    std::uint32_t first = 0, count = 0;
    bool operator==(const PixelRun&) const = default;
};

/// `numbers`: of all runs, one after the other, `channels` a pixel.
struct PackedChanges {
    std::vector<PixelRun> runs;
    std::vector<std::int64_t> numbers;
};

std::vector<std::uint8_t> pack(const PackedChanges& changes, std::size_t channels);

/// From untrusted bytes: runs in increasing order within `pixels`, and as many numbers as they
/// need. Throws Error if the bytes are anything else.
PackedChanges unpack(std::span<const std::uint8_t> bytes, std::size_t pixels, std::size_t channels);

}  // namespace gw::inspect
