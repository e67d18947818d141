#include "multipass/passes/pass_toml.h"

#include "gw/describe/opengl.h"
#include "multipass/passes/pass.h"
#include "multipass/passes/tokens.h"
#include "multipass/passes/validate_passes.h"
#include "scene/toml/toml_binder.h"

#include <fmt/format.h>

#include <utility>

namespace gw::multipass {
namespace {

/// The keys of [[pass]], each named once: reader and writer share them. `keys` has a function for
/// each kind of value; a table means a switch that is on.
template <typename Keys, typename PassOrConst>
void pass_keys(Keys& keys, PassOrConst& pass) {
    keys.name("name", pass.name);
    keys.token("action", pass.action);
    keys.planes("clear", pass.clear);
    keys.parameter("Ka", pass.material.Ka);
    keys.parameter("Kd", pass.material.Kd);
    keys.parameter("Ks", pass.material.Ks);
    keys.parameter("Ke", pass.material.Ke);
    keys.token("Map", pass.material.Map);
    keys.table("depth", pass.depth.test, pass.depth, [](auto& k, auto& depth) {
        k.token("func", depth.func);
        k.flag("mask", depth.mask);
    });
    const auto stencil_face = [](auto& k, auto& face) {
        k.token("func", face.func);
        k.number("ref", face.ref);
        k.number("mask", face.mask);
        k.token("fail", face.fail);
        k.token("zfail", face.zfail);
        k.token("zpass", face.zpass);
        k.number("write_mask", face.write_mask);
    };
    keys.table("stencil", pass.stencil.test, pass.stencil, [&](auto& k, auto& stencil) {
        stencil_face(k, stencil);
        k.table("back", stencil.two_side, stencil.back, stencil_face);
    });
    keys.table("blend", pass.blend.enable, pass.blend, [](auto& k, auto& blend) {
        k.source("src", blend.src);
        k.destination("dst", blend.dst);
        k.token("equation", blend.equation);
        k.color("color", blend.color);
        k.table("alpha", blend.alpha.separate, blend.alpha, [](auto& a, auto& alpha) {
            a.source("src", alpha.src);
            a.destination("dst", alpha.dst);
            a.token("equation", alpha.equation);
        });
    });
    keys.flag("color", pass.color);
    keys.token("fog", pass.fog);
    keys.token("lights", pass.lights);
    keys.objects("objects", pass.objects, pass.names);
}

using scene::TomlKind;
using scene::TomlValue;

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

/// Collects the reader of each key of one table.
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
    void color(const char* key, vec4& color) {
        read(key, [&color](const TomlValue& value) {
            scene::expect_numbers(value, 4);
            for (int i = 0; i < 4; ++i)
                color[i] = scene::to_float(value.elements[std::size_t(i)], {0, 1});
        });
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
    void color(const char* key, const vec4& c) {
        write(key, fmt::format("[{}, {}, {}, {}]", c.x, c.y, c.z, c.w));
    }
    void planes(const char* key, PlaneMask planes) {
        std::vector<std::string> names;
        for (const auto& [plane, name] : tokens(Plane{}))
            if (planes & mask_of(plane)) names.push_back(toml_string(name));
        write(key, fmt::format("[{}]", fmt::join(names, ", ")));
    }
    /// The first two keys, which name the table's subject, and those that differ from the initial
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

std::string to_toml(const PassList& passes) {
    std::string text;
    for (const Pass& pass : passes) text += (text.empty() ? "" : "\n") + to_toml(pass);
    return text;
}

}  // namespace gw::multipass
