#include "inspect/compare/command_difference.h"

#include "gw/names.h"
#include "inspect/compare/command_members.h"
#include "inspect/manifest/profile_json.h"
#include "inspect/replay/player.h"
#include "inspect/text/state_fields.h"
#include "inspect/text/value_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace gw::inspect {
namespace {

/// What differs within a command: a name and both values.
struct Part {
    std::string name, a, b;
};
using Parts = std::optional<Part>;

template <typename T>
Parts difference(const std::string& name, const T& a, const T& b) {
    if (a == b) return {};
    return Part{name, text(a), text(b)};
}
template <typename T>
Parts difference(const std::string& name, const std::vector<T>& a, const std::vector<T>& b) {
    if (a == b) return {};
    if (a.size() != b.size())
        return Part{"number of " + name, std::to_string(a.size()), std::to_string(b.size())};
    const auto [i, j] = std::mismatch(a.begin(), a.end(), b.begin());
    return Part{fmt::format("{} {}", name, i - a.begin()), text(*i), text(*j)};
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
    if (a.texture == b.texture) return {};
    if (a.texture && b.texture)
        return difference(a.texture->levels.front(), b.texture->levels.front());
    const auto name = [](const TextureBinding& t) { return t.texture ? t.texture->name : "none"; };
    return Part{"map", name(a), name(b)};
}

Parts difference(const LightsRef& a, const LightsRef& b) {
    static const std::vector<Light> none;
    const auto &p = a ? *a : none, &q = b ? *b : none;
    if (p.size() != q.size())
        return Part{"number of lights", std::to_string(p.size()), std::to_string(q.size())};
    for (std::size_t i = 0; i < p.size(); ++i)
        if (auto part = difference(p[i], q[i])) return part;
    return {};
}

Parts difference(const Draw& a, const Draw& b) {
    if (a.mesh != b.mesh)
        if (auto part = difference(a.mesh->data(), b.mesh->data())) return part;
    if (auto part = difference(a.material, b.material)) return part;
    if (auto part = difference(a.lights, b.lights)) return part;
    if (auto part = difference(a.map, b.map)) return part;
    return difference<Draw>(a, b);
}

Parts difference(const SetState& a, const SetState& b) {
    const std::vector<Field> p = fields(a.state), q = fields(b.state);
    for (std::size_t i = 0; i < p.size(); ++i)
        if (auto part = difference(p[i].name, p[i].value, q[i].value)) return part;
    return {};
}

Parts difference(const Command& a, const Command& b) {
    if (a.index() != b.index()) return Part{"kind", name_of(a), name_of(b)};
    return std::visit(
        [&](const auto& c) { return difference(c, std::get<std::remove_cvref_t<decltype(c)>>(b)); },
        a);
}

Parts head_difference(const Recording& a, const Recording& b) {
    if (a.profile != b.profile)
        return Part{"profile", json_of(a.profile).dump(), json_of(b.profile).dump()};
    if (a.width != b.width) return difference("width", a.width, b.width);
    return difference("height", a.height, b.height);
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
        if (const auto part = difference(*p[i], *q[i]))
            return finding_at(a, i, name_of(*p[i]), *part);
    if (p.size() == q.size()) return {};
    return Finding{.what = "number of commands",
                   .expected = std::to_string(p.size()),
                   .actual = std::to_string(q.size())};
}

}  // namespace gw::inspect
