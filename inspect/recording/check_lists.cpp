// gw's `validate` for every list, and the memory that a machine would need.
#include "inspect/recording/check_lists.h"

#include "gw/describe/enumerators.h"
#include "gw/error.h"
#include "gw/machine.h"
#include "gw/stages/texels.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

namespace gw::inspect {
namespace {

std::uint64_t area(const Rect& r) { return std::uint64_t(r.width) * std::uint64_t(r.height); }

/// Bytes that a machine keeps: slots with all their levels, surfaces, and rectangles read back.
class Memory {
public:
    explicit Memory(const Limits& limits) : limits_(limits) {}
    void add(const CopyTexture& c) { make(slots_[c.slot], area(c.rect), 16); }
    /// Planes in the host's layout and of tiles, and the texels of colours and depths.
    void add(const MakeSurface& m) {
        const Surface& s = m.surface;
        make(surfaces_[m.number], area({0, 0, s.width, s.height}),
             14 * std::uint64_t(s.sample_count()) + (s.has(Plane::Color) ? 16 : 0) +
                 (s.has(Plane::Depth) ? 16 : 0));
    }
    void add(const Read& r) { keep(readbacks_[r.key], 64 + 16 * area(r.rect)); }
    void add(const SetState& s) { texture_ = s.state->texture; }
    /// A bilinear filter has pairs of texels made of a slot or a plane, for each way to wrap.
    void add(const Draw& d) {
        if (!(is_linear(texture_, false) || is_linear(texture_, true))) return;
        if (d.map.slot) pair(slots_[*d.map.slot]);
        if (d.map.surface) pair(surfaces_[d.map.surface->surface]);
    }
    void add(const auto&) {}

private:
    static constexpr std::size_t wraps = count_of<Wrap>;
    /// Of slots and surfaces.
    struct Slot {
        std::uint64_t area = 0, bytes = 0;
        std::array<bool, wraps * wraps> paired{};
    };
    void make(Slot& slot, std::uint64_t pixels, std::uint64_t bytes) {
        slot.area = pixels;
        slot.paired = {};
        keep(slot.bytes, bytes * pixels);
    }
    void pair(Slot& slot) {
        bool& paired =
            slot.paired[std::size_t(texture_.wrap_s) * wraps + std::size_t(texture_.wrap_t)];
        if (!paired) keep(slot.bytes, slot.bytes + 8 * slot.area);
        paired = true;
    }
    void keep(std::uint64_t& stored, std::uint64_t bytes) {
        total_ += bytes - stored;
        stored = bytes;
        if (total_ > limits_.machine_bytes)
            throw Error(fmt::format(
                "texture slots, surfaces and read-backs of more than {} MB; expected less",
                limits_.machine_bytes >> 20));
    }
    const Limits& limits_;
    std::uint64_t total_ = 0;
    TextureState texture_;
    std::map<std::uint32_t, Slot> slots_, surfaces_;
    std::map<std::uint32_t, std::uint64_t> readbacks_;
};

std::uint64_t tiles_of(int width, int height) {
    return std::uint64_t((width + 63) / 64) * std::uint64_t((height + 63) / 64);
}

void check_geometry(const Draw& draw, std::uint64_t tiles, const Limits& limits) {
    const Mesh& mesh = *draw.mesh;
    const std::uint64_t primitives =
        mesh.triangles().size() + mesh.lines().size() + mesh.points().size();
    if (primitives * tiles > limits.geometry)
        throw Error(fmt::format("{} primitives in one draw; expected at most {} in this window",
                                primitives, limits.geometry / tiles));
}

/// Calls `check` with every list that is valid, and names the list in errors.
void for_each_list(const Recording& r, const auto& check) {
    ListContext context;
    for (std::size_t i = 0; i < r.lists.size(); ++i) {
        try {
            validate(r.lists[i], r.profile, r.width, r.height, context);
            check(r.lists[i]);
        } catch (const Error& error) {
            throw Error(fmt::format("list {}: {}", i, error.what()));
        }
        follow(r.lists[i], context);
    }
}

}  // namespace

void follow(const CommandList& list, ListContext& context) {
    for (const Command& command : list.commands) {
        if (const auto* begin = std::get_if<BeginPass>(&command)) context.pass = begin->name;
        if (const auto* set = std::get_if<SetState>(&command)) context.state = set->state;
        if (const auto* query = std::get_if<Query>(&command)) gw::follow(*query, context);
        if (const auto* copy = std::get_if<CopyTexture>(&command))
            context.slots[copy->slot] = copy->plane;
        if (const auto* make = std::get_if<MakeSurface>(&command)) {
            context.surfaces[make->number] = make->surface;
            if (make->surface.width == 0) context.surfaces.erase(make->number);
        }
        if (const auto* use = std::get_if<UseSurface>(&command)) context.surface = use->number;
    }
}

void validate_lists(const Recording& recording) {
    for_each_list(recording, [](const CommandList&) {});
}

void check_lists(const Recording& r, const Limits& limits) {
    std::uint64_t tiles = tiles_of(r.width, r.height);  // of the largest surface
    Memory memory(limits);
    for_each_list(r, [&](const CommandList& list) {
        for (const Command& command : list.commands) {
            std::visit([&](const auto& c) { memory.add(c); }, command);
            if (const auto* make = std::get_if<MakeSurface>(&command))
                tiles = std::max(tiles, tiles_of(make->surface.width, make->surface.height));
            if (const auto* draw = std::get_if<Draw>(&command))
                check_geometry(*draw, tiles, limits);
        }
    });
}

}  // namespace gw::inspect
