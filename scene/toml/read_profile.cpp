#include "scene/toml/read_profile.h"

#include "gw/error.h"
#include "scene/toml/toml_binder.h"

namespace gw::scene {
namespace {

Profile base_of(const TomlValue& file) {
    const TomlValue* base = file.find("base");
    if (!base) return vgx();
    std::vector<std::string> names;
    for (const Profile& profile : profiles()) names.push_back(profile.name);
    return profiles()[to_word(*base, names)];
}

Key extensions_key(Extensions& extensions) {
    return {"extensions", [&extensions](const TomlValue& table) {
                std::vector<Key> keys;
                for (const auto& [name, member] : extension_names())
                    keys.push_back(key(name, extensions.*member));
                read_table(table, keys);
            }};
}

void check(const Profile& profile, const TomlValue& file) {
    try {
        validate(profile);
    } catch (const Error& error) {
        const std::string what = error.what();
        for (const TomlValue& value : file.elements) {
            if (what.find(value.key + " = ") != what.npos) value.fail(what);
        }
        file.fail(what);
    }
}

}  // namespace

Profile read_profile(const std::filesystem::path& path) {
    const TomlValue file = read_toml_file(path);
    Profile p = base_of(file);
    p.name = path.stem().string();
    const Range bits{0, 64};  // the profile's own limits are validate's
    std::string base;
    read_table(file, {
                         key("base", base),
                         key("name", p.name),
                         key("color_bits", p.color_bits, bits),
                         key("depth_bits", p.depth_bits, bits),
                         key("stencil_bits", p.stencil_bits, bits),
                         key("accum_bits", p.accum_bits, bits),
                         key("subpixel_bits", p.subpixel_bits, bits),
                         key("lit_bits", p.lit_bits, bits),
                         key("max_lights", p.max_lights, {0, 1e6}),
                         key("texel_bits", p.texel_bits, bits),
                         key("coverage_bits", p.coverage_bits, bits),
                         key("color_planes", p.color_planes, bits),
                         key("fragment_fog", p.fragment_fog),
                         key("perspective_color", p.perspective_color),
                         extensions_key(p.extensions),
                     });
    check(p, file);
    return p;
}

}  // namespace gw::scene
