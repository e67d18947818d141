#include "scene/gltf/gltf_material.h"

#include "gw/base/elementary.h"
#include "scene/text/suggest.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace gw::scene {
namespace {

constexpr Range unit_range{0, 1};

dvec3 color_of(const std::optional<JsonValue>& value, const dvec3& standard,
               Range range = unit_range) {
    if (!value) return standard;
    dvec3 color;
    for (int k = 0; k < 3; ++k) color[k] = (*value)[std::size_t(k)].number(range);
    return color;
}

double number_of(const std::optional<JsonValue>& value, double standard, Range range = unit_range) {
    return value ? value->number(range) : standard;
}

Map color_map(const Tint& tint, const std::string& file) {
    return {
        .origin = {file, 0}, .wrap_s = Wrap::Clamp, .wrap_t = Wrap::Clamp, .texture = tint.texture};
}

class MaterialReader {
public:
    MaterialReader(const GltfDocument& document, const JsonValue& json, const std::string& name)
        : document_(document), json_(json), name_(name) {}

    GltfMaterial read(const Tint& tint) {
        out_.material.name = name_;
        if (!read_specular_glossiness()) read_metallic_roughness();
        read_extensions();
        read_emission();
        if (const auto sides = json_.find("doubleSided")) out_.double_sided = sides->boolean();
        physical_.alpha *= double(tint.color.w);
        read_alpha();
        warn_left_out();
        if (has_many_sets_) out_.other.reset();
        physical_.base *= dvec3(vec3(tint.color));
        if (tint.texture) out_.material.map_Kd.push_back(color_map(tint, document_.file()));
        set_words(physical_, out_.material);
        out_.luminance = physical_.unlit ? physical_.base : physical_.emissive;
        if (physical_.unlit) {
            std::swap(out_.material.map_Kd, out_.material.map_Ke);
            out_.material.map_metal.clear();
        } else {
            out_.material.physical = std::make_shared<const Physical>(physical_);
        }
        return std::move(out_);
    }

private:
    void read_metallic_roughness() {
        const auto pbr = json_.find("pbrMetallicRoughness");
        if (!pbr) return;
        if (const auto factor = pbr->find("baseColorFactor")) {
            physical_.base = color_of(factor, dvec3(1));
            physical_.alpha = (*factor)[3].number(unit_range);
        }
        physical_.metallic = number_of(pbr->find("metallicFactor"), 1);
        physical_.roughness = number_of(pbr->find("roughnessFactor"), 1);
        if (const auto texture = pbr->find("baseColorTexture"))
            add_map(out_.material.map_Kd, *texture, "baseColorTexture");
        if (const auto texture = pbr->find("metallicRoughnessTexture"))
            add_map(out_.material.map_metal, *texture, "metallicRoughnessTexture");
    }

    void read_emission() {
        physical_.emissive = color_of(json_.find("emissiveFactor"), dvec3(0)) * strength_;
        const auto texture = json_.find("emissiveTexture");
        if (texture && physical_.emissive != dvec3(0) && !physical_.unlit)
            add_map(out_.material.map_Ke, *texture, "emissiveTexture");
    }

    void read_extensions() {
        const auto extensions = json_.find("extensions");
        if (!extensions) return;
        physical_.unlit = extensions->find("KHR_materials_unlit").has_value();
        if (const auto emissive = extensions->find("KHR_materials_emissive_strength"))
            strength_ = number_of(emissive->find("emissiveStrength"), 1, {0, 1e6});
        if (const auto ior = extensions->find("KHR_materials_ior")) read_ior(ior->find("ior"));
        const auto specular = extensions->find("KHR_materials_specular");
        if (!specular) return;
        physical_.specular *= number_of(specular->find("specularFactor"), 1);
        physical_.F0_tint = color_of(specular->find("specularColorFactor"), dvec3(1), {0, 1e6});
        for (const char* key : {"specularTexture", "specularColorTexture"})
            if (specular->find(key)) warn_texture(key);
    }

    /// KHR_materials_pbrSpecularGlossiness: in place of the metallic-roughness model. Whether it is
    /// there.
    bool read_specular_glossiness() {
        const auto extensions = json_.find("extensions");
        const auto model =
            extensions ? extensions->find("KHR_materials_pbrSpecularGlossiness") : std::nullopt;
        if (!model) return false;
        const auto diffuse = model->find("diffuseFactor");
        physical_.base = color_of(diffuse, dvec3(1));
        physical_.alpha = diffuse ? (*diffuse)[3].number(unit_range) : 1;
        physical_.metallic = 0;
        physical_.F0 = color_of(model->find("specularFactor"), dvec3(1));
        physical_.roughness = 1 - number_of(model->find("glossinessFactor"), 1);
        if (const auto texture = model->find("diffuseTexture"))
            add_map(out_.material.map_Kd, *texture, "diffuseTexture");
        if (const auto texture = model->find("specularGlossinessTexture"))
            add_map(out_.material.map_metal, *texture, "specularGlossinessTexture");
        return true;
    }

    /// F0 is ((n - 1) / (n + 1))^2; n = 0 stands for a mirror of any angle.
    void read_ior(const std::optional<JsonValue>& value) {
        const double n = number_of(value, 1.5, {0, 100});
        if (n != 0 && n < 1) value->fail_expected("0, or a number from 1 to 100");
        const double root = (n - 1) / (n + 1);
        physical_.specular *= root * root / dielectric_F0;
        if (n >= 0.01) out_.material.Ni = float(n);
    }

    void read_alpha() {
        const auto mode = json_.find("alphaMode");
        if (!mode || mode->text() == "OPAQUE") return;
        if (mode->text() != "MASK" && mode->text() != "BLEND")
            mode->fail_expected("OPAQUE, MASK or BLEND");
        Material& m = out_.material;
        m.map_d = m.map_Kd;
        m.vertex_d = true;
        if (mode->text() == "BLEND") {
            m.d = float(physical_.alpha);
            return;
        }
        const double cutoff = number_of(json_.find("alphaCutoff"), 0.5, not_negative);
        m.d = physical_.alpha < cutoff ? 0 : 1;
        if (m.d == 1) m.d_cutoff = cutoff > 0 ? float(cutoff / physical_.alpha) : 0;
    }

    void warn_left_out() {
        for (const char* key : {"normalTexture", "occlusionTexture"})
            if (json_.find(key)) warn_texture(key);
    }

    void add_map(std::vector<Map>& list, const JsonValue& info, const std::string& name) {
        const JsonValue texture = document_.element("textures", info.at("index"));
        const auto source = texture.find("source");
        if (!source)
            return warn("source", "its " + name + " has no picture that GW reads; it is left out");
        Map map;
        map.origin = {document_.file(), 0};
        read_image(document_.element("images", *source), map);
        if (const auto sampler = texture.find("sampler"))
            read_sampler(document_.element("samplers", *sampler), map);
        const auto extensions = info.find("extensions");
        const auto transform =
            extensions ? extensions->find("KHR_texture_transform") : std::nullopt;
        const auto other = transform ? transform->find("texCoord") : std::nullopt;
        CoordinateSet* const set = choose_set(other ? other : info.find("texCoord"), name);
        map.is_mean = set != &out_.own;
        if (transform && set) read_transform(*transform, map, *set);
        if (set) used_.insert(set->index);
        list.push_back(std::move(map));
    }

    /// The first map's or a second one; null, with a warning, if there are more.
    CoordinateSet* choose_set(const std::optional<JsonValue>& value, const std::string& name) {
        const std::size_t set = value ? value->whole(0, 100) : 0;
        if (used_.empty()) out_.own.index = set;
        if (set == out_.own.index) return &out_.own;
        if (!out_.other) out_.other = CoordinateSet{set, std::nullopt};
        if (set == out_.other->index) return &*out_.other;
        warn("texCoord", "its " + name + " has texCoord " + std::to_string(set) +
                             " beside textures with " + std::to_string(out_.own.index) + " and " +
                             std::to_string(out_.other->index) +
                             "; expected at most two, so all but those with the first are drawn "
                             "with their mean");
        has_many_sets_ = true;
        return nullptr;
    }

    /// A Map has no rotation: the mesh is turned, for all maps of one set.
    void read_transform(const JsonValue& json, Map& map, CoordinateSet& set) {
        TextureTransform transform;
        for (int k = 0; k < 2; ++k) {
            if (const auto s = json.find("scale"))
                transform.scale[k] = (*s)[std::size_t(k)].number(placeable);
            if (const auto o = json.find("offset"))
                transform.offset[k] = (*o)[std::size_t(k)].number(placeable);
        }
        transform.rotation = number_of(json.find("rotation"), 0, placeable);
        if (transform.rotation != 0 && !used_.contains(set.index)) set.turn = transform;
        if (set.turn && *set.turn == transform) return;
        if (set.turn || transform.rotation != 0)
            warn("rotation", "its textures are turned in several ways; all are drawn as the first");
        map.scale = vec2(transform.scale);
        map.offset = vec2(transform.offset.x, 1 - transform.scale.y - transform.offset.y);
    }

    void read_sampler(const JsonValue& sampler, Map& map) {
        constexpr std::size_t repeat = 10497, clamp = 33071, mirrored = 33648;
        const auto wrap_of = [&](const char* key) {
            const auto value = sampler.find(key);
            const std::size_t wrap = value ? value->whole(0, 0xFFFF) : repeat;
            if (wrap != repeat && wrap != clamp && wrap != mirrored)
                value->fail_expected("10497, 33071 or 33648");
            return wrap == clamp      ? Wrap::Clamp
                   : wrap == mirrored ? Wrap::MirroredRepeat
                                      : Wrap::Repeat;
        };
        map.wrap_s = wrap_of("wrapS");
        map.wrap_t = wrap_of("wrapT");
        const auto filter = sampler.find("magFilter");
        if (filter && filter->whole(0, 0xFFFF) == 9728)
            warn("magFilter", "its texture is interpolated, not NEAREST");
    }

    void read_image(const JsonValue& image, Map& map) {
        map.place = image.place();
        if (const auto view = image.find("bufferView")) {
            map.bytes = std::make_shared<const std::string>(document_.bytes_of_view(*view));
            map.file = document_.file() + ": " + image.place();
            return;
        }
        map.place = image.at("uri").place();
        GltfUri uri = document_.read_uri(image.at("uri"));
        map.bytes = std::move(uri.bytes);
        map.file = std::move(uri.file);
        map.may_lack = !map.bytes;
        if (map.bytes) map.file = document_.file() + ": " + image.place();
    }

    void warn_texture(const std::string& key) { warn(key, "its " + key + " is left out"); }
    void warn(const std::string& kind, const std::string& text) {
        document_.warn("material " + kind, "material '" + printable(name_) + "': " + text);
    }

    const GltfDocument& document_;
    const JsonValue json_;
    const std::string& name_;
    GltfMaterial out_;
    Physical physical_;
    double strength_ = 1;
    std::set<std::size_t> used_;  ///< sets of coordinates
    bool has_many_sets_ = false;
};

}  // namespace

vec2 TextureTransform::moved(const vec2& st) const {
    const dvec2 scaled = dvec2(st.x, 1 - double(st.y)) * scale;
    const double c = cos(rotation), s = sin(rotation);
    const dvec2 uv = offset + dvec2(c * scaled.x + s * scaled.y, c * scaled.y - s * scaled.x);
    return {float(uv.x), float(1 - uv.y)};
}

GltfMaterial read_gltf_material(const GltfDocument& document, const JsonValue& material,
                                const std::string& name, const Tint& tint) {
    return MaterialReader(document, material, name).read(tint);
}

GltfMaterial default_gltf_material(const Tint& tint) {
    GltfMaterial out;
    out.material.name = "default";
    Physical physical;
    physical.base = dvec3(vec3(tint.color));
    set_words(physical, out.material);
    if (tint.texture) out.material.map_Kd = out.material.map_Ks = {color_map(tint, std::string())};
    return out;
}

}  // namespace gw::scene
