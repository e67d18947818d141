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

/// The surface of a number, which has to be there. The window is always there.
Surface surface_of(const Checker& c, const ListContext& context, std::uint32_t number) {
    if (number == 0) return c.window;
    const auto found = context.surfaces.find(number);
    if (found == context.surfaces.end())
        c.fail(fmt::format("there is no surface {}; expected a MakeSurface before", number));
    return found->second;
}

void use(Checker& c, const ListContext& context) {
    const Surface surface = surface_of(c, context, context.surface);
    c.width = surface.width;
    c.height = surface.height;
    c.depth_bits = depth_bits(c.profile, surface);
}

void check_one_sample(const Checker& c, const ListContext& context, std::uint32_t number) {
    const int samples = surface_of(c, context, number).samples;
    if (samples != 0)
        c.fail(fmt::format("surface {} has {} samples; expected one without samples", number,
                           samples));
}

/// Commands that read a plane need one, without samples.
void check_has(const Checker& c, const ListContext& context, Plane plane) {
    check_one_sample(c, context, context.surface);
    if (context.surface != 0 && !surface_of(c, context, context.surface).has(plane))
        c.fail(fmt::format("plane = {}; expected a plane of surface {}", name_of(plane),
                           context.surface));
}

/// A plane of a surface as texture.
void check_map(const Checker& c, const SurfacePlane& map, bool compares,
               const ListContext& context) {
    if (map.surface == 0) c.fail("the window as texture; expected a surface");
    if (map.surface == context.surface)
        c.fail(fmt::format("surface {} as texture while it is drawn to; expected another surface",
                           map.surface));
    const Surface surface = surface_of(c, context, map.surface);
    check_one_sample(c, context, map.surface);
    if ((map.plane != Plane::Color && map.plane != Plane::Depth) || !surface.has(map.plane))
        c.fail(fmt::format("{} of surface {} as texture; expected a plane of colours or depths",
                           name_of(map.plane), map.surface));
    if (compares && map.plane != Plane::Depth)
        c.fail(fmt::format("texture.shadow_compare with colours of surface {}; expected depths",
                           map.surface));
}

/// The textures of all units.
void check_maps(const Checker& c, const auto& command, const ListContext& context) {
    for (std::size_t unit = 0; unit < max_texture_units; ++unit) {
        const TextureBinding& map = map_of(command, unit);
        const bool compares = texture_of(context.state, unit).shadow_compare;
        map.surface ? check_map(c, *map.surface, compares, context)
                    : check_slot(c, map, compares, context);
    }
}

/// Commands that act on the window only.
void check_window_only(const Checker& c, const ListContext& context) {
    if (context.surface != 0)
        c.fail(fmt::format("surface {} is in use; expected the window", context.surface));
}

void check_in_context(const Checker&, const auto&, const ListContext&) {}
void check_in_context(const Checker& c, const Draw& draw, const ListContext& context) {
    check_maps(c, draw, context);
}
void check_in_context(const Checker& c, const DrawPixels& draw, const ListContext& context) {
    check_maps(c, draw, context);
    if (draw.source) check_has(c, context, draw.source->plane);
}
void check_in_context(const Checker& c, const Read& read, const ListContext& context) {
    check_has(c, context, read.plane);
    check_target(c, read, context);
}
void check_in_context(const Checker& c, const Copy& copy, const ListContext& context) {
    check_has(c, context, copy.plane);
}
void check_in_context(const Checker& c, const CopyTexture& copy, const ListContext& context) {
    check_has(c, context, copy.plane);
}
void check_in_context(const Checker& c, const Accumulate&, const ListContext& context) {
    check_window_only(c, context);
}
void check_in_context(const Checker& c, const SwapBuffers&, const ListContext& context) {
    check_window_only(c, context);
}
void check_in_context(const Checker& c, const MakeSurface& make, const ListContext& context) {
    if (make.number == context.surface)
        c.fail(fmt::format("surface {} is in use; expected another one", make.number));
}
void check_in_context(const Checker& c, const UseSurface& use, const ListContext& context) {
    surface_of(c, context, use.number);
}
void check_in_context(const Checker& c, const Blit& blit, const ListContext& context) {
    const Surface from = surface_of(c, context, blit.from_surface),
                  to = surface_of(c, context, context.surface);
    if (from.samples != 0 && to.samples != 0 && from.samples != to.samples)
        c.fail(fmt::format("{} samples to {} samples; expected as many", from.samples, to.samples));
    const bool equal =
        blit.source.width == blit.target.width && blit.source.height == blit.target.height;
    if ((from.samples != 0 || to.samples != 0) && !equal)
        c.fail(fmt::format("samples of {} x {} pixels to {} x {}; expected sides of equal length",
                           blit.source.width, blit.source.height, blit.target.width,
                           blit.target.height));
    const bool depths = (blit.planes & from.planes & to.planes & mask_of(Plane::Depth)) != 0;
    if (depths && depth_bits(c.profile, from) != depth_bits(c.profile, to))
        c.fail(fmt::format("depths of {} bits to {} bits; expected as many",
                           depth_bits(c.profile, from), depth_bits(c.profile, to)));
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

/// Of a command that is valid.
void end(Checker&, const auto&, ListContext&) {}
void end(Checker&, const MakeSurface& make, ListContext& context) {
    if (make.surface.width == 0)
        context.surfaces.erase(make.number);
    else
        context.surfaces[make.number] = make.surface;
}
void end(Checker& c, const UseSurface& command, ListContext& context) {
    context.surface = command.number;
    use(c, context);
}

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
    Checker checker{profile, {width, height, all_planes}};
    use(checker, context);
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
                end(checker, c, context);
            },
            command);
        checker.command += 1;
    }
}

}  // namespace gw
