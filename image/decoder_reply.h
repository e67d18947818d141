// The decoder's reply to each file name (a line): this header, then `bytes` of R, G, B, A, bottom row
// first, or of a message.
#pragma once

#include <cstdint>

namespace gw::image {

struct DecoderReply {
    enum Kind : std::uint32_t { Message = 1, Bits8 = 8, Bits16 = 16 };
    std::uint32_t kind = Message;
    std::int32_t width = 0, height = 0;
    float largest = 1;  ///< value of the file; above 1 it was clamped
    std::uint64_t bytes = 0;
};

/// Limits for a file: the decoder's processor time, its memory, and the time until it is killed.
inline constexpr int decoder_seconds = 20;
inline constexpr std::uint64_t decoder_megabytes = 1024;
inline constexpr int decoder_patience_seconds = 60;

}  // namespace gw::image
