#include "scene/toml/luminous/toml_luminous.h"

#include "gw/base/elementary.h"
#include "scene/read_ies.h"
#include "scene/text/number.h"
#include "scene/text/suggest.h"
#include "scene/text/text_file.h"

#include <algorithm>
#include <cmath>

namespace gw::scene {
namespace {

constexpr Range light_numbers{1e-9, 1e12};

/// With luminance 1; white if there is none.
dvec3 color_of(const TomlValue* value) {
    if (!value) return dvec3(1);
    const dvec3 color(to_color(*value));
    if (color == dvec3(0)) value->fail(value->name + " is 0; expected a colour that is not black");
    return with_luminance_1(color);
}

std::shared_ptr<const Photometry> read_web(const TomlValue& value, Warnings& warnings) {
    const std::string name = to_string(value);
    const std::filesystem::path path =
        find_file(std::filesystem::path(*value.file).parent_path(), name);
    if (const std::string fault = file_fault(path); !fault.empty())
        value.fail("ies '" + printable(name) + "' " + fault + "; expected an IES file");
    return std::make_shared<const Photometry>(read_ies(path, warnings));
}

/// A spot as bright along its axis and with as much light in all: passes know no other distribution.
void show_web(const TomlValue& value, const Photometry& web, Warnings& warnings, Light& light) {
    const double along = web.at(0, 0), lumen = web.lumen();
    const double exponent = along > 0 ? 2 * pi * along / lumen - 1 : 0;
    light.spot_exponent = float(std::clamp(exponent, 0.0, 128.0));
    light.cone_angle = 90;
    warnings.add(*value.file, value.line, "ies",
                 "passes and rays draw " + printable(web.name) + " as a spot with exponent " +
                     number_text(double(std::round(light.spot_exponent))) +
                     "; gw radiosity has the distribution of the file");
}

/// Candela along the axis, or the factor of the web, before colours.
double strength_of(const LuminousKeys& keys, const Light& light) {
    if (keys.candela) return to_double(*keys.candela, light_numbers);
    if (!keys.lumen) return 1;
    Light one = light;
    one.luminous->candela = dvec3(1);
    return to_double(*keys.lumen, light_numbers) / luminous_flux(one).x;
}

void check_keys(const TomlValue& table, const LuminousKeys& keys, const Light& light) {
    for (const TomlValue* key : {keys.color, keys.turn})
        if (key && !keys.candela && !keys.lumen && !keys.lux && !keys.ies)
            key->fail(key->name +
                      " beside no number of light; expected candela, lumen, lux or ies");
    if (keys.turn && !keys.ies) keys.turn->fail("turn turns an IES file; expected ies beside it");
    const TomlValue* const numbers[] = {keys.candela, keys.lumen, keys.lux};
    for (const TomlValue* a : numbers)
        for (const TomlValue* b : numbers)
            if (a && b && a != b)
                b->fail(b->name + " beside " + a->name + "; expected one of them");
    for (const char* key : {"Id", "attenuation"})
        if (const TomlValue* own = table.find(key))
            own->fail(own->name + " beside a number of light; expected one of them");
    const bool sun = light.kind == LightKind::Directional;
    if (keys.lux && !sun) keys.lux->fail("lux of a lamp; expected candela or lumen");
    if (sun && !keys.lux) table.fail("a directional light in candela, lumen or ies; expected lux");
    if (!keys.ies) return;
    if (keys.candela)
        keys.candela->fail("candela beside ies; expected lumen, or the file's own candela");
    if (light.kind != LightKind::Spot)
        table.fail("ies of a light without position and direction; expected both");
    for (const char* key : {"cone", "exponent"})
        if (const TomlValue* own = table.find(key))
            own->fail(own->name + " beside ies; expected one of them");
}

}  // namespace

double to_white(const TomlValue& value) {
    if (value.kind != TomlKind::Table) value.fail_expected("{lux = 500} or {nit = 160}");
    double lux = 0, nit = 0;
    read_table(value, {key("lux", lux, light_numbers), key("nit", nit, light_numbers)});
    if ((lux > 0) == (nit > 0)) value.fail_expected("{lux = 500} or {nit = 160}");
    return lux > 0 ? lux : pi * nit;
}

void add_luminous_keys(std::vector<Key>& keys, LuminousKeys& luminous) {
    const auto keep = [&](const char* name, const TomlValue*& field) {
        keys.push_back({name, [&field](const TomlValue& value) { field = &value; }});
    };
    keep("candela", luminous.candela);
    keep("lumen", luminous.lumen);
    keep("lux", luminous.lux);
    keep("ies", luminous.ies);
    keep("color", luminous.color);
    keep("turn", luminous.turn);
}

void read_luminous(const TomlValue& table, const LuminousKeys& keys, const LightScene& scene,
                   Light& light) {
    const bool any = keys.candela || keys.lumen || keys.lux || keys.ies;
    if (any || keys.color || keys.turn) check_keys(table, keys, light);
    if (!any) return;
    if (scene.white == 0)
        table.fail(
            "light has a number of light, but the scene has no white; expected "
            "white = {lux = 500} or another one");
    const dvec3 color = color_of(keys.color);
    if (keys.lux) {
        light.Id = vec3(color * (to_double(*keys.lux, light_numbers) / scene.white));
        return;
    }
    light.luminous.emplace();
    if (keys.turn) light.luminous->turn = to_double(*keys.turn, {-360, 360});
    if (keys.ies) {
        light.luminous->web = read_web(*keys.ies, scene.warnings);
        show_web(*keys.ies, *light.luminous->web, scene.warnings, light);
    }
    const double strength = strength_of(keys, light);
    light.luminous->candela = color * strength;
    dvec3 along = light.luminous->candela;
    if (light.luminous->web) {
        const double axis = light.luminous->web->at(0, 0);
        along *= axis > 0 ? axis : light.luminous->web->lumen() / (2 * pi);
    }
    light.Id = vec3(along / scene.white);
    light.constant_attenuation = light.linear_attenuation = 0;
    light.quadratic_attenuation = 1;
}

void read_lamp(const TomlValue& table, double nit, PixmapChoice& pixmap) {
    const int given = int(pixmap.emission.has_value()) + int(pixmap.lumen > 0) + int(nit > 0);
    if (given > 1) table.fail("emission, lumen or nit beside each other; expected one of them");
    const TomlValue* const color = table.find("color");
    if (color && (pixmap.emission || given == 0))
        color->fail("color of no lumen or nit; expected one of them beside it");
    const dvec3 tint = color_of(color);
    pixmap.color = vec3(tint);
    if (nit > 0) pixmap.emission = vec3(tint * (pi * nit));
}

}  // namespace gw::scene
