#include "multipass/passes/pass_toml.h"

#include "multipass/passes/pass_keys.h"
#include "multipass/passes/tokens.h"
#include "multipass/passes/validate_passes.h"
#include "scene/toml/toml_binder.h"

#include <fmt/format.h>

#include <utility>

namespace gw::multipass {
namespace {

using scene::TomlKind;
using scene::TomlValue;

bool is_source(BlendFactor f) {
    return f != BlendFactor::SrcColor && f != BlendFactor::OneMinusSrcColor;
}
bool is_destination(BlendFactor f) {
    return f != BlendFactor::DstColor && f != BlendFactor::OneMinusDstColor &&
           f != BlendFactor::SrcAlphaSaturate;
}

template <typename Enum>
bool any_of_them(Enum) {
    return true;
}

/// "object", a number, or three.
Parameter to_parameter(const TomlValue& value) {
    if (value.kind == TomlKind::String) {
        std::vector<std::string> known;
        for (const auto& [kind, text] : tokens(Parameter::Kind{})) known.emplace_back(text);
        return Parameter(tokens(Parameter::Kind{})[scene::to_word(value, known)].first);
    }
    if (!value.is_number() && value.kind != TomlKind::Array)
        value.fail_expected(
            "'object', 'object Ks', 'object Tf', a number or an array of 3 numbers");
    const vec3 color = scene::to_color(value);
    return {color.x, color.y, color.z};
}

Name to_name(const TomlValue& value) {
    const std::string text = scene::to_string(value);
    if (text.empty() || text.size() > Name::most)
        value.fail(
            fmt::format("{} has {} bytes; expected 1 to {}", value.name, text.size(), Name::most));
    return Name(text);
}

/// Collects what reads each key of one table.
struct Reading {
    std::vector<scene::Key> list;

    void read(const char* name, auto read) { list.push_back({name, std::move(read)}); }

    void name(const char* key, Name& name) {
        read(key, [&name](const TomlValue& value) { name = to_name(value); });
    }
    template <typename Enum>
    void token(const char* key, Enum& token, bool (*allowed)(Enum) = any_of_them) {
        std::vector<std::pair<std::string, Enum>> known;
        for (const auto& [value, text] : tokens(Enum{}))
            if (allowed(value)) known.emplace_back(text, value);
        list.push_back(scene::key(key, token, std::move(known)));
    }
    void source(const char* key, BlendFactor& factor) { token(key, factor, is_source); }
    void destination(const char* key, BlendFactor& factor) { token(key, factor, is_destination); }
    void flag(const char* key, bool& flag) { list.push_back(scene::key(key, flag)); }
    /// References and masks: a stencil has at most 8 bits.
    void number(const char* key, auto& number) {
        read(key, [&number](const TomlValue& value) {
            number = static_cast<std::remove_reference_t<decltype(number)>>(
                scene::to_int(value, {0, 255}));
        });
    }
    void parameter(const char* key, Parameter& parameter) {
        read(key, [&parameter](const TomlValue& value) { parameter = to_parameter(value); });
    }
    void planes(const char* key, PlaneMask& planes) {
        read(key, [&planes](const TomlValue& value) {
            if (value.kind != TomlKind::Array) value.fail_expected("an array of planes");
            planes = 0;
            for (const TomlValue& element : value.elements) {
                Plane plane{};
                Reading one;
                one.token("", plane);
                one.list.front().read(element);
                planes |= mask_of(plane);
            }
        });
    }
    void table(const char* key, bool& on, auto& fields, auto keys_of_it) {
        read(key, [&on, &fields, keys_of_it](const TomlValue& value) {
            Reading inner;
            keys_of_it(inner, fields);
            scene::read_table(value, inner.list);
            on = true;
        });
    }
    /// A token, or an array of names.
    void objects(const char* key, PassObjects& objects, std::vector<std::string>& names) {
        Reading one;
        one.token(
            key, objects, +[](PassObjects o) { return o != PassObjects::Named; });
        read(key, [&, one](const TomlValue& value) {
            if (value.kind != TomlKind::Array) return one.list.front().read(value);
            objects = PassObjects::Named;
            names = scene::to_strings(value);
        });
    }
};

Pass read_pass(const TomlValue& table) {
    Pass pass;
    Reading keys;
    pass_keys(keys, pass);
    scene::read_table(table, keys.list);
    return pass;
}

}  // namespace

PassList read_passes(const std::vector<TomlValue>& tables) {
    PassList passes;
    for (const TomlValue& table : tables) passes.push_back(read_pass(table));
    if (const auto fault = first_fault(passes)) {
        const TomlValue& table = tables[fault->pass];
        const TomlValue* key = table.find(fault->key);
        (key ? *key : table).fail(fault->what);
    }
    return passes;
}

}  // namespace gw::multipass
