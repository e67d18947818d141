#include "scene/gltf/gltf_material.h"

#include "gw/base/elementary.h"
#include "scene/text/suggest.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace gw::scene {
namespace {

constexpr Range unit_range{0, 1};
/// F0 of a dielectric of index 1.5.
constexpr double dielectric = 0.04;

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

double encoded_number(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * pow(linear, 1 / 2.4) - 0.055;
}

double decoded(double shown) {
    return shown <= 0.04045 ? shown / 12.92 : pow((shown + 0.055) / 1.055, 2.4);
}

/// What a material is before it has MTL's words.
struct Physical {
    dvec3 base{1}, emissive{0}, F0_tint{1};
    double alpha = 1, metallic = 1, roughness = 1, specular = 1;
    bool unlit = false;
};

void set_words(const Physical& p, Material& material) {
    const vec3 base = encoded(p.base);
    if (p.unlit) {
        material.Ka = material.Kd = material.Ks = vec3(0);
        material.Ke = base;
        return;
    }
    const dvec3 F0 =
        glm::mix(glm::min(p.F0_tint * (dielectric * p.specular), dvec3(1)), p.base, p.metallic);
    const dvec3 diffuse = p.base * (1 - p.metallic);
    const Highlight highlight = highlight_of(F0, diffuse, p.roughness);
    material.Ka = base;
    material.Kd = encoded(diffuse);
    material.Ks = highlight.Ks;
    material.Ns = highlight.Ns;
    material.Ke = encoded(p.emissive);
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
        read_metallic_roughness();
        read_extensions();
        read_emission();
        physical_.alpha *= double(tint.color.w);
        read_alpha();
        warn_left_out();
        physical_.base *= dvec3(vec3(tint.color));
        if (tint.texture) out_.material.map_Kd.push_back(color_map(tint, document_.file()));
        set_words(physical_, out_.material);
        out_.luminance = physical_.unlit ? physical_.base : physical_.emissive;
        if (physical_.unlit) std::swap(out_.material.map_Kd, out_.material.map_Ke);
        if (physical_.metallic > 0.5) out_.material.map_Ks = out_.material.map_Kd;
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
            add_map(out_.material.map_Kd, *texture);
        if (pbr->find("metallicRoughnessTexture")) {
            physical_.metallic = 0;
            physical_.roughness *= 0.5;
            warn("metallicRoughnessTexture",
                 "its metallicRoughnessTexture is left out; it is drawn as metallic 0 and half its "
                 "roughness");
        }
    }

    void read_emission() {
        physical_.emissive = color_of(json_.find("emissiveFactor"), dvec3(0)) * strength_;
        const auto texture = json_.find("emissiveTexture");
        if (texture && physical_.emissive != dvec3(0) && !physical_.unlit)
            add_map(out_.material.map_Ke, *texture);
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

    /// F0 is ((n - 1) / (n + 1))^2; n = 0 stands for a mirror of any angle.
    void read_ior(const std::optional<JsonValue>& value) {
        const double n = number_of(value, 1.5, {0, 100});
        if (n != 0 && n < 1) value->fail_expected("0, or a number from 1 to 100");
        const double root = (n - 1) / (n + 1);
        physical_.specular *= root * root / dielectric;
        if (n >= 0.01) out_.material.Ni = float(n);
    }

    void read_alpha() {
        const auto mode = json_.find("alphaMode");
        if (!mode || mode->text() == "OPAQUE") return;
        if (mode->text() != "MASK" && mode->text() != "BLEND")
            mode->fail_expected("OPAQUE, MASK or BLEND");
        if (!out_.material.map_Kd.empty())
            warn("alpha " + mode->text(), "the alpha of its texture is not used");
        if (mode->text() == "BLEND") out_.material.d = float(physical_.alpha);
        if (mode->text() == "MASK")
            out_.material.d =
                physical_.alpha < number_of(json_.find("alphaCutoff"), 0.5, not_negative) ? 0 : 1;
    }

    void warn_left_out() {
        for (const char* key : {"normalTexture", "occlusionTexture"})
            if (json_.find(key)) warn_texture(key);
    }

    void add_map(std::vector<Map>& list, const JsonValue& info) {
        const JsonValue texture = document_.element("textures", info.at("index"));
        const auto set = info.find("texCoord");
        std::size_t texcoord_set = set ? set->whole(0, 100) : 0;
        Map map;
        map.origin = {document_.file(), 0};
        if (const auto extensions = info.find("extensions"))
            if (const auto transform = extensions->find("KHR_texture_transform")) {
                read_transform(*transform, map);
                if (const auto other = transform->find("texCoord"))
                    texcoord_set = other->whole(0, 100);
            }
        if (has_maps_ && texcoord_set != out_.texcoord_set)
            warn("texCoord",
                 "its textures have several sets of coordinates; all are drawn with set " +
                     std::to_string(out_.texcoord_set));
        else
            out_.texcoord_set = texcoord_set;
        has_maps_ = true;
        if (const auto sampler = texture.find("sampler"))
            read_sampler(document_.element("samplers", *sampler), map);
        const auto source = texture.find("source");
        if (!source)
            return warn("source", "its texture has no picture that GW reads; it is left out");
        read_image(document_.element("images", *source), map);
        list.push_back(std::move(map));
    }

    /// A Map has no rotation: the mesh is turned, for all maps of the material.
    void read_transform(const JsonValue& json, Map& map) {
        TextureTransform transform;
        for (int k = 0; k < 2; ++k) {
            if (const auto s = json.find("scale"))
                transform.scale[k] = (*s)[std::size_t(k)].number(placeable);
            if (const auto o = json.find("offset"))
                transform.offset[k] = (*o)[std::size_t(k)].number(placeable);
        }
        transform.rotation = number_of(json.find("rotation"), 0, placeable);
        if (transform.rotation != 0 && !has_maps_) out_.turn = transform;
        if (out_.turn && *out_.turn == transform) return;
        if (out_.turn || transform.rotation != 0)
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
            if (wrap == mirrored) warn("mirrored", "its texture repeats without being mirrored");
            return wrap == clamp ? Wrap::Clamp : Wrap::Repeat;
        };
        map.wrap_s = wrap_of("wrapS");
        map.wrap_t = wrap_of("wrapT");
        const auto filter = sampler.find("magFilter");
        if (filter && filter->whole(0, 0xFFFF) == 9728)
            warn("magFilter", "its texture is interpolated, not NEAREST");
    }

    void read_image(const JsonValue& image, Map& map) {
        if (const auto view = image.find("bufferView")) {
            map.bytes = std::make_shared<const std::string>(document_.bytes_of_view(*view));
            map.file = document_.file() + ": " + image.place();
            return;
        }
        GltfUri uri = document_.read_uri(image.at("uri"));
        map.bytes = std::move(uri.bytes);
        map.file = std::move(uri.file);
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
    bool has_maps_ = false;
};

}  // namespace

vec3 encoded(const dvec3& linear) {
    return {float(encoded_number(linear.x)), float(encoded_number(linear.y)),
            float(encoded_number(linear.z))};
}

Highlight highlight_of(const dvec3& F0, const dvec3& diffuse, double roughness) {
    constexpr double sharpest = 0.01, most_Ns = 10000;
    const double a2 = std::max(roughness * roughness * roughness * roughness, sharpest * sharpest);
    const dvec3 peak = F0 / (4 * a2);
    const dvec3 lit = diffuse + peak;
    const double most = std::max({lit.x, lit.y, lit.z, 1.0});  // beyond white it keeps its hue
    Highlight out{encoded(glm::max(lit / most, diffuse)) - encoded(diffuse), 0};

    // Where the strongest channel has half its height on the display: GGX is (a2 / root)^2 there.
    const int k = peak.x >= peak.y && peak.x >= peak.z ? 0 : peak.y >= peak.z ? 1 : 2;
    const double half = decoded(encoded_number(diffuse[k]) + double(out.Ks[k]) / 2) - diffuse[k];
    const double root = std::sqrt(half / peak[k]);
    const double cos2 = (1 - a2 / root) / (1 - a2);
    if (a2 < 1 && root > a2) out.Ns = float(std::min(log(0.25) / log(cos2), most_Ns));
    return out;
}

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
