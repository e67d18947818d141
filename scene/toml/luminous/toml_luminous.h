// Reads the numbers of light of a TOML scene: its white, lamps and lights in lumen, candela, nit and
// lux, and IES files.
#pragma once

#include "scene/toml/toml_sections.h"

namespace gw::scene {

/// {lux = 500} or {nit = 160}, as lux: a white surface has 1 / pi as many nit. Throws Error.
double to_white(const TomlValue& value);

/// The keys of a light that has numbers.
struct LuminousKeys {
    const TomlValue *candela = nullptr, *lumen = nullptr, *lux = nullptr, *ies = nullptr;
    const TomlValue *color = nullptr, *turn = nullptr;
};
void add_luminous_keys(std::vector<Key>& keys, LuminousKeys& luminous);

/// Sets `light.luminous`, and Id and attenuation so that passes show it. The light has all its other
/// keys. Throws Error for keys that exclude each other, and without a white of the scene.
void read_luminous(const TomlValue& table, const LuminousKeys& keys, const LightScene& scene,
                   Light& light);

/// Reads a pixmap's lumen, nit and color: nit become its emission. Throws Error for keys that exclude
/// each other.
void read_lamp(const TomlValue& table, double nit, PixmapChoice& pixmap);

}  // namespace gw::scene
