// Checks a command list in order: each command by itself, and the textures, slots and memory that
// earlier commands and calls provide.
#include "gw/base/prefetch.h"
#include "gw/names.h"
#include "gw/validate/checker.h"

#include <type_traits>

namespace gw {
namespace {

/// Slots depend on earlier commands: a slot may be empty or filled from the wrong plane.
void check_slot(const Checker& c, const TextureBinding& map, bool compares,
                const ListContext& context) {
    if (!map.enabled()) return;
    if (!map.slot) {
        if (compares && !map.texture->depths)
            c.fail(
                "texture.shadow_compare with a colour texture; expected depths, or a slot copied from the depth plane");
        return;
    }
    const auto slot = context.slots.find(*map.slot);
    if (slot == context.slots.end())
        c.fail(fmt::format("texture slot {} is empty; expected a CopyTexture before", *map.slot));
    if (compares && slot->second != Plane::Depth)
        c.fail(fmt::format(
            "texture.shadow_compare with slot {} of the colour plane; expected the depth plane",
            *map.slot));
}

/// Memory that read_into gave for a Read.
void check_target(const Checker& c, const Read& read, const ListContext& context) {
    const auto target = context.targets.find(read.key);
    if (target == context.targets.end()) return;
    const bool words = read.plane == Plane::Depth || read.plane == Plane::Stencil || read.packed;
    c.require(words, "plane of read_into", name_of(read.plane), "depth, stencil or packed color");
    const std::size_t given = target->second.values.size();
    c.require(given == read.rect.area(), "values of read_into", given, "width times height");
    const ReadLayout& layout = target->second.layout;
    c.require(read.packed || layout == ReadLayout{}, "layout of read_into", name_of(read.plane),
              "packed color");
    const bool whole = read.rect == Rect{0, 0, c.width, c.height};
    c.require(whole || layout.known == nullptr, "known pixels of read_into", given,
              "those of the whole window");
}

void check_in_context(const Checker&, const auto&, const ListContext&) {}
void check_slots(const Checker& c, const auto& command, const ListContext& context) {
    for (std::size_t unit = 0; unit < max_texture_units; ++unit)
        check_slot(c, map_of(command, unit), texture_of(context.state, unit).shadow_compare,
                   context);
}
void check_in_context(const Checker& c, const Draw& draw, const ListContext& context) {
    check_slots(c, draw, context);
}
void check_in_context(const Checker& c, const DrawPixels& draw, const ListContext& context) {
    check_slots(c, draw, context);
}
void check_in_context(const Checker& c, const Read& read, const ListContext& context) {
    check_target(c, read, context);
}

/// A query begins if none is active, and ends if it is.
void check_in_context(const Checker& c, const Query& query, const ListContext& context) {
    const std::optional<std::uint32_t>& active = context.query;
    if (query.begin && active)
        c.fail(fmt::format("query {} is active; expected its end before", *active));
    if (!query.begin && active != query.key)
        c.fail(fmt::format("query {} is not active; expected its begin before", query.key));
}

void follow(const auto&, ListContext&) {}
/// Only the textures' states decide whether a later command is valid.
void follow(const SetState& set, ListContext& context) {
    context.state.texture = set.state->texture;
    context.state.more_textures = set.state->more_textures;
}
void follow(const CopyTexture& copy, ListContext& context) {
    context.slots[copy.slot] = copy.plane;
}
void follow(const BeginPass& begin, ListContext& context) { context.pass = begin.name; }

/// Prefetches a later draw, and the materials of the mesh of a draw between. Inlined: GCC leaves out
/// calls of functions that only prefetch.
[[gnu::always_inline]] inline void prefetch_checked(std::span<const Command> commands,
                                                    std::size_t i) {
    constexpr std::size_t steps = 8;
    prefetch_ahead(commands, i, 2 * steps, sizeof(Draw));
    if (i + steps >= commands.size()) return;
    const Draw* const draw = std::get_if<Draw>(&commands[i + steps]);
    if (draw && draw->mesh) prefetch(&draw->mesh->data().materials, 1);
}

}  // namespace

void check_window(int width, int height) {
    if (width < 1 || height < 1 || width > max_window_size || height > max_window_size)
        throw Error(fmt::format("window of {} x {} pixels; expected 1 to {} each", width, height,
                                max_window_size));
}

void validate(const CommandList& list, const Profile& profile, int width, int height,
              ListContext context) {
    Checker checker{profile, width, height};
    for (const Command& command : list.commands) {
        prefetch_checked(list.commands, checker.command);
        std::visit(
            [&](const auto& c) {
                // Whether a query is active is checked before it begins or ends.
                constexpr bool is_query = std::is_same_v<std::decay_t<decltype(c)>, Query>;
                if constexpr (!is_query) follow(c, context);
                checker.name = name_of(command);
                checker.pass = context.pass;
                check(checker, c);
                check_in_context(checker, c, context);
                if constexpr (is_query) follow(c, context);
            },
            command);
        checker.command += 1;
    }
}

}  // namespace gw
