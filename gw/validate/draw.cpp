// Checks Draw: its matrix, material and lights. make_mesh and make_texture have checked the rest.
#include "gw/validate/checker.h"

namespace gw {
namespace {

void check_light(const Checker& c, const Light& light) {
    c.finite("light.position", light.position);
    c.finite("light.Ia", light.Ia);
    c.finite("light.Id", light.Id);
    c.finite("light.Is", light.Is);
    c.finite("light.spot_direction", light.spot_direction);
    c.require(light.spot_exponent >= 0 && light.spot_exponent <= 128, "light.spot_exponent",
              light.spot_exponent, "0 to 128");
    c.require(light.spot_cos_cutoff >= -1 && light.spot_cos_cutoff <= 1, "light.spot_cos_cutoff",
              light.spot_cos_cutoff, "-1 to 1");
    for (const float a :
         {light.constant_attenuation, light.linear_attenuation, light.quadratic_attenuation})
        c.require(a >= 0 && std::isfinite(a), "light attenuation", a, "0 or more");
}

void check_material(const Checker& c, const Material& m) {
    for (const vec3& v : {m.Ka, m.Kd, m.Ks, m.Ke}) c.finite("material", v);
    c.require(m.Ns >= 0 && m.Ns <= 10000, "material.Ns", m.Ns, "0 to 10000");
    c.require(std::isfinite(m.alpha), "material.alpha", m.alpha, "a finite number");
}

}  // namespace

void check(const Checker& c, const TextureBinding& map) {
    if (map.texture && map.slot) c.fail("both a texture and a slot; expected one of them");
    c.extension(map.surface.has_value(), c.profile.extensions.surfaces, "surfaces");
    if (map.surface && (map.texture || map.slot))
        c.fail("a surface and another texture; expected one of them");
    if (!map.texture) return;
    const Extensions& e = c.profile.extensions;
    c.extension(map.texture->border, e.texture_border, "texture_border");
    c.extension(map.texture->given_levels, e.texture_formats, "texture_formats");
    c.extension(map.texture->srgb, e.texture_srgb, "texture_srgb");
    c.extension(is_any_size(map.texture->width(), map.texture->height()), e.texture_sizes,
                "texture_sizes");
    c.extension(map.texture->depths, e.texture_depth, "texture_depth");
    c.extension(map.texture->cube, e.texture_cube, "texture_cube");
    c.extension(map.texture->dimensions == 3, e.texture_3d, "texture_3d");
}

void check(const Checker& c, const MoreBindings& maps) {
    for (const TextureBinding& map : maps) {
        c.extension(map.enabled(), c.profile.extensions.texture_units, "texture_units");
        check(c, map);
    }
}

void check(const Checker& c, const Draw& draw) {
    c.require(draw.mesh != nullptr, "mesh", "null", "a mesh");
    c.finite("eye_from_object", draw.eye_from_object);
    check_material(c, draw.material);
    if (draw.back_material) check_material(c, *draw.back_material);
    if (draw.current) {
        c.finite("current.color", draw.current->color);
        c.finite("current.normal", draw.current->normal);
        c.finite("current.texcoord", draw.current->texcoord);
        c.finite("current.secondary_color", draw.current->secondary_color);
        c.finite("current.fog_coordinate", draw.current->fog_coordinate);
        for (const vec4& v : draw.current->more_texcoords) c.finite("current.more_texcoords", v);
    }
    if (draw.mesh.get() != c.checked_mesh)
        for (const FaceMaterials& m : draw.mesh->data().materials) {
            check_material(c, m.front);
            check_material(c, m.back);
        }
    c.checked_mesh = draw.mesh.get();
    check(c, draw.map);
    if (draw.more_maps) check(c, *draw.more_maps);
    c.require(draw.id_shift >= 0 && draw.id_shift < 32, "id_shift", draw.id_shift, "0 to 31");
    if (!draw.lights) return;
    // Most draws have the lights of the previous draw.
    if (draw.lights.get() == c.checked_lights) return;
    if (int(draw.lights->size()) > c.profile.max_lights)
        c.fail(fmt::format("lights in one pass = {}; expected at most {} (profile {})",
                           draw.lights->size(), c.profile.max_lights, c.profile.name));
    for (const Light& light : *draw.lights) check_light(c, light);
    c.checked_lights = draw.lights.get();
}

}  // namespace gw
