#include "inspect/command_difference.h"

#include "inspect/player.h"
#include "inspect/profile_json.h"
#include "inspect/state_fields.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace gw::inspect {
namespace {

/// What differs within a command: a name and both values.
struct Part {
    std::string name, a, b;
};
using Parts = std::optional<Part>;

std::string text(const std::string& v) { return "'" + v + "'"; }
template <typename T>
requires std::is_arithmetic_v<T> std::string text(T v) { return fmt::format("{}", v); }
template <typename T>
requires std::is_enum_v<T> std::string text(T v) { return std::to_string(int(v)); }
template <typename T>
requires requires(const T& v) { T::length(); }
std::string text(const T& v) {
    std::string out;
    for (int i = 0; i < T::length(); ++i) {
        if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(v[i])>>)
            out += (i ? " " : "") + fmt::format("{}", v[i]);
        else
            out += (i ? ", " : "") + text(v[i]);
    }
    return "(" + out + ")";
}
std::string text(const Rgba& c) { return fmt::format("({})", fmt::join(c, " ")); }
std::string text(const Rect& r) { return fmt::format("({} {} {} {})", r.x, r.y, r.width, r.height); }
std::string text(const Span& s) { return fmt::format("(x {} y {} length {})", s.x, s.y, s.length); }
std::string text(const std::optional<std::uint32_t>& v) { return v ? std::to_string(*v) : "none"; }

/// Compares named members one by one; keeps the first that differs.
class Members {
public:
    template <typename T>
    Members& compare(const char* name, const T& a, const T& b) {
        if (!first_ && !(a == b)) first_ = {name, text(a), text(b)};
        return *this;
    }
    template <typename T>
    Members& compare(const char* name, const std::vector<T>& a, const std::vector<T>& b) {
        if (first_ || a == b) return *this;
        const auto [i, j] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
        if (a.size() != b.size())
            first_ = {std::string("number of ") + name, text(a.size()), text(b.size())};
        else
            first_ = {fmt::format("{} {}", name, i - a.begin()), text(*i), text(*j)};
        return *this;
    }
    Members& add(Parts part) {
        if (!first_) first_ = std::move(part);
        return *this;
    }
    Parts first() const { return first_; }

private:
    Parts first_;
};

Parts difference(const MeshData& a, const MeshData& b) {
    return Members()
        .compare("primitive", a.primitive, b.primitive)
        .compare("positions", a.positions, b.positions)
        .compare("indices", a.indices, b.indices)
        .compare("polygon_sizes", a.polygon_sizes, b.polygon_sizes)
        .compare("normals", a.normals, b.normals)
        .compare("texcoords", a.texcoords, b.texcoords)
        .compare("colors", a.colors, b.colors)
        .compare("polygon_ids", a.polygon_ids, b.polygon_ids)
        .first();
}

Parts difference(const TextureBinding& a, const TextureBinding& b) {
    Members members;
    members.compare("texture slot", a.slot, b.slot);
    const auto there = [](const TextureBinding& t) {
        return std::string(t.texture ? t.texture->name : "none");
    };
    if (!a.texture || !b.texture) {
        if (a.texture != b.texture) members.add(Part{"map", there(a), there(b)});
        return members.first();
    }
    if (a.texture == b.texture) return members.first();
    return members.compare("map's width", a.texture->width(), b.texture->width())
        .compare("map's height", a.texture->height(), b.texture->height())
        .compare("map's values", a.texture->levels.front().rgba, b.texture->levels.front().rgba)
        .first();
}

Parts difference(const Light& a, const Light& b) {
    return Members()
        .compare("light.position", a.position, b.position)
        .compare("light.Ia", a.Ia, b.Ia)
        .compare("light.Id", a.Id, b.Id)
        .compare("light.Is", a.Is, b.Is)
        .compare("light.spot_direction", a.spot_direction, b.spot_direction)
        .compare("light.spot_exponent", a.spot_exponent, b.spot_exponent)
        .compare("light.spot_cos_cutoff", a.spot_cos_cutoff, b.spot_cos_cutoff)
        .compare("light.constant_attenuation", a.constant_attenuation, b.constant_attenuation)
        .compare("light.linear_attenuation", a.linear_attenuation, b.linear_attenuation)
        .compare("light.quadratic_attenuation", a.quadratic_attenuation, b.quadratic_attenuation)
        .first();
}

Parts difference(const LightsRef& a, const LightsRef& b) {
    static const std::vector<Light> none;
    const auto &p = a ? *a : none, &q = b ? *b : none;
    Members members;
    members.compare("number of lights", p.size(), q.size());
    for (std::size_t i = 0; i < std::min(p.size(), q.size()); ++i) members.add(difference(p[i], q[i]));
    return members.first();
}

Parts difference(const Draw& a, const Draw& b) {
    return Members()
        .add(a.mesh == b.mesh ? Parts() : difference(a.mesh->data(), b.mesh->data()))
        .compare("eye_from_object", a.eye_from_object, b.eye_from_object)
        .compare("Ka", a.material.Ka, b.material.Ka)
        .compare("Kd", a.material.Kd, b.material.Kd)
        .compare("Ks", a.material.Ks, b.material.Ks)
        .compare("Ke", a.material.Ke, b.material.Ke)
        .compare("Ns", a.material.Ns, b.material.Ns)
        .compare("alpha", a.material.alpha, b.material.alpha)
        .add(difference(a.lights, b.lights))
        .add(difference(a.map, b.map))
        .compare("id_base", a.id_base, b.id_base)
        .compare("id_shift", a.id_shift, b.id_shift)
        .first();
}
Parts difference(const SetState& a, const SetState& b) {
    const std::vector<Field> p = fields(a.state), q = fields(b.state);
    Members members;
    for (std::size_t i = 0; i < p.size(); ++i) members.compare(p[i].name.c_str(), p[i].value, q[i].value);
    return members.first();
}
Parts difference(const BeginPass& a, const BeginPass& b) {
    return Members().compare("name", a.name, b.name).first();
}
Parts difference(const Clear& a, const Clear& b) {
    return Members()
        .compare("planes", int{a.planes}, int{b.planes})
        .compare("color", a.color, b.color)
        .compare("depth", a.depth, b.depth)
        .compare("stencil", a.stencil, b.stencil)
        .first();
}
Parts difference(const WriteSpans& a, const WriteSpans& b) {
    return Members()
        .compare("spans", a.spans, b.spans)
        .compare("colors", a.colors, b.colors)
        .compare("depth", a.depth, b.depth)
        .first();
}
Parts difference(const WritePixels& a, const WritePixels& b) {
    return Members()
        .compare("plane", a.plane, b.plane)
        .compare("rect", a.rect, b.rect)
        .compare("colors", a.colors, b.colors)
        .compare("values", a.values, b.values)
        .compare("depth", a.depth, b.depth)
        .first();
}
Parts difference(const Accumulate& a, const Accumulate& b) {
    return Members().compare("op", a.op, b.op).compare("value", a.value, b.value).first();
}
Parts difference(const Copy& a, const Copy& b) {
    return Members()
        .compare("plane", a.plane, b.plane)
        .compare("source", a.source, b.source)
        .compare("x", a.x, b.x)
        .compare("y", a.y, b.y)
        .first();
}
Parts difference(const CopyTexture& a, const CopyTexture& b) {
    return Members()
        .compare("slot", a.slot, b.slot)
        .compare("plane", a.plane, b.plane)
        .compare("rect", a.rect, b.rect)
        .first();
}
Parts difference(const Read& a, const Read& b) {
    return Members()
        .compare("key", a.key, b.key)
        .compare("plane", a.plane, b.plane)
        .compare("rect", a.rect, b.rect)
        .first();
}

Parts difference(const Command& a, const Command& b) {
    if (a.index() != b.index()) return Part{"kind", name_of(a), name_of(b)};
    return std::visit(
        [&](const auto& c) { return difference(c, std::get<std::remove_cvref_t<decltype(c)>>(b)); }, a);
}

Parts head_difference(const Recording& a, const Recording& b) {
    if (a.profile != b.profile) return Part{"profile", json_of(a.profile).dump(), json_of(b.profile).dump()};
    return Members().compare("width", a.width, b.width).compare("height", a.height, b.height).first();
}

std::vector<const Command*> commands_of(const Recording& recording) {
    std::vector<const Command*> all;
    for (const CommandList& list : recording.lists)
        for (const Command& command : list.commands) all.push_back(&command);
    return all;
}

/// Names the command and the pass that it is in.
Finding finding_at(const Recording& a, std::size_t command, const char* name, const Part& part) {
    Finding f{.what = fmt::format("command {} ({}), {}", command, name, part.name),
              .expected = part.a,
              .actual = part.b};
    const auto passes = pass_ranges(a);
    for (std::size_t i = 0; i < passes.size(); ++i)
        if (command >= passes[i].first && command < passes[i].end) {
            f.pass = i;
            f.pass_name = passes[i].name;
        }
    return f;
}

}  // namespace

std::optional<Finding> first_command_difference(const Recording& a, const Recording& b) {
    if (const auto part = head_difference(a, b))
        return Finding{.what = part->name, .expected = part->a, .actual = part->b};
    const auto p = commands_of(a), q = commands_of(b);
    for (std::size_t i = 0; i < std::min(p.size(), q.size()); ++i)
        if (const auto part = difference(*p[i], *q[i])) return finding_at(a, i, name_of(*p[i]), *part);
    if (p.size() == q.size()) return {};
    return Finding{.what = "number of commands", .expected = text(p.size()), .actual = text(q.size())};
}

}  // namespace gw::inspect
