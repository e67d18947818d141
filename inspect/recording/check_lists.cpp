// gw's `validate` for every list, and the memory that a machine would need.
#include "inspect/recording/check_lists.h"

#include "gw/describe/enumerators.h"
#include "gw/error.h"
#include "gw/machine.h"
#include "gw/stages/texels.h"

#include <fmt/format.h>

#include <array>
#include <map>

namespace gw::inspect {
namespace {

std::uint64_t area(const Rect& r) { return std::uint64_t(r.width) * std::uint64_t(r.height); }

/// Bytes that a machine keeps: slots with all their levels, and rectangles read back.
class Memory {
public:
    explicit Memory(const Limits& limits) : limits_(limits) {}
    void add(const CopyTexture& c) {
        Slot& slot = slots_[c.slot];
        slot.area = area(c.rect);
        slot.paired = {};
        keep(slot.bytes, 16 * slot.area);
    }
    void add(const Read& r) { keep(readbacks_[r.key], 64 + 16 * area(r.rect)); }
    void add(const SetState& s) { texture_ = s.state->texture; }
    /// A bilinear filter has pairs of texels made of the slot, for each way to wrap.
    void add(const Draw& d) {
        if (!d.map.slot || !(is_linear(texture_, false) || is_linear(texture_, true))) return;
        Slot& slot = slots_[*d.map.slot];
        bool& paired =
            slot.paired[std::size_t(texture_.wrap_s) * wraps + std::size_t(texture_.wrap_t)];
        if (!paired) keep(slot.bytes, slot.bytes + 8 * slot.area);
        paired = true;
    }
    void add(const auto&) {}

private:
    static constexpr std::size_t wraps = count_of<Wrap>;
    struct Slot {
        std::uint64_t area = 0, bytes = 0;
        std::array<bool, wraps * wraps> paired{};
    };
    void keep(std::uint64_t& stored, std::uint64_t bytes) {
        total_ += bytes - stored;
        stored = bytes;
        if (total_ > limits_.machine_bytes)
            throw Error(
                fmt::format("texture slots and read-backs of more than {} MB; expected less",
                            limits_.machine_bytes >> 20));
    }
    const Limits& limits_;
    std::uint64_t total_ = 0;
    TextureState texture_;
    std::map<std::uint32_t, Slot> slots_;
    std::map<std::uint32_t, std::uint64_t> readbacks_;
};

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
    }
}

void validate_lists(const Recording& recording) {
    for_each_list(recording, [](const CommandList&) {});
}

void check_lists(const Recording& r, const Limits& limits) {
    const std::uint64_t tiles =
        std::uint64_t((r.width + 63) / 64) * std::uint64_t((r.height + 63) / 64);
    Memory memory(limits);
    for_each_list(r, [&](const CommandList& list) {
        for (const Command& command : list.commands) {
            std::visit([&](const auto& c) { memory.add(c); }, command);
            if (const auto* draw = std::get_if<Draw>(&command))
                check_geometry(*draw, tiles, limits);
        }
    });
}

}  // namespace gw::inspect
