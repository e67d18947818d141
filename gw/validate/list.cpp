// A command list in order: each command by itself, and the textures, slots and memory that earlier
// commands and calls provide.
#include "gw/names.h"
#include "gw/validate/checker.h"

namespace gw {
namespace {

/// Slots depend on earlier commands: a slot may be empty or filled from the wrong plane.
void check_slot(const Checker& c, const Draw& draw, const ListContext& context) {
    if (!draw.map.enabled()) return;
    const bool compares = context.state.texture.shadow_compare;
    if (!draw.map.slot) {
        if (compares)
            c.fail(
                "texture.shadow_compare with a colour texture; expected a slot copied from the depth plane");
        return;
    }
    const auto slot = context.slots.find(*draw.map.slot);
    if (slot == context.slots.end())
        c.fail(
            fmt::format("texture slot {} is empty; expected a CopyTexture before", *draw.map.slot));
    if (compares && slot->second != Plane::Depth)
        c.fail(fmt::format(
            "texture.shadow_compare with slot {} of the colour plane; expected the depth plane",
            *draw.map.slot));
}

void follow(const Checker&, const auto&, ListContext&) {}
void follow(const Checker& c, const Draw& draw, ListContext& context) {
    check_slot(c, draw, context);
}
void follow(const Checker&, const SetState& set, ListContext& context) {
    context.state = set.state;
}
/// Memory that read_into gave for a Read.
void follow(const Checker& c, const Read& read, ListContext& context) {
    const auto target = context.targets.find(read.key);
    if (target == context.targets.end()) return;
    const bool words = read.plane == Plane::Depth || read.plane == Plane::Stencil || read.packed;
    c.require(words, "plane of read_into", name_of(read.plane), "depth, stencil or packed color");
    c.require(target->second.size() == read.rect.area(), "values of read_into",
              target->second.size(), "width times height");
}
void follow(const Checker&, const CopyTexture& copy, ListContext& context) {
    context.slots[copy.slot] = copy.plane;
}

}  // namespace

void check_window(int width, int height) {
    if (width < 1 || height < 1 || width > max_window_size || height > max_window_size)
        throw Error(fmt::format("window of {} x {} pixels; expected 1 to {} each", width, height,
                                max_window_size));
}

void validate(const CommandList& list, const Profile& profile, int width, int height,
              ListContext context) {
    Checker checker{profile, width, height, 0, "", context.pass};
    for (const Command& command : list.commands) {
        checker.name = name_of(command);
        if (const auto* begin = std::get_if<BeginPass>(&command)) checker.pass = begin->name;
        std::visit([&](const auto& c) { check(checker, c); }, command);
        std::visit([&](const auto& c) { follow(checker, c, context); }, command);
        checker.command += 1;
    }
}

}  // namespace gw
