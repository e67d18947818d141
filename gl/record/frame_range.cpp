#include "gl/record/frame_range.h"

#include "gl/drawable/settings.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <optional>
#include <string_view>

namespace gw::gl {

namespace {

std::optional<std::uint64_t> frame_number(std::string_view digits) {
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error != std::errc() || end != digits.data() + digits.size()) return {};
    return number;
}

}  // namespace

FrameRange read_frame_range() {
    const char* const value = std::getenv("GW_FRAMES");
    if (value == nullptr) return {};
    const std::string_view text = value;
    const std::size_t dash = std::min(text.find('-'), text.size());
    const auto first = frame_number(text.substr(0, dash));
    const auto last = dash < text.size() ? frame_number(text.substr(dash + 1)) : first;
    if (first && last && *first <= *last) return {*first, *last};
    report_ignored("GW_FRAMES", text, "expected A-B, such as 10-12");
    return {};
}

}  // namespace gw::gl
