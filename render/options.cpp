#include "render/options.h"

#include "gw/profile.h"
#include "render/renderers.h"
#include "render/words/option_words.h"

#include <fmt/format.h>

#include <algorithm>

namespace gw::render {
namespace {

std::vector<std::string> profile_names() {
    std::vector<std::string> names;
    for (const Profile& profile : profiles()) names.push_back(profile.name);
    return names;
}

std::string point_text(const std::optional<dvec3>& p) {
    return p ? fmt::format("{},{},{}", p->x, p->y, p->z) : "";
}

/// An option whose word is kept as it is.
Option named(const char* name, const char* type, const std::string& about,
             const std::vector<std::string>& words, std::string Request::*member) {
    return {name,
            type,
            about,
            words,
            [=](Request& r, const std::string& word) { r.*member = one_of(name, word, words); },
            [=](const Request& r) { return r.*member; }};
}

/// An option whose words stand for values.
template <class Table, class Value>
Option choice(const char* name, const char* type, const Table& table, Value Request::*member,
              const char* about) {
    return {name,
            type,
            about,
            words_of(table),
            [name, &table, member](Request& r, const std::string& word) {
                r.*member = value_from(name, word, table);
            },
            [&table, member](const Request& r) { return scene::word_of(table, r.*member); }};
}

Option whole_number(const char* name, int low, int high, int Request::*member, const char* about) {
    return {name,
            "N",
            about,
            {},
            [=](Request& r, const std::string& word) {
                r.*member = whole_number_from(name, word, low, high);
            },
            [=](const Request& r) { return r.*member < low ? "" : std::to_string(r.*member); }};
}

Option point(const char* name, std::optional<dvec3> scene::CameraOverrides::*member,
             const char* about) {
    return {name,
            "X,Y,Z",
            about,
            {},
            [=](Request& r, const std::string& word) { r.camera.*member = point_from(name, word); },
            [=](const Request& r) { return point_text(r.camera.*member); }};
}

Option size_option() {
    return {"size",
            "WxH",
            "Pixels, both sides 1..4096 (default 640x480)",
            {},
            [](Request& r, const std::string& word) { r.size = size_from("size", word); },
            [](const Request& r) { return fmt::format("{}x{}", r.size.width, r.size.height); }};
}

Option profile_option() {
    return {"profile",
            "NAME|FILE.toml",
            "vgx, reality, ideal, opengl or a TOML file (default vgx)",
            profile_names(),
            [](Request& r, const std::string& word) {
                r.profile = is_profile_file(word) ? word : one_of("profile", word, profile_names());
            },
            [](const Request& r) { return r.profile; }};
}

Option fov_option() {
    return {"fov",
            "DEGREES",
            "Vertical angle of view",
            {},
            [](Request& r, const std::string& word) {
                r.camera.fov = number_from("fov", word, 0.1, 179);
            },
            [](const Request& r) { return r.camera.fov ? fmt::format("{}", *r.camera.fov) : ""; }};
}

// NOLINTNEXTLINE(readability-function-size): a table
std::vector<Option> all_options() {
    using Camera = scene::CameraOverrides;
    return {
        named("renderer", "NAME", renderers_help(), renderer_names(), &Request::renderer),
        size_option(),
        named(
            "machine", "NAME",
            "The machine that draws; both give the same bits (default " + machines().front() + ")",
            machines(), &Request::machine),
        whole_number("threads", 1, most_threads, &Request::threads,
                     "Threads of the fast machine (default: all)"),
        whole_number("samples", 1, most_samples, &Request::samples,
                     "Pictures superposed against jagged edges (default 1; in groups if the "
                     "accumulation buffer cannot hold them all)"),
        profile_option(),
        point("eye", &Camera::eye, "The eye's position (default: the scene's camera, or fitted)"),
        point("at", &Camera::at, "The point it looks at"),
        point("up", &Camera::up, "The direction that is up in the picture"),
        fov_option(),
        choice(
            "translucency", "NAME", translucency_words, &Request::translucency,
            "Translucent faces: sorted by distance (default), unsorted, or in exact layers pixel "
            "by pixel"),
        choice("shadow", "NAME", scene::shadow_words, &Request::shadow,
               "none, volume or map, for all lights that cast shadows (default: the scene's)"),
        choice("averaging", "NAME", averaging_words, &Request::weighted,
               "Mean of --samples: simple (default), or weighted with integers that fall towards "
               "the pixel's border"),
        choice("reflections", "rays|maps", reflection_words, &Request::traced,
               "Reflections of materials with illum 3 to 7: by rays from an item buffer (default), "
               "or by maps only"),
        whole_number("depth", 1, most_depth, &Request::depth,
                     "Rays in a path, with the one from the eye (default 2; glass needs about 6)"),
        choice("reflected-shadows", "rays|maps", reflected_shadow_words, &Request::shadow_maps,
               "Shadows in reflections: by shadow rays (default), or by the lights' shadow maps"),
    };
}

}  // namespace

const std::vector<Option>& options() {
    static const std::vector<Option> all = all_options();
    return all;
}

bool is_profile_file(const std::string& word) {
    return std::filesystem::path(word).extension() == ".toml";
}

void set(Request& request, const std::string& option, const std::string& word) {
    std::ranges::find(options(), option, &Option::name)->set(request, word);
}

}  // namespace gw::render
