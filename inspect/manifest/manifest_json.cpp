// Manifests as JSON. Reading is strict: a manifest is a claim, and a word that is not understood
// may be part of it.
#include "inspect/manifest/manifest.h"

#include "gw/error.h"
#include "gw/machine.h"
#include "gw/names.h"
#include "inspect/manifest/json_of.h"
#include "inspect/replay/plane_values.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>

namespace gw::inspect {
namespace {

using Json = nlohmann::ordered_json;
constexpr const char* format_name = "gw manifest";

// Objects are begun with Json::object(): the first operator[] of a null value cannot do without the
// memory that it asks for, and ends the process (nlohmann/json 3.11.2).
Json state_json(const std::vector<Field>& state) {
    Json json = Json::object();
    for (const Field& field : state) json[field.name] = field.value;
    return json;
}

/// Names may hold bytes that are no UTF-8.
std::string dumped(const Json& json, int indent = -1) {
    return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

/// Counters that are 0 are left out.
Json counters_json(const Counters& counters) {
    Json json = Json::object();
    for (const auto& [name, count] : counter_names())
        if (counters.*count) json[name] = counters.*count;
    return json;
}

/// The entries are six digits each: R, G, B.
Json color_map_json(const ColorMap& map) {
    std::string entries;
    for (const std::uint32_t rgb : map.entries)
        entries += fmt::format("{:02x}{:02x}{:02x}", rgb & 255, rgb >> 8 & 255, rgb >> 16 & 255);
    return {{"planes", name_of(map.planes)},
            {"bits", map.bits},
            {"bits_in_r", map.bits_in_r},
            {"entries", std::move(entries)}};
}

Json pass_json(const ManifestPass& pass) {
    Json json{{"name", pass.report.name},
              {"set", pass.set},
              {"state", state_json(pass.state)},
              {"counters", counters_json(pass.report.counters)}};
    Json digests = Json::object();
    for (const Plane plane : planes_in_order)
        if (pass.report.digested & mask_of(plane))
            digests[name_of(plane)] = to_string(pass.report.digests[std::size_t(plane)]);
    if (pass.shown) digests["shown"] = to_string(*pass.shown);
    if (!digests.empty()) json["digests"] = std::move(digests);
    for (const QueryResult& query : pass.report.queries)
        json["queries"].push_back({query.key, query.samples});
    if (pass.color_map) json["color_map"] = color_map_json(*pass.color_map);
    return json;
}

/// An object whose members are taken one by one: a missing member, or one left in the end, is an
/// error.
class Members {
public:
    Members(const Json& json, std::string where) : json_(json), where_(std::move(where)) {
        if (!json.is_object()) fail("is not an object; expected one");
    }
    /// Takes a member that must be there.
    const Json& take(const std::string& name) {
        const auto found = json_.find(name);
        if (found == json_.end()) fail("has no member '" + name + "'; expected one");
        ++taken_;
        return *found;
    }
    bool has(const std::string& name) const { return json_.contains(name); }
    template <typename T>
    T get(const std::string& name) {
        const Json& member = take(name);
        const bool right = std::is_same_v<T, std::string> ? member.is_string()
                           : std::is_same_v<T, bool>      ? member.is_boolean()
                           : std::is_unsigned_v<T>        ? member.is_number_unsigned()
                                                   : member.is_number_integer() && fits(member);
        if (!right) fail("'" + name + "' is " + printed(member) + "; expected " + expected<T>());
        return member.get<T>();
    }
    /// All have been taken.
    void finish() const {
        if (taken_ != json_.size())
            fail(fmt::format("has {} members; expected {}, those that docs/recordings.md lists",
                             json_.size(), taken_));
    }
    [[noreturn]] void fail(const std::string& what) const { throw Error(where_ + " " + what); }

private:
    static bool fits(const Json& number) {
        const auto v = number.get<std::int64_t>();
        return v >= -2147483648LL && v <= 2147483647LL;
    }
    static std::string printed(const Json& json) {
        return json.is_primitive() ? dumped(json).substr(0, 40) : json.type_name();
    }
    template <typename T>
    static const char* expected() {
        return std::is_same_v<T, std::string> ? "a string"
               : std::is_same_v<T, bool>      ? "true or false"
                                              : "a whole number";
    }
    const Json& json_;
    std::string where_;
    std::size_t taken_ = 0;
};

Digest digest_from(Members& members, const std::string& name) {
    const auto word = members.get<std::string>(name);
    Digest digest;
    const auto half = [&](std::size_t first, std::uint64_t& value) {
        const char* end = word.data() + first + 16;
        const auto [stop, error] = std::from_chars(word.data() + first, end, value, 16);
        return error == std::errc() && stop == end;
    };
    if (word.size() != 32 || !half(0, digest.high) || !half(16, digest.low))
        members.fail("'" + name + "' is '" + word.substr(0, 40) +
                     "'; expected 32 hexadecimal digits");
    return digest;
}

Profile profile_from(const Json& json) {
    Members m(json, "profile");
    Members e(m.take("extensions"), "profile.extensions");
    Profile p{.name = m.get<std::string>("name"),
              .color_bits = m.get<int>("color_bits"),
              .depth_bits = m.get<int>("depth_bits"),
              .stencil_bits = m.get<int>("stencil_bits"),
              .accum_bits = m.get<int>("accum_bits"),
              .subpixel_bits = m.get<int>("subpixel_bits"),
              .lit_bits = m.get<int>("lit_bits"),
              .max_lights = m.get<int>("max_lights"),
              .fragment_fog = m.get<bool>("fragment_fog"),
              .perspective_color = m.get<bool>("perspective_color")};
    for (std::size_t i = 0; i < extension_names().size(); ++i) {
        const auto& [name, member] = extension_names()[i];
        if (i < always_named_extensions || e.has(name)) p.extensions.*member = e.get<bool>(name);
    }
    if (m.has("texel_bits")) p.texel_bits = m.get<int>("texel_bits");
    if (m.has("coverage_bits")) p.coverage_bits = m.get<int>("coverage_bits");
    if (m.has("color_planes")) p.color_planes = m.get<int>("color_planes");
    m.finish();
    e.finish();
    validate(p);
    return p;
}

/// Pairs of a key and a count.
std::vector<QueryResult> queries_from(const Json& json, const std::string& where) {
    std::vector<QueryResult> out;
    for (const Json& pair : json) {
        if (!pair.is_array() || pair.size() != 2 || !pair[0].is_number_unsigned() ||
            !pair[1].is_number_unsigned())
            throw Error(where + ": queries are pairs of a key and a count");
        out.push_back({pair[0].get<std::uint32_t>(), pair[1].get<std::uint64_t>()});
    }
    return out;
}

ColorMap color_map_from(const Json& json, const std::string& where) {
    Members m(json, where);
    ColorMap map;
    const auto planes = m.get<std::string>("planes");
    const auto named = std::ranges::find_if(every_index_planes,
                                            [&](IndexPlanes p) { return planes == name_of(p); });
    if (named == every_index_planes.end())
        m.fail("'planes' is '" + planes + "'; expected window, overlay, underlay or pop-up");
    map.planes = *named;
    map.bits = m.get<int>("bits");
    map.bits_in_r = m.get<int>("bits_in_r");
    const auto digits = m.get<std::string>("entries");
    m.finish();
    for (std::size_t i = 0; i + 6 <= digits.size(); i += 6) {
        std::uint32_t rgb = 0;
        const char* const end = digits.data() + i + 6;
        if (std::from_chars(digits.data() + i, end, rgb, 16).ptr != end)
            m.fail("'entries' has '" + digits.substr(i, 6) + "'; expected six digits an entry");
        map.entries.push_back((rgb >> 16 & 255) | (rgb & 0xFF00) | (rgb & 255) << 16);
    }
    check_color_map(map);
    return map;
}

/// A pass of a machine with these planes.
ManifestPass pass_from(const Json& json, PlaneMask planes, const std::string& where) {
    Members m(json, where);
    ManifestPass pass;
    pass.report.name = m.get<std::string>("name");
    pass.set = m.get<std::string>("set");
    const Json& changes = m.take("state");
    Members state(changes, where + " state");
    for (const auto& [name, value] : changes.items())
        pass.state.push_back({name, state.get<std::string>(name)});
    Members counters(m.take("counters"), where + " counters");
    for (const auto& [name, count] : counter_names())
        if (counters.has(name)) pass.report.counters.*count = counters.get<std::uint64_t>(name);
    counters.finish();
    Members digests(m.take("digests"), where + " digests");
    for (const Plane plane : planes_in_order) {
        if (!(planes & mask_of(plane))) continue;
        pass.report.digests[std::size_t(plane)] = digest_from(digests, name_of(plane));
    }
    if (digests.has("shown")) pass.shown = digest_from(digests, "shown");
    digests.finish();
    if (m.has("color_map"))
        pass.color_map = color_map_from(m.take("color_map"), where + " color_map");
    if (m.has("queries")) pass.report.queries = queries_from(m.take("queries"), where);
    m.finish();
    pass.report.digested = planes;
    return pass;
}

Json parsed(std::string_view text) {
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& error) {
        throw Error(
            fmt::format("is not JSON at byte {}; expected a manifest that gw wrote", error.byte));
    } catch (const Json::exception&) {
        throw Error("has a number beyond 1e308; expected a manifest that gw wrote");
    }
}

}  // namespace

std::string to_json(const Manifest& m) {
    Json head{{"format", format_name},
              {"version", manifest_version},
              {"producer", m.producer},
              {"scene", {{"file", m.scene}, {"hash", to_string(m.scene_hash)}}},
              {"commands", to_string(m.commands_hash)},
              {"renderer", m.renderer},
              {"profile", json_of(m.profile)},
              {"width", m.width},
              {"height", m.height}};
    if (!m.values.empty()) head["values"] = m.values;
    std::string text = dumped(head, 2);
    text.erase(text.size() - 2);  // "\n}"
    text += ",\n  \"passes\": [";
    for (std::size_t i = 0; i < m.passes.size(); ++i)
        text += (i ? ",\n    " : "\n    ") + dumped(pass_json(m.passes[i]));
    return text + "\n  ]\n}\n";
}

Manifest manifest_from_json(std::string_view text) {
    const Json json = parsed(text);
    Members m(json, "the manifest");
    if (!m.has("format") || m.take("format") != format_name)
        m.fail(fmt::format("is of another kind; expected \"format\": \"{}\"", format_name));
    if (const int version = m.get<int>("version"); version != manifest_version)
        m.fail(fmt::format("is of version {}; expected {}", version, manifest_version));
    Manifest manifest;
    manifest.producer = m.get<std::string>("producer");
    Members scene(m.take("scene"), "scene");
    manifest.scene = scene.get<std::string>("file");
    manifest.scene_hash = digest_from(scene, "hash");
    scene.finish();
    manifest.commands_hash = digest_from(m, "commands");
    manifest.renderer = m.get<std::string>("renderer");
    manifest.profile = profile_from(m.take("profile"));
    manifest.width = m.get<int>("width");
    manifest.height = m.get<int>("height");
    check_window(manifest.width, manifest.height);
    if (m.has("values")) manifest.values = m.get<std::string>("values");
    const Json& passes = m.take("passes");
    if (!passes.is_array()) m.fail("'passes' is not an array; expected one");
    for (const Json& pass : passes)
        manifest.passes.push_back(pass_from(pass, planes_of(manifest.profile),
                                            fmt::format("pass {}", manifest.passes.size())));
    m.finish();
    return manifest;
}

}  // namespace gw::inspect
