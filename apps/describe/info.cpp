// gw info: the profiles, limits and vectors of this build, and its compiler and libraries.
#include "apps/command/command.h"
#include "apps/command/terminal.h"
#include "gw/machine.h"
#include "image/write.h"
#include "inspect/manifest/json_of.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <CLI/Version.hpp>
#include <glm/detail/setup.hpp>
#include <nlohmann/json_fwd.hpp>

#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

namespace gw::apps {
namespace {

/// The libraries and the compiler that gw was built with: name, number; in a fixed order.
std::vector<std::pair<std::string, std::string>> versions() {
    return {
#ifdef __clang__
        {"compiler", "clang++ " __clang_version__},
#else
        {"compiler", "g++ " __VERSION__},
#endif
        {"OpenImageIO", image::library_version()},
        {"GLM", fmt::format("{}.{}.{}.{}", GLM_VERSION_MAJOR, GLM_VERSION_MINOR, GLM_VERSION_PATCH,
                            GLM_VERSION_REVISION)},
        {"CLI11", CLI11_VERSION},
        {"fmt",
         fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
        {"nlohmann-json", fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR,
                                      NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)},
    };
}

std::string extensions_of(const Profile& profile) {
    std::string names;
    for (const auto& [name, member] : extension_names())
        if (profile.extensions.*member) names += (names.empty() ? "" : " ") + std::string(name);
    return names.empty() ? "none" : names;
}

struct Row {
    const char* title;
    int Profile::*bits;
};
constexpr Row profile_rows[] = {
    {"colour, bits per channel", &Profile::color_bits},
    {"Z, bits", &Profile::depth_bits},
    {"stencil, bits", &Profile::stencil_bits},
    {"colour planes", &Profile::color_planes},
    {"accumulation, bits per channel, signed", &Profile::accum_bits},
    {"sub-pixel bits", &Profile::subpixel_bits},
    {"lit vertex colour, bits", &Profile::lit_bits},
    {"lights in one pass", &Profile::max_lights},
    {"antialiasing, bits of coverage", &Profile::coverage_bits},
};

std::string line(const std::string& title, const std::function<std::string(const Profile&)>& cell) {
    std::string text = fmt::format("  {:<40}", title);
    for (const Profile& profile : profiles()) text += fmt::format("{:>10}", cell(profile));
    return text + "\n";
}

std::string text() {
    std::string out = fmt::format("gw {}\n\nprofiles\n", version());
    out += line("", [](const Profile& p) { return p.name; });
    for (const Row& row : profile_rows) {
        out += line(row.title, [&](const Profile& p) { return std::to_string(p.*row.bits); });
    }
    out +=
        line("fog factor", [](const Profile& p) { return p.fragment_fog ? "fragment" : "vertex"; });
    out += line("Gouraud colour, linear in",
                [](const Profile& p) { return p.perspective_color ? "space" : "screen"; });
    for (const Profile& p : profiles())
        out += fmt::format("  extensions of {:<26}{}\n", p.name, extensions_of(p));
    out += fmt::format("\nwindow {0} x {0} at most\nthreads {1}\nvectors {2}\n\nmade with\n",
                       max_window_size, std::thread::hardware_concurrency(), simd_target());
    for (const auto& [name, number] : versions()) out += fmt::format("  {:<16}{}\n", name, number);
    return out;
}

std::string json() {
    nlohmann::ordered_json json{{"version", version()},
                                {"profiles", nlohmann::ordered_json::array()}};
    for (const Profile& profile : profiles()) json["profiles"].push_back(inspect::json_of(profile));
    json["max_window_size"] = max_window_size;
    json["threads"] = std::thread::hardware_concurrency();
    json["vectors"] = simd_target();
    auto made_with = nlohmann::ordered_json::object();
    for (const auto& [name, number] : versions()) made_with[name] = number;
    json["made_with"] = std::move(made_with);
    return json.dump(2) + "\n";
}

}  // namespace

Command add_info(CLI::App& app) {
    CLI::App* command = app.add_subcommand("info", "Profiles, threads, versions");
    const auto as_json = std::make_shared<bool>(false);
    command->add_flag("--json", *as_json, "The same as JSON");
    command->footer("Example:\n  build/release/bin/gw info --json");
    return {command, [as_json](Session&) {
                print(*as_json ? json() : text());
                return Done;
            }};
}

}  // namespace gw::apps
