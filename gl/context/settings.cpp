#include "gl/context/settings.h"

#include "gw/error.h"

#include <charconv>
#include <cstdlib>
#include <string>
#include <string_view>

namespace gw::gl {

namespace {

constexpr int most_threads = 256;

int thread_count(std::string_view text) {
    int count = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
    if (error != std::errc() || end != text.data() + text.size() || count < 0 ||
        count > most_threads)
        throw Error("GW_THREADS is '" + std::string(text) + "'; expected 0 to 256 (0: all)");
    return count;
}

Settings read_settings() {
    Settings out;
    const char* const profile = std::getenv("GW_PROFILE");
    const char* const threads = std::getenv("GW_THREADS");
    out.profile = profile != nullptr ? profile_named(profile) : opengl();
    if (threads != nullptr) out.threads = thread_count(threads);
    return out;
}

}  // namespace

const Settings& settings() {
    static const Settings read = read_settings();
    return read;
}

}  // namespace gw::gl
