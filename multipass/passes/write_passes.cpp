#include "multipass/passes/pass_keys.h"
#include "multipass/passes/pass_toml.h"
#include "multipass/passes/tokens.h"

#include <fmt/format.h>

#include <utility>

namespace gw::multipass {
namespace {

std::string toml_string(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\')
            out += std::string("\\") + c;
        else
            out += byte < 0x20 || byte == 0x7f ? fmt::format("\\u{:04x}", byte) : std::string(1, c);
    }
    return out + "\"";
}

/// Collects each key of one table with its value as text.
struct Writing {
    std::vector<std::pair<std::string, std::string>> list;

    void write(const char* key, std::string text) { list.emplace_back(key, std::move(text)); }

    void name(const char* key, const Name& name) { write(key, toml_string(name.view())); }
    void token(const char* key, auto value) { write(key, toml_string(multipass::token(value))); }
    void source(const char* key, BlendFactor factor) { token(key, factor); }
    void destination(const char* key, BlendFactor factor) { token(key, factor); }
    void flag(const char* key, bool flag) { write(key, flag ? "true" : "false"); }
    void number(const char* key, auto number) { write(key, std::to_string(number)); }
    void parameter(const char* key, const Parameter& p) {
        if (p.kind != Parameter::Kind::Value) return token(key, p.kind);
        const auto& v = p.value;
        const bool grey = v[0] == v[1] && v[1] == v[2];
        write(key, grey ? fmt::format("{}", v[0]) : fmt::format("[{}, {}, {}]", v[0], v[1], v[2]));
    }
    void planes(const char* key, PlaneMask planes) {
        std::vector<std::string> names;
        for (const auto& [plane, name] : tokens(Plane{}))
            if (planes & mask_of(plane)) names.push_back(toml_string(name));
        write(key, fmt::format("[{}]", fmt::join(names, ", ")));
    }
    /// The first two keys, which say what the table is about, and what differs from the initial
    /// state.
    template <typename Fields>
    void table(const char* key, bool on, const Fields& fields, auto keys_of_it) {
        Writing inner, initial;
        keys_of_it(inner, fields);
        keys_of_it(initial, std::as_const(unchanged<Fields>));
        std::vector<std::string> entries;
        for (std::size_t i = 0; i < inner.list.size(); ++i)
            if (i < 2 || inner.list[i] != initial.list[i])
                entries.push_back(inner.list[i].first + " = " + inner.list[i].second);
        write(key, on ? fmt::format("{{{}}}", fmt::join(entries, ", ")) : "");
    }
    void objects(const char* key, PassObjects objects, const std::vector<std::string>& names) {
        if (objects != PassObjects::Named) return token(key, objects);
        std::vector<std::string> texts;
        for (const std::string& name : names) texts.push_back(toml_string(name));
        write(key, fmt::format("[{}]", fmt::join(texts, ", ")));
    }

    template <typename Fields>
    static inline const Fields unchanged{};
};

/// The paper writes the whole set, zeros and all.
bool always_written(const Pass& pass, std::string_view key) {
    return key == "name" || (pass.action == PassAction::Draw && (key[0] == 'K' || key == "Map"));
}

std::string to_toml(const Pass& pass) {
    Writing keys, initial;
    pass_keys(keys, pass);
    pass_keys(initial, std::as_const(Writing::unchanged<Pass>));
    std::string text = "[[pass]]\n";
    for (std::size_t i = 0; i < keys.list.size(); ++i) {
        const auto& [key, value] = keys.list[i];
        if (always_written(pass, key) || keys.list[i] != initial.list[i])
            text += fmt::format("{} = {}\n", key, value);
    }
    return text;
}

}  // namespace

std::string to_toml(const PassList& passes) {
    std::string text;
    for (const Pass& pass : passes) text += (text.empty() ? "" : "\n") + to_toml(pass);
    return text;
}

}  // namespace gw::multipass
