#include "scene/obj/read_mtl.h"

#include "scene/obj/map_options.h"
#include "scene/obj/obj_tokens.h"
#include "scene/text/encoding.h"
#include "scene/text/suggest.h"
#include "scene/text/text_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace gw::scene {
namespace {

// Files differ in the case of keywords, so these tables are in lower case.
struct ColorWord {
    std::string_view name;
    vec3 Material::*field;
};
constexpr std::array colors{
    ColorWord{"ka", &Material::Ka}, ColorWord{"kd", &Material::Kd}, ColorWord{"ks", &Material::Ks},
    ColorWord{"ke", &Material::Ke}, ColorWord{"tf", &Material::Tf},
};

struct MapWord {
    std::string_view name;
    std::vector<Map> Material::*field;
};
constexpr std::array maps{
    MapWord{"map_ka", &Material::map_Ka}, MapWord{"map_kd", &Material::map_Kd},
    MapWord{"map_ks", &Material::map_Ks}, MapWord{"map_ke", &Material::map_Ke},
    MapWord{"map_d", &Material::map_d},   MapWord{"refl", &Material::refl},
};

// Understood, but without effect on the picture: surface detail, other programs' materials.
constexpr std::array mtl_not_honoured = std::to_array<std::string_view>({
    "bump",    "map_bump", "disp",    "map_disp", "decal",     "map_decal", "map_tr", "map_opacity",
    "map_ns",  "map_ni",   "norm",    "map_aat",  "sharpness", "pr",        "pm",     "ps",
    "pc",      "pcr",      "aniso",   "anisor",   "map_pr",    "map_pm",    "map_ps", "map_pc",
    "map_pcr", "map_refl", "map_rma", "map_orm",  "map_kn",    "km",        "it",     "kt",
});

class MtlReader {
public:
    MtlReader(const std::filesystem::path& path, std::string_view text, Warnings& warnings)
        : folder_(path.parent_path()), in_(path.string(), text), warnings_(warnings) {}

    MaterialLibrary read() {
        while (in_.next()) {
            keyword_ = lower(in_.keyword());
            if (keyword_ == "newmtl")
                new_material();
            else if (materials_.empty())
                in_.fail("'" + printable(in_.keyword()) +
                         "' before any material; expected newmtl NAME");
            else if (faults_.back().empty())
                try_statement();
        }
        end_material();
        drop_repeated();
        for (Material& material : library_.materials) choose_alpha(material);
        return std::move(library_);
    }

private:
    void new_material() {
        if (in_.rest().empty()) in_.fail("newmtl has no name; expected newmtl NAME");
        end_material();
        materials_.emplace_back().name = in_.rest();
        lines_.push_back(in_.line());
        faults_.emplace_back();
        illum_line_ = 0;
        has_d_ = has_Tr_ = false;
    }

    // MTL's illum 0 has neither lights nor highlights, 1 has no highlights. We light both.
    void end_material() {
        if (illum_line_ == 0) return;
        Material& material = materials_.back();
        const std::string name = "material '" + printable(material.name) + "': illum ";
        if (material.illum == 0)
            warnings_.add(in_.file(), illum_line_, "illum 0",
                          name + "0 (constant colour) is read as 1 (lit, without highlights)");
        if (!without_highlights(material) || material.illum == 0) return;
        warnings_.add(in_.file(), illum_line_, "illum Ks",
                      name + std::to_string(material.illum) +
                          " has no highlights: Ks is not used; expected illum 2 for highlights");
    }

    // Programs name the picture of map_Kd again for its alpha, which may be 1 everywhere.
    static void choose_alpha(Material& material) {
        for (Map& map : material.map_d)
            if (map.channel == OpacityChannel::AlphaOrLuminance &&
                std::ranges::find(material.map_Kd, map.file, &Map::file) != material.map_Kd.end())
                map.channel = OpacityChannel::Alpha;
    }

    // The first material of a name counts, as the first of several libraries does.
    void drop_repeated() {
        std::set<std::string> names;
        for (std::size_t i = 0; i < materials_.size(); ++i) {
            const std::string name = materials_[i].name;
            if (!names.insert(name).second) {
                warnings_.add(in_.file(), lines_[i], "newmtl " + name,
                              "material '" + printable(name) + "' again; the first one counts");
                continue;
            }
            library_.materials.push_back(std::move(materials_[i]));
            if (!faults_[i].empty()) library_.faults[name] = std::move(faults_[i]);
        }
    }

    // Readers that find the material in use throw the fault: then nobody sees the warning.
    void try_statement() {
        try {
            statement();
        } catch (const Error& error) {
            const std::string& name = materials_.back().name;
            faults_.back() = error.what();
            const std::size_t place = at_line(in_.file(), in_.line(), "").size();
            warn("fault " + name, faults_.back().substr(place) + "; nothing uses material '" +
                                      printable(name) + "', so it is left out");
        }
    }

    void statement() {
        Material& material = materials_.back();
        for (const ColorWord& word : colors)
            if (keyword_ == word.name) return void(material.*word.field = color());
        for (const MapWord& word : maps)
            if (keyword_ == word.name) return add_map(material.*word.field);
        if (keyword_ == "ns")
            material.Ns = number(in_.rest(), 0, 10000, "Ns 0 .. 10000");
        else if (keyword_ == "ni")
            material.Ni = refraction();
        else if (keyword_ == "d")
            dissolve(material);
        else if (keyword_ == "tr")
            transparency(material);
        else if (keyword_ == "illum") {
            material.illum = illumination();
            illum_line_ = in_.line();
        } else
            other();
    }

    void other() {
        for (const std::string_view name : mtl_not_honoured)
            if (keyword_ == name)
                return warn(name, std::string(in_.keyword()) + " is not honoured");
        std::vector<std::string> known{"newmtl", "Ka",     "Kd",     "Ks",    "Ke",    "Tf",
                                       "Ns",     "Ni",     "d",      "Tr",    "illum", "map_Ka",
                                       "map_Kd", "map_Ks", "map_Ke", "map_d", "refl"};
        known.insert(known.end(), mtl_not_honoured.begin(), mtl_not_honoured.end());
        in_.fail(unknown("statement", in_.keyword(), known));
    }

    void warn(std::string_view kind, std::string_view text) {
        warnings_.add(in_.file(), in_.line(), std::string(kind), text);
    }

    // Real files exceed the ranges; the nearest value in range is used, with a warning.
    float limit(float value, float low, float high, std::string_view form) {
        if (value < low || value > high)
            warn(std::string(keyword_) + " range", std::string(in_.keyword()) +
                                                       " is out of range and limited to " +
                                                       std::string(form));
        return std::clamp(value, low, high);
    }

    float number(std::string_view text, float low, float high, std::string_view form) {
        std::array<float, 1> n{};
        if (read_numbers(in_, text, n, form) != 1) fail_count(in_, 0, form);
        return limit(n[0], low, high, form);
    }

    vec3 color() {
        const std::string form = std::string(in_.keyword()) + " r g b";
        std::string_view rest = in_.rest();
        const std::string_view first = take_word(rest);
        if (first == "spectral" || first == "xyz")
            in_.fail(std::string(in_.keyword()) + " " + std::string(first) +
                     " is not supported; expected " + form);
        std::array<float, 3> n{};
        const std::size_t count = read_numbers(in_, in_.rest(), n, form);
        if (count != 1 && count != 3) fail_count(in_, count, form);
        if (count == 1) n[1] = n[2] = n[0];
        for (float& c : n) c = limit(c, 0, 1e6f, form + " from 0");
        return {n[0], n[1], n[2]};
    }

    float refraction() {
        const float Ni = number(in_.rest(), 0, 100, "Ni 0 .. 100");
        return Ni == 0 ? 1 : Ni;
    }

    int illumination() {
        const std::string_view rest = in_.rest();
        const float model = number(in_.rest(), 0, 10, "illum 0 .. 10");
        if (model != std::floor(model))
            in_.fail("illum is '" + printable(rest) + "'; expected a whole number 0 .. 10");
        return static_cast<int>(model);
    }

    // "d 0.5" and "d -halo 0.5": the latter fades with the angle, which is not honoured.
    void dissolve(Material& material) {
        constexpr std::string_view halo = "-halo";
        std::string_view text = in_.rest();
        if (text.starts_with(halo)) {
            warn(halo, "d -halo is read as d");
            text.remove_prefix(halo.size());
        }
        const float d = number(text, 0, 1, "d 0 .. 1");
        if (has_Tr_) compare(d, material.d);
        material.d = d;
        has_d_ = true;
    }

    // If a material has both, d counts, in either order.
    void transparency(Material& material) {
        const float d = 1 - number(in_.rest(), 0, 1, "Tr 0 .. 1");
        if (has_d_) return compare(material.d, d);
        material.d = d;
        has_Tr_ = true;
    }
    void compare(float d, float from_Tr) {
        if (std::abs(d - from_Tr) > 1.0f / 256)
            warn("Tr", "d and Tr disagree (Tr should be 1 - d); d counts");
    }

    void add_map(std::vector<Map>& list) {
        const MapStatement statement = read_map(in_, folder_, warnings_);
        if (statement.map.file.empty())
            return warn(keyword_, std::string(in_.keyword()) + " names no file: left out");
        if (keyword_ == "refl" && !statement.type.empty() && statement.type != "sphere")
            in_.fail("refl -type " + printable(statement.type) +
                     " is not supported; expected refl -type sphere");
        const Map& map = statement.map;
        const auto same = [&](const Map& m) {
            return m.file == map.file && m.wrap_s == map.wrap_s && m.offset == map.offset &&
                   m.scale == map.scale && m.channel == map.channel;
        };
        if (std::ranges::any_of(list, same))
            return warn("map again",
                        std::string(in_.keyword()) + " again with the same map; it counts once");
        if (keyword_ == "map_d" && !list.empty())
            return warn("map_d again", std::string(in_.keyword()) +
                                           " again with another map; the first one counts");
        list.push_back(map);
    }

    const std::filesystem::path folder_;
    Statements in_;
    Warnings& warnings_;
    std::string keyword_;
    std::vector<Material> materials_;
    std::vector<int> lines_;           ///< of each
    std::vector<std::string> faults_;  ///< of each; empty: none
    MaterialLibrary library_;
    int illum_line_ = 0;  ///< of the last material; 0: it has no illum
    bool has_d_ = false, has_Tr_ = false;
};

}  // namespace

MaterialLibrary read_mtl(const std::filesystem::path& path, Warnings& warnings) {
    warnings.add_file(path);
    const std::string text = utf8_of_statements(path.string(), read_text(path));
    return MtlReader(path, text, warnings).read();
}

}  // namespace gw::scene
