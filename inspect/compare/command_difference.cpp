#include "inspect/compare/difference.h"

#include "gw/names.h"
#include "gw/stages/resolve.h"
#include "inspect/manifest/json_of.h"
#include "inspect/replay/player.h"
#include "inspect/replay/shown_maps.h"
#include "inspect/text/call_text.h"
#include "inspect/text/state_fields.h"
#include "inspect/text/value_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <tuple>
#include <type_traits>
#include <variant>

namespace gw::inspect {
namespace {

// The members of commands and of the values that they refer to, by name, in the order in which they
// are compared. A Draw's mesh, lights and map are shared values with members of their own.
template <typename Struct, typename Value>
struct NamedMember {
    const char* name;
    Value Struct::*member;
};
template <typename Struct, typename Value>
constexpr NamedMember<Struct, Value> named(const char* name, Value Struct::*member) {
    return {name, member};
}

/// A std::tuple of NamedMember, in the order in which they are compared.
template <typename Struct>
inline constexpr auto members_of = std::tuple<>();

template <>
inline constexpr auto members_of<MeshData> = std::tuple(
    named("primitive", &MeshData::primitive), named("positions", &MeshData::positions),
    named("indices", &MeshData::indices), named("polygon_sizes", &MeshData::polygon_sizes),
    named("normals", &MeshData::normals), named("texcoords", &MeshData::texcoords),
    named("colors", &MeshData::colors), named("polygon_ids", &MeshData::polygon_ids),
    named("w", &MeshData::w), named("texcoords_rq", &MeshData::texcoords_rq),
    named("edge_flags", &MeshData::edge_flags), named("materials", &MeshData::materials),
    named("material_indices", &MeshData::material_indices),
    named("secondary_colors", &MeshData::secondary_colors),
    named("fog_coordinates", &MeshData::fog_coordinates));

template <>
inline constexpr auto members_of<Texture> = std::tuple(
    named("map's format", &Texture::format), named("map's dimensions", &Texture::dimensions),
    named("map's border", &Texture::border), named("map's cube", &Texture::cube),
    named("map's depths", &Texture::depths));

template <>
inline constexpr auto members_of<TextureLevel> = std::tuple(
    named("map's width", &TextureLevel::width), named("map's height", &TextureLevel::height),
    named("map's layers", &TextureLevel::layers), named("map's values", &TextureLevel::rgba));

template <>
inline constexpr auto members_of<Light> =
    std::tuple(named("light.position", &Light::position), named("light.Ia", &Light::Ia),
               named("light.Id", &Light::Id), named("light.Is", &Light::Is),
               named("light.spot_direction", &Light::spot_direction),
               named("light.spot_exponent", &Light::spot_exponent),
               named("light.spot_cos_cutoff", &Light::spot_cos_cutoff),
               named("light.constant_attenuation", &Light::constant_attenuation),
               named("light.linear_attenuation", &Light::linear_attenuation),
               named("light.quadratic_attenuation", &Light::quadratic_attenuation));

template <>
inline constexpr auto members_of<Material> = std::tuple(
    named("Ka", &Material::Ka), named("Kd", &Material::Kd), named("Ks", &Material::Ks),
    named("Ke", &Material::Ke), named("Ns", &Material::Ns), named("alpha", &Material::alpha));

template <>
inline constexpr auto members_of<CurrentValues> = std::tuple(
    named("current.color", &CurrentValues::color), named("current.normal", &CurrentValues::normal),
    named("current.texcoord", &CurrentValues::texcoord),
    named("current.secondary_color", &CurrentValues::secondary_color),
    named("current.fog_coordinate", &CurrentValues::fog_coordinate),
    named("current.more_texcoords", &CurrentValues::more_texcoords));

template <>
inline constexpr auto members_of<UnitTexcoords> =
    std::tuple(named("texcoords of a unit", &UnitTexcoords::st),
               named("texcoords_rq of a unit", &UnitTexcoords::rq));

template <>
inline constexpr auto members_of<Draw> = std::tuple(named("eye_from_object",
                                                          &Draw::eye_from_object),
                                                    named("id_base", &Draw::id_base),
                                                    named("id_shift", &Draw::id_shift));

template <>
inline constexpr auto members_of<BeginPass> = std::tuple(named("name", &BeginPass::name));

template <>
inline constexpr auto members_of<Clear> = std::tuple(named("planes", &Clear::planes),
                                                     named("color", &Clear::color),
                                                     named("depth", &Clear::depth),
                                                     named("stencil", &Clear::stencil),
                                                     named("accum", &Clear::accum));

template <>
inline constexpr auto members_of<WriteSpans> = std::tuple(named("spans", &WriteSpans::spans),
                                                          named("colors", &WriteSpans::colors),
                                                          named("depth", &WriteSpans::depth));

template <>
inline constexpr auto members_of<WritePixels> = std::tuple(named("plane", &WritePixels::plane),
                                                           named("rect", &WritePixels::rect),
                                                           named("colors", &WritePixels::colors),
                                                           named("values", &WritePixels::values),
                                                           named("depth", &WritePixels::depth));

template <>
inline constexpr auto members_of<Accumulate> = std::tuple(named("op", &Accumulate::op),
                                                          named("value", &Accumulate::value));

template <>
inline constexpr auto members_of<Copy> = std::tuple(named("plane", &Copy::plane),
                                                    named("source", &Copy::source),
                                                    named("x", &Copy::x), named("y", &Copy::y));

template <>
inline constexpr auto members_of<CopyTexture> = std::tuple(named("slot", &CopyTexture::slot),
                                                           named("plane", &CopyTexture::plane),
                                                           named("rect", &CopyTexture::rect));

template <>
inline constexpr auto members_of<MakeSurface> = std::tuple(named("number", &MakeSurface::number),
                                                           named("surface", &MakeSurface::surface));

template <>
inline constexpr auto members_of<UseSurface> = std::tuple(named("number", &UseSurface::number));

template <>
inline constexpr auto members_of<Blit> = std::tuple(
    named("from_surface", &Blit::from_surface), named("planes", &Blit::planes),
    named("source", &Blit::source), named("target", &Blit::target), named("flip_x", &Blit::flip_x),
    named("flip_y", &Blit::flip_y), named("filter", &Blit::filter));

template <>
inline constexpr auto members_of<Read> = std::tuple(named("key", &Read::key),
                                                    named("plane", &Read::plane),
                                                    named("rect", &Read::rect),
                                                    named("packed", &Read::packed));

template <>
inline constexpr auto members_of<DrawPixels> =
    std::tuple(named("width", &DrawPixels::width), named("height", &DrawPixels::height),
               named("raster", &DrawPixels::raster), named("zoom_x", &DrawPixels::zoom_x),
               named("zoom_y", &DrawPixels::zoom_y), named("source", &DrawPixels::source),
               named("colors", &DrawPixels::colors), named("depths", &DrawPixels::depths),
               named("stencils", &DrawPixels::stencils), named("bits", &DrawPixels::bits));

/// The part of a command that differs: a name and both values; of colours also as numbers.
struct DifferentPart {
    std::string name, a, b;
    using Color = std::variant<std::monostate, vec4, Rgba>;
    Color color_a = {}, color_b = {};
};
using Parts = std::optional<DifferentPart>;

/// Colours are floats, 0 to 1, or what a plane holds.
template <typename T>
DifferentPart part_of(const std::string& name, const T& a, const T& b) {
    DifferentPart part{name, text(a), text(b)};
    constexpr bool is_color = std::is_same_v<T, vec4> || std::is_same_v<T, Rgba>;
    if constexpr (is_color) {
        if (name == "color" || name == "current.color" || name.starts_with("colors ")) {
            part.color_a = a;
            part.color_b = b;
        }
    }
    return part;
}

template <typename T>
Parts difference(const std::string& name, const T& a, const T& b) {
    if (a == b) return {};
    return part_of(name, a, b);
}
template <typename T>
Parts difference(const std::string& name, const std::vector<T>& a, const std::vector<T>& b) {
    if (a == b) return {};
    if (a.size() != b.size())
        return DifferentPart{"number of " + name, std::to_string(a.size()),
                             std::to_string(b.size())};
    const auto [i, j] = std::mismatch(a.begin(), a.end(), b.begin());
    return part_of(fmt::format("{} {}", name, i - a.begin()), *i, *j);
}

Parts difference(const std::string& name, const TexelValues& a, const TexelValues& b) {
    return difference(name, *a, *b);
}

/// Of two of a kind, member by member.
template <typename Struct>
Parts difference(const Struct& a, const Struct& b) {
    Parts first;
    const auto compare = [&](const auto& m) {
        if (!first) first = difference(m.name, a.*m.member, b.*m.member);
    };
    std::apply([&](const auto&... m) { (compare(m), ...); }, members_of<Struct>);
    return first;
}

Parts difference(const TextureBinding& a, const TextureBinding& b) {
    if (a.slot != b.slot) return difference("texture slot", a.slot, b.slot);
    if (a.surface != b.surface) return difference("texture's surface", a.surface, b.surface);
    if (a.texture == b.texture) return {};
    if (a.texture && b.texture) {
        const Texture &p = *a.texture, &q = *b.texture;
        if (auto part = difference<Texture>(p, q)) return part;
        if (p.levels.size() != q.levels.size())
            return DifferentPart{"number of the map's levels", std::to_string(p.levels.size()),
                                 std::to_string(q.levels.size())};
        for (std::size_t i = 0; i < p.levels.size(); ++i)
            if (auto part = difference(p.levels[i], q.levels[i])) return part;
        return {};
    }
    const auto name = [](const TextureBinding& t) { return t.texture ? t.texture->name : "none"; };
    return DifferentPart{"map", name(a), name(b)};
}

Parts difference(const LightsRef& a, const LightsRef& b) {
    static const std::vector<Light> none;
    const auto &p = a ? *a : none, &q = b ? *b : none;
    if (p.size() != q.size())
        return DifferentPart{"number of lights", std::to_string(p.size()),
                             std::to_string(q.size())};
    for (std::size_t i = 0; i < p.size(); ++i)
        if (auto part = difference(p[i], q[i])) return part;
    return {};
}

/// Of all units' textures.
Parts map_difference(const auto& a, const auto& b) {
    for (std::size_t unit = 0; unit < max_texture_units; ++unit)
        if (auto part = difference(map_of(a, unit), map_of(b, unit))) {
            if (unit > 0) part->name += fmt::format(" of unit {}", unit);
            return part;
        }
    return {};
}
Parts mesh_difference(const MeshData& a, const MeshData& b) {
    if (auto part = difference(a, b)) return part;
    for (std::size_t i = 0; i < a.more_texcoords.size(); ++i)
        if (auto part = difference(a.more_texcoords[i], b.more_texcoords[i])) return part;
    return {};
}

Parts difference(const Draw& a, const Draw& b) {
    if (a.mesh != b.mesh)
        if (auto part = mesh_difference(a.mesh->data(), b.mesh->data())) return part;
    if (auto part = difference(a.material, b.material)) return part;
    const Material &back_a = a.back_material ? *a.back_material : a.material,
                   &back_b = b.back_material ? *b.back_material : b.material;
    if (auto part = difference(back_a, back_b))
        return DifferentPart{"back " + part->name, part->a, part->b};
    static const CurrentValues initial;
    if (auto part = difference(a.current ? *a.current : initial, b.current ? *b.current : initial))
        return part;
    if (auto part = difference(a.lights, b.lights)) return part;
    if (auto part = map_difference(a, b)) return part;
    return difference<Draw>(a, b);
}

Parts difference(const DrawPixels& a, const DrawPixels& b) {
    if (auto part = map_difference(a, b)) return part;
    return difference<DrawPixels>(a, b);
}

Parts difference(const SetState& a, const SetState& b) {
    const std::vector<Field> p = fields(a.state), q = fields(b.state);
    for (std::size_t i = 0; i < p.size(); ++i)
        if (auto part = difference(p[i].name, p[i].value, q[i].value)) return part;
    return {};
}

Parts difference(const Command& a, const Command& b) {
    if (a.index() != b.index()) return DifferentPart{"kind", name_of(a), name_of(b)};
    return std::visit(
        [&](const auto& c) { return difference(c, std::get<std::remove_cvref_t<decltype(c)>>(b)); },
        a);
}

Parts head_difference(const Recording& a, const Recording& b) {
    if (a.profile != b.profile)
        return DifferentPart{"profile", json_of(a.profile).dump(), json_of(b.profile).dump()};
    if (a.width != b.width) return difference("width", a.width, b.width);
    return difference("height", a.height, b.height);
}

std::vector<const Command*> commands_of(const Recording& recording) {
    std::vector<const Command*> all;
    for (const CommandList& list : recording.lists)
        for (const Command& command : list.commands) all.push_back(&command);
    return all;
}

/// The index that a colour is, if `of` shows indices there; else `text`.
std::string shown_color(const DifferentPart::Color& color, const std::string& text,
                        const Recording& of, std::size_t command) {
    const ColorMap* const map = ShownMaps(of).of(command);
    if (map == nullptr) return text;
    if (const auto* value = std::get_if<vec4>(&color))
        return index_text(*map, quantize_color(*value, of.profile.color_bits));
    if (const auto* value = std::get_if<Rgba>(&color)) return index_text(*map, *value);
    return text;
}

/// Names the command and the pass that it is in.
Finding finding_at(const Recording& a, const Recording& b, std::size_t command, const char* name,
                   const DifferentPart& part) {
    Finding f{.what = fmt::format("command {} ({}), {}", command, name, part.name),
              .expected = shown_color(part.color_a, part.a, a, command),
              .actual = shown_color(part.color_b, part.b, b, command)};
    const auto passes = pass_ranges(a);
    for (std::size_t i = 0; i < passes.size(); ++i)
        if (command >= passes[i].first && command < passes[i].end) {
            f.pass = i;
            f.pass_name = passes[i].name;
        }
    return f;
}

/// Names the program's calls.
Finding with_calls(Finding f, const Recording& a, const Recording& b, std::size_t command) {
    for (const auto& [name, recording] : {std::pair("A", &a), std::pair("B", &b)})
        if (const std::string call = CallNames(*recording).text(command); !call.empty())
            f.notes.push_back(fmt::format("{}: {}", name, call));
    return f;
}

}  // namespace

std::optional<Finding> first_command_difference(const Recording& a, const Recording& b) {
    if (const auto part = head_difference(a, b))
        return Finding{.what = part->name, .expected = part->a, .actual = part->b};
    const auto p = commands_of(a), q = commands_of(b);
    for (std::size_t i = 0; i < std::min(p.size(), q.size()); ++i)
        if (const auto part = difference(*p[i], *q[i]))
            return with_calls(finding_at(a, b, i, name_of(*p[i]), *part), a, b, i);
    if (p.size() == q.size()) return {};
    return Finding{.what = "number of commands",
                   .expected = std::to_string(p.size()),
                   .actual = std::to_string(q.size())};
}

}  // namespace gw::inspect
