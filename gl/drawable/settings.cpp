#include "gl/drawable/settings.h"

#include "gw/base/leaked_static.h"
#include "gw/error.h"
#include "gw/escape_controls.h"
#include "gw/profile_text.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>

namespace gw::gl {

namespace {

constexpr int most_threads = 256;

void read_profile(Settings& out, const char* value) {
    try {
        out.profile = profile_from_text(value);
    } catch (const Error& error) {
        report_ignored("GW_PROFILE", value, error.what());
    }
}

void read_threads(Settings& out, std::string_view value) {
    int count = 0;
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), count);
    if (error != std::errc() || end != value.data() + value.size() || count < 0 ||
        count > most_threads)
        return report_ignored("GW_THREADS", value, "expected 0 to 256 (0: all)");
    out.threads = count;
}

void read_machine(Settings& out, std::string_view value) {
    if (value != "fast" && value != "reference")
        return report_ignored("GW_MACHINE", value, "expected fast or reference");
    out.reference = value == "reference";
}

void read_version(Settings& out, std::string_view value) {
    for (int version = first_version; version <= last_version; ++version)
        if (value == "1." + std::to_string(version % 10)) {
            out.version = version;
            return;
        }
    report_ignored("GW_GL_VERSION", value, "expected 1.1, 1.2, 1.3, 1.4 or 1.5");
}

void read_swap(Settings& out, std::string_view value) {
    if (value != "copy" && value != "exchange")
        return report_ignored("GW_SWAP", value, "expected copy or exchange");
    out.swap = value == "copy" ? SwapMethod::Copy : SwapMethod::Exchange;
}

std::optional<std::uint64_t> frame_number(std::string_view digits) {
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error != std::errc() || end != digits.data() + digits.size()) return {};
    return number;
}

Settings read_settings() {
    Settings out;
    if (const char* const value = std::getenv("GW_PROFILE")) read_profile(out, value);
    if (const char* const value = std::getenv("GW_THREADS")) read_threads(out, value);
    if (const char* const value = std::getenv("GW_MACHINE")) read_machine(out, value);
    if (const char* const value = std::getenv("GW_GL_VERSION")) read_version(out, value);
    if (const char* const value = std::getenv("GW_SWAP")) read_swap(out, value);
    return out;
}

}  // namespace

int offered_minor() { return whole_version(settings().profile, settings().version) % 10; }

const Settings& settings() {
    static const Settings& read = leaked_static(read_settings());
    return read;
}

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

void report_ignored(std::string_view variable, std::string_view value, std::string_view expected) {
    const std::string line = "gw: " + std::string(variable) + " is '" + escape_controls(value) +
                             "'; " + std::string(expected) + "; it is ignored\n";
    std::fputs(line.c_str(), stderr);
}

void report_refused_context(int major, int minor) {
    if (major == 1 && minor <= offered_minor()) {
        std::fprintf(
            stderr,
            "gw: a core or forward-compatible context is asked for; OpenGL 1.%d with its fixed "
            "pipeline is offered; no context is made\n",
            offered_minor());
        return;
    }
    std::fprintf(stderr, "gw: OpenGL %d.%d is asked for; 1.%d is offered; no context is made\n",
                 major, minor, offered_minor());
}

std::unique_ptr<Machine> make_machine(const Profile& profile, int width, int height) {
    if (settings().reference) return make_reference(profile, width, height);
    return make_fast(profile, width, height, {.threads = settings().threads});
}

}  // namespace gw::gl
